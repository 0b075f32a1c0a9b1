#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Installs into a scratch folder and uses the installed files as a user would: the command, smc.mk in a project of its own, the
# VM library by pkg-config; then uninstalls and searches for leftovers.    sh tests/install/run.sh MAKE B CC  (CC may be several words)
make=$1 build=$2 cc=$3
. tests/checks.sh
root=$(pwd)
dir=$(mktemp -d) || exit 1
trap 'rm -rf "$dir"' EXIT
inst=$dir/inst/usr

# Whether make reports something to rebuild: exit code 1; 2 would be an error.
stale() { "$make" -q "$@"; test $? -eq 1; }
# stops TEXT ARGUMENT...: make ends with an error, and its output contains the text.
stops()
{
    text=$1
    shift
    "$make" -s "$@" >"$dir/stops" 2>&1
    test $? -eq 2 && grep -q "$text" "$dir/stops"
}

check "make install" "$make" -s B="$build" CC="$cc" DESTDIR="$dir/inst" PREFIX=/usr install
check "the command runs" "$inst/bin/smc" --version

# All commands of `smc help` are there, and cases of .smt files run.
commands_help()
{
    "$inst/bin/smc" help | sed -n 's/^  smc \([a-z-]*\) .*/\1/p' | sort -u >"$dir/commands"
    test "$(wc -l <"$dir/commands")" -ge 20 || return 1
    while read -r command; do
        "$inst/bin/smc" help "$command" | grep -q '^Usage:' && "$inst/bin/smc" "$command" --help | grep -q '^Usage:' || { echo "$command"; return 1; }
    done <"$dir/commands"
}
check "each command prints its help" commands_help
check "cases of an .smt file run" sh -c "'$inst/bin/smc' test '$root/tests/script'/*.smt >'$dir/cases' && grep -q ' passed' '$dir/cases'"

