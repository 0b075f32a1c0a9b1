# SPDX-License-Identifier: Apache-2.0
# smc faults and smc sweep: the matrix of a machine with twelve states and six sensors within 10 s of processor time; every script that is written
# fails when smc test runs it; a signal leaves complete files.
#     sh tests/whatif/run.sh SMC [short]
# short: two sensors of that machine, and no pairs of its faults.
smc=$1 short=${2:+1}
dir=$(mktemp -d "${TMPDIR:-/tmp}/smc-whatif.XXXXXX") || exit 1
trap 'rm -rf "$dir"' EXIT
passed=0
failed=0

check() { # LABEL CONDITION...
    label=$1
    shift
    if "$@"; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "whatif: $label: failed: $*"
    fi
}

# Runs smc faults with these arguments and writes the scripts.  Each of them has to fail as an ordinary script.
reproduce() { # NAME LEAST ARGUMENTS...
    name=$1
    least=$2
    shift 2
    "$smc" faults "$@" --scripts="$dir/$name" >"$dir/$name.txt" 2>"$dir/errors" || check "$name: $(head -n 1 "$dir/errors")" false
    total=$(ls "$dir/$name" | wc -l)
    check "$name: at least $least scripts" [ "$total" -ge "$least" ]
    check "$name: a script for each line" grep -q "^$total of $total line" "$dir/$name.txt"
    files=
    for argument; do
        case $argument in *.ss | --pairs | --kinds=*) ;; *) files="$files $argument" ;; esac
    done
    for script in "$dir/$name"/*.ss; do
        "$smc" test $files "$script" >"$dir/out" 2>&1
        check "$script" [ $? -eq 1 ]
    done
}

reproduce parachutes 8 examples/parachutes/parachutes.sm examples/parachutes/parachutes.ss examples/parachutes/parachutes.rq
reproduce recovery 8 examples/recovery/recovery.sm examples/recovery/recovery.ss --sv examples/recovery/recovery.sv
reproduce ignition 15 examples/ignition/ignition.sm examples/ignition/ignition.ss examples/ignition/ignition.rq
reproduce pairs 15 examples/ignition/ignition.sm examples/ignition/ignition.ss examples/ignition/ignition.rq --pairs --kinds=dead,stuck
reproduce application 20 examples/dualdeploy/dualdeploy.app examples/dualdeploy/*.ss examples/dualdeploy/dualdeploy.rq
reproduce tank 2 examples/tank/tank.sm examples/tank/tank.ss examples/tank/tank.rq

# The machine of tests/whatif, with a flight, a weak motor and a drogue that does not come out: every kind at every trigger.  A build with sanitizers has no limit of its own.
limit=10
grep -q __asan_init "$smc" && limit=300
( ulimit -t $limit
  "$smc" faults tests/whatif/sequencer.sm tests/whatif/sequencer*.ss tests/whatif/sequencer.rq ${short:+--inputs=altitude,drogueOut} >"$dir/sequencer.txt" 2>"$dir/errors" )
check "the matrix of the sequencer in $limit s of processor time" [ $? -eq 0 ]
faults=3172
[ -z "$short" ] || faults=976
check "all faults of the sequencer" grep -q "61 triggers in 3 scripts; [0-9]* of $faults faults" "$dir/sequencer.txt"
check "the dead altimeter of the sequencer" grep -q '^  altitude dead .*R3, by the true values' "$dir/sequencer.txt"
check "the dead feedback of the sequencer" grep -q '^  drogueOut dead .*backupDrogue = true instead of false' "$dir/sequencer.txt"
check "the stuck feedback of the sequencer" grep -q '^  drogueOut high .*sequencer-backup.ss): backupDrogue = false instead of true' "$dir/sequencer.txt"

# Faults of which no analysis warned: an altimeter that dies in the ascent fires a charge, with a limit beside a timer and with the form of an apogee
# detector; one wild sample in the first step fills a window that has to be full for half a second.
cat >"$dir/limit.sm" <<'EOF_SM'
[state_vector]
U64  time      @alias G
U32  state     @alias S
F32  altitude  @read_only
bool drogue
[Ascent]
.step
    altitude < 500: -> Drogue
    T > 18000: -> Drogue
[Drogue] @safe
.entry
    drogue = true
EOF_SM
sed -e '/altitude < 500/d' -e 's/18000/18 s/' -e 's/^\[Ascent\]/[local]\nF64 highest = 0\n&/' -e 's/@read_only/& @range -50 12000/' \
    -e 's/^    T > 18 s/    highest = max(highest, roll_median(altitude, 9))\n    T > 1000 and roll_median(altitude, 9) < highest - 10: -> Drogue\n&/' \
    "$dir/limit.sm" >"$dir/apogee.sm"
cat >"$dir/ascent.ss" <<'EOF_SS'
[options]
delta_t 10
[all_states]
true: altitude = 600 + 200 * (G / 1000) - 5 * (G / 1000) * (G / 1000)
at 25 s: @stop
EOF_SS
echo 'R1 "no charge in the ascent"  never drogue and G < 13 s' >"$dir/ascent.rq"
cat >"$dir/latch.sm" <<'EOF_SM'
[state_vector]
U64   time  @alias G
U32   state @alias S
F64   P1    @read_only
F64   P2    @read_only
bool  alarm
[local]
bool bad = false
[Watch] @safe
.step
    roll_min(abs(P1 - P2), 50) > 2: bad = true
    alarm = bad
    bad: -> Stop
[Stop] @abort @safe
EOF_SM
cat >"$dir/latch.ss" <<'EOF_SS'
[options]
delta_t 10
[all_states]
true {
    P1 = 100 + noise(0.1)
    P2 = 100 + noise(0.1)
}
at 4 s: @assert state Watch
at 5 s: @stop
EOF_SS
echo 'R1 "half a second of disagreement"  never alarm and G < 0.48 s' >"$dir/latch.rq"
find_fault() { # NAME PATTERN FILE...
    name=$1 pattern=$2
    shift 2
    "$smc" faults -w "$@" >"$dir/$name.txt" 2>"$dir/errors"
    check "$name: the fault is found" grep -q "$pattern" "$dir/$name.txt"
}
find_fault limit '^  altitude dead .*: R1 at G = .*drogue = true instead of false' "$dir/limit.sm" "$dir/ascent.ss" "$dir/ascent.rq"
find_fault apogee '^  altitude dead .*: R1 at G = .*drogue = true instead of false' "$dir/apogee.sm" "$dir/ascent.ss" "$dir/ascent.rq"
find_fault latch '^  P1 dead from the start.*: R1 at G = 0;' "$dir/latch.sm" "$dir/latch.ss" "$dir/latch.rq"

# Pairs: those that are not run because they cannot be worse do not count, and no others are left out.  A campaign that ran every pair found these.
find_pairs() {
    "$smc" faults tests/whatif/sequencer.sm tests/whatif/sequencer.ss tests/whatif/sequencer.rq --pairs --kinds=noisy,late,dead -v >"$dir/pairs.txt" 2>"$dir/errors"
    check "the pairs of the sequencer" grep -q "2120 pairs, 6 of them worse than each alone" "$dir/pairs.txt"
    check "pairs of the sequencer that are not run" [ "$(sed -n 's/^\([0-9]*\) runs;.*/\1/p' "$dir/pairs.txt")" -lt 300 ]
}
[ -n "$short" ] || find_pairs

