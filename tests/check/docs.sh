#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Runs the examples of the documentation: docs.sh SMC FOLDER PAGE…   Each page has a folder of its own below FOLDER, in which
# its files stand and its commands run; the examples of the tree are reachable from there.  See docs.awk for the fences.
smc=$1
folder=$2
shift 2
root=$(pwd)
case $smc in /*) ;; *) smc=$root/$smc ;; esac
case $folder in /*) ;; *) folder=$root/$folder ;; esac
passed=0 failed=0

say_wrong() { echo "$1:$2: this example does not do what the page says"; sed 's/^/    /' "$folder/out"; failed=$((failed + 1)); }

# A source without a mistake or a doubt, or one with mistakes (!).
check_source() { if [ "$2" = ! ]; then "$smc" check "$1"; test $? -eq 1; else "$smc" check -Werror "$1"; fi; }

# Puts a section into a file: in the place of its section of that name, or at the end.
put_section() {
    awk 'FNR == NR { if (FNR == 1) header = $1; block = block $0 "\n"; next }
         /^\[/     { inside = $1 == header; if (inside) { printf "%s\n", block; done = 1 } }
         !inside   { print }
         END       { if (!done) printf "\n%s", block }' "$1" "$2" >"$2.new" && mv "$2.new" "$2"
}

# Whether the lines of a block are in a file, one after another.
stands_in() {
    awk 'FNR == NR { part = part $0 "\n"; next } { all = all $0 "\n" } END { exit index("\n" all, "\n" part) == 0 }' "$1" "$2"
}

run_block() {                             # NUMBER KIND NAME OTHER, in the page's folder; prints to $folder/out
    block=$folder/blocks/$1.block
    case $2 in
    console) PATH=$folder/bin:$PATH NO_COLOR=1 awk -f "$root/tests/check/console.awk" "$block" ;;
    c|csv|app|make|sh|yaml) cp "$block" "$3" ;;
    smt)     cp "$block" case.smt && "$smc" test case.smt ;;
    io)      cp "$block" "$3" && "$smc" check -Werror "$3" --sv "$4" ;;
    rq)      cp "$block" "$3" && "$smc" check -Werror "$4" "$3" ;;
    ss)      cp "$block" "$3" && { [ -z "$4" ] || "$smc" test -Werror "$4" "$3"; } ;;
    *)       case $4 in
             =)  stands_in "$block" "$root/$3" ;;
             +*) put_section "$block" "$3" && check_source "$3" "${4#+}" ;;
             *)  cp "$block" "$3" && check_source "$3" "$4" ;;
             esac ;;
    esac >"$folder/out" 2>&1
}

rm -rf "$folder"
mkdir -p "$folder/blocks" "$folder/bin"
ln -s "$smc" "$folder/bin/smc"
for page; do
    place=$folder/$(printf '%s' "$page" | tr / _)
    mkdir -p "$place/build"
    # (-n: where two of these run at once, a link is not made inside of what the other's leads to.)
    ln -sfn "$smc" "$place/build/smc"
    ln -sfn "$root/examples" "$place/examples"
    ln -sfn "$root" "$place/smc"
    if ! awk -v out="$folder/blocks" -f tests/check/docs.awk "$page" >"$folder/list" 2>"$folder/out"; then
        say_wrong "$page" 1
        continue
    fi
    while IFS='|' read -r number line kind name other; do
        if ( cd "$place" && run_block "$number" "$kind" "$name" "$other" ); then
            passed=$((passed + 1))
        else
            say_wrong "$page" "$line"
        fi
    done <"$folder/list"
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
