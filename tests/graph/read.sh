# SPDX-License-Identifier: Apache-2.0
# State diagrams are read by others: the SVG by librsvg, the text for Graphviz by dot; and each line for Mermaid is one of those that
# its grammar has.
#     read.sh SMC MACHINE.sm…
smc=$1
shift
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
passed=0 failed=0 skipped=0

judge() {                        # judge WHAT STATUS
    if [ "$2" = 0 ]; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "$1" >&2
    fi
}

has() { command -v "$1" >/dev/null 2>&1; }

for tool in rsvg-convert dot; do
    has $tool && continue
    echo "$tool is not installed: it reads nothing here"
    skipped=$((skipped + 1))
done
for m in "$@"; do
    for format in svg dot mermaid; do
        "$smc" graph -w --format=$format "$m" -o "$out/a.$format"
        judge "$m: smc graph --format=$format failed" $?
    done
    if has rsvg-convert; then
        rsvg-convert "$out/a.svg" -o "$out/a.png" 2>"$out/said" && [ ! -s "$out/said" ]
        judge "$m: rsvg-convert does not read the SVG" $?
    fi
    if has dot; then
        dot -Tsvg "$out/a.dot" -o "$out/dot.svg" 2>"$out/said"
        judge "$m: dot does not read the text for Graphviz" $?
    fi
    awk -f tests/graph/mermaid.awk "$out/a.mermaid"
    judge "$m: a line for Mermaid is none" $?
done
echo "graph-read: $passed passed, $failed failed, $skipped skipped"
[ "$failed" -eq 0 ] && [ $((passed + skipped)) -gt 0 ]