# A project that builds a machine both ways with smc.mk.
mkdir "$dir/project"
cp examples/tank/tank.sm examples/tank/tank.ss "$dir/project"
cat >"$dir/project/Makefile" <<EOF
all: tank.smb tank.o
SMC = $inst/bin/smc
tank.o: tank.c tank.h
include $inst/share/smc/smc.mk
EOF
cd "$dir/project" || exit 1
check "the grammars for editors are there" test -e "$inst/share/smc/editors/vim/syntax/smc.vim"
check "what messages refer to is there" test -e "$inst/share/smc/docs/boards.md"
check "a project builds with smc.mk" "$make" -s CC="$cc"
check "its image is sound" "$inst/bin/smc" verify tank.smb
check "nothing is built twice" "$make" -q CC="$cc"
sleep 1
touch tank.sm
check "a changed source is noticed" stale CC="$cc"
check "and built again" "$make" -s CC="$cc"
printf 'nonsense\n' >broken.sm
check "a broken source stops make" stops '^broken.sm:1:1: error' SMC="$inst/bin/smc" broken.smb
check "and leaves no output" test ! -e broken.smb
cat >flags.mk <<EOF
SMC      = $inst/bin/smc
SMCFLAGS = --sv=tank.sv
include $inst/share/smc/smc.mk
EOF
printf '[Tank]\nU64 G\nU32 S\nbool open\n' >tank.sv
printf '[state_vector]\nU64 G\nU32 S\nbool open\n[Idle]\n.step\n    open = true\n' >valve.sm
sees_flags()
{
    "$make" -s -f flags.mk valve.c valve.smb && "$make" -q -f flags.mk valve.c valve.smb && sleep 1 && touch tank.sv &&
        stale -f flags.mk valve.c && stale -f flags.mk valve.h && stale -f flags.mk valve.smb
}
check "a state vector that only the options name is noticed, by the C as well" sees_flags
cat >pins.mk <<EOF
SMC    = $inst/bin/smc
SMC_SV = tank.sv
SMC_IO = tank.io
include $inst/share/smc/smc.mk
EOF
printf '[digital]\no 8 open\n' >tank.io
sees_pins()
{
    "$make" -s -f pins.mk valve.smb && "$make" -q -f pins.mk valve.smb && sleep 1 && touch tank.io && stale -f pins.mk valve.smb &&
        "$make" -s -f pins.mk valve.smb && sleep 1 && sed -i.old '/SMC_IO/d' pins.mk && stale -f pins.mk valve.smb
}
check "so are the pins of an image, and where both are named" sees_pins
sees_messages()
{
    printf '[A]\nU32 x\n' >far.sv && printf 'receive a on 5001 { x }\n' >far.net && sed 's/tank/far/' pins.mk >net.mk &&
        "$make" -s -f net.mk far_net.c && test -f far_net.h && sleep 1 && touch far.sv && stale -f net.mk far_net.c &&
        "$make" -s -f net.mk smc-clean && test ! -f far_net.c && rm -f far.sv far.net net.mk
}
check "messages become C, again if their state vector changes" sees_messages
check "make flash-NAME sends" sh -c "$make -n -f pins.mk flash-valve PORT=there | grep -q 'smc flash valve.smb --port=there'"
check "missing pins are reported, not left out" sh -c "$make -f pins.mk SMC_IO=lost.io flash-valve PORT=there 2>&1 | grep -q 'there is no lost.io'"
check "make flash asks which" sh -c "$make -n -f pins.mk flash PORT=there 2>&1 | grep -q 'flash-NAME says which machine'"
mkdir one && cp valve.sm one
check "or sends the one that is here" sh -c "$make -n -C one -f ../pins.mk SMC_SV=../tank.sv flash PORT=there | grep -q 'smc flash valve.smb --port=there'"
mkdir -p far/away && cp valve.sm far/away
sees_far()
{
    "$make" -s -f flags.mk far/away/valve.c && "$make" -q -f flags.mk far/away/valve.c && sleep 1 && touch tank.sv &&
        stale -f flags.mk far/away/valve.c && "$make" -s -f flags.mk smc-clean && test ! -e far/away/valve.c -a ! -e far/away/valve.h -a ! -e far/away/valve.sm.d
}
check "a machine two folders down is one, too" sees_far
rm -rf flags.mk pins.mk* one far tank.sv tank.io valve.*
check "smc-clean removes what was made, and nothing else" sh -c "$make -s smc-clean && test ! -e tank.c -a ! -e tank.h -a ! -e tank.smb -a -e tank.sm -a -e broken.sm"
printf 'include %s/share/smc/smc.mk\nmine:\n\t@echo mine\n' "$inst" >own.mk
check "nothing of it is what plain make makes" sh -c "$make -s -f own.mk | grep -qx mine"

