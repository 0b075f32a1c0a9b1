#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# The instructions that `smc build` executes for each line of a large machine, with the warnings of the default settings, against budgets: a few percent
# above what gcc 12.2 -O2 needs on x86-64.  Counted by callgrind, so other work on this machine does not count.
#     instructions.sh BUILD CC CFLAGS
build=$1/instructions scale=$1/bench/scale smc=$1/smc CC=$2 CFLAGS=$3
passed=0 failed=0

skip() { echo "instructions: 0 passed, 0 failed, 1 skipped ($*)"; exit 0; }
command -v valgrind >/dev/null 2>&1 || skip "valgrind is not here"
case $($CC -dumpmachine 2>/dev/null)/$CFLAGS in
x86_64-*/-O2*) ;;
*) skip "the budgets are for x86-64 at -O2" ;;
esac
$CC --version | grep -q 'clang\|tcc' && skip "the budgets are for gcc"
mkdir -p "$build" || exit 1

# check SHAPE N MOST: MOST instructions for each line
check()
{
    "$scale" "$1" "$2" -p >"$build/$1.sm" || exit 1
    lines=$(wc -l <"$build/$1.sm")
    count=$(valgrind --tool=callgrind --callgrind-out-file="$build/$1.callgrind" "$smc" build "$build/$1.sm" -o "$build/$1.smb" 2>&1 |
        awk '/Collected/ { print $4 }')
    each=$(awk -v n="${count:-0}" -v lines="$lines" 'BEGIN { printf "%d", n / lines }')
    if [ "$each" -gt 1000 ] && [ "$each" -le "$3" ]; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
    fi
    echo "$1 $2: $each instructions a line, at most $3"
}

check mission 300 30000
check guards 1000 54500
check conditionals 2000 33300
check states 500 20900
check states_locals 150 20700
echo "instructions: $passed passed, $failed failed"
[ $failed = 0 ]
