#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Breaks the implementation on purpose, one line at a time (mutants.txt, faults.txt), and demands that tests notice.
#   mutants.sh LIST FOLDER [WHICH…]    FOLDER contains a copy of the tree and its build; WHICH: a clause as 5.7, a chapter as 5, an
#                                      engine, lines of the list as 100-220 or 100-: a run in pieces
#   mutants.sh --places LIST…          only whether each has its place still and is given once, and in mutants.txt each clause of the
#                                      language a mutant
# Ends with "N passed, N failed": a mutant passes when each of its engines notices it.  CFLAGS: what the copy is built with.
#
# An engine notices a mutant when its tests have been built with the fault, have run, and have failed.  Tests that cannot be built, or that do
# not end within LIMIT seconds, have shown nothing: then the mutant is not noticed.
here=tests/check
passed=0 failed=0
places() { awk -f $here/mutants.awk "$1" $(find stdlib compiler bytecode-vm runtime-c -name '*.[chS]' -o -name '*.def'); }

# Prints the clauses of the language, and of requirements, that no mutant of the list breaks.
without_mutant() {      # LIST
    awk 'FNR == NR { if (/^[0-9]+\.[0-9]+[, ]/) { sub(/  .*/, ""); n = split($0, clause, /, */); while (n) has[clause[n--]] = 1 } next }
         /^\*\*[0-9]+\.[0-9]+\*\* / { gsub(/\*/, "", $1); if (!($1 in has)) print "clause " $1 " has no mutant" }' "$1" docs/language.md docs/requirements.md
}

# Prints the entries of the list that break a place in the same way as an earlier one.  One entry can name several engines.
given_twice() {         # LIST
    awk '/^(#|$)/ { next }
         /^- / { old = $0; next }
         /^\+ / { key = place SUBSEP old SUBSEP $0
                  if (key in first) print FILENAME ":" line ": is given in line " first[key] " already; name both engines there"
                  else first[key] = line
                  next }
         { place = $0; sub(/.*[ \t][ \t]/, "", place); line = FNR }' "$1"
}

if [ "$1" = --places ]; then
    shift
    for list in "$@"; do
        places "$list" | sed -n "s|^\([0-9]*\).*[|]$|$list:\1: its place is not there in exactly one line|p"
        failed=$((failed + $(places "$list" | grep -c '|$')))
        passed=$((passed + $(places "$list" | grep -c '[^|]$')))
        given_twice "$list"
        failed=$((failed + $(given_twice "$list" | wc -l)))
        [ "$list" = $here/mutants.txt ] || continue
        without_mutant "$list"
        failed=$((failed + $(without_mutant "$list" | wc -l)))
    done
    echo "$passed passed, $failed failed"
    exit $((failed != 0))
fi

list=$1 folder=$2
shift 2
LIMIT=${LIMIT:-200}
command -v timeout >/dev/null || { echo "mutants.sh needs timeout (coreutils): 0 passed, 1 failed"; exit 1; }
mkdir -p "$folder/tree" "$folder/build" || exit 1
folder=$(cd "$folder" && pwd)
tree=$folder/tree build=$folder/build
parts='Makefile README.md stdlib compiler bytecode-vm runtime-c tests conformance docs examples'
for part in $parts; do
    rm -rf "$tree/${part:?}.new"
    cp -Rp "$part" "$tree/$part.new" && { rm -rf "$tree/$part"; mv "$tree/$part.new" "$tree/$part"; } || exit 1
done
# Where a run was cut short an object of the broken source may be left: it is older than what touch makes of the source.
[ -f "$build.broken" ] && touch "$tree/$(cat "$build.broken")"

# ---- what must notice ----

# What to build for an engine: targets of make, and the folders that its command expects.
targets_of() {      # ENGINE
    case $1 in
    host) echo "$build/clauses/steps $build/clauses/memory $build/clauses/regions $build/clauses/probe.smb" ;;
    diff) echo "$build/diff/difftest $build/unit/vm_select" ;;
    soft) echo "$build/soft/run" ;;
    store) echo "$build/store/cuts $build/store/agent $build/store/agent_log $build/store/auth $build/unit/vm_auth $build/store/old.smb $build/store/new.smb" ;;
    ref | vm | c) ;;
    *) command_of "$1" | tr ' ' '\n' | sed -n "s|^\($build/[^*]*[^*/]\).*|\1|p" ;;      # of files that a pattern names, their folder
    esac
}
compile() { ( cd "$tree" && make -s B="$build" CFLAGS="${CFLAGS:--O0}" WARN=-w "$@" ) >"$build.log" 2>&1; }

# The command of a row of tests.mk.
command_of() { sed -n "s/^+\{0,1\}$1: //p" "$build.lines"; }

# The files of conformance/ whose spec line names one of the clauses.
cases_of() {
    pattern=$(printf '%s' "$1" | sed 's/\./\\./g; s/  */|/g')
    grep -rElZ --include='*.smt' "^spec ([0-9.]+, *)*($pattern)(,|  )" conformance | tr '\0' ' '
}

