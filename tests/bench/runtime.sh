#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# `make bench-runtime`:  runtime.sh BUILD CC
# What an access to the state vector costs, in instructions (callgrind: of one call, without the loop around it) and nanoseconds,
# and what code and tables of state vector, events, log and keep weigh.
build=$1 cc=$2
dir=$build/bench/runtime made=$build/runtime/made
mkdir -p "$dir"
strict='-std=c99 -ffp-contract=off -fno-tree-slp-vectorize -I.'
ours='runtime-c/statevec.c runtime-c/region.c runtime-c/names.c runtime-c/event.c'
others='runtime-c/log.c runtime-c/log_drain.c runtime-c/log_describe.c runtime-c/keep.c'
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

# ---- sizes ----

# The functions of each group; a program contains only those that it uses (-ffunction-sections -fdata-sections, --gc-sections).
groups='
function hex(text,    n, i) { for (i = 1; i <= length(text); i++) n = n * 16 + index("0123456789abcdef", substr(text, i, 1)) - 1; return n }
function group(name) {
    if (name ~ /^sm_(enter|leave|statevec_init)$/) return "lock"
    if (name ~ /^sm_read_number$/) return "reading a number"
    if (name ~ /^sm_write_number$/) return "writing a number"
    if (name ~ /^(sm_read_[A-Z]|read_typed)/) return "reading typed, all 11"
    if (name ~ /^(sm_write_[A-Z]|write_typed)/) return "writing typed, all 11"
    if (name ~ /^sm_(un)?pack_region$|^(copy_packed|store_unpacked|convert_to_wire|store_wire|load_wire)$/) return "wire form"
    if (name ~ /region$/) return "regions"
    if (name ~ /^sm_find|^find_name$|^is_same_name$/) return "names"
    if (name ~ /^sm_event_name$/) return "names of events"
    if (name ~ /^sm_event|^(un)?lock_ring$|^(copy_event|event_slot|count_overwritten)$/) return "events"
    if (name ~ /_names$/) return "V: names, without texts"
    if (name ~ /_sv$/) return "V: elements (RAM)"
    if (name ~ /_vector$/) return "V: SmStateVec (RAM)"
    if (name ~ /^fight_/) return "V: layout"
    return "shared: places, sizes, cells"
}
NF == 4 { bytes[group($4)] += hex($2) }
END { for (g in bytes) printf "%-12s %-32s %6d\n", name, g, bytes[g] }'

weigh() {                     # weigh NAME NM COMPILER FLAGS…
    name=$1 nm=$2
    shift 2
    command -v "$1" >/dev/null 2>&1 || { echo "$1 is not here: $name is left out"; return; }
    objects=
    for source in $ours $others "$made/fight.c"; do
        object=$dir/$(basename "$source" .c).o
        "$@" $strict -Os -ffunction-sections -fdata-sections -I"$made" -c "$source" -o "$object" || return
        objects="$objects $object"
    done
    $nm -S $objects | awk -v name="$name" "$groups" | sort
}

echo
weigh x86-64 nm $cc
weigh cortex-m3 arm-none-eabi-nm arm-none-eabi-gcc -mcpu=cortex-m3 -mthumb
weigh atmega328p avr-nm avr-gcc -mmcu=atmega328p
