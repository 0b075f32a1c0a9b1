# SPDX-License-Identifier: Apache-2.0
# Wraps the prose of a Markdown document at 100 columns: reads one document, writes it wrapped.  Run with LC_ALL=C, so that every
# awk counts bytes (a UTF-8 character is one column).
#
#     -v width=N     another width
#     -v units=1     writes no document, but its prose: a line `LINE TAB text` for each paragraph and list item, and
#                    `LINE TAB | TAB text` for each cell of a table (for sentences.awk)
#
# Prose is the text of paragraphs and list items.  Everything else is copied: fenced and indented code, tables,
# headings, rules, link definitions, HTML.  Invariants:
#   1. A code span is never broken, and no line begins with what Markdown would read as the beginning of a block.
#   2. A line is longer than `width` only if it consists of one word or code span.
#   3. The result of wrapping a wrapped document is the same document.

function columns(s) {
    gsub(/[\200-\277]/, "", s)
    return length(s)
}

function blanks(n,    s) {
    s = sprintf("%" n "s", "")
    return n > 0 ? s : ""
}

# The length of the code span at the beginning of s, or 0.
function span_length(s,    n, rest, at) {
    match(s, /^`+/)
    n = RLENGTH
    at = n
    rest = substr(s, n + 1)
    while (match(rest, /`+/)) {
        at += RSTART + RLENGTH - 1
        if (RLENGTH == n)
            return at
        rest = substr(rest, RSTART + RLENGTH)
    }
    return 0
}

# Whether a word must not begin a line: Markdown would read that line as something else than prose, or it is a percent sign.
function must_follow(word) {
    return word ~ /^([-+*%]|[0-9]+[.)]|#+|=+|-+)$/ || word ~ /^(>|\||```|~~~|<[A-Za-z\/!?])/
}

# Splits the text into words.  A code span belongs to one word, and a word that must not begin a line to the word before it.
function split_words(text,    at, c, n, current) {
    words = 0
    current = ""
    for (at = 1; at <= length(text) + 1; at += n) {
        c = substr(text, at, 1)
        n = 1
        if (c == " " || c == "") {
            if (current != "" && words > 0 && must_follow(current))
                word[words] = word[words] " " current
            else if (current != "")
                word[++words] = current
            current = ""
        } else {
            if (c == "`" && (n = span_length(substr(text, at))) == 0) {
                match(substr(text, at), /^`+/)
                n = RLENGTH
            }
            current = current substr(text, at, n)
        }
    }
}

# Writes the collected paragraph.  `mark` is what precedes its first line ("- ", ">"), `indent` the column of the others.
function end_paragraph(    i, line) {
    if (paragraph == "")
        return
    if (units)
        print start "\t" paragraph
    else {
        split_words(paragraph)
        line = mark word[1]
        for (i = 2; i <= words; i++)
            if (columns(line " " word[i]) <= width)
                line = line " " word[i]
            else {
                print line
                line = blanks(indent) word[i]
            }
        print line
    }
    paragraph = ""
}

function begin_paragraph(prefix, column, text) {
    paragraph = text
    mark = prefix
    indent = column
    start = FNR
}

function verbatim() {
    end_paragraph()
    if (!units)
        print
}

# Writes a row of a table, or its cells: `|` in a code span or after a backslash separates none.
function table_row(    row, n, c, cell) {
    end_paragraph()
    if (!units) {
        print
        return
    }
    row = $0
    sub(/^ *\|/, "", row)
    for (cell = ""; row != ""; row = substr(row, n + 1)) {
        c = substr(row, 1, 1)
        n = 1
        if (c == "\\")
            n = 2
        else if (c == "`")
            n = span_length(row) ? span_length(row) : 1
        if (c == "|") {
            print FNR "\t|\t" cell
            cell = ""
        } else
            cell = cell substr(row, 1, n)
    }
}

# Leaves the list items that a line with this indentation does not belong to.
function leave_lists(column) {
    while (depth > 0 && column < content[depth])
        depth--
}

BEGIN {
    if (!width)
        width = 100
}

{
    sub(/\r$/, "")
    match($0, /^ */)
    column = RLENGTH
    text = substr($0, column + 1)
}

fence != "" {
    verbatim()
    if (index(text, fence) == 1)
        fence = ""
    next
}

/^[ \t]*$/ {
    verbatim()
    after_blank = 1
    html = 0
    next
}

html { verbatim(); next }

# After a blank line the indentation decides which list item a line belongs to, and whether it is code.
after_blank || paragraph == "" {
    leave_lists(column)
    if (column >= content[depth] + 4 && (after_blank || code)) {
        code = 1
        after_blank = 0
        verbatim()
        next
    }
}

{ code = 0; after_blank = 0 }

text ~ /^(```|~~~)/ {
    verbatim()
    fence = substr(text, 1, 3)
    next
}

text ~ /^\|/ { table_row(); next }

text ~ /^#+ / || text ~ /^(---+|\*\*\*+|===+)$/ || text ~ /^\[[^]]+\]: / { verbatim(); next }

text ~ /^<[A-Za-z\/!?]/ && text !~ /^<[a-z]+:/ && paragraph == "" {
    verbatim()
    html = 1
    next
}

text ~ /^([-+*]|[0-9]+[.)]) / {
    end_paragraph()
    leave_lists(column)
    match(text, /^[^ ]+ +/)
    content[++depth] = column + RLENGTH
    begin_paragraph(blanks(column) substr(text, 1, RLENGTH), column + RLENGTH, substr(text, RLENGTH + 1))
    next
}

{
    if (paragraph == "")
        begin_paragraph(blanks(content[depth]), content[depth] + 0, text)
    else
        paragraph = paragraph " " text
    if (text ~ /\\$/)                            # a hard line break
        end_paragraph()
}

END { end_paragraph() }
