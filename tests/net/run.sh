#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Two applications in two processes, with a relay between them that loses, delays, repeats, reorders and damages messages.  Then the sender
# dies, the network is flooded, and the sender starts again.        sh tests/net/run.sh SMC LINUX.a CC
smc=$1 linux=$2 cc=$3
passed=0 failed=0
root=$(pwd)
dir=$(mktemp -d "${TMPDIR:-/tmp}/smc-net.XXXXXX") || exit 1
case $smc in /*) ;; *) smc=$root/$smc ;; esac
case $linux in /*) ;; *) linux=$root/$linux ;; esac
pids=
trap 'for p in $pids; do kill -9 $p 2>/dev/null; done; rm -rf "$dir"' EXIT

good() { passed=$((passed + 1)); }
bad() { failed=$((failed + 1)); echo "net: $1"; }
# is WHAT CONDITION: a test.
is() { if eval "$2"; then good; else bad "$1: $2"; fi }

# builds NAME TASK: the application NAME with the task in TASK.c.
builds()
{
    "$smc" build "$1.app" -o "$1" -Werror && $cc -std=c99 -D_GNU_SOURCE -O1 -Wall -Wextra -Werror -I"$root" -I"$1" -o "$1.out" "$1"/*.c "$2.c" "$linux" -pthread -lrt
}

cp "$root"/tests/net/*.sv "$root"/tests/net/*.app "$root"/tests/net/*.net "$root"/tests/net/*.c "$dir" && cd "$dir" || exit 1
relay=$((20000 + $$ % 20000)) direct=$((relay + 1))
sed -i "s/RELAY/$relay/; s/DIRECT/$direct/" sender.net receiver.net
if builds sender source && builds receiver watch && $cc -std=c99 -O1 -Wall -Wextra -Werror -o relay.out relay.c; then good; else bad "the parts cannot be built"; exit 1; fi

mkfifo ask
./receiver.out <ask >heard & pids="$pids $!"
exec 3>ask
./relay.out $relay $direct 1 & relaying=$!; pids="$pids $relaying"
./sender.out & sender=$!; pids="$pids $sender"

# answer: asks the receiver, and sets accepted, refused, ... and ticks.
answer()
{
    lines=$(grep -c accepted heard)
    printf '?' >&3
    for i in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20; do
        test "$(grep -c accepted heard)" -gt "$lines" && break
        sleep 0.1
    done
    set -- $(grep accepted heard | tail -1)
    while test $# -gt 1; do eval "$1=$2"; shift 2; done
}

sleep 3
answer
is "a bad network" 'test $wrong = 0 && test $accepted -gt 200'
is "each fault occurred" 'test $damaged -gt 10 && test $repeated -gt 10 && test $late -gt 10 && test $short -gt 10 && test $long -gt 10'
is "the sum of the causes" 'test $((damaged + repeated + late + short + long)) = $refused'
is "hears" 'test "$(grep -c hears heard)" -ge 1'

kill -9 $sender
sleep 1
answer
is "the sender died" 'test "$(tail -2 heard | head -1)" = silent && test $wrong = 0'
before=$accepted ticked=$ticks refusals=$refused
./relay.out 0 $direct 7 1500 >flooded
answer
is "a flood" 'test $accepted = $before && test $wrong = 0 && test $((refused - refusals)) -gt 1000'
is "a flood delays no step" 'test $((ticks - ticked)) -gt 1400'
is "the flood was one" 'test $(sed "s/[^0-9]//g" flooded) -gt 20000'

./sender.out & sender=$!; pids="$pids $sender"
sleep 1
answer
is "the sender starts again" 'test $accepted -gt $((before + 100)) && test $wrong = 0 && test "$(grep -v accepted heard | tail -1)" = hears'
exec 3>&-
echo "$passed passed, $failed failed"
test $failed = 0