# Where the command is, if it is in PATH, and the message if it is not.
cp "$root/examples/tank/tank.sm" "$dir/project/found.sm"
printf 'export PATH := %s/bin:$(PATH)\ninclude %s/share/smc/smc.mk\n' "$inst" "$inst" >path.mk
check "make cover-NAME writes scripts" sh -c "$make -s -f path.mk cover-tank && ls cover/tank-*.ss && rm -r cover"
cp "$root/examples/tank/tank.rq" "$root"/examples/tank/tank-*.ss .
check "make test-NAME runs scripts with their requirements" sh -c "$make -s -f path.mk test-tank >test.txt && grep -q 'R1  *met' test.txt && rm test.txt"
check "make test-NAME needs a script" sh -c "$make -s -f path.mk test-found 2>&1 | grep -q 'there is no found.ss'"
sees_proof()
{
    "$make" -s -f path.mk tank.proof && grep -q 'R1' tank.proof && "$make" -q -f path.mk tank.proof && sleep 1 && touch tank.rq && stale -f path.mk tank.proof &&
        "$make" -s -f path.mk smc-clean && test ! -e tank.proof -a ! -e tank.proof.d
}
check "NAME.proof has the verdicts on requirements, again if they change, until smc-clean" sees_proof
# What fails is made again, and stays to be read.
makes_again()
{
    printf 'R1 "never" never valveOpen\n' >>tank.rq && sed -i.old 's/^R1 "above/R7 "above/' tank.rq
    ! "$make" -s -f path.mk tank.proof >/dev/null 2>&1 && grep -q violated tank.proof && ! "$make" -s -f path.mk tank.proof >/dev/null 2>&1
}
check "a proof that fails does not count as made" makes_again
cp "$root/examples/tank/tank.rq" . && rm -f tank.rq.old tank.proof*
sees_page()
{
    "$make" -s -f path.mk tank.html SMC_REPORT=--sweep && grep -q 'Parameters at other values' tank.html && "$make" -q -f path.mk tank.html && sleep 1 &&
        touch tank-overpressure.ss && stale -f path.mk tank.html && printf '[all_states]\nat 0: @assert valveOpen\nat 0: @stop\n' >tank-bad.ss &&
        ! "$make" -s -f path.mk tank.html 2>/dev/null && grep -q 'tank-bad.ss' tank.html && stale -f path.mk tank.html && rm tank-bad.ss &&
        "$make" -s -f path.mk smc-clean && test ! -e tank.html -a ! -e tank.html.d
}
check "NAME.html is the page for a review, again if a script changes, until smc-clean" sees_page
sed 's/^U64  counter.*/&\nU16 limit = 775 @parameter @range 700 900/; s/> 775/> limit/' tank.sm >swept.sm && cp tank.ss swept.ss
check "make mutate-NAME changes the machine" sh -c "$make -s -f path.mk mutate-tank | grep -q '^mutations of tank: .* changes are noticed'"
check "make faults-NAME makes its inputs faulty" sh -c "$make -s -f path.mk faults-tank 2>/dev/null | grep -q '^faults of tank: 1 input'"
check "make sweep-NAME sets a parameter to other values" sh -c "$make -s -f path.mk sweep-swept SET=limit=700:800:3 | grep -q '^sweep of swept: 1 script'"
check "and asks which" sh -c "$make -s -f path.mk sweep-swept 2>&1 | grep -q 'SET=limit=700:900:21 says which parameter'"
rm -f swept.*
mkdir app && cp "$root"/examples/dualdeploy/* app
sees_application()
{
    "$make" -s -C app -f ../path.mk test-dualdeploy | grep -q 'R1  *met' &&
        "$make" -s -C app -f ../path.mk faults-dualdeploy SMCFLAGS=-Wno-all 2>/dev/null | grep -q '^faults of dualdeploy: 2 inputs' &&
        "$make" -n -C app -f ../path.mk mutate-dualdeploy | grep -q 'smc mutate dualdeploy.app dualdeploy' &&
        "$make" -n -C app -f ../path.mk sweep-dualdeploy SET=a.b=1:2:3 SMC_SV=dualdeploy.sv | grep 'smc sweep dualdeploy.app' | grep -qv -e '--sv' &&
        "$make" -s -C app -f ../path.mk dualdeploy.html && "$make" -q -C app -f ../path.mk dualdeploy.html && sleep 1 && touch app/channel.sm &&
        stale -C app -f ../path.mk dualdeploy.html
}
check "the same of an application, whose page is made again if a machine changes" sees_application
rm -r app
sed 's/825/820/; s/+ 25/+ 20/' tank.sm >flown.sm
check "make diff-NAME compares with an earlier machine" sh -c "! $make -s -f path.mk diff-tank OLD=flown.sm >diff.txt && grep -q '^comparison of flown.sm with tank.sm: behaviour changed' diff.txt && rm diff.txt flown.sm"
check "the command is found in PATH" sh -c "PATH='$inst/bin:$PATH' $make -s -f own.mk found.smb && rm found.smb"
check "and in a PATH that the project sets" sh -c "$make -s -f path.mk found.smb && rm found.smb"
if command -v smc >/dev/null; then
    echo "install: smc is in PATH here: the message for a missing smc is not checked"
    skipped=$((skipped + 1))
else
    check "where it is missing, the message names the variable to set" sh -c "$make -f own.mk found.smb 2>&1 | grep -q '^smc is not in PATH: set SMC = /where/it/is/smc before the include'"
    check "and nothing where it is not wanted" sh -c "$make -s -f own.mk mine && $make -s -f own.mk smc-clean"
fi
rm -f found.* path.mk

# A project that builds an application, away from this tree: its machine as C, then as an image.
mkdir "$dir/app"
cp "$root"/tests/app/probe.* "$root"/tests/app/*.sm "$root/tests/app/tasks.c" "$root/tests/app/expected.txt" "$dir/app"
cd "$dir/app" || exit 1
cat >Makefile <<EOF
SMC          = $inst/bin/smc
SMC_APP      = probe            # blanks before a comment belong to a value,
SMC_SOURCES  = tasks.c          # and do no harm
SMC_PLATFORM = sim              #
include $inst/share/smc/smc.mk
EOF
check "an application builds with smc.mk" "$make" -s CC="$cc" CFLAGS=-O0
check "and flies" sh -c "./probe | cmp - expected.txt"
check "nothing of it is built twice" "$make" -q CC="$cc" CFLAGS=-O0
check "make cover-NAME writes scripts of an application" sh -c "$make -s cover-probe | grep -q '^goals of ' && ls cover/probe-*.ss && rm -r cover"
sleep 1
sed 's/"rise.sm"/& @bytecode/' probe.app >new && mv new probe.app
check "a changed application is noticed" stale CC="$cc" CFLAGS=-O0
check "and built again" "$make" -s CC="$cc" CFLAGS=-O0
check "and flies on the VM" sh -c "./probe | cmp - expected.txt"
sleep 1
echo nonsense >>probe.app
check "a broken application stops make" stops '^probe.app:.*error' CC="$cc" CFLAGS=-O0
check "on Linux it links too" sh -c "sed /nonsense/d probe.app >new && mv new probe.app && $make -s CC='$cc' CFLAGS=-O0 SMC_PLATFORM=linux SMC_OUT=real"

# The test stand for an NI sbRIO, with the Makefile of the examples and the stand-in for NI's library, away from this tree.
mkdir "$dir/sbrio"
cp "$root"/examples/sbrio/* "$root"/examples/teststand/teststand.* "$root"/examples/teststand/monitor.sm "$root"/examples/teststand/stand.sm "$root"/tests/sbrio/NiFpga* "$dir/sbrio"
for_sbrio()
{
    cd "$dir/sbrio" && $make -s SMC_MK="$inst/share/smc/smc.mk" SMC="$inst/bin/smc" CC="$cc" CFLAGS=-O0 PSL_WATCHDOG=watchdog_process &&
        STANDIN_CALLS=200 ./teststand && "$inst/bin/smc" log teststand.log | grep -q 'the application was stopped'
}
check "an application for an NI sbRIO builds, runs and ends" for_sbrio
cd "$dir/project" || exit 1

# An application that swaps one of its machines: the image comes from smc.mk, too.
mkdir "$dir/swapping"
cp "$root"/tests/app/swap/* "$dir/swapping"
cd "$dir/swapping" || exit 1
cat >Makefile <<EOF
SMC          = $inst/bin/smc
SMCFLAGS     = -w -g
SMC_APP      = bench
SMC_SV       = bench.sv
SMC_SOURCES  = tasks.c
SMC_PLATFORM = sim
all: bench
image.h: faster.smb
	{ echo 'static const unsigned char image[] = {'; od -An -v -tx1 faster.smb | sed 's/ *\([0-9a-f][0-9a-f]\)/0x\1, /g'; echo '};'; } >image.h
include $inst/share/smc/smc.mk
EOF
check "an application with swaps builds with smc.mk" sh -c "$make -s image.h CC='$cc' && $make -s CC='$cc' CFLAGS='-O0 -I.'"
check "and swaps its machine" sh -c "./bench | cmp - expected.txt"
check "with its log, on a desk" sh -c "$make -s CC='$cc' CFLAGS='-O0 -I.' SMC_PLATFORM=desk && ./bench | cmp - expected.txt && '$inst/bin/smc' log bench.log | grep -q 'confirmed'"

# The application while it runs, reached with the installed command: `count` counts by hundreds from now on.
cat >stand.app <<EOF
[options]
state_vector "bench.sv"
time         time 1 ms
swap         8 KB
swap_trial   100000
swap_at      "stand.sock"
[flight]
every 10 ms:
    machine count "count.sm" @bytecode @swap
EOF
sed 's/ = bench$/ = stand/; /SOURCES/d; /^all:/d; s/ = sim/ = linux/' Makefile >stand.mk
mkdir new && sed 's/n + 1$/n + 3/' count.sm >new/count.sm
reaches()
{
    $make -s -f stand.mk stand CC="$cc" CFLAGS=-O0 || return 1
    ./stand & stand=$!
    tries=0
    while ! test -S stand.sock && test $tries -lt 50; do sleep 0.1; tries=$((tries + 1)); done
    cp new/count.sm count.sm
    $make -s -f stand.mk swap-count TO=stand.sock MODE=continue >swapped && "$inst/bin/smc" device confirm --port=stand.sock >confirmed
    code=$?
    kill $stand && wait $stand 2>/dev/null
    test $code = 0 && grep -q 'kept     state Up' swapped && grep -q 'was confirmed' confirmed
}
check "an application that runs gets another machine by make swap-NAME" reaches
check "which asks how the machine goes on" sh -c "$make -n -f stand.mk swap-count TO=stand.sock 2>&1 | grep -q 'MODE=continue or MODE=restart'"

# One program, other settings: each time it is the one that was asked for.
cd "$dir/app" || exit 1
programs()
{
    rm -f probe.log
    "$make" -s CC="$cc" CFLAGS=-O0 && ./probe | cmp - expected.txt && test ! -e probe.log || return 1
    "$make" -s CC="$cc" CFLAGS=-O0 SMC_PLATFORM=linux && grep -q /dev/watchdog probe || return 1
    "$make" -s CC="$cc" CFLAGS=-O0 SMC_PLATFORM=linux PSL_WATCHDOG=watchdog_process && ! grep -q /dev/watchdog probe || return 1
    "$make" -s CC="$cc" CFLAGS=-O0 SMC_PLATFORM=desk && ./probe | cmp - expected.txt && test -s probe.log
}
other_flags()
{
    stale CC="$cc" CFLAGS="-O0 -DMARK='\"a b\"'" && "$make" -s CC="$cc" CFLAGS="-O0 -DMARK='\"a b\"'" &&
        "$make" -q CC="$cc" CFLAGS="-O0 -DMARK='\"a b\"'"
}
check "each platform has its program" programs
check "other flags rebuild it, once" other_flags
in_cxx()
{
    case $cc in *' '*) cxx="${CXX:-g++} ${cc#* }" ;; *) cxx=${CXX:-g++} ;; esac         # with the options of CC, as sanitizers want
    cp tasks.c own.cpp && "$make" -s CC="$cc" CXX="$cxx" CFLAGS=-O0 SMC_SOURCES=own.cpp &&
        "$make" -q CC="$cc" CXX="$cxx" CFLAGS=-O0 SMC_SOURCES=own.cpp &&
        ./probe | cmp - expected.txt && rm own.cpp
}
if command -v "${CXX:-g++}" >/dev/null; then
    check "tasks may be C++" in_cxx
else
    echo "install: no C++ compiler here; apt-get install g++"
    skipped=$((skipped + 1))
fi
refused() { ! "$make" -s CC="$cc" "$1" >log 2>&1 && grep -qF "$2" log && rm log; }
check "an unknown platform is reported" refused SMC_PLATFORM=bord 'SMC_PLATFORM = bord: there is none of that name; there are avr desk linux none sbrio sim'
check "an application in a folder too" refused SMC_APP=sub/probe 'Run make where probe.app is'
check "and a source of another kind" refused SMC_SOURCES='tasks.c own.rs' 'own.rs ends in none of .c, .cc and .cpp'
echo nonsense >>probe.app
printf 'clean: smc-clean\n\trm -f probe.log\n' >>Makefile
check "smc-clean, behind a clean of one's own, removes what was made" sh -c "$make -s clean && test ! -e made -a ! -e probe -a -e tasks.c -a -e probe.app -a -e real"
cd "$dir/project" || exit 1

# The VM as a library.
cat >host.c <<'EOF'
#include "bytecode-vm/smvm.h"

int main(void)
{
    static const uint8_t none[16] = {0};
    SmvmVerdict why;
    return smvm_verify(none, sizeof none, &why) != 0 ? 0 : 1;
}
EOF
check "the VM library compiles in" $cc -std=c99 -I"$inst/include/smc" host.c -L"$inst/lib" -lsmvm -o host
check "and runs" ./host
# As a shared library for other languages: it exports what the headers declare, and nothing else.
shared() { $cc -shared -o libsmvm.so -Wl,--whole-archive "$inst/lib/libsmvm.a" -Wl,--no-whole-archive; }
declarations() { $cc -E -P -std=c99 -DSMVM_BINDINGS '-D__attribute__(x)=' -I"$inst/include/smc" "$inst/include/smc/bytecode-vm/swap.h" >smvm.i; }
exports_declared()
{
    grep -o '[ *]sm_result_text(\|[ *]smvm_[a-z_0-9]*(' smvm.i | tr -d ' *(' | sort >declared
    nm -D --defined-only libsmvm.so | sed -n 's/.* [A-Z] \(sm.*\)/\1/p' | sort >exported
    test "$(wc -l <declared)" -ge 32 && cmp declared exported
}
check "the VM library becomes a shared one" shared
check "its headers can be read as declarations" declarations
if command -v nm >/dev/null; then
    check "which are exactly what it exports" exports_declared
else
    echo "install: no nm here; apt-get install binutils"
    skipped=$((skipped + 1))
fi
check "a program uses the shared one" sh -c "$cc -std=c99 -I'$inst/include/smc' host.c ./libsmvm.so -Wl,-rpath,. -o host3 && ./host3"
runs_python()
{
    sed -n '/^import cffi/,/^```$/{/^```$/d;p;}' "$root/docs/embedding.md" >host.py && test "$(wc -l <host.py)" -ge 25 &&
        "$inst/bin/smc" build -w -g tank.sm -o tank.smb && python3 host.py >host.out && grep -c 'psi in TankVentControl' host.out | grep -qx 4 &&
        sed -n '/^\$ .\/host$/,/^```$/{/psi in/p;}' "$root/docs/embedding.md" | cmp - host.out
}
if python3 -c 'import cffi' 2>/dev/null; then
    check "cffi reads the declarations, and the example of the documentation runs" runs_python
else
    echo "install: no cffi for python3 here; apt-get install python3-cffi"
    skipped=$((skipped + 1))
fi
runs_rust()
{
    bindgen "$inst/include/smc/bytecode-vm/smvm.h" -o smvm.rs -- -DSMVM_BINDINGS -I"$inst/include/smc" &&
        printf '#![allow(warnings)]\ninclude!("smvm.rs");\nfn main() { unsafe { assert!(smvm_machine_size() as usize == std::mem::size_of::<SmvmMachine>()); } }\n' >host.rs &&
        rustc host.rs -L native="$inst/lib" -l static=smvm -o host_rs && ./host_rs
}
if command -v bindgen >/dev/null && command -v rustc >/dev/null; then
    check "bindgen reads the header, and a program in Rust links the library" runs_rust
else
    echo "install: no bindgen or no rustc here; apt-get install bindgen rustc"
    skipped=$((skipped + 1))
fi
if command -v pkg-config >/dev/null; then
    PKG_CONFIG_PATH=$inst/lib/pkgconfig
    export PKG_CONFIG_PATH
    check "pkg-config knows smvm" pkg-config --define-prefix --cflags --libs smvm
    check "and its flags work" sh -c "$cc host.c \$(pkg-config --define-prefix --cflags --libs smvm) -o host2 && ./host2"
else
    echo "install: no pkg-config here; apt-get install pkg-config"
    skipped=$((skipped + 2))
fi

cd "$root" || exit 1
there="$dir/another place"
check "make install to a second place, with a blank in its name" "$make" -s B="$build" CC="$cc" PREFIX="$there" install
check "the command runs there" "$there/bin/smc" --version
if command -v pkg-config >/dev/null; then
    names_place() { eval "set -- $(PKG_CONFIG_PATH="$there/lib/pkgconfig" pkg-config --cflags smvm)" && test "$1" = "-I$there/include/smc" -a -d "$there/include/smc"; }
    check "pkg-config names the second place" names_place
else
    skipped=$((skipped + 1))
fi
check "and is gone from there" sh -c "'$make' -s B='$build' PREFIX='$there' uninstall && test -z \"\$(find '$there' -type f)\""
check "make uninstall" "$make" -s B="$build" DESTDIR="$dir/inst" PREFIX=/usr uninstall
check "nothing is left" sh -c "test -z \"\$(find '$dir/inst' -type f)\""

finish install
