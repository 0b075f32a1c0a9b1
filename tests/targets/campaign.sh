#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Random programs on other processors: N as images, NC as emitted C at each of LEVELS, from SEED on; and all of conformance/.
#     campaign.sh BUILD [TARGET…]
# An interrupted campaign continues; a finished one prints its result again.
B=$1/targets difftest=$1/diff/difftest
N=${N:-10000} NC=${NC:-1000} SEED=${SEED:-1} LEVELS=${LEVELS:--O2 -Os -O0}
[ $# -gt 1 ] || set -- "$1" $(sed -n 's/^\([a-z][^ ]*\) *|.*/\1/p' tests/targets/targets.txt)
build=$1
shift

run() {  # NAME COMMAND…
    echo "== $1"
    shift
    "$@" || failed=1
}

failed=0
for target; do
    missing=$(sh tests/targets/cc.sh "$target" present)
    [ -z "$missing" ] || { echo "$target: $missing"; continue; }
    if [ "$N" -gt 0 ]; then
        make -s B="$build" "$B/vm-$target" || exit 1
        run "$target, images of conformance" "$B/cases" --vm="$B/vm-$target" --out="$B/campaign-cases-$target" \
            conformance/*/*.smt
        run "$target, images" "$difftest" --vm="$B/vm-$target" --seed="$SEED" --count="$N" --resume --out="$B/campaign-images-$target"
    fi
    # Emitted C wants more room than a microbit has; where double is not right it wants its numbers in software.
    via=--cc
    case $NC-$target in
    0-* | *-m0) continue ;;
    *-m3 | *-m4f | *-soft) via=--cc-soft ;;
    esac
    run "$target, C of conformance" "$B/cases" $via="sh tests/targets/cc.sh $target -std=gnu11 -O1" --out="$B/campaign-cases-$target" \
        conformance/*/*.smt
    for level in $LEVELS; do
        run "$target, C $level" "$difftest" $via="sh tests/targets/cc.sh $target -std=gnu11 $level" --seed="$SEED" --count="$NC" --resume \
            --out="$B/campaign-c$level-$target"
    done
done
exit $failed
