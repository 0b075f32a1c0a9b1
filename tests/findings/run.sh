#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# run.sh SMC [--every=N] [FILE...]: every seeded fault of faulty/ is found and nothing else, nothing in clean/ (README.md).
# With N, of every N machines one is checked.  How long a step lasts is taken from the machine's own words.
smc=$1
shift
here=$(dirname "$0")
out=${TMPDIR:-/tmp}/smc-findings.$$
trap 'rm -f "$out"' EXIT
every=1
case $1 in --every=*) every=${1#*=}; shift ;; esac
[ $# -gt 0 ] || set -- "$here"/faulty/*[!d] "$here"/clean/*[!d]
passed=0 failed=0 n=0

for machine do
    n=$((n + 1))
    [ $((n % every)) -eq 0 ] || continue
    case $machine in
    *.sm) set -- "$machine" ;;
    *) set -- "$machine"/*.sm ;;
    esac
    vector=
    [ -f "$machine" ] || vector=--sv=$(echo "$machine"/*.sv)
    step=$(sed -n 's/.*Stepped every \([0-9]*\) ms.*/--step=\1/p' "$@" | sort -u)
    "$smc" check -Weverything --color=never $vector $step "$@" >"$out" 2>&1
    code=$?
    if [ $code = 0 ] && awk -v machine="$machine" -f "$here/judge.awk" "$here/also.txt" "$here/missed.txt" "$@" "$out"; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        [ $code = 0 ] || { echo "$machine: exit $code"; head -3 "$out"; }
    fi
done
echo "findings: $passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
