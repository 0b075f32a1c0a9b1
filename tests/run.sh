#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Runs the test commands of standard input and adds up their results.  Lines:
#   NAME: COMMAND     a test
#   +NAME: COMMAND    a test whose command calls make for files that others need: these run one after another, beside the others
#   [PART]            the following tests belong to this part; the runner prints a total and the time when a part is complete
# One command more than there are processors runs at once, because some wait for clocks and emulated boards, or as many as JOBS says.  The
# last line that a command prints ends with "N passed, N failed" or "N passed, N failed, N skipped".  Exit code 1 if a test failed, or with
# STRICT=1 if a test was skipped.
#
# A command fails as well if
#   1. it ran no test and skipped none,
#   2. it skipped nothing and passed fewer tests than floors.txt requires of its name,
#   3. it does not end within LIMIT seconds,
#   4. another command has the same name.
# With STRICT=1 it is a failure as well if the commands leave files in the source tree that git does not know; without, it is only printed.
floors=${FLOORS:-$(dirname "$0")/floors.txt}
limit=
timeout --foreground 1 true 2>/dev/null && limit="timeout --foreground -k 10 ${LIMIT:-3600}"      # in this process group, so that Ctrl-C ends it too
unset MAKEFLAGS MFLAGS MAKELEVEL      # a make called by a command gets no options of the current one
jobs=${JOBS:-$(($(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1) + 1))}
work=$(mktemp -d "${TMPDIR:-/tmp}/smc-test.XXXXXX") || exit 1
failures=$work/failures               # the ends of the outputs of failed commands, repeated at the end
trap 'rm -rf "$work"' EXIT
trap 'trap "" TERM; kill -TERM 0; exit 130' INT TERM

# $work/lines: the commands.  $work/parts: the part of each, "-" without one.
awk -v parts="$work/parts" 'BEGIN { part = "-" } /^$/ { next } /^\[[a-z]*\]$/ { part = substr($0, 2, length($0) - 2); next } { print; print part >parts }' >"$work/lines"
count=$(wc -l <"$work/lines" | tr -d ' ')
passed=0 failed=0 skipped=0 reported=0
mkfifo "$work/ended" && exec 3<>"$work/ended" || exit 1
for name in $(sed 's/^+\{0,1\}\([^:]*\):.*/\1/' "$work/lines" | sort | uniq -d); do
    echo "$name: two commands have this name"
    failed=$((failed + 1))
done
start=$(date +%s)

# list_untracked FILE: writes the names of the files that git neither knows nor ignores
list_untracked() { git ls-files --others --exclude-standard 2>/dev/null | LC_ALL=C sort >"$1"; }
list_untracked "$work/untracked"

# run NUMBER LINE: writes the output of the command to NUMBER.out, its exit code and seconds to NUMBER.code, and what `times` says of
# this worker before and after it to NUMBER.times
run() {
    began=$(date +%s)
    times >"$work/$1.times"
    $limit sh -c "${2#*: }" >"$work/$1.out" 2>&1 </dev/null 3>&-
    echo "$? $(($(date +%s) - began))" >"$work/$1.code"
    times >>"$work/$1.times"
    echo "$1" >&3
}

# Runs the commands that call make and have not begun, unless another worker is running them.
run_makes() {
    mkdir "$work/make" 2>/dev/null || return 0
    m=0
    while IFS= read -r making; do
        m=$((m + 1))
        case $making in
        +*) mkdir "$work/$m.begun" 2>/dev/null && run "$m" "$making" ;;
        esac
    done <"$work/lines"
    rmdir "$work/make" 2>/dev/null        # all may have been reported meanwhile, and the folder be gone
}

# Runs, in order, the commands that no other worker has begun.  Those that call make come first, or after the first of several parts: they run
# one after another, so a late start would leave the other workers idle at the end.
run_remaining() {
    n=0 first=$(uniq "$work/parts" | sed -n '1h; 2{g;p;q}')
    while IFS= read -r line && IFS= read -r part <&4; do
        n=$((n + 1))
        case $line in +*) continue ;; esac
        [ -d "$work/$n.begun" ] && continue
        [ "$part" = "$first" ] || run_makes
        mkdir "$work/$n.begun" 2>/dev/null && run "$n" "$line"
    done <"$work/lines" 4<"$work/parts"
    run_makes
}

# floor_of NAME: the least number of tests that a command of that name must run
floor_of() { sed -n "s/^$1  *\([0-9][0-9]*\)$/\1/p" "$floors" | tail -n 1 | grep . || echo 1; }

# cpu_of NUMBER: the processor seconds that a command and the processes it waited for took
cpu_of() {
    awk '{ for (i = 1; i <= 2; i++) { split($i, t, "m"); sum += (NR > 2 ? 1 : -1) * (60 * t[1] + t[2]) } } END { printf "%.1f", sum < 0 ? 0 : sum }' "$work/$1.times"
}

