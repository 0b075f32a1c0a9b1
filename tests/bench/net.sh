#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# `make bench-net`: what 10 messages in 1 ms cost, beside the system calls of the same traffic, in the same run:  net.sh BUILD CC SMC
# Prints the least of ROUNDS runs of each, which alternate: nanoseconds a tick, per cent of a core at 1 kHz, and their ratio.
build=$1 cc=$2 smc=$3 rounds=${ROUNDS:-9} ticks=${TICKS:-20000}
dir=$build/bench/net
mkdir -p "$dir"

for i in 1 2 3 4 5; do
    printf '[M%d]\nF64 a%d\nF64 b%d\nF64 c%d\nF64 d%d\nF64 e%d\n' $i $i $i $i $i $i
done >"$dir/traffic.sv"
for i in 1 2 3 4 5; do echo "receive m$i on 127.0.0.1:4720$i { [M$i] }"; done >"$dir/traffic_in.net"
for i in 1 2 3 4 5; do echo "send m$i every 1 ms to 127.0.0.1:4720$i { [M$i] }"; done >"$dir/traffic_out.net"
"$smc" build --emit=c --runtime -w -o "$dir/traffic.c" "$dir/traffic.sv" || exit 1
for part in in out; do
    "$smc" build --emit=c --sv "$dir/traffic.sv" -o "$dir/traffic_${part}_net.c" "$dir/traffic_$part.net" || exit 1
done
# shellcheck disable=SC2046
$cc -std=c99 -ffp-contract=off -O2 -I. -I"$dir" tests/bench/net.c "$dir"/traffic.c "$dir"/traffic_*_net.c runtime-c/net.c runtime-c/net_message.c \
    runtime-c/net_stream.c runtime-c/statevec.c $(ls runtime-c/psl/linux/*.c | grep -v watchdog_process) stdlib/result.c -o "$dir/net" -pthread -lrt || exit 1

i=0
: >"$dir/times"
while [ $i -lt "$rounds" ]; do
    for kind in calls runtime; do
        ns=$("$dir/net" $kind "$ticks") || { echo "bench-net: $kind failed"; exit 1; }
        echo "$kind $ns" >>"$dir/times"
    done
    i=$((i + 1))
done
awk '!($1 in least) || $2 < least[$1] { least[$1] = $2 }
    END {
        printf "%-10s %12s %18s\n", "", "ns a tick", "of a core (1 kHz)"
        printf "%-10s %12d %17.2f%%\n%-10s %12d %17.2f%%\n", "calls", least["calls"], least["calls"] / 10000, "runtime", least["runtime"], least["runtime"] / 10000
        printf "ratio %.2f\n", least["runtime"] / least["calls"]
    }' "$dir/times"
