#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Puts the faults of faults.list into a copy of the sources, one at a time, and runs the tests that must notice:
# random programs on the VM, alone against what analyses say of them, in emitted C, and the conformance cases, in this order, until one fails.
#     faults.sh BUILD-FOLDER CC [FIRST [LAST]]
# Exit 1 if a fault was noticed by none of them.
b=$1/faults cc=$2 first=${3:-1} last=${4:-100000}
here=$(dirname "$0")
src=$b/src out=$b/out
mkdir -p "$src" "$out" "$b/obj"
tar cf - Makefile stdlib bytecode-vm runtime-c compiler tests conformance examples | tar xf - -C "$src"
b=$(cd "$b" && pwd)

# replace FILE: its first stretch $old becomes $new
replace() {
    old=$old new=$new awk '{
        at = done ? 0 : index($0, ENVIRON["old"])
        if (at) { $0 = substr($0, 1, at - 1) ENVIRON["new"] substr($0, at + length(ENVIRON["old"])); done = 1 }
        print
    } END { exit !done }' "$1" >"$1.new" && mv "$1.new" "$1"
}

build() {
    make -s -C "$src" B="$b/obj" CC="$cc" CFLAGS='-O1 -w' "$b/obj/smc" "$b/obj/diff/difftest" >"$b/out/build.log" 2>&1
}

# The first test that notices, or nothing.
noticed_by() {
    build || { echo "compiler"; return; }
    "$b/obj/diff/difftest" --count=5000 --first --no-reduce --no-floors --out="$b/out/vm" >"$b/out/log" 2>&1 || { echo "vm: $(head -n 1 "$b/out/log")"; return; }
    "$b/obj/diff/difftest" --sound --steps=1000 --count=3000 --first --no-reduce --no-floors --out="$b/out/sound" >"$b/out/log" 2>&1 || { echo "sound: $(head -n 1 "$b/out/log")"; return; }
    "$b/obj/diff/difftest" --count=400 --seed=7000 --first --no-reduce --cc="$cc -std=c99 -O0" --out="$b/out/c" >"$b/out/log" 2>&1 || { echo "c: $(head -n 1 "$b/out/log")"; return; }
    conformance
    [ "$result" = "$sound" ] || echo "conformance: $result"
}

# Runs the cases; their last line goes to $result, which is $sound where there is no fault.
conformance() { result=$(cd "$src" && "$b/obj/smc" test conformance 2>&1 | tail -n 1); }

judge() {
    [ "$number" -ge "$first" ] && [ "$number" -le "$last" ] || return
    cp "$file" "$src/$file"
    if ! replace "$src/$file"; then
        echo "fault $number: $file no longer holds: $old"
        survived=$((survived + 1))
        return
    fi
    by=$(noticed_by)
    if [ -n "$by" ]; then
        echo "fault $number noticed by $(printf '%.150s' "$by")"
        noticed=$((noticed + 1))
    else
        echo "fault $number NOT NOTICED: $file: $old  =>  $new"
        survived=$((survived + 1))
    fi
    cp "$file" "$src/$file"
}

number=0 noticed=0 survived=0
build && conformance && sound=$result
[ -n "$sound" ] && [ -z "$(noticed_by)" ] || { echo "the tests fail without any fault; see $b/out"; exit 1; }
while IFS= read -r line; do
    case $line in
    '@ '*) file=${line#@ } ;;
    '- '*) old=${line#- } ;;
    '+ '*) new=${line#+ } number=$((number + 1)); judge ;;
    esac
done <"$here/faults.list"
echo "faults: $noticed passed, $survived failed"
[ "$survived" -eq 0 ]
