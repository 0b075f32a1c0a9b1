# SPDX-License-Identifier: Apache-2.0
# Checks that each spelling in hints.def is on a line of a test case that announces a message (`#! E0329 ...`), and that the rows of
# patterns are in the order of HintContext, which the search relies on.
# Input: hints.h, hints.def, then the names of the cases, one a line.

FILENAME ~ /hints\.h$/ && /^ *HINT_(AT|AFTER)_/ {
    name = $1
    sub(/^HINT_/, "", name)
    sub(/,$/, "", name)
    order[name] = ++places
}

FILENAME ~ /hints\.def$/ && /^HINT(_LABEL)?\(A/ {
    name = $0
    sub(/^[^(]*\(/, "", name)
    sub(/,.*/, "", name)
    if (!(name in order) || order[name] < last) {
        print "hints.def:" FNR ": " name " is not in the order of HintContext"
        bad++
    }
    last = order[name]
    patterns++
}

FILENAME ~ /hints\.def$/ && /^HINT_(TEXT|OPERATOR|ABSENT_OPERATOR|PHRASE|WORD|SYNONYM)\(/ {
    split($0, part, "\"")
    row[++rows] = tolower(part[2])
    place[rows] = FNR
}

function is_word(c) { return c ~ /[a-z0-9_]/ }

# Whether the text contains the spelling, and the spelling is no part of a longer word.
function contains(text, spelling,    at, from, last) {
    last = substr(spelling, length(spelling))
    for (from = 1; (at = index(substr(text, from), spelling)) > 0; from = at + 1) {
        at += from - 1
        if (!(is_word(substr(spelling, 1, 1)) && at > 1 && is_word(substr(text, at - 1, 1))) &&
            !(is_word(last) && is_word(substr(text, at + length(spelling), 1))))
            return 1
    }
    return 0
}

FILENAME !~ /hints\.(h|def)$/ {
    while ((getline line < $0) > 0)
        if (index(line, "#!") > 0)
            marked = marked "\n" tolower(substr(line, 1, index(line, "#!") - 1))
    close($0)
}

END {
    for (i = 1; i <= rows; i++)
        if (!contains(marked, row[i])) {
            print "hints.def:" place[i] ": no case has '" row[i] "' on a line with #!"
            bad++
        }
    print rows + patterns - bad " passed, " bad + (rows == 0 || patterns == 0) " failed"
    exit bad > 0 || rows == 0 || patterns == 0
}
