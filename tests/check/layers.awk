# SPDX-License-Identifier: Apache-2.0
# Checks every include of ours against layers.txt.  Input: layers.txt, then the names of the files to look at, one a line.

# The layer of a path: the longest that it begins with, at a border of words ("compiler/script/ref" holds ref_eval.c).
function layer_of(path,    name, best) {
    best = ""
    for (name in known)
        if (index(path, name) == 1 && substr(path, length(name) + 1, 1) !~ /[A-Za-z0-9]/ && length(name) > length(best))
            best = name
    return best
}

function may(from, path,    to) {
    to = layer_of(path)
    return from == "" || to == from || (from, path) in allowed || (to != "" && (from, to) in allowed)
}

function look(file, line,    path) {
    path = line
    sub(/^[ \t]*#[ \t]*include[ \t]*"/, "", path)
    sub(/".*/, "", path)
    seen++
    if (may(layer_of(file), path))
        return
    print file ": may not include \"" path "\": layer " layer_of(file) " may include:" list[layer_of(file)]
    bad++
}

FNR == NR && /^[a-z]/ {
    name = $1
    sub(/:$/, "", name)
    known[name] = 1
    for (i = 2; i <= NF; i++) {
        allowed[name, $i] = 1
        list[name] = list[name] " " $i
    }
}

FNR != NR {
    while ((getline line < $0) > 0)
        if (line ~ /^[ \t]*#[ \t]*include[ \t]*"/)
            look($0, line)
    close($0)
}

END {
    print seen - bad " passed, " bad + (seen == 0) " failed"
    exit bad > 0 || seen == 0
}
