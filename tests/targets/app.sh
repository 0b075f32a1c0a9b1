#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# One application of the flight runtime (app/stand.app) here and on other processors: the state vector in wire form after each tick, which
# is to be the same.  Its second machine is C or runs on the VM; numbers are in software where `double` is not right.     app.sh BUILD CC
B=$1 CC=$2 here=tests/targets
dir=$B/targets/app
. tests/checks.sh
rm -rf "$dir"
mkdir -p "$dir" || exit 1
vm=$(for f in target/machine load verify interp pins debug; do echo bytecode-vm/$f.c; done)
app=$(echo $here/app/tasks.c runtime-c/*.c $vm stdlib/*.c)
sim=$(echo runtime-c/psl/sim/*.c runtime-c/psl/none/thread.c)
warn='-Wall -Wextra -Werror'

# made NAME EDIT OPTION…: builds the application, its second machine as the edit of stand.app says.
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

# By the chip's own clock: the time that machines see is that at which a tick was due.
on_avr() {
    $CC -std=gnu99 -O1 -I. tests/avr/sim.c tests/avr/run_c.c -o "$dir/run_c" -lsimavr -lelf &&
        "${AVR_CC:-avr-gcc}" -mmcu=atmega2560 -DF_CPU=16000000UL -Os -std=gnu99 $warn -DSM_NO_MAIN -ffunction-sections -fdata-sections -Wl,--gc-sections \
            -I. -I"$dir/vm-soft/out" "$dir/vm-soft/out"/*.c $app $here/app/avr.c tests/avr/console.c bytecode-vm/interp_avr.S stdlib/*.S \
            $(ls runtime-c/psl/avr/*.c) $(for f in console thread socket log; do echo runtime-c/psl/none/$f.c; done) -o "$dir/avr.elf" &&
        sh tests/avr/pack.sh "$dir/run_c" atmega2560 "$dir/avr.elf" "$dir/on-avr" && "$dir/on-avr" </dev/null >"$dir/avr.trace" &&
        cmp "$dir/here.trace" "$dir/avr.trace"
}

check 'C and bytecode of it' eval "made c '' && made vm '/watch.sm/s/\$/ @bytecode/' && made vm-soft '/watch.sm/s/\$/ @bytecode/' --soft"
check 'here' eval "$CC -std=c99 -ffp-contract=off $warn -I. -I$dir/c/out $dir/c/out/*.c $app $sim -o $dir/on-here && $dir/on-here >$dir/here.trace"
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
    check 'ATmega2560, by its own clock' on_avr
else
    skip 'no avr-gcc or simavr here (gcc-avr avr-libc libsimavr-dev libelf-dev)'
fi
finish app
