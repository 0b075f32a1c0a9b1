# SPDX-License-Identifier: Apache-2.0
# Checks that what documents refer to exists.  Input: the names of the files of the tree, a line `--`, the names of documents.
#
#   1. The target of each relative link is a file or folder, and the heading of `page.md#heading` is in that page.
#   2. Each code span that begins with a top folder, as `compiler/ir/ir.h`, is a file or folder; `*` and `NAME` match any name.
#   3. In pages that describe the source (the READMEs of folders, codemap.md, design.md), each code span that is the name of a
#      file of C, as `ir.h` or `ir/ir.h`, is the end of the path of a file.

function complain(what) {
    print page ":" n ": " what
    failed++
}

# Removes `FOLDER/..` from a path.
function normalise(path) {
    while (sub(/[^\/]+\/\.\.\//, "", path))
        continue
    sub(/[^\/]+\/\.\.$/, ".", path)
    gsub(/\/\.\//, "/", path)
    sub(/^\.\//, "", path)
    sub(/\/$/, "", path)
    return path
}

# Whether a path exists.  One with `*` is compared with every file and folder.
function exists(path,    pattern, f) {
    if (index(path, "*") == 0)
        return path in file || path in folder
    pattern = path
    gsub(/[.+]/, "\\\\&", pattern)
    gsub(/\*/, "[^/]*", pattern)
    for (f in file)
        if (f ~ "^" pattern "(/|$)")
            return 1
    return 0
}

# The name by which Markdown links to a heading.
function anchor(heading) {
    heading = tolower(heading)
    gsub(/`/, "", heading)
    gsub(/[^a-z0-9 _\200-\377-]/, "", heading)
    gsub(/ /, "-", heading)
    return heading
}

function read_headings(target,    line, fenced) {
    if (target in headings_of)
        return
    headings_of[target] = 1
    while ((getline line < target) > 0) {
        if (line ~ /^```/)
            fenced = !fenced
        if (!fenced && sub(/^#+ +/, "", line))
            heading[target, anchor(line)] = 1
    }
    close(target)
}

function check_link(to,    at, path, part) {
    if (to ~ /^[a-z]+:/)
        return
    checked++
    path = to
    at = index(to, "#")
    if (at) {
        path = substr(to, 1, at - 1)
        part = substr(to, at + 1)
    }
    path = path == "" ? page : normalise(base path)
    if (!exists(path) && path != ".") {
        complain("the link leads to " path ", which does not exist")
        return
    }
    if (part != "") {
        read_headings(path)
        if (!((path, part) in heading))
            complain(path " has no heading '" part "'")
    }
}

function check_span(span) {
    sub(/:[0-9]+$/, "", span)
    gsub(/NAME/, "*", span)
    if (span !~ /^[A-Za-z0-9_.*\/-]+$/)
        return
    if (span ~ top) {
        checked++
        if (!exists(normalise(span)))
            complain(span " does not exist")
    } else if (describes_source && span ~ /^[A-Za-z0-9_\/-]+\.(c|h|def|S)$/ && span !~ /\.\./) {
        checked++
        if (!((span) in ending))
            complain("no file is named " span)
    }
}

function check_line(line,    span) {
    while (match(line, /`[^`]+`/)) {
        span = substr(line, RSTART + 1, RLENGTH - 2)
        line = substr(line, 1, RSTART - 1) "X" substr(line, RSTART + RLENGTH)
        check_span(span)
    }
    while (match(line, /\]\([^) ]+\)/)) {
        span = substr(line, RSTART + 2, RLENGTH - 3)
        line = substr(line, RSTART + RLENGTH)
        check_link(span)
    }
}

function check_page(    line, fenced) {
    read_headings(page)                           # before the page is open: links can lead to its own headings
    n = 0
    base = page
    if (!sub(/[^\/]*$/, "", base))
        base = ""
    describes_source = page ~ /^(compiler|runtime-c|bytecode-vm|stdlib)\/|^docs\/(codemap|design)\.md$/
    while ((getline line < page) > 0) {
        n++
        if (line ~ /^ *```/)
            fenced = !fenced
        else if (!fenced && line !~ /^    /)
            check_line(line)
    }
    close(page)
}

BEGIN { top = "^(arduino|bytecode-vm|compiler|conformance|docs|editors|examples|runtime-c|stdlib|tests)/" }

$0 == "--" { listed = 1; next }

!listed {
    file[$0] = 1
    path = $0
    for (at = length(path); at > 0; at--)
        if (substr(path, at, 1) == "/") {
            ending[substr(path, at + 1)] = 1
            folder[substr(path, 1, at - 1)] = 1
        }
    next
}

{ page = $0; check_page() }

END {
    print checked - failed " passed, " failed + 0 " failed"
    exit failed > 0 || checked < 100
}
