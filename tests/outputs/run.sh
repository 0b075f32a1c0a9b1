#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# run.sh SMC LOG [short]: what outputs may replace.  Every command that writes a file is tried, through each of its options, on sources, on
# its own inputs under other names, on files of others and on its own results.  LOG is a flight log.
# short: each option of each command once, and not with every format.
smc=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
flight=$(cd "$(dirname "$2")" && pwd)/$(basename "$2")
short=${3:+1} passed=0 failed=0
dir=$(mktemp -d "${TMPDIR:-/tmp}/smc-outputs.XXXXXX") && cd "$dir" || exit 1
trap 'rm -rf "$dir"' EXIT
trap 'exit 130' INT TERM

good() { passed=$((passed + 1)); }
bad() { failed=$((failed + 1)); echo "tests/outputs: $*" >&2; sed 's/^/    /' log >&2; }

# ---- what the commands read ----

cat >tank.sm <<'END_OF_FILE'
[state_vector]
U64 G
U32 S
F64 p @read_only
bool open
[Idle]
.step
    open = p > 5
    p > 50: -> Abort
[Abort] @safe
.step
    open = true
END_OF_FILE
cat >tank.ss <<'END_OF_FILE'
[options]
delta_t 10
[all_states]
G == 20 {
    @assert not open
    @stop
}
END_OF_FILE
cat >app.sv <<'END_OF_FILE'
[R]
U64 G
U32 S
F64 p
bool open
END_OF_FILE
cat >app.io <<'END_OF_FILE'
[digital_outputs]
1: open
END_OF_FILE
cat >tiny.app <<'END_OF_FILE'
[application]
END_OF_FILE
"$smc" build tank.sm -o image.smb 2>log && "$smc" key rocket.key >log 2>&1 || { bad "no image and no key"; exit 1; }
cp "$flight" flight.log || exit 1

# Each line: OPTION, a tab, the command without it.  @ is where the name goes.
writers()
{
    printf '%s\t%s\n' \
        '-o @' 'build tank.sm' \
        '-o @' 'build tank.sm -O0 -g' \
        '-o @' 'build tank.sm --emit=array' \
        '-o @' 'build tank.sm --emit=ir' \
        '-o @' 'build tank.sm --emit=ast' \
        '-o @' 'build tank.sm --emit=tokens' \
        '-MF @' 'build tank.sm -o other.smb -MD' \
        '-o @' 'report tank.sm tank.ss' \
        '-o @' 'report tank.sm --format=text' \
        '-o @' 'report tank.sm --format=json' \
        '-o @' 'graph tank.sm' \
        '-o @' 'graph tank.sm --format=dot' \
        '-o @' 'graph tank.sm --format=mermaid' \
        '-o @' 'sign image.smb --key=rocket.key --number=7' \
        '--junit=@' 'test tank.sm tank.ss' \
        '--coverage-data=@' 'test tank.sm tank.ss' \
        '--coverage-json=@' 'test tank.sm tank.ss' \
        '--coverage-lcov=@' 'test tank.sm tank.ss' \
        '--traceability=@' 'test tank.sm tank.ss' \
        '-o @' 'diff tank.sm tank.sm tank.ss' \
        '-o @' 'diff tank.sm tank.sm --format=markdown' \
        '-o @' 'diff tank.sm tank.sm --format=json' \
        '-o @' 'diff tank.sm tank.sm --format=svg' \
        '-o @' 'mutate tank.sm tank.ss' \
        '-o @' 'mutate tank.sm tank.ss --format=json' \
        '-o @' 'faults tank.sm tank.ss' \
        '-o @' 'faults tank.sm tank.ss --format=json' \
        '--trace=@' 'test tank.sm tank.ss' \
        '--trace=@' 'test tank.sm tank.ss --trace-format=exact' \
        '--message-file=@' 'check tank.sm -Weverything' \
        '--message-file=@' 'check tank.sm -Weverything --message-format=json' \
        '--message-file=@' 'graph tank.sm -Weverything --message-format=sarif -o /dev/null' \
        '--message-file=@' 'test tank.sm tank.ss -Weverything' \
        '-o @' 'log flight.log --format=text' \
        '-o @' 'log flight.log --format=csv' \
        '-o @' 'log flight.log --format=json' \
        '-o @' 'log flight.log --format=svg'
}
tab=$(printf '\t')

