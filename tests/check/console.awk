# SPDX-License-Identifier: Apache-2.0
# Runs the commands of a console block (lines `$ COMMAND`) and compares the output of each with the lines below it; a line …
# matches any number of lines.  Exit 1, with both texts, if anything differs.

function matches(i, j) {                  # expected from line i, printed from line j on
    for (; i <= wanted; i++) {
        if (want[i] == "…") {
            for (; j <= printed + 1; j++)
                if (matches(i + 1, j))
                    return 1
            return 0
        }
        if (j > printed || want[i] != line[j])
            return 0
        j++
    }
    return j > printed
}

function run(    text) {
    if (command == "")
        return
    printed = 0
    call = "{ " command "; } 2>&1"
    while ((call | getline text) > 0)
        line[++printed] = text
    close(call)
    if (matches(1, 1))
        return
    bad = 1
    print "$ " command
    for (k = 1; k <= printed; k++)
        print line[k]
    print "instead of"
    for (k = 1; k <= wanted; k++)
        print want[k]
}

/^\$ / { run(); command = substr($0, 3); wanted = 0; next }
{ want[++wanted] = $0 }
END {
    run()
    if (command == "") {
        print "there is no command in it"
        bad = 1
    }
    exit bad + 0
}
