#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Verdicts of smc prove on requirements of the examples, whose truth a person has decided: P1… cannot be violated, V1… can.
# Fails if a verdict is wrong, or if fewer of them are decided than the table below has.  `make prove-corpus`.
#
#     corpus.sh SMC [OPTION…]         the options are passed to smc prove
smc=$1
shift
here=$(dirname "$0")
out=$(mktemp)
trap 'rm -f "$out"' EXIT
passed=0
failed=0

# check NAME MACHINE PROVED VIOLATED [OPTION…]: at least so many are proved, and violated
check()
{
    name=$1 machine=$2 proved=$3 violated=$4
    shift 4
    "$smc" prove "$here/../../examples/$machine" "$here/corpus/$name.rq" --format=json -w "$@" >"$out"
    if awk -v name="$name" -v proved="$proved" -v violated="$violated" '
        match($0, /^{"id":"[PV][0-9]*"/) {
            id = substr($0, 8, RLENGTH - 8); kind = substr(id, 1, 1)
            match($0, /"verdict":"[a-z]*"/); verdict = substr($0, RSTART + 11, RLENGTH - 12)
            right = kind == "V" ? verdict == "violated" : verdict == "proved" || verdict == "vacuous"
            all[kind]++; found[kind] += right
            if (!right && verdict != "undecided") { print name ": " id " is not " verdict; wrong = 1 }
            if (verdict == "undecided") missed = missed " " id
        }
        END {
            printf "%s: %d of %d proved, %d of %d violated%s%s\n", name, found["P"], all["P"], found["V"], all["V"], missed ? "; undecided:" : "", missed
            exit wrong || found["P"] < proved || found["V"] < violated
        }' "$out"; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
    fi
}

check ignition   ignition/ignition.sm     21 12 "$@"
check chilldown  chilldown/chilldown.sm   15  6 --step=50 "$@"
check parachutes parachutes/parachutes.sm 14  6 "$@"
check recovery   recovery/recovery.sm     10  5 "$@"
check stand      teststand/stand.sm       19  8 "$@"
check monitor    teststand/monitor.sm      6  2 "$@"
check airbrakes  mission/airbrakes.sm      5  4 "$@"
check tank       tank/tank.sm              3  3 "$@"
check vent       replay/vent.sm            2  1 --step=20 "$@"
echo "verdicts on requirements of examples: $passed passed, $failed failed"
[ "$failed" = 0 ] && [ "$passed" = 9 ]