# call NAME MORE...: the current command with NAME as its output.
call()
{
    to=$1; shift
    "$smc" $rest $(echo "$option" | sed "s|@|$to|") "$@" >out 2>log
}

# refuses NAME WORDS: exit code 2, and the message has those words.
refuses()
{
    call "$1"; code=$?
    if [ $code = 2 ] && grep -q -- "$2" log; then good; else bad "$option $1, $rest: exit $code, not 2 with '$2'"; fi
}

same() { if cmp -s "$1" "$2"; then good; else bad "$option $1, $rest: it was changed"; fi; }

without_time() { sed 's/ time="[^"]*"//g' "$1" >"$2"; }

own_1= own_7= : >before.txt
exec 7>before.txt
for n in /dev/fd /proc/self/fd /proc/thread-self/fd; do
    [ -e $n/7 ] && own_1="$own_1 $n/1" own_7="$own_7 $n/7"
done
exec 7>&-

commands=0
writers | awk -v short="$short" -F "$tab" '{ split($2, word, " ") } !short || !seen[$1, word[1]]++' >writers.txt
while IFS=$tab read -r option rest; do
    commands=$((commands + 1))

    # A source is never an output, forced or not, whether it is there or not, under any name.
    for ending in sm ss sv io app smt rq SM; do
        refuses "new.$ending" "a source"
        [ -e "new.$ending" ] && { bad "new.$ending was written"; rm -f "new.$ending"; }
    done
    echo "[Other]" >other.ss
    cp other.ss other.copy
    ln -sf other.ss link.out
    refuses other.ss "a source"
    refuses link.out "a source"
    for name in other.ss link.out; do
        call $name --force; code=$?
        [ $code = 2 ] && good || bad "$option $name --force, $rest: exit $code"
    done
    same other.ss other.copy
    rm -f other.ss link.out

    # Nor are the inputs of the command, under their own or other names.
    for input in tank.sm image.smb rocket.key tank.ss flight.log; do
        case " $rest " in *[\ =]$input\ *) ;; *) continue ;; esac
        [ "$input/${rest%% *}" = image.smb/sign ] && continue          # sign edits its image: below
        cp -p $input input.copy
        ln -s $input link.out; ln $input hard.out
        for name in ./$input "$PWD/$input" link.out hard.out; do
            for force in '' --force; do
                call "$name" $force; code=$?
                [ $code = 2 ] && good || bad "$option $name $force, $rest: exit $code"
            done
        done
        same $input input.copy
        rm -f link.out hard.out
    done

    # A file by another author is kept, unless --force is given; an empty file or one by smc is replaced.
    ending=
    case $option in --coverage-data*) ending=.cov ;; esac
    foreign=foreign$ending empty=empty$ending
    echo "altitude,seconds" >$foreign; cp $foreign foreign.copy
    refuses $foreign --force
    same $foreign foreign.copy
    call $foreign --force; code=$?
    if [ $code = 0 ] && ! cmp -s $foreign foreign.copy; then good; else bad "$option $foreign --force, $rest: exit $code"; fi
    cp $foreign first
    call $foreign; code=$?
    [ $code = 0 ] && good || bad "$option, $rest, again over its own result: exit $code"
    case $option in --junit*) sed -i.old 's/ time="[^"]*"//g' first $foreign ;; esac
    same $foreign first
    : >$empty
    call $empty; code=$?
    if [ $code = 0 ] && [ -s $empty ]; then good; else bad "$option $empty, $rest: exit $code"; fi

    # A key that this command does not read is not replaced either, not even by force.
    cp rocket.key other.key; tr 'a-f\n' 'A-F\r' <other.key >upper.key
    ln -s other.key link.out
    for name in other.key upper.key link.out; do
        for force in '' --force; do
            call $name $force; code=$?
            if [ $code = 2 ] && grep -q 'is a key' log; then good; else bad "$option $name $force, $rest: exit $code"; fi
        done
    done
    same other.key rocket.key
    rm -f other.key upper.key link.out

    # A device and standard output take anything, any number of times.
    for name in /dev/null /dev/null -; do
        call $name; code=$?
        [ $code = 0 ] && good || bad "$option $name, $rest: exit $code"
    done

    # Names of this process's own files are these files as they are open, whatever they were redirected to.
    call -; without_time out expected
    ln -s /dev/stdout own.out
    for name in /dev/stdout /dev/../dev/stdout own.out $own_1; do
        for force in '' --force; do
            ln -f out same.out
            call $name $force; code=$?
            without_time out found
            if [ $code = 0 ] && cmp -s found expected && [ out -ef same.out ]; then good; else bad "$option $name $force, $rest: exit $code, or other than to -"; fi
        done
    done
    for name in $own_7; do
        ln -f before.txt seven; echo before >seven
        call $name 7>>seven; code=$?
        { echo before; cat expected; } >sum
        without_time seven found
        if [ $code = 0 ] && cmp -s found sum && [ seven -ef before.txt ]; then good; else bad "$option $name, $rest: exit $code, or not as it is open"; fi
        rm seven
    done
    call /dev/stderr; code=$?
    without_time log found
    if [ $code = 0 ] && [ "$(tail -c +1 found | grep -acxFf expected)" -ge "$(grep -ac '' expected)" ]; then good; else bad "$option /dev/stderr, $rest: exit $code"; fi
    rm own.out same.out
    mkfifo pipe
    timeout 20 cat pipe >piped &
    call pipe; code=$?
    wait
    if [ $code = 0 ] && [ -p pipe ] && [ -s piped ]; then good; else bad "$option pipe, $rest: exit $code"; fi
    rm -f pipe piped $foreign foreign.copy first first.old foreign.old $empty
