#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# What `make check` does on other processors: cases of conformance/ and a few random programs, as targets.txt says.     run.sh BUILD
B=$1/targets difftest=$1/diff/difftest
passed=0 failed=0 skipped=0

count() {
    if "$@" >"$B/log" 2>&1; then passed=$((passed + 1)); else failed=$((failed + 1)); cat "$B/log"; echo "failed: $*"; fi
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
    case $what in *runtime*)
        count make -s B="$1" "$B/runtime-$target"
        for t in "$B/runtime-$target.tests"/*.elf; do count "${t%.elf}"; done ;;
    esac
    case $what in *c)
        count "$difftest" --cc="sh tests/targets/cc.sh $target -std=gnu11 -O2" --count=6 --out="$B/c-$target" ;;
    esac
done
rm -f "$B/log"
echo "targets: $passed passed, $failed failed, $skipped skipped"
[ "$failed" -eq 0 ]
