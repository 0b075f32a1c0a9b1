#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# The tests of `make check` on other processors: cases of conformance/ and a few random programs, by the rows of targets.txt.     run.sh BUILD
B=$1/targets difftest=$1/diff/difftest
passed=0 failed=0 skipped=0

count() {
    if "$@" >"$B/log" 2>&1; then passed=$((passed + 1)); else failed=$((failed + 1)); cat "$B/log"; echo "failed: $*"; fi
}

# Cases of conformance as C on TARGET: not one starts.
refuses() {
    if "$B/cases" --cc="sh tests/targets/cc.sh $1 -O2" --out="$B/cases-$1" conformance/07-windows/median-of-t*.smt; then return 1; fi >"$B/refused"
    grep -q 'status: ref has 0x0, .* has 0x2' "$B/refused" && grep -q '^0 passed' "$B/refused"
}

# double TARGET: what its compiler makes of double, against stdlib/soft_*.
double() {
    sh tests/targets/cc.sh "$1" -std=c99 -ffp-contract=off -Wall -Wextra -Werror -O2 -DSM_F64_SOFT=1 -DSOFT_STRIDE=1009 -DSOFT_RANDOM=1000 -I. \
        tests/targets/soft.c tests/soft/hardware.c tests/soft/subject.c tests/soft/vectors.c stdlib/*.c -o "$B/double-$1" -lm && "$B/double-$1" </dev/null
}

# root TARGET: the square root by its instruction against that by integers.
root() {
    sh tests/targets/cc.sh "$1" -std=gnu11 -Wall -Wextra -Werror -O2 -I. tests/targets/root.c tests/targets/root_integers.c -o "$B/root-$1" &&
        "$B/root-$1" </dev/null
}

mkdir -p "$B" || exit 1
for target in $(sed -n 's/^\([a-z][^ ]*\) *|.*/\1/p' tests/targets/targets.txt); do
    what=$(sed -n "s/^$target *|.*| *//p" tests/targets/targets.txt)
    [ "$what" != - ] || continue
    missing=$(sh tests/targets/cc.sh "$target" present)
    if [ -n "$missing" ]; then
        echo "$target: $missing"
        skipped=$((skipped + 1))
        continue
    fi
    case $what in images*)
        if ! make -s B="$1" "$B/vm-$target"; then
            echo "failed: $B/vm-$target"
            failed=$((failed + 1))
            continue
        fi
        count "$B/cases" --vm="$B/vm-$target" --out="$B/cases-$target" conformance/*/*.smt
        count "$difftest" --vm="$B/vm-$target" --count=50 --out="$B/images-$target" ;;
    esac
    case $what in
    refuses) count refuses "$target" ;;
    double) count double "$target" ;;
    esac
    case $what in *root*)
        count root "$target" ;;
    esac
    case $what in *runtime*)
        count make -s B="$1" "$B/runtime-$target"
        for t in "$B/runtime-$target.tests"/*.elf; do count "${t%.elf}"; done ;;
    esac
    case $what in *units*)
        count make -s B="$1" "$B/units-$target"
        for t in "$B/units-$target"/*.elf; do count "${t%.elf}"; done ;;
    esac
    case $what in *c)
        count "$difftest" --cc="sh tests/targets/cc.sh $target -std=gnu11 -O2" --count=6 --out="$B/c-$target" ;;
    esac
done
rm -f "$B/log"
echo "targets: $passed passed, $failed failed, $skipped skipped"
[ "$failed" -eq 0 ] && [ $((passed + skipped)) -gt 0 ]
