#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# What runs on a target needs nothing there: its objects import each other's sm_, smvm_ and pal_ functions, mem*, and what the
# compiler itself adds (__*).  So no malloc, no stdio, no libm.     imports.sh OBJECT…     NM names the lister.
NM=${NM:-nm}
passed=0 failed=0 named=0
command -v "$NM" >/dev/null 2>&1 || { echo "no $NM here: 0 passed, 0 failed, 1 skipped"; exit 0; }
[ $# -gt 0 ] || { echo "no objects: 0 passed, 1 failed"; exit 1; }
for object in "$@"; do
    undefined=$("$NM" -u "$object") || { failed=$((failed + 1)); echo "$NM cannot read $object"; continue; }
    named=$((named + $(echo "$undefined" | grep -c .)))
    foreign=$(echo "$undefined" | sed 's/.* //' | grep -Ev '^(sm_|smvm_|pal_|memcpy$|memmove$|memset$|memcmp$|__|_GLOBAL_OFFSET_TABLE_$)' | grep .)
    if [ -z "$foreign" ]; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "$object imports" $foreign
    fi
done
[ "$named" -ge $# ] || { failed=$((failed + 1)); echo "$NM names only $named symbols that are imported"; }
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
