#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# One application of the flight runtime (app/stand.app) here and on other processors: the state vector in wire form after each tick, which
# is to be the same.  Its second machine is C or runs on the VM; numbers are in software where `double` is not right.     app.sh BUILD CC
B=$1 CC=$2 here=tests/targets
dir=$B/targets/app
. tests/checks.sh
rm -rf "$dir"
mkdir -p "$dir" || exit 1
vm=$(for f in target/machine load verify interp function pins debug; do echo bytecode-vm/$f.c; done)
app=$(echo $here/app/tasks.c runtime-c/*.c $vm stdlib/*.c)
sim=$(echo runtime-c/psl/sim/*.c runtime-c/psl/none/thread.c)
warn='-Wall -Wextra -Werror'
small='/machine watch/d; /^every 100/,$d'      # of stand.app, what an Uno has room for

# made NAME EDIT OPTION…: builds the application, with its second machine changed by an edit of stand.app.
made() {
    name=$1 edit=$2
    shift 2
    mkdir "$dir/$name" && cp $here/app/*.s[mv] "$dir/$name" && sed "$edit" $here/app/stand.app >"$dir/$name/stand.app" &&
        "$B/smc" build "$dir/$name/stand.app" -Werror "$@" -o "$dir/$name/out"
}

# flies WHO APPLICATION COMPILER…: compiles it, runs it, and compares.
flies() {
    who=$1 out=$dir/$2/out
    shift 2
    "$@" $warn -I. -I"$out" "$out"/*.c -o "$dir/on-$who" && "$dir/on-$who" </dev/null >"$dir/$who.trace" && cmp "$dir/here.trace" "$dir/$who.trace"
}
flies_on() { flies "$1" "$2" sh $here/cc.sh "$1" -std=c99 -ffp-contract=off -O0 $3 $app $sim; }

# By the chip's own clock: the time that machines see is that at which a tick was due.      on_avr CHIP APPLICATION TRACE OPTION…
on_avr() {
    chip=$1 out=$dir/$2/out trace=$3
    shift 3
    $CC -std=gnu99 -O1 -I. tests/avr/sim.c tests/avr/run_c.c -o "$dir/run_c" -lsimavr -lelf &&
        "${AVR_CC:-avr-gcc}" -mmcu=$chip -DF_CPU=16000000UL -Os "$@" -std=gnu99 $warn -DSM_NO_MAIN -ffunction-sections -fdata-sections -Wl,--gc-sections \
            -I. -I"$out" -DSMVM_FUNCTIONS=0u "$out"/*.c $app $here/app/avr.c tests/avr/console.c bytecode-vm/interp_avr.S stdlib/*.S \
            $(ls runtime-c/psl/avr/*.c) $(for f in console thread socket log; do echo runtime-c/psl/none/$f.c; done) -o "$dir/$chip.elf" &&
        avr-size "$dir/$chip.elf" &&
        sh tests/avr/pack.sh "$dir/run_c" $chip "$dir/$chip.elf" "$dir/on-$chip" && "$dir/on-$chip" </dev/null >"$dir/$chip.trace" &&
        cmp "$trace" "$dir/$chip.trace"
}
runs_here() { $CC -std=c99 -ffp-contract=off $warn -I. -I"$dir/$1/out" "$dir/$1/out"/*.c $app $sim -o "$dir/on-here" && "$dir/on-here" >"$2"; }

check 'C and bytecode of it' eval "made c '' && made vm '/watch.sm/s/\$/ @bytecode/' && made vm-soft '/watch.sm/s/\$/ @bytecode/' --soft"
check 'here' runs_here c "$dir/here.trace"
check 'sixty ticks and more' test "$(wc -l <"$dir/here.trace")" -eq 61
check 'here, on the VM' flies vm vm $CC -std=c99 -ffp-contract=off $app $sim
for target in armhf s390x-fma m0-roomy rv32imac m3 m4f; do
    missing=$(sh $here/cc.sh $target present)
    case $missing-$target in
    -m3 | -m4f) check "$target" flies_on $target vm-soft -DSM_F64_SOFT=1 ;;
    -*) check "$target" flies_on $target vm ;;
    *) skip "$target: $missing" ;;
    esac
done
if has "${AVR_CC:-avr-gcc}" && echo '#include <simavr/sim_avr.h>' | $CC -fsyntax-only -x c - 2>/dev/null; then
    check 'ATmega2560, by its own clock' on_avr atmega2560 vm-soft "$dir/here.trace"
    check 'one machine of it' eval "made small '$small' && made small-soft '$small' --soft"
    check 'that, here' runs_here small "$dir/small.trace"
    check 'ATmega328P, by its own clock' on_avr atmega328p small-soft "$dir/small.trace" -flto -mrelax -mcall-prologues -Wno-maybe-uninitialized
else
    skip 'no avr-gcc or simavr here (gcc-avr avr-libc libsimavr-dev libelf-dev)'
fi
finish app
