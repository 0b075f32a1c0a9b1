# SPDX-License-Identifier: Apache-2.0
# Checks that every clause or chapter that the code cites exists.
# Input: docs/language.md, docs/config.md, docs/swapping.md and docs/requirements.md, then the names of the source files, one a line.
#
# A citation names the document: `language.md 7.4`, `config.md 9.4, 9.5`, `language.md 4.7 to 4.10`, or a chapter, `language.md 7`.
# A comment of the product that cites a number without the document, as `// 9.4` or `(6.5)`, is refused.  In the documents themselves a
# number in parentheses is a clause of any: `(5.49)`, `(5.46, 5.47)`.

function complain(what) {
    print what
    bad++
}

function check(number, name, where) {
    cited++
    if (!((name, number) in place))
        complain(where ": " name " has no " (number ~ /\./ ? "clause " : "chapter ") number)
}

# Checks the numbers at the start of text: "7.4", "9.4, 9.5", "4.7 to 4.10 ..."
function check_list(text, name, where) {
    while (match(text, /^[0-9]+(\.[0-9]+)?/)) {
        check(substr(text, 1, RLENGTH), name, where)
        text = substr(text, RLENGTH + 1)
        if (!sub(/^(, (and )?| to | and )/, "", text))
            return
    }
}

function check_comment(text, where,    name, rest) {
    if (where !~ /^tests\// && (text ~ /^\/\/ *[0-9][0-9]?\.[0-9][0-9]?([,:;]|\.? |\.?$)/ || text ~ /\([0-9][0-9]?\.[0-9][0-9]?(\)|[,;:] | to | and )/))
        complain(where ": a citation names its document, as in `language.md 7.4`:  " text)
    rest = text
    while (match(rest, /(language|config|swapping|requirements)\.md( chapter)? [0-9]/)) {
        name = substr(rest, RSTART, index(substr(rest, RSTART), ".md") + 2)
        rest = substr(rest, RSTART + RLENGTH - 1)
        check_list(rest, name, where)
    }
}

# The document that has the clause; any of them, if none has.
function document_of(number,    name) {
    for (name in document)
        if ((name, number) in place)
            return name
    return "language.md"
}

# The documents: their clauses and chapters, then what they cite in parentheses.
FILENAME ~ /\.md$/ {
    name = FILENAME
    sub(/.*\//, "", name)
    if (/^```/)
        fenced = !fenced
    if (/^\*\*[0-9]+\.[0-9]+\*\* /)
        place[name, substr($1, 3, length($1) - 4)] = 1
    if (/^## [0-9]+ /)
        place[name, $2] = 1
    document[name] = 1
    text = $0
    gsub(/`[^`]*`/, "", text)
    while (!fenced && match(text, /\([0-9]+\.[0-9]+(, [0-9]+\.[0-9]+)*\)/)) {
        inner[++inners] = substr(text, RSTART + 1, RLENGTH - 2)
        inner_at[inners] = FILENAME ":" FNR
        text = substr(text, RSTART + RLENGTH)
    }
    next
}

{
    file = $0
    for (n = 1; (getline line < file) > 0; n++)
        if (file ~ /\.def$/ || (at = match(line, /\/\/|\/\*/)))
            check_comment(file ~ /\.def$/ && !match(line, /\/\//) ? line : substr(line, match(line, /\/\/|\/\*/)), file ":" n)
    close(file)
}

END {
    for (i = 1; i <= inners; i++) {
        count = split(inner[i], number, ", ")
        for (k = 1; k <= count; k++)
            check(number[k], document_of(number[k]), inner_at[i])
    }
    print cited - bad " passed, " bad + (cited == 0) " failed"
    exit bad > 0 || cited == 0
}