done <writers.txt

# ---- C: two files, and more beside them ----

option='-o @' rest='build tank.sm --emit=c --soft'
for name in - /dev/stdout /dev/stderr $own_1; do
    refuses $name "C is two files"
done
[ -e /dev/stdout.c ] || [ -e /dev/stderr.c ] && bad "a file was made in /dev" || good
refuses other.ss "a source"
for name in x.c x.h sm_soft.c sm_soft.h sm_soft_avr.S; do
    echo 'int mine;' >$name; cp $name mine.copy
    refuses x.c --force
    same $name mine.copy
    for other in x.c x.h sm_soft.c; do
        [ $other = $name ] || [ ! -e $other ] && good || bad "$other was written although $name is not ours"
    done
    rm $name
done
echo 'int mine;' >x.h
call x.c --force && good || bad "C that is forced"
call x.c && good || bad "C over its own"
echo 'a program' >x
call x && [ "$(cat x)" = 'a program' ] && good || bad "-o x is x.c and x.h, and not x"

# ---- one name for two outputs ----

twice()
{
    "$smc" "$@" >out 2>log; code=$?
    if [ $code = 2 ] && grep -q 'same file\|standard output' log; then good; else bad "$*: exit $code"; fi
}
mkdir -p folder; ln -sfn folder alias; ln -sf nowhere.xml dangling
twice test tank.sm tank.ss --junit=a --trace=a
twice test tank.sm tank.ss --junit=a --trace=./a
twice test tank.sm tank.ss --junit=folder/a --trace=alias/a
twice test tank.sm tank.ss --junit=dangling --trace=nowhere.xml
: >a; ln a b
twice test tank.sm tank.ss --junit=a --trace=b
twice test tank.sm tank.ss --junit=- --trace=-
twice test tank.sm tank.ss --junit=m --message-file=m
twice test tank.sm tank.ss --tap --message-file=/dev/stdout
twice build tank.sm -o c.smb --message-file=c.smb
twice build tank.sm -MD -o c.smb --message-file=c.d
twice build tank.sm -MD --emit=c --message-file=tank.h
twice report tank.sm --message-file=-
twice build tank.sm -o a -MF a
twice build tank.sm -o - -MF -
twice build tank.sm -o - -MF /dev/stdout
twice test tank.sm tank.ss --junit=/dev/stdout --trace=-
twice build tank.sm --emit=c -o y.c -MF y.h
mkdir -p one two; cp tank.sm one; cp tank.sm two
twice build one/tank.sm two/tank.sm --emit=c
[ -e tank.c ] && bad "tank.c was written for one of two machines" || good
"$smc" test tank.sm tank.ss --junit=/dev/null --trace=/dev/null >out 2>log && good || bad "two outputs to /dev/null"

# ---- what edits: only fix, and only sources; keys are never replaced ----

