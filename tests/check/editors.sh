#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# editors.sh EDITORS: checks the grammars in editors/.  They are those that the program EDITORS writes, and have every keyword of the compiler.
# Wants python3, to read the JSON files and to try the patterns of TextMate on the lines of editors.txt, and vim, to do so in the editor.
# Uses node with vscode-textmate and vscode-oniguruma, if they are installed.
set -u
editors=$1
textmate=editors/smc.tmLanguage.json vim=editors/vim/syntax/smc.vim
made=$(mktemp -d) || exit 1
trap 'rm -rf "$made"' EXIT
passed=0 failed=0 skipped=0

pass() { passed=$((passed + 1)); }
fail() { failed=$((failed + 1)); echo "editors: $*"; }
has() { command -v "$1" >/dev/null 2>&1; }
skip() { skipped=$((skipped + 1)); echo "editors: wants $1"; }

# Whether a pattern in the file $2 has the word $1.
has_word() { grep -E '"match"|^syn match' "$2" | grep -qE "[(|:]$1[|)]"; }

# Adds the counts at the end of the file $1, and prints what precedes them.  There are at least $2.
add_counts() {
    sed '$d' "$1"
    set -- "$2" $(tail -n 1 "$1")
    case "$#:${2-}${3-}" in 3:*[!0-9]*) set -- "$1" 0 1 ;; 3:*) ;; *) set -- "$1" 0 1 ;; esac
    [ "$2" -ge "$1" ] || fail "only $2 samples agree, of at least $1"
    passed=$((passed + $2)) failed=$((failed + $3))
}

"$editors" textmate >"$made/textmate" && cmp "$made/textmate" $textmate && pass || fail "$textmate is stale: make grammars"
"$editors" vim >"$made/vim" && cmp "$made/vim" $vim && pass || fail "$vim is stale: make grammars"

# The keywords are in both files; without one of them, this check fails.
keywords=$(sed -n 's/^WORD([A-Z]*, *"\([a-z]*\)").*/\1/p' compiler/syntax/tokens.def)
[ "$(echo "$keywords" | wc -l)" -ge 7 ] && pass || fail "tokens.def has fewer than 7 keywords"
for file in $textmate $vim; do
    for word in $keywords; do
        has_word "$word" $file && pass || fail "$file lacks the keyword '$word'"
        sed "s/|$word\\([|)]\\)/\\1/g; s/(:*$word|/(/g; s/?:$word|/?:/g" $file >"$made/without"
        has_word "$word" "$made/without" && fail "the keyword '$word' is found in a copy of $file without it" || pass
    done
done

# Words of the grammar that are in no table: the compiler still compares with them.
awk '/more_words\[\] = {/ { on = 1 } on { print } /};/ { on = 0 }' tests/check/editors.c | grep -oE '"[a-z_]+"' >"$made/words"
[ "$(wc -l <"$made/words")" -ge 30 ] && pass || fail "editors.c has fewer than 30 words that are in no table"
while read -r word; do
    grep -qF "$word" compiler/syntax/*.[ch] compiler/sema/*.[ch] && pass || fail "the compiler has no word $word"
done <"$made/words"

# Each kind of file is listed for each editor.
for kind in sm sv ss io app net rq; do
    grep -q "\"$kind\"" $textmate && grep -q "\"[.]$kind\"" editors/package.json && grep -qE "[*][.]$kind[, ]" editors/vim/ftdetect/smc.vim &&
        pass || fail "an editor does not know files *.$kind"
done

if has python3; then
    for file in $textmate editors/package.json editors/language-configuration.json; do
        python3 -m json.tool $file >/dev/null && pass || fail "$file is not JSON"
    done
    python3 tests/check/editors.py $textmate tests/check/editors.txt >"$made/scopes" || fail "editors.py"
    add_counts "$made/scopes" 50
else
    skip python3
fi
# The same by the packages of VS Code, where they are (NODE_PATH).  Without them, Python's regular expressions are near enough.
if has node && node -e 'require("vscode-textmate"), require("vscode-oniguruma")' 2>/dev/null; then
    node tests/check/editors.js $textmate tests/check/editors.txt >"$made/tokens" || fail "editors.js"
    add_counts "$made/tokens" 50
fi
if has vim && vim --version | grep -q '+syntax'; then
    EDITORS_OUT=$made/groups HOME=$made vim -es -u NONE -i NONE -S tests/check/editors.vim </dev/null >/dev/null 2>&1
    [ -f "$made/groups" ] || echo 'vim wrote nothing' >"$made/groups"
    add_counts "$made/groups" 100
else
    skip "vim with +syntax"
fi
echo "$passed passed, $failed failed$([ $skipped -eq 0 ] || echo ", $skipped skipped")"
[ "$failed" -eq 0 ]
