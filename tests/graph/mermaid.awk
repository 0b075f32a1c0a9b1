# SPDX-License-Identifier: Apache-2.0
# Whether a text is a Mermaid state diagram of the simple kind: each line one of a few, every state declared before it is used, no
# character in a text that could mean something.
function plain(text) {
    gsub(/#[0-9]+;/, "", text)
    return text !~ /[^A-Za-z0-9_ .,()+*\/=-]/ && text !~ /--[>-]/
}
function known(state) { return state == "[*]" || state in states }
function after(mark) { return substr($0, index($0, mark) + length(mark)) }

NR == 1 { good = $0 == "stateDiagram-v2"; next }
NR == 2 { good = good && $0 == "    %% drawn by smc"; next }
/^    classDef [a-z]+ [a-z:#0-9,-]+$/ { classes[$2] = 1; next }
/^    state "[A-Za-z_][A-Za-z0-9_]*" as s[0-9]+$/ { states[$4] = 1; next }
/^    state "all states( except [A-Za-z0-9_, ]+)?" as s[0-9]+$/ { states[$NF] = 1; next }
/^    \[\*\] --> s1$/ && known($3) { next }
/^    s[0-9]+ : ./ && known($1) && plain(after(" : ")) { next }
/^    s[0-9]+ --> s[0-9]+ : ./ && known($1) && known($3) && plain(after(" : ")) { next }
/^    class s[0-9]+ [a-z]+$/ && known($2) && $3 in classes { next }
/^    note right of s[0-9]+ : ./ && known($4) && plain(after(" : ")) { next }
{ print FILENAME ":" NR ": " $0 > "/dev/stderr"; bad = 1 }
END { exit bad || !good }
