#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# smc.exe at a console, which Wine makes of a pseudoterminal: Ctrl-C, and colours.     console.sh MAKE BUILD CC MACHINE
make=$1 build=$2 cc=$3 machine=$4
. tests/windows/wine.sh
. tests/checks.sh
command -v script >/dev/null || { echo "no script here (apt-get install bsdutils): 0 passed, 0 failed, 1 skipped"; exit ${MUST_RUN:-0}; }
dir=$folder/console
rm -rf "$dir" && mkdir -p "$dir" && cp examples/tank/tank.sm "$dir" || exit 1
printf '[options]\ndelta_t 1\n[all_states]\n    G == 2000000000: @stop\n' >"$dir/long.ss"
printf 'machine\n' >"$dir/wrong.sm"
printf '#include <windows.h>\nint main(void) { Sleep(60000); return 0; }\n' >"$dir/sleep.c"
"$machine-w64-mingw32-gcc" -s "$dir/sleep.c" -o "$dir/smc-sleeps.exe" || exit 1
cd "$dir" || exit 1

# until_ COMMAND…: waits until it succeeds, for 20 seconds at most
until_() { tries=0; until "$@"; do tries=$((tries + 1)); [ $tries -lt 200 ] || return 1; sleep 0.1; done; }

# press_c READY COMMAND: runs the command at a console, presses Ctrl-C when READY succeeds, and is true if the command ends then, with the low byte
# of STATUS_CONTROL_C_EXIT
press_c()
{
    rm -f keys ended
    mkfifo keys
    { script -qec "$2" /dev/null <keys >screen 2>&1; echo $? >ended; } &
    exec 4>keys
    until_ "$1" && [ ! -e ended ] || { echo "it is not so far:"; cat screen; }
    printf '\003' >&4
    until_ test -s ended
    exec 4>&-
    wait
    [ "$(cat ended)" = 58 ]
}
writes_trace() { [ -n "$(find . -name 'out.csv.*' -size +0)" ]; }
no_trace() { ! ls out.csv* 2>/dev/null; }
compiler_runs() { pgrep -f 'smc-sleeps.exe -O1' >/dev/null; }
compiler_ended() { ! compiler_runs; }

check "Ctrl-C ends a run" press_c writes_trace "'$smc' test tank.sm long.ss --trace=out.csv --max-steps=1000000000"
check "and nothing of its output is left" no_trace
check "Ctrl-C ends the compiler of --engine=c" press_c compiler_runs "CC='$(pwd)/smc-sleeps.exe' '$smc' test tank.sm long.ss --engine=c"
check "with it" until_ compiler_ended

# has_colour: whether the last command printed an escape sequence of a colour
has_colour() { LC_ALL=C grep -q "$(printf '\033')\[[0-9;]*m" screen; }
no_colour() { ! has_colour; }
at_console() { script -qec "$1" /dev/null </dev/null >screen 2>&1; grep -q wrong.sm screen; }
check "a message at a console" at_console "'$smc' check wrong.sm"
check "has colours" has_colour
check "a message with NO_COLOR" at_console "NO_COLOR=1 '$smc' check wrong.sm"
check "has none" no_colour
finish windows-console
