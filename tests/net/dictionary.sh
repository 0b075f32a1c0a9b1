#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Programs that have only the dictionary of tests/runtime/link.net exchange messages with the runtime.
#         sh tests/net/dictionary.sh SMC PACKETS CC
smc=$1 packets=$2 cc=$3
passed=0 failed=0 skipped=0
root=$(pwd)
dir=$(mktemp -d "${TMPDIR:-/tmp}/smc-dictionary.XXXXXX") || exit 1
trap 'rm -rf "$dir"' EXIT
case $smc in /*) ;; *) smc=$root/$smc ;; esac
case $packets in /*) ;; *) packets=$root/$packets ;; esac
# is WHAT EXPECTED FOUND: a test.
is() { if test "$2" = "$3"; then passed=$((passed + 1)); else failed=$((failed + 1)); echo "dictionary: $1: expected '$2', found '$3'"; fi; }

cp "$root"/tests/runtime/link.* "$root"/tests/runtime/stream.* "$root"/tests/net/far.* "$dir" && cd "$dir" || exit 1
for form in json h py xml; do
    "$smc" emit-dictionary link.net --sv link.sv -o link.$form
    is "the form .$form" 0 $?
    "$smc" emit-dictionary link.net --sv link.sv -o link.$form
    is "the form .$form is recognised as smc's own" 0 $?
done
for strict in "-std=c99" "-std=c11 -O2"; do
    $cc $strict -Wall -Wextra -Wconversion -Wshadow -Wno-unused-function -pedantic -Werror far.c -o far
    is "the C header compiles with $strict" 0 $?
done
"$smc" emit-dictionary stream.net --sv stream.sv -o stream.json && "$smc" emit-dictionary stream.net --sv stream.sv -o stream.xml
is "who listens, in JSON" "tcp receiver tcp sender tcp receiver tcp sender" \
    "$(sed -n 's/.*"link":"\([a-z]*\)","listens":"\([a-z]*\)".*/\1 \2/p' stream.json | tr '\n' ' ' | sed 's/ $//')"
is "who listens, in XTCE" "tcp receiver 10.0.0.1:6001 tcp sender 0.0.0.0:6002 tcp receiver 127.0.0.1:6003 tcp sender 10.0.0.1:6004" \
    "$(sed -n 's/.*<AncillaryData name="[a-z]*">\(.*\)<.AncillaryData>/\1/p' stream.xml | tr '\n' ' ' | sed 's/ $//')"
is "by UDP, the receiver listens" "3" "$(grep -c '"link":"udp","listens":"receiver"' link.json)"
sent=$("$packets" </dev/null | head -1)
is "C" "cause 0: 12.75 -2.5 1 -3 -5000000000 65535
damaged 1, short 1" "$(echo "$sent" | ./far 2>command)"
"$packets" <command >received
is "a command from C" "0 0.25 -7 1e+06 18446744073709551615 accepted 1 refused 0" "$(tail -1 received)"
{ cat command; cat command; } | "$packets" >received
is "sent twice" "0 0.25 -7 1e+06 18446744073709551615 accepted 1 refused 1" "$(tail -1 received)"
if command -v python3 >/dev/null; then
    python3 far.py "$sent" >out 2>&1
    is "Python" "python [12.75, -2.5, True, -3, -5000000000, 65535]" "$(grep python out)"
    is "what Python refuses" "refused short refused long refused damaged" "$(grep refused out | tr '\n' ' ' | sed 's/ $//')"
    is "JSON" "json [12.75, -2.5, True, -3, -5000000000, 65535]" "$(grep json out)"
    is "XTCE" "xtce [12.75, -2.5, 1, -3, -5000000000, 65535] True" "$(grep xtce out)"
    sed -n 's/command //p' out | "$packets" >received
    is "a command from Python" "0 0.25 -7 1e+06 18446744073709551615 accepted 1 refused 0" "$(tail -1 received)"
else
    skipped=5
fi
echo "$passed passed, $failed failed, $skipped skipped"
test $failed = 0
