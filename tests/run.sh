#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Runs test commands, one a line of standard input ("NAME: COMMAND"), and adds up what they say.  A command ends with a
# line "N passed, N failed" or "N passed, N failed, N skipped", anything before it on that line ignored.
# Exit 1 if anything failed, or with STRICT=1 if anything was skipped.
passed=0 failed=0 skipped=0
unset MAKEFLAGS MFLAGS MAKELEVEL      # a make among the commands is a make of its own
out=${TMPDIR:-/tmp}/smc-test.$$
again=$out.again                      # what failed said, told once more at the end
trap 'rm -f "$out" "$again"' EXIT
trap 'exit 130' INT TERM

while IFS= read -r line; do
    [ -n "$line" ] || continue
    name=${line%%: *} command=${line#*: }
    sh -c "$command" >"$out" 2>&1 </dev/null
    code=$?
    last=$(grep '[0-9] passed, [0-9]* failed' "$out" | tail -n 1)
    p=$(printf '%s\n' "$last" | sed -n 's/^\(.*[^0-9]\)\{0,1\}\([0-9][0-9]*\) passed, [0-9][0-9]* failed.*/\2/p')
    f=$(printf '%s\n' "$last" | sed -n 's/.* passed, \([0-9][0-9]*\) failed.*/\1/p')
    s=$(printf '%s\n' "$last" | sed -n 's/.* failed, \([0-9][0-9]*\) skipped.*/\1/p')
    if [ -z "$p" ] || { [ "$code" -ne 0 ] && [ "${f:-0}" -eq 0 ]; }; then
        echo "$name: ended with exit code $code${p:+, with nothing failed}" >>"$out"
        failed=$((failed + 1))
        code=1
    fi
    if [ "$code" -ne 0 ] || [ "${f:-0}" -ne 0 ] || [ "${s:-0}" -ne 0 ]; then
        cat "$out"
    fi
    if [ "$code" -ne 0 ] || [ "${f:-0}" -ne 0 ]; then
        { echo "---- $name"; tail -n 30 "$out"; } >>"$again"
    fi
    printf '%-28s %s\n' "$name" "$last"
    passed=$((passed + ${p:-0})) failed=$((failed + ${f:-0})) skipped=$((skipped + ${s:-0}))
done
[ ! -s "$again" ] || cat "$again"
if [ "$skipped" -ne 0 ]; then
    echo "skipped tests need tools that are not here; on Debian or Ubuntu: apt-get install clang tcc g++ lua5.4 luajit chromium graphviz librsvg2-bin"
    echo "  python3-jsonschema; and: make sarif-schema"
    echo "$passed passed, $failed failed, $skipped skipped"
    [ "${STRICT:-0}" = 1 ] && exit 1
else
    echo "$passed passed, $failed failed"
fi
[ "$failed" -eq 0 ]
