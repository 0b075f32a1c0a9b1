#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# junit.sh SMC FOLDER: what `smc test --junit` writes of tests that pass, fail, cannot run and are skipped.
smc=$(cd "$(dirname "$1")" && pwd)/$(basename "$1"); here=$(cd "$(dirname "$0")" && pwd)
command -v python3 >/dev/null || { echo "junit: wants python3"; echo "0 passed, 0 failed, 1 skipped"; exit 0; }
rm -rf "$2" && mkdir -p "$2/flight" "$2/cases/inner" && cd "$2" || exit 1
passed=0; failed=0
good() { passed=$((passed + 1)); }
bad() { failed=$((failed + 1)); echo "tests/check/junit.sh: $*" >&2; }

cat >tank.sm <<'EOF'
[state_vector]
U64 G
U32 S
F64 x
bool open
[Idle]
.step
    open = true
EOF
cp tank.sm flight/other.sm
sed 's/open = true/opne = x < 1/' tank.sm >broken.sm
script() { printf '[options]\ndelta_t 10\n[all_states]\nG == 20: @assert %s\nG == 30: @stop\n' "$2" >"$1"; }
script good.ss 'open'
script 'a & b <"c">.ss' 'open'
script bad.ss 'not open == (x < 1)'
script broken.ss 'opne'
printf '[options]\ndelta_t 10\n[all_states]\ntrue: @assert open\nG == 35: @stop\n' >endless.ss
printf -- '-- a.sm --\n[state_vector]\nU64 G\nU32 S\n[Idle]\n' >cases/good.smt
printf -- '-- a.sm --\n[state_vector]\nU64 G\nU32 S\n[Idle]\n.step\n    y = 1\n' >cases/inner/bad.smt
printf 'expect perhaps\n' >cases/malformed.smt
printf -- '-- stdout --\nx\n' >cases/inner/golden.smt

# run NAME CODE TESTS FAILURES ERRORS SKIPPED ARGUMENT...: the exit code, and the counts that the root and its suites have together.
run()
{
    name=$1 code=$2 want="$3 $4 $5 $6"; shift 6
    "$smc" test "$@" --junit="$name.xml" >out 2>err; came=$?
    got=$(python3 - "$name.xml" <<'EOF'
import sys, xml.etree.ElementTree as E
r = E.parse(sys.argv[1]).getroot()
print(r.get('tests'), r.get('failures'), r.get('errors'), sum(int(s.get('skipped')) for s in r))
EOF
)
    if [ $came = $code ] && [ "$got" = "$want" ]; then good; else bad "$name: exit $came, not $code; tests, failures, errors, skipped: '$got', not '$want'"; fi
    files="$files $name.xml"
}
files=
run pass 0 1 0 0 0 tank.sm good.ss
run mixed 1 5 2 1 0 tank.sm good.ss bad.ss broken.ss endless.ss 'a & b <"c">.ss' --max-steps=10
run other 1 2 1 0 0 flight/other.sm good.ss bad.ss
run machine 1 2 0 2 0 broken.sm good.ss bad.ss
run unread 3 2 0 1 0 tank.sm good.ss nosuch.ss
run nomachine 3 1 0 1 0 nosuch.sm good.ss
run cases 1 4 1 1 1 cases
run both 1 6 2 1 1 tank.sm good.ss bad.ss cases
export CC=/nosuch/cc
run nocompiler 3 2 0 2 0 tank.sm good.ss bad.ss --engine=c
say() { if grep -q -e "$2" "$1"; then good; else bad "$1 has no $2"; fi; }
say mixed.xml '<failure message="bad.ss:4:18: error: '
say mixed.xml '<error message="broken.ss:4:18: error: unknown element .opne. .E0204." type="E0204">'
say mixed.xml 'classname="tank"'
say other.xml 'classname="flight.other"'
say machine.xml '<error message="broken.sm:8:5: error: unknown element .opne. .E0204." type="E0204">'
say machine.xml 'did you mean .open'
say cases.xml 'name="bad.smt" classname="cases.inner"'
[ $failed = 0 ] || { echo "$passed passed, $failed failed"; exit 1; }
echo "$passed passed, 0 failed"
python3 "$here/junit.py" $files && python3 "$here/junit.py" --self-test mixed.xml
