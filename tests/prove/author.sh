#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Verdicts of smc prove on 60 requirements over ten machines (author/), whose truth their author has decided.  `make prove-author`.
#
#     author.sh SMC [OPTION…]     the options are passed to smc prove
#     author.sh --scripts SMC     only runs author/scripts: each ends with the violation of the requirement that it is named after
#
# The author wrote machines, requirements, the expected verdicts with their reasons (author/expected.txt) and the scripts from the documents
# alone, before smc prove was run on any of them.  The first run, before any fix, with the default effort: 22 of 25 P proved, 22 of 25 V
# violated, 6 of 10 H proved, no wrong verdict, every script with at most 5 changes.
#
#     P   no run violates it, and the reason is short
#     V   some run violates it
#     H   no run violates it, but a proof needs more than facts about single variables
#
# Fails if a verdict is wrong, or if fewer are right than the last line demands.  What is undecided is listed.
if [ "$1" = --scripts ]; then
    only_scripts=yes
    shift
fi
smc=$1
shift
here=$(dirname "$0")/author
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

passed=0
failed=0
for script in "$here"/scripts/*.ss; do
    id=$(basename "$script" .ss)
    machine=$(ls "$here/$(echo "${id%_*}" | tr M m)"_*.sm)
    if "$smc" test "$machine" "$script" "${machine%.sm}.rq" -w 2>&1 | grep -q "violat.*$id\|$id.*violat"; then
        passed=$((passed + 1))
    else
        echo "$script does not violate $id"
        failed=$((failed + 1))
    fi
done
echo "scripts that violate their requirement: $passed passed, $failed failed"
[ "$failed" = 0 ] && [ "$passed" = 25 ] || exit 1
[ -z "$only_scripts" ] || exit 0

for machine in "$here"/m*.sm; do
    "$smc" prove "$machine" "${machine%.sm}.rq" --format=json -w "$@"
done >"$out/verdicts"
awk -v id=2 -v all=60 -v proved=25 -v violated=25 -v hard=10 -v most_changes=5 -v set="requirements of an independent author" \
    -f "$(dirname "$0")/verdicts.awk" "$here/expected.txt" "$out/verdicts"