# report NUMBER: prints the result of a command and adds it to the totals
report() {
    out=$work/$1.out name=$(sed -n "$1s/^+\{0,1\}\([^:]*\):.*/\1/p" "$work/lines")
    read -r code seconds <"$work/$1.code"
    last=$(LC_ALL=C sed -n '/[0-9] passed, [0-9]* failed/p' "$out" | tail -n 1)        # grep prints no line of a file with other bytes than text
    p=$(printf '%s\n' "$last" | sed -n 's/^\(.*[^0-9]\)\{0,1\}\([0-9][0-9]*\) passed, [0-9][0-9]* failed.*/\2/p')
    f=$(printf '%s\n' "$last" | sed -n 's/.* passed, \([0-9][0-9]*\) failed.*/\1/p')
    s=$(printf '%s\n' "$last" | sed -n 's/.* failed, \([0-9][0-9]*\) skipped.*/\1/p')
    if [ -z "$p" ] || { [ "$code" -ne 0 ] && [ "${f:-0}" -eq 0 ]; }; then
        echo "$name: ended with exit code $code${p:+, with nothing failed}" >>"$out"
        last="${last:+$last, }ended with exit code $code"
        f=$((${f:-0} + 1))
        code=1
    elif [ $((p + f + ${s:-0})) -eq 0 ]; then
        echo "$name: no test was run" >>"$out"
        f=$((f + 1))
        code=1
    elif [ "${s:-0}" -eq 0 ] && [ "$((p + f))" -lt "$(floor_of "$name")" ]; then
        echo "$name: $((p + f)) tests were run; $floors requires at least $(floor_of "$name")" >>"$out"
        f=$((f + 1))
        code=1
    fi
    if [ "$code" -ne 0 ] || [ "${f:-0}" -ne 0 ] || [ "${s:-0}" -ne 0 ]; then
        cat "$out"
    fi
    if [ "$code" -ne 0 ] || [ "${f:-0}" -ne 0 ]; then
        { echo "---- $name"; tail -n 30 "$out"; } >>"$failures"
    fi
    reported=$((reported + 1))
    cpu=$(cpu_of "$1")
    printf '[%*d/%d] %-24s %4d s %6s cpu  %s\n' ${#count} "$reported" "$count" "$name" "$seconds" "$cpu" "$last"
    echo "$cpu $seconds $name" >>"$work/cpu"
    passed=$((passed + ${p:-0})) failed=$((failed + ${f:-0})) skipped=$((skipped + ${s:-0}))
    add_to_part "$(sed -n "$1p" "$work/parts")" "${p:-0}" "${f:-0}" "${s:-0}"
}

# add_to_part PART PASSED FAILED SKIPPED: prints the part's totals after its last command
add_to_part() {
    [ "$1" = - ] && return
    echo "$2 $3 $4" >>"$work/part.$1"
    [ "$(wc -l <"$work/part.$1")" -eq "$(grep -c "^$1\$" "$work/parts")" ] || return
    awk -v part="$1" -v seconds=$(($(date +%s) - start)) '{ p += $1; f += $2; s += $3 }
        END { printf "---- %s: %d passed, %d failed%s, after %d s\n", part, p, f, s ? ", " s " skipped" : "", seconds }' "$work/part.$1"
}

while [ "$jobs" -gt 0 ]; do
    run_remaining &
    jobs=$((jobs - 1))
done
while [ "$reported" -lt "$count" ]; do
    read -r number <&3
    report "$number"
done

# The ten tests that took most processor seconds, in a run that has more than ten.
[ "$count" -le 10 ] || LC_ALL=C sort -rn "$work/cpu" | awk '
    { sum += $1 }
    NR <= 10 { most = most sprintf("    %-24s %4d s %6.1f cpu\n", $3, $2, $1) }
    END { printf "---- most processor seconds, of %.0f in all:\n%s", sum, most }'

[ ! -s "$failures" ] || cat "$failures"
list_untracked "$work/untracked.after"
LC_ALL=C comm -13 "$work/untracked" "$work/untracked.after" >"$work/left"
if [ -s "$work/left" ]; then
    sed 's/^/a new file in the source tree: /' "$work/left"
    [ "${STRICT:-0}" = 1 ] && failed=$((failed + 1))
fi
if [ "$skipped" -ne 0 ]; then
    echo "skipped tests need tools that are not here; on Debian or Ubuntu: apt-get install clang tcc g++ lua5.4 luajit chromium graphviz librsvg2-bin"
    echo "  python3-jsonschema python3-yaml wine wine64 gcc-mingw-w64-x86-64 gcc-mingw-w64-i686; and: make sarif-schema"
    echo "$passed passed, $failed failed, $skipped skipped"
    [ "${STRICT:-0}" = 1 ] && exit 1
else
    echo "$passed passed, $failed failed"
fi
[ "$failed" -eq 0 ]
