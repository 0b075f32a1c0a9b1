#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# What runs on a target needs nothing there: its objects import each other's sm_, smvm_ and pal_ functions, mem*, and what the
# compiler itself adds (__*).  So no malloc, no stdio, no libm.     imports.sh OBJECT…     NM names the lister.
NM=${NM:-nm}
command -v "$NM" >/dev/null 2>&1 || { echo "no $NM here: 0 passed, 0 failed, 1 skipped"; exit 0; }
[ $# -gt 0 ] || { echo "no objects: 0 passed, 1 failed"; exit 1; }
list=$(mktemp "${TMPDIR:-/tmp}/smc-imports.XXXXXX") || exit 1
trap 'rm -f "$list"' EXIT
unread=0
# Each line of the list is "OBJECT: … U NAME".
"$NM" -A -u "$@" >"$list" || unread=1
awk -v lister="$NM" -v objects=$# -v unread=$unread '
    { object = $0; sub(/:.*/, "", object); imported++ }
    $NF !~ /^(sm_|smvm_|pal_|memcpy$|memmove$|memset$|memcmp$|__|_GLOBAL_OFFSET_TABLE_$)/ { foreign[object] = foreign[object] " " $NF }
    END {
        for (object in foreign) {
            print object " imports" foreign[object]
            failed++
        }
        if (unread) { print lister " cannot read every object"; failed++ }
        if (imported < objects) { print lister " names only " imported + 0 " symbols that are imported"; failed++ }
        passed = unread || failed > objects ? 0 : objects - failed
        printf "%d passed, %d failed\n", passed, failed
        exit (failed > 0 || passed == 0)
    }' "$list"
