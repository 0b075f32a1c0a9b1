# SPDX-License-Identifier: Apache-2.0
# Takes the fenced examples out of a page.  -v out=FOLDER: block N becomes FOLDER/N.block, and for each that is to be run
# stands a line `N|LINE|KIND|NAME|OTHER` on standard output, from the words behind the fence:
#   sv|sm|ss NAME [OTHER]   the source file NAME, of which smc check has nothing to say; OTHER `!`: it has mistakes; of a script:
#                           the machine that it is run on, without a warning
#   io NAME VECTOR          the pin file NAME, of elements of the .sv VECTOR, of which smc check has nothing to say
#   sm NAME +               the section that stands in the block is put into the file NAME, in the place of the one of that name or
#                           at the end; `+!`: the file has mistakes then
#   sm PATH =               the lines stand so in that file of the tree
#   c|app|make NAME         the file NAME, for the commands that follow; without a name it is for reading, or other tests compile it
#   smt                     a case as in conformance/
#   console                 `$ ` commands, and what they print; a line … stands for any lines
# Other fences (sh, text, c without a name, none) are for reading.

/^```/ && !inside {
    inside = 1
    n++
    split(substr($0, 4), word, " ")
    file = out "/" n ".block"
    printf "" >file
    if (word[1] ~ /^(sv|sm|ss|smt|console)$/ || (word[1] == "io" && word[3] != "") || (word[1] ~ /^(c|app|make)$/ && word[2] != ""))
        printf "%d|%d|%s|%s|%s\n", n, FNR, word[1], word[2], word[3]
    delete word
    next
}
/^```/ { inside = 0; close(file); next }
inside { print >file }
END { if (inside) { print "a fence is not closed" >"/dev/stderr"; exit 1 } }
