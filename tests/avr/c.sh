#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Emitted C on an emulated ATmega328P (cc.sh), its traces held against the reference's: examples with their scripts, random programs, and
# every EVERY-th conformance case.     c.sh BUILD CC [PROGRAMS [SEED [EVERY]]]     RESUME=1: continues an interrupted run
# Wants gcc-avr avr-libc libsimavr-dev libelf-dev; AVR_CC names the compiler.
B=$1 CC=$2 PROGRAMS=${3:-12} SEED=${4:-1} EVERY=${5:-60}
if ! command -v "${AVR_CC:-avr-gcc}" >/dev/null 2>&1; then
    echo "no ${AVR_CC:-avr-gcc} here (gcc-avr, avr-libc): 0 passed, 0 failed, 1 skipped"
    exit 0
fi
if ! echo '#include <simavr/sim_avr.h>' | $CC -fsyntax-only -x c - 2>/dev/null; then
    echo "no simavr here (libsimavr-dev, libelf-dev): 0 passed, 0 failed, 1 skipped"
    exit 0
fi
passed=0 failed=0 skipped=0
export ASAN_OPTIONS=detect_leaks=0             # libsimavr forgets what it read of the firmware
mkdir -p "$B/avr" || exit 1
$CC -std=gnu99 -O1 -Wall -Wextra -I. tests/avr/sim.c tests/avr/run_c.c -o "$B/avr/run_c" -lsimavr -lelf || exit 1
root=$(pwd)
case $B in
/*) cc="$root/tests/avr/cc.sh $B/avr/run_c" ;;
*) cc="$root/tests/avr/cc.sh $root/$B/avr/run_c" ;;
esac

count() {
    if "$@" >"$B/avr/c.log" 2>&1; then passed=$((passed + 1)); else failed=$((failed + 1)); echo "failed: $1 $2 $3"; head -20 "$B/avr/c.log"; fi
}

CC=$cc count "$B/smc" test --engine=ref,c-soft examples/tank/tank.sm examples/tank/tank.ss
count "$B/diff/difftest" --seed="$SEED" --count="$PROGRAMS" --batch=4 --cc-soft="$cc" --out="$B/avr/diff-c" ${RESUME:+--resume}
grep 'no room\|difftest:' "$B/avr/c.log"

for pressure in "f64 60" "i16 65"; do
    count sh tests/avr/tank.sh "$B" "$CC" "$B/avr" $pressure
    cat "$B/avr/c.log"
done

# The sketch of docs/embedding-c.md, built as the Arduino IDE does.
core=${ARDUINO_CORE:-/usr/share/arduino/hardware/arduino/avr}
sketch() {
    dir=$B/avr/sketch
    flags="-mmcu=atmega328p -DF_CPU=16000000L -DARDUINO=10807 -Os -ffunction-sections -fdata-sections -flto -I$core/cores/arduino -I$core/variants/standard"
    rm -rf "$dir" && mkdir -p "$dir" && "$B/smc" build examples/tank/tank.sm --emit=c --soft -o "$dir/tank.c" || return 1
    { echo '#include <Arduino.h>' && sed -n '/^```c tank.tank.ino/,/^```$/{/^```/d;p;}' docs/embedding-c.md; } >"$dir/sketch.cpp"
    ${AVR_CC:-avr-gcc} $flags -std=gnu++11 -fno-exceptions -c -Wall -Wextra -Werror "$dir/sketch.cpp" -o "$dir/sketch.o" &&
        ${AVR_CC:-avr-gcc} $flags -std=gnu++11 -fno-exceptions -w -c "$core/cores/arduino/main.cpp" -o "$dir/main.o" &&
        ${AVR_CC:-avr-gcc} $flags -std=gnu11 -w "$dir"/*.[coS] "$core"/cores/arduino/wiring.c "$core"/cores/arduino/wiring_digital.c \
            "$core"/cores/arduino/wiring_analog.c "$core"/cores/arduino/hooks.c -Wl,--gc-sections -o "$dir/sketch.elf" && avr-size "$dir/sketch.elf"
}
if [ -d "$core" ]; then
    count sketch
    tail -1 "$B/avr/c.log" | awk '{ print "the sketch: " $1 + $2 " bytes of flash, " $2 + $3 " of RAM" }'
else
    echo "no Arduino core here (arduino-core-avr)"
    skipped=$((skipped + 1))
fi
count "$B/targets/cases" --cc-soft="$cc" --every="$EVERY" --out="$B/avr/cases" conformance/*/*.smt
tail -2 "$B/avr/c.log"
echo "avr-c: $passed passed, $failed failed, $skipped skipped"
[ "$failed" -eq 0 ] && [ $((passed + skipped)) -gt 0 ]
