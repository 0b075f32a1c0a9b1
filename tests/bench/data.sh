#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# data.sh SMC [ROWS]: how many rows of recorded data `smc test` reads a second, ten columns a row.  Processor seconds of the process, the best of
# three runs: on a busy computer the real time says little.
smc=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
rows=${2:-1000000}
dir=$(mktemp -d) || exit 1
trap 'rm -rf "$dir"' EXIT
cd "$dir" || exit 1

columns='c1 c2 c3 c4 c5 c6 c7 c8 c9 c10'
awk -v n="$rows" 'BEGIN {
    print "t,c1,c2,c3,c4,c5,c6,c7,c8,c9,c10"
    for (i = 0; i < n; i++)
        printf "%d,%d.5,%d,%d,%d,%d.25,%d,%d,%d,%d,%d\n", i, i % 97, i % 31, i % 7, i % 11, i % 13, i % 17, i % 19, i % 23, i % 29, i % 3
}' >d.csv
{
    printf '[state_vector]\nU64 G\nU32 S\n'
    for c in $columns; do echo "F64 $c @read_only"; done
    printf 'bool on\n[Run]\n.step\n    on = c1 > 50\n'
} >m.sm
script() {          # DELTA_T END LINE
    printf '[options]\ndelta_t %s\n[data]\nfile "d.csv"\ntime "t" ms\n%s\n' "$1" "$3"
    for c in $columns; do echo "$c = \"$c\""; done
    printf '[all_states]\nG == %s: @assert c1 >= 0\nG == %s: @stop\n' "$2" "$2"
}
last=$((rows - 1000))
script file $last '' >each.ss
script 1000 $last '' >thousandth.ss
script 10 $last linear >linear.ss

# Prints the processor seconds of a run, as 0.31: the last line of `times` has those of the shell's children, as 0m0.300000s 0m0.010000s.
seconds_of() {
    ( "$smc" test m.sm "$1" -w --max-steps=$((rows * 2)) >out 2>&1; times ) | awk '{ user = $1; sys = $2 } END {
        split(user, a, /[ms]/); split(sys, b, /[ms]/); print 60 * (a[1] + b[1]) + a[2] + b[2] }'
}
measure() {         # NAME SCRIPT
    best=
    for run in 1 2 3; do
        s=$(seconds_of "$2")
        grep -q '^1 assert passed' out || { cat out; exit 1; }
        best=$(echo "$s ${best:-$s}" | awk '{ print $1 < $2 ? $1 : $2 }')
    done
    echo "$rows $best" | awk -v name="$1" '{ printf "%-32s %5.2f s   %9.0f rows a second\n", name, $2, $1 / ($2 > 0 ? $2 : 0.01) }'
}
measure 'a step each row' each.ss
measure 'a step each 1,000 rows' thousandth.ss
measure 'a step each 10 rows, linear' linear.ss
