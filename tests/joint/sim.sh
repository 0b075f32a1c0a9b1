#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Random applications run in the simulation, as C and on the VM, and in smc test: at the end of simulated time without jitter, all elements
# are the same.  A C task plays the script.  clause 8.71 clause 8.72 clause 8.73 clause 8.74 clause 8.75
#     sh tests/joint/sim.sh SMC RANDOM SIM.a CC COUNT
smc=$1 random=$2 sim=$3 cc=$4 count=$5
passed=0 failed=0
case $2 in /*) ;; *) random=$(pwd)/$2 ;; esac
root=$(pwd)
dir=$(mktemp -d "${TMPDIR:-/tmp}/smc-joint.XXXXXX") || exit 1
trap 'rm -rf "$dir"' EXIT
good() { passed=$((passed + 1)); }
bad() { failed=$((failed + 1)); echo "joint/sim: $1"; head -10 "$dir/log"; }

seed=1
while test $seed -le "$count"; do
    rm -rf "$dir/app" && mkdir "$dir/app"
    # The generator has compared smc test's engines with its reference before it writes the files.
    if ! "$random" $seed 1 "$dir/app" 2>"$dir/log"; then
        bad "seed $seed is not generated"
    elif ! "$smc" build -w "$dir/app/joint.app" -o "$dir/app/out" 2>"$dir/log" ||
         ! $cc -std=c99 -O1 -ffp-contract=off -I"$root" -I"$dir/app/out" -o "$dir/app/run" "$dir"/app/out/*.c "$dir/app/player.c" "$sim" -lm 2>"$dir/log"; then
        bad "seed $seed does not build"
    elif "$dir/app/run" >"$dir/app/values.txt" 2>"$dir/log" && diff "$dir/app/expected.txt" "$dir/app/values.txt" >"$dir/log"; then
        good
    else
        bad "seed $seed: other values"
    fi
    seed=$((seed + 1))
done
echo "joint/sim: $passed passed, $failed failed"
exit $((failed > 0 || passed == 0))
