#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Builds firmware for an ATmega328P and runs it in simavr.     run.sh BUILD CC [N [SEED [PROGRAMS]]]: N random operands for each operation, and
# so many random programs.
# Wants gcc-avr avr-libc libsimavr-dev libelf-dev; AVR_CC names the compiler.
B=$1/avr CC=$2 N=${3:-600} SEED=${4:-1} PROGRAMS=${5:-20}
AVR_CC=${AVR_CC:-avr-gcc}
mkdir -p "$B" || exit 1
if ! command -v "$AVR_CC" >/dev/null 2>&1; then
    echo "no $AVR_CC here: 0 passed, 0 failed, 1 skipped"
    exit 0
fi
if ! echo '#include <simavr/sim_avr.h>' | $CC -fsyntax-only -x c - 2>/dev/null; then
    echo "no simavr here: 0 passed, 0 failed, 1 skipped"
    exit 0
fi
passed=0 failed=0
export ASAN_OPTIONS=detect_leaks=0             # libsimavr forgets what it read of the firmware

count() {
    if "$@"; then passed=$((passed + 1)); else failed=$((failed + 1)); echo "failed: $*"; fi
}

# avr NAME OPTION-OR-SOURCE…: the firmware NAME
avr() {
    name=$1
    shift
    "$AVR_CC" -mmcu=${AVR_MCU:-atmega328p} -Os -std=c99 -Wall -Wextra -Wconversion -Wshadow -Werror -ffunction-sections -fdata-sections -Wl,--gc-sections \
        -I. "$@" -o "$B/$name.elf"
}

SOFT="stdlib/soft_arith.c stdlib/soft_convert.c stdlib/soft_avr.S stdlib/soft_cells.c stdlib/soft_cells_avr.S stdlib/soft_sqrt_avr.S"
$CC -std=gnu99 -ffp-contract=off -O1 -Wall -Wextra -I. tests/avr/sim.c tests/avr/run_soft.c tests/soft/hardware.c tests/soft/vectors.c -o "$B/run_soft" \
    -lsimavr -lelf -lm || exit 1