# in_place NUMBER ARGUMENTS...: signs image.smb itself
in_place()
{
    number=$1; shift
    "$smc" sign image.smb --key=rocket.key --number=$number "$@" >out 2>log && "$smc" verify image.smb --key=rocket.key >out 2>>log &&
        grep -q "number $number\b" out && good || bad "an image is signed in place: $*"
}
ln -s image.smb link.smb
in_place 9
in_place 10 -o image.smb
in_place 11 -o link.smb
in_place 12 -o "$PWD/image.smb" --force
[ -L link.smb ] && good || bad "the link to an image was replaced"
rm link.smb
"$smc" key rocket.key 2>log; [ $? = 3 ] && good || bad "a key replaces another"
"$smc" key new.sm 2>log; if [ $? = 2 ] && [ ! -e new.sm ]; then good; else bad "a key is written to a source"; fi
"$smc" build tank.sm -MD -o - >out 2>log; if [ $? = 2 ] && grep -q -e '-MF' log; then good; else bad "-MD has no name for its file"; fi

# What edits a file with several names changes the one that it was given, and reports that.
printf '[state_vector]\nU64 G\nU32 S\nbool x\n[A]\n.step\n    x = true   // on\n' >links.sm; cp links.sm links.copy; ln links.sm link.copy
"$smc" fix links.sm --dry-run >out 2>log && ! grep -q 'hard link' log && good || bad "fix --dry-run of a hard link"
"$smc" fix links.sm >out 2>log && grep -q "'links.sm' .*hard link" log && grep -q '# on' links.sm && cmp -s links.copy link.copy && good || bad "fix of a hard link"
cp links.copy links.sm
"$smc" fix links.sm >out 2>log && ! grep -q 'hard link' log && good || bad "fix of a file with one name"
ln image.smb image.copy
"$smc" sign image.smb --key=rocket.key --number=13 >out 2>log && grep -q "'image.smb' .*hard link" log && good || bad "sign of a hard link"

cp tank.sm in.txt
for force in '' --force; do
    "$smc" graph - -o in.txt $force <in.txt >out 2>log
    if [ $? = 2 ] && cmp -s in.txt tank.sm; then good; else bad "standard input is the output"; fi
done
for again in 1 2; do
    "$smc" build - -o piped.smb -MD <tank.sm 2>log && good || bad "a rule without a source, again"
done
"$smc" build tank.sm -o piped.smb -MD -MP -MT 'a b' 2>log && "$smc" build tank.sm -o piped.smb -MD 2>log && good || bad "a rule with other targets"
cp tank.sm 'a tank#1.sm'
for again in 1 2; do
    "$smc" build 'a tank#1.sm' -o 'a b.smb' -MD -MP 2>log && good || bad "a rule with blanks in names"
done

long=$(printf '%0150d' 0); many=
for n in $(seq 30); do cp tank.sm "m$n-$long.sm"; many="$many m$n-$long.sm"; done
for again in 1 2; do
    "$smc" build $many --emit=c -MD -MP -MF long.d 2>log && [ "$(wc -c <long.d)" -gt 18000 ] && good || bad "a long rule"
    "$smc" build tank.sm -o other.smb -MD -MF huge.d -MT "$(seq -s ' ' 12000)" 2>log && good || bad "a rule with many targets"
done

# ---- files that almost look like smc's ----

