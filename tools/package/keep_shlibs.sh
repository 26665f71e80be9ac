#!/bin/sh
# SPDX-License-Identifier: MIT
# A hook of mmdebstrap when it extracts the armhf sysroot; $1 is its tree. Keeps of each package with
# shared libraries these and what it says of them, as dpkg-shlibdeps wants to see packages that are
# not installed here: shlibs/PACKAGE/DEBIAN and the files.
set -eu
for package in "$1"/var/cache/apt/archives/*.deb; do
    name=$(dpkg-deb -f "$package" Package)
    kept=$1/shlibs/$name
    mkdir -p "$kept"
    dpkg-deb -e "$package" "$kept/DEBIAN"
    if [ -e "$kept/DEBIAN/shlibs" ]; then
        dpkg-deb --fsys-tarfile "$package" |
            tar -C "$kept" -x --wildcards './lib/*.so*' './usr/lib/*.so*' 2>"$kept/said" ||
            grep -q 'Not found in archive' "$kept/said" # one of the two, mostly
        rm "$kept/said"
    else
        rm -r "$kept"
    fi
done