# The command that runs the tests of an engine; it is run in the tree.
tests_of() {        # CLAUSES ENGINE
    random="$build/diff/difftest --first --no-reduce --out=$build/diff/out"
    case $2 in
    host) echo "$build/clauses/steps && $build/clauses/memory $build/clauses/probe.smb && $build/clauses/regions" ;;
    diff)           # IR as images, random programs on the VM, alone against what analyses say of them, in emitted C, and all cases
        echo "$build/unit/vm_select && $random --count=2000 --no-floors && $random --sound --steps=1000 --count=1500 --no-floors &&
            $random --count=400 --seed=7000 --cc='${CC:-cc} -std=c99 -O0' && sh tests/emitc/run.sh $build/smc readings &&
            $build/smc test -O0 conformance && CC='${CC:-cc} -O0' $build/smc test --engine=vm,c-soft conformance" ;;
    soft) echo "$build/soft/run" ;;
    store)
        images="$build/store/old.smb $build/store/new.smb"
        echo "$build/store/cuts $images && $build/store/agent $images && $build/store/agent_log $images && $build/store/auth $images && $build/unit/vm_auth" ;;
    ref | vm | c) echo "$build/smc test --engine=$2 $(cases_of "$1")" ;;
    golden | analysis) echo "$(command_of "$2") && $(command_of "$2-long")" ;;
    *) command_of "$2" ;;
    esac
}

# Runs the tests of an engine on what has been built; prints what kept them from noticing, nothing if they noticed.
shows_nothing() {   # CLAUSES ENGINE
    # shellcheck disable=SC2046
    compile all $(targets_of "$2") || { echo "$2 (its tests cannot be built)"; return; }
    tests=$(tests_of "$1" "$2")
    [ -n "$tests" ] || { echo "$2 (there is no such engine)"; return; }
    ( cd "$tree" && timeout -k 5 "$LIMIT" sh -c "$tests" ) </dev/null >"$build.out" 2>&1
    case $? in
    0) echo "$2" ;;
    124 | 137) echo "$2 (its tests did not end)" ;;
    esac
}

# Prints the engines that do not notice; of several that are joined by '/' one must notice.
silent() {          # CLAUSES ENGINES
    for engines in $2; do
        unnoticed=
        for engine in $(echo "$engines" | tr / ' '); do
            quiet=$(shows_nothing "$1" "$engine")
            [ -n "$quiet" ] || { echo "$engine" >"$build.by"; unnoticed=; break; }
            unnoticed="$unnoticed $quiet"
        done
        printf '%s' "$unnoticed"
    done
}

# ---- one after the other ----

wanted() {          # LINE CLAUSES ENGINES WHICH
    [ -z "$4" ] && return 0
    for w in $4; do
        case " $3 " in *" $w "*) return 0 ;; esac
        end=${w#*-}
        case $w in *-*) [ "$1" -ge "${w%-*}" ] && [ "$1" -le "${end:-100000}" ] && return 0 ;; esac
        for c in $2; do
            case $c in "$w" | "$w".*) return 0 ;; esac
        done
    done
    return 1
}

judge() {           # LINE CLAUSES ENGINES FILE: says what came of it, true if it was noticed
    printf '%s' "$list:$1 (${2:+$2, }$4): "
    [ -n "$4" ] || { echo "its place is not there exactly once"; return 1; }
    echo "$4" >"$build.broken"
    awk -v number="$1" -f $here/mutants.awk "$list" "$4" >"$tree/$4"
    rm -f "$build.by"
    if compile all; then
        bad=$(silent "$2" "$3")
    else
        bad=" anything: it does not compile"
        sed 's/^/    /' "$build.log" | head -n 8
    fi
    cp "$4" "$tree/$4"
    [ -n "$bad" ] || by=$(cat "$build.by")
    echo "${bad:+NOT }noticed by${bad:- $by}"
    [ -z "$bad" ]
}

compile all || { tail "$build.log"; echo "the tree does not build: 0 passed, 1 failed"; exit 1; }
( cd "$tree" && make -s B="$build" list-tests ) >"$build.lines" || exit 1
mkdir -p "$build/device" "$build/log"
places "$list" | while IFS='|' read -r number clauses engines file; do
    wanted "$number" "$clauses" "$engines" "$*" && echo "$number|$clauses|$engines|$file"
done >"$build.list"

# Without any fault no engine must notice anything; where that was seen of these sources it is not tried again.
for engine in $(cut -d '|' -f 3 "$build.list" | tr ' /' '\n\n' | sort -u); do
    clauses=$(awk -F '|' -v e="$engine" '{ gsub("/", " ", $3) } index(" " $3 " ", " " e " ") { print $2 }' "$build.list" | tr ' ' '\n' | sort -u | tr '\n' ' ')
    sound=$build.sound-$engine-$(printf '%s' "$clauses" | cksum | tr ' ' -)
    [ -f "$sound" ] && [ -z "$(find $parts -type f -newer "$sound" | head -n 1)" ] && continue
    [ "$(shows_nothing "${clauses% }" "$engine")" = "$engine" ] || { tail "$build.log" "$build.out"; echo "$engine fails without any fault: 0 passed, 1 failed"; exit 1; }
    touch "$sound"
done
while IFS='|' read -r number clauses engines file; do
    if judge "$number" "$clauses" "$engines" "$file" </dev/null; then passed=$((passed + 1)); else failed=$((failed + 1)); fi
done <"$build.list"

[ $((passed + failed)) -gt 0 ] || { echo "no mutant was tried"; failed=1; }
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
