#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# The bench's report of part of its records: `make bench-count` has no times, and shows its instructions all the same.
dir=$(dirname "$0")/../bench
got=$(echo 'insn tank vm 42' | awk -v json=/dev/stdout -f "$dir/report.awk" "$dir/goals.txt" - | tr -s ' ')
pass=0 fail=0
for want in ' vm 42.00' '{"workload": "tank", "row": "vm", "instructions": 42}'; do
    case $got in
    *"$want"*) pass=$((pass + 1)) ;;
    *) fail=$((fail + 1)); printf 'bench report: no "%s" in\n%s\n' "$want" "$got" ;;
    esac
done
echo "bench-report: $pass passed, $fail failed"
[ $fail = 0 ]
