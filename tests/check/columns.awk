# SPDX-License-Identifier: Apache-2.0
# No line of code has more than 150 columns, except in macros and in the snippets of stdlib/, which emitted C contains line by line.  Files
# that are not wrapped yet are in columns.txt, one a line with the number of their longer lines: a number can fall, and not grow.
# Input: columns.txt, then the names of the source files, one a line.
BEGIN { MOST = 150 }

function count_long(file,    line, n, in_macro) {
    while ((getline line < file) > 0) {
        gsub(/[\200-\277]/, "", line)                 # the bytes of a character after its first one
        if (length(line) > MOST && !in_macro && line !~ /^ *#/)
            n++
        in_macro = line ~ /\\$/
        read++
    }
    close(file)
    return n + 0
}

FNR == NR {
    if ($0 !~ /^#/ && NF == 2)
        allowed[$1] = $2
    next
}
/\.[ch]$/ && !/^stdlib\// && !/^tests\// {
    long = count_long($0)
    if (long > allowed[$0] + 0) {
        printf "%s: %d lines have more than %d columns, and %d are allowed: wrap them\n", $0, long, MOST, allowed[$0]
        failed++
    } else
        passed++
}
END {
    printf "%d passed, %d failed\n", passed, failed
    exit failed > 0 || passed < 600 || read < 80000
}
