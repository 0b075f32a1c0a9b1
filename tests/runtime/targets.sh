#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# The runtime for small targets: it compiles there without a warning; and names that are not used are not linked.
#     targets.sh SMC     CC names the host's compiler.
smc=$1 CC=${CC:-cc}
here=tests/runtime
. tests/checks.sh
dir=$(mktemp -d "${TMPDIR:-/tmp}/smc-targets.XXXXXX") || exit 1
trap 'rm -rf "$dir"' EXIT
strict='-std=c99 -Os -ffunction-sections -fdata-sections -Wall -Wextra -Wconversion -Wshadow -Wstrict-prototypes -Wmissing-prototypes
        -pedantic -Werror -I.'
strict_cpp='-std=c++11 -Wall -Wextra -Wconversion -Wshadow -pedantic -Werror -I.'
sources='runtime-c/statevec.c runtime-c/region.c runtime-c/names.c runtime-c/event.c'
more='runtime-c/log.c runtime-c/log_drain.c runtime-c/log_describe.c runtime-c/keep.c
      runtime-c/task.c runtime-c/executor.c runtime-c/app.c runtime-c/run.c runtime-c/writing.c
      runtime-c/machine.c bytecode-vm/target/machine.c bytecode-vm/debug.c runtime-c/pin.c runtime-c/io.c bytecode-vm/target/io.c'

for v in wide plain narrow; do
    "$smc" build "$here/$v.sv" --emit=c --runtime -o "$dir/$v.c" || failed=$((failed + 1))
done

compiles() {                  # compiles COMPILER FLAGS…
    if ! has "$1"; then
        skipped=$((skipped + 1))
        return
    fi
    for source in $sources $more "$dir/wide.c" "$dir/plain.c" "$dir/narrow.c"; do
        check "$* $source" "$@" $strict -I"$dir" -c "$source" -o "$dir/x.o"
    done
}
compiles gcc
compiles clang-19
compiles avr-gcc -mmcu=atmega328p
compiles avr-gcc -mmcu=atmega2560
compiles arm-none-eabi-gcc -mcpu=cortex-m0 -mthumb
compiles arm-none-eabi-gcc -mcpu=cortex-m3 -mthumb

# What smc makes is C++ as well.
for cpp in g++ clang++-19; do
    command -v $cpp >/dev/null 2>&1 || { skipped=$((skipped + 1)); continue; }
    for v in wide plain narrow; do
        check "$cpp $v" $cpp -x c++ $strict_cpp -I"$dir" -c "$dir/$v.c" -o "$dir/x.o"
    done
done

# More elements than the runtime can number: the generated C fails to compile and reports it.
{ echo '[All]'; awk 'BEGIN { for (i = 0; i < 65536; i++) print "U8 e" i }'; } >"$dir/vast.sv"
"$smc" build "$dir/vast.sv" --emit=c --runtime -o "$dir/vast.c" || failed=$((failed + 1))
refuses() { ! "$@" 2>"$dir/errors" && grep -q '65,535' "$dir/errors"; }
check 'too many elements are refused' refuses $CC -std=c99 -I. -I"$dir" -c "$dir/vast.c" -o "$dir/x.o"

# ---- what a program does not use is not in it ----

# program NAME STATEMENT: links a main of that statement; the PAL's locks are empty.
program() {
    {
        echo '#include "wide.h"'
        echo 'SmResult pal_lock_open(PalLock *lock) { lock->id = 1; return SM_OK; }'
        echo 'SmResult pal_lock_take(PalLock lock, uint64_t timeout) { (void)lock, (void)timeout; return SM_OK; }'
        echo 'SmResult pal_lock_give(PalLock lock) { (void)lock; return SM_OK; }'
        echo "int main(void) { if (sm_statevec_init(&wide_vector) != SM_OK) return 1; $2 return (int)wide_f64(); }"
    } >"$dir/$1.c"
    # (Without options that can follow the compiler's name: sanitizers keep everything.)
    ${CC%% *} -std=c99 -Os -ffunction-sections -fdata-sections -Wl,--gc-sections -I. -I"$dir" "$dir/$1.c" "$dir/wide.c" $sources \
        -o "$dir/$1" 2>"$dir/log"
}
links() { nm "$dir/$1" | grep -q " $2\$"; }
links_not() { ! links "$1" "$2"; }
holds() { grep -q "$2" "$dir/$1"; }
holds_not() { ! holds "$1" "$2"; }

if program few '' && has nm; then
    check 'names are looked up where they are asked for' program names 'if (!sm_find_element(&wide_names, "f64")) return 2;'
    check 'a program that looks up names has them' holds names set_class
    check 'a program that looks up none has none' holds_not few set_class
    check '... nor the table' links_not few wide_names
    check 'who only reads elements has no regions' links_not few sm_pack_region
    check 'but has the description' links few wide_layout
else
    skipped=$((skipped + 1))
fi
finish targets
