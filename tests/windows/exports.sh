#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# smc.exe and smc.dll are built without a warning; the DLL exports what its headers declare, undecorated, and needs KERNEL32 and msvcrt alone.  This runs
# nothing under Wine.     exports.sh MAKE BUILD CC MACHINE LEVEL
make=$1 build=$2 cc=$3 machine=$4 level=$5
. tests/checks.sh
if ! command -v "$machine-w64-mingw32-gcc" >/dev/null 2>&1; then
    echo "no $machine-w64-mingw32-gcc here (apt-get install gcc-mingw-w64-$(echo "$machine" | tr _ -)): 0 passed, 0 failed, 1 skipped"
    exit 0
fi
dir=$(mktemp -d) || exit 1
trap 'rm -rf "$dir"' EXIT
files=$build/windows-$machine
dump="$machine-w64-mingw32-objdump -p"
check "make windows-$machine" $make -s B="$build" BUILD_CC="$cc" CFLAGS="$level -Werror" "windows-$machine"

needs() { $dump "$files/$1" | sed -n 's/.*DLL Name: //p' | tr 'A-Z' 'a-z' | sort | tr '\n' ' '; }
check "the DLL needs KERNEL32 and msvcrt alone" test "$(needs smc.dll)" = 'kernel32.dll msvcrt.dll '
check "the command needs what every Windows has" test "$(needs smc.exe)" = 'advapi32.dll kernel32.dll msvcrt.dll shell32.dll ws2_32.dll '
$dump "$files/smc.dll" | awk '/\[Ordinal\/Name Pointer\] Table/ { inside = 1; next } /^$/ { inside = 0 } inside { print $NF }' | sort >"$dir/exports"
cat compiler/library/smc.h compiler/labview/labview.h | grep -v '^ *//' | grep -o 'smc[lv]*_[a-z0-9_]*(' | tr -d '(' | sort -u >"$dir/declared"
check "it exports what the headers declare, undecorated" cmp "$dir/declared" "$dir/exports"
check "at least 100 functions" test "$(wc -l <"$dir/exports")" -ge 100
finish "windows-exports"
