#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# The generic firmware on emulated boards, from smc flash to the pins.     firmware.sh MAKE BUILD CC [RUNS [SEED]]: RUNS updates with faults.
# Wants gcc-avr avr-libc libsimavr-dev libelf-dev, and python3 for the bound of the stack.
MAKE=$1 B=$2 CC=$3 RUNS=${4:-2} SEED=${5:-1}
D=$B/avr/firmware
smc=$B/smc
passed=0 failed=0 skipped=0 board=
mkdir -p "$D" || exit 1
if ! command -v "${AVR_CC:-avr-gcc}" >/dev/null 2>&1; then
    echo "no avr-gcc here (apt-get install gcc-avr avr-libc): 0 passed, 0 failed, 1 skipped"
    exit 0
fi
if ! echo '#include <simavr/sim_avr.h>' | $CC -fsyntax-only -x c - 2>/dev/null; then
    echo "no simavr here (apt-get install libsimavr-dev libelf-dev): 0 passed, 0 failed, 1 skipped"
    exit 0
fi
export ASAN_OPTIONS=detect_leaks=0             # libsimavr forgets what it read of the firmware
export SPEED=10
trap '[ -z "$board" ] || kill $board 2>/dev/null' EXIT

count() {
    if "$@"; then passed=$((passed + 1)); else failed=$((failed + 1)); echo "failed on $MCU: $*"; fi
}

build() {
    name=$1
    shift
    "$smc" build -w "$@" -o "$D/$name.smb" || exit 1
}

# board_on MEMORY: starts it, with the line $port
board_on() {
    memory=$1
    rm -f "$memory.line" "$memory.go"
    "$D/board" - "$memory" >"$memory.said" 2>&1 &
    board=$!
    while ! [ -s "$memory.line" ]; do sleep 0.05; done
    port=--port=$(cat "$memory.line")
}

board_off() {
    kill "$board" && wait "$board"
    code=$?
    board=
    cat "$memory.said"
    return $code
}

says() { "$@" 2>&1 | grep -q "$text"; }
says_not() { said=$("$@" 2>&1) && ! echo "$said" | grep -q "$text"; }

# logged TEXT SECONDS: TEXT appears in the board's log within SECONDS
logged() {
    tries=$(($2 * 4))
    while ! "$smc" device log "$port" 2>&1 | grep -q "$1"; do
        tries=$((tries - 1))
        [ $tries -gt 0 ] || return 1
        sleep 0.25
    done
}

# The chip has room for the most stack that a firmware can need; sets $stack to that.
has_room_for_stack() {
    ram=$(case $MCU in atmega328p) echo 2048 ;; *) echo 8192 ;; esac)
    stack=$(python3 tests/avr/stack.py avr-objdump "$1" | sed -n 's/ bytes of stack$//p')
    static=$(avr-size -A "$1" | awk '$1 == ".data" || $1 == ".bss" || $1 == ".noinit" { n += $2 } END { print n }')
    echo "$1: at most ${stack:=0} of $((ram - static)) bytes of stack"
    [ "$stack" -gt 0 ] && [ "$stack" -le $((ram - static)) ]
}

bound_stack() {     # ELF
    if command -v python3 >/dev/null 2>&1; then
        count has_room_for_stack "$1"
    else
        stack=9999 skipped=$((skipped + 1))
    fi
}

# What was seen of the stack in a flight is no more than what there can be.
stack_was_bounded() { awk -v most="$stack" '/ bytes of stack, / { for (i = 4; i <= NF; i++) if ($(i) == "stack,") seen = $(i - 3) } END { exit !(seen > 100 && seen <= most) }' "$1"; }

# An Uno has one slot: nothing runs while it receives an image, so the machine must be in a @safe state, as with the vent open.
rest_on_uno() {
    [ $MCU = atmega328p ] || return 0
    rm "$D/$1.mem.go"
    sleep 0.5
}

