#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Every macro that a header of the VM, the runtime or stdlib lets its user set (#ifndef NAME) has a row in configurations.txt, which names
# the files that set it to something else for a test: "NAME FILE…".  Each of them must contain -DNAME or #define NAME.
#     configurations.sh
cd "$(dirname "$0")/../.." || exit 1
table=tests/check/configurations.txt
passed=0 failed=0
pass() { passed=$((passed + 1)); }
fail() { failed=$((failed + 1)); echo "$1"; }

offered=$(find stdlib bytecode-vm runtime-c -name '*.h' -exec sed -n 's/^ *# *ifndef \([A-Z][A-Z0-9_]*\) *\(\/\/.*\)\{0,1\}$/\1/p' {} + | grep -v '_H$' | sort -u)
[ "$(echo "$offered" | wc -l)" -ge 30 ] || fail "only found these macros: $offered"
for name in $offered; do
    files=$(sed -n "s/^$name  *//p" $table)
    [ -n "$files" ] || fail "$name: has no row in $table, so no test sets it"
    case $files in '- '?*) pass && continue ;; esac
    for file in $files; do
        if grep -Eqs -- "(-D|define )$name([^A-Z0-9_]|\$)" "$file"; then pass; else fail "$name: $file does not set it"; fi
    done
done
while read -r name _; do
    case $name in '#' | '') continue ;; esac
    echo "$offered" | grep -qx "$name" || fail "$table: no header offers $name"
done <$table
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
