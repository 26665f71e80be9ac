#!/bin/sh
# SPDX-License-Identifier: MIT
# Tests the first steps of a new user: makes a root folder of a Debian release, clones the last commit
# into it, and runs ./dev demo and ./dev test as root and as an ordinary user. Ends with a table of the
# times. It needs root, a mirror, and some 4 GB of disk.
#
#   tools/clean_room.sh bookworm|trixie
set -eu
release=$1
case $release in
    bookworm | trixie) ;;
    *)
        echo "clean-room: the releases are bookworm and trixie, not '$release'" >&2
        exit 64
        ;;
esac
here=$(cd "$(dirname "$0")/.." && pwd)
[ "$(id -u)" -eq 0 ] || exec sudo "$0" "$release"
command -v mmdebstrap >/dev/null || {
    echo "clean-room: there is no mmdebstrap here: apt-get install mmdebstrap" >&2
    exit 69
}
# The script runs again in its own mount namespace; its mounts end with it.
[ -n "${RAYMARCH_CLEAN_ROOM:-}" ] ||
    RAYMARCH_CLEAN_ROOM=1 exec unshare --mount --propagation private "$0" "$release"

mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' |
    grep -v security | sort -u | head -n 1)
folder=$(mktemp -d)
chmod 755 "$folder" # for the ordinary user
root=$folder/root
trap 'umount -R "$root/dev" "$root/proc" "$root/sys" 2>/dev/null
    rm -rf --one-file-system "$folder"' EXIT

step() {
    printf '\n== clean-room %s: %s\n' "$release" "$1"
    started=$(date +%s)
    shift
    "$@"
    took=$(($(date +%s) - started))
}
row() {
    table="$table$(printf '%-28s %2d:%02d' "$1" $((took / 60)) $((took % 60)))
"
}
table=

step "an empty root" mmdebstrap --variant=apt --include=git,ca-certificates,sudo \
    "$release" "$root" "$mirror"
row "an empty root"
git clone -q "$here" "$root/srv/raymarchd"
cp /etc/resolv.conf "$root/etc/resolv.conf"
mount -t proc proc "$root/proc"
mount --rbind /sys "$root/sys"
mount -t tmpfs tmpfs "$root/dev"
for node in null zero full random urandom tty; do
    : >"$root/dev/$node"
    mount --bind "/dev/$node" "$root/dev/$node"
done
mkdir "$root/dev/pts" "$root/dev/shm"
mount -t devpts -o newinstance,ptmxmode=0666,mode=0620,gid=5 devpts "$root/dev/pts"
ln -s pts/ptmx "$root/dev/ptmx"
ln -s /proc/self/fd "$root/dev/fd"
ln -s fd/0 "$root/dev/stdin"
ln -s fd/1 "$root/dev/stdout"
ln -s fd/2 "$root/dev/stderr"
mount -t tmpfs -o mode=1777 tmpfs "$root/dev/shm"

inside() { chroot "$root" env -i HOME=/root PATH="$PATH" TERM=dumb LANG=C.UTF-8 sh -ec "$1"; }
as_user() {
    chroot "$root" su - student -c "$1"
}
step "./dev demo, as root" inside 'cd /srv/raymarchd && ./dev demo'
row "./dev demo"
step "./dev test, as root" inside 'cd /srv/raymarchd && ./dev test'
row "./dev test"
step "./dev test again" inside 'cd /srv/raymarchd && ./dev test'
row "./dev test, nothing changed"
# The user has no sudo and another clone; the packages are already installed.
inside 'useradd -m -s /bin/sh student
    git clone -q /srv/raymarchd /home/student/raymarchd # git refuses a clone that belongs to root
    chown -R student: /home/student/raymarchd'
step "./dev demo, as a user" as_user 'cd raymarchd && ./dev demo'
row "./dev demo, as a user"
step "./dev test, as a user" as_user 'cd raymarchd && ./dev test'
row "./dev test, as a user"

printf '\n== clean-room %s: all passed\n%s' "$release" "$table"
