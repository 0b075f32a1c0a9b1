#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Sources that need no POSIX compile without a warning where `long` has 32 bits and pointers have 64, as on Windows; and by tcc, which
# accepts fewer expressions as constants than gcc and clang.
#     models.sh OPTION…     (those of the Makefile)
cc=x86_64-w64-mingw32-gcc
command -v $cc >/dev/null || { echo "no $cc here (apt-get install gcc-mingw-w64-x86-64): 0 passed, 0 failed, 1 skipped"; exit 0; }
command -v tcc >/dev/null || { echo "no tcc here (apt-get install tcc): 0 passed, 0 failed, 1 skipped"; exit 0; }
passed=0 failed=0
object=$(mktemp "${TMPDIR:-/tmp}/smc-models.XXXXXX") || exit 1          # tcc would replace /dev/null
trap 'rm -f "$object"' EXIT
count() { if "$@"; then passed=$((passed + 1)); else failed=$((failed + 1)); fi; }
for source in $(find compiler stdlib bytecode-vm runtime-c -name '*.c' | sort | grep -v '/os_[a-z_]*posix.c$\|/firmware/\|/psl/\(linux\|avr\|desk\|sbrio\)/'); do
    count $cc "$@" -Werror -fsyntax-only "$source"
    case $source in */os_*windows.c) ;; *) count tcc "$@" -w -c "$source" -o "$object" ;; esac      # tcc has no headers of Windows here
done
[ $passed -gt 600 ] || { failed=$((failed + 1)); echo "only $passed sources"; }
echo "models: $passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
