# SPDX-License-Identifier: Apache-2.0
# Checks that every row of codes.def has an id of its own and the page and test that it promises, and that its flag is in flags.def.
# Input: flags.def, codes.def, codes.txt (exceptions), then the names of the test files, one a line.

function complain(what) {
    print what
    bad++
}

# flags.def: FLAG("dead-code", ALL, …
FILENAME ~ /flags\.def$/ && /^FLAG\("/ {
    split($0, word, "\"")
    if (word[2] in flag)
        complain("flags.def:" FNR ": " word[2] " appears twice")
    flag[word[2]] = FNR
}

# codes.def: DIAG("E0204", unknown_element, …
FILENAME ~ /codes\.def$/ && /^DIAG\("/ {
    if (split($0, word, "DIAG_WARNING, \"") > 1) {
        split(word[2], word, "\"")
        used[word[1]] = 1
        if (!(word[1] in flag))
            complain("codes.def:" FNR ": " word[1] " is no flag of flags.def")
    }
    id = substr($0, 7, 5)
    if (id in row)
        complain("codes.def:" FNR ": " id " appears twice")
    row[id] = FNR
}

# codes.def: DIAG_FOLD(semicolon, … directly below the error of this name
FILENAME ~ /codes\.def$/ && /^DIAG\("/ {
    split($0, word, ", ")
    named = word[2]
    is_error = $0 ~ /^DIAG\("E/
}

FILENAME ~ /codes\.def$/ && /^DIAG_FOLD\(/ {
    split(substr($0, 11), word, ", ")
    if (word[1] != named || !is_error)
        complain("codes.def:" FNR ": a row DIAG_FOLD follows the error that it is about")
}

FILENAME ~ /codes\.txt$/ && /^([EW][0-9]|[a-z])/ {
    if (NF < 2)
        complain("codes.txt:" FNR ": no reason given")
    excused[$1] = 1
}

# A test provokes a code by `#! E0204 …` behind the line, or shows it as the command prints it: [E0204], [W0503 unreachable-state], "code":"E0204".
function look(file, line,    rest, id) {
    rest = line
    while (match(rest, /[EW][0-9][0-9][0-9][0-9]/)) {
        id = substr(rest, RSTART, 5)
        if (line ~ "#! *([EW][0-9].*#! *)?" id || line ~ "\\[" id "[] ]" || line ~ "\"" id "\"") {
            provoked[id] = 1
            if (!(id in row) && !(id in unknown)) {
                unknown[id] = 1
                complain(file ": " id " is no row of codes.def")
            }
        }
        rest = substr(rest, RSTART + 5)
    }
}

FILENAME !~ /(codes|flags)\.(def|txt)$/ {
    while ((getline line < $0) > 0)
        look($0, line)
    close($0)
}

END {
    for (id in row)
        if (!(id in provoked) && !(id in excused))
            complain("codes.def:" row[id] ": " id " is provoked by no test; write one, or give the reason in tests/check/codes.txt")
        else if (id in provoked && id in excused)
            complain("codes.txt: " id " is provoked by a test; remove the excuse")
        else
            good++
    for (name in flag)
        if (name in used && name in excused)
            complain("codes.txt: " name " is used; remove the excuse")
        else if (name in used)
            good++
        else if (!(name in excused))
            complain("flags.def:" flag[name] ": no diagnostic is called " name)
    for (id in excused)
        if (!(id in row) && !(id in flag))
            complain("codes.txt: " id " is no row of codes.def")
    print good + 0 " passed, " bad + 0 " failed"
    exit bad > 0
}
