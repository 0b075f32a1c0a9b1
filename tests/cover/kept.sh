# SPDX-License-Identifier: Apache-2.0
# What smc cover, mutate and faults write for their users, and what they refuse: edited scripts are kept and named, missing ones are written again,
# files of other origin are not touched; counts and requirements of another machine, counts of another version, and requirements that contradict
# each other are refused, with a message that names the file, and without an output.
#     sh tests/cover/kept.sh SMC
smc=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
root=$PWD
. tests/checks.sh
dir=$(mktemp -d) || exit 1
trap 'rm -rf "$dir"' EXIT
cp examples/tank/tank.sm examples/tank/tank.ss examples/tank/tank.rq examples/ignition/ignition.rq "$dir" && cd "$dir" || exit 1

# A folder of scripts, written by the command after its name.
folder() { # NAME COMMAND...
    made=$1
    shift
    "$@" >out 2>&1
    first=$made/$(ls "$made" | head -n 1) last=$made/$(ls "$made" | tail -n 1)
    check "$made: at least two scripts" test "$first" != "$last"
    cp "$last" was.ss && rm "$last"
    echo '# mine' >>"$first" && cp "$first" edited.ss
    echo 'not of smc' >"$made/zz-foreign.ss"
    "$@" >out 2>&1
    check "$made: the edited script is kept" cmp "$first" edited.ss
    check "$made: and named" grep -q "$(basename "$first").*kept\|kept.*$(basename "$first")" out
    check "$made: the missing script is written again" cmp "$last" was.ss
    check "$made: another file stays" grep -q 'not of smc' "$made/zz-foreign.ss"
}

folder covered "$smc" cover -w tank.sm tank.ss -o covered --effort=2
folder changed "$smc" mutate -w tank.sm tank.ss --scripts=changed
folder faulty "$smc" faults -w tank.sm tank.ss tank.rq --scripts=faulty

# A file of another origin under the name of a script.
first=faulty/$(ls faulty | head -n 1)
echo 'not of smc' >"$first"
check "faults: a foreign file of that name: exit code 2" sh -c "'$smc' faults -w tank.sm tank.ss tank.rq --scripts=faulty >out 2>&1; test \$? -eq 2"
check "faults: and it stays" grep -q 'not of smc' "$first"
first=changed/$(ls changed | head -n 1)
echo 'not of smc' >"$first"
"$smc" mutate -w tank.sm tank.ss --scripts=changed >out 2>&1
check "mutate: a foreign file of that name stays" grep -q 'not of smc' "$first"
check "mutate: and is named" grep -q "$(basename "$first").* is kept" out

# A script of smc cover that no longer fits the machine is kept, or replaced by one that does; the folder then passes as far as it is named.
sed 's/T > 4000/T > 9000/; s/counter > 1000/counter > 30/' tank.sm >other.sm && mv tank.sm old.sm && mv other.sm tank.sm
rm covered/zz-foreign.ss
"$smc" cover -w tank.sm -o covered --effort=4 >out 2>&1
for script in covered/*.ss; do
    "$smc" test -w tank.sm "$script" >/dev/null 2>&1 || check "cover: the stale $script is named" grep -q "$(basename "$script")" out
done
mv old.sm tank.sm

refuse() { # CODE PATTERN COMMAND...
    code=$1 pattern=$2
    shift 2
    "$@" >out 2>&1
    check "$*: exit code $code" test $? -eq "$code"
    check "$*: $pattern" grep -q "$pattern" out
}

# Counts of another machine, of another version and of a damaged file.
printf '[state_vector]\nU64 G\nU32 S\nbool a @read_only\nbool b\n[X]\n.step\n    b = a\n' >x.sm
printf '[options]\ndelta_t 10\n[all_states]\nat 10: @stop\n' >x.ss
"$smc" test tank.sm tank.ss --coverage-data=tank.cov >/dev/null
refuse 1 "'tank.cov' has the coverage of the machine 'tank', not of 'x'" "$smc" test x.sm x.ss tank.cov --coverage
mkdir version && sed 's/775/776/' tank.sm >version/tank.sm
refuse 1 "tank.cov.*version" "$smc" test version/tank.sm tank.ss tank.cov --coverage
head -c 60 tank.cov >cut.cov
refuse 1 "cut.cov" "$smc" test tank.sm tank.ss cut.cov --coverage
# Without a script, too: the counts are all that the call has.
refuse 1 "'tank.cov' has the coverage of the machine 'tank', not of 'x'" "$smc" test x.sm tank.cov --coverage
refuse 1 "tank.cov.*version" "$smc" test version/tank.sm tank.cov --min-coverage=states:0
refuse 1 "cut.cov" "$smc" test tank.sm cut.cov --coverage --junit=cut.xml
check "and in a JUnit file" grep -q '<error' cut.xml
refuse 1 "no-machine.sm:1:1: error" sh -c "echo x >no-machine.sm; '$smc' test no-machine.sm tank.cov --coverage"
refuse 2 "a name that ends in .cov, not 'tank.txt'" "$smc" test tank.sm tank.ss --coverage-data=tank.txt
check "no counts were written" test ! -e tank.txt
echo mine >mine.cov
refuse 2 "'mine.cov' exists and was not written by smc" "$smc" test tank.sm tank.ss --coverage-data=mine.cov
check "the foreign file stays" grep -q mine mine.cov

# Requirements of another machine, and requirements that no run can meet.
for command in test mutate faults prove report; do
    output=
    test $command = report && output="-o page.html"
    # shellcheck disable=SC2086
    refuse 1 "ignition.rq:[0-9]*:[0-9]*: error: unknown" "$smc" $command tank.sm tank.ss ignition.rq $output
done
check "no page was written" test ! -e page.html
printf 'R1 "open"  always valveOpen\nR2 "shut"  never valveOpen\n' >both.rq
refuse 1 "both.rq:2:1: error: requirement R2 contradicts R1" "$smc" prove tank.sm both.rq
refuse 1 "both.rq:2:1: error: requirement R2 contradicts R1" "$smc" report tank.sm tank.ss both.rq --prove -o page.html
refuse 1 "requirement R1 violated" "$smc" test tank.sm tank.ss both.rq
refuse 1 "Not judged: R1 in tank.ss" "$smc" faults tank.sm tank.ss both.rq
refuse 1 "do not pass without any change: 1 of 1" "$smc" mutate tank.sm tank.ss both.rq
cd "$root" || exit 1
finish kept && test "$passed" -ge 45
