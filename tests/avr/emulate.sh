#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# An emulated Uno or Mega with the generic firmware, for users without a board (docs/boards.md): prints its line, runs until Ctrl-C.
#   emulate.sh MAKE BUILD CC MCU          its EEPROM stays in BUILD/emulate/MCU.eeprom, as that of a board that is switched off
MAKE=$1 B=$2 CC=$3 MCU=$4
D=$B/emulate
memory=$D/$MCU.eeprom
mkdir -p "$D" || exit 1

# needs WHAT PACKAGES TEST…: ends with what to install, unless TEST succeeds
needs() {
    what=$1 packages=$2
    shift 2
    "$@" >/dev/null 2>&1 && return
    echo "make emulate needs $what; on Debian or Ubuntu: apt-get install $packages" >&2
    exit 1
}
has_simavr() { printf '#include <simavr/sim_avr.h>\n#include <libelf.h>\n' | $CC -fsyntax-only -x c -; }
needs "the compiler avr-gcc, for the firmware" "gcc-avr avr-libc" command -v "${AVR_CC:-avr-gcc}"
needs "libsimavr, which emulates the chip" "libsimavr-dev libelf-dev" has_simavr

$CC -std=gnu99 -O2 -I. tests/avr/board.c tests/avr/plants.c -o "$D/board" -lsimavr -lelf -lm || exit 1
$MAKE -s --no-print-directory firmware B="$B" MCU="$MCU" F_CPU=16000000 FIRMWARE_OUT="$D" >/dev/null || exit 1
"$B/smc" build -w examples/tank/tank.sm --sv tests/avr/tank.sv --io tests/avr/tank.io -o "$D/tank.smb" || exit 1

# stop: what Ctrl-C does.  The board prints what it has done.
stop() {
    trap '' INT TERM
    kill -TERM "$board" 2>/dev/null
    wait "$board"
    code=$?
    rm -f "$memory.line" "$memory.go"
    exit $code
}
rm -f "$memory.line"
: >"$memory.go"                                # the tank is there from the start
trap stop INT TERM
env -u F_CPU FIRMWARE="$D/$MCU.elf" MCU="$MCU" PLANT=tank SPEED=1 "$D/board" - "$memory" &
board=$!
while ! [ -s "$memory.line" ]; do
    kill -0 $board 2>/dev/null || stop
    sleep 0.1
done
port=$(cat "$memory.line")
cat <<END
An emulated $(case $MCU in atmega328p) echo Uno ;; *) echo Mega ;; esac) is at $port, with a tank of up to 820 psi at its pins A0 and 8.  In another terminal:
    $B/smc flash $D/tank.smb --port=$port
    $B/smc device list --port=$port
    $B/smc device log --port=$port
Its EEPROM is $memory.  Ctrl-C switches the board off.
END
wait "$board"
stop
