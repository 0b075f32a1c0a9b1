#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Verdicts of smc prove on 40 requirements over eight machines (second/), four of them examples.  `make prove-second`.
#
#     second.sh SMC [OPTION…]     the options are passed to smc prove
#
# They were written after the prover, by one of its authors, and nothing was changed for them.  second/expected.txt has the kinds, as author.sh explains
# them, with the machine and the reason.  The first run, with the default effort: 15 of 15 P proved, 15 of 15 V violated, 6 of 10 H proved, no wrong
# verdict, every script with at most 5 changes.
#
# Fails if a verdict is wrong, or if fewer are right than the last line demands.  What is undecided is listed.
smc=$1
shift
here=$(dirname "$0")/second
root=$(dirname "$0")/../..
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

for machine in $(awk '{print $3}' "$here/expected.txt" | uniq); do
    awk -v machine="$machine" '$3 == machine {print $1}' "$here/expected.txt" >"$out/ids"
    requirements=$(grep -l "^$(head -n 1 "$out/ids") " "$here"/*.rq)
    "$smc" prove "$root/$machine" "$requirements" --format=json -w "$@"
done >"$out/verdicts"
awk -v hard=6 -v most_changes=5 '
    FNR == NR { kind[$1] = $2; all[$2]++; next }
    match($0, /^{"id":"[A-Z]_[PVH][0-9]*"/) {
        id = substr($0, 8, RLENGTH - 8); of = kind[id]
        match($0, /"verdict":"[a-z]*"/); verdict = substr($0, RSTART + 11, RLENGTH - 12)
        right = of == "V" ? verdict == "violated" : verdict == "proved" || verdict == "vacuous"
        judged++; found[of] += right
        if (verdict == "undecided") print "undecided: " id
        else if (!right) { print id " is not " verdict; wrong++ }
        if (match($0, /"changes":[0-9]*/) && substr($0, RSTART + 10, RLENGTH - 10) + 0 > most_changes) { print id ": too many changes"; wrong++ }
    }
    END {
        if (judged != 40) { print judged + 0 " of 40 judged"; wrong++ }
        printf "verdicts on a second set of requirements: P %d of %d, V %d of %d, H %d of %d, wrong %d\n", found["P"], all["P"], found["V"], all["V"], found["H"], all["H"], wrong
        exit wrong || found["P"] < 15 || found["V"] < 15 || found["H"] < hard
    }' "$here/expected.txt" "$out/verdicts"
