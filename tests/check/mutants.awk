# SPDX-License-Identifier: Apache-2.0
# Takes mutants.txt apart.  With -v list=1: a line `NUMBER|CLAUSES|ENGINES|FILE` for each mutant, clauses and engines
# separated by blanks.  With -v show=N: the piece that mutant N replaces.  With -v number=N and a source file behind it:
# that file with mutant N applied, exit 2 when the place is not there exactly once.  FILE #2 in mutants.txt takes the second of
# several equal places.

FNR == NR && /^#/ { next }
FNR == NR && /^[0-9]/ {
    split($0, field, /[ \t][ \t]+/)
    gsub(/,/, "", field[1])
    gsub(/,/, "", field[2])
    n++
    nth[n] = sub(/ #[0-9]+$/, "", field[3]) ? substr($0, length($0)) + 0 : 0
    if (list)
        print n "|" field[1] "|" field[2] "|" field[3]
    next
}
FNR == NR && /^- / { old[n] = substr($0, 3); next }
FNR == NR && /^\+ / { new[n] = substr($0, 3); next }
FNR == NR { next }

{
    at = index($0, old[number])
    if (at && (!nth[number] || ++met == nth[number])) {
        done++
        $0 = substr($0, 1, at - 1) new[number] substr($0, at + length(old[number]))
    }
    print
}

END {
    if (show)
        print old[show]
    else if (!list && done != 1)
        exit 2
}
