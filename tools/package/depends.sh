#!/bin/sh
# SPDX-License-Identifier: MIT
# Finds the packages whose shared libraries armhf programs need, with dpkg-shlibdeps.
#
#   depends.sh SYSROOT PROGRAM...     prints the value of a Depends line
#
# CPack would use the packages that are installed here, which have another architecture. So this script
# uses the packages that keep_shlibs.sh kept.
set -eu
sysroot=$1
shift
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
mkdir "$work/debian"
printf 'Source: raymarchd\n\nPackage: raymarchd\nArchitecture: armhf\n' >"$work/debian/control"
cd "$work"
for kept in "$sysroot"/shlibs/*; do set -- "-S$kept" "$@"; done
# It warns of run paths in the build folder, which the installation removes.
DEB_HOST_ARCH=armhf dpkg-shlibdeps -O "$@" >found 2>said || {
    cat said >&2
    exit 1
}
sed -n 's/^shlibs:Depends=//p' found
