#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# `make emulate`, as a user runs it: the commands that it prints work, Ctrl-C ends it, and the board keeps its image.   emulated.sh MAKE BUILD CC
# Wants gcc-avr avr-libc libsimavr-dev libelf-dev.
MAKE=$1 B=$2 CC=$3
D=$B/emulated dir=$B/emulated
mkdir -p "$D" || exit 1
. tests/checks.sh
export ASAN_OPTIONS=detect_leaks=0             # libsimavr forgets what it read of the firmware
group=
trap '[ -z "$group" ] || kill -TERM -$group 2>/dev/null' EXIT

# Without its tools it names them.
names_tools() { ! sh tests/avr/emulate.sh "$MAKE" "$B" false atmega328p >"$D/none.txt" 2>&1 && grep -q 'needs libsimavr, .*: apt-get install libsimavr-dev libelf-dev' "$D/none.txt"; }
names_compiler() { ! AVR_CC=no-avr-gcc sh tests/avr/emulate.sh "$MAKE" "$B" "$CC" atmega328p >"$D/none.txt" 2>&1 && grep -q 'needs the compiler avr-gcc, .*: apt-get install gcc-avr avr-libc' "$D/none.txt"; }

# switch_on MCU: `make emulate` in a group of processes of its own, as a shell starts it; sets $port
switch_on() {
    : >"$D/said"                               # what the last board said is not what this one says
    setsid env --default-signal=INT $MAKE -s --no-print-directory emulate B="$B" CC="$CC" MCU=$1 >>"$D/said" 2>&1 &
    group=$!
    for _ in $(seq 600); do
        grep -q 'Ctrl-C switches the board off' "$D/said" && break
        sleep 0.1
    done
    port=$(sed -n 's/^An emulated .* is at \(.*\), with a tank.*/\1/p' "$D/said")
    [ -n "$port" ]
}

# Ctrl-C reaches make, the script and the board.
switch_off() {
    kill -INT -$group
    wait $group 2>/dev/null
    ! kill -0 -$group 2>/dev/null && group= && grep -q 's, [0-9]* steps, .* cycles on average' "$D/said" && ! [ -e "$B/emulate/$mcu.eeprom.line" ]
}

# Runs a line that it printed.
printed() { sh -c "$(sed -n "s/^    .*smc $1/\"\$B\"\/smc $1/p" "$D/said")" >"$D/out" 2>&1 || { cat "$D/out"; return 1; }; }
says() { grep -q "$1" "$D/out"; }

if ! command -v "${AVR_CC:-avr-gcc}" >/dev/null 2>&1 || ! echo '#include <simavr/sim_avr.h>' | $CC -fsyntax-only -x c - 2>/dev/null; then
    skip "no avr-gcc and simavr here (apt-get install gcc-avr avr-libc libsimavr-dev libelf-dev)"
    finish emulated
    exit
fi
check "without simavr it says what to install" names_tools
check "without avr-gcc it says what to install" names_compiler
export B
for mcu in atmega328p atmega2560; do
    rm -f "$B/emulate/$mcu.eeprom"
    check "$mcu: it starts" switch_on $mcu
    check "$mcu: flash" printed flash
    check "$mcu: the image runs on trial" says 'now: slot 0: .*, runs, on trial'
    check "$mcu: confirm" "$B/smc" device confirm --port="$port"
    check "$mcu: list" printed 'device list'
    check "$mcu: the image is confirmed" says 'slot 0: .*, runs, confirmed'
    check "$mcu: log" printed 'device log'
    check "$mcu: the log has the machine's start" says 'STATE of machine 0, from 0, to 1'
    sleep 3
    check "$mcu: the tank is kept in its band" sh -c "! '$B/smc' device log --port='$port' | grep 'STATE.*to 3'"
    check "$mcu: Ctrl-C ends it" switch_off
    check "$mcu: the vent has moved" grep -q 'vent opened [1-9][0-9]* times' "$D/said"
    check "$mcu: it starts again" switch_on $mcu
    check "$mcu: list again" printed 'device list'
    check "$mcu: the image is still there" says 'slot 0: .*, runs, confirmed'
    check "$mcu: Ctrl-C ends it again" switch_off
done
finish emulated
