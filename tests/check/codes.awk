# SPDX-License-Identifier: Apache-2.0
# Checks that every row of codes.def has an id of its own and the page and test that it promises.
# Input: codes.def, codes.txt (exceptions), then the names of the test files, one a line.

function complain(what) {
    print what
    bad++
}

# codes.def: DIAG("E0204", unknown_element, …
FILENAME ~ /codes\.def$/ && /^DIAG\("/ {
    id = substr($0, 7, 5)
    if (id in row)
        complain("codes.def:" FNR ": " id " stands twice")
    row[id] = FNR
}

FILENAME ~ /codes\.txt$/ && /^[EW][0-9]/ {
    if (NF < 2)
        complain("codes.txt:" FNR ": no reason given")
    excused[$1] = 1
}

# A test provokes a code by `#! E0204 …` behind the line, or shows it as the command prints it: [E0204], "code":"E0204".
function look(file, line,    rest, id) {
    rest = line
    while (match(rest, /[EW][0-9][0-9][0-9][0-9]/)) {
        id = substr(rest, RSTART, 5)
        if (line ~ "#! *([EW][0-9].*#! *)?" id || line ~ "\\[" id "\\]" || line ~ "\"" id "\"") {
            provoked[id] = 1
            if (!(id in row) && !(id in unknown)) {
                unknown[id] = 1
                complain(file ": " id " is no row of codes.def")
            }
        }
        rest = substr(rest, RSTART + 5)
    }
}

FILENAME !~ /codes\.(def|txt)$/ {
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
    for (id in excused)
        if (!(id in row))
            complain("codes.txt: " id " is no row of codes.def")
    print good + 0 " passed, " bad + 0 " failed"
    exit bad > 0
}
