# SPDX-License-Identifier: Apache-2.0
# Checks calls that report something to the user:
#   1. the {} of every diagnostic get as many arguments where it is reported, because the C compiler cannot count them;
#   2. the same for labels in tables: a row of hints.def or foreign_names.def has an argument exactly if its label has a {};
#   3. no message of the command is written where it is printed: all are in compiler/cli/texts.def, where the C compiler checks them.
#   4. no label is a literal where it is reported: all are in codes.def.
# Input: codes.def, hints.def, foreign_names.def, then the names of the source files, one a line.

function complain(what) {
    print what
    bad++
}

function count_holes(text,    n) {
    n = 0
    while (sub(/\{\}/, "", text))
        n++
    return n
}

# codes.def: the message is between the fourth comma and the page, on the row's first or second line.
FILENAME ~ /codes\.def$/ && /^DIAG_NOTE_TEXT\("?/ {
    name = $0
    sub(/^DIAG_NOTE_TEXT\(/, "", name)
    sub(/,.*/, "", name)
    holes[name] = count_holes($0)
    next
}
FILENAME ~ /codes\.def$/ && /^DIAG\("/ {
    name = $2
    sub(/,$/, "", name)
    holes[name] = count_holes($0)
    spans[name] = 1
    waiting = $0 !~ /"[^"]*",$/ || $0 ~ /(NULL|"[a-z-]*"),$/
    next
}
FILENAME ~ /codes\.def$/ && waiting {
    holes[name] = count_holes($0)
    waiting = 0
}

# Blanks out strings and comments of a line, so that their commas and brackets do not count.
function plain(line) {
    gsub(/\\\\/, "", line)
    gsub(/\\"/, "", line)
    gsub(/"[^"]*"/, "S", line)
    gsub(/'[^']*'/, "C", line)
    sub(/\/\/.*/, "", line)
    return line
}

# `text` begins behind the ( of a call.  Splits it into arguments, up to the ) that closes it.
function split_arguments(text, out,    i, c, depth, n) {
    n = 1
    out[1] = ""
    depth = 0
    for (i = 1; i <= length(text); i++) {
        c = substr(text, i, 1)
        if (c == ")" && depth == 0)
            return n
        depth += (c ~ /[({[]/) - (c ~ /[)}\]]/)
        if (c == "," && depth == 0)
            out[++n] = ""
        else
            out[n] = out[n] c
    }
    return n
}

function check_code(file, code, arguments) {
    if (!(code in holes))
        return
    seen++
    if (arguments - (code in spans) != holes[code])
        complain(file ": DIAG_" code " has " holes[code] " {}, and is given " arguments - (code in spans) " arguments")
}

# Checks a row of a table: column `label` names a row of codes.def, and the last column is the argument of that label, or `none` without one.
function check_row(row, label, none,    part) {
    sub(/^[^(]*\(/, "", row)
    if (split_arguments(plain(row), part) != label + 1)
        complain(FILENAME ":" FNR ": a row of " label + 1 " columns is expected")
    gsub(/ /, "", part[label])
    rows++
    check_code(FILENAME ":" FNR, part[label], row !~ (", *" none "\\)"))
}

FILENAME ~ /hints\.def$/ {
    if (/^HINT_LABEL\(/)
        check_row($0, 6, "NULL")
    next
}
FILENAME ~ /foreign_names\.def$/ {
    if (/^FOREIGN_(NAME|FUNCTION)\(/)
        check_row($0, 2, "\"\"")
    next
}

function check_call(file, text,    n, i, part, rest) {
    n = split_arguments(text, part)
    for (i = 1; i <= n; i++) {
        rest = part[i]
        sub(/(diag_report|diag_note|diag_note_step|diag_label|diag_text|parser_report|parser_fail)\(.*/, "", rest)      # a call of its own
        while (match(rest, /(^|[^A-Za-z0-9_])DIAG_[a-z][a-z0-9_]*/)) {
            code = substr(rest, RSTART, RLENGTH)
            sub(/.*DIAG_/, "", code)
            check_code(file, code, n - i)
            rest = substr(rest, RSTART + RLENGTH)
        }
    }
}

FILENAME !~ /codes\.def$/ {
    text = ""
    while ((getline line < $0) > 0)
        text = text " " plain(line)
    close($0)
    rest = text
    while (match(rest, /cli_(print_error|print_note|usage_error)\([^(,]*, [^;]*/)) {
        call = substr(rest, RSTART, RLENGTH)
        rest = substr(rest, RSTART + RLENGTH)
        if (call ~ /TEXT_/) {
            seen++
            texts++
        }
        if (call ~ /^cli_[a-z_]*\([^(,]*, (S|[^,]*\? S|[^,]*: S)/)
            complain($0 ": a message is a literal here; it belongs into compiler/cli/texts.def")
    }
    while (match(text, /(diag_report|diag_note|diag_note_step|diag_label|diag_text|parser_report|parser_fail)\(/)) {
        text = substr(text, RSTART + RLENGTH)
        check_call($0, substr(text, 1, 600))
        if (text ~ /^[^;]*DIAG_label_text, *S/)
            complain($0 ": the text of a label is a literal here; it belongs into compiler/diag/codes.def")
    }
}

END {
    if (texts == 0)
        complain("no call of cli_print_error, cli_print_note or cli_usage_error was found: have they other names now?")
    if (rows == 0)
        complain("no row of hints.def or foreign_names.def was found: have they other names now?")
    print seen - bad " passed, " bad + (seen == 0) " failed"
    exit bad > 0 || seen == 0
}
