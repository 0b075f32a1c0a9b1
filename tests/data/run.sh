#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# run.sh SMC: files with recorded data as the command finds them on a disk. What cannot be read is an error with a reason and exit code 1, no
# output replaces a file that is read, dependencies list it, and memory does not grow with its rows.
smc=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
dir=$(mktemp -d) || exit 1
trap 'rm -rf "$dir"' EXIT
cd "$dir" || exit 1
passed=0 failed=0

cat >m.sm <<'END'
[state_vector]
U64 G
U32 S
F64 x @read_only
bool out
[Run]
.step
    out = x > 5
END

# Writes the script for the file $1, with the lines $2 after the section's first ones.
script() {
    printf '[options]\ndelta_t 10\n[data]\nfile "%s"\ntime "t" ms\nx = "P"\n%s\n[all_states]\nG == 50: @assert x == 9\nG == 50: @stop\n' "$1" "$2" >s.ss
}

# A test: its name, the exit code, a text of the output, and the command.
expect() {
    name=$1 code=$2 text=$3
    shift 3
    "$@" >out 2>&1
    got=$?
    if [ "$got" -eq "$code" ] && { [ -z "$text" ] || grep -qF -e "$text" out; }; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "$name: exit code $got, expected $code and: $text"
        cat out
    fi
}

printf 't,P,OUT\n0,1,0\n20,9,1\n' >good.csv
mkdir folder
mkfifo pipe
printf 't,P\n0,1\n20,nine\n' >text.csv
: >empty.csv
printf 't,P\n0,1\n20' >cut.csv

script good.csv
expect 'a file' 0 'good.csv: 2 rows read' "$smc" test m.sm s.ss
expect 'every engine of this machine' 0 'good.csv: 2 rows read' "$smc" test m.sm s.ss --engine=ref,vm,vm-soft
expect 'a script that is checked only' 0 '' "$smc" check m.sm s.ss
script ./folder/../good.csv
expect 'another name of it' 0 'rows read' "$smc" test m.sm s.ss
script "$dir/good.csv"
expect 'an absolute name' 0 'rows read' "$smc" test m.sm s.ss
script absent.csv
expect 'no file' 1 's.ss:4:6: error: absent.csv: ' "$smc" test m.sm s.ss
expect 'no file, checked only' 1 's.ss:4:6: error: absent.csv: ' "$smc" check m.sm s.ss
script folder
expect 'a folder' 1 's.ss:4:6: error: folder: it is a folder' "$smc" test m.sm s.ss
script pipe
expect 'a pipe' 1 's.ss:4:6: error: pipe: it is not a regular file' "$smc" test m.sm s.ss
script /dev/null
expect 'a device' 1 '/dev/null: it is not a regular file' "$smc" test m.sm s.ss
mkfifo pipe.ss
mkdir folder.ss
ln -s /dev/zero zero.ss
for bad in pipe zero; do
    printf 'include "%s.ss"\n[options]\ndelta_t 10\n[all_states]\nG == 50: @stop\n' $bad >i.ss
    expect "an include of a $bad" 1 "i.ss:1:9: error: cannot include '$bad.ss': it is not a regular file" timeout 10 "$smc" test m.sm i.ss
done
printf 'include "folder.ss"\n[options]\ndelta_t 10\n[all_states]\nG == 50: @stop\n' >i.ss
expect 'an include of a folder' 1 "i.ss:1:9: error: cannot include 'folder.ss': it is a folder" "$smc" test m.sm i.ss
script -
expect 'standard input' 1 's.ss:4:6: error: -: ' "$smc" test m.sm s.ss
script empty.csv
expect 'an empty file' 1 's.ss:4:6: error: empty.csv: the file is empty' "$smc" test m.sm s.ss
script text.csv
expect 'text for a number' 1 "s.ss:6:5: error: text.csv:3: 'nine' is not a number" "$smc" test m.sm s.ss
script cut.csv
expect 'a file that was cut' 1 's.ss:4:6: error: cut.csv:3: the row has 1 cells, and the header has 2' "$smc" test m.sm s.ss

script good.csv '@compare out "OUT"'
expect 'a @compare' 0 '2 asserts passed' "$smc" test m.sm s.ss
sed 's/x > 5/x > 50/' m.sm >late.sm
expect 'one that is not met' 1 "differs from column 'OUT' in 4 of 6 steps" "$smc" test late.sm s.ss
expect 'its first step and row' 1 'first at G = 20, row 2 (good.csv:3): false, recorded true' "$smc" test late.sm s.ss
expect 'it in JUnit' 1 "differs from column 'OUT'" "$smc" test late.sm s.ss --junit=-
expect 'it in TAP' 1 "differs from column 'OUT'" "$smc" test late.sm s.ss --tap
expect 'it in a report' 1 's.ss failed' "$smc" report late.sm s.ss -o late.html
expect 'a recorded column in the plot' 0 'class="recorded' cat late.html
expect 'when it was not met' 0 'G = 20 to 50' cat late.html

expect 'dependencies of a report' 0 '' "$smc" report m.sm s.ss -MD -o r.html
expect 'the data among them' 0 'good.csv' cat r.d
cp good.csv before.csv
expect 'a trace in place of the data' 1 'it is also an output of this command' "$smc" test m.sm s.ss --force --trace=good.csv
expect 'a report in place of the data' 2 'is an input of this command' "$smc" report m.sm s.ss --force -o good.csv --format=text
expect 'the data is as it was' 0 '' cmp good.csv before.csv

"$smc" test m.sm s.ss --trace=trace.csv >/dev/null
printf '[options]\ndelta_t 10\n[data]\nfile "trace.csv"\ntime "G" ms\nx = "x"\n@compare out "out"\n[all_states]\nG == 50: @stop\n' >again.ss
expect 'a trace is recorded data' 0 'trace.csv: 6 rows read' "$smc" test m.sm again.ss

# Memory: the largest resident set in KiB of a run on 100 and on 300,000 rows.
rows() { awk -v n="$1" 'BEGIN { print "t,P,OUT"; for (i = 0; i < n; i++) print i ",9,1" }'; }
script rows.csv
peak() {
    rows "$1" >rows.csv
    sed "s/delta_t 10/delta_t $2/; s/G == 50/G == $3/" s.ss >many.ss
    "$smc" test m.sm many.ss >out 2>&1 || cat out
    ( ulimit -v $((limit)) 2>/dev/null; "$smc" test m.sm many.ss >out 2>&1 )
}
limit=40000
if ( ulimit -v $limit && "$smc" --version ) >/dev/null 2>&1; then
    expect 'few rows in 40 MB of addresses' 0 '' peak 100 10 50
    expect 'many rows in as much' 0 '' peak 300000 1000 299000
    skipped=
else
    echo "smc does not start in 40 MB of addresses, as with sanitizers"
    skipped=', 2 skipped'
fi

echo "data: $passed passed, $failed failed$skipped"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
