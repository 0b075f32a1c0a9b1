#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# The Arduino library built by `make arduino`: the content of its files, that its archive is complete, and that it builds where it is unpacked, for
# boards that are here as compilers; the examples run on emulated boards, step for step as the script engine does.
#   run.sh BUILD LIBRARY VERSION
# CC and CXX name the compilers of this computer.  Wants zip, arduino-builder arduino-core-avr, libsimavr-dev libelf-dev, gcc-arm-none-eabi
# libnewlib-arm-none-eabi, gcc-riscv64-unknown-elf picolibc-riscv64-unknown-elf; tests without their tools are skipped.
build=$1 library=$2 version=$3
CC=${CC:-cc} CXX=${CXX:-c++}
mkdir -p "$build/arduino/test" || exit 1
dir=$(cd "$build/arduino/test" && pwd)
export ASAN_OPTIONS=detect_leaks=0             # libsimavr forgets what it read of the firmware
find "$dir" -mindepth 1 -maxdepth 1 ! -name core -exec rm -rf {} +         # the cores of the boards take most of the time
mkdir -p "$dir/libraries" "$dir/core" || exit 1

. tests/checks.sh

# ---- what describes it ----

field() { sed -n "s/^$1=//p" "$library/library.properties"; }
json() { sed -n "s/^  \"$1\": \"\([^\"]*\)\".*/\1/p" "$library/library.json"; }
for f in name version author maintainer sentence paragraph category architectures includes dot_a_linkage; do
    check "library.properties says $f, once" test "$(field $f | grep -c .)" = 1
done
check "library.properties has a url, that of the project or none" sh -c "test \"\$(grep -c '^url=' '$library/library.properties')\" = 1 && test '$(field url)' = '$(json homepage)'"
check "no address is invented" sh -c "! grep -rn 'example\.org\|](/blob' '$library'"
check "library.properties has no other line" test "$(wc -l <"$library/library.properties")" = 11
check "the name is allowed in the index" sh -c "echo '$(field name)' | grep -Eq '^[A-Za-z0-9][A-Za-z0-9 _.-]{0,62}$'"
check "the category is one that is known" sh -c "echo '$(field category)' |
    grep -Exq 'Display|Communication|Signal Input/Output|Sensors|Device Control|Timing|Data Storage|Data Processing|Other'"
check "the version is smc's" test "$(field version) $(json version)" = "$version $version"
check "names and sentences agree" test "$(field name) $(field sentence) $(field includes)" = "$(json name) $(json description) $(json headers)"
check "what is to be included is there" test -f "$library/src/$(field includes)"
check "the fields of keywords.txt stand apart by one tab" awk -F '\t' \
    '/^#/ || /^$/ { next } NF != 2 || $1 !~ /^[A-Za-z_0-9]+$/ || $2 !~ /^(KEYWORD[123]|LITERAL1)$/ { exit 1 }' "$library/keywords.txt"
for word in $(sed -n 's/^\([A-Za-z_0-9]*\)\t.*/\1/p' "$library/keywords.txt"); do
    check "$word is in the library" grep -rqw "$word" "$library/src"
done
if has python3; then
    check "library.json is JSON" python3 -m json.tool "$library/library.json"
else
    skip "no python3 here"
fi

# ---- the archive ----

(cd "$library/.." && find smc -type f | LC_ALL=C sort) >"$dir/files"
(cd "$library/src" && find . -type f | sed 's|^\./||' | LC_ALL=C sort) >"$dir/sources"
while read -r f; do
    test "$f" = safe_image.inc || check "src/$f is as it is in the tree" cmp "$library/src/$f" "$(test -f "$f" && echo "$f" || echo "arduino/$f")"
    case $f in
    *.c | *.S | smc.h | smc_config.h) ;;
    *) check "src/$f is used" grep -rqF "#include \"$f\"" "$library/src" ;;
    esac
