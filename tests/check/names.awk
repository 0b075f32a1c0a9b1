# SPDX-License-Identifier: Apache-2.0
# Checks names and sizes in the product: files of compiler/ have unique base names, types have unique names, no function has more
# than 90 lines.  Input: names.txt (the exceptions), then the names of the source files, one per line.

function complain(kind, name, what) {
    if ((kind, name) in excepted)
        used[kind, name] = 1
    else {
        print what
        bad++
    }
}

# A .c, .h and .def in one folder are one file.
function check_file(file,    folder, base) {
    folder = base = file
    sub(/\/[^\/]*$/, "", folder)
    sub(/.*\//, "", base)
    sub(/\..*/, "", base)
    if (base in folder_of && folder_of[base] != folder)
        complain("file", base, file ": the base name " base " is also in " folder_of[base])
    folder_of[base] = folder
    files++
}

# One file can define a type several times, in the branches of an #if.
function check_type(name, file, n) {
    if (!(name in type_in)) {
        type_in[name] = file
        types++
    } else if (type_in[name] != file && !((file, name) in reported)) {
        reported[file, name] = 1
        complain("type", name, file ":" n ": type " name " is also defined in " type_in[name])
    }
}

# The name in "static bool parse_line(Parser *p, ..." or in a line that continues such parameters: then nothing.
function function_name(line) {
    if (line ~ /^[a-zA-Z_]/ && match(line, /[A-Za-z_0-9]+\(/))
        return substr(line, RSTART, RLENGTH - 1)
    return ""
}

function read_source(file,    line, n, name, start, part) {
    name = ""
    start = 0
    for (n = 1; (getline line < file) > 0; n++) {
        if (line ~ /^typedef (struct|enum|union) [A-Z][A-Za-z0-9_]* *\{/ || line ~ /^(struct|enum|union) [A-Z][A-Za-z0-9_]* *\{/) {
            split(line, part, /[ {]+/)
            check_type(part[line ~ /^typedef/ ? 3 : 2], file, n)
        } else if (line ~ /^} [A-Z][A-Za-z0-9]*;/) {
            split(line, part, /[ ;]/)
            check_type(part[2], file, n)
        } else if (line ~ /^typedef [^(]*[ *][A-Z][A-Za-z0-9]*(\[[^]]*\])?;/ && line !~ /^typedef (struct|enum|union) ([A-Za-z0-9]+) \2;/) {
            sub(/(\[[^]]*\])?;.*/, "", line)
            if (line !~ /^typedef (struct|enum|union) /) {
                sub(/.*[ *]/, "", line)
                check_type(line, file, n)
            }
        } else if (line ~ /^typedef VEC\(.*\) [A-Z][A-Za-z0-9]*;/) {
            sub(/;.*/, "", line)
            sub(/.* /, "", line)
            check_type(line, file, n)
        }
        if (start == 0 && function_name(line) != "")
            name = function_name(line)
        if (line == "{")
            start = n
        if (line ~ /^}/) {
            if (start > 0) {
                functions++
                if (n - start - 1 > 90)
                    complain("function", name, file ":" start ": " name " has " n - start - 1 " lines, at most 90 are allowed")
            }
            start = 0
        }
    }
    close(file)
}

FILENAME ~ /names\.txt$/ {
    if (/^(file|type|function) /) {
        if (!/\| *[^ ]/)
            complain("", "", "names.txt:" FNR ": an exception needs a reason")
        excepted[$1, $2] = FNR
    }
    next
}

/^compiler\// { check_file($0) }
/\.[ch]$/ { read_source($0) }

END {
    for (key in excepted)
        if (!(key in used)) {
            split(key, part, SUBSEP)
            print "tests/check/names.txt:" excepted[key] ": " part[1] " " part[2] " is not an exception any more: remove this line"
            bad++
        }
    if (files < 100 || types < 100 || functions < 1000) {
        print "names: nothing was checked: " files + 0 " files, " types + 0 " types, " functions + 0 " functions"
        bad++
    }
    print files + types + functions " passed, " bad + 0 " failed"
    exit bad > 0
}
