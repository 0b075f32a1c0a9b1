# SPDX-License-Identifier: Apache-2.0
# Takes the fenced examples out of a page.  -v out=FOLDER: block N becomes FOLDER/N.block, and for each that is to be run
# a line `N|LINE|KIND|NAME|OTHER` is printed, from the words after the fence:
#   sv|sm|ss NAME [OTHER]   the source file NAME, without findings of smc check; OTHER `!`: it has mistakes; of a script:
#                           the machine that it is run on, without a warning
#   io NAME VECTOR          the pin file NAME, of elements of the .sv VECTOR, without findings of smc check
#   rq NAME MACHINE         the requirements NAME of the machine, without findings of smc check
#   sm NAME +               the section in the block replaces the section of that name in the file NAME, or is added
#                           at the end; `+!`: the file has mistakes then
#   sm PATH =               the lines stand so in that file of the tree
#   c|csv|app|make|sh|yaml NAME the file NAME, for the commands that follow; without a name it is for reading, or other tests compile it
#   smt                     a case as in conformance/
#   console                 `$ ` commands, and their output; a line … matches any lines
# Other fences (text, groovy, sh or c without a name, none) are for reading.

/^```/ && !inside {
    inside = 1
    n++
    split(substr($0, 4), word, " ")
    file = out "/" n ".block"
    printf "" >file
    if (word[1] ~ /^(sv|sm|ss|smt|console)$/ || (word[1] ~ /^(io|rq)$/ && word[3] != "") || (word[1] ~ /^(c|csv|app|make|sh|yaml)$/ && word[2] != ""))
        printf "%d|%d|%s|%s|%s\n", n, FNR, word[1], word[2], word[3]
    delete word
    next
}
/^```/ { inside = 0; close(file); next }
inside { print >file }
END { if (inside) { print "a fence is not closed" >"/dev/stderr"; exit 1 } }
