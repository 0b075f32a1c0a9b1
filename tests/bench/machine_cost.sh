#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Instructions a step by callgrind, what the loop and the inputs take not counted.     machine_cost.sh PROGRAM IMAGE
command -v valgrind >/dev/null 2>&1 || { echo "valgrind is not here" >&2; exit 1; }
program=$1 image=$2 steps=20000
out=$(mktemp "${TMPDIR:-/tmp}/smc-cost.XXXXXX") || exit 1
trap 'rm -f "$out"' EXIT

count() {                     # count WAY STEPS
    valgrind --tool=callgrind --callgrind-out-file="$out" "$program" "$1" "$2" "$image" >/dev/null 2>&1 || exit 1
    awk '/^summary:/ { print $2 }' "$out"
}

a_step() { echo "$(count "$1" 0) $(count "$1" $steps)" | awk -v n=$steps '{ printf "%.1f", ($2 - $1) / n }'; }

base=$(a_step input)
for way in plain tracked emitted emitted-guarded image image-guarded decoded decoded-guarded; do
    echo "$way $(a_step $way) $base" | awk '{ printf "%-16s %6.0f instructions a step\n", $1, $2 - $3 }'
done
echo "locks $(a_step locks)" | awk '{ printf "%-16s %6.0f instructions: two critical sections with nothing in them\n", $1, $2 }'
