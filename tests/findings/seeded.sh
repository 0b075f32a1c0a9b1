#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# seeded.sh SMC: faults that authors have seeded without knowledge of the analyses (README.md): each is found, at a line that its author
# accepts and with the output, state or sensor named, unless missed.txt lists it; nothing is found on a clean machine, unless wrong.txt
# lists it.
smc=$1
here=$(dirname "$0")/seeded
out=${TMPDIR:-/tmp}/smc-seeded.$$
trap 'rm -f "$out"' EXIT
tab=$(printf '\t')

# Every finding of a set as "MACHINE:LINE:COLUMN: warning: TEXT [CODE name]".
check_set() (
    cd "$1" || exit
    { cut -f1,6 faults.tsv; cut -f1,2 clean.tsv; } | sed '/^#/d' | sort -t "$tab" -k1,1 -u |
        while IFS=$tab read -r machine step; do
            [ "$step" = - ] && step=
            "$smc" check -Wflight --color=never ${step:+--step="$step"} "$machine" 2>&1 | sed -n '/: warning: /p'
        done
)

case $smc in /*) ;; *) smc=$PWD/$smc ;; esac
passed=0 failed=0
for set in "$here"/*/; do
    set=${set%/}
    check_set "$set" >"$out"
    line=$(awk -v set="$(basename "$set")" -f "$here/../seeded.awk" "$here/missed.txt" "$here/wrong.txt" "$out" "$set/clean.tsv" "$set/faults.tsv")
    echo "$line" | sed '$d'
    # shellcheck disable=SC2046
    set -- $(echo "$line" | sed -n '$p')
    passed=$((passed + $1)) failed=$((failed + $2))
done
echo "seeded: $passed passed, $failed failed"
[ $failed = 0 ] && [ $passed -ge 501 ]
