#!/bin/sh
# SPDX-License-Identifier: MIT
# Cross-compiles the virtual board's kernel from Debian's source package, because Debian's prebuilt
# kernels have neither this processor nor its UIO driver nor simulated GPIO lines.
#
#   kernel.sh CACHE [--cached]     prints the folder with zImage, its configuration, and dts/
#
# With --cached nothing is built; the exit status is 77 if there is no kernel.
# The folder's name contains the source's version and a hash of the configuration, so only a change of
# these builds a new kernel.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
cache=$1
fragment=$here/zynq-virtual.config
jobs=$(nproc 2>/dev/null || echo 2)

version=$(dpkg-query -W -f '${Version}' linux-source-6.1 2>/dev/null) || {
    echo "kernel.sh: the package linux-source-6.1 is not installed" >&2
    exit 77
}
kernel=$cache/kernel-$version-$(sha256sum <"$fragment" | cut -c 1-12)

if [ ! -d "$kernel" ]; then
    if [ "${2:-}" = --cached ]; then
        echo "kernel.sh: $kernel is not made yet" >&2
        exit 77
    fi
    echo "kernel.sh: building Linux $version for the virtual board (once, minutes)" >&2
    work=$kernel.new
    source=$work/linux-source-6.1
    log=$kernel.log
    make="make -C $source ARCH=arm CROSS_COMPILE=arm-linux-gnueabihf- -j$jobs"
    rm -rf "$work"
    mkdir -p "$work"
    tar -C "$work" -xf /usr/src/linux-source-6.1.tar.xz
    give_up() {
        tail -n 30 "$log" >&2
        exit 1
    }
    $make -s allnoconfig >"$log" 2>&1 || give_up
    cat "$fragment" >>"$source/.config"
    $make -s olddefconfig >>"$log" 2>&1 || give_up
    # It is a mistake in the fragment if the kernel refuses one of its options.
    if grep '^CONFIG' "$fragment" | grep -vxFf "$source/.config" >"$work/refused"; then
        echo "kernel.sh: not taken into the configuration:" >&2
        cat "$work/refused" >&2
        exit 1
    fi
    $make -s zImage >>"$log" 2>&1 || give_up
    mkdir "$work/dts"
    cp "$source/arch/arm/boot/zImage" "$work/"
    cp "$source/.config" "$work/config"
    cp "$source/arch/arm/boot/dts/zynq-7000.dtsi" "$work/dts/"
    rm -rf "$source"
    mv "$work" "$kernel"
fi
echo "$kernel"
