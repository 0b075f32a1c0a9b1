#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Fails if the random calls of tests/library/random.c leave out a function or a kind of source of smc.h.
header=compiler/library/smc.h test=tests/library/random.c
passed=0 failed=0
for name in $(grep -v '^ *//' $header | grep -o 'smc_[a-z0-9_]*(' | tr -d '(' | sort -u) $(grep -o 'SMC_KIND_[A-Z]* =' $header | tr -d ' ='); do
    if grep -q "$name\b" $test; then passed=$((passed + 1)); else failed=$((failed + 1)); echo "$test: $name is not called"; fi
done
[ $passed -gt 80 ] || { echo "$header: only $passed names found"; failed=$((failed + 1)); }
echo "calls: $passed passed, $failed failed"
[ $failed -eq 0 ]
