#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# A message to a multicast group, from one process to two others, on the loopback interface of this computer.  Skipped, with the reason, where
# the system does not allow that.        sh tests/net/multicast.sh SMC LINUX.a CC
smc=$1 linux=$2 cc=$3
passed=0 failed=0
root=$(pwd)
dir=$(mktemp -d "${TMPDIR:-/tmp}/smc-multicast.XXXXXX") || exit 1
case $smc in /*) ;; *) smc=$root/$smc ;; esac
case $linux in /*) ;; *) linux=$root/$linux ;; esac
pids=
trap 'for p in $pids; do kill -9 $p 2>/dev/null; done; rm -rf "$dir"' EXIT

# is WHAT CONDITION: a test.
is() { if eval "$2"; then passed=$((passed + 1)); else failed=$((failed + 1)); echo "multicast: $1: $2"; fi }

builds()
{
    "$smc" build "$1.app" -o "$1" -Werror && $cc -std=c99 -D_GNU_SOURCE -O1 -Wall -Wextra -Werror -I"$root" -I"$1" -o "$1.out" "$1"/*.c "$2.c" "$linux" -pthread -lrt
}

cp "$root"/tests/net/*.sv "$root"/tests/net/*.app "$root"/tests/net/*.net "$root"/tests/net/*.c "$dir" && cd "$dir" || exit 1
port=$((20000 + $$ % 20000))
sed -i "s/127.0.0.1:RELAY/239.77.12.3:$port @interface 127.0.0.1/" sender.net
sed -i "s/127.0.0.1:DIRECT/239.77.12.3:$port @interface 127.0.0.1/" receiver.net
is "the parts are built" 'builds sender source && builds receiver watch'
mkfifo ask1 ask2
./receiver.out <ask1 >heard1 2>errors1 & first=$!
./receiver.out <ask2 >heard2 2>errors2 & pids="$pids $first $!"
exec 3>ask1 4>ask2
sleep 0.5
if ! kill -0 $first 2>/dev/null && grep -q "there is no such" errors1; then
    echo "multicast: this computer has no interface for groups: $(head -1 errors1)"
    echo "$passed passed, $failed failed, 1 skipped"
    test $failed = 0
    exit
fi
./sender.out & pids="$pids $!"
sleep 2
printf '?' >&3
printf '?' >&4
sleep 0.5
for i in 1 2; do
    line=$(grep accepted heard$i | tail -1)
    count=$(echo "$line" | sed 's/accepted \([0-9]*\) refused 0 .* wrong 0 .*/\1/')
    is "receiver $i ($line)" 'test "$count" -gt 300 && test "$(grep -c hears heard$i)" = 1'
done
exec 3>&- 4>&-
echo "$passed passed, $failed failed, 0 skipped"
test $failed = 0
