#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Machines that are large in one respect, for run.sh.     large.sh FOLDER: writes outputs.sm, with 90 outputs, and states.sm, with 300 states.
D=$1
{
    echo "[state_vector]"
    echo "U64 time @alias G"
    echo "U32 state @alias S"
    echo "U8 in @read_only"
    for i in $(seq 90); do echo "U8 out$i"; done
    echo "[All] .step"
    for i in $(seq 90); do echo "    out$i = in"; done
    echo "    in > 100: -> Some"
    echo "[Some] .step"
    for i in $(seq 2 5 90); do echo "    out$i = 1"; done
    echo "    in > 50: -> None"
    echo "[None] .step"
    echo "    in > 100: -> All"
} >"$D/outputs.sm"
{
    echo "[state_vector]"
    echo "U64 time @alias G"
    echo "U32 state @alias S"
    echo "U8 in @read_only"
    for i in $(seq 300); do
        echo "[State$i] .step"
        echo "    in > 20: -> State$((i * 7 % 300 + 1))"
    done
} >"$D/states.sm"
