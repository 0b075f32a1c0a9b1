#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# `make bench-avr`:  avr.sh BUILD CC
# Cycles of a step on an emulated ATmega328P, and flash and RAM, at -Os: machines of avr/ by hand, as emitted C, on the VM.  The rows must
# agree on the state vector after every step.  The VM's RAM is left out, since its memory is larger here than it needs.  "value" records on standard output.
# Wants gcc-avr avr-libc libsimavr-dev libelf-dev.
B=$1 CC=$2
here=tests/bench/avr dir=$B/bench/avr
if ! command -v avr-gcc >/dev/null 2>&1 || ! echo '#include <simavr/sim_avr.h>' | $CC -fsyntax-only -x c - 2>/dev/null; then
    echo "note avr-gcc or simavr is not here: the rows of the ATmega328P are left out"
    exit 0
fi
export ASAN_OPTIONS=detect_leaks=0             # libsimavr forgets what it read of the firmware
rm -rf "$dir"
mkdir -p "$dir" || exit 1
$CC -std=gnu99 -O1 -I. tests/avr/sim.c $here/run.c -o "$dir/run" -lsimavr -lelf || exit 1
flags="-mmcu=atmega328p -DF_CPU=16000000UL -Os -std=gnu99 -Wall -Wextra -ffunction-sections -fdata-sections -Wl,--gc-sections -I. -I$here -I$dir"
# Without elementary functions, as the firmware of an Uno (bytecode-vm/firmware/config.h).
vm="-DSMVM_FUNCTIONS=0 bytecode-vm/load.c bytecode-vm/pins.c bytecode-vm/interp.c bytecode-vm/function.c bytecode-vm/interp_avr.S stdlib/soft_arith.c stdlib/soft_convert.c stdlib/soft_avr.S"

build() {                     # build ROW HEADER MACHINE INIT STEP SOURCE-OR-OPTION…
    elf=$dir/$m-$1.elf header=$2 machine=$3 init=$4 step=$5
    shift 5
    avr-gcc $flags "-DHEADER=\"$header\"" "-DMACHINE=$machine machine" -DSV=${M}Sv "-DROW_INIT=$init" "-DROW_STEP=$step" "$@" $here/row.c -o "$elf" || exit 1
}

for m in dual median; do
    case $m in dual) M=Dual ;; *) M=Median ;; esac
    "$B/smc" build -w $here/$m.sm --emit=c --soft -o "$dir/$m.c" && "$B/smc" build -w $here/$m.sm --emit=array -o "$dir/${m}_image.h" || exit 1
    build hand ${m}_hand.h ${M}Hand "${m}_hand_init(&machine, &sv)" "${m}_hand_step(&machine, &sv)"
    build c $m.h $M "${m}_init(&machine, &sv, 1)" "${m}_step(&machine, &sv)" "$dir/$m.c" $(ls "$dir"/sm_soft*.[cS])
    build vm vm.h "Memory" "start(&machine, sizeof machine, &sv, sizeof sv)" "smvm_step((SmVm *)&machine, &sv)" \
        -DSV_HEADER="\"$m.h\"" -DIMAGE_HEADER="\"${m}_image.h\"" -DIMAGE=${m}_image $vm
    "$dir/run" $m "$dir/$m-hand.elf" "$dir/$m-c.elf" "$dir/$m-vm.elf" >"$dir/$m.txt" || { cat "$dir/$m.txt"; exit 1; }
    awk -v m=$m '
        { n = split($1, path, "[-/.]"); row = path[n - 1]; cycles[row] = $2; printf "value avr %s-%s %d cycles\nvalue avr %s-%s-most %d cycles\n", m, row, $2, m, row, $3 }
        END { printf "value avr %s-c-to-hand %.3g times\nvalue avr %s-c-to-vm %.3g times\n", m, cycles["c"] / cycles["hand"], m, cycles["c"] / cycles["vm"] }' "$dir/$m.txt"
    for row in hand c vm; do
        avr-size "$dir/$m-$row.elf" | awk -v m=$m-$row 'NR > 1 { printf "value avr %s-flash %d bytes\n", m, $1 + $2 }
            NR > 1 && m !~ /vm$/ { printf "value avr %s-ram %d bytes\n", m, $2 + $3 }'
    done
done
