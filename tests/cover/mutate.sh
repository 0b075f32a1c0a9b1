# SPDX-License-Identifier: Apache-2.0
# smc mutate against the slow way: every change is made in the text of the machine, and smc test runs the scripts on it in a process of its own.
#     sh tests/cover/mutate.sh SMC [EVERY]        of every EVERY changes, one is made in the text (default 1)
# Machines: those of the folder, with scripts and requirements of the same stem, and examples.
smc=$1 every=${2:-1}
dir=$(mktemp -d) || exit 1
trap 'rm -rf "$dir"' EXIT
passed=0 failed=0 by_requirement=0

fail() { echo "$1"; failed=$((failed + 1)); }

# Leaves one of `every` mutants in the list.
thin() { awk -v every="$every" 'NR % every == 1 % every' "$dir/list" >"$dir/thinned" && mv "$dir/thinned" "$dir/list"; }

# Compares all mutants of machine $1 with the scripts and requirements after it.
compare() {
    machine=$1
    shift
    name=$(basename "$machine")
    if ! "$smc" mutate -w "$machine" "$@" --format=json -o "$dir/list.json" --force 2>"$dir/errors"; then
        fail "$machine: mutate: $(head -n 1 "$dir/errors")"
        return
    fi
    # at, length, verdict, the requirement that a run violates, or -, then the text, which can be empty.
    sed -e 's/"verdict":"\([a-z]*\)"\(.*\)"requirement":"\([^"]*\)"/"verdict":"\1 \3"\2/' -e 's/"verdict":"\([a-z]*\)"/"verdict":"\1 -"/' "$dir/list.json" |
        sed -n 's/.*"at":\([0-9]*\),"length":\([0-9]*\),.*,"new":"\(.*\)","danger":.*"verdict":"\([a-z]* [^"]*\)".*/\1 \2 \4 \3/p' >"$dir/list"
    test -s "$dir/list" || fail "$machine: no mutants"
    thin
    while read -r at length verdict requirement text; do
        { head -c "$at" "$machine"; printf %s "$text"; tail -c +$((at + length + 1)) "$machine"; } >"$dir/$name"
        "$smc" test -w "$dir/$name" "$@" >"$dir/out" 2>&1
        code=$?
        case $verdict in
        noticed) wanted=1 ;;
        *) wanted=0 ;;
        esac
        if test $requirement != -; then
            by_requirement=$((by_requirement + 1))
            grep -q "requirement $requirement violated" "$dir/out" || fail "$machine: byte $at, '$text': smc test does not report that $requirement is violated"
        fi
        if test $code = $wanted; then
            passed=$((passed + 1))
        else
            fail "$machine: byte $at, '$text': $verdict, but smc test exits $code: $(grep -m 1 error "$dir/out")"
        fi
    done <"$dir/list"
}

# Compares all mutants of a machine of an application with its scripts: $1 folder, $2 name of the .app, $3 machine, which has a file of its own.
compare_in_application() {
    cp -r "$1" "$dir/app"
    "$smc" mutate -w "$1/$2" "$1"/*.ss "$1"/*.rq --format=json -o "$dir/list.json" --force 2>"$dir/errors" || fail "$1: mutate: $(head -n 1 "$dir/errors")"
    sed -n "/\"machine\":\"$3\"/,/^\]}/p" "$dir/list.json" |
        sed -n 's/.*"at":\([0-9]*\),"length":\([0-9]*\),.*,"new":"\(.*\)","danger":.*"verdict":"\([a-z]*\)".*/\1 \2 \4 \3/p' >"$dir/list"
    test "$(grep -c . "$dir/list")" -ge 50 || fail "$1: $(grep -c . "$dir/list") mutants of $3, not 50"
    thin
    while read -r at length verdict text; do
        { head -c "$at" "$1/$3.sm"; printf %s "$text"; tail -c +$((at + length + 1)) "$1/$3.sm"; } >"$dir/app/$3.sm"
        "$smc" test -w "$dir/app/$2" "$dir"/app/*.ss "$dir"/app/*.rq >"$dir/out" 2>&1
        code=$?
        case $verdict in
        noticed) wanted=1 ;;
        *) wanted=0 ;;
        esac
        if test $code = $wanted; then
            passed=$((passed + 1))
        else
            fail "$1, $3: byte $at, '$text': $verdict, but smc test exits $code: $(grep -m 1 error "$dir/out")"
        fi
    done <"$dir/list"
    test "$(grep -c '^{"smc-mutations":1,"machine"\|^,{"smc-mutations"' "$dir/list.json")" = 3 || fail "$1: the list is not of three machines"
}

compare_in_application examples/dualdeploy dualdeploy.app flight
compare examples/tank/tank.sm examples/tank/tank.ss examples/tank/tank.rq
compare examples/recovery/recovery.sm examples/recovery/recovery.ss
for machine in tests/cover/*.sm; do
    requirements=${machine%.sm}.rq
    test -f "$requirements" || requirements=
    compare "$machine" "${machine%.sm}"*.ss $requirements
done
# Every sign of signs.sm is left out in a mutant.
"$smc" mutate -w tests/cover/signs.sm tests/cover/signs.ss --format=json -o "$dir/list.json" --force
test "$(grep -c '"old":"-","new":""' "$dir/list.json")" = 10 || fail "signs.sm: $(grep -c '"old":"-","new":""' "$dir/list.json") signs, not 10"
test $((by_requirement * every)) -ge 15 || fail "requirements notice $by_requirement changes, not $((15 / every))"

# Ctrl-C: what is known so far is complete, and the process ends by the signal.
interrupt() {
    "$smc" mutate -w examples/teststand/stand.sm examples/teststand/stand*.ss --generate --format=json >"$dir/partial.json" 2>"$dir/errors" &
    pid=$!
    sleep 1
    kill -TERM $pid
    wait $pid
    code=$?
    if test $code = 143 && test "$(tail -n 1 "$dir/partial.json")" = ']}' && head -n 1 "$dir/partial.json" | grep -q '"smc-mutations":1'; then
        passed=$((passed + 1))
    else
        fail "interrupted: exit code $code, $(head -n 1 "$dir/errors")"
    fi
}

interrupt
echo "mutation: $passed passed, $failed failed"
test "$failed" -eq 0
