# SPDX-License-Identifier: Apache-2.0
# Checks that comments, documents and messages avoid the words of words.txt.  Input: words.txt, then the names of files, one a line.
#
# It reads the comments of C and assembly, all of .def files, and of documents everything outside fenced examples and `code`.
# -v least=N: the least number of lines to be checked, instead of 100.

function complain(what) {
    print what
    bad++
}

function trim(s) {
    sub(/^ +/, "", s)
    sub(/ +$/, "", s)
    return s
}

# Lower case, with one blank around each word; what ends a clause is " ; ".
function plain(s) {
    s = tolower(s)
    gsub(/`[^`]*`/, " x ", s)
    gsub(/[.,:;!?()]/, " ; ", s)
    gsub(/[^a-z0-9;'_-]+/, " ", s)
    return " ; " s " "
}

function is_left(file,    name) {
    for (name in left)
        if (file == name || index(file, name "/") == 1) {
            has_file[name] = 1
            return 1
        }
    return 0
}

function check_line(file, n, s,    i) {
    s = plain(s)
    for (i = 1; i <= words; i++)
        if (index(s, pattern[i]) && !((file, word[i]) in allowed))
            complain(file ":" n ": '" word[i] "': write " use[i])
        else if (index(s, pattern[i]))
            used[file, word[i]] = 1
    checked++
}

# The comment in a line of C or assembly, or nothing.  `inside`: of /* */ that began before.
function comment_of(line,    at) {
    if (inside) {
        if (index(line, "*/"))
            inside = 0
        return line
    }
    if ((at = index(line, "/*")) && !index(substr(line, at), "*/"))
        inside = 1
    if (at)
        return substr(line, at)
    if ((at = match(line, /(^|[^:"'])\/\/ ?/)))
        return substr(line, at)
    return ""
}

function check_file(file,    line, n, fenced, s) {
    inside = 0
    while ((getline line < file) > 0) {
        n++
        if (file ~ /\.md$/) {
            if (line ~ /^ *```/)
                fenced = !fenced
            s = fenced || line ~ /^    / ? "" : line
        } else if (file ~ /\.[chS]$/)
            s = comment_of(line)
        else
            s = line
        if (s != "")
            check_line(file, n, s)
    }
    close(file)
    files++
}

FILENAME ~ /words\.txt$/ {
    if ($1 == "leave") {
        left[$2] = FNR
        if (!/\| *[^ ]/)
            complain("words.txt:" FNR ": a file that is left out needs a reason")
    }
    if ($1 == "word") {
        split(substr($0, 6), part, "|")
        word[++words] = trim(part[1])
        use[words] = trim(part[2])
        pattern[words] = " " word[words] " "
        sub(/^ -/, " ; ", pattern[words])
    }
    if ($1 == "allow") {
        split(substr($0, 7), part, "|")
        at = index(part[1], ":")
        if (trim(part[2]) == "")
            complain("words.txt:" FNR ": an exception needs a reason")
        allowed[substr(part[1], 1, at - 1), trim(substr(part[1], at + 1))] = FNR
    }
    next
}

$0 !~ /\/words\.txt$/ && !is_left($0) { check_file($0) }

END {
    for (key in allowed)
        if (!(key in used)) {
            split(key, part, SUBSEP)
            complain("words.txt:" allowed[key] ": unused exception: " part[1] ": " part[2])
        }
    for (name in left)
        if (!(name in has_file) && !least)
            complain("words.txt:" left[name] ": no file of " name " exists: remove this line")
    if (words < 20 || files < 1 || checked < (least ? least : 100))
        complain("words: nothing was checked")
    print files + 0 " passed, " bad + 0 " failed"
    exit bad > 0
}
