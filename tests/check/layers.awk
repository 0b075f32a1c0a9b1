# SPDX-License-Identifier: Apache-2.0
# Checks every include of a file of the project against layers.txt; that each permission there is used; and that the includes between
# layers form no cycle.  Input: layers.txt, then the names of the source files, one per line.

# The layer of a path: the longest that it begins with, at a border of words ("compiler/script/ref" holds ref_eval.c).
function layer_of(path,    name, best) {
    best = ""
    for (name in known)
        if (index(path, name) == 1 && substr(path, length(name) + 1, 1) !~ /[A-Za-z0-9]/ && length(name) > length(best))
            best = name
    return best
}

function is_allowed(from, path,    to) {
    to = layer_of(path)
    if (from == "" || to == from)
        return 1
    if ((from, path) in allowed)
        to = path
    used[from, to] = 1
    return to != "" && (from, to) in allowed
}

function check_include(file, line,    path, from, to) {
    path = line
    sub(/^[ \t]*#[ \t]*include[ \t]*"/, "", path)
    sub(/".*/, "", path)
    seen++
    from = layer_of(file)
    to = layer_of(path)
    if (from != "" && to != "" && from != to && !((from, to) in example)) {
        example[from, to] = file " includes \"" path "\""
        targets[from] = targets[from] " " to
    }
    if (is_allowed(from, path))
        return
    print file ": may not include \"" path "\": layer " layer_of(file) " may include:" list[layer_of(file)]
    bad++
}

# Depth-first search: a target that is still on the path closes a cycle.
function find_cycles(node, path,    target, n, i) {
    on_path[node] = 1
    n = split(targets[node], target, " ")
    for (i = 1; i <= n; i++) {
        if (target[i] in on_path) {
            print "layers include each other:" path " " node " " target[i] ": " example[node, target[i]]
            bad++
        } else if (!(target[i] in finished))
            find_cycles(target[i], path " " node)
    }
    delete on_path[node]
    finished[node] = 1
}

FNR == NR && /^[a-z]/ {
    name = $1
    sub(/:$/, "", name)
    known[name] = 1
    for (i = 2; i <= NF; i++) {
        allowed[name, $i] = FNR
        list[name] = list[name] " " $i
    }
}

FNR != NR {
    has_file[layer_of($0)] = 1
    while ((getline line < $0) > 0)
        if (line ~ /^[ \t]*#[ \t]*include[ \t]*"/)
            check_include($0, line)
    close($0)
}

END {
    for (key in allowed) {
        seen++
        if (!(key in used)) {
            split(key, part, SUBSEP)
            print "tests/check/layers.txt:" allowed[key] ": " part[1] " does not include " part[2] ": remove the permission"
            bad++
        }
    }
    for (name in known) {
        seen++
        if (!(name in has_file)) {
            print "tests/check/layers.txt: no file belongs to layer " name
            bad++
        }
        if (!(name in finished))
            find_cycles(name, "")
    }
    print seen - bad " passed, " bad + (seen == 0) " failed"
    exit bad > 0 || seen == 0
}