done <"$dir/sources"
if has unzip && test -f "$library.zip"; then
    unzip -Z1 "$library.zip" | LC_ALL=C sort >"$dir/zipped"
    check "the archive has every file and no other" cmp "$dir/files" "$dir/zipped"
    unzip -q "$library.zip" -d "$dir/libraries"
else
    skip "no zip and unzip here (apt-get install both)"
    cp -r "$library" "$dir/libraries"
fi
src=$dir/libraries/smc/src examples=$dir/libraries/smc/examples

bytes_of() { sed -n 's/^    0x\(.*\)/0x\1/p' "$1" | sed 's/0x//g' | tr -d ', \n'; }
check "an image is made" "$build/smc" build -w "$library/examples/TankImage/tank.sm" -o "$dir/tank.smb"
check "the array is the image" test "$(bytes_of "$library/examples/TankImage/tank_image.h")" = "$(od -An -v -tx1 "$dir/tank.smb" | tr -d ' \n')"

# ---- other boards: it compiles, without a tree around it ----

WARN="-Wall -Wextra -Wno-unused-function"
compiles()  # PREFIX FLAGS…: library and examples
{
    prefix=$1
    shift
    for f in $(cd "$src" && find . -name '*.c' -o -name '*.S'); do
        $prefix -std=gnu11 -Os $WARN -Werror "$@" -DARDUINO=10800 -I"$src" -c "$src/$f" -o "$dir/object.o" || return 1
    done
    for sketch in "$examples"/*/*.ino; do
        for f in "$(dirname "$sketch")"/*.c; do
            test ! -f "$f" || $prefix -std=gnu11 -Os $WARN -Werror "$@" -DARDUINO=10800 -c "$f" -o "$dir/object.o" || return 1
        done
    done
}
sketches()  # CXX FLAGS…
{
    cxx=$1
    shift
    for sketch in "$examples"/Tank*/*.ino; do
        $cxx -x c++ -std=gnu++11 -Os $WARN -Werror "$@" -DARDUINO=10800 -Itests/arduino -I"$src" -include Arduino.h -c "$sketch" -o "$dir/object.o" || return 1
    done
}
refuses_firmware()      # CXX FLAGS…: says on which boards it runs
{
    cxx=$1
    shift
    ! $cxx -x c++ -std=gnu++11 "$@" -DARDUINO=10800 -Itests/arduino -I"$src" -include Arduino.h -fsyntax-only "$examples/Firmware/Firmware.ino" 2>"$dir/refused.txt" &&
        grep -q '#error "smc.s firmware runs on an Uno, a Nano or a Pro Mini (ATmega328P) and on a Mega (ATmega2560), at 16 or 8 MHz' "$dir/refused.txt"
}
board()     # NAME CC CXX FLAGS…
{
    name=$1 cc=$2 cxx=$3
    shift 3
    if has "$cc"; then check "the library for $name" compiles "$cc" "$@"; else skip "no $cc here (apt-get install gcc-arm-none-eabi libnewlib-arm-none-eabi gcc-avr avr-libc)"; fi
    if ! has "$cxx"; then
        skip "no $cxx here"
        return
    fi
    check "the sketches for $name" sketches "$cxx" "$@"
    check "Firmware for $name is refused" refuses_firmware "$cxx" "$@"
}
# numbers WHERE CC FLAGS…: whether the numbers of TankC are the board's `double` or are computed in software
numbers()
{
    where=$1 cc=$2
    shift 2
    $cc -std=gnu11 -Os "$@" -DARDUINO=10800 -c "$examples/TankC/tank.c" -o "$dir/tank.o" || return 1
    case $where in
    soft) $nm "$dir/tank.o" | grep -q sm_soft_ ;;
    double) $nm "$dir/tank.o" | grep -q tank_step && ! $nm "$dir/tank.o" | grep -q sm_soft_ ;;
    esac
}
board "Cortex-M0+ (Zero)" arm-none-eabi-gcc arm-none-eabi-g++ -mcpu=cortex-m0plus -mthumb
board "Cortex-M7 (Teensy 4, Giga)" arm-none-eabi-gcc arm-none-eabi-g++ -mcpu=cortex-m7 -mthumb -mfpu=fpv5-d16 -mfloat-abi=hard
board "a Leonardo" avr-gcc avr-g++ -mmcu=atmega32u4 -DF_CPU=16000000UL
board "a Digispark" avr-gcc avr-g++ -mmcu=attiny85 -DF_CPU=16000000UL
board "an Uno of 20 MHz" avr-gcc avr-g++ -mmcu=atmega328p -DF_CPU=20000000UL
if has arm-none-eabi-gcc && has avr-gcc; then
    nm=arm-none-eabi-nm
    check "TankC on a Cortex-M7 has doubles" numbers double arm-none-eabi-gcc -mcpu=cortex-m7 -mthumb -mfpu=fpv5-d16 -mfloat-abi=hard
    check "TankC on a Cortex-M0+ has doubles" numbers double arm-none-eabi-gcc -mcpu=cortex-m0plus -mthumb
    check "TankC on a Cortex-M3 (Due) has soft numbers" numbers soft arm-none-eabi-gcc -mcpu=cortex-m3 -mthumb
    nm=avr-nm
    check "TankC on an Uno has soft numbers" numbers soft avr-gcc -mmcu=atmega328p