# A tank that is filled all the time: the machine comes over the line, its vent keeps the pressure in its band; then another one.
fly_tank() {
    export PLANT=tank
    rm -f "$D/tank.mem"*
    board_on "$D/tank.mem"
    count "$smc" flash "$D/tank.smb" "$port" --confirm --period=5 >"$D/tank.out" 2>&1
    touch "$D/tank.mem.go"
    sleep 4
    count logged "STATE of machine 0, from 0, to 1" 5
    touch "$D/tank.mem.armed"
    text='the board is armed; disarm it first'
    count says "$smc" flash "$D/recovery.smb" "$port"
    rm "$D/tank.mem.armed"
    text='needs more than [0-9]* bytes of RAM, the board has .*; nothing was sent'
    count says "$smc" flash "$D/large.smb" "$port"
    rest_on_uno tank
    count "$smc" flash "$D/vent.smb" "$port" --period=5 >"$D/tank.out" 2>&1
    touch "$D/tank.mem.go"
    sleep 1
    count board_off
    count awk '/steps/ { seen = $3 > 120 * $1 && $9 < 50000 } END { exit !seen }' "$D/tank.mem.said"
    count awk '/^tank:/ { seen = $4 >= 699 && $6 > 770 && $6 <= 800 && $10 > 2 } END { exit !seen }' "$D/tank.mem.said"
}

# A flight from the pad to the main, after one power failure since the machine was flashed.
fly_rocket() {
    export PLANT=rocket
    rm -f "$D/rocket.mem"*
    board_on "$D/rocket.mem"
    count "$smc" flash "$D/recovery.smb" "$port" --confirm >"$D/rocket.out" 2>&1
    kill -9 "$board"
    board_on "$D/rocket.mem"
    count logged "to 1" 5
    touch "$D/rocket.mem.go"
    count logged "from 3, to 4" 20
    count board_off
    count awk '/^rocket:/ { seen = $7 > $3 - 15 && $14 > 80 && $14 < 101 } END { exit !seen }' "$D/rocket.mem.said"
}

# With one slot, an update without a permit of the key does not stop the machine.  (The permit ends 24 bytes before the image does.)
keeps_its_machine() {
    [ $MCU = atmega328p ] || return 0
    cp "$D/signed.smb" "$D/stops.smb" && "$B/device/link" forge "$D/stops.smb" 25 || exit 1
    text='the update was not begun: the board accepts only images that are signed with its key'
    count says "$smc" flash "$D/stops.smb" "$port"
    text='slot 0: .*, runs, confirmed'
    count says "$smc" device list "$port"
}

# A board with a key accepts an image signed with it, once.
fly_signed() {
    rm -f "$D/signed.mem"* "$D/rocket.key" "$D/other.key"
    "$smc" key "$D/rocket.key" && "$smc" sign "$D/tank.smb" --key="$D/rocket.key" --number=7 -o "$D/signed.smb" || exit 1
    $MAKE -s --no-print-directory firmware B="$B" MCU=$MCU KEY="$D/rocket.key" FIRMWARE_OUT="$D/keyed" || exit 1
    bound_stack "$D/keyed/$MCU.elf"
    FIRMWARE=$D/keyed/$MCU.elf board_on "$D/signed.mem"
    touch "$D/signed.mem.go"
    text='the board accepts signed images only'
    count says "$smc" flash "$D/tank.smb" "$port"
    count "$smc" flash "$D/signed.smb" "$port" --confirm >"$D/signed.out" 2>&1
    count grep -q 'runs, confirmed' "$D/signed.out"
    text='takes signed images only, with key [0-9a-f]*, with numbers above 7'
    count says "$smc" device info "$port"
    "$smc" sign "$D/recovery.smb" --key="$D/rocket.key" --number=7 -o "$D/signed.smb" || exit 1
    text='has number 7, but the board has confirmed number 7'
    count says "$smc" flash "$D/signed.smb" "$port"
    "$smc" key "$D/other.key" && "$smc" sign "$D/signed.smb" --key="$D/other.key" --number=8 || exit 1
    text='is signed with key [0-9a-f]*, but the board accepts only images signed with key [0-9a-f]*: .*nothing was sent'
    count says "$smc" flash "$D/signed.smb" "$port"
    "$smc" sign "$D/signed.smb" --key="$D/rocket.key" --number=8 && "$B/device/link" forge "$D/signed.smb" || exit 1
    rest_on_uno signed
    keeps_its_machine
    text='the image was not accepted: the board accepts only images that are signed with its key'
    for i in 1 2; do                           # and is no more chosen for having come before
        count says "$smc" flash "$D/signed.smb" "$port"
    done
    text='slot .: [0-9]* bytes.*, chosen, but'
    count says_not "$smc" device list "$port"
    count board_off >"$D/signed.said" 2>&1
}

