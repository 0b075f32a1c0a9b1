#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# What the parts take on a board, against budgets.txt.     sizes.sh BUILD CC MAKE
#     flash    bytes of code and constants, at -Os; of single files as their compiler leaves them, before a linker drops what a program does not call
#     ram      static bytes (on AVR constants too, which are copied there unless they are in flash)
#     stack    the deepest, by painting the RAM of the emulated chip and running programs
#     cycles   of an emulated ATmega328P
# Targets whose compiler is not here are left out and counted as skipped.
build=$1/sizes CC=$2 MAKE=$3 smc=$1/smc
here=tests/bench
export ASAN_OPTIONS=detect_leaks=0             # libsimavr forgets what it read of the firmware
rm -rf "$build"
mkdir -p "$build" || exit 1
records=$build/records
: >"$records"
skipped=0

has() { command -v "$1" >/dev/null 2>&1; }
record() { echo "$*" >>"$records"; }           # record TARGET PART MEASURE NUMBER
fail() { echo "sizes: $*: 0 passed, 1 failed"; exit 1; }

# sections OBJECT…: flash and static RAM; by `lsr`, whether read-only data is in RAM
sections()
{
    lsr=$1
    shift
    "${prefix}size" -A "$@" | awk -v lsr="$lsr" '
        /^\.(text|init|fini|vectors|progmem)/ { flash += $2 }
        /^\.rodata/ { flash += $2; ram += lsr * $2 }
        /^\.data/   { flash += $2; ram += $2 }
        /^\.(bss|noinit)/ { ram += $2 }
        END { print flash + 0, ram + 0 }'
}

# part TARGET NAME FILE…: compiles them one by one with $compile
part()
{
    target=$1 name=$2
    shift 2
    mkdir -p "$build/$target"
    objects=
    for f; do
        o=$build/$target/$(echo "$f" | tr / _).o
        [ -f "$o" ] || $compile -I. -c "$f" -o "$o" || fail "$f for $target"
        objects="$objects $o"
    done
    set -- $(sections "$in_ram" $objects)
    record "$target" "$name" flash "$1"
    record "$target" "$name" ram "$2"
}

VM_PARTS="load pins verify interp"        # and function.c, which an Uno has not
parts()     # TARGET
{
    for p in $VM_PARTS; do
        part "$1" "vm/$p" "bytecode-vm/$p.c"
    done
    part "$1" vm $(for p in $VM_PARTS; do echo "bytecode-vm/$p.c"; done)
    part "$1" vm/function bytecode-vm/function.c
    part "$1" link runtime-c/link/link.c
    part "$1" store bytecode-vm/target/store.c
    part "$1" agent bytecode-vm/target/agent.c
    part "$1" auth bytecode-vm/auth.c
}

