#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# libsmc gives what smc gives, byte for byte: images, C, reports, diagrams, diagnostics and runs of every example.    parity.sh SMC COMMAND [EVERY]
# EVERY: of every EVERY machines, one is compared (default 1).
smc=$1 command=$2 every=${3:-1}
. tests/checks.sh
dir=$(mktemp -d) || exit 1
trap 'rm -rf "$dir"' EXIT

# equal WHAT FILE…: `command WHAT` printed what smc wrote to $dir/smc.
equal()
{
    "$command" "$@" >"$dir/library" 2>"$dir/errors"
    cmp "$dir/smc" "$dir/library"
}
# same_structure MACHINE: the transitions that `command structure` prints are those of $dir/smc.  The library has one of [all_states] for each
# state, the report has it once, so of such machines only targets, blocks, lines and conditions are compared.
same_structure()
{
    "$command" structure "$1" >"$dir/library" 2>"$dir/errors"
    if grep -q '^\[all_states\]' "$1"; then
        for f in smc library; do
            sed 's/^[0-9]* [A-Za-z_0-9, ]* \([A-Za-z_0-9]* \.\{0,1\}[a-z]* [0-9]* \)/\1/' "$dir/$f" | sort -u >"$dir/$f.once"
        done
        [ -s "$dir/smc.once" ] && cmp "$dir/smc.once" "$dir/library.once"
    else
        cmp "$dir/smc" "$dir/library"
    fi
}
# Prints the files with recorded data that the scripts name.
data_of() { for s; do sed -n "s|^file \"\([^\"]*\)\".*|${s%/*}/\1|p" "$s"; done; }
for machine in $(ls examples/*/*.sm tests/app/*.sm | awk -v every="$every" 'NR % every == 0'); do
    scripts=$(ls "${machine%.sm}".ss 2>/dev/null)
    "$smc" build -w "$machine" -o "$dir/smc" --force 2>/dev/null || continue         # it needs a state vector
    check "image of $machine" equal image "$machine"
    (cd "$dir" && rm -rf c && mkdir c) && "$smc" build -w "$machine" --emit=c -o "$dir/c/" 2>/dev/null && cat "$dir"/c/*.c "$dir"/c/*.h >"$dir/smc"
    check "C of $machine" equal c "$machine"
    "$smc" check "$machine" 2>"$dir/smc"
    check "diagnostics of $machine" equal check "$machine"
    "$smc" report "$machine" $scripts -o "$dir/smc" --format=html --force 2>/dev/null
    check "report of $machine" equal report "$machine" $scripts $(data_of $scripts)
    "$smc" graph -w "$machine" -o "$dir/smc" --format=svg --force 2>/dev/null
    "$smc" graph "$machine" -o "$dir/smc" --format=svg --force 2>/dev/null
    check "diagram of $machine" equal graph "$machine"
    "$smc" report "$machine" -o "$dir/report" --format=json --force 2>/dev/null
    sed -n 's/.*{"number": \([0-9]*\), "from": "\([^"]*\)", "to": "\([^"]*\)", "when": "\([^"]*\)", "block": "\([^"]*\)", "line": \([0-9]*\),.*/\1 \2 \3 \5 \6 \4/p' "$dir/report" >"$dir/smc"
    check "structure of $machine" same_structure "$machine"
    check "which an opened machine has" "$command" structure "$machine"
    for script in $scripts; do
        "$smc" test "$machine" "$script" >"$dir/smc" 2>/dev/null
        check "run of $script" equal run "$machine" "$script" $(data_of "$script")
    done
done

# An application: its files are named as it names them.
"$smc" build -w examples/rocket/rocket.app -o "$dir/made" 2>/dev/null
rocket() { "$command" c examples/rocket/rocket.app $(cd examples/rocket && for f in *.sv *.sm *.io; do test -e "$f" && echo "examples/rocket/$f=$f"; done) >"$dir/library"; }
check "the C of an application" rocket
lines_of_app() { cat "$dir"/made/*.c "$dir"/made/*.h | sort >"$dir/a"; sort "$dir/library" >"$dir/b"; cmp "$dir/a" "$dir/b"; }
check "is that of smc" lines_of_app
finish parity
