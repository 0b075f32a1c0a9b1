#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# smc.exe under Wine prints and writes what smc does on this system, byte for byte: conformance cases, scripts, traces, diagrams, reports, images and
# emitted C of every example.     same.sh MAKE BUILD CC MACHINE
make=$1 build=$2 cc=$3 machine=$4
. tests/windows/wine.sh
. tests/checks.sh
dir=$folder/tmp
native=$(cd "$build" && pwd)/smc
rm -rf "$dir/here" "$dir/there"
mkdir -p "$dir/here" "$dir/there"

check "conformance on all engines but c" sh -c "'$native' test --engine=vm,ref,vm-soft --tap conformance >'$dir/here.tap'; echo \$? >>'$dir/here.tap'
    '$smc' test --engine=vm,ref,vm-soft --tap conformance >'$dir/there.tap'; echo \$? >>'$dir/there.tap'; grep -c '^ok' '$dir/here.tap' && ! grep '^not ok' '$dir/there.tap' && cmp '$dir/here.tap' '$dir/there.tap'"
check "at least 1000 conformance cases" sh -c "[ \$(grep -c '^ok' '$dir/there.tap') -ge 1000 ]"

# same NAME ARGUMENTS…: both print the same, end the same, and write the same file out
same()
{
    name=$1
    shift
    rm -f out
    "$native" "$@" >"$dir/here.out" 2>"$dir/here.err" </dev/null
    echo $? >"$dir/here.code"
    mv out "$dir/here/out" 2>/dev/null || : >"$dir/here/out"
    "$smc" "$@" >"$dir/there.out" 2>"$dir/there.err" </dev/null
    echo $? >"$dir/there.code"
    mv out "$dir/there/out" 2>/dev/null || : >"$dir/there/out"
    check "$name" sh -c "cmp '$dir/here.out' '$dir/there.out' && cmp '$dir/here.err' '$dir/there.err' && cmp '$dir/here.code' '$dir/there.code' && cmp '$dir/here/out' '$dir/there/out'"
}
for machine_file in examples/*/*.sm; do
    stem=${machine_file%.sm}
    scripts=$(ls "$stem".ss 2>/dev/null)
    vector=$(ls "$stem".sv 2>/dev/null)
    set -- "$machine_file" ${vector:+"--sv=$vector"}
    same "image of $machine_file" build -g "$@" --force -o out
    same "C of $machine_file" build -w --emit=c "$@" -o -
    same "diagram of $machine_file" graph "$@" --format=svg -o out --force
    same "check of $machine_file" check -Weverything "$@"
    same "report of $machine_file" report "$@" $scripts -o out --force
    for script in $scripts; do
        same "script $script" test "$@" "$script"
        same "trace of $script" test "$@" "$script" --trace=out --force
    done
done
finish "windows-same"
