# SPDX-License-Identifier: Apache-2.0
# What coverage costs the command: smc test with and without --coverage on a script of a million steps for the tank, in processor seconds, in turns.
# The traces of a shorter script have the same bytes.
#     sh tests/bench/coverage.sh SMC
smc=$1
dir=$(mktemp -d) || exit 1
trap 'rm -rf "$dir"' EXIT

# Writes a script of $1 milliseconds to $2.
write_script() { printf '[options]\ndelta_t 10\n[all_states]\ntrue: tankPressure = 770 + noise(8)\nat %s: @stop\n' "$1" >"$2"; }

# Prints the processor seconds of ten calls.
seconds() {
    ( for run in 1 2 3 4 5 6 7 8 9 10; do "$smc" test -w examples/tank/tank.sm "$dir/long.ss" "$@" >/dev/null; done
      times ) | awk 'END { split($1, a, /[ms]/); split($2, b, /[ms]/); print 60 * (a[1] + b[1]) + a[2] + b[2] }'
}

write_script 9999990 "$dir/long.ss"
write_script 100000 "$dir/short.ss"
off=$(seconds) on=$(seconds --coverage) off2=$(seconds) on2=$(seconds --coverage)
passed=0
echo "$off $off2 $on $on2" | awk '{ printf "smc test, tank: %.0f ns a step, with --coverage %.0f ns: %.2f of the speed\n", ($1 + $2) * 50, ($3 + $4) * 50, ($1 + $2) / ($3 + $4) }'
# At least half the speed, by the better of two runs each.
echo "$off $off2 $on $on2" | awk '{ off = $1 < $2 ? $1 : $2; on = $3 < $4 ? $3 : $4; exit !(off > 0 && off >= on / 2) }' && passed=$((passed + 1))
"$smc" test -w examples/tank/tank.sm "$dir/short.ss" --trace="$dir/off.csv" >/dev/null
"$smc" test -w examples/tank/tank.sm "$dir/short.ss" --trace="$dir/on.csv" --coverage >/dev/null
test -s "$dir/on.csv" && cmp "$dir/off.csv" "$dir/on.csv" && echo "smc test, tank: the same trace with and without --coverage" && passed=$((passed + 1))
echo "cost of coverage: $passed passed, $((2 - passed)) failed"
test $passed = 2
