#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Builds applications and runs them in simulated time: as C and on the VM, in place and guarded.  And wrong, missing or large parts:
# a message at its place, the exit code that is promised, and nothing half written.        sh tests/app/run.sh SMC SIM.a CC DESK.a
smc=$1 sim=$2 cc=$3 desk=$4
passed=0 failed=0 skipped=0
root=$(pwd)
here=$root/tests/app
dir=$(mktemp -d "${TMPDIR:-/tmp}/smc-app.XXXXXX") || exit 1
trap 'rm -rf "$dir"' EXIT
case $smc in /*) ;; *) smc=$root/$smc ;; esac
case $sim in /*) ;; *) sim=$root/$sim ;; esac
case $desk in /*) ;; *) desk=$root/$desk ;; esac
warn="-Wall -Wextra -Wconversion -Wshadow -Wstrict-prototypes -Wmissing-prototypes -pedantic -Werror"

good() { passed=$((passed + 1)); }
bad() { failed=$((failed + 1)); echo "app: $1"; }

# fresh NAME: an empty folder with the test's application, and goes there.
fresh()
{
    mkdir "$dir/$1" && cd "$dir/$1" || exit 1
    cp "$here/probe.app" "$here/probe.sv" "$here/rise.sm" .
}

# flies NAME: builds the application of this folder, runs it, and compares.
flies()
{
    mkdir out
    if "$smc" build probe.app -Werror -o out 2>log && $cc -std=c99 $warn -I"$root" -Iout -c out/probe_app.c -o out/probe_app.o 2>>log &&
       $cc -std=c99 -O1 $warn -I"$root" -Iout -o run out/*.c "$here/tasks.c" "$sim" 2>>log && ./run >trace 2>>log &&
       diff "$here/expected.txt" trace >>log; then
        good
    else
        bad "$1"
        head -20 log
    fi
}

fresh plain;    flies "machines as C"
fresh bytecode; sed -i.old 's/"rise.sm"/& @bytecode/' probe.app; flies "machines on the VM"
fresh guarded;  printf '[options]\nlock\n' | cat - probe.sv >new && mv new probe.sv; flies "a guarded vector"
fresh both;     printf '[options]\nlock\n' | cat - probe.sv >new && mv new probe.sv
sed -i.old 's/"rise.sm"/& @bytecode/' probe.app; flies "a guarded vector, on the VM"

# swaps NAME: builds and runs the application of this folder that swaps a machine, and compares.
swaps()
{
    mkdir out
    if "$smc" build bench.app -Werror -o out 2>log && "$smc" build -w -g faster.sm --sv bench.sv -o faster.smb 2>>log &&
       { echo 'static const unsigned char image[] = {'; od -An -v -tx1 faster.smb | sed 's/ *\([0-9a-f][0-9a-f]\)/0x\1, /g'; echo '};'; } >out/image.h &&
       $cc -std=c99 -O1 $warn -I"$root" -Iout -o run out/*.c tasks.c "$sim" 2>>log && ./run >trace 2>>log && diff expected.txt trace >>log; then
        good
    else
        bad "$1"
        head -20 log
    fi
}

for vector in plain guarded; do
    mkdir "$dir/swap-$vector" && cd "$dir/swap-$vector" && cp "$here"/swap/* . || exit 1
    if [ $vector = guarded ]; then printf '[options]\nlock\n' | cat - bench.sv >new && mv new bench.sv; fi
    swaps "a swap of a machine, $vector"
    # The log has the names of both images, and why a swap was refused.
    if $cc -std=c99 -O1 $warn -I"$root" -Iout -o run_desk out/*.c tasks.c "$desk" -pthread 2>log && rm -f bench.log && ./run_desk >trace && diff expected.txt trace >>log &&
       "$smc" log bench.log | sed -n '/^  events/,/^$/p' | sed 's/[0-9a-f]\{8\}/IMAGE/g' | diff events.txt - >>log && "$smc" log bench.log --format=svg n | grep -q Before; then
        good
    else
        bad "the log of swaps, $vector"
        head -20 log
    fi
done

# With swap_store, the machine of the confirmed swap runs after a restart.
mkdir "$dir/swap-stored" && cd "$dir/swap-stored" && cp "$here"/swap/* . || exit 1
sed -i.old 's/^armed .*/swap_store "bench.images"\n&/' bench.app
swaps_stored()
{
    mkdir out
    "$smc" build bench.app -Werror -o out 2>log && cp "$dir/swap-plain/out/image.h" out/ &&
        $cc -std=c99 -O1 $warn -I"$root" -Iout -o run_desk out/*.c tasks.c "$desk" -pthread 2>>log && ./run_desk >trace 2>>log && diff expected.txt trace >>log &&
        ./run_desk >again 2>>log && "$smc" log bench.log >>log && grep -q 'count started with the stored image' log && grep -q 'count: starts in Before' log
}
if swaps_stored; then
    good
else
    bad "a machine that is stored"
    head -20 log
fi

# Several machines of one file: as C and on the VM, in place and guarded.  clause 10.30 clause 10.32
binds()
{
    mkdir out
    if "$smc" build channels.app -Werror -o out 2>log && $cc -std=c99 -O1 $warn -I"$root" -Iout -o run out/*.c tasks.c "$sim" 2>>log &&
       ./run >trace 2>>log && diff "$here/channels/expected.txt" trace >>log; then
        good
    else
        bad "$1"
        head -20 log
    fi
}

channels() { mkdir "$dir/$1" && cd "$dir/$1" && cp "$here"/channels/* . || exit 1; }
channels bound;          binds "machines of one file"
if test -f out/drogue.c && test -f out/spare.c && test -f out/channel.c; then good; else bad "a file of C for each machine"; fi
channels bound-bytecode; sed -i.old 's/"channel.sm"/& @bytecode/' channels.app; binds "machines of one file on the VM"
channels bound-guarded;  printf '[options]\nlock\n' | cat - channels.sv >new && mv new channels.sv; binds "machines of one file, guarded"
channels bound-both;     printf '[options]\nlock\n' | cat - channels.sv >new && mv new channels.sv
sed -i.old 's/"channel.sm" {/"channel.sm" @bytecode {/' channels.app; binds "machines of one file, guarded, some on the VM"

# --bind compiles one of them alone: the C differs only in the names that begin with that of the machine.
cd "$dir/bound" || exit 1
if "$smc" build channel.sm --sv channels.sv --bind fire=fireDrogue,go=apogee --bind 'state = drogueState' --emit=c --runtime --prefix=drogue -o alone.c &&
   sed 's/alone/drogue/g; s/state machine channel/state machine drogue/' alone.c | diff out/drogue.c - >log; then good; else bad "--bind"; head -5 log; fi
for bad in 'fire=nosuch:1:E0204' 'fire=time:1:E1221' 'nosuch=fire:1:E1222' 'fire fireDrogue:1:E1020' 'fire=apogee,S=:1:E0312'; do
    bindings=${bad%%:*} code=${bad#*:}
    "$smc" check channel.sm --sv channels.sv --bind "$bindings" 2>log
    if test $? = "${code%:*}" && grep -q "^--bind:1:.*\[${code#*:}\]" log; then good; else bad "--bind $bindings"; head -5 log; fi
done
"$smc" check channel.sm --bind fire=fireDrogue 2>log
if test $? = 2 && grep -q -- '--bind requires --sv' log; then good; else bad "--bind without --sv"; cat log; fi
"$smc" check channels.app --bind fire=fireDrogue 2>log
if test $? = 2 && grep -q -- '--bind is for one machine' log; then good; else bad "--bind of an application"; cat log; fi
printf '[options]\ndelta_t 10\n[Idle]\nT == 0 {\narmed = true\ngo = true\n}\n[Fire]\nT == 10: @assert fire\n[Done]\ntrue: @stop\n' >alone.ss
if "$smc" test channel.sm alone.ss --sv channels.sv --bind fire=fireDrogue,S=drogueState >trace 2>log && grep -q '1 assert passed' trace; then good; else bad "--bind of a test"; cat log trace; fi

if "$smc" report channel.sm --sv channels.sv --bind fire=fireDrogue,S=drogueState --format=text 2>log >report && grep -q 'state (S) = drogueState' report && grep -q 'fire = fireDrogue' report
then good; else bad "--bind of a report"; cat log; fi
if "$smc" graph channel.sm --sv channels.sv --bind fire=fireDrogue,S=drogueState -o graph.svg 2>log && grep -q Fire graph.svg; then good; else bad "--bind of a graph"; cat log; fi

# Other compilers take the sources without a word, C++ the header.
for other in gcc clang clang-19; do
    if command -v $other >/dev/null 2>&1; then
        if $other -std=c99 $warn -I"$root" -I"$dir/both/out" -fsyntax-only "$dir/both/out/probe_app.c" "$dir/plain/out/probe_app.c" &&
           $other -std=c99 $warn -I"$root" -I"$dir/swap-guarded/out" -fsyntax-only "$dir/swap-guarded/out/bench_app.c" 2>"$dir/log"; then
            good
        else
            bad "$other"
            head -20 "$dir/log"
        fi
    fi
done
if command -v g++ >/dev/null 2>&1; then
    echo '#include "probe_app.h"' >"$dir/header.cpp"
    if g++ -std=c++11 -Wall -Wextra -Wconversion -Wshadow -pedantic -Werror -I"$root" -I"$dir/plain/out" -fsyntax-only "$dir/header.cpp" 2>"$dir/log"; then
        good
    else
        bad "the header as C++"
        head -20 "$dir/log"
    fi
else
    skipped=$((skipped + 1))
fi

# ---- the output ----

# refuses NAME CODE TEXT [OPTION…]: the build ends with CODE, prints TEXT, writes nothing.
refuses()
{
    name=$1 expected=$2 text=$3
    shift 3
    rm -rf out && mkdir out
    "$smc" build probe.app -o out "$@" >log 2>&1
    code=$?
    if test $code = "$expected" && grep -q -- "$text" log && test -z "$(ls out)"; then
        good
    else
        bad "$name: exit $code, where $expected was expected, and '$text'"
        head -5 log
    fi
}

# A second build produces the same bytes, from any current folder.
fresh again; mkdir out other
"$smc" build probe.app -o out && cd / && "$smc" build "$dir/again/probe.app" -o "$dir/again/other"
if diff -r "$dir/again/out" "$dir/again/other"; then good; else bad "the same bytes from elsewhere"; fi

cd "$dir/again" && "$smc" build probe.app -o out -MD -MF deps -MP
for f in probe.app probe.sv rise.sm; do
    if grep -q "^out.*probe_app.c.*:.* $f" deps && grep -q "^$f:\$" deps; then good; else bad "-MD names $f"; cat deps; fi
done
if head -1 deps | grep -q 'out/probe_app.c out/probe_app.h out/probe.c out/probe.h out/rise.c out/rise.h:'; then good; else bad "-MD's targets"; cat deps; fi

fresh missing;    rm rise.sm;            refuses "a missing machine" 1 "probe.app:19:18: error: cannot read 'rise.sm': .*E1031"
fresh nosv;       rm probe.sv;           refuses "a missing state vector" 1 "probe.app:3:14: error: cannot read 'probe.sv': .*E1031"
fresh folder;     rm rise.sm; mkdir rise.sm; refuses "a folder" 1 "cannot read 'rise.sm': .*E1031"
fresh wrong;      echo '    nosuch = 1' >>rise.sm; refuses "a mistake in a machine" 1 "rise.sm:14:5: error: unknown element 'nosuch'"
fresh wrongsv;    echo 'F64' >>probe.sv; refuses "a mistake in the state vector" 1 "probe.sv:.*error"
fresh werror;     sed -i.old 's/^    log$//' probe.app; rm -rf out; mkdir out
if ! "$smc" build probe.app -o out -Werror 2>log && grep -q W1040 log && test -z "$(ls out)"; then good; else bad "-Werror"; fi
if "$smc" build probe.app -o out -Wno-option-without-task 2>log && ! test -s log; then good; else bad "-Wno-option-without-task"; cat log; fi
fresh binary;     head -c 3000 "$smc" >probe.app; refuses "a program in place of an application" 1 "E0104"
fresh empty;      : >probe.app;          refuses "an empty application" 1 "probe.app:1:1: error: an application needs a state vector.*E1030"
fresh absent;     rm probe.app;          refuses "no application" 3 "cannot read 'probe.app'"
fresh nodir
"$smc" build probe.app -o nosuch/folder 2>log
if test $? = 3 && grep -q "cannot create the folder 'nosuch/folder'" log; then good; else bad "a folder in one that is not there"; cat log; fi
"$smc" build probe.app -o new 2>log
if test $? = 0 && test -f new/probe_app.c; then good; else bad "a folder that is not there"; cat log; fi
"$smc" build probe.app -o probe.sv 2>log
if test $? = 2 && grep -q "'probe.sv' is the name of a source" log; then good; else bad "a source in place of the folder"; cat log; fi
: >taken
"$smc" build probe.app -o taken 2>log
if test $? = 3 && grep -q "cannot create the folder 'taken'" log; then good; else bad "a file in place of the folder"; cat log; fi

# Handwritten C is not replaced, and then nothing else is written.  Files made by smc and empty files are replaced.
fresh mine; mkdir out; echo 'int rise;' >out/rise.c; cp out/rise.c rise.c
"$smc" build probe.app -o out 2>log
if test $? = 2 && grep -q "'out/rise.c' exists and was not written by smc; use another name, or --force" log && cmp -s rise.c out/rise.c && test "$(ls out)" = rise.c
then good; else bad "handwritten C"; cat log; fi
: >out/rise.c
if "$smc" build probe.app -o out && "$smc" build probe.app -o out && grep -q 'Generated by smc' out/rise.c; then good; else bad "C that smc made"; fi
"$smc" build rise.sm --sv probe.sv --emit=c 2>log
if test $? = 2 && grep -q "'rise.c' exists and was not written by smc; use another name, or --force" log && ! test -f rise.h; then good; else bad "a machine's handwritten C"; cat log; fi

# Names that lead out of the folder, and into others.
fresh paths; mkdir parts out; mv probe.sv parts/probe.sv; sed -i.old 's/"probe.sv"/"parts\/..\/parts\/probe.sv"/' probe.app
if "$smc" build probe.app -o out && test -f out/probe.c; then good; else bad "a file in another folder"; fi

# ---- large ones ----

fresh large
{
    printf '[options]\nstate_vector "probe.sv"\ntime time 1 ms\n[flight]\nevery 1 ms:\n'
    awk 'BEGIN { for (i = 0; i < 10000; i++) printf "task t%d @mode mode\n", i
                 for (i = 2; i < 1000; i++) printf "every %d ms:\ntask r%d\n", i, i }'
} >probe.app
mkdir out
if "$smc" build probe.app -o out 2>log && test "$(grep -c '^    {.name = ' out/probe_app.c)" = 10999 &&
   $cc -std=c99 -I"$root" -Iout -c out/probe_app.c -o large.o 2>>log; then good; else bad "11,000 tasks"; head -5 log; fi
awk 'BEGIN { printf "[options]\nstate_vector \"probe.sv\"\n[flight]\nevery 1 ms:\n"; for (i = 0; i < 65536; i++) printf "task t%d\n", i }' >probe.app
refuses "65,536 tasks" 1 E1045
printf '[options]\nstate_vector "probe.sv"\nio "probe.io"\n[flight]\nevery 1 ms:\noutputs\n' >probe.app
awk 'BEGIN { printf "[analog]\n"; for (i = 0; i < 65536; i++) printf "o %d mode\n", i }' >probe.io
refuses "65,536 pins" 1 E1045
awk 'BEGIN { printf "[options]\nstate_vector \"probe.sv\"\n[flight]\nevery 1 ms:\n"; for (i = 0; i < 20000; i++) printf "task t%d @mode mod%d\n", i, i }' >probe.app
refuses "20,000 unknown elements" 1 "20000 errors"
# The costs of the first machine, whose longest step is in its third state, are not checked again for a machine without an image.
printf '[options]\nstate_vector "probe.sv"\ntime time 1 ms\n[flight]\nevery 1 ms:\nmachine a "a.sm" @bytecode\nmachine b "b.sm" @bytecode\n' >probe.app
printf '[A]\nU64 time\nU32 s\nU32 t\nF64 x\nF64 y\n' >probe.sv
printf '[state_vector]\nU64 time @alias G\nU32 s @alias S\nF64 x\n[A] @safe\n.step\nx > 1: -> B\n[B]\n.step\nx > 2: -> C\n[C]\n.step\nx = x / 3 * x / 7\n' >a.sm
awk 'BEGIN { printf "[state_vector]\nU64 time @alias G\nU32 t @alias S\nF64 x\nF64 y\n[A] @safe\n.step\n"
             for (i = 0; i < 2750; i++) printf "y = y + roll_avg(x, %d)\n", 100000 - i }' >b.sm
refuses "a limit, and windows of 2 GB" 1 "machine 'b' needs too much memory.*E0853" -w --max-step=2
cp "$here/probe.app" "$here/probe.sv" .
awk 'BEGIN { for (i = 0; i < 100000; i++) printf "(" }' | cat "$here/probe.app" - >probe.app; refuses "parentheses" 1 "E1023"
{ cat "$here/probe.app"; printf '[more]\nevery 1 s:\ntask a @mode '; awk 'BEGIN { for (i = 0; i < 100000; i++) printf "x" }'; } >probe.app; refuses "a long name" 1 "E0"

echo "$passed passed, $failed failed$(test $skipped = 0 || echo ", $skipped skipped")"
[ "$failed" -eq 0 ] && [ $((passed + skipped)) -gt 0 ]