near()
{
    printf "$1" >near; cp near near.copy
    "$smc" graph tank.sm -o near 2>log; code=$?
    if [ $code = 2 ] && cmp -s near near.copy; then good; else bad "replaced: $1"; fi
}
near 'seconds,altitude\n0,1\n'
near 'script,step\n'
near '{"severity": "none"}\n'
near '{"version":"2.1.0","runs":[]}\n'
near 'smc: my notes\n\nlater\n'
near 'smc: my notes\nlater\n'
near 'smc: my notes'
near 'a.c:1:2: error: wrong [-Werror]\n'
near 'note: later\n'
near 'smc: cannot open the valve\n'
near 'smc: cannot: later\n'
trace='script,step,G,state,T,open\n"a, b.ss",1,0,Idle,0,1\n'
near "script,step,G,state,T,my notes\na.ss,1,0,Idle,0,1\n"
near "script,step,G,state,T,notes\na.ss,1,0,Idle,0,ok\n"
near "script,step,G,state,T,notes\na.ss,1,0,Idle,0,\n"
near "script,step,G,state,T,open\r\na.ss,1,0,Idle,0,1\r\n"
near "script,step,G,state,T,open,\na.ss,1,0,Idle,0,1,\n"
near "${trace}a.ss,2,10,Idle,10,1,checked\n"
near "${trace}a.ss,2,10,Idle,10\n"
near "${trace}a.ss,two,10,Idle,10,1\n"
near "${trace}a.ss,2,10,In Idle,10,1\n"
near "${trace}\nmean,,,,5,1\n"
near "${trace}a.ss,2,10,Idle,10,=F2"
near 'session,seconds,altitude,my notes\n1,0.000,5,1\n'
near 'session,seconds,altitude\n1,0.000,5,high\n'
near 'session,seconds,altitude\n1,0:00,5\n'
near 'int main(void);  // Made by hand\n'
near 'tank.smb: tank.sm\n\tsmc build tank.sm\n'
near 'tank.o: tank.c tank.h\n'
near 'smc: notes on it\n'
near 'Shopping:\n'
near '<svg class="plot"></svg>\n'
near '<?xml version="1.0" encoding="UTF-8"?>\n<testsuites name="pytest tests"/>\n'
xml='<?xml version="1.0" encoding="UTF-8"?>\n<testsuites name="smc test"'
suites=' tests="1" failures="0" errors="0" time="0.1">\n'
suite='  <testsuite name="a.sm" tests="1" failures="0" errors="0" skipped="0" time="0.1">\n'
case='    <testcase name="a.ss" classname="a" time="0.1"'
end='  </testsuite>\n</testsuites>\n'
near "$xml/>\n"
near "$xml><note>mine</note></testsuites>\n"
near "$xml$suites  <!-- mine -->\n$suite$case/>\n$end"
near "$xml$suites${suite}    <properties/>\n$case/>\n$end"
near "$xml$suites$suite$case owner=\"me\"/>\n$end"
near "$xml$suites$suite$case>\n      <system-out>mine</system-out>\n    </testcase>\n$end"
near "$xml$suites$suite$case/>\n    mine\n$end"
near "$xml$suites$suite$case/>\n${end}mine\n"
near "$xml$suites$suite$case/>\n"
near '1 apple 3\n2 pears 4\n'
near '# my tokens\n'
near '{"time":0}\n'
near 'digraph "tank" {\n}\n'
near 'stateDiagram-v2\n    [*] --> s1\n'
near '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8"/>\n<title>mine</title>\n'

# ---- files by smc, with any names and messages ----

ours()
{
    printf "$1" >ours
    "$smc" graph tank.sm -o ours 2>log && good || bad "not recognised as smc's: $1"
}
ours "$trace"
ours 'script,step,G,state\n'
ours "${trace}\"say \"\"it\"\"\",2,10,Idle,-1.5e-300,inf\na.ss,3,20,Idle,nan,-inf\na.ss,4,30,Idle,-0.0,1e22\n" 
ours 'script,step,G,state,tank.state,x\n'
ours 'session,seconds,altitude\n1,-0.000001,5\n2,0.000000,nan\n3,1e-06,true\n'
ours "$xml$suites$suite$case/>\n$end"
ours "$xml$suites$suite$case>\n      <failure message=\"a &#60; b\" type=\"E0750\">a &#60; b\n\n  x\n</failure>\n    </testcase>\n$end"
ours "$xml$suites$suite$case>\n      <skipped message=\"why\">why</skipped>\n    </testcase>\n$end"
cp tank.ss 'a, "b".ss'
printf '[options]\ndelta_t 10\n[all_states]\ntrue: @assert open and "no such'>wrong.ss
printf '[options]\ndelta_t 10\n[all_states]\nG == 20000 {\n    @assert open\n    @stop\n}\n' >long.ss
for again in 1 2; do
    "$smc" test tank.sm 'a, "b".ss' wrong.ss long.ss missing.ss --trace=long.csv --junit=long.xml >out 2>log
    [ $? = 3 ] && [ "$(wc -c <long.csv)" -gt 50000 ] && grep -q '<failure' long.xml && grep -q '<error' long.xml && good || bad "a trace and results of every kind, again"
done

[ $commands -ge "$([ $short ] && echo 18 || echo 21)" ] || { echo "tests/outputs: only $commands commands were tried" >&2; failed=$((failed + 1)); }
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
