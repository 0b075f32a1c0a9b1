#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# smc prove is interrupted by a real signal while it works on a requirement that takes long.  What was decided before stays decided.  What was not
# must end as "not decided", never as "no violation found", and the process ends by the signal.
#
#     interrupted.sh SMC
smc=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
trap 'exit 130' INT TERM
cd "$dir" || exit 1
checks=0
fails=0

fail()
{
    echo "interrupted: $*"
    sed 's/^/    /' out err
    fails=$((fails + 1))
}

cat >a.sm <<'END'
[options]
step 10 ms

[state_vector]
U64  time  @alias G
U32  state @alias S
F64  key   @read_only
bool valve

[local]
F64 a = 0
F64 b = 0

[Idle]
.step
    a = a * 31 + key * key
    a = a - 65521 * floor(a / 65521)
    b = b * 57 + key * (key + 3)
    b = b - 65521 * floor(b / 65521)
    T >= 40 ms and a == 40961 and b == 41309: -> Locked

[Locked]
.entry
    valve = true
END
cat >a.rq <<'END'
R1 "in a state"     always S == Idle or S == Locked
R2 "never open"     never valve
R3 "never at 7"     never valve and a == 7
END

# interrupt SECONDS OPTION…: runs until the signal
interrupt()
{
    seconds=$1
    shift
    timeout --preserve-status -s INT "$seconds" "$smc" prove a.sm a.rq --effort=1000000 "$@" >out 2>err
    code=$?
}

# R2 takes long, but R3 does not wait for it.  The signal can come before R3 is decided, or even before signals are delayed, on a computer that is
# busy.  Then it has to come later.
for seconds in 2 4 8 16 32 64; do
    interrupt "$seconds"
    grep -q '^  R3  proved ' out && break
done
checks=$((checks + 1))
grep -q '^  R1  proved ' out || fail "R1 is not proved before the signal"
checks=$((checks + 1))
grep -q '^  R3  proved ' out || fail "R3, which a short proof decides, has waited for R2"
checks=$((checks + 1))
[ "$code" = 130 ] || fail "ends with $code, not by the signal"
checks=$((checks + 1))
grep -q '^  R2  not decided ' out && grep -q '^      interrupted after [1-9][0-9]* steps of runs and [1-9][0-9]* paths of proofs; this says nothing about it$' out || fail "R2 was interrupted"
checks=$((checks + 1))
grep -q 'no violation found' out && fail "a requirement that was not decided counts as searched"

# A verdict is printed when it is known: it is there even if the process cannot end as it wants.
timeout -s KILL "$seconds" "$smc" prove a.sm a.rq --requirements=R3,R1,R2 --effort=1000000 >out 2>err
checks=$((checks + 1))
grep -q '^  R1  proved ' out && ! grep -q '^  R[23]' out || fail "the verdict on R1 was not printed when it was known"

interrupt "$seconds" --format=json -o verdicts
checks=$((checks + 1))
if [ "$code" != 130 ] || ! grep -q '"id":"R2".*"verdict":"interrupted".*"steps":[1-9]' verdicts; then
    cp verdicts out 2>/dev/null
    fail "in JSON, what was not decided is not interrupted"
fi
checks=$((checks + 1))
grep -q '"verdict":"undecided"' verdicts && fail "in JSON, a requirement that was not decided counts as searched"

# A signal during a proof that takes long: it comes after a short search.
cat >large.sm <<'END'
[options]
step 10 ms

[state_vector]
U64  time   @alias G
U32  state  @alias S
F64  p      @read_only
F64  key    @read_only
bool go     @read_only
U32  count
U32  other
bool valve

[local]
F64 a = 0

[Idle]
.step
    count = count + 1
    a = a * 31 + key * key
    a = a - 65521 * floor(a / 65521)
    T >= 40 ms and a == 40961 and held(key > 7, 9 s): -> Locked
    held(p > 5, 700 ms) and go: -> Wait

[Wait]
.step
    other = other + count
    T > 7 s and go: -> Idle
    held(p < 2, 300 ms): -> Idle

[Locked]
.entry
    valve = true
END
for n in 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29; do
    echo "P$n \"different\" never count == 4000000000 and other == 7$n and held(p > 3, 500 ms)"
done >large.rq
for seconds in 1 2 3; do
    timeout --preserve-status -s INT "$seconds" "$smc" prove large.sm large.rq --effort=1 >out 2>err
    checks=$((checks + 1))
    grep -q ' proved \| vacuous ' out && fail "a proof that was interrupted after $seconds s counts"
    checks=$((checks + 1))
    [ -s out ] && ! grep -q ' not decided ' out && fail "the proofs ended before $seconds s"
done

# A report has what was found until then.  The traceability matrix is not written.  On a fast computer the proofs have ended before a late signal.
printf '@step_all 10\n' >a.ss
for seconds in 2 1 0.5 0.25; do
    timeout --preserve-status -s INT "$seconds" "$smc" report a.sm a.rq --prove -o page.html >out 2>err
    code=$?
    [ "$code" = 130 ] && break
    rm -f page.html
done
checks=$((checks + 1))
[ "$code" = 130 ] || fail "report ends with $code"
checks=$((checks + 1))
if [ -e page.html ]; then
    grep -q 'not decided' page.html && ! grep -q 'no violation found' page.html || fail "in a report, a requirement that was not decided counts as searched"
fi
for seconds in 2 1 0.5 0.25; do
    timeout --preserve-status -s INT "$seconds" "$smc" test a.sm a.ss a.rq --traceability=trace.csv --prove >out 2>err
    code=$?
    [ "$code" = 130 ] && break
    rm -f trace.csv
done
checks=$((checks + 1))
[ "$code" = 130 ] && [ ! -e trace.csv ] || fail "test ends with $code, and may have written a matrix"

echo "interrupted proofs: $((checks - fails)) passed, $fails failed"
[ "$fails" = 0 ] && [ "$checks" -ge 16 ]
