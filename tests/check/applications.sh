#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Builds the applications among the examples and flies them: applications.sh SMC CC ARCHIVES FOLDER...  (ARCHIVES/PLATFORM.a: the
# runtime on that platform.)  Each is checked without a word from smc and compiles without one.  One with a bench (bench.c) is tried
# on it.  The others fly on a desk, twice as C and once as bytecode, and leave the same log, byte for byte.  FOLDER/check.sh then
# checks that flight.
smc=$1 cc=$2 archives=$3
shift 3
root=$(pwd)
for file in smc archives; do
    eval "case \$$file in /*) ;; *) $file=\$root/\$$file ;; esac"
done
work=${TMPDIR:-/tmp}/smc-applications.$$
trap 'rm -rf "$work"' EXIT
passed=0 failed=0

# A test: its name, then the command, which must succeed; with quiet=1 it must print nothing either.
expect() {
    name=$1
    shift
    if "$@" >"$work/out" 2>&1 && { [ -z "$quiet" ] || [ ! -s "$work/out" ]; }; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "$folder, $name: $*"
        cat "$work/out"
    fi
}

# One that has tests of its own: their number is in its last line.
expect_all() {
    "$@" >"$work/out" 2>&1
    line=$(tail -n 1 "$work/out")
    p=$(expr "$line" : '\([0-9]*\) passed, [0-9]* failed$') f=$(expr "$line" : '[0-9]* passed, \([0-9]*\) failed$')
    [ "${f:-1}" -eq 0 ] && [ "${p:-0}" -gt 0 ] || { echo "$folder: $*"; cat "$work/out"; }
    passed=$((passed + ${p:-0})) failed=$((failed + ${f:-1}))
}

WARN="-Wall -Wextra -Wconversion -Wshadow -Wstrict-prototypes -Wmissing-prototypes -pedantic -Werror"

# compile GEN PLATFORM OUT: the C in the folder and what smc made in GEN.
compile() {
    # shellcheck disable=SC2086
    $cc -std=c99 -O1 -ffp-contract=off $WARN $defines -I"$root" -I"$1" "$folder"/*.c "$1"/*.c "$archives/$2.a" -o "$3" -pthread -lrt
}

# build APP GEN: into a new folder.
build() { mkdir -p "$2" && "$smc" build "$1" -o "$2"; }

# fly PROGRAM: runs it in a folder of its own, which contains the log afterwards.
fly() { mkdir -p "$1.flight" && (cd "$1.flight" && "$1"); }

# variant NAME APP SED: the application with some lines changed, beside its sources; built and compiled as $work/NAME.
variant() {
    rm -rf "$work/$1.src" && cp -r "$folder" "$work/$1.src" && sed "$3" "$2" >"$work/$1.src/$(basename "$2")"
    expect "$1: build" build "$work/$1.src/$(basename "$2")" "$work/$1.gen"
    expect "$1: compile" compile "$work/$1.gen" "$4" "$work/$1"
}

try() {                                   # APP
    quiet=1 defines=
    rm -rf "$work" && mkdir -p "$work"
    expect check "$smc" check -Weverything "$1"
    expect build build "$1" "$work/gen"
    if [ -f "$folder/bench.c" ]; then
        defines=-DSM_NO_MAIN
        expect compile compile "$work/gen" sim "$work/bench"
        expect_all "$work/bench"
        return
    fi
    expect compile compile "$work/gen" desk "$work/desk"
    expect flight fly "$work/desk"
    mv "$work/desk.flight" "$work/first"
    expect "flight again" fly "$work/desk"
    expect "the same log" cmp "$work"/first/*.log "$work"/desk.flight/*.log
    variant bytecode "$1" 's/^ *machine .*/& @bytecode/' desk
    expect "flight of bytecode" fly "$work/bytecode"
    expect "the same log of bytecode" cmp "$work"/first/*.log "$work"/bytecode.flight/*.log
    quiet=
    # shellcheck source=/dev/null
    [ ! -f "$folder/check.sh" ] || . "$root/$folder/check.sh"
}

for folder; do
    for app in "$folder"/*.app; do
        [ ! -f "$app" ] || try "$app"
    done
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
