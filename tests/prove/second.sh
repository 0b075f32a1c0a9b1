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
awk -v id=1 -v all=40 -v proved=15 -v violated=15 -v hard=6 -v most_changes=5 -v set="a second set of requirements" \
    -f "$(dirname "$0")/verdicts.awk" "$here/expected.txt" "$out/verdicts"
