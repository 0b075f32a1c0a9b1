# SPDX-License-Identifier: Apache-2.0
# Compares docs/language.md, docs/config.md, docs/swapping.md and docs/requirements.md with their evidence, in both directions.
# Input: the three, clauses.txt (those that a script cannot show), then the names of the test files, one a line.
# A clause is a line of them that begins `**5.7** `.  Evidence is a .smt file whose header names the clause
# (`spec 5.7, 5.8  Sentence.`), or, for clauses that clauses.txt lists, a C test that says `clause 5.7` in a comment.
# Reports clauses without evidence, evidence for clauses that do not exist, gaps in the numbers, and conformance
# cases without a spec line.

function complain(text) {
    print text
    failed++
}

function found(number, where) {
    if (number in clause) {
        evidence[number]++
    } else
        complain(where ": there is no clause " number)
}

# The numbers at the start of "5.7, 5.8  Sentence."
function read_spec(text, where) {
    while (match(text, /^[0-9]+\.[0-9]+/)) {
        found(substr(text, 1, RLENGTH), where)
        text = substr(text, RLENGTH + 1)
        if (!sub(/^,[ \t]*/, "", text))
            break
    }
    if (text !~ /^[ \t]+[^ \t].*\.$/)
        complain(where ": behind the clauses of a spec line stands a sentence")
}

function read_case(name,    line, n, specs) {
    for (n = 1; (getline line < name) > 0 && line !~ /^-- /; n++)
        if (line ~ /^spec /) {
            specs++
            if (name ~ /^conformance\// || line ~ /^spec [0-9]/)
                read_spec(substr(line, 6), name ":" n)
        }
    if (!specs && name ~ /^conformance\//)
        complain(name ": no line `spec CLAUSE  Sentence.`")
    close(name)
}

function read_c(name,    line, n, number) {
    for (n = 1; (getline line < name) > 0; n++)
        while (match(line, /clause [0-9]+\.[0-9]+/)) {
            number = substr(line, RSTART + 7, RLENGTH - 7)
            line = substr(line, RSTART + RLENGTH)
            if (number in by_c)
                evidence[number]++
            else
                complain(name ":" n ": clause " number " is not listed in tests/check/clauses.txt")
        }
    close(name)
}

FILENAME ~ /\.md$/ && /^\*\*[0-9]+\.[0-9]+\*\* / {
    number = $1
    gsub(/\*/, "", number)
    split(number, part, ".")
    if (part[2] != last[part[1]] + 1)
        complain(FILENAME ":" FNR ": clause " number " does not follow " part[1] "." last[part[1]] + 0)
    last[part[1]] = part[2]
    clause[number] = ++count
    order[count] = number
}

FILENAME ~ /clauses\.txt$/ && /^[0-9]/ {
    by_c[$1] = 1
    if (!($1 in clause))
        complain("tests/check/clauses.txt:" FNR ": there is no clause " $1)
    if (NF < 2)
        complain("tests/check/clauses.txt:" FNR ": no reason given")
}

FILENAME == "-" && /\.smt$/ { read_case($0) }
FILENAME == "-" && /\.c$/   { read_c($0) }

END {
    for (i = 1; i <= count; i++)
        if (!evidence[order[i]])
            complain("clause " order[i] " has no case")
    printf "%d passed, %d failed\n", count, failed + (count == 0)
    exit (failed > 0 || count == 0)
}
