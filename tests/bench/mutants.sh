# SPDX-License-Identifier: Apache-2.0
# smc mutate: how many changes of a machine it tries a second of processor time, the whole command counted, and what becomes of those that no
# script notices.  Goals: 5,000 a second on machines of the size of the tank, 500 with about a hundred scripts; at most 2 % unknown.
#     sh tests/bench/mutants.sh SMC
smc=$1
dir=$(mktemp -d) || exit 1
trap 'rm -rf "$dir"' EXIT

# Prints how often a word is in the lists of changes.
count() { cat "$dir"/*.json | grep '"line"' | grep -c "$1"; }

# Runs the command $1 times on the machine and the scripts after it, and prints changes a second.
measure() {
    runs=$1 machine=$2
    shift 2
    scripts=$(printf '%s\n' "$@" | grep -c 'ss$')
    changes=$("$smc" mutate -w "$machine" "$@" --format=json | grep -c '"line"')
    # The last line of `times` has the seconds of the shell's children, as 0m0.300000s 0m0.010000s.
    (
        for run in $(seq "$runs"); do
            "$smc" mutate -w "$machine" "$@" --format=json >"$dir/list" || exit 1
        done
        times
    ) | awk -v name="$machine" -v scripts="$scripts" -v changes="$changes" -v runs="$runs" 'END {
        split($1, a, /[ms]/); split($2, b, /[ms]/)
        printf "%-34s %4d changes, %3d scripts: %6.0f a second\n", name, changes, scripts, changes * runs / (60 * (a[1] + b[1]) + a[2] + b[2]) }'
}

measure 100 examples/tank/tank.sm examples/tank/tank*.ss examples/tank/tank.rq
measure 100 examples/replay/vent.sm examples/replay/vent*.ss
measure 40 examples/recovery/recovery.sm examples/recovery/recovery*.ss
measure 20 examples/teststand/stand.sm examples/teststand/stand*.ss
"$smc" cover -w examples/teststand/stand.sm -o "$dir/covered" --effort=30 --must-not >/dev/null 2>&1
"$smc" mutate -w examples/teststand/stand.sm examples/teststand/stand*.ss --scripts="$dir/shown" >/dev/null
measure 10 examples/teststand/stand.sm examples/teststand/stand*.ss "$dir"/covered/*.ss "$dir"/shown/*.ss

# Every example that has scripts of its own, with its requirements.
n=0
for machine in examples/*/*.sm; do
    stem=${machine%.sm} requirements=
    test -n "$(ls "$stem"*.ss 2>/dev/null)" && test "$(dirname "$machine")" != examples/dualdeploy || continue
    test -f "$stem.rq" && requirements=$stem.rq
    n=$((n + 1))
    "$smc" mutate -w "$machine" "$stem"*.ss $requirements --generate --format=json -o "$dir/$n.json" || exit 1
    grep '"line"' "$dir/$n.json" | awk -v name="$machine" '/"unnoticed"}/ { u++ } END { printf "%-34s %4d changes, %d unknown (%.1f %%)\n", name, NR, u, 100 * u / NR }'
done
all=$(count .)
unknown=$(count '"unnoticed"}')
echo "$all changes: $(count '"noticed"') noticed, $(count '"generated"') shown by generated inputs, $(count '"equivalent"') equivalent" \
    "($(count '"if"') of them if only inputs change), $unknown unknown ($(awk "BEGIN { printf \"%.1f\", 100 * $unknown / $all }") %)"
