#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Every header compiles alone, and can be included twice.
#     headers.sh c FLAGS…         as C99.  A header of compiler/ whose source includes it first is compiled alone by the build; of these only the
#                                 include guard is checked
#     headers.sh targets FLAGS…   those that a target or another program includes (stdlib, bytecode-vm, runtime-c), with soft numbers and as
#                                 C++11, since Arduino sketches are C++
# CC and CXX name the compilers.
CC=${CC:-cc} CXX=${CXX:-c++}
part=$1
shift
passed=0 failed=0 skipped=0
dir=$(mktemp -d "${TMPDIR:-/tmp}/smc-headers.XXXXXX") || exit 1
trap 'rm -rf "$dir"' EXIT

# compiles NAME COMMAND…: the header alone, twice, so that its include guard is tried as well
compiles() {
    header=$1
    shift
    printf '#include "%s"\n#include "%s"\nextern int alone;\n' "$header" "$header" >"$dir/$source"
    if "$@" -I. -fsyntax-only "$dir/$source" >"$dir/log" 2>&1; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "$header does not compile alone: $*"
        head -5 "$dir/log"
    fi
}

# The headers of compiler/ whose source includes them before anything else.  The files os_windows and embed_tool.c are not of every build.
first_included() {
    find compiler -name '*.c' ! -name 'os_*windows*' ! -name embed_tool.c ! -path 'compiler/labview/*' | sort |
        awk '{ while ((getline line <$0) > 0 && line !~ /^#/) { }
               close($0)
               header = $0
               sub(/c$/, "h", header)
               if (line == "#include \"" header "\"") print header }'
}

# guarded HEADER…: the first directives of each header are #ifndef NAME and #define NAME, its last line is #endif
guarded() {
    awk 'function finish() { if (file != "" && (last !~ /^#endif/ || defined != wanted || wanted == "")) { print file " has no include guard"; failed++ } }
        FNR == 1 { finish(); file = FILENAME; wanted = defined = ""; directives = 0 }
        /^#/ { directives++ }
        /^#/ && directives == 1 && $1 == "#ifndef" { wanted = $2 }
        /^#/ && directives == 2 && $1 == "#define" { defined = $2 }
        NF { last = $0 }
        END { finish(); exit failed > 0 }' "$@"
}

check_c() {
    first_included >"$dir/first"
    # shellcheck disable=SC2046
    if guarded $(cat "$dir/first"); then
        passed=$((passed + $(wc -l <"$dir/first")))
    else
        failed=$((failed + 1))
    fi
    source=alone.c
    for header in $(find stdlib bytecode-vm compiler runtime-c -name '*.h' | sort | grep -vxF -f "$dir/first"); do
        case $header in
        */os_windows.h) command -v x86_64-w64-mingw32-gcc >/dev/null 2>&1 || continue
            compiles "$header" x86_64-w64-mingw32-gcc -std=c99 -pedantic -Wall -Wextra -Werror "$@" ;;
        *)  compiles "$header" $CC -std=c99 -pedantic -Wall -Wextra -Werror "$@" ;;
        esac
    done
}

# refused IMAGE RAM: these two limits of the VM do not fit offsets of 16 bits, whose largest value means "too large".
refused() {
    if ! $CC -std=c99 -DSMVM_AT=uint16_t -DSMVM_IMAGE_MAX="$1" -DSMVM_RAM_MAX="$2" -I. -fsyntax-only bytecode-vm/config.h >"$dir/log" 2>&1 &&
       grep -q 'smvm_at_is_too_small' "$dir/log"; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "bytecode-vm/config.h does not refuse images of $1 and memory of $2 bytes with offsets of 16 bits"
    fi
}

check_targets() {
    for header in $(find stdlib bytecode-vm runtime-c -name '*.h' | sort); do
        source=alone.c
        compiles "$header" $CC -std=c99 -pedantic -Wall -Wextra -Werror -DSM_F64_SOFT=1 "$@"
        source=alone.cpp
        if command -v $CXX >/dev/null 2>&1; then
            compiles "$header" $CXX -std=c++11 -pedantic -Wall -Wextra -Werror "$@"
        else
            skipped=$((skipped + 1))
        fi
    done
    refused 0xfffe 0xffff
    refused 0xffff 0xfffe
    source=alone.c
    compiles bytecode-vm/config.h $CC -std=c99 -DSMVM_AT=uint16_t -DSMVM_IMAGE_MAX=0xfffe -DSMVM_RAM_MAX=0xfffe
}

"check_$part" "$@"
echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" -eq 0 ] && [ $((passed + skipped)) -gt 0 ]
