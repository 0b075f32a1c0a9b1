#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Checks that every row of stdlib/builtins.def has what the compiler cannot miss by itself: a definition in the language reference, its name
# in the diagnostic on unknown functions, a conformance case that calls it, a line that says what its units are, and as many names of arguments
# as arguments.  Prints the file that lacks it.
passed=0 failed=0
check() {
    if [ -n "$3" ]; then passed=$((passed + 1)); else failed=$((failed + 1)); echo "$1: $2"; fi
}
for name in $(sed -n 's/^SM_[A-Z]*(\([a-z0-9_]*\),.*/\1/p' stdlib/builtins.def); do
    check docs/language.md "$name(…) is not defined" "$(grep -l "\`$name(" docs/language.md)"
    check compiler/diag/codes.def "the page of E0217 does not list $name" \
          "$(sed -n '/^DIAG("E0217"/,/^DIAG("E0218"/p' compiler/diag/codes.def | grep -w "$name")"
    check conformance "no case calls $name(…)" "$(grep -l "\<$name(" conformance/*/*.smt | grep -v /11-errors/ | head -1)"
    check tests/analysis/units-table.smt "no line has $name(…)" "$(grep "^ .*\<$name(" tests/analysis/units-table.smt)"
done
wrong=$(awk '/^SM_(PURE|COMPOSED|SAMPLED)\([a-z]/ { match($0, /"\([^"]*\)"/); split(substr($0, RSTART, RLENGTH), name, ","); split($0, field, /, */)
                                                n = 0; for (i in name) n++; rows++; if (n != field[2]) print field[1] " has another number of names than of arguments" }
             END { if (rows < 25) print "only " rows + 0 " rows were read" }' stdlib/builtins.def)
check stdlib/builtins.def "$wrong" "$([ -z "$wrong" ] && echo right)"
echo "$passed passed, $failed failed"
[ $failed -eq 0 ]
