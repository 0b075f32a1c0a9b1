# SPDX-License-Identifier: Apache-2.0
# smc cover as its user runs it: twice, after edits of scripts and machine, with names that are in use, interrupted, and where it cannot write.
#     sh tests/cover/cover.sh SMC
smc=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
root=$(pwd)
dir=$(mktemp -d "${TMPDIR:-/tmp}/smc-cover.XXXXXX") && cd "$dir" || exit 1
trap 'chmod -R u+w "$dir"; rm -rf "$dir"' EXIT
trap 'exit 130' INT TERM
passed=0 failed=0 skipped=0

check() # CODE WHAT COMMAND...: the command exits with this code
{
    wanted=$1 what=$2
    shift 2
    if test "$1" = has; then
        "$@"
    else
        "$@" >"$dir/out" 2>"$dir/err"
    fi
    code=$?
    if test $code = "$wanted"; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "tests/cover: $what: exit code $code, not $wanted" >&2
        sed 's/^/    /' "$dir/out" "$dir/err" >&2
    fi
}
has() { grep -q -- "$1" "$dir/out" || grep -q -- "$1" "$dir/err"; }        # what the last command of `check` has printed

cat >vent.sm <<'END_OF_FILE'
[state_vector]
U64 G
U32 S
F64 pressure @read_only @range 0 1000
bool armed @read_only
bool valveOpen

[Wait] @safe
.step
    armed and pressure > 400: -> Vent

[Vent] @safe
.step
    valveOpen = true
    T > 200 and not armed: -> Wait
.exit
    valveOpen = false
END_OF_FILE

# ---- what is written ----

