#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# N random programs from SEED on, as images streamed into one firmware on an emulated ATmega1284P, in lock step with the VM here: from flash,
# where no step may take more cycles than is estimated of its machine, and from EEPROM.     campaign.sh BUILD N SEED
# Goes on where it was stopped.  Wants the firmware and the runner that run.sh builds.
B=$1/avr N=${2:-10000} SEED=${3:-1}
done_file=$B/campaign-$SEED images=$B/campaign-images BATCH=100
read -r program passed skipped 2>/dev/null <"$done_file" || program=$SEED passed=0 skipped=0
export ASAN_OPTIONS=detect_leaks=0             # libsimavr forgets what it read of the firmware
export AVR_MCU=atmega1284p                     # as in run.sh: the chip for which it has built the firmware

make_image() {
    "$1/diff/difftest" --seed="$2" --print --out="$B/campaign-program" >/dev/null || return 1
    sv=$(ls "$B"/campaign-program/*.sv 2>/dev/null)
    "$1/smc" build -w "$B"/campaign-program/*.sm ${sv:+--sv "$sv"} -O$(($2 % 3)) -o "$images/$2.smb" || return 1
    rm -rf "$B/campaign-program"
}

while [ "$program" -lt $((SEED + N)) ]; do
    rm -rf "$images" "$B/campaign-program"
    mkdir -p "$images"
    last=$((program + BATCH))
    [ "$last" -le $((SEED + N)) ] || last=$((SEED + N))
    while [ "$program" -lt "$last" ]; do
        make_image "$1" "$program" || exit 1
        program=$((program + 1))
    done
    for kind in vm vm_eeprom; do
        ESTIMATE=1 "$B/run_vm" "$B/$kind.elf" 60 0 0 "$images"/*.smb >"$B/campaign.txt" || { tail -20 "$B/campaign.txt"; exit 1; }
    done
    set -- "$1" $(tail -1 "$B/campaign.txt")
    passed=$((passed + $2 - 1)) skipped=$((skipped + $6))       # one of them was the loads and stores alone
    echo "$program $passed $skipped" >"$done_file"
done
echo "avr-campaign: $passed passed, 0 failed, $skipped had no room"
