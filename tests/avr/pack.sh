#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Makes a program of a firmware: the emulator, and behind it what run_c.c wants there.      pack.sh RUN_C MCU PROGRAM.elf PROGRAM
avr-objcopy -O binary "$3" "$4.bin" || exit 1
size=$(wc -c <"$4.bin")
{
    cat "$1" "$4.bin"
    printf '%-16s' "$2" | tr ' ' '\000'
    for shift in 0 8 16 24; do printf "\\$(printf %03o $((size >> shift & 255)))"; done
} >"$4" && chmod +x "$4" && rm -f "$4.bin"
