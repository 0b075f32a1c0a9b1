#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Checks that documents are wrapped as wrap.awk wraps them, or with -w wraps them:  wrap.sh [-w] PAGE…
write=
[ "$1" != -w ] || { write=1; shift; }
passed=0 failed=0
wrapped=$(mktemp) || exit 1
trap 'rm -f "$wrapped"' EXIT
for page; do
    LC_ALL=C awk -f tests/check/wrap.awk "$page" >"$wrapped" || exit 1
    if cmp -s "$wrapped" "$page"; then
        passed=$((passed + 1))
    elif [ "$write" ]; then
        cat "$wrapped" >"$page" && echo "wrapped $page"
    else
        echo "$page:$(cmp "$wrapped" "$page" 2>&1 | sed 's/.*line //'): this line is not wrapped at 100 columns: make wrap-docs"
        failed=$((failed + 1))
    fi
done
[ "$write" ] && exit
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
