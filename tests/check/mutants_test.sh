#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# mutants.sh --places itself: which lists it accepts.
passed=0 failed=0
list=$(mktemp "${TMPDIR:-/tmp}/smc-mutants.XXXXXX") || exit 1
trap 'rm -f "$list" "$list.out"' EXIT

# expect CODE TEXT ENTRIES: mutants.sh --places ends with CODE on a list of the entries, and prints TEXT
expect() {
    printf '%s\n' "$3" >"$list"
    sh tests/check/mutants.sh --places "$list" >"$list.out" 2>&1
    if [ $? -eq "$1" ] && grep -q "$2" "$list.out"; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "not exit $1 and '$2' for:"
        cat "$list" "$list.out"
    fi
}

first='vm  stdlib/builtins.def
- STEP2(max, 0, 1)
+ STEP2(min, 0, 1)'
other='c  stdlib/builtins.def
- STEP2(max, 0, 1)
+ STEP2(max, 1, 0)'
expect 0 '^2 passed, 0 failed' "$first
$other"
expect 1 ':4: is given in line 1 already' "$first
$first"
expect 1 ':4: is given in line 1 already' "$first
c${first#vm}"
expect 1 ':1: its place is not there in exactly one line' 'vm  stdlib/builtins.def
- STEP2(max, 0, 5)
+ STEP2(max, 0, 1)'
expect 1 ':1: its place is not there in exactly one line' 'vm  stdlib/builtins.def
- SM_PURE(
+ SM_LIST('
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
