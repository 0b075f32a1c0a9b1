# SPDX-License-Identifier: Apache-2.0
# Checks that every module of the product says what it is for: the comment at the start of its header, its table or its source, or a row
# "//     name.c    purpose" of a header in its folder.  Input: the names of the source files, one a line.
# -v list=1: prints the modules with the first sentence of their purpose instead (`make list-files`).

# Sorts what the files of a module say: a header counts more than a table, a table more than a source.
function rank(file) { return file ~ /\.h$/ ? 3 : file ~ /\.def$/ ? 2 : 1 }

function first_sentence(s,    end) {
    end = match(s, /[.:]  ?[A-Z]/) ? RSTART : length(s)
    s = substr(s, 1, end)
    sub(/[.:]$/, "", s)
    return s
}

function read_file(file,    line, n, stem, folder, text, open, part) {
    stem = folder = file
    sub(/\.[a-z]+$/, "", stem)
    sub(/\/[^\/]*$/, "", folder)
    if (!(stem in best)) {
        best[stem] = 0
        order[++modules] = stem
    }
    suffixes[stem] = suffixes[stem] " " substr(file, length(stem) + 1)
    open = 1
    for (n = 1; (getline line < file) > 0; n++) {
        if (line ~ /^\/\/ +[a-z_0-9]+\.c  +[^ ]/) {
            split(line, part, /^\/\/ +|\.c  +/)
            row[folder "/" part[2]] = part[3]
        }
        if (n > 1 && open) {
            open = line ~ /^\/\/ ?[^ ]/
            if (open)
                text = text (text == "" ? "" : " ") substr(line, 4)
        }
    }
    close(file)
    if (text != "" && rank(file) > best[stem]) {
        best[stem] = rank(file)
        purpose[stem] = text
    }
}

{ read_file($0) }

END {
    for (i = 1; i <= modules; i++) {
        stem = order[i]
        if (!(stem in purpose) && stem in row)
            purpose[stem] = row[stem]
        if (list)
            print stem suffixes[stem] ": " first_sentence(purpose[stem])
        else if (!(stem in purpose)) {
            print stem suffixes[stem] ": no comment at its start says what the module is for"
            bad++
        }
    }
    if (!list) {
        print modules - bad " passed, " bad + (modules < 100) " failed"
        exit bad > 0 || modules < 100
    }
}
