#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# smc itself, built by tcc, gives the answers that it gives when other compilers build it: runs conformance/, tests/analysis/,
# tests/script/ and tests/golden/.  Analyses depend on many numbers and orders, so a difference between compilers shows in them first.
#     tcc.sh BUILD MAKE
command -v tcc >/dev/null || { echo "no tcc here (apt-get install tcc): 0 passed, 0 failed, 1 skipped"; exit 0; }
passed=0 failed=0

# count COMMAND…: runs tests, and adds the counts in the last line that they print
count() {
    output=$("$@" 2>&1)
    set -- $(echo "$output" | sed -n '$s/.*\([^0-9]\|^\)\([0-9][0-9]*\) passed, \([0-9][0-9]*\) failed.*/\2 \3/p')
    passed=$((passed + ${1:-0})) failed=$((failed + ${2:-1}))
    [ "${2:-1}" -eq 0 ] || echo "$output" | tail -n 20
}

$2 -s B="$1/tcc" CC=tcc || { echo "tcc does not compile smc: 0 passed, 1 failed"; exit 1; }
count "$1/tcc/smc" test --engine=ref,vm,vm-soft conformance
count "$1/tcc/smc" test tests/analysis/*.smt
count "$1/tcc/smc" test tests/script
count "$1/golden" "$1/tcc/smc" tests/golden/*.smt
echo "tcc: $passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
