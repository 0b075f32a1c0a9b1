#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# The interface of libsmc: what smc.h declares is what the library exports; the declarations and constants of earlier versions are still there;
# the library has no data that changes, and imports nothing that prints, opens or ends.       abi.sh B CC
build=$1 cc=$2
. tests/checks.sh
dir=$(mktemp -d) || exit 1
trap 'rm -rf "$dir"' EXIT

# One declaration or constant a line, without blanks at its ends.  The header has no structures, so this is all of the interface.
list_declarations()
{
    printf '#include "compiler/library/smc.h"\n' >"$dir/all.c"
    $cc -E -std=c99 -I. "$dir/all.c" | awk '/^# [0-9]+ "/ { own = $3 ~ /library\/smc\.h"$/; next } /^#/ { next } own' | tr '\n' ' ' |
        sed 's/enum Smc[A-Za-z]* {/\nenum {/g; s/;/;\n/g' | awk '
            /^ *enum \{/ { gsub(/^ *enum \{|\}.*/, ""); n = split($0, part, ","); for (i = 1; i <= n; i++) { gsub(/^ +| +$/, "", part[i]); if (part[i] != "") print part[i] } next }
            { gsub(/  +/, " "); gsub(/^ +| +$/, ""); if ($0 != "" && $0 != ";") print }' | sort
}
list_declarations >"$dir/now"
check "the header has declarations" test "$(wc -l <"$dir/now")" -ge 150
removed() { grep -vxFf "$dir/now" tests/library/abi.txt | grep -v '^#'; }
unchanged() { removed >"$dir/removed"; cat "$dir/removed"; test ! -s "$dir/removed"; }
check "no declaration of this version was changed or removed" unchanged
recorded() { grep -v '^#' tests/library/abi.txt | sort | cmp - "$dir/now"; }
check "each is recorded in tests/library/abi.txt" recorded

if has nm; then
    sed -n 's/.*[ *]\(smc_[a-z0-9_]*\)(.*/\1/p' "$dir/now" | sort >"$dir/declared"
    nm --defined-only -g "$build/lib/libsmc.o" | awk '{ print $3 }' | sort >"$dir/global"
    nm -D --defined-only "$build"/lib/libsmc.so.* | awk '$2 != "w" { print $3 }' | grep -v '^_' | sort >"$dir/exported"
    check "the archive exports what the header declares" cmp "$dir/declared" "$dir/global"
    check "and so does the shared library" cmp "$dir/declared" "$dir/exported"
    nm -u "$build/lib/libsmc.o" | awk '{ print $2 }' | sed 's/^__isoc[0-9]*_//' | grep -Ev '^(malloc|free|mem(cpy|move|set|cmp|chr)|str[a-z]*|v?snprintf|sscanf|qsort|bsearch|_?_?setjmp|longjmp|(new|free|use)locale|_GLOBAL_OFFSET_TABLE_|__(asan|ubsan|tsan|stack_chk|gcov|sanitizer)_.*|__v?snprintf_chk|__mem[a-z]*_chk|__str[a-z]*_chk|__sigsetjmp|__longjmp_chk|__ctype_b_loc)$' >"$dir/imports"
    check "the library imports no function that prints, opens or exits" test ! -s "$dir/imports"
    data() { nm "$build/lib/libsmc.o" | awk '$2 ~ /^[bBcCD]$/ && $3 !~ /^__odr_asan/' >"$dir/data"; cat "$dir/data"; test ! -s "$dir/data"; }
    check "and has no data that changes" data
else
    skip "exports (apt-get install binutils)"
fi
finish library-abi
