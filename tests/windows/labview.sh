#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# smc.dll by the settings of docs/labview.md alone: tests/windows/labview.c, whose declarations come from the page.
#     labview.sh MAKE BUILD CC MACHINE
make=$1 build=$2 cc=$3 machine=$4
. tests/windows/wine.sh
. tests/checks.sh
dir=$folder/tmp

# page.h: for each prototype of the page a pointer, and a macro that loads them all.
awk '/^```c prototypes$/ { inside = 1; next } /^```/ { inside = 0 } inside && /^int32_t smclv_/ {
        name = $2; sub(/\(.*/, "", name); rest = $0; sub(/^[^(]*/, "", rest)
        print "static int32_t (__cdecl *" name ")" rest
        load = load " smclv_load((FARPROC *)&" name ", dll, \"" name "\");" }
    END { print "static void smclv_load(FARPROC *f, HMODULE dll, const char *name) { if ((*f = GetProcAddress(dll, name)) == NULL) { printf(\"no %s: 0 passed, 1 failed\\n\", name); ExitProcess(1); } }"
          print "#define LOAD_FUNCTIONS(dll)" load }' docs/labview.md >"$dir/page.h"
sed -n 's/^int32_t \(smclv_[a-z_]*\)(.*/\1/p' compiler/labview/labview.h | sort >"$dir/declared"
sed -n 's/^static int32_t (__cdecl \*\(smclv_[a-z_]*\)).*/\1/p' "$dir/page.h" | sort >"$dir/shown"
check "the page shows every function" sh -c "cmp '$dir/declared' '$dir/shown' && [ \$(wc -l <'$dir/shown') -ge 24 ]"
# The page's prototypes are those of the header, but for const and the names of string types.
prototypes() { tr '\n' ' ' <"$1" | sed 's/;/;\n/g' | grep -o 'int32_t smclv_.*;' | sed 's/const //g; s/char \*/CStr /g; s/  */ /g; s/(\(smclv\)/\1/' | sort; }
awk '/^```c prototypes$/ { inside = 1; next } /^```/ { inside = 0 } inside' docs/labview.md >"$dir/block"
grep -v '^ *//' compiler/labview/labview.h >"$dir/header"
prototypes "$dir/block" >"$dir/block.list"
prototypes "$dir/header" >"$dir/header.list"
check "its prototypes are those of labview.h" diff "$dir/block.list" "$dir/header.list"

check "the program compiles" "$machine-w64-mingw32-gcc" -std=gnu99 -O1 -Wall -Wextra -Werror -Wno-cast-function-type -I"$dir" tests/windows/labview.c -o "$dir/labview.exe"
wine "$dir/labview.exe" "$files/smc.dll" examples >"$dir/labview.log" 2>&1 </dev/null
code=$?
grep -v ' passed, ' "$dir/labview.log"
p=$(sed -n 's/^labview: \([0-9]*\) passed.*/\1/p' "$dir/labview.log") f=$(sed -n 's/^labview: .* \([0-9]*\) failed.*/\1/p' "$dir/labview.log")
passed=$((passed + ${p:-0})) failed=$((failed + ${f:-1}))
check "it ends with exit code 0" test $code -eq 0
finish windows-labview
