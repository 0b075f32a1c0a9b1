#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# A C compiler for a target, to be used like any other: it links a program for the host that runs the target's program in an emulator.
#     cc.sh TARGET OPTION-OR-FILE…
# Or, instead of options: `present`, which prints nothing if all tools are installed, else how to install them; `vm`, the options of vm.c;
# `ar OPERATION…`, the archiver that goes with it.
here=tests/targets name=$1
shift

row() {  # FILE NAME: its columns behind the name, as arguments
    sed -n "s/^$2 *| *//p" "$here/$1" | sed 's/ *| */|/g'
}
column() { printf '%s\n' "$2" | cut -d'|' -f"$1" | sed 's/ *$//'; }

target=$(row targets.txt "$name")
[ -n "$target" ] || { echo "cc.sh: no target '$name' in $here/targets.txt" >&2; exit 2; }
cc=$(column 1 "$target") options=$(column 2 "$target")
board=$(row boards.txt "$(column 3 "$target")")
emulator=$(column 1 "$board" | sed 's/SEMIHOSTING/-display none -monitor none -serial null -semihosting-config enable=on,target=native -kernel/')
link=$(column 2 "$board")

case $1 in
ar)
    shift
    exec "${cc%gcc}ar" "$@" ;;
present)
    command -v "$cc" >/dev/null && command -v "${emulator%% *}" >/dev/null &&
        { [ "${link%% *}" != linux ] || printf '#include <errno.h>\nint main(void) { return errno; }\n' | $cc $options -x c - -static -o /dev/null 2>/dev/null; } ||
        echo "apt-get install $(column 4 "$board")"
    exit 0 ;;
vm)
    case $(column 3 "$board") in
    small) echo "-DVM_IMAGE=4096 -DVM_RAM=2048 -DVM_VECTOR=768 -DVM_DECODED=0 -DVM_CELLS=80" ;;
    medium) echo "-DVM_IMAGE=65536 -DVM_RAM=30000 -DVM_VECTOR=30000 -DVM_DECODED=1048576 -DVM_CELLS=1000" ;;
    *) echo "-DVM_IMAGE=65536 -DVM_RAM=262144 -DVM_VECTOR=65536 -DVM_DECODED=1048576 -DVM_CELLS=1000" ;;
    esac
    exit 0 ;;
esac

out=a.out object=no previous=
for argument in "$@"; do
    [ "$argument" = -c ] && object=yes
done
kind=${link%% *} bare=
if [ "$kind" != linux ]; then
    bare="-I$here/bare -ffunction-sections -fdata-sections"
    [ "$kind" = riscv ] && bare="--specs=picolibc.specs $bare"
fi
# shellcheck disable=SC2086    # options are words
[ $object = yes ] && exec $cc $options $bare "$@"
if [ "$kind" = linux ]; then
    bare=-static
else
    symbols=
    for s in ${link#* }; do symbols=$symbols,--defsym=$s; done
    bare="$bare -I. $here/bare/$kind.c $here/bare/semihost.c -nostartfiles -T $here/bare/bare.ld -Wl,--gc-sections$symbols"
fi
for argument in "$@"; do              # -o OUT becomes -o OUT.elf
    [ -n "$previous" ] || set --
    [ "$previous" = -o ] && out=$argument && argument=$out.elf
    set -- "$@" "$argument"
    previous=$argument
done
# shellcheck disable=SC2086
$cc $options "$@" $bare || exit 1
case $out in /*) elf=$out.elf ;; *) elf=$PWD/$out.elf ;; esac
printf '#!/bin/sh\nexec timeout 900 %s "%s" "$@"\n' "$emulator" "$elf" >"$out" && chmod +x "$out"
