#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Checks that tests/README.md has a row for every folder of tests, and that the table of CONTRIBUTING.md, which says where a test belongs,
# names each of them.
passed=0 failed=0
for folder in tests/*/; do
    name=$(basename "$folder")
    for where in tests/README.md CONTRIBUTING.md; do
        case $where in tests/*) row="^| \`$name/\` |" ;; *) row="^|.*\`tests/$name/" ;; esac
        if grep -q "$row" "$where"; then passed=$((passed + 1)); else failed=$((failed + 1)); echo "$where: no row of the table names $folder"; fi
    done
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -ge 60 ]
