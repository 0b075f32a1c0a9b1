# SPDX-License-Identifier: Apache-2.0
# Judges one set of seeded machines (seeded.sh).  Input: missed.txt, wrong.txt, all findings, clean.tsv, faults.tsv; -v set=its name.
# The last line is "PASSED FAILED": faults and clean machines.
BEGIN {
    FS = "\t"
    kind["dead-sensor"] = " output-on-zero "
    kind["waits-for-sensor"] = " waits-for-sensor missing-timeout "
    kind["left-on"] = " output-left-on missing-timeout "
    kind["window"] = " window-not-full "
    kind["abort"] = " abort-blind abort-single-sensor abort-by-command abort-latch abort-exit abort-missing output-on-zero "
    kind["time"] = " exact-moment missing-timeout waits-for-sensor "
    kind["rest"] = " ping-pong never-rests "
    kind["missing-reset"] = " missing-reset abort-latch "
    kind["abort-restarts"] = " abort-restarts abort-exit "
    kind["restarted-timer"] = " restarted-timer "
    kind["repeated-operand"] = " repeated-operand "
    kind["vote-of-one"] = " output-on-zero repeated-operand "
    kind["never"] = " constant-guard "
    others = " unused-definition unused-element dead-store "          # on by default: not judged on clean machines
    kind["priority"] = " abort-order "
    kind["hysteresis"] = " overlapping-limits "
    kind["mirrored-exit"] = " exit-repeats-entry "
    kind["lockout"] = " held-command abort-exit "
    kind["unit"] = " late-timer mixed-units "
    kind["unused"] = others
    kind["stale"] = " stale-latch "
    carried = " missing-reset abort-restarts restarted-timer repeated-operand "
    flight = " maybe-division-by-zero missing-way-out cascade "
    for (k in kind)
        if (kind[k] != others)
            flight = flight kind[k]
    if (set == "blind6")                  # its author has judged these kinds only (README.md)
        flight = carried
}

# SET/MACHINE KIND reason
FILENAME ~ /missed\.txt$/ {
    split($0, word, " ")
    if ($0 !~ /^#/)
        missed[word[1], word[2]] = 1
    next
}

# SET/MACHINE NAME reason
FILENAME ~ /wrong\.txt$/ {
    split($0, word, " ")
    if ($0 !~ /^#/)
        wrong[word[1], word[2]] = 1
    next
}

/^#/ { next }

FILENAME ~ /clean\.tsv$/ {
    machines++
    bad = 0
    for (i = 1; i <= findings; i++)
        if (machine[i] == $1 && index(flight, " " name[i] " ")) {
            if ((set "/" $1, name[i]) in wrong)
                print "known to be wrong: " set "/" text[i]
            else {
                print "wrong: " set "/" text[i]
                bad = 1
            }
        }
    if (bad)
        failed++
    else
        passed++
    next
}

FILENAME ~ /faults\.tsv$/ {
    found = 0
    for (i = 1; i <= findings; i++)
        if (machine[i] == $1 && index(kind[$2], " " name[i] " ") && index(" " $3 " ", " " line[i] " ") &&
            ($2 ~ /^(window|time|rest|never|repeated-operand)$/ || name[i] == "abort-latch" || index(text[i], "'" $4 "'") || index(text[i], "'" $5 "'")))
            found = 1
    if (found)
        passed++
    else if ((set "/" $1, $2) in missed)
        print "known miss: " set "/" $1 ": " $2 " " $4
    else {
        print "missed: " set "/" $1 ": " $2 " " $4 ": " $7
        failed++
    }
    next
}

{
    findings++
    text[findings] = $0
    split($0, part, ":")
    machine[findings] = part[1]
    line[findings] = part[2]
    match($0, /\[W[0-9]+ [a-z-]+\]$/)
    name[findings] = substr($0, RSTART + 7, RLENGTH - 8)
}

END { print passed + 0, failed + 0 }
