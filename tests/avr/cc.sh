#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# A C compiler whose programs run on an emulated ATmega328P, or on an ATmega1284P (the same core) where they do not fit there:
#     cc.sh RUN_C [OPTION…] -o PROGRAM SOURCE.c        RUN_C is built from run_c.c; AVR_CC names the compiler
root=$(cd "$(dirname "$0")/../.." && pwd)
[ "$1" = --version ] && exec "${AVR_CC:-avr-gcc}" --version
run=$1 out= options= source=
shift
while [ $# -gt 0 ]; do
    case $1 in
    -o) out=$2; shift ;;
    *.c) source=$1 ;;
    -O*) ;;
    *) options="$options $1" ;;
    esac
    shift
done

# build MCU FLASH RAM: fails if the program does not fit
build() {
    "${AVR_CC:-avr-gcc}" -mmcu=$1 -Os -std=gnu99 -DSM_IN_FLASH=__flash -ffunction-sections -fdata-sections -Wl,--gc-sections -w $options \
        "$source" "$root/tests/avr/console.c" "$root/stdlib/soft_avr.S" "$root/stdlib/soft_cells_avr.S" "$root/stdlib/soft_sqrt_avr.S" -I"$root" -o "$out.elf" 2>"$out.log" || {
        grep -q 'overflowed by\|will not fit in region\|is not within region\|is too large' "$out.log" && return 1
        cat "$out.log"
        exit 1
    }
    set -- "$@" $(avr-size "$out.elf" | tail -1)
    [ $(($4 + $5)) -le $2 ] && [ $(($5 + $6)) -le $3 ]
}

if build atmega328p 32768 1600; then
    mcu=atmega328p
elif build atmega1284p 131072 15000; then
    mcu=atmega1284p
else
    echo "does not fit"
    exit 77
fi
[ -n "$AVR_CHIPS" ] && echo $mcu >>"$AVR_CHIPS"
sh "$root/tests/avr/pack.sh" "$run" $mcu "$out.elf" "$out" || exit 1
rm -f "$out.elf" "$out.log"
