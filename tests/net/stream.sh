#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Two applications in two processes, with TCP connections through a relay that cuts them, divides what it passes, and damages some of it.
# Programs that have only the dictionary receive from the sender, too.  Then the receiver stops, dies and starts again.
#         sh tests/net/stream.sh SMC LINUX.a CC
smc=$1 linux=$2 cc=$3
passed=0 failed=0 skipped=0
root=$(pwd)
dir=$(mktemp -d "${TMPDIR:-/tmp}/smc-stream.XXXXXX") || exit 1
case $smc in /*) ;; *) smc=$root/$smc ;; esac
case $linux in /*) ;; *) linux=$root/$linux ;; esac
pids=
trap 'for p in $pids; do kill -9 $p 2>/dev/null; done; rm -rf "$dir"' EXIT

good() { passed=$((passed + 1)); }
bad() { failed=$((failed + 1)); echo "stream: $1"; }
# is WHAT CONDITION: a test.
is() { if eval "$2"; then good; else bad "$1: $2"; fi }

# builds NAME TASK: the application NAME with the task in TASK.c.
builds()
{
    "$smc" build "$1.app" -o "$1" -Werror && $cc -std=c99 -D_GNU_SOURCE -O1 -Wall -Wextra -Werror -I"$root" -I"$1" -o "$1.out" "$1"/*.c "$2.c" "$linux" -pthread -lrt
}

cp "$root"/tests/net/*.sv "$root"/tests/net/*.app "$root"/tests/net/*.c "$root"/tests/net/far_stream.py "$dir" &&
    cp "$root"/tests/net/stream_sender.net "$dir"/sender.net && cp "$root"/tests/net/stream_receiver.net "$dir"/receiver.net && cd "$dir" || exit 1
relay=$((20000 + $$ % 20000)) direct=$((relay + 1)) offers=$((relay + 2))
sed -i "s/RELAY/$relay/; s/DIRECT/$direct/; s/OFFERS/$offers/" sender.net receiver.net
"$smc" emit-dictionary sender.net --sv link.sv -o sender_dictionary.h && "$smc" emit-dictionary sender.net --sv link.sv -o sender_dictionary.py
is "the dictionaries" 'test -s sender_dictionary.h && test -s sender_dictionary.py'
if builds sender source && builds receiver watch && $cc -std=c99 -O1 -Wall -Wextra -Werror -o relay.out relay_stream.c &&
   $cc -std=c99 -O1 -Wall -Wextra -Werror -D_GNU_SOURCE -o far.out far_stream.c; then good; else bad "the parts cannot be built"; exit 1; fi

# receives: starts the receiver, which answers questions from a pipe.
mkfifo ask
receives() { ./receiver.out <ask >>heard & receiver=$!; pids="$pids $receiver"; exec 3>ask; }

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

./sender.out & sender=$!; pids="$pids $sender"
sleep 0.3
receives
./relay.out $relay $direct 1 >relayed & pids="$pids $!"
sleep 8
answer
is "connections that are cut and damaged" 'test $wrong = 0 && test $accepted -gt 200'
is "a receiver counts damage" 'test $((damaged + hash)) -gt 0 && test $short -gt 0 && test $((damaged + repeated + late + short + hash)) = $refused'
is "connections were made again" 'test $connected -gt 3 && test $broken -gt 2'
is "the relay cut connections" 'test $(grep -c cut relayed) -gt 2'
is "hears" 'test "$(grep -c hears heard)" -ge 1'

# ---- programs that have only the dictionary ----

./far.out $offers 50 >far_c 2>&1
is "a receiver in C" 'test "$(tail -1 far_c)" = "50 messages"'
if command -v python3 >/dev/null; then
    python3 far_stream.py $offers 50 >far_py 2>&1
    is "a receiver in Python" 'test "$(tail -1 far_py)" = "50 messages"'
else
    skipped=$((skipped + 1))
fi

# ---- a receiver that stops, dies, and starts again ----

kill -STOP $receiver
sleep 1.5
kill -CONT $receiver
sleep 1
answer
is "a receiver that stopped" 'test $wrong = 0'
kill -9 $receiver
exec 3>&-
sleep 0.5
rm -f ask && mkfifo ask
receives
sleep 4
answer
is "a receiver that starts again" 'test $wrong = 0 && test $accepted -gt 20'
is "the sender still runs" 'kill -0 $sender'
exec 3>&-
echo "$passed passed, $failed failed, $skipped skipped"
test $failed = 0
