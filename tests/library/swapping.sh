#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# tests/library/swapping: an application that receives the text of a machine over a pipe, compiles it in a thread without a deadline, and continues
# in it.     swapping.sh MAKE B CC CFLAGS
make=$1 build=$2 cc=$3 cflags=$4
. tests/checks.sh
root=$(pwd)
dir=$(mktemp -d) || exit 1
trap 'rm -rf "$dir"' EXIT
case $build in /*) ;; *) build=$root/$build ;; esac

# The function that docs/library.md shows is that of the program, line by line.
awk '$0 == "```c swap" { inside = 1; next } /^```/ { inside = 0 } inside' docs/library.md >"$dir/shown"
check "the page shows a function" test "$(wc -l <"$dir/shown")" -ge 10
contains() { awk 'FNR == NR { want[n++] = $0; next } { at = $0 == want[at] ? at + 1 : $0 == want[0]; if (at == n) found = 1 } END { exit !found }' "$dir/shown" "$1"; }
check "which is that of the program" contains tests/library/swapping/tasks.c

cp tests/library/swapping/* compiler/library/smc.h "$build/lib/libsmc.a" "$dir"
cd "$dir" || exit 1
check "the application builds with smc.mk and libsmc" "$make" -s CC="$cc" CFLAGS="$cflags" ROOT="$root" SMC="$build/smc" LIB="$dir"
cat >expected <<END
state Run is kept: both machines have it
local peak is new: the old machine does not have it
local n is kept: both machines have it
window roll(pressure, 5) is new: the old machine does not have it
window roll(pressure, 10) is kept: both machines have it
state Wait is lost: the new machine does not have it
swapped, the average lags by 4.5, the count rose by 100
confirmed
END
swaps() { cat better.sm | ./stand >out && cmp expected out; }
check "it swaps the machine for a text, and keeps the window" swaps
refuses() { ./stand <wrong.sm >out && grep -q "^line 15: unknown element 'averge'" out && test "$(wc -l <out)" -eq 1; }
check "a text with an error changes nothing" refuses
check "a text without an end does not either" sh -c "head -c 100 better.sm | ./stand | grep -q '^line'"
finish library-swapping
