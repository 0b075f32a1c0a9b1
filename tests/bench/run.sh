#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# `make bench`:  run.sh BUILD CC PARTS WORKLOADS
# Each part adds records to BUILD/bench/records; report.awk makes the table and BUILD/bench.json of them.
#     time      ns a step, all rows (BENCH_SECONDS each workload, 8)
#     count     instructions a step, by callgrind
#     sizes     images, memory, the VM's code
#     compile   the speed of the compiler, and of gcc on the emitted C
#     avr       cycles a step on an emulated ATmega328P
build=$1 cc=$2 parts=$3 workloads=$4
here=tests/bench dir=$build/bench
records=$dir/records
: >"$records"

note() { echo "note $*" >>"$records"; }

# One core, so that alternating programs use the same caches; the last one, since interrupts tend to be on the first.
pin=
core=$(($(getconf _NPROCESSORS_ONLN) - 1))
if command -v taskset >/dev/null 2>&1 && taskset -c "$core" true 2>/dev/null; then
    pin="taskset -c $core"
else
    note "taskset is not here: the runs were not pinned to a core"
fi

for lua in lua5.4 luajit; do
    command -v $lua >/dev/null 2>&1 || note "$lua is not here: its rows are left out"
done

grep -q ".!" "$dir/wasm3.txt" || note "wasm3 is not here (tests/bench/README.md): its row is left out"

part_time() {
    for w in $workloads; do
        echo "bench: time of $w" >&2
        $pin "$dir/steps" "$dir" time "${BENCH_SECONDS:-8}" "$w" >>"$records" 2>"$dir/log" || { cat "$dir/log" >&2; exit 1; }
    done
}

# ---- instructions ----

record_instructions() {       # record_instructions ROW NONE ALL STEPS
    echo "$w $*" | awk '{ printf "insn %s %s %.6g\n", $1, $2, ($4 - $3) / $5 }' >>"$records"
}

# Under callgrind, which dumps what was collected each time a drive returns: first the warm steps, then those that count.
count_rows() {
    rm -f "$dir"/callgrind.*
    set --
    for drive in empty native f64 c_o0 c_o1 c_o2 c_os in_place decoded ref wasm; do
        set -- "$@" "--dump-after=drive_$drive*"
    done
    valgrind --tool=callgrind --callgrind-out-file="$dir/callgrind" --toggle-collect='drive_*' "$@" \
        "$dir/steps" "$dir" count "$w" >"$dir/counted" 2>"$dir/log" || { cat "$dir/log" >&2; exit 1; }
    n=0
    while read -r _ row steps; do
        n=$((n + 2))
        all=$(awk '/^summary:/ { print $2 }' "$dir/callgrind.$n")
        record_instructions "$row" 0 "$all" "$steps"
    done <"$dir/counted"
}

instructions_of() {           # instructions_of STEPS COMMAND…
    echo "count 0 $1" >"$dir/asked"
    shift
    valgrind --tool=callgrind --callgrind-out-file="$dir/callgrind" \
        "$@" $here/driver.lua "$w" "$dir/$w.count" <"$dir/asked" >/dev/null 2>&1 &&
        awk '/^summary:/ { print $2 }' "$dir/callgrind"
}

# The cost in Lua is the difference of two runs, since it has no function to search in the profile.
count_lua() {
    "$dir/steps" "$dir" inputs "$w" || exit 1
    steps=$(awk 'NR == 1 { print $3 }' "$dir/counted")
    for row in lua luajit-int; do
        case $row in
        lua) set -- lua5.4 ;;
        *) set -- luajit -joff ;;
        esac
        command -v "$1" >/dev/null 2>&1 || continue
        none=$(instructions_of 0 "$@")
        all=$(instructions_of "$steps" "$@")
        if [ -n "$none" ] && [ -n "$all" ]; then
            record_instructions "$row" "$none" "$all" "$steps"
        else
            note "$1 does not run under valgrind: its instructions were not counted"
        fi
    done
}

part_count() {
    command -v valgrind >/dev/null 2>&1 || { note "valgrind is not here: no instructions were counted"; return; }
    for w in $workloads; do
        echo "bench: instructions of $w" >&2
        count_rows
        count_lua
    done
}

# ---- sizes ----

code_of() {                   # code_of NAME FILE…: code and constants of some files of the VM, for size
    name=$1 sum=0
    shift
    for f in "$@"; do
        [ -f "$f" ] || return 0
        $cc -std=c99 -ffp-contract=off -I. -Os -c "$f" -o "$dir/size.o" || exit 1
        sum=$((sum + $(size -A "$dir/size.o" | awk '/^\.(text|rodata)/ { n += $2 } END { print n + 0 }')))
    done
    echo "value vm $name $sum bytes" >>"$records"
}

part_sizes() {
    for w in $workloads; do
        "$dir/steps" "$dir" sizes "$w" >>"$records" || exit 1
    done
    command -v size >/dev/null 2>&1 || { note "size is not here: the VM was not weighed"; return; }
    code_of core bytecode-vm/load.c bytecode-vm/interp.c
    code_of verifier bytecode-vm/verify.c
    code_of decoded bytecode-vm/decode*.c bytecode-vm/fast.c
}

part_compile() {
    echo "bench: compiling" >&2
    $pin "$dir/compile" "$cc" "$dir" "$dir/prefix/bin/smc" >>"$records" || exit 1
}

part_avr() {
    echo "bench: ATmega328P" >&2
    sh $here/avr.sh "$build" "$cc" >>"$records" || exit 1
}

for part in $parts; do
    "part_$part"
done
awk -v json="$build/bench.json" -f $here/report.awk $here/goals.txt "$records"
