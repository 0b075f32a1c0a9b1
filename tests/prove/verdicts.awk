# SPDX-License-Identifier: Apache-2.0
# Compares verdicts of smc prove with those that a person expects.     verdicts.awk NUMBERS EXPECTED VERDICTS
#
# EXPECTED has a line for each requirement, with its identifier in field `id` and its kind (author.sh explains them) in the next.  VERDICTS is what smc
# prove --format=json has written.  Lists what is undecided.  Fails if a verdict is wrong, if a script has more than most_changes changes, if the number
# of judged requirements is not `all`, or if fewer are right than `proved`, `violated` and `hard` demand.
FNR == NR && NF > 2 { kind[$id] = $(id + 1); of_kind[$(id + 1)]++; next }
match($0, /^{"id":"[A-Z][0-9]*_[PVH][0-9]*"/) {
    name = substr($0, 8, RLENGTH - 8); of = kind[name]
    match($0, /"verdict":"[a-z]*"/); verdict = substr($0, RSTART + 11, RLENGTH - 12)
    right = of == "V" ? verdict == "violated" : verdict == "proved" || verdict == "vacuous"
    judged++; found[of] += right
    if (verdict == "undecided") print "undecided: " name
    else if (!right) { print name " is not " verdict; wrong++ }
    if (match($0, /"changes":[0-9]*/) && substr($0, RSTART + 10, RLENGTH - 10) + 0 > most_changes) { print name ": too many changes"; wrong++ }
}
END {
    if (judged != all) { print judged + 0 " of " all " judged"; wrong++ }
    printf "verdicts on %s: P %d of %d, V %d of %d, H %d of %d, wrong %d\n", set, found["P"], of_kind["P"], found["V"], of_kind["V"], found["H"], of_kind["H"], wrong
    exit wrong || found["P"] < proved || found["V"] < violated || found["H"] < hard
}
