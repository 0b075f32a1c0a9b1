#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# The engine vm-soft calculates in software: no object of it has a function of the engine vm, and those that calculate call soft.h.
#   engine.sh OBJECT…     NM names the lister.
NM=${NM:-nm}
passed=0 failed=0
command -v "$NM" >/dev/null 2>&1 || { echo "no $NM here: 0 passed, 0 failed, 1 skipped"; exit 0; }
for object in "$@"; do
    symbols=$("$NM" "$object" | sed 's/.* //')
    if [ -z "$symbols" ] || echo "$symbols" | grep -q '^smvm_' || { case $object in */interp.o | */fast.o) ! echo "$symbols" | grep -q '^sm_soft_mul$' ;; *) false ;; esac; }; then
        failed=$((failed + 1))
        echo "$object is not of the soft VM"
    else
        passed=$((passed + 1))
    fi
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
