#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Tests the checks of documents themselves: what wrap.awk wraps and leaves alone, and that sentences.awk and links.awk notice faults.
dir=$(mktemp -d) || exit 1
trap 'rm -rf "$dir"' EXIT
LC_ALL=C
export LC_ALL
passed=0 failed=0

# expect NAME GOT: compares a result with the standard input.
expect() {
    cat >"$dir/want"
    if cmp -s "$dir/want" "$2"; then passed=$((passed + 1)); else failed=$((failed + 1)); echo "$1:"; diff "$dir/want" "$2"; fi
}

wrap() { awk -v width=40 -f tests/check/wrap.awk "$1"; }

cat >"$dir/page.md" <<'END'
# A heading that is longer than forty columns stays as it is

A paragraph of
short lines is filled up to the width of forty columns, and `a code span of several words` is not broken.

- An item of a list is wrapped, and its lines
are indented below its text.
  - A nested item has an indentation of its own, whatever precedes it.

1. Numbered items, too, and
   their second paragraph:

   It belongs to the item, so it has the same indentation.

| a table | is left alone, however wide it becomes |
|---|---|

    indented code is left alone, however wide it becomes

```sh
fenced code is left alone, however wide it becomes
```

[name]: https://example.org/a/link/definition/is/left/alone

This line has exactly forty columns now - and this sign must not begin the next.

A sentence of thirty-nine columns ends 1. and this number must not begin the next line either.

Signs of several bytes: − − − − − − − − − − − − − − − − −
END
wrap "$dir/page.md" >"$dir/wrapped"
expect wrap "$dir/wrapped" <<'END'
# A heading that is longer than forty columns stays as it is

A paragraph of short lines is filled up
to the width of forty columns, and
`a code span of several words` is not
broken.

- An item of a list is wrapped, and its
  lines are indented below its text.
  - A nested item has an indentation of
    its own, whatever precedes it.

1. Numbered items, too, and their second
   paragraph:

   It belongs to the item, so it has the
   same indentation.

| a table | is left alone, however wide it becomes |
|---|---|

    indented code is left alone, however wide it becomes

```sh
fenced code is left alone, however wide it becomes
```

[name]: https://example.org/a/link/definition/is/left/alone

This line has exactly forty columns
now - and this sign must not begin the
next.

A sentence of thirty-nine columns
ends 1. and this number must not begin
the next line either.

Signs of several bytes: − − − − − − − −
− − − − − − − − −
END
wrap "$dir/wrapped" >"$dir/again"
expect "wrap twice" "$dir/again" <"$dir/wrapped"

# words N: a sentence of N words.
words() { awk -v n="$1" 'BEGIN { for (i = 1; i < n; i++) printf "word "; print "`one code span`." }'; }

{ words 35; echo; words 36; echo; printf '| %s | %s |\n|---|---|\n' "$(words 30)" "$(words 31)"; echo '```'; words 99; echo '```'; } >"$dir/page.md"
echo "$dir/page.md" | awk -f tests/check/sentences.awk | sed "s|^$dir/||; s/ are allowed.*//" >"$dir/got"
expect sentences "$dir/got" <<'END'
page.md:3: a sentence has 36 words, at most 35
page.md:5: a sentence has 31 words, at most 30
2 passed, 2 failed
END

mkdir -p "$dir/tree/compiler/ir"
cat >"$dir/tree/README.md" <<'END'
# Title of `this` page

[a file](compiler/README.md), [its heading](compiler/README.md#two-parts), [this page](#title-of-this-page),
[no file](missing.md), [no heading](compiler/README.md#missing), [nor here](#missing)

`compiler/ir/ir.h` `compiler/*/ir.h` `compiler/ir` `any/thing.h`
`compiler/ir/missing.h` `compiler/*/missing.h`
END
cat >"$dir/tree/compiler/README.md" <<'END'
# Two parts

`ir.h` `ir/ir.h` [up](../README.md)
`missing.h` [not up](../missing.md)
END
echo >"$dir/tree/compiler/ir/ir.h"
links=$(pwd)/tests/check/links.awk
(cd "$dir/tree" && { find . -type f | sed 's|^[.]/||'; echo --; find . -name '*.md' | sed 's|^[.]/||' | sort; } | awk -f "$links") >"$dir/got"
expect links "$dir/got" <<'END'
README.md:4: the link leads to missing.md, which does not exist
README.md:4: compiler/README.md has no heading 'missing'
README.md:4: README.md has no heading 'missing'
README.md:7: compiler/ir/missing.h does not exist
README.md:7: compiler/*/missing.h does not exist
compiler/README.md:4: no file is named missing.h
compiler/README.md:4: the link leads to missing.md, which does not exist
9 passed, 7 failed
END
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
