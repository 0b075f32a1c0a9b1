# SPDX-License-Identifier: Apache-2.0
# What was measured, as a table with the goals beside it and as JSON.
#     awk -v json=FILE -f report.awk goals.txt RECORDS
# Records, by their first word:
#     time WORKLOAD ROW BEST QUARTER MEDIAN THREE_QUARTERS RUNS TO_NATIVE TO_F64           ns a step; ratios
#     insn WORKLOAD ROW N                                                                  instructions a step
#     value GROUP NAME N UNIT                                                              anything else
#     note TEXT                                                                            what could not be measured
/^#/ || NF == 0 { next }
FNR == NR { rule[++rules] = $0; next }

$1 == "time" || $1 == "insn" {
    if (!($2 in rows)) { rows[$2] = 0; workload[++workloads] = $2 }
    key = $2 " " $3
    if (!(key in known)) { known[key]; row[$2, ++rows[$2]] = $3 }
}
$1 == "time" {
    measured["ratio", $2]
    timed[key]; ns[key] = $4; quarter[key] = $5; median[key] = $6; three[key] = $7; runs[key] = $8; native[key] = $9; f64[key] = $10
}
$1 == "insn" { counted[key]; insn[key] = $4 }
$1 == "value" { if (!(($2 " " $3) in value)) name[++values] = $2 " " $3; value[$2 " " $3] = $4; unit[$2 " " $3] = $5; measured[$2] }
$1 == "note" { sub(/^note /, ""); note[++notes] = $0 }

END {
    read_goals()
    for (i = 1; i <= workloads; i++)
        print_workload(workload[i])
    print_values()
    print_goals()
    for (i = 1; i <= notes; i++)
        print (i == 1 ? "\n" : "") note[i]
    print_json()
}

function print_workload(w,    i, key) {
    printf "%s%-13s %8s   %8s  %-19s %9s %9s %8s\n", (w == workload[1] ? "" : "\n"), w, "ns/step", "median", "quartiles", "instr.",
           "/native", "/f64"
    for (i = 1; i <= rows[w]; i++) {
        key = w " " row[w, i]
        printf "  %-11s %8s   %8s  %-19s %9s %9s %8s\n", row[w, i], short(ns[key]), short(median[key]),
               key in timed ? short(quarter[key]) " … " short(three[key]) : "", short(insn[key]),
               short(native[key]), short(f64[key])
    }
}

function short(x) {
    return x == "" ? "" : x >= 1000 ? sprintf("%.0f", x) : x >= 100 ? sprintf("%.1f", x) : sprintf("%.2f", x)
}

function print_values(    i, part, group) {
    for (i = 1; i <= values; i++) {
        split(name[i], part, " ")
        if (part[1] != group)
            printf "\n%s\n", part[1]
        group = part[1]
        printf "  %-32s %12s %s\n", part[2], whole(value[name[i]]), unit[name[i]]
    }
}

function whole(x) { return x == int(x) ? sprintf("%d", x) : sprintf("%.3g", x) }

# ---- goals ----

# A rule for `*` is a goal of each workload.
function read_goals(    i, k, g) {
    for (i = 1; i <= rules; i++)
        if (split(rule[i], g, /[ \t]+/) && g[2] != "*")
            goal[++goals] = rule[i]
        else
            for (k = 1; k <= workloads; k++)
                goal[++goals] = g[1] " " workload[k] " " g[3] " " g[4] " " g[5]
}

# The row of the VM that is the fastest against `native`.
function best(w,    i, r, found) {
    for (i = 1; i <= rows[w]; i++) {
        r = row[w, i]
        if (r ~ /^(in-place|decoded)-/ && (found == "" || native[w " " r] < native[w " " found]))
            found = r
    }
    return found
}

function ratio(w, a, b) {
    if (!((w " " a) in native) || !((w " " b) in native))
        return ""
    if (b == "f64")
        return f64[w " " a]
    return native[w " " b] > 0 ? native[w " " a] / native[w " " b] : ""
}

# Splits goal i into what, got, sign and limit; 0 if nothing of its workload or group was measured.
function judge(i,    g, r) {
    split(goal[i], g, /[ \t]+/)
    limit = g[1] == "ratio" ? g[5] : g[4]
    sign = g[1] == "least" ? ">=" : "<="
    if (g[1] == "ratio") {
        r = g[3] == "vm" ? best(g[2]) : g[3]
        what = g[2] ": " r " / " g[4]
        got = ratio(g[2], r, g[4])
    } else {
        what = g[2] ": " g[3]
        got = (g[2] " " g[3]) in value ? value[g[2] " " g[3]] : ""
    }
    met = 0
    if (got == "")
        return (g[1] == "ratio" ? "ratio" SUBSEP g[2] : g[2]) in measured
    met = sign == "<=" ? got + 0 <= limit + 0 : got + 0 >= limit + 0
    return 1
}

function print_goals(    i, n) {
    for (i = 1; i <= goals; i++)
        if (judge(i)) {
            if (n++ == 0)
                printf "\ngoals\n"
            printf "  %-32s %12s   %s %-8s %s\n", what, got == "" ? "" : whole(sprintf("%.3g", got)), sign, limit,
                   got == "" ? "not measured" : met ? "met" : "not met"
        }
}

# ---- JSON ----

function print_json(    i, k, w, key, n, part) {
    if (json == "")
        return
    printf("{\n\"time\": [") >json
    for (i = 1; i <= workloads; i++)
        for (k = 1; k <= rows[workload[i]]; k++) {
            w = workload[i]
            key = w " " row[w, k]
            printf("%s\n{\"workload\": \"%s\", \"row\": \"%s\"", n++ ? "," : "", w, row[w, k]) >json
            if (key in timed) {
                printf(", \"ns\": %s, \"runs\": %s, \"median\": %s", ns[key], runs[key], median[key]) >json
                printf(", \"quarter\": %s, \"three_quarters\": %s", quarter[key], three[key]) >json
                printf(", \"to_native\": %s, \"to_f64\": %s", native[key], f64[key]) >json
            }
            printf("%s}", key in counted ? ", \"instructions\": " insn[key] : "") >json
        }
    printf("\n],\n\"values\": [") >json
    for (i = 1; i <= values; i++) {
        split(name[i], part, " ")
        printf("%s\n{\"group\": \"%s\", \"name\": \"%s\"", i > 1 ? "," : "", part[1], part[2]) >json
        printf(", \"value\": %s, \"unit\": \"%s\"}", value[name[i]], unit[name[i]]) >json
    }
    printf("\n],\n\"goals\": [") >json
    n = 0
    for (i = 1; i <= goals; i++)
        if (judge(i) && got != "")
            printf("%s\n{\"goal\": \"%s\", \"value\": %s, \"%s\": %s, \"met\": %s}", n++ ? "," : "", what, got,
                   sign == "<=" ? "at_most" : "at_least", limit, met ? "true" : "false") >json
    printf("\n]\n}\n") >json
}