# A Pro Mini of 3.3 V and 8 MHz: a period is as long as on an Uno, and a voltage is measured as what it is.
fly_slow() {
    [ $MCU = atmega328p ] || return 0
    export PLANT=tank F_CPU=8000000
    rm -f "$D/slow.mem"*
    $MAKE -s --no-print-directory firmware B="$B" MCU=$MCU FIRMWARE_OUT="$D/slow" || exit 1
    FIRMWARE=$D/slow/$MCU.elf board_on "$D/slow.mem"
    text=', a step every 10 ms, of up to 7200 cycles in each of them'
    count says "$smc" device info "$port" --speed=57600
    count "$smc" flash "$D/tank.smb" "$port" --speed=57600 --confirm --period=5 >"$D/slow.out" 2>&1
    touch "$D/slow.mem.go"
    sleep 4
    count board_off
    count awk '/steps/ { seen = $3 > 150 * $1 && $3 < 201 * $1 } END { exit !seen }' "$D/slow.mem.said"
    count awk '/^tank:/ { seen = $4 >= 699 && $6 > 770 && $6 <= 800 && $10 > 2 } END { exit !seen }' "$D/slow.mem.said"
    unset F_CPU
}

# A Mega stores transitions in EEPROM, where they survive a power failure.  No step waits for that: a byte of EEPROM takes 54,400 cycles.
fly_logged() {
    [ $MCU = atmega2560 ] || return 0
    many_stored='/^stored/ { stored = 1 } /^since/ { stored = 0 } stored && / s  STATE of machine 0, from [123], to [123]$/ { n++ } END { exit n < 60 }'
    rm -f "$D/logged.mem"*
    board_on "$D/logged.mem"
    count "$smc" flash "$D/toggle.smb" "$port" --period=5 --confirm >"$D/logged.out" 2>&1
    touch "$D/logged.mem.go"
    tries=60                                        # however slow the emulator is
    while [ $tries -gt 0 ] && ! "$smc" device log "$port" 2>&1 | awk "$many_stored"; do
        tries=$((tries - 1))
        sleep 0.5
    done
    kill -9 "$board"
    board_on "$D/logged.mem"
    touch "$D/logged.mem.go"
    "$smc" device log "$port" >"$D/logged.out" 2>&1
    text='^stored by image [0-9a-f]*, from earlier starts too:$'
    count says cat "$D/logged.out"
    count awk "$many_stored" "$D/logged.out"
    sleep 2
    count board_off
    count awk '/steps/ { seen = $3 > 50 && $9 > 0 && $9 < 20000 } / EEPROM written/ { for (i = 2; i < NF; i++) if ($(i) == "bytes" && $(i + 2) == "EEPROM") wrote = $(i - 1) } END { exit !(seen && wrote > 100) }' "$D/logged.mem.said"
}

# padded NAME WAIT LEAST MOST: the machine toggle, which waits so long in a state, and so many other states that its image has LEAST to MOST bytes.
padded() {
    sed "s/^U32 state.*/&\nU32 pad/; s/>= 20/>= $2/" "$D/toggle.sm" >"$D/$1.sm"
    size=0 states=0
    while [ "$size" -lt "$3" ] && [ $states -lt 400 ]; do
        states=$((states + 1))
        printf '[P%d] @safe .step\n    pad = %d\n' $states $((states + 70000)) >>"$D/$1.sm"
        [ $((states % 8)) = 0 ] || [ "$size" -gt $(($3 - 200)) ] || continue
        build "$1" "$D/$1.sm"
        size=$(wc -c <"$D/$1.smb")
    done
    if [ "$size" -gt "$4" ]; then echo "$1.smb has $size bytes, more than $4"; exit 1; fi
}

# The checksum of an image that has been flashed.
checksum_of() { sed -n 's/^now: .*, checksum \([0-9a-f]*\),.*/\1/p' "$D/$1.out"; }

