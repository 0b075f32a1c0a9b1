#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# names.sh SMC FOLDER LOG: control characters in the name of a file, wherever smc accepts one: exit code 3, or 2 where no file is opened, a message on
# one line without them, and no output.  Then the values of CC.     LOG is a flight log.
smc=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
flight=$(cd "$(dirname "$3")" && pwd)/$(basename "$3")
passed=0 failed=0
rm -rf "$2" && mkdir -p "$2" && cd "$2" || exit 1
newline='
'
escape=$(printf '\033')

cat >tank.sm <<'END_OF_FILE'
[state_vector]
U64 G
U32 S
[Idle]
END_OF_FILE
printf '[options]\ndelta_t 10\n[all_states]\nG == 20: @stop\n' >tank.ss
printf '[R]\nU64 G\nU32 S\n' >tank.sv
"$smc" build tank.sm -o tank.smb && "$smc" key tank.key >log && cp "$flight" flight.log || exit 1
for ending in sm ss sv io smt app log; do
    cp tank.sm "bad$newline.$ending"
done
mkdir "bad$newline"
cp tank.sm "bad$newline/tank.smt"

# refused CODE ARGUMENT…
refused() {
    wanted=$1
    shift
    "$smc" "$@" >out 2>log </dev/null
    code=$?
    case $wanted in 3) lines=1 ;; *) lines=2 ;; esac              # usage: a second line points to the help
    ls >after
    if [ $code -eq "$wanted" ] && [ "$(cat out log | grep -c .)" -eq $lines ] && cat out log | grep -q 'contains a control character' &&
        ! grep -q "$escape" out log && cmp -s before after; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "smc $*: exit code $code"
        cat out log
        diff before after
    fi
}
touch out log after && ls >before

for bad in "bad$newline" "bad$escape[31m"; do
    refused 3 build "$bad.sm" -o -
    refused 3 build tank.sm --sv "$bad.sv" -o -
    refused 3 build tank.sm --sv tank.sv --io "$bad.io" -o -
    refused 3 build "$bad.app"
    refused 3 check "$bad.sm"
    refused 3 check tank.sm "$bad.ss"
    refused 3 fix "$bad.sm"
    refused 3 graph "$bad.sm"
    refused 3 report "$bad.sm" -o -
    refused 3 test "$bad.sm" tank.ss
    refused 3 test tank.sm "$bad.ss"
    refused 3 test tank.sm tank.ss --trace="$bad.csv"
    refused 3 disasm "$bad.smb"
    refused 3 verify "$bad.smb"
    refused 3 log "$bad.log"
    refused 3 build tank.sm -o "$bad.smb"
    refused 3 build tank.sm --emit=c -o "$bad.c"
    refused 3 build tank.sm -o x.smb -MD -MF "$bad.d"
    refused 3 graph tank.sm -o "$bad.svg"
    refused 3 report tank.sm -o "$bad.html"
    refused 3 log flight.log -o "$bad.svg"
    refused 3 sign tank.smb --key=tank.key --number=1 -o "$bad.smb"
    refused 3 key "$bad.key"
    refused 2 build tank.sm -o x.smb -MD -MT "$bad"
done

# Names in an application: a line end or a character outside the language ends the name.
printf '[application]\nstate_vector "bad\033.sv"\n' >odd.app
"$smc" check odd.app >out 2>log
if [ $? -eq 1 ] && [ -s log ] && ! grep -q "$escape" log; then passed=$((passed + 1)); else failed=$((failed + 1)); echo "odd.app:"; cat log; fi

# ---- CC: the words of a shell ----

mkdir 'my tools'
printf '#!/bin/sh\nfor a; do printf "%%s\\n" "$a"; done >>words\nexec cc "$@"\n' >'my tools/cc' && chmod +x 'my tools/cc'
# accepts CC WORD…: the compiler is found, and its command contains these words
takes() {
    cc=$1
    shift
    rm -f words
    CC=$cc "$smc" test tank.sm tank.ss --engine=c >out 2>log || { failed=$((failed + 1)); echo "CC=$cc"; cat log; return; }
    for word; do
        if grep -qxF -- "$word" words; then passed=$((passed + 1)); else failed=$((failed + 1)); echo "CC=$cc: no word '$word'"; fi
    done
}
takes "'./my tools/cc' -DA" -DA
takes '"./my tools/cc"  -O0 ' -O0
takes './my\ tools/cc -D"A B"=1 -DC='"'"'"x"'"'" '-DA B=1' '-DC="x"'
takes "'./my tools/cc' $(i=0; while [ $i -lt 200 ]; do printf -- '-DX%d ' $i; i=$((i + 1)); done)" -DX0 -DX59 -DX60 -DX199
for cc in "'./my tools/cc" '"cc'; do
    CC=$cc "$smc" test tank.sm tank.ss --engine=c >out 2>log
    if [ $? -eq 3 ] && grep -q 'a quote in it is not closed' log; then passed=$((passed + 1)); else failed=$((failed + 1)); echo "CC=$cc"; cat log; fi
done

echo "host-names: $passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
