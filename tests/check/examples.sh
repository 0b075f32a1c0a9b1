#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Runs the examples as their reader would: examples.sh SMC [--once] FOLDER...  Each machine M.sm of a folder is checked for a flight, with the
# step of its options ("step 10 ms") or its comment ("Stepped every 10 ms"), and there must be no finding.  It is tested on every engine by its scripts
# M.ss and M-*.ss, and these judge all its requirements M.rq; a state vector (.sv) in the folder is for all its machines.
# An application X.app with scripts X.ss and X-*.ss is tested by these, and so are its machines.
# A script that belongs to no machine, and that no other one includes, is a failure, as is a machine without a script or without a step.
# So that silence means something, machines that have @safe or @allow are checked again without them: most must draw a finding.  Not with --once.
smc=$1 least=7
shift
[ "$1" != --once ] || { least=0; shift; }
out=${TMPDIR:-/tmp}/smc-examples.$$
trap 'rm -f "$out" "$out".smb "$out".sm' EXIT
passed=0 failed=0 machines=0 marked=0 requirements=0

# A test: its name, then the command, which must succeed; with quiet=1 it must print nothing either.
expect() {
    name=$1
    shift
    if "$@" >"$out" 2>&1 && { [ -z "$quiet" ] || [ ! -s "$out" ]; }; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "$name: $*"
        cat "$out"
    fi
}

# The scripts of the machine or application $1: M.ss, M-*.ss.
scripts_of() {
    for script in "${1%.*}.ss" "${1%.*}"-*.ss; do
        [ -f "$script" ] && echo "$script"
    done
}

# The option for the step of the machine $1.
step_of() {
    sed -n 's/.*Stepped every \([0-9]*\) ms.*/--step=\1/p; s/^step \([0-9]*\) ms$/--step=\1/p' "$1"
}

# Without its marks, the machine $1 with the step $2 draws a finding.
draws_finding() {
    sed 's/ *@safe//; s/@allow([^)]*)//' "$1" >"$out".sm
    "$smc" check -Wflight "$2" ${sv:+"$sv"} "$out".sm 2>&1 | grep ' \[W09[0-9]* '
}

# Sets `sv` to the option for the folder's state vector, or to nothing.
find_vector() {
    sv=
    for file in "$1"/*.sv; do
        [ -f "$file" ] && sv=--sv=$file
    done
}

# Tests the applications of a folder that have scripts, and adds their names to `apps`.
try_applications() {
    for app in "$1"/*.app; do
        for script in $(scripts_of "$app"); do
            seen=$((seen + 1))
            apps="$apps $app"
            expect test "$smc" test --engine=all -Werror "$app" "$script"
        done
        if [ -f "${app%.app}.rq" ]; then
            requirements=$((requirements + 1))
            # shellcheck disable=SC2046
            expect requirements "$smc" test -Werror "$app" $(scripts_of "$app") "${app%.app}.rq"
        fi
    done
}

for folder; do
    find_vector "$folder"
    seen=0 apps=
    try_applications "$folder"
    for machine in "$folder"/*.sm; do
        # A machine whose application has scripts is tested by these; applications.sh checks it.
        # shellcheck disable=SC2086
        [ -z "$apps" ] || ! grep -q "\"${machine##*/}\"" $apps || continue
        scripts=$(scripts_of "$machine")
        # shellcheck disable=SC2086
        set -- $scripts
        seen=$((seen + $#))
        step=$(step_of "$machine")
        machines=$((machines + 1))
        expect "a step of $machine" test -n "$step"
        quiet=1
        expect check "$smc" check ${sv:+"$sv"} "$machine" "$@"
        expect "check for a flight" "$smc" check -Wflight ${step:+"$step"} ${sv:+"$sv"} "$machine"
        expect build "$smc" build ${sv:+"$sv"} "$machine" -o "$out".smb
        quiet=
        if [ $least -gt 0 ] && grep -q '@safe\|@allow' "$machine"; then
            draws_finding "$machine" "$step" >"$out" && marked=$((marked + 1))
        fi
        expect scripts test $# -gt 0
        for script; do
            expect test "$smc" test --engine=all -Werror ${sv:+"$sv"} "$machine" "$script"
        done
        if [ -f "${machine%.sm}.rq" ]; then
            requirements=$((requirements + 1))
            expect requirements "$smc" test -Werror ${sv:+"$sv"} "$machine" "$@" "${machine%.sm}.rq"
        fi
    done
    for script in "$folder"/*.ss; do
        grep -q "^include \"${script##*/}\"" "$folder"/*.ss && seen=$((seen + 1))
    done
    # shellcheck disable=SC2012
    expect "a script of no machine in $folder" test "$(ls "$folder"/*.ss | wc -l)" -eq "$seen"
done
expect "ten machines, $least of them with findings without their marks" test "$machines" -ge 10 -a "$marked" -ge "$least"
expect "four machines and applications with requirements" test "$requirements" -ge 4
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
