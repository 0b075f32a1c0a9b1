# SPDX-License-Identifier: Apache-2.0
# For test scripts of single checks, to be read in by `. tests/checks.sh`.  $dir is a folder of theirs.
passed=0 failed=0 skipped=0

check()     # NAME COMMAND…
{
    name=$1
    shift
    if "$@" >"$dir/log" 2>&1; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "failed: $name"
        head -20 "$dir/log"
    fi
}

skip() { skipped=$((skipped + 1)); echo "skipped: $*"; }
has() { command -v "$1" >/dev/null 2>&1; }

finish()    # NAME: the last line, and what the script ends with
{
    if [ "$skipped" -eq 0 ]; then echo "$1: $passed passed, $failed failed"; else echo "$1: $passed passed, $failed failed, $skipped skipped"; fi
    [ "$failed" -eq 0 ] && [ $((passed + skipped)) -gt 0 ]
}
