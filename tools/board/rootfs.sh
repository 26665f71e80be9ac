#!/bin/sh
# SPDX-License-Identifier: MIT
# Makes the SD card of the virtual board: Debian for armhf with systemd, and nothing of ours yet.
#
#   rootfs.sh CACHE [--cached]     prints the name of the image, an ext4 file system
#
# Maintainer scripts of another architecture run through binfmt_misc and qemu-user. Status 77, and a
# message that says what is missing, where the kernel here has none of that; with --cached also where
# the card would have to be made.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
cache=$1
packages=$(grep '^[a-z]' "$here/packages.txt" | paste -sd,)
key=$(cat "$here/packages.txt" "$here/customize.sh" "$here/rootfs.sh" | sha256sum | cut -c 1-12)
image=$cache/rootfs-$key.ext4
tree=$cache/rootfs-build-$key
log=$cache/rootfs-$key.log

if [ ! -e "$image" ]; then
    if [ "${2:-}" = --cached ]; then
        echo "rootfs.sh: $image is not made yet" >&2
        exit 77
    fi
    echo "rootfs.sh: making Debian for the virtual board (once, minutes)" >&2
    # What a person's machine does at its boot, a container may not have done.
    mountpoint -q /proc/sys/fs/binfmt_misc ||
        mount -t binfmt_misc binfmt_misc /proc/sys/fs/binfmt_misc || true
    arch-test armhf >/dev/null 2>&1 || update-binfmts --enable qemu-arm || true
    arch-test armhf >/dev/null 2>&1 || {
        echo "rootfs.sh: no armhf program runs here: binfmt_misc with qemu-arm is missing" >&2
        exit 77
    }
    rm -rf "$tree"
    # The mirror that apt has here; the release alone, which never changes under a build.
    mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' |
        grep -v security | sort -u | head -n 1)
    mmdebstrap --variant=essential --architectures=armhf --include="$packages" \
        --dpkgopt='path-exclude=/usr/share/man/*' --dpkgopt='path-exclude=/usr/share/locale/*' \
        --dpkgopt='path-exclude=/usr/share/doc/*' --aptopt='APT::Install-Recommends "false"' \
        --customize-hook="$here/customize.sh" \
        bookworm "$tree" "$mirror" >"$log" 2>&1 || {
        tail -n 30 "$log" >&2
        exit 1
    }
    rm -f "$image.new"
    # Without what this kernel was not built with.
    mke2fs -q -t ext4 -O '^metadata_csum,^64bit' -L board -d "$tree" "$image.new" 768M >>"$log" 2>&1
    rm -rf "$tree"
    mv "$image.new" "$image"
fi
echo "$image"
