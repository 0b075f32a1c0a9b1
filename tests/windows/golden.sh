#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# The golden cases with smc.exe under Wine, with the cross compiler as its cc.  exceptions.txt names those that differ, with the reason; each of them must still differ, else it is
# reported as one too many.     golden.sh MAKE BUILD CC MACHINE
make=$1 build=$2 cc=$3 machine=$4
. tests/windows/wine.sh
. tests/windows/relay.sh
cases= excepted=
for case in tests/golden/*.smt; do
    name=$(basename "$case" .smt)
    if grep -q "^$name  " tests/windows/exceptions.txt; then excepted="$excepted $case"; else cases="$cases $case"; fi
done
for name in $(sed -n 's/^\([a-z0-9-]*\)  .*/\1/p' tests/windows/exceptions.txt); do
    [ -f "tests/golden/$name.smt" ] || { echo "exceptions.txt: there is no case $name: 0 passed, 1 failed"; exit 1; }
done
# Two at a time: most of the time is spent on starting Wine.
half=$(($(echo $cases | wc -w) / 2))
"$build/golden" "$smc" $(echo $cases | tr ' ' '\n' | head -n $half) >"$folder/golden.1" 2>&1 &
first=$!
"$build/golden" "$smc" $(echo $cases | tr ' ' '\n' | tail -n +$((half + 1))) >"$folder/golden.2" 2>&1
second=$?
wait $first || second=1
grep -hv '^golden: ' "$folder/golden.1" "$folder/golden.2"
# Under load a winedevice.exe of Wine can crash, and prints so on the standard error of a command.  The address is in ntoskrnl.exe of Wine 8.0, which no
# other process loads (0x31ca90000 to 0x31cbbd000).  Only cases with this line are run again, once.
again=$(awk '/^tests\/golden\/.*: failed$/ { name = substr($0, 1, length($0) - 8) }
    /^wine: Unhandled page fault .* at address 000000031C[AB][0-9A-F]*/ && !seen[name]++ { print name }' "$folder/golden.1" "$folder/golden.2")
: >"$folder/golden.4"
if [ "$again" ]; then
    "$build/golden" "$smc" $again >"$folder/golden.4" 2>&1
    cat "$folder/golden.4"
fi
"$build/golden" "$smc" $excepted >"$folder/golden.3" 2>&1
fit=$(sed -n 's/^golden: \([0-9]*\) passed.*/\1/p' "$folder/golden.3")
[ "$fit" -eq 0 ] || echo "$fit cases of exceptions.txt pass: remove them there"
fixed=$(sed -n 's/^golden: \([0-9]*\) passed.*/\1/p' "$folder/golden.4")
cat "$folder/golden.1" "$folder/golden.2" | awk -v second=$second -v fit="$fit" -v fixed="${fixed:-0}" '/^golden: / { p += $2; f += $4 }
    END { if (second && f == 0) f = 1; p += fixed; f += fit - fixed; printf "windows-golden: %d passed, %d failed\n", p, f; exit f != 0 || p == 0 }'
