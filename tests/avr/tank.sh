#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# The emitted tank against one written by hand, on an emulated ATmega328P: whether they do the same, cycles, flash.
#   tank.sh BUILD CC FOLDER f64|i16 MOST         what pressure is, and the most hundredths of the other's cycles (run_tank.c)
# Wants gcc-avr avr-libc libsimavr-dev libelf-dev; AVR_CC names the compiler.
B=$1 CC=$2 dir=$3/tank-$4 pressure=$4 most=$5
avr=${AVR_CC:-avr-gcc}
flags="-mmcu=atmega328p -Os -std=c99 -Wall -Wextra -Wconversion -Wshadow -Werror -ffunction-sections -fdata-sections -I. -I$dir"
[ "$pressure" = f64 ] || flags="$flags -DTANK_I16"
rm -rf "$dir"
mkdir -p "$dir" || exit 1
$CC -std=gnu99 -O1 -Wall -Wextra -I. tests/avr/sim.c tests/avr/run_tank.c -o "$dir/run_tank" -lsimavr -lelf || exit 1
if [ "$pressure" = f64 ]; then cat examples/tank/tank.sm; else sed 's/^F64  /I16  /' examples/tank/tank.sm; fi >"$dir/tank.sm"
"$B/smc" build -w "$dir/tank.sm" --emit=c --soft -o "$dir/tank.c" || exit 1
for source in "$dir/tank.c" "$dir/sm_soft_avr.S" tests/avr/tank_hand.c tests/avr/tank_bench.c; do
    $avr $flags -c "$source" -o "$dir/$(basename "$source" | tr . _).o" || exit 1
done
$avr $flags -Wl,--gc-sections "$dir"/*.o -o "$dir/tank.elf" && "$dir/run_tank" "$dir/tank.elf" "$pressure" "$most" || exit 1
avr-size "$dir/tank_c.o" "$dir/tank_hand_c.o" | awk -v p="$pressure" 'NR > 1 { print p ", " (NR == 2 ? "emitted" : "by hand") ": " $1 " bytes of flash" }'