avr soft tests/avr/soft.c $SOFT || exit 1
avr soft_portable -DSM_SOFT_PORTABLE tests/avr/soft.c $SOFT || exit 1
count "$B/run_soft" "$B/soft.elf" "$N" "$SEED"
count "$B/run_soft" "$B/soft_portable.elf" 20 "$SEED" free >"$B/soft_portable.txt"
"$AVR_CC" -mmcu=atmega328p -I. -c stdlib/soft_avr.S -o "$B/soft_avr.o" || exit 1
size=$(avr-size "$B/soft_avr.o" | awk 'NR == 2 { print $1 }')
echo "soft binary64: $size bytes of flash"
count test "$size" -le 2816
"$AVR_CC" -mmcu=atmega328p -I. -c stdlib/soft_sqrt_avr.S -o "$B/soft_sqrt_avr.o" || exit 1
size=$(avr-size "$B/soft_sqrt_avr.o" | awk 'NR == 2 { print $1 }')
echo "square root: $size bytes of flash"
count test "$size" -le 256
# Rolling windows, all types and statistics.
avr roll tests/avr/roll.c $SOFT || exit 1
$CC -std=gnu99 -ffp-contract=off -O1 -Wall -Wextra -I. tests/avr/sim.c tests/avr/run_roll.c -o "$B/run_roll" -lsimavr -lelf || exit 1
count "$B/run_roll" "$B/roll.elf" "$SEED"
size=$(avr-nm -S --radix=d "$B/roll.elf" | awk '$4 ~ /^sm_roll_/ { n += $2 } END { print n }')
echo "rolling windows: $size bytes of flash"
count test "$size" -le 2048
# The code of signed images.
avr auth tests/avr/auth.c bytecode-vm/auth.c bytecode-vm/load.c || exit 1
$CC -std=gnu99 -O1 -Wall -Wextra -I. tests/avr/sim.c tests/avr/run_auth.c compiler/device/sign.c "$1/libsmc.a" -o "$B/run_auth" -lsimavr -lelf -lm || exit 1
count "$B/run_auth" "$B/auth.elf"
size=$(avr-nm -S --radix=d "$B/auth.elf" | awk '$4 ~ /^(smvm_auth|smvm_mac)_/ || $4 ~ /^(permute|double_key|xor_block|find_auth_section|byte_of|rotate_)/ { n += $2 } END { print n }')
echo "code of images: $size bytes of flash"
count test "$size" -le 1400
# avr-gcc 5.4 takes (x & 0x7FF0000000000000u) == 0x7FF0000000000000u for false.  No code that runs on a board compares 64 masked bits with the mask.
masked_64='& \(0x[0-9A-Fa-f]\{16\}\)u*) *[!=]= *\1'
count sh -c "echo 'if ((x & 0x7FF0000000000000u) != 0x7FF0000000000000u)' | grep -q '$masked_64'"
count sh -c "! grep -rn '$masked_64' --include='*.[ch]' stdlib bytecode-vm runtime-c"
# The VM: examples and random programs, in lock step with the VM here.
VM="tests/avr/vm.c bytecode-vm/load.c bytecode-vm/pins.c bytecode-vm/verify.c bytecode-vm/interp.c bytecode-vm/function.c bytecode-vm/interp_avr.S bytecode-vm/interp_avr_eeprom.S $SOFT"
vm() { name=$1; shift; avr "$name" "$@" $VM || exit 1; }
# An ATmega1284P has room for all elementary functions, and otherwise runs as an ATmega328P does.
export AVR_MCU=atmega1284p
vm vm -DVM_CELLS
vm vm_portable -DVM_CELLS -DSMVM_PORTABLE
vm vm_eeprom -DVM_CELLS -DSMVM_FUNCTIONS=UINT32_MAX -DSMVM_CONFIG='"bytecode-vm/firmware/config.h"'
$CC -std=gnu99 -ffp-contract=off -O1 -Wall -Wextra -I. tests/avr/sim.c tests/avr/run_vm.c "$1/libsmc.a" -o "$B/run_vm" -lsimavr -lelf -lm || exit 1
rm -rf "$B/images" "$B/program"
mkdir -p "$B/images"
"$1/smc" build -w examples/tank/tank.sm -o "$B/tank.smb" || exit 1
for workload in arith mission; do
    "$1/smc" build -w tests/bench/workloads/$workload.sm --sv tests/bench/workloads/$workload.sv -o "$B/images/$workload.smb" || exit 1
