#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Answers tests/windows/cc.c: runs COMPILER with the arguments that appear in FOLDER, until it is ended.     cc.sh COMPILER FOLDER
# Paths of Windows become those of this system.
while sleep 0.02; do
    for args in "$2"/*.args; do
        [ -f "$args" ] || continue
        base=${args%.args}
        set -- "$1" "$2"
        while IFS= read -r word; do
            case $word in
            *\\*) word=$(printf '%s' "$word" | sed 's/^[a-zA-Z]://' | tr '\\' /) ;;
            esac
            set -- "$@" "$word"
        done <"$args"
        compiler=$1 place=$2
        shift 2
        "$compiler" "$@" >"$base.out" 2>&1
        echo $? >"$base.code.new"
        rm -f "$args"
        mv "$base.code.new" "$base.code"
        set -- "$compiler" "$place"
    done
done