# stored_of CHECKSUM FILE: the transitions that this image has stored, in the output of smc device log
stored_of() { awk -v image="$1," '/^stored/ { stored = $4 == image } /^since/ { stored = 0 } stored && / STATE of machine 0, /' "$2"; }

# The stored log has become full, and its oldest transition is another one than before.
overwrites_its_oldest() {
    oldest=
    for i in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29 30; do
        "$smc" device log "$port" >"$D/filled.out" 2>&1
        stored_of "$(checksum_of other)" "$D/filled.out" >"$D/filled.stored"
        lines=$(wc -l <"$D/filled.stored")
        [ "$lines" -le 14 ] || return 1
        if [ "$lines" -ge 8 ]; then
            first=$(head -n 1 "$D/filled.stored")
            [ -z "$oldest" ] || [ "$first" = "$oldest" ] || return 0
            oldest=$first
        fi
        sleep 0.5
    done
    return 1
}

# The log uses what its image leaves free of its slot, and no byte of the other slot.  An image that needs a whole slot gets it, though there
# was a log, and then stores none.
fly_filled() {
    [ $MCU = atmega2560 ] || return 0
    slot=2016 record=12
    padded near 20 $((slot - 14 * record)) $((slot - 8 * record))
    padded other 21 $((slot - 14 * record)) $((slot - 8 * record))
    padded full 20 $((slot - 8 * record + 1)) $slot
    rm -f "$D/filled.mem"*
    board_on "$D/filled.mem"
    text="2 slots of $slot bytes"
    count says "$smc" device info "$port"
    touch "$D/filled.mem.go"
    for image in full near other; do
        count "$smc" flash "$D/$image.smb" "$port" --period=5 --confirm >"$D/$image.out" 2>&1
    done
    count overwrites_its_oldest
    kill -9 "$board"
    board_on "$D/filled.mem"
    touch "$D/filled.mem.go"
    text="slot 1: .*, checksum $(checksum_of near), .* runs again if the chosen one does not"
    count says "$smc" device list "$port"
    count "$smc" flash "$D/full.smb" "$port" --period=5 --confirm >"$D/full.out" 2>&1
    sleep 1
    text="stored by image $(checksum_of full)"
    count says_not "$smc" device log "$port"
    kill -9 "$board"
    board_on "$D/filled.mem"
    touch "$D/filled.mem.go"
    text="slot 1: .*, checksum $(checksum_of full), .* runs, every 5 ms, confirmed"
    count says "$smc" device list "$port"
    text="slot 0: .*, checksum $(checksum_of other), .* runs again if the chosen one does not"
    count says "$smc" device list "$port"
    count board_off
}

# As much stack as can be had: averages in the steps, and images verified beside them.
fly_deep() {
    rm -f "$D/deep.mem"*
    board_on "$D/deep.mem"
    touch "$D/deep.mem.go"
    count "$smc" flash "$D/deep.smb" "$port" --period=3 --confirm >"$D/deep.out" 2>&1
    for i in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20; do
        "$smc" device list "$port" >"$D/deep.out" 2>&1
    done
    count grep -q ', runs, every 3 ms, confirmed' "$D/deep.out"
    count board_off
    count stack_was_bounded "$D/deep.mem.said"
}

# An image that uses a pin twice is not sent, nor one that uses the arming plug's.  An image sent by another firmware that uses it does not run
# here, and is not reported as running.
fly_wrong_pins() {
    rm -f "$D/pins.mem"*
    $MAKE -s --no-print-directory firmware B="$B" MCU=$MCU FIRMWARE_OUT="$D/free" || exit 1
    FIRMWARE=$D/free/$MCU.elf board_on "$D/pins.mem"
    touch "$D/pins.mem.go"
    text='uses digital output 9 and analog output 9, which are one pin of this board; nothing was sent'
    count says "$smc" flash "$D/twice.smb" "$port"
    text='runs, confirmed'
    count says "$smc" flash "$D/plug.smb" "$port" --confirm
    count board_off >"$D/pins.said" 2>&1
    board_on "$D/pins.mem"
    touch "$D/pins.mem.go"
    text='slot 0: .*, chosen, but does not run before the next start, confirmed'
    count says "$smc" device list "$port"
    text='built in: .*, runs'
    count says "$smc" device list "$port"
    text='there is nothing to confirm'
    count says "$smc" device confirm "$port"
    text='uses digital output 7, which this board does not have or uses itself'
    count says "$smc" flash "$D/plug.smb" "$port"
    count board_off >"$D/pins.said" 2>&1
    fly_back
}