done
program=$SEED
while [ $program -lt $((SEED + PROGRAMS)) ]; do
    "$1/diff/difftest" --seed=$program --print --out="$B/program" >/dev/null || exit 1
    sv=$(ls "$B"/program/*.sv 2>/dev/null)
    "$1/smc" build -w "$B"/program/*.sm ${sv:+--sv "$sv"} -O$((program % 3)) -o "$B/images/$program.smb" || exit 1
    rm -rf "$B/program"
    program=$((program + 1))
done
size_of() { avr-size "$B/$1.elf" | awk 'NR == 2 { print $1 - 1024 }'; }          # without the room for an image
vm vm_plain -DVM_CELLS -DSMVM_FUNCTIONS=0u
vm vm_none -DVM_CELLS -DSMVM_FUNCTIONS=0u -DSM_ROLL_NONE=1
echo "VM and verifier with soft binary64: $(size_of vm_plain) bytes of flash, $(size_of vm_none) without windows, $(size_of vm) with all elementary functions"
count test $(($(size_of vm_plain) - $(size_of vm_none))) -ge 1900
sed 's/F64  tankPressure/I16  tankPressure/' tests/avr/tank.sv >"$B/tank.sv"
sed 's/^F64 *tankPressure/I16 tankPressure/' examples/tank/tank.sm >"$B/tank_i16.sm"
"$1/smc" build -w "$B/tank_i16.sm" --sv "$B/tank.sv" -o "$B/tank_i16.smb" || exit 1
for program in types numbers functions; do
    "$1/smc" build -w tests/avr/$program.sm -o "$B/$program.smb" || exit 1
done
{   # more outputs than an SmVm itself has bits for
    printf '[state_vector]\nU64 time @alias G\nU32 state @alias S\nU8 in @read_only\n'
    for i in $(seq 90); do echo "bool out$i"; done
    printf '[Many]\n.step\n'
    for i in $(seq 30); do echo "    out$((i * 3)) = in > $i"; done
    echo '    if in > 99 {'
    for i in $(seq 30); do echo "        out$((i * 3 - 1)) = true"; done
    echo '    }'
} >"$B/many.sm"
"$1/smc" build -w "$B/many.sm" -o "$B/many.smb" || exit 1
for kind in vm vm_eeprom vm_portable; do           # in assembly, whose cycles are held against the estimate of reports, that for EEPROM, in C
    if [ $kind = vm_portable ]; then unset ESTIMATE; else export ESTIMATE=1; fi
    count "$B/run_vm" "$B/$kind.elf" 500 700 820 "$B/tank.smb" "$B/tank_i16.smb"                # in its band: never Abort
    count "$B/run_vm" "$B/$kind.elf" 600 0 0 "$B/types.smb"
    count "$B/run_vm" "$B/$kind.elf" 200 0 0 "$B/numbers.smb" "$B/many.smb"
    count "$B/run_vm" "$B/$kind.elf" 1000 0 0 "$B/functions.smb"
    count "$B/run_vm" "$B/$kind.elf" 100 0 0 "$B"/images/*.smb >"$B/$kind.txt"
    tail -1 "$B/$kind.txt"
done
# More than 64 outputs, more than 256 states, and entries of the table of functions of one, two and three bytes.
sh tests/avr/large.sh "$B" || exit 1
for large in outputs states; do "$1/smc" build -w "$B/$large.sm" -o "$B/$large.smb" || exit 1; done
vm vm_large -DVM_ROOM=8192
vm vm_large_portable -DVM_ROOM=8192 -DSMVM_PORTABLE
for kind in vm_large vm_large_portable; do
    count "$B/run_vm" "$B/$kind.elf" 2000 0 0 "$B/outputs.smb" "$B/states.smb"
    WIDE=1 count "$B/run_vm" "$B/$kind.elf" 500 0 0 "$B/outputs.smb" "$B/states.smb" "$B/tank.smb"
done
WIDE=1 count "$B/run_vm" "$B/vm_eeprom.elf" 500 0 0 "$B/outputs.smb" "$B/tank.smb"
unset AVR_MCU
# The generic firmware's runner, with all kinds of pins; and the cycles of a step of the tank with its own.
avr pins -flto -DF_CPU=16000000UL -DSMVM_CONFIG='"bytecode-vm/firmware/config.h"' -DSM_CONFIG='"bytecode-vm/firmware/config.h"' -DSM_ROLL_NONE=1 tests/avr/pins.c \
    bytecode-vm/firmware/runner.c bytecode-vm/target/io.c runtime-c/pin.c runtime-c/psl/avr/*.c ${VM#tests/avr/vm.c} || exit 1
$CC -std=gnu99 -ffp-contract=off -O1 -Wall -Wextra -I. tests/avr/sim.c tests/avr/run_pins.c "$1/libsmc.a" -o "$B/run_pins" -lsimavr -lelf -lm || exit 1
"$1/smc" build -w tests/avr/pins.sm --sv tests/avr/pins.sv --io tests/avr/pins.io -o "$B/pins.smb" || exit 1
"$1/smc" build -w examples/tank/tank.sm --sv tests/avr/tank.sv --io tests/avr/tank.io -o "$B/tank_pins.smb" || exit 1
count "$B/run_pins" "$B/pins.elf" 200 "$B/pins.smb" "$B/tank_pins.smb"
# The platform layer at each clock: time, pins that are opened for another use, and results.
$CC -std=gnu99 -O1 -Wall -Wextra -I. tests/avr/sim.c tests/avr/run_psl.c -o "$B/run_psl" -lsimavr -lelf || exit 1
for hertz in 16000000 8000000; do
    avr psl -DF_CPU=${hertz}UL tests/avr/psl.c runtime-c/psl/avr/*.c || exit 1
    count "$B/run_psl" "$B/psl.elf" $hertz
done
refuses_clock() { ! avr psl -DF_CPU=$1 tests/avr/psl.c runtime-c/psl/avr/*.c 2>"$B/clock.txt" && grep -q 'error "smc: build with -DF_CPU=16000000UL or' "$B/clock.txt"; }
count refuses_clock 20000000UL
echo "avr: $passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