check 0 "every goal is reached" "$smc" cover vent.sm -o made
check 0 "and counted" has '^goals of vent: [0-9]* of [0-9]* reached$'
check 0 "a script has the name of its last transition" test -s made/vent-2-vent-to-wait.ss
check 0 "its second line is the goal" sh -c "sed -n 2p made/vent-2-vent-to-wait.ss | grep -q '^# Vent -> Wait, taken because T > 200 and not armed'"
check 0 "the scripts pass on every engine" "$smc" test -Werror vent.sm made/*.ss --engine=ref,vm,vm-soft
check 0 "and cover what was announced" "$smc" test vent.sm made/*.ss --min-coverage=transitions:100,statements:100,guards:100,conditions:100,states:100
cp -r made before
check 0 "a second call" "$smc" cover vent.sm -o made
check 0 "changes nothing" diff -r before made
check 0 "the same seed" "$smc" cover vent.sm -o again --seed=1
check 0 "writes the same" diff -r before again
check 0 "given scripts leave no goal" "$smc" cover vent.sm made/*.ss -o none
check 0 "so nothing is written" test -z "$(ls none)"
check 0 "skeletons" "$smc" cover vent.sm -o bare --skeletons
check 1 "have no asserts" grep -rq '^[^#]*@assert' bare
check 0 "and pass" sh -c "\"$smc\" test -w vent.sm bare/*.ss"
check 0 "goals as JSON" "$smc" cover vent.sm -o made --format=json
check 0 "name the outcome" has '"outcome":"reached"'
check 0 "kinds of goals" "$smc" cover vent.sm -o few --goals=transitions
check 0 "dependencies" "$smc" cover vent.sm -o made -MD -MF deps
check 0 "name the machine" grep -qx 'made: vent.sm' deps
check 0 "pairs of states" "$smc" cover vent.sm -o made --must-not

# ---- edits ----

echo '# mine' >>made/vent-2-vent-to-wait.ss
cp made/vent-2-vent-to-wait.ss edited
check 0 "an edited script" "$smc" cover vent.sm -o made
check 0 "is named" has '^kept: made/vent-2-vent-to-wait.ss has been edited'
check 0 "and kept" cmp edited made/vent-2-vent-to-wait.ss
sed 's/T > 200/T > 300/' vent.sm >changed && mv changed vent.sm
check 1 "an edited script that fails" "$smc" cover vent.sm -o made
check 0 "is left out" has 'Left out: vent-2-vent-to-wait.ss, because it fails at'
check 0 "is kept" cmp edited made/vent-2-vent-to-wait.ss
check 0 "and another script has its goal" grep -q 'T > 300' made/vent-2-vent-to-wait-2.ss
rm -r made && cp -r before made
check 0 "a changed machine" "$smc" cover vent.sm -o made
check 0 "makes scripts stale" has '^replaced: made/vent-2-vent-to-wait.ss'
check 0 "which are replaced" grep -q 'T > 300' made/vent-2-vent-to-wait.ss
mkdir foreign
echo '# not generated' >foreign/vent-2-vent-to-wait.ss
cp foreign/vent-2-vent-to-wait.ss edited
check 0 "a script of other origin" "$smc" cover vent.sm -o foreign
check 0 "is named" has '^kept: foreign/vent-2-vent-to-wait.ss: smc has not written it'
check 0 "is not touched" cmp edited foreign/vent-2-vent-to-wait.ss
check 0 "and the new one has another name" test -s foreign/vent-2-vent-to-wait-2.ss
check 0 "a second call" "$smc" cover vent.sm -o foreign
check 1 "has no name to change" has 'has not written it'
mkdir crlf
for f in again/*.ss; do sed 's/$/\r/' "$f" >crlf/"$(basename "$f")"; done
check 0 "carriage returns are no edit" "$smc" cover vent.sm -o crlf
check 1 "carriage returns are no edit" has 'has been edited'

# ---- wrong use, and where it cannot write ----

check 2 "no folder" "$smc" cover vent.sm
check 2 "standard output" "$smc" cover vent.sm -o -
check 2 "unknown goals" "$smc" cover vent.sm -o made --goals=all
check 2 "no effort" "$smc" cover vent.sm -o made --effort=0
check 2 "two machines" "$smc" cover vent.sm vent.sm -o made
check 2 "the name of a source" "$smc" cover vent.sm -o x.ss
echo text >file
check 3 "a folder that is a file" "$smc" cover vent.sm -o file
check 3 "a folder in a file" "$smc" cover vent.sm -o file/made
printf '[options]\ndelta_t 10\n[all_states]\nG == 0: @assert state Vent\nG == 0: @stop\n' >fails.ss
check 0 "before a script that fails" "$smc" cover vent.sm -o alone
check 1 "a given script that fails" "$smc" cover vent.sm fails.ss -o without
check 0 "is named with its line" has 'Left out: fails.ss, because it fails at fails.ss:4'
check 0 "and counted" has 'scripts that do not pass: 1 of 1'
check 0 "and covers nothing" diff -r alone without
check 1 "a passing script beside it" "$smc" cover vent.sm alone/*.ss fails.ss -o beside
check 0 "counts" test -z "$(ls beside)"
check 1 "a script that is left out, as JSON" "$smc" cover vent.sm fails.ss -o without --format=json
check 0 "has its reason" has '"left_out":\[{"script":"fails.ss","why":"fails at fails.ss:4"'
printf '[options]\ndelta_t 10\n[all_states]\npressure > 2000: @stop\n' >endless.ss
check 1 "a script without an end" "$smc" cover vent.sm endless.ss -o without
check 0 "is left out, too" has 'Left out: endless.ss, because it does not stop'
printf '[options]\ndelta_t 10\n[all_states]\nG == 0: other = 1\n' >unknown.ss
check 1 "a script that does not compile" "$smc" cover vent.sm unknown.ss -o without
check 0 "ends the call at its line" has "unknown.ss:4:9: error: unknown element 'other'"
check 0 "a machine from standard input" sh -c "\"$smc\" cover - -o from-stdin <vent.sm"
check 0 "has names that every system can store" test -s from-stdin/stdin-2-vent-to-wait.ss
check 2 "too much effort" "$smc" cover vent.sm -o made --effort=1000000001
check 0 "has its limit named" has "effort can be at most 1000000000, not '1000000001'"
check 2 "a number of more than 64 bits" "$smc" cover vent.sm -o made --memory=99999999999999999999999
check 0 "has its limit named, too" has "memory can be at most [0-9]*, not '9*'"
mkdir locked && chmod a-w locked
if test -w locked && mount -t tmpfs -o ro none locked 2>/dev/null; then       # root can write everywhere else
    check 3 "an unwritable folder" "$smc" cover vent.sm -o locked
    umount locked
elif test -w locked; then
    echo "tests/cover: this user can write everywhere: no unwritable folder is tried"
    skipped=$((skipped + 1))
else
    check 3 "an unwritable folder" "$smc" cover vent.sm -o locked
fi
if (mkdir small && mount -t tmpfs -o size=4k,nr_inodes=3 none small) 2>/dev/null; then
    check 3 "a full disk" "$smc" cover vent.sm -o small
    check 0 "leaves whole scripts only" sh -c "for f in small/*.ss; do \"$smc\" test -w vent.sm \$f || exit 1; done"
    umount small
else
    echo "tests/cover: no small file system can be mounted: no full disk is tried"
    skipped=$((skipped + 1))
fi

# ---- what is not found, and Ctrl-C ----

cat >hard.sm <<'END_OF_FILE'
[state_vector]
U64 G
U32 S
F64 x @read_only
F64 y @read_only
[local]
U32 count = 0
[A] @safe
.step
    x > 5: -> B
    sin(x) * 1000 == sin(y) * 1000 + 0.123456789 and x > y: -> C
[B] @safe
.step
    x < 3: -> A
[C] @safe
END_OF_FILE
check 5 "a goal that is not found" "$smc" cover hard.sm -o hard --effort=1
check 0 "is named with how near a run came" has "line [0-9]*: .*never"
check 0 "and the message says what to do" has '\-\-effort=10 searches longer'
timeout -s INT 3 "$smc" cover hard.sm -o stopped --effort=1000000 >out 2>err
check 0 "the message of an interrupted search" has '^smc: interrupted'
check 0 "and leaves scripts" sh -c 'ls stopped/*.ss'
check 0 "that are whole" sh -c "\"$smc\" test -w hard.sm stopped/*.ss"

check 5 "without a terminal" "$smc" cover hard.sm -o terminal --effort=20
check 1 "there is no progress" has 'million steps a second'
if command -v script >/dev/null && script -qec true /dev/null </dev/null >/dev/null 2>&1; then
    # util-linux returns the exit code of the command with -e.  The progress is a line that is written again and again, and is erased at the end.
    check 5 "on a terminal" script -qec "'$smc' cover hard.sm -o terminal-2 --effort=20" /dev/null </dev/null
    check 0 "the progress has the goals" has '[0-9] goals reached, [0-9]* left, [0-9.]* million steps a second, [0-9]* %'
else
    echo "tests/cover: there is no script(1): no progress is tried"
    skipped=$((skipped + 1))
fi

"$smc" cover "$root/tests/search/machines/unfound.sm" -o unfound --effort=1 --format=json >unfound.json 2>err
check 0 "goals that are not found as JSON" grep -q '"outcome":"not found"' unfound.json
check 1 "name what blocked them" sh -c "grep '\"outcome\":\"not found\"' unfound.json | grep -qv '\"blocked_by\":{\"kind\"'"
check 0 "and how near a run came" grep -q '"missed_by":' unfound.json
check 5 "little memory" "$smc" cover "$root/tests/search/machines/unfound.sm" -o small-memory --effort=20 --memory=1
check 0 "is reported" has '^smc: the search has used its 1 MB of memory; --memory=4'

# ---- given scripts as starting points ----

cat >code.sm <<'END_OF_FILE'
[state_vector]
U64 G
U32 S
U8  code @read_only
F64 h
bool open
[Locked] @safe
.step
    h = sin(h * 100 + code)
    T == 50 and h > 0.99264536936 and h < 0.99264536938: -> Open
[Open] @safe
.step
    open = true
    code > 200 and T > 500: -> Locked
END_OF_FILE
cat >code.ss <<'END_OF_FILE'
[options]
delta_t 10
[all_states]
G == 0:  code = 7
G == 20: code = 99
G == 40: code = 31
G == 80: @assert state Open
G == 80: @stop
END_OF_FILE
check 5 "a code that only a script knows" "$smc" cover code.sm -o codes --effort=1 --goals=transitions
check 0 "with this script" "$smc" cover code.sm code.ss -o codes --effort=1 --goals=transitions
check 0 "the search begins where it leads" test -s codes/code-2-open-to-locked.ss
check 1 "and repeats nothing" test -e codes/code-1-locked-to-open.ss
sed 's/^G == 0:.*/&\nG == 0: h = 0/' code.ss >wrote.ss
check 5 "a script that writes an output is no start" "$smc" cover code.sm wrote.ss -o codes-2 --effort=1 --goals=transitions

# ---- every example ----

cd "$root" || exit 1
for machine in examples/tank/tank.sm examples/ignition/ignition.sm examples/parachutes/parachutes.sm examples/chilldown/chilldown.sm; do
    name=$(basename "$machine" .sm)
    "$smc" cover "$machine" -o "$dir/$name" --goals=transitions --effort=20 >"$dir/out" 2>"$dir/err"
    code=$?
    check 0 "$name: $code" test $code = 0
    check 0 "$name: its scripts pass" sh -c "'$smc' test -w '$machine' '$dir/$name'/*.ss --min-coverage=transitions:100"
    check 0 "$name: no script changes inputs more often than ten times" sh -c "for f in '$dir/$name'/*.ss; do test \$(grep -c '^at.*[a-zA-Z] = ' \$f) -le 10 || exit 1; done"
done
echo "cover: $passed passed, $failed failed, $skipped skipped"
test "$failed" -eq 0