# smc why: values of parameters need whole runs, whose steps are bounded.
cat >"$dir/w.sm" <<'EOF_SM'
[options]
step 1 ms
[state_vector]
U64 G
U32 S
F64 p @read_only
[local]
F64 most = 800 @parameter @range 100 2000
F64 other = 700 @parameter @range 100 2000
F64 third = 600 @parameter @range 100 2000
[Run]
.step
    T >= 1400000 and p >= most: -> Stop
    T >= 1400000 and p >= other: -> Stop
    T >= 1400000 and p >= third: -> Stop
[Stop] @safe
EOF_SM
printf '[options]\ndelta_t 1\n[all_states]\nG == 0: p = 400\nG == 1400000: @stop\n' >"$dir/w.ss"
"$smc" why "$dir/w.sm" "$dir/w.ss" --max-steps=2000000 >"$dir/why.txt" 2>"$dir/errors"
check "a parameter that is tried" grep -q 'with most = 400 in the whole run' "$dir/why.txt"
check "a parameter for which there is no room" [ "$(grep -c 'third = 400 in the whole run' "$dir/why.txt")" = 0 ]
check "parameters that are not" grep -q '^not all values of parameters were tried' "$dir/why.txt"

# A signal: the result has what was run, and is complete.
"$smc" faults tests/whatif/sequencer.sm tests/whatif/sequencer.ss --pairs --format=json -o "$dir/cut.json" --scripts="$dir/cut" 2>"$dir/errors" &
sleep 2
kill -TERM $!
wait $!
check "a signal ends the process" [ $? -eq 143 ]
check "the file is complete" [ "$(tail -c 4 "$dir/cut.json")" = "]}" -o "$(tail -c 3 "$dir/cut.json")" = "]}" ]
check "the file is marked" grep -q '"complete":false' "$dir/cut.json"
check "the message" grep -q 'interrupted after' "$dir/errors"
for script in "$dir/cut"/*.ss; do
    [ ! -e "$script" ] || check "$script" grep -q '^# ---- the fault ----\|@stop' "$script"
done

# The page of smc report after a signal, and after the time that it was given.
"$smc" report tests/whatif/sequencer.sm tests/whatif/sequencer.ss --faults --pairs --mutate --format=text -o "$dir/page.txt" 2>"$dir/errors" &
pid=$! waited=0
catches() { grep -q '^SigCgt:.*[4-7c-f]...$' "/proc/$pid/status" 2>/dev/null; }       # SIGTERM is signal 15
until catches || [ $waited -eq 120 ]; do          # the parts have begun; without /proc, for as long as they take
    sleep 1
    waited=$((waited + 1))
    [ -e "/proc/$pid/status" ] || [ $waited -lt 5 ] || break
done
sleep 1
kill -TERM $pid
wait $pid
check "a signal ends smc report" [ $? -eq 143 ]
tr '\n' ' ' <"$dir/page.txt" >"$dir/page-unwrapped.txt"
check "the page is there, and says it" grep -q 'Stopped before it was complete: [^.]*faults of sensors' "$dir/page-unwrapped.txt"
check "the page is complete" grep -q '^Costs$' "$dir/page.txt"
"$smc" report tests/whatif/sequencer.sm tests/whatif/sequencer.ss --faults --pairs --time=1 --format=text -o "$dir/page.txt" 2>"$dir/errors"
check "the time ends no process" [ $? -eq 0 ]
check "the page says that time was over" grep -q '^Stopped before it was complete: faults of sensors' "$dir/page.txt"
check "so does a note" grep -q 'stopped before it was complete: faults of sensors' "$dir/errors"

echo "whatif: $passed passed, $failed failed"
[ "$failed" -eq 0 ]