else
    skip "no arm-none-eabi-gcc and avr-gcc here"
fi
if has riscv64-unknown-elf-gcc && echo '#include <string.h>' | riscv64-unknown-elf-gcc --specs=picolibc.specs -fsyntax-only -x c - 2>/dev/null; then
    check "the library for RV32 (ESP32-C3)" compiles riscv64-unknown-elf-gcc --specs=picolibc.specs -march=rv32imc -mabi=ilp32
else
    skip "no riscv64-unknown-elf-gcc with picolibc here (apt-get install gcc-riscv64-unknown-elf picolibc-riscv64-unknown-elf)"
fi
printf '#include "tank.h"\n#include <smc.h>\n' >"$dir/order.c"
check "the machine before the library is refused" sh -c "! $CC -I$src -I$examples/TankImage -fsyntax-only $dir/order.c 2>'$dir/order.txt' &&
    grep -q 'include <smc.h> before the header of a machine' '$dir/order.txt'"
# Where the chip has a fused multiply-add, gnu11 would use it, and the Arduino tools take no options.
fused() { arm-none-eabi-gcc -std=gnu11 -O2 -mcpu=cortex-m7 -mthumb -mfpu=fpv5-d16 -mfloat-abi=hard "$@" -I"$src" -S "$dir/fused.c" -o - | grep -c vfma; }
printf 'double plain(double a, double b, double c) { return a * b + c; }\n#include "stdlib/f64.h"\nSmF64 f(SmF64 a, SmF64 b, SmF64 c) { return sm_add(sm_mul(a, b), c); }\n' >"$dir/fused.c"
if has arm-none-eabi-gcc; then
    check "a * b + c is rounded twice on a Cortex-M7" test "$(fused -DARDUINO=10800)" = 1          # that of plain C before it
fi

# ---- the examples, against the script engine ----

# What the sketch of that name should print: pressure, state, valve.  (A trace has numbers in C's %a.)
values() { sed -n "s/^[0-9]* $1 //p" "$dir/trace"; }
expect()
{
    "$build/smc" test -w --engine=all "$examples/$1/tank.sm" tests/arduino/plant.ss --trace="$dir/trace" --trace-format=exact >/dev/null || return 1
    values tankPressure | xargs printf '%.0f\n' >"$dir/pressure"
    values S >"$dir/state"
    values valveOpen | sed 's/true/1/; s/false/0/' | paste -d ' ' "$dir/pressure" "$dir/state" - >"$dir/$1.expected"
}

