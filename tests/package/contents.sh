#!/bin/sh
# SPDX-License-Identifier: MIT
# Makes the package of a cross build, and looks at what is in it and what it needs.
#
#   contents.sh BUILD CPACK SYSROOT
#
# Status 77, with the reason, where that cannot be done.
set -eu
source=$(cd "$(dirname "$0")/../.." && pwd)
build=$1
cpack=$2
sysroot=$3
for tool in dpkg-shlibdeps dpkg-deb file readelf; do
    command -v "$tool" >/dev/null || {
        echo "skipped: there is no $tool here"
        exit 77
    }
done
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
"$cpack" --config "$build/CPackConfig.cmake" -B "$work" >"$work/cpack.log" || {
    cat "$work/cpack.log"
    exit 1
}
python3 "$source/tools/package/contents.py" --made-in "$source" --made-in "$build" \
    --made-in "$sysroot" "$work"/*.deb
