#!/bin/sh
# SPDX-License-Identifier: MIT
# The packages whose shared libraries armhf programs need, as dpkg-shlibdeps has them.
#
#   depends.sh SYSROOT PROGRAM...     prints a Depends line's worth
#
# CPack's own way runs dpkg-shlibdeps on what is installed here, which is another architecture's. So
# it is told where the packages lie that keep_shlibs.sh kept.
set -eu
sysroot=$1
shift
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
mkdir "$work/debian"
printf 'Source: raymarchd\n\nPackage: raymarchd\nArchitecture: armhf\n' >"$work/debian/control"
cd "$work"
for kept in "$sysroot"/shlibs/*; do set -- "-S$kept" "$@"; done
# It warns of run paths of the build folder, which installing takes away.
DEB_HOST_ARCH=armhf dpkg-shlibdeps -O "$@" >found 2>said || {
    cat said >&2
    exit 1
}
sed -n 's/^shlibs:Depends=//p' found
