#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Runs test commands, one a line of standard input ("NAME: COMMAND"), and adds up what they say; as many at once as there are
# processors, or as JOBS says.  Commands that call make themselves have a '+' before their name: they run one after another, beside
# the rest.  A command ends with a line "N passed, N failed" or "N passed, N failed, N skipped", anything before it on that line
# ignored.  Exit 1 if anything failed, or with STRICT=1 if anything was skipped.
#
# A command fails as well if
#   1. it ran no test and skipped none,
#   2. it skipped nothing and passed fewer tests than floors.txt demands of its name,
#   3. it does not end within LIMIT seconds,
#   4. another one has its name.
passed=0 failed=0 skipped=0 told=0
floors=${FLOORS:-$(dirname "$0")/floors.txt}
limit=
timeout --foreground 1 true 2>/dev/null && limit="timeout --foreground -k 10 ${LIMIT:-3600}"      # in this group, so that Ctrl-C ends it too
unset MAKEFLAGS MFLAGS MAKELEVEL      # a make among the commands is a make of its own
jobs=${JOBS:-$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1)}
work=$(mktemp -d "${TMPDIR:-/tmp}/smc-test.XXXXXX") || exit 1
again=$work/again                     # what failed said, told once more at the end
trap 'rm -rf "$work"' EXIT
trap 'trap "" TERM; kill -TERM 0; exit 130' INT TERM

grep -v '^$' >"$work/lines"
mkfifo "$work/ended" && exec 3<>"$work/ended" || exit 1
for name in $(sed 's/^+\{0,1\}\([^:]*\):.*/\1/' "$work/lines" | sort | uniq -d); do
    echo "$name: two commands have this name"
    failed=$((failed + 1))
done

# run NUMBER LINE: leaves what the command said, and its exit code and seconds
run() {
    began=$(date +%s)
    $limit sh -c "${2#*: }" >"$work/$1.out" 2>&1 </dev/null 3>&-
    echo "$? $(($(date +%s) - began))" >"$work/$1.code"
    echo "$1" >&3
}

# take KIND: runs those lines of a kind, '+' or '-', that nobody else has begun
take() {
    n=0
    while IFS= read -r line; do
        n=$((n + 1))
        case $line in +*) kind=+ ;; *) kind=- ;; esac
        [ "$kind" = "$1" ] && mkdir "$work/$n.begun" 2>/dev/null && run "$n" "$line"
    done <"$work/lines"
}

# floor_of NAME: how many tests a command of that name must run at least
floor_of() { sed -n "s/^$1  *\([0-9][0-9]*\)$/\1/p" "$floors" | tail -n 1 | grep . || echo 1; }

# tell NUMBER: says how that line ended
tell() {
    out=$work/$1.out name=$(sed -n "$1s/^+\{0,1\}\([^:]*\):.*/\1/p" "$work/lines")
    read -r code seconds <"$work/$1.code"
    last=$(grep '[0-9] passed, [0-9]* failed' "$out" | tail -n 1)
    p=$(printf '%s\n' "$last" | sed -n 's/^\(.*[^0-9]\)\{0,1\}\([0-9][0-9]*\) passed, [0-9][0-9]* failed.*/\2/p')
    f=$(printf '%s\n' "$last" | sed -n 's/.* passed, \([0-9][0-9]*\) failed.*/\1/p')
    s=$(printf '%s\n' "$last" | sed -n 's/.* failed, \([0-9][0-9]*\) skipped.*/\1/p')
    if [ -z "$p" ] || { [ "$code" -ne 0 ] && [ "${f:-0}" -eq 0 ]; }; then
        echo "$name: ended with exit code $code${p:+, with nothing failed}" >>"$out"
        failed=$((failed + 1))
        code=1
    elif [ $((p + f + ${s:-0})) -eq 0 ]; then
        echo "$name: no test was run" >>"$out"
        failed=$((failed + 1))
        code=1
    elif [ "${s:-0}" -eq 0 ] && [ "$((p + f))" -lt "$(floor_of "$name")" ]; then
        echo "$name: $((p + f)) tests were run; $floors demands at least $(floor_of "$name")" >>"$out"
        failed=$((failed + 1))
        code=1
    fi
    if [ "$code" -ne 0 ] || [ "${f:-0}" -ne 0 ] || [ "${s:-0}" -ne 0 ]; then
        cat "$out"
    fi
    if [ "$code" -ne 0 ] || [ "${f:-0}" -ne 0 ]; then
        { echo "---- $name"; tail -n 30 "$out"; } >>"$again"
    fi
    printf '%-28s %4d s  %s\n' "$name" "$seconds" "$last"
    passed=$((passed + ${p:-0})) failed=$((failed + ${f:-0})) skipped=$((skipped + ${s:-0}))
}

{ take +; take -; } &
while [ "$jobs" -gt 1 ]; do
    take - &
    jobs=$((jobs - 1))
done
while [ "$told" -lt "$(wc -l <"$work/lines")" ]; do
    read -r number <&3
    tell "$number"
    told=$((told + 1))
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
