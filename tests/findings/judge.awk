# SPDX-License-Identifier: Apache-2.0
# Judges what smc found in one machine.  Input: also.txt, missed.txt, the machine's sources, what smc printed.  -v machine=its path.
# Fails, and says why, if a mark `#! name` has no finding, or a finding no mark.

# MACHINE NAME reason: a finding that is right, though it was not seeded.
FILENAME ~ /also\.txt$/ {
    if ($0 !~ /^#/ && NF > 2 && index(machine, "/" $1))
        also[$2]
    next
}

# MACHINE NAME reason: a seeded fault that is not found.
FILENAME ~ /missed\.txt$/ {
    if ($0 !~ /^#/ && NF > 2 && index(machine, "/" $1))
        missed[$2]
    next
}

FILENAME ~ /\.sm$/ {
    if (FNR == 1)
        section = ""
    if ($0 ~ /^\[/)
        section = FILENAME " " FNR
    at[FILENAME ":" FNR] = section
    rest = $0
    while (match(rest, /#! [a-z-]+/)) {
        name = substr(rest, RSTART + 3, RLENGTH - 3)
        mark[++marks] = name
        where[marks] = section
        line[marks] = FILENAME ":" FNR
        marked[name]
        rest = substr(rest, RSTART + RLENGTH)
    }
    next
}

/: warning: .*\[W[0-9]+ [a-z-]+\]$/ {
    match($0, /\[W[0-9]+ [a-z-]+\]$/)
    name = substr($0, RSTART + 7, RLENGTH - 8)
    split($0, part, ":")
    found[name, at[part[1] ":" part[2]]]
    found[name]
    if (!(name in marked) && !(name in also)) {
        print "not seeded: " name ": " $0
        bad++
    }
}

END {
    if (machine ~ /\/faulty\// && !marks) {
        print "no fault is marked in it"
        bad++
    }
    for (i = 1; i <= marks; i++) {
        name = mark[i]
        anywhere = name == "ping-pong" || name == "two-writers" || name == "cascade" || name == "unused-window"
        lost = anywhere ? !(name in found) : !((name, where[i]) in found)
        if (lost && name in missed)
            print "known miss: " name ": " line[i]
        else if (lost) {
            print "not found: " name ": " line[i]
            bad++
        }
    }
    for (name in missed)
        if (name in found) {
            print "found, though missed.txt says not: " name
            bad++
        }
    exit bad > 0
}
