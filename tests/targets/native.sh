#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# smc itself, built for a target of targets.txt that this computer runs, and its tests; or how to get what that needs.     native.sh BUILD MAKE TARGET
missing=$(sh tests/targets/cc.sh "$3" present)
if [ -n "$missing" ]; then
    echo "$3: $missing"
    echo "0 passed, 0 failed, 1 skipped"
    exit 0
fi
exec $2 -s B="$1" NC=200 TARGETS="$3" targets-native
