#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# The second half of `make bench-runtime`:  ticks.sh BUILD CC
# What a tick and a task's step cost, in instructions (callgrind), beside a loop over function pointers; what task, executor and
# application weigh, in code and in memory.
build=$1 cc=$2
dir=$build/bench/runtime made=$build/runtime/made
mkdir -p "$dir"
strict='-std=c99 -ffp-contract=off -I.'

if command -v valgrind >/dev/null 2>&1; then
    $cc $strict -O2 -I"$made" tests/bench/ticks.c "$made/crew.c" runtime-c/task.c runtime-c/executor.c runtime-c/statevec.c runtime-c/event.c \
        $(ls runtime-c/psl/sim/*.c) -o "$dir/ticks" || exit 1
    counted() { valgrind --tool=callgrind --callgrind-out-file=/dev/null "$dir/ticks" "$1" "$2" 2>&1 | awk '/Collected/ { print $4 }'; }
    printf '\n%-24s %s\n' '' 'instructions a tick'
    for row in $("$dir/ticks"); do
        echo "$row $(counted "$row" 1000) $(counted "$row" 2000)"
    done | awk '{ n = ($3 - $2) / 1000; if (NR == 1) none = n; else printf "%-24s %8.1f\n", $1, n - none }'
else
    echo 'valgrind is not here: instructions are left out'
fi

weigh() {                     # weigh NAME SIZE COMPILER FLAGS…
    name=$1 size=$2
    shift 2
    command -v "$1" >/dev/null 2>&1 || { echo "$1 is not here: $name is left out"; return; }
    for part in task executor app run writing; do
        "$@" $strict -Os -ffunction-sections -fdata-sections -c runtime-c/$part.c -o "$dir/$part.o" || return
        $size "$dir/$part.o" | awk -v name="$name" -v part="$part" 'NR == 2 { printf "%-12s %-12s %6d %6d\n", name, part, $1, $2 + $3 }'
    done
    echo '#include "runtime-c/app.h"
        char a_task[sizeof(SmTask)], an_executor[sizeof(SmExecutor)], an_app[sizeof(SmApp)];' >"$dir/sizes.c"
    "$@" $strict -Os -fno-common -c "$dir/sizes.c" -o "$dir/sizes.o" || return
    nm -S "$dir/sizes.o" | grep ' an*_' | while read -r _ bytes _ what; do
        printf '%-12s %-12s %6s %6d\n' "$name" "$what" '' "$((0x$bytes))"
    done
}
printf '\n%-12s %-12s %6s %6s\n' '' '' 'ROM' 'RAM'
weigh x86-64 size $cc
weigh cortex-m3 arm-none-eabi-size arm-none-eabi-gcc -mcpu=cortex-m3 -mthumb
weigh atmega328p avr-size avr-gcc -mmcu=atmega328p