# On trial its trial is over at once, and with two slots the image before it runs.
fly_back() {
    rm -f "$D/pins.mem"*
    FIRMWARE=$D/free/$MCU.elf board_on "$D/pins.mem"
    count "$smc" flash "$D/deep.smb" "$port" --confirm --period=5 >"$D/pins.out" 2>&1
    text='on trial'
    count says "$smc" flash "$D/plug.smb" "$port"
    count board_off >"$D/pins.said" 2>&1
    board_on "$D/pins.mem"
    text=$(test $MCU = atmega328p && echo 'built in: .*, runs' || echo 'slot 0: .*, runs, every 5 ms, confirmed')
    count says "$smc" device list "$port"
    count board_off >"$D/pins.said" 2>&1
}

$CC -std=gnu99 -O1 -Wall -Wextra -I. tests/avr/board.c tests/avr/plants.c -o "$D/board" -lsimavr -lelf -lm || exit 1
sed '/-> Idle/d' examples/tank/tank.sm >"$D/tank.sm"      # or it idles, vent open, after as much of its time as a slow computer may take
build tank "$D/tank.sm" --sv tests/avr/tank.sv --io tests/avr/tank.io
build recovery examples/recovery/recovery.sm --sv examples/recovery/recovery.sv --io examples/recovery/recovery.io
sed 's/tankPressure > 775/roll_median(tankPressure, 700) > 775/' "$D/tank.sm" >"$D/large.sm"
build large "$D/large.sm"
sed 's/tankPressure > 775/tankPressure > 770/' "$D/tank.sm" >"$D/vent.sm"
build vent "$D/vent.sm" --sv tests/avr/tank.sv --io tests/avr/tank.io
sed 's/o 8/o 9/; s/^\[digital\]/o 9 state\n&/' tests/avr/tank.io >"$D/twice.io"
build twice "$D/tank.sm" --sv tests/avr/tank.sv --io "$D/twice.io"
sed 's/o 8/o 7/' tests/avr/tank.io >"$D/plug.io"
printf '[state_vector]\nU64 time @alias G\nU32 state @alias S\nF64 tankPressure\nbool valveOpen\n[Deep] .step\n    valveOpen = roll_avg(tankPressure, 40) > 3\n' >"$D/deep.sm"
build deep "$D/deep.sm" --sv tests/avr/tank.sv --io tests/avr/tank.io
printf '[state_vector]\nU64 time @alias G\nU32 state @alias S\n[A] @safe .step\n    T >= 20: -> B\n[B] @safe .step\n    T >= 20: -> C\n[C] @safe .step\n    T >= 20: -> A\n' >"$D/toggle.sm"
build toggle "$D/toggle.sm"
build limits tests/device/limits.sm --sv tests/avr/tank.sv --io tests/avr/tank.io
build plug "$D/tank.sm" --sv tests/avr/tank.sv --io "$D/plug.io"
for MCU in ${BOARDS:-atmega2560 atmega328p}; do
    export MCU FIRMWARE=$D/$MCU.elf
    $MAKE -s --no-print-directory firmware B="$B" MCU=$MCU ARM_PIN=7 FIRMWARE_OUT="$D" || exit 1
    bound_stack "$FIRMWARE"
    if [ $MCU = atmega328p ]; then
        SLOTS=1 count "$B/device/link" "$smc" "$D/board" "$D" "$D/tank.smb" "$D/vent.smb" "$D/limits.smb" "$RUNS" "$SEED"
    else
        NO_KEY=1 count "$B/device/link" "$smc" "$D/board" "$D" "$B/store/old.smb" "$B/store/new.smb" "$B/device/limits.smb" "$RUNS" "$SEED"
    fi
    fly_tank
    fly_rocket
    fly_deep
    fly_signed
    fly_wrong_pins
    fly_slow
    fly_logged
    fly_filled
done
echo "firmware: $passed passed, $failed failed, $skipped skipped"
[ "$failed" -eq 0 ] && [ $((passed + skipped)) -gt 0 ]
