# SPDX-License-Identifier: Apache-2.0
# Parses a list of faults (mutants.txt describes the form).
#   awk -f mutants.awk LIST FILE…             a line `LINE|CLAUSES|ENGINES|FILE` for each, clauses and engines separated by blanks: where
#                                             it begins in LIST; FILE is empty if its place is not in exactly one line of the FILEs
#   awk -v number=N -f mutants.awk LIST FILE  FILE, with the breakage of line N in it

FNR == NR && /^(#|$)/ { next }
FNR == NR && /^- / { old[n] = substr($0, 3); next }
FNR == NR && /^\+ / { new[n] = substr($0, 3); next }
FNR == NR {
    fields = split($0, field, /[ \t][ \t]+/)
    where[n = FNR] = field[fields]
    order[++count] = n
    nth[n] = sub(/ #[0-9]+$/, "", where[n]) ? substr($0, length($0)) + 0 : 0
    engines[n] = field[fields - 1]
    clauses[n] = fields > 2 ? field[1] : ""
    gsub(/,/, "", engines[n])
    gsub(/,/, "", clauses[n])
    next
}

FNR == 1 {
    mine = 0
    for (k = 1; k <= count; k++) {
        i = order[k]
        if (number ? i == number : FILENAME == where[i] || index(FILENAME, where[i] "/") == 1) {
            at_hand[++mine] = i
            met[i] = 0
        }
    }
}
{
    for (k = 1; k <= mine; k++) {
        i = at_hand[k]
        at = index($0, old[i])
        if (at && (!nth[i] || ++met[i] == nth[i])) {
            places[i]++
            found[i] = FILENAME
            if (number)
                $0 = substr($0, 1, at - 1) new[i] substr($0, at + length(old[i]))
        }
    }
    if (number)
        print
}

END {
    for (k = 1; !number && k <= count; k++) {
        i = order[k]
        print i "|" clauses[i] "|" engines[i] "|" (places[i] == 1 ? found[i] : "")
    }
}
