# SPDX-License-Identifier: Apache-2.0
# Checks how long the sentences of documents are: at most 35 words, in a cell of a table 30.  Input: the names of documents, one a
# line.  Run with LC_ALL=C.
#
# A sentence ends at a point, a question mark or an exclamation mark, and at the end of its paragraph, list item or cell.  A code
# span is one word, and a link the words of its text.  Signs without a letter or a digit are no words.

function count_words(s,    n, part, i, count) {
    n = split(s, part, " ")
    for (i = 1; i <= n; i++)
        count += part[i] ~ /[A-Za-z0-9]/
    return count + 0
}

function check_sentence(page, line, s, most,    count) {
    count = count_words(s)
    if (count > most) {
        sub(/^ +/, "", s)
        print page ":" line ": a sentence has " count " words, at most " most " are allowed: " substr(s, 1, 70) "..."
        failed++
    } else if (count > 0)
        passed++
}

# Checks the sentences of a paragraph, a list item or a cell.  A point before a small letter ends none: "e.g. this".
function check_unit(page, line, text, most,    sentence) {
    gsub(/`+[^`]*`+/, "X", text)
    gsub(/\]\([^)]*\)/, "", text)
    gsub(/\*/, "", text)
    while (match(text, /[.?!]["')]*( |$)/)) {
        sentence = sentence substr(text, 1, RSTART + RLENGTH - 1)
        text = substr(text, RSTART + RLENGTH)
        if (text !~ /^[a-z]/) {
            check_sentence(page, line, sentence, most)
            sentence = ""
        }
    }
    check_sentence(page, line, sentence text, most)
}

function check_page(page,    command, unit, tab, text) {
    command = "awk -v units=1 -f tests/check/wrap.awk " page
    while ((command | getline unit) > 0) {
        tab = index(unit, "\t")
        text = substr(unit, tab + 1)
        if (sub(/^\|\t/, "", text))
            check_unit(page, substr(unit, 1, tab - 1), text, 30)
        else
            check_unit(page, substr(unit, 1, tab - 1), text, 35)
    }
    close(command)
}

{ check_page($0) }

END {
    print passed + 0 " passed, " failed + 0 " failed"
    exit failed > 0 || passed == 0
}
