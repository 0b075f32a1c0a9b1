#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Breaks the implementation on purpose, one line at a time (mutants.txt), and demands that the cases of the clause notice.
#   mutants.sh FOLDER [CLAUSE-OR-CHAPTER…]     FOLDER holds a copy of the tree and its build; CLAUSE as 5.7, chapter as 5.
# Ends with "N passed, N failed": a mutant passes when some case of its clauses fails.
folder=$1
shift
txt=tests/check/mutants.txt
awk=tests/check/mutants.awk
tree=$folder/tree
build=$folder/build
mkdir -p "$tree"
for part in Makefile stdlib compiler bytecode-vm runtime-c tests conformance docs; do
    rm -rf "$tree/${part:?}.new"
    cp -Rp "$part" "$tree/$part.new" && { rm -rf "$tree/$part"; mv "$tree/$part.new" "$tree/$part"; } || exit 1
done
# Where a run was cut short an object of the broken source may be left: it is older than what touch makes of the source.
[ -f "$build.broken" ] && touch "$tree/$(cat "$build.broken")"
root=$(pwd)
case $build in /*) ;; *) build=$root/$build ;; esac
case $tree in /*) ;; *) tree=$root/$tree ;; esac

compile() { ( cd "$tree" && make -s B="$build" CFLAGS=-O0 WARN=-w "$@" ) >"$build.log" 2>&1; }
host_tests="$build/clauses/steps $build/clauses/memory $build/clauses/regions $build/clauses/probe.smb"

# The files of conformance/ whose spec line names one of the clauses.
cases_of() {
    pattern=$(printf '%s' "$1" | sed 's/\./\\./g; s/  */|/g')
    ( cd "$tree" && grep -rElZ "^spec ([0-9.]+, *)*($pattern)(,|  )" conformance | tr '\0' '\n' )
}

# True if no case notices.
survives() {
    clauses=$1 engine=$2
    case $engine in
    host)
        ( cd "$tree" && "$build/clauses/steps" && "$build/clauses/memory" "$build/clauses/probe.smb" && "$build/clauses/regions" ) >"$build.out" 2>&1 ;;
    golden)
        ( cd "$tree" && "$build/golden" "$build/smc" tests/golden/column-is-a-byte.smt ) >"$build.out" 2>&1 ;;
    *)
        cases=$(cases_of "$clauses")
        [ -n "$cases" ] || { echo "no cases for $clauses"; return 0; }
        ( cd "$tree" && ulimit -t 60 && "$build/smc" test --engine="$engine" $cases ) >"$build.out" 2>&1 ;;
    esac
}

passed=0 failed=0
mkdir -p "$build"
compile all || { cat "$build.log"; echo "0 passed, 1 failed"; exit 1; }

wanted() {
    [ -z "$2" ] && return 0
    for c in $1; do
        for w in $2; do
            case $c in "$w" | "$w".*) return 0 ;; esac
        done
    done
    return 1
}

awk -v list=1 -f $awk $txt >"$build.list"
while IFS='|' read -r number clauses engines file; do
    wanted "$clauses" "$*" || continue
    if [ -d "$file" ]; then
        awk -v show="$number" -f $awk $txt >"$build.old"
        file=$(grep -rlF -f "$build.old" "$file")             # several names are no file's name
    fi
    if [ ! -f "$file" ] || ! awk -v number="$number" -f $awk $txt "$file" >"$build.mutant"; then
        echo "mutant $number ($clauses, $file): its place is not there exactly once"
        failed=$((failed + 1))
        continue
    fi
    echo "$file" >"$build.broken"
    cp "$build.mutant" "$tree/$file"
    targets=all
    case $engines in *host*) targets="all $host_tests" ;; *golden*) targets="all $build/golden" ;; esac
    if compile $targets; then
        bad=
        for engine in $engines; do
            survives "$clauses" "$engine" && bad="$bad $engine"
        done
        if [ -n "$bad" ]; then
            echo "mutant $number ($clauses, $file): nobody noticed on$bad"
            failed=$((failed + 1))
        else
            passed=$((passed + 1))
        fi
    elif [ "$engines" = host ] && grep -q "probe" "$build.log"; then
        passed=$((passed + 1))                # what it emits does not even compile
    else
        echo "mutant $number ($clauses, $file): does not compile"
        sed 's/^/    /' "$build.log" | head -n 8
        failed=$((failed + 1))
    fi
    cp "$file" "$tree/$file"
done <"$build.list"

if [ $# -eq 0 ]; then
    sed -n 's/^\*\*\([0-9]*\.[0-9]*\)\*\* .*/\1/p' docs/language.md | while read -r clause; do
        grep -Eq "^[0-9]+\|([0-9. ]+ )?$(printf '%s' "$clause" | sed 's/\./\\./')( |\|)" "$build.list" || echo "clause $clause has no mutant"
    done
fi
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
