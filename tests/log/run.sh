#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# run.sh SMC WRITER FOLDER: what `smc log` shows of a flight that is the same each time (WRITER FILE writes it), and of files that are not
# logs.  UPDATE=1 writes the output to the expected files.
smc=$(cd "$(dirname "$1")" && pwd)/$(basename "$1"); writer=$(cd "$(dirname "$2")" && pwd)/$(basename "$2"); here=$(cd "$(dirname "$0")" && pwd)
passed=0; failed=0
mkdir -p "$3" && cd "$3" || exit 1

ok() { passed=$((passed + 1)); }
no() { failed=$((failed + 1)); echo "tests/log: $1" >&2; }

# same FILE ARGUMENT...: prints the contents of FILE of this folder, exit 0.
same()
{
    name=$1; shift
    "$smc" log "$@" >out 2>err || no "$name: exit $?"
    [ "${UPDATE:-}" = 1 ] && cp out "$here/$name"
    cmp -s out "$here/$name" && ok || no "$name differs: $(diff out "$here/$name" | head -5)"
}

# says CODE TEXT ARGUMENT...: exits with CODE, and prints TEXT on standard error.
says()
{
    code=$1; text=$2; shift 2
    "$smc" log "$@" >out 2>err; got=$?
    [ $got = "$code" ] || no "log $*: exit $got, not $code"
    if grep -qF -- "$text" err; then ok; else no "log $*: '$text' is not in '$(cat err)'"; fi
}

"$writer" flight.log || no "the flight was not written"
same text.txt flight.log
same element.txt flight.log --session 1 f64 flag
same table.csv flight.log --format csv --session 2 f64 flag i16
same lines.json flight.log --format json --session=2 f64
same plot.svg flight.log --format svg --session 1 f64 flag

# A record a second: states begin at the times of their events, and a state shorter than a second is included.
"$writer" flight.log rare.log || no "the rare flight was not written"
"$smc" log rare.log --format svg f64 >rare.svg || no "the rare flight was not drawn"
for part in '<rect class="s0" x="64" y="0" width="266.9" height="22"/>' '<rect class="s1" x="330.9" y="0" width="44.2" height="22"/>' \
    '<circle class="begin" cx="330.9" cy="98.9"' '<circle class="begin" cx="375.1" cy="98.9"'; do
    grep -qF -- "$part" rare.svg && ok || no "rare.svg: no $part"
done
"$smc" log rare.log | grep -q 'f32 .* 0 .. 9, from 0 to 9, nan in 2 records' && ok || no "records with nan are not counted"
"$smc" log rare.log --format svg f32 >nan.svg && grep -q 'not a number (nan) in the gaps' nan.svg &&
    grep -q 'class="trace" d="M64 [^M]*M[^M]*"' nan.svg && ok || no "the curve has no gap at nan"
"$smc" log rare.log >rare.txt
for part in 'recovered after 1 failure$' 'skipped 1 tick$'; do
    grep -q "$part" rare.txt && ok || no "rare.txt: no $part"
done
"$smc" log rare.log | grep -q 'started; the saved state vector could not be used' && ok || no "a saved state vector that could not be used is not reported"

rm -f out.csv
"$smc" log flight.log -o out.csv 2>err && head -1 out.csv | grep -q '^session,seconds,time,state' && ok || no "the format is not taken from the ending"

says 0 "this is the last of 2 sessions" flight.log --format csv
says 1 "unknown element 'f65'; did you mean 'f64'?" flight.log f65
says 1 "unknown machine 'mision'; did you mean 'mission'?" flight.log --machine mision
says 1 "there is no session 3; it has 2" flight.log --session 3
says 2 "--session requires a number" flight.log --session first
says 2 "as in 'smc log flight.log'"
says 2 "csv" flight.log --format html
says 3 "cannot read 'nothing.log'" nothing.log

# Damage is reported, and undamaged parts are shown.
head -c 20000 flight.log >torn.log
says 0 "are an incomplete block" torn.log
{ head -c 9000 flight.log; printf xxxx; tail -c +9005 flight.log; } >damaged.log
says 0 "bytes are damaged; the intact blocks are shown" damaged.log
# A file that was crafted to cost time: 100 heads that claim 24,700 bytes of events each.
{ head -c 5000 flight.log; i=0; while [ $i -lt 100 ]; do printf '\245E\174\140\0\0'; i=$((i + 1)); done; tail -c +5001 flight.log; } >crafted.log
says 0 "bytes were not read" crafted.log
grep -q ', [0-9]* bytes not read$' out && ok || no "the summary of crafted.log does not count unread bytes"
: >empty.log
says 1 "the file is empty" empty.log
printf 'time,altitude\n0,1\n' >other.log
says 1 "the file does not begin as a flight log does" other.log
says 1 "the file does not begin as a flight log does" - <other.log
echo "log: $passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
