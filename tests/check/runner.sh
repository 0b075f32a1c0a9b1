#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# tests/run.sh itself: which commands it counts as passed and which as failed.
passed=0 failed=0
dir=$(mktemp -d "${TMPDIR:-/tmp}/smc-runner.XXXXXX") || exit 1
trap 'rm -rf "$dir"' EXIT
echo 'counted 10' >"$dir/floors"
limit=200               # seconds that a command of a line may take

# ends WANT TEXT LINE…: the runner ends with exit code WANT on these lines, and prints TEXT
ends() {
    want=$1 text=$2
    shift 2
    printf '%s\n' "$@" | FLOORS=$dir/floors LIMIT=$limit STRICT=0 JOBS=2 sh tests/run.sh >"$dir/out" 2>&1
    if [ $? -eq "$want" ] && grep -q "$text" "$dir/out"; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "runner: not exit $want and '$text' for:" "$@"
        cat "$dir/out"
    fi
}

ends 0 '^3 passed, 0 failed$' 'a: echo a: 1 passed, 0 failed' '+b: echo 2 passed, 0 failed'
ends 0 '^1 passed, 0 failed, 1 skipped$' 'a: echo 1 passed, 0 failed' 'b: echo 0 passed, 0 failed, 1 skipped'
ends 1 '^1 passed, 2 failed$' 'a: echo 1 passed, 2 failed; exit 1'
ends 1 'a: ended with exit code 0' 'a: echo nothing'
ends 1 '^\[1/1\] a  *[0-9]* s  *[0-9.]* cpu  ended with exit code 0$' 'a: echo nothing'
ends 1 '^\[1/1\] a  *[0-9]* s  *[0-9.]* cpu  1 passed, 0 failed, ended with exit code 3$' 'a: echo 1 passed, 0 failed; exit 3'
ends 1 'a: ended with exit code 3, with nothing failed' 'a: echo 1 passed, 0 failed; exit 3'
ends 1 'a: no test was run' 'a: echo 0 passed, 0 failed'
ends 1 'counted: 9 tests were run; .* requires at least 10' 'counted: echo 9 passed, 0 failed'
ends 0 '^---- one: 3 passed, 0 failed, 1 skipped, after' '[one]' 'a: echo 1 passed, 0 failed' 'b: echo 2 passed, 0 failed, 1 skipped' '[two]' 'c: echo 4 passed, 0 failed'
ends 1 '^---- two: 4 passed, 1 failed, after' '[one]' 'a: echo 1 passed, 0 failed' '[two]' 'b: exit 1' 'c: echo 4 passed, 0 failed'
ends 0 '^2 passed, 0 failed' "+a: mkdir $dir/make && sleep 1 && rmdir $dir/make && echo 1 passed, 0 failed" "+b: mkdir $dir/make && rmdir $dir/make && echo 1 passed, 0 failed"
ends 1 'a: two commands have this name' 'a: echo 1 passed, 0 failed' '+a: echo 1 passed, 0 failed'
ends 0 '^---- most processor seconds, of [0-9]* in all:$' "$(printf '%s: echo 1 passed, 0 failed\n' a b c d e f g h i j k)"
ends 0 '^10 passed' 'counted: echo 10 passed, 0 failed'
ends 0 '^9 passed, 0 failed, 1 skipped' 'counted: echo 9 passed, 0 failed, 1 skipped'
ends 0 '^\[1/1\] a  *[0-9]* s  *[0-9.]*[1-9][0-9.]* cpu ' 'a: awk "BEGIN { while (i < 30000000) i++ }"; echo 1 passed, 0 failed'
ends 0 '^1 passed, 0 failed$' 'a: printf "\\377\\000\\n"; echo 1 passed, 0 failed'        # bytes that are no text
limit=2
if timeout --foreground 1 true 2>/dev/null; then ends 1 'a: ended with exit code 124' 'a: exec sleep 20'; fi
# Files that a command leaves in the source tree, which is a repository of git.
runner=$PWD/tests/run.sh
leaves() # STRICT CODE: the runner ends with CODE, and names the file
{
    (cd "$dir/tree" && echo 'a: echo left >out; echo 1 passed, 0 failed' | STRICT=$1 sh "$runner") >"$dir/out" 2>&1
    if [ $? -eq "$2" ] && grep -qx 'a new file in the source tree: out' "$dir/out" && rm "$dir/tree/out"; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "runner: STRICT=$1 and a file that is left"
        cat "$dir/out"
    fi
}
if mkdir "$dir/tree" && git init -q "$dir/tree" 2>/dev/null; then
    : >"$dir/tree/known"
    leaves 0 0
    leaves 1 1
fi
echo "runner: $passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
