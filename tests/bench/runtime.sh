#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# `make bench-runtime`:  runtime.sh BUILD CC
# What an access to the state vector costs, in instructions (callgrind: of one call, without the loop around it) and nanoseconds,
# and what code and tables of state vector and events weigh on x86-64 and Cortex-M3.
build=$1 cc=$2
dir=$build/bench/runtime made=$build/runtime/made
mkdir -p "$dir"
strict='-std=c99 -ffp-contract=off -fno-tree-slp-vectorize -I.'
ours='runtime-c/statevec.c runtime-c/region.c runtime-c/names.c runtime-c/event.c'
psl='runtime-c/psl/linux/lock.c runtime-c/psl/linux/clock.c runtime-c/psl/linux/linux.c'

$cc $strict -O2 -I"$made" tests/bench/runtime.c "$made/plain.c" "$made/fight.c" $ours $psl -pthread -o "$dir/run" || exit 1

# ---- what a call costs ----

counted() {                   # counted ROW N: the program's instructions
    valgrind --tool=callgrind --callgrind-out-file=/dev/null "$dir/run" "$1" "$2" 2>&1 | awk '/Collected/ { print $4 }'
}

"$dir/run" time >"$dir/times"
if command -v valgrind >/dev/null 2>&1; then
    for row in $("$dir/run"); do
        echo "count $row $(counted "$row" 1000) $(counted "$row" 2000)"
    done >"$dir/counts"
else
    echo 'valgrind is not here: instructions are left out'
    : >"$dir/counts"
fi
awk '
    $1 == "count" { insn[$2] = ($4 - $3) / 1000 }
    $1 == "time"  { if (!base) base = $3; ns[$2] = $3; order[++n] = $2 }
    END {
        printf "%-22s %12s %8s\n", "", "instructions", "ns"
        for (i = 2; i <= n; i++)
            printf "%-22s %12s %8.1f\n", order[i], order[i] in insn ? insn[order[i]] - insn["nothing"] + 1 : "", ns[order[i]] - base
    }' "$dir/counts" "$dir/times"

# ---- what it weighs ----

weigh() {                     # weigh NAME SIZE COMPILER FLAGS…
    name=$1 size=$2
    shift 2
    command -v "$1" >/dev/null 2>&1 || { echo "$1 is not here: $name is left out"; return; }
    for source in $ours "$made/fight.c"; do
        "$@" $strict -Os -ffunction-sections -fdata-sections -I"$made" -c "$source" -o "$dir/$(basename "$source" .c).o" || return
    done
    for part in statevec region names event fight; do
        $size "$dir/$part.o" | awk -v name="$name" -v part="$part" 'NR == 2 { printf "%-12s %-10s %8d %8d\n", name, part, $1, $2 + $3 }'
    done
}

printf '\n%-12s %-10s %8s %8s\n' '' '' 'ROM' 'RAM'
weigh x86-64 size $cc
weigh cortex-m3 arm-none-eabi-size arm-none-eabi-gcc -mcpu=cortex-m3 -mthumb
