#!/bin/sh
# SPDX-License-Identifier: MIT
# Makes the packages of a build folder, looks at what is in them, and tries their life in a fresh
# root of the release that they were built on: install, upgrade, remove, purge.
#
#   clean_root.sh BUILD CPACK       CPACK is CMake's
#
# Status 77, with the reason, where that cannot be done.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
source=$(cd "$here/../.." && pwd)
build=$1
cpack=$2
release=$(sed -n 's/^VERSION_CODENAME=//p' /etc/os-release)
for tool in mmdebstrap mount dpkg-shlibdeps dpkg-deb file; do
    command -v "$tool" >/dev/null || {
        echo "skipped: there is no $tool here"
        exit 77
    }
done
mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' |
    grep -v security | sort -u | head -n 1)
apt-get download --print-uris -q dpkg >/dev/null 2>&1 || {
    echo "skipped: apt has no lists of packages here"
    exit 77
}
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
chmod 755 "$work" # mmdebstrap may be another user inside

"$cpack" --config "$build/CPackConfig.cmake" -B "$work/made" >"$work/cpack.log" || {
    cat "$work/cpack.log"
    exit 1
}
service=$(ls "$work"/made/raymarchd_*.deb)
# What Debian 12 makes runs on Ubuntu 22.04, too; what a newer Debian makes may need more.
like_the_board=
[ "$release" != bookworm ] || like_the_board=--board
python3 "$source/tools/package/contents.py" --made-in "$source" --made-in "$build" $like_the_board \
    "$work"/made/*.deb
# The tool finds the modules of the other package; here, where OpenCV is.
for package in "$work"/made/*.deb; do dpkg-deb -x "$package" "$work/both"; done
"$work/both/usr/bin/raymarchctl" render --size 16x12 -o "$work/a.jpg"

mkdir "$work/packages"
cp "$work"/made/*.deb "$here/life.sh" "$work/packages"

# The next versions are this one with another number and another example of the configuration.
for next in next1 next2; do
    dpkg-deb -R "$service" "$work/$next"
    sed -i "s/^Version: .*/&+$next/" "$work/$next/DEBIAN/control"
    echo "# as of $next" >>"$work/$next/etc/raymarchd.toml"
    dpkg-deb --root-owner-group -b "$work/$next" "$work/packages/$next.deb" >/dev/null
done

# The root is made, used and thrown away.
mmdebstrap --variant=apt --include=systemd,udev --aptopt='APT::Install-Recommends "false"' \
    --dpkgopt=force-unsafe-io \
    --customize-hook="copy-in $work/packages /root" \
    --customize-hook='chroot "$1" sh /root/packages/life.sh' \
    "$release" /dev/null "$mirror" >"$work/log" 2>&1 || {
    if grep -q 'unable to pick chroot mode' "$work/log"; then
        echo "skipped: mmdebstrap finds no way here for this user to make a root"
        exit 77
    fi
    tail -n 60 "$work/log"
    exit 1
}
grep '^life: ' "$work/log"
