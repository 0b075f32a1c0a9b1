# SPDX-License-Identifier: Apache-2.0
# A loop without braces at the end of a function cannot end with `return`: the loop has to have braces.  tcc 0.9.27 emits no jump for a
# `return` that is followed by the function's closing brace, so such a loop would go on.  Input: the names of the source files, one a line.

function indent(line) {
    match(line, /^ */)
    return RLENGTH
}

# Whether the last statement of the function is such a loop.  text[1] to text[n] are the lines between the function's braces, each of
# which is indented.  From its last line on, the lines that enclose it are those that are indented less and less.
function ends_in_loop(    k, outer) {
    if (text[n] !~ /(^|[^A-Za-z0-9_])return([^A-Za-z0-9_].*)?;/ || text[n] ~ /[}] *$/)
        return 0
    outer = indent(text[n]) + 1
    for (k = n; k > 0 && outer > 4; k--)
        if (text[k] !~ /^ *$/ && indent(text[k]) < outer) {
            outer = indent(text[k])
            if (text[k] ~ /^ *(else )?(for|while|do)([^A-Za-z0-9_]|$)/)
                return 1
        }
    return 0
}

function read_source(file,    line, number) {
    n = -1
    for (number = 1; (getline line < file) > 0; number++) {
        if (line ~ /^[{]$/) {
            n = 0
        } else if (line ~ /^[}]/ && n > 0) {
            functions++
            if (ends_in_loop()) {
                print file ":" number - 1 ": a loop without braces ends the function with `return`"
                bad++
            }
            n = -1
        } else if (n >= 0) {
            text[++n] = line
        }
    }
    close(file)
}

{ read_source($0) }

END {
    print functions - bad " passed, " bad + (functions == 0) " failed"
    exit bad > 0 || functions == 0
}