# The runtime, and what an application with messages, and one that swaps machines, links in addition.
SWAP_PARTS="runtime-c/swap.c runtime-c/swap_log.c bytecode-vm/swap.c bytecode-vm/debug.c bytecode-vm/target/slot.c"
runtime_parts()     # TARGET
{
    part "$1" runtime $(ls runtime-c/*.c | grep -v '/swap\|/net')
    part "$1" net runtime-c/net.c runtime-c/net_message.c
    part "$1" net-tcp runtime-c/net_stream.c
    part "$1" swap $SWAP_PARTS
}

# ---- an Uno's chip ----

AVR_FLAGS="-mmcu=atmega328p -DSMVM_FUNCTIONS=0u -DF_CPU=16000000UL -Os -std=c99 -ffunction-sections -fdata-sections"
avr_program()   # NAME SOURCE-OR-OPTION…: build/NAME.elf
{
    name=$1
    shift
    avr-gcc $AVR_FLAGS -Wl,--gc-sections -I. "$@" -o "$build/$name.elf" || fail "$name for AVR"
}

# What the VM costs that runs: cycles of a step of the tank and of verifying it, the deepest stack of both.
avr_vm()
{
    $CC -std=gnu99 -ffp-contract=off -O1 -I. tests/avr/sim.c tests/avr/run_vm.c "$1/libsmc.a" -o "$build/run_vm" -lsimavr -lelf -lm || fail "run_vm"
    avr_program vm tests/avr/vm.c $(for p in $VM_PARTS function; do echo "$build/atmega328p/bytecode-vm_$p.c.o"; done) bytecode-vm/interp_avr.S stdlib/soft_arith.c stdlib/soft_convert.c stdlib/soft_avr.S
    set -- $(sections 1 "$build/vm.elf")
    record atmega328p vm+soft flash $(($1 - 1024))         # less the place of the image
    "$smc" build -w examples/tank/tank.sm -o "$build/tank.smb" || fail "tank.smb"
    "$build/run_vm" "$build/vm.elf" 500 700 820 "$build/tank.smb" >"$build/vm.txt" || fail "the tank on the VM"
    record atmega328p vm-tank cycles "$(sed -n 's/.* steps, \([0-9]*\) cycles.*/\1/p' "$build/vm.txt")"
    record atmega328p vm-tank cycles-most "$(sed -n 's/.* cycles on average, \([0-9]*\) at most.*/\1/p' "$build/vm.txt")"
    record atmega328p vm-tank stack "$(sed -n 's/^\([0-9]*\) bytes of stack/\1/p' "$build/vm.txt")"
    record atmega328p vm-tank image "$(wc -c <"$build/tank.smb")"
}

# The same in the generic firmware, with its pins, image in EEPROM, interpreter in C: a step from the ADC to the vent.
avr_pins()
{
    conf='"bytecode-vm/firmware/config.h"'
    $CC -std=gnu99 -ffp-contract=off -O1 -I. tests/avr/sim.c tests/avr/run_pins.c "$1/libsmc.a" -o "$build/run_pins" -lsimavr -lelf -lm || fail "run_pins"
    avr_program pins -flto -DSMVM_CONFIG="$conf" -DSM_CONFIG="$conf" -DSM_ROLL_NONE=1 tests/avr/pins.c bytecode-vm/firmware/runner.c bytecode-vm/target/io.c \
        runtime-c/pin.c runtime-c/psl/avr/*.c $(for p in $VM_PARTS function; do echo "bytecode-vm/$p.c"; done) bytecode-vm/interp_avr_eeprom.S stdlib/soft_arith.c stdlib/soft_convert.c stdlib/soft_avr.S
    "$smc" build -w examples/tank/tank.sm --sv tests/avr/tank.sv --io tests/avr/tank.io -o "$build/pins.smb" || fail "pins.smb"
    "$build/run_pins" "$build/pins.elf" 500 "$build/pins.smb" >"$build/pins.txt" || fail "the tank with its pins"
    record atmega328p tank-pins cycles "$(sed -n 's/.* steps, \([0-9]*\) cycles.*/\1/p' "$build/pins.txt")"
}

# The tank as C, and the whole firmware.
avr_tank()
{
    for p in f64 i16; do
        sh tests/avr/tank.sh "$1" "$CC" "$build" $p 100 >"$build/tank.txt" || fail "the tank as C"
        record atmega328p tank-c-$p flash "$(sed -n 's/.*emitted: \([0-9]*\) bytes.*/\1/p' "$build/tank.txt")"
        record atmega328p tank-c-$p cycles "$(sed -n 's/.*emitted: \([0-9]*\) cycles.*/\1/p' "$build/tank.txt")"
        record atmega328p tank-c-$p cycles-most "$(sed -n 's/.*emitted: .* \([0-9]*\) at most.*/\1/p' "$build/tank.txt")"
    done
}
# The tank with its pins as an application of the flight runtime.
avr_app()
{
    mkdir -p "$build/app" && cp examples/tank/tank.sm tests/avr/tank.io "$build/app" && cp tests/avr/tank.sv "$build/app/uno.sv" || fail "the application"
    printf '[options]\nstate_vector "uno.sv"\nio "tank.io"\ntime time 1 ms\nevents 8\n[control]\nevery 10 ms:\n inputs\n machine tank "tank.sm"\n outputs\n' >"$build/app/stand.app"
    "$smc" build -w "$build/app/stand.app" --soft -o "$build/app/out" || fail "the application"
    avr_program app -flto -mrelax -mcall-prologues -I"$build/app/out" "$build/app/out"/*.c runtime-c/*.c stdlib/*.c stdlib/*.S runtime-c/psl/avr/*.c \
        $(for f in console thread socket log; do echo runtime-c/psl/none/$f.c; done)
    set -- $(sections 1 "$build/app.elf")
    record atmega328p tank-app flash "$1"
    record atmega328p tank-app ram "$2"
}

avr_firmware()  # MCU
{
    $MAKE -s --no-print-directory firmware B="$2" MCU="$1" FIRMWARE_OUT="$build/firmware" >/dev/null || fail "the firmware"
    if has python3; then
        record "$1" firmware stack "$(python3 tests/avr/stack.py avr-objdump "$build/firmware/$1.elf" | sed -n 's/ bytes of stack$//p')"
    fi
    set -- "$1" $(sections 1 "$build/firmware/$1.elf")
    record "$1" firmware flash "$2"
    record "$1" firmware ram "$3"
}

if has avr-gcc; then
    prefix=avr- in_ram=1 compile="avr-gcc $AVR_FLAGS"
    part atmega328p soft stdlib/soft_avr.S
    part atmega328p vm/interp_avr bytecode-vm/interp_avr.S
    parts atmega328p
    if echo '#include <simavr/sim_avr.h>' | $CC -fsyntax-only -x c - 2>/dev/null; then
        avr_vm "$1"
        avr_pins "$1"
        avr_tank "$1"
    else
        skipped=$((skipped + 1))
    fi
    avr_app
    for mcu in atmega328p atmega2560; do
        avr_firmware $mcu "$1"
    done
else
    skipped=$((skipped + 2))
fi

# ---- other chips ----

arm()       # TARGET FLAGS…
{
    target=$1
    shift
    compile="arm-none-eabi-gcc -Os -std=c99 -ffp-contract=off -mthumb $*"
    parts "$target"
    runtime_parts "$target"
}
if has arm-none-eabi-gcc; then
    prefix=arm-none-eabi- in_ram=0
    arm cortex-m0 -mcpu=cortex-m0
    arm cortex-m3 -mcpu=cortex-m3
else
    skipped=$((skipped + 2))
fi
if has gcc && [ "$(gcc -dumpmachine)" = x86_64-linux-gnu ]; then
    prefix= in_ram=0 compile="gcc -Os -std=c99 -ffp-contract=off"
    parts x86-64
    runtime_parts x86-64
else
    skipped=$((skipped + 1))
fi

# ---- against docs/boards.md ----

# documented WORDS: the words are in docs/boards.md, however its lines are wrapped, and with commas in its numbers
doc_passed=0 doc_failed=0
documented()
{
    if tr -s '\n' ' ' <docs/boards.md | sed 's/\([0-9]\),\([0-9]\)/\1\2/g' | grep -qF "$1"; then
        doc_passed=$((doc_passed + 1))
    else
        doc_failed=$((doc_failed + 1))
        echo "sizes: not so in docs/boards.md: $1"
    fi
}
measured() { awk -v key="$1 firmware $2" '$1 " " $2 " " $3 == key { print $4 }' "$records"; }
limits() { sed -n "s/^BOARD(\"$1\", *\"[A-Za-z]*\", *\([0-9]*\), *\([0-9]*\), *\([0-9]*\), *\([0-9]*\),.*/\\$2/p" compiler/budget/boards.def; }

documented "| an image | $(limits atmega2560 1) bytes, two slots | $(limits atmega328p 1) bytes, one slot |"
documented "| RAM for state vector, machines and pins | $(limits atmega2560 2) bytes | $(limits atmega328p 2) bytes |"
documented "A digital pin takes $(limits atmega328p 3) bytes of this RAM, an analog pin $(limits atmega328p 4)."
if has avr-gcc && [ "$(avr-gcc -dumpversion)" = 5.4.0 ] && has python3; then
    ram=2048 for_images=1024 used=$(measured atmega328p ram) stack=$(measured atmega328p stack)
    documented "The firmware of the Uno has $(measured atmega328p flash) bytes of flash"
    documented "The firmware of the Mega has $(awk -v n="$(measured atmega2560 flash)" 'BEGIN { printf "%.1f", n / 1024 }') KB of flash"
    documented "$((used - for_images)) bytes are static in addition to those for images, and $((ram - used)) are left"
    documented "takes more than $stack bytes of stack"
    documented "its stack leaves only $((ram - used - stack)) free"
else
    skipped=$((skipped + 1))
fi

# ---- against the budgets ----

awk -v skipped=$skipped -v passed=$doc_passed -v failed=$doc_failed '
    /^#/ || NF == 0 { next }
    FNR == NR { most[$1 " " $2 " " $3] = $4; next }
    {
        key = $1 " " $2 " " $3
        if ($3 == "ram" && $4 == 0 && !(key in most))
            next
        verdict = ""
        if (key in most) {
            if ($4 + 0 > most[key] + 0 || $4 !~ /^[0-9]+$/) { failed++; verdict = "  over the budget" } else passed++
        }
        printf "%-12s %-14s %-12s %8s %8s%s\n", $1, $2, $3, $4, most[key], verdict
        seen[key] = 1
        target[$1] = 1
    }
    END {
        for (key in most) {
            split(key, word, " ")
            if (word[1] in target && !(key in seen) && !skipped) { print "nothing measured: " key; failed++ }
        }
        printf "%d passed, %d failed, %d skipped\n", passed, failed, skipped
        exit failed > 0
    }' $here/budgets.txt "$records"