library_here()
{
    for f in $(cd "$src" && find . -name '*.c'); do
        $CC -std=gnu11 -O1 -I"$src" -c "$src/$f" -o "$dir/$(echo "$f" | tr / _).o" || return 1
    done
    ar rcs "$dir/smc.a" "$dir"/._*.o
}
# The sketch with the decoded form of its machine, as docs/arduino.md describes it.
decoded_here()
{
    mkdir -p "$dir/decoded" && cp "$examples/TankImage/"*.h "$dir/decoded" || return 1
    sed -n '/^```c decoded$/,/^```$/ { /^```/!p; }' docs/arduino.md >"$dir/decoded/lines"
    test "$(grep -c . "$dir/decoded/lines")" = 4 || return 1
    { sed -n '1,/^TankSv sv/p' "$examples/TankImage/TankImage.ino" && sed -n 1,2p "$dir/decoded/lines" &&
        sed '1,/^TankSv sv/d' "$examples/TankImage/TankImage.ino" | awk -v start="$(sed -n 3p "$dir/decoded/lines")" -v step="$(sed -n 4p "$dir/decoded/lines")" '
            /return smvm_init/ { sub(/return/, "const int why_not ="); print; print "    if (why_not != 0)\n        return why_not;"; print start; next }
            /smvm_step/ { print step; next }
            { print }'; } >"$dir/decoded/TankImage.ino"
    $CXX $(echo "$CC" | sed 's/^[^ ]* *//') -std=c++11 -O1 -I. -Itests/arduino -I"$src" -x c++ -include Arduino.h "$dir/decoded/TankImage.ino" tests/arduino/host.cpp -x none \
        "$dir/smc.a" -o "$dir/decoded/run" && "$dir/decoded/run" >"$dir/decoded/here" && cmp "$dir/decoded/here" "$dir/TankImage.expected"
}
on_this_computer()
{
    for f in "$examples/$1"/*.c; do
        test ! -f "$f" || $CC -std=gnu11 -O1 -c "$f" -o "$dir/$1_$(basename "$f").o" || return 1
    done
    $CXX $(echo "$CC" | sed 's/^[^ ]* *//') -std=c++11 -O1 -I. -Itests/arduino -I"$src" -x c++ -include Arduino.h "$examples/$1/$1.ino" tests/arduino/host.cpp -x none \
        $(find "$dir" -name "$1_*.o") "$dir/smc.a" -o "$dir/$1" && "$dir/$1" >"$dir/$1.here" && cmp "$dir/$1.here" "$dir/$1.expected"
}

# arduino BOARD SKETCH: by the Arduino tools, without a warning of ours (gcc 5.4 finds variables uninitialized, when linking, that are not)
arduino()
{
    arduino-builder -compile -hardware /usr/share/arduino-builder -hardware /usr/share/arduino/hardware -tools /usr/bin -libraries "$dir/libraries" \
        -fqbn "arduino:avr:$1" -build-path "$dir/made" -build-cache "$dir/core" -warnings all -prefs=build.extra_flags=-DDECIMAL_DIG=__DECIMAL_DIG__ \
        "$examples/$2/$2.ino" >"$dir/builder" 2>&1 && ! grep "$dir/libraries.*warning" "$dir/builder" | grep -v maybe-uninit && grep 'Sketch uses\|Global var' "$dir/builder"
}

sizes() { sed -n 's/Sketch uses \([0-9]*\).*/\1 bytes of flash,/p; s/Global variables use \([0-9]*\).*/\1 bytes of RAM/p' "$dir/builder" | paste -d ' ' - -; }
emulated() { "$dir/board" "$1" "$dir/made/$2.ino.elf" >"$dir/$2.there" 2>"$dir/$2.stack" && cmp "$dir/$2.there" "$dir/$2.expected"; }

emulates=0
if ! has arduino-builder || [ ! -d /usr/share/arduino/hardware/arduino/avr ]; then
    skip "no arduino-builder and arduino-core-avr here (apt-get install both)"
elif ! echo '#include <simavr/sim_avr.h>' | $CC -fsyntax-only -x c - 2>/dev/null; then
    skip "no simavr here (apt-get install libsimavr-dev libelf-dev)"
elif $CC -std=gnu99 -O1 -Wall -Wextra -I. tests/arduino/board.c -o "$dir/board" -lsimavr -lelf; then
    emulates=1
fi

example()   # SKETCH BOARD…
{
    sketch=$1
    shift
    check "the script of $sketch runs" expect "$sketch"
    check "$sketch goes through every state but one" test "$(awk '{ print $2, $3 }' "$dir/$sketch.expected" | sort -u | tr '\n' ' ')" = "1 0 1 1 3 1 "
    if has "$CXX"; then check "$sketch on this computer" on_this_computer "$sketch"; else skip "no $CXX here"; fi
    for board in "$@"; do
        [ $emulates = 1 ] || break
        rm -rf "$dir/made"
        mkdir "$dir/made"
        mcu=$(case $board in uno) echo atmega328p ;; *) echo atmega2560 ;; esac)
        check "$sketch for $board builds" arduino "$(test $board = uno && echo uno || echo mega:cpu=atmega2560)" "$sketch"
        check "$sketch on $board" emulated $mcu "$sketch"
        echo "$sketch on $board: $(sizes), $(cat "$dir/$sketch.stack")"
    done
}
# The firmware as a sketch: receives an image over the line, and runs it.     firmware CHIP
firmware()
{
    rm -f "$dir/eeprom"*
    $CC -std=gnu99 -O1 -I. tests/avr/board.c tests/avr/plants.c -o "$dir/line" -lsimavr -lelf -lm &&
        "$build/smc" build -w examples/tank/tank.sm --sv tests/avr/tank.sv --io tests/avr/tank.io -o "$dir/tank.smb" || return 1
    FIRMWARE=$dir/made/Firmware.ino.elf MCU=$1 PLANT=none SPEED=10 "$dir/line" - "$dir/eeprom" >"$dir/line.said" 2>&1 &
    line=$!
    for _ in 1 2 3 4 5 6 7 8 9; do [ -s "$dir/eeprom.line" ] || sleep 0.3; done
    port=--port=$(cat "$dir/eeprom.line")
    "$build/smc" flash "$dir/tank.smb" "$port" --speed=$speed --confirm && "$build/smc" device list "$port" --speed=$speed | grep -q confirmed
    code=$?
    kill $line
    return $code
}

