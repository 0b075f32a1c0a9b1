#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# A seed for tests/fuzz/link.c: an update of a board with SLOTS slots to IMAGE, from HELLO to CONFIRM.     link_seed.sh SLOTS IMAGE >FILE
bytes() { for b; do printf "\\$(printf %03o "$b")"; done; }

# message NUMBER BYTE…: a frame's body in the form of the target: its length, the request, the bytes
message() {
    number=$1
    shift
    bytes $# "$number" "$@"
}

slots=$1
# shellcheck disable=SC2046
set -- $(od -An -v -tu1 "$2")
checksum="$5 $6 $7 $8" length="$9 ${10} ${11}"      # of the header: SMVM_CRC_AT, SMVM_LENGTH_AT
bytes $(((slots - 1) * 2))
message 1                                           # HELLO
message 16 5 0 $length $checksum                    # BEGIN of session 5
at=0
while [ $# -gt 0 ]; do
    block=
    first=$at
    while [ $# -gt 0 ] && [ $((at - first)) -lt 32 ]; do
        block="$block $1"
        shift
        at=$((at + 1))
    done
    message 17 5 0 $((first % 256)) $((first / 256)) 0 $block       # DATA
done
message 18 5 0                                      # END
message 19 5 0 0 0                                  # ACTIVATE
message 23                                          # RESTART
message 2 0                                         # IMAGE
message 20 $checksum                                # CONFIRM
message 32 0 0 0 0                                  # EVENTS
