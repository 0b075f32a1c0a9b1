#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Breaks the implementation on purpose, one line at a time (mutants.txt, faults.txt), and demands that tests notice.
#   mutants.sh LIST FOLDER [WHICH…]    FOLDER holds a copy of the tree and its build; WHICH: a clause as 5.7, a chapter as 5, an
#                                      engine, lines of the list as 100-220 or 100-: a run in pieces
#   mutants.sh --places LIST…          only whether each has its place still
# Ends with "N passed, N failed": a mutant passes when each of its engines notices.  CFLAGS: what the copy is built with.
here=tests/check
passed=0 failed=0
places() { awk -f $here/mutants.awk "$1" $(find stdlib compiler bytecode-vm runtime-c -name '*.[chS]' -o -name '*.def'); }

if [ "$1" = --places ]; then
    shift
    for list in "$@"; do
        places "$list" | sed -n "s|^\([0-9]*\).*[|]$|$list:\1: its place is not there in exactly one line|p"
        failed=$((failed + $(places "$list" | grep -c '|$')))
        passed=$((passed + $(places "$list" | grep -c '[^|]$')))
    done
    echo "$passed passed, $failed failed"
    exit $((failed != 0))
fi

list=$1 folder=$2
shift 2
mkdir -p "$folder/tree" "$folder/build" || exit 1
folder=$(cd "$folder" && pwd)
tree=$folder/tree build=$folder/build
parts='Makefile stdlib compiler bytecode-vm runtime-c tests conformance docs examples'
for part in $parts; do
    rm -rf "$tree/${part:?}.new"
    cp -Rp "$part" "$tree/$part.new" && { rm -rf "$tree/$part"; mv "$tree/$part.new" "$tree/$part"; } || exit 1
done
# Where a run was cut short an object of the broken source may be left: it is older than what touch makes of the source.
[ -f "$build.broken" ] && touch "$tree/$(cat "$build.broken")"

# ---- what must notice ----

targets_of() {      # ENGINES
    echo all
    case " $1 " in *' host '*) echo "$build/clauses/steps $build/clauses/memory $build/clauses/regions $build/clauses/probe.smb" ;; esac
    case " $1 " in *' golden '*) echo "$build/golden" ;; esac
    case " $1 " in *' diff '*) echo "$build/diff/difftest $build/unit/vm_select" ;; esac
    case " $1 " in *' soft '*) echo "$build/soft/run" ;; esac
    case " $1 " in *' store '*) echo "$build/store/cuts $build/store/agent $build/store/auth $build/unit/vm_auth $build/store/old.smb $build/store/new.smb" ;; esac
}
compile() { ( cd "$tree" && make -s B="$build" CFLAGS="${CFLAGS:--O0}" WARN=-w $(targets_of "$1") ) >"$build.log" 2>&1; }

# The files of conformance/ whose spec line names one of the clauses.
cases_of() {
    pattern=$(printf '%s' "$1" | sed 's/\./\\./g; s/  */|/g')
    grep -rElZ --include='*.smt' "^spec ([0-9.]+, *)*($pattern)(,|  )" conformance | tr '\0' '\n'
}

random() { "$build/diff/difftest" --first --no-reduce --out="$build/diff/out" "$@"; }

# True if ENGINE does not notice; CLAUSES say which cases it is shown.
survives() {
    cd "$tree" && ulimit -t 100 || exit
    case $2 in
    host) "$build/clauses/steps" && "$build/clauses/memory" "$build/clauses/probe.smb" && "$build/clauses/regions" ;;
    golden) "$build/golden" "$build/smc" tests/golden/column-is-a-byte.smt ;;
    diff)           # IR as images, random programs on the VM, alone against what analyses say of them, in emitted C, and all cases
        "$build/unit/vm_select" && random --count=2000 --no-floors && random --sound --steps=1000 --count=1500 --no-floors &&
            random --count=400 --seed=7000 --cc="${CC:-cc} -std=c99 -O0" && sh tests/emitc/run.sh "$build/smc" readings &&
            "$build/smc" test -O0 conformance && CC="${CC:-cc} -O0" "$build/smc" test --engine=vm,c-soft conformance ;;
    soft) "$build/soft/run" ;;
    store)
        set -- "$build/store/old.smb" "$build/store/new.smb"
        "$build/store/cuts" "$@" && "$build/store/agent" "$@" && "$build/store/auth" "$@" && "$build/unit/vm_auth" ;;
    *) "$build/smc" test --engine="$2" $(cases_of "$1") ;;
    esac >"$build.out" 2>&1
}

silent() {          # CLAUSES ENGINES: those of them that do not notice
    for engine in $2; do
        (survives "$1" "$engine") && printf ' %s' "$engine"
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
    if compile "$3"; then
        bad=$(silent "$2" "$3")
    elif compile ''; then
        bad=                                      # the tests cannot be made with it
    else
        bad=" anything: it does not compile"
        sed 's/^/    /' "$build.log" | head -n 8
    fi
    cp "$4" "$tree/$4"
    echo "${bad:+NOT }noticed${bad:+ by}$bad"
    [ -z "$bad" ]
}

places "$list" | while IFS='|' read -r number clauses engines file; do
    wanted "$number" "$clauses" "$engines" "$*" && echo "$number|$clauses|$engines|$file"
done >"$build.list"

# Without any fault nobody must notice; what has been found so of these sources is kept.
for engine in $(cut -d '|' -f 3 "$build.list" | tr ' ' '\n' | sort -u); do
    clauses=$(awk -F '|' -v e="$engine" 'index(" " $3 " ", " " e " ") { print $2 }' "$build.list" | tr ' ' '\n' | sort -u | tr '\n' ' ')
    sound=$build.sound-$engine-$(printf '%s' "$clauses" | cksum | tr ' ' -)
    [ -f "$sound" ] && [ -z "$(find $parts -type f -newer "$sound" | head -n 1)" ] && continue
    compile "$engine" && (survives "${clauses% }" "$engine") || { tail "$build.log" "$build.out"; echo "without any fault: 0 passed, 1 failed"; exit 1; }
    touch "$sound"
done
while IFS='|' read -r number clauses engines file; do
    if judge "$number" "$clauses" "$engines" "$file" </dev/null; then passed=$((passed + 1)); else failed=$((failed + 1)); fi
done <"$build.list"

if [ $# -eq 0 ] && cut -d '|' -f 2 "$build.list" | grep -q .; then
    sed -n 's/^\*\*\([0-9]*\.[0-9]*\)\*\* .*/\1/p' docs/language.md | while read -r clause; do
        grep -Eq "^[0-9]+\|([0-9. ]+ )?$(printf '%s' "$clause" | sed 's/\./\\./')( |\|)" "$build.list" || echo "clause $clause has no mutant"
    done
fi
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
