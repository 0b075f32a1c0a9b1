#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# The table of cycles on an ATmega328P (compiler/budget/avr_cycles.def) against the counts of simavr, or measured again.
#     cycles.sh BUILD CC [check | make] [OPERANDS [SEED]]
# Wants gcc-avr avr-libc libsimavr-dev libelf-dev; AVR_CC names the compiler.
B=$1/avr CC=$2 what=${3:-check} OPERANDS=${4:-150} SEED=${5:-1}
AVR_CC=${AVR_CC:-avr-gcc}
table=compiler/budget/avr_cycles.def
if ! command -v "$AVR_CC" >/dev/null 2>&1; then
    echo "no $AVR_CC here (gcc-avr, avr-libc): 0 passed, 0 failed, 1 skipped"
    exit 0
fi
if ! echo '#include <simavr/sim_avr.h>' | $CC -fsyntax-only -x c - 2>/dev/null; then
    echo "no simavr here (libsimavr-dev, libelf-dev): 0 passed, 0 failed, 1 skipped"
    exit 0
fi
export ASAN_OPTIONS=detect_leaks=0             # libsimavr forgets what it read of the firmware
mkdir -p "$B" || exit 1
# An ATmega1284P takes as many cycles as an ATmega328P, and has room for all elementary functions.
export AVR_MCU=atmega1284p
firmware()  # NAME OPTION…
{
    name=$1
    shift
    "$AVR_CC" -mmcu=$AVR_MCU -Os -std=c99 -ffunction-sections -fdata-sections -Wl,--gc-sections -I. "$@" tests/avr/vm.c \
        bytecode-vm/load.c bytecode-vm/pins.c bytecode-vm/verify.c bytecode-vm/interp.c bytecode-vm/function.c bytecode-vm/interp_avr*.S stdlib/soft_*.c stdlib/soft_*.S -o "$B/$name.elf" || exit 1
}
firmware cycles_flash
firmware cycles_eeprom -DSMVM_FUNCTIONS=UINT32_MAX -DSMVM_CONFIG='"bytecode-vm/firmware/config.h"'
$CC -std=gnu99 -ffp-contract=off -O1 -Wall -Wextra -I. tests/avr/sim.c tests/avr/run_cycles.c "$1/libsmc.a" -o "$B/run_cycles" -lsimavr -lelf -lm || exit 1
if [ "$what" = make ]; then
    "$B/run_cycles" "$B/cycles_flash.elf" "$B/cycles_eeprom.elf" "$OPERANDS" "$SEED" >"$B/cycles.rows" || exit 1
    { sed '/^[^/]/,$d' $table && cat "$B/cycles.rows"; } >"$B/cycles.def" && mv "$B/cycles.def" $table
else
    "$B/run_cycles" "$B/cycles_flash.elf" "$B/cycles_eeprom.elf" "$OPERANDS" "$SEED" check
fi
