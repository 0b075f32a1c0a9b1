#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Prints the names of the project's files of one kind, one a line, sorted, for the checks of this folder.
#     files.sh code | text | sources | product | compiler | cases | documents | evidence
#   code      sources: C, tables, scripts, makefiles
#   text      all files with words in them
#   sources   C, assembly, tables
#   product   the sources that are compiled into the products
#   compiler  the C files of compiler/
#   cases     the .smt files
#   documents the .md files
#   evidence  the .smt files, and the C tests that cite clauses
case $1 in
code)     find stdlib compiler bytecode-vm runtime-c arduino tests examples -name '*.[ch]' -o -name '*.def' -o -name '*.awk' -o -name '*.sh' \
              -o -name '*.cpp' -o -name '*.mk'
          echo Makefile ;;
text)     find stdlib compiler bytecode-vm runtime-c arduino tests examples conformance docs editors -type f 2>/dev/null
          find python -name build -prune -o -name '*.py' -print -o -name '*.md' -print -o -name '*.toml' -print
          ls README.md CONTRIBUTING.md Makefile ;;
sources)  find stdlib compiler bytecode-vm runtime-c arduino tests -name '*.[chS]' -o -name '*.def' ;;
product)  find stdlib compiler bytecode-vm runtime-c -name '*.[ch]' -o -name '*.def' ;;
compiler) find compiler -name '*.c' ;;
documents) sh "$0" text | grep '[.]md$' ;;
cases)    find conformance tests -name '*.smt' ;;
evidence) find conformance tests -name '*.smt'
          ls tests/clauses/*.c tests/net/*.c tests/runtime/*.c tests/swap/*.c ;;
*)        echo "files.sh: unknown kind '$1'" >&2
          exit 2 ;;
esac | sort