has_room_for_stack()
{
    most=$(python3 tests/avr/stack.py avr-objdump "$dir/made/Firmware.ino.elf" | sed -n 's/ bytes of stack$//p')
    left=$(sed -n 's/.*leaving \([0-9]*\) bytes for local.*/\1/p' "$dir/builder")
    echo "at most $most of $left bytes of stack"
    [ "$most" -le "$left" ]
}

check "the library for this computer" library_here
example TankC uno mega
example TankImage uno mega
if has "$CXX"; then check "TankImage with the decoded form, on this computer" decoded_here; else skip "no $CXX here"; fi
for board in uno mega:cpu=atmega2560 pro:cpu=8MHzatmega328; do
    [ $emulates = 1 ] || break
    rm -rf "$dir/made"
    mkdir "$dir/made"
    chip=$(case $board in mega*) echo atmega2560 ;; *) echo atmega328p ;; esac)
    if [ $board = pro:cpu=8MHzatmega328 ]; then speed=57600; export F_CPU=8000000; else speed=115200; export F_CPU=16000000; fi
    check "Firmware for $board builds" arduino "$board" Firmware
    echo "Firmware on $board: $(sizes)"
    check "Firmware on $board" firmware $chip
    if has python3; then check "Firmware on $board has room for its stack" has_room_for_stack; else skip "no python3 here"; fi
done
finish arduino
