#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Emitted C under many compilers and options: it compiles without a warning, runs as the reference does or refuses to, and
# can be used as docs/embedding-c.md says.     run.sh SMC [matrix] [flags] [recommended] [use] [foreign] [size] [readings] [parameters] [wide] [straight] [cases]     (all but cases when none is named)
smc=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
shift
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
passed=0 failed=0 skipped=0 hinted=
dir=$(mktemp -d "${TMPDIR:-/tmp}/smc-emitc.XXXXXX") || exit 1
trap 'rm -rf "$dir"' EXIT
trap 'exit 130' INT TERM
strict="-pedantic -Wall -Wextra -Wconversion -Wshadow"

pass() { passed=$((passed + 1)); }
fail() { failed=$((failed + 1)); echo "$1"; [ -f "$dir/log" ] && head -8 "$dir/log"; }
present() { command -v "$1" >/dev/null 2>&1; }

# 32-bit x86 as our own #error recommends it.
x86_32='-m32 -msse2 -mfpmath=sse'

# Whether COMMAND, a compiler with options, makes programs for 32-bit x86.  Otherwise a skip, which prints once how to install the missing packages.
makes_32() {
    printf '#include <stdint.h>\n#include <stdio.h>\nint main(void) { return puts("") < 0; }\n' >"$dir/is_32.c"
    $1 "$dir/is_32.c" -o "$dir/is_32" >/dev/null 2>&1 && "$dir/is_32" >/dev/null && return 0
    skipped=$((skipped + 1))
    [ -n "$hinted" ] || echo "$1: makes no programs for 32-bit x86; on Debian: apt-get install libc6-dev-i386 lib32gcc-12-dev"
    hinted=yes
    return 1
}

# try COMPILER FUNCTION ARGUMENTS…: calls the function with the compiler command behind the arguments
try() {
    compiler=$1
    shift
    if ! present "${compiler%% *}"; then
        skipped=$((skipped + 1))
        return
    fi
    case $compiler in *-m32*) makes_32 "$compiler" || return ;; esac
    "$@" "$compiler"
}

every_compiler() {
    for each in "gcc -std=c99" "gcc -std=gnu17 -O2" "clang-19 -std=c99 -O1" "clang-19 -std=gnu17" "tcc" "g++ -x c++ -std=c++11 -O1" \
                "clang++-19 -x c++ -std=c++11" "gcc $x86_32 -O1"; do
        try "$each" "$@"
    done
}

compilers_32() {
    for each in "gcc $x86_32 -O0" "gcc $x86_32 -O1" "gcc $x86_32 -O2" "gcc $x86_32 -std=c99 -O2" "gcc $x86_32 -Os" "clang-19 $x86_32 -O2"; do
        try "$each" "$@"
    done
}

# For slow tests: the compilers that differ most.
few_compilers() {
    for each in "gcc -std=c99" "clang++-19 -x c++ -std=c++11" "tcc"; do
        try "$each" "$@"
    done
}

# ---- matrix: no warning, whatever the machine ----

compile_one() {
    rm -f "$dir/log"
    if $2 $strict -c "$dir/$1.c" -o "$dir/$1.o" >"$dir/log" 2>&1 && [ ! -s "$dir/log" ]; then
        pass
    else
        fail "$1: $2 has something to say"
    fi
}

# compile_machine COMPILERS NAME ARGUMENTS…: emits and compiles it with all of them
compile_machine() {
    compilers=$1 name=$2
    shift 2
    if "$smc" build -w "$@" --emit=c -o "$dir/$name.c" >"$dir/log" 2>&1; then
        $compilers compile_one "$name"
    else
        fail "$name: not compiled"
    fi
}

# A thousand conditionals in one another, a sum of two thousand, a chain of else-ifs, a thousand states.
make_large() {
    awk 'BEGIN {
        print "[state_vector]\nU64 G\nU32 S\nF64 x\nF64 y\n[A]\n.step"
        for (i = 0; i < 1000; i++) printf "%*sx > %d {\n", i % 60, "", i
        print "y = 1"
        for (i = 999; i >= 0; i--) print i % 3 ? "}" : "} else { y = y + " i " }"
    }' >"$dir/nested.sm"
    awk 'BEGIN {
        print "[state_vector]\nU64 G\nU32 S\nF64 x\nF64 y\nbool b\n[A]\n.step\ny = x"
        for (i = 0; i < 900; i++) s = s " + x * " i
        print "y = x" s
        s = "x"
        for (i = 0; i < 900; i++) s = "(" s (i % 2 ? " - " : " / ") "y)"
        print "y = " s
        s = "x"
        for (i = 0; i < 400; i++) s = "(" i + 1 " - " s ")"
        print "x = " s
        s = "b"
        for (i = 0; i < 400; i++) s = "(x > " i (i % 2 ? " or " : " and ") "not " s ")"
        print "b = " s
        s = "x"
        for (i = 0; i < 300; i++) s = "max(y, min(x, " s "))"
        print "y = " s
    }' >"$dir/deep.sm"
    awk 'BEGIN {
        print "[state_vector]\nU64 G\nU32 S\nF64 x\nF64 y\n[A]\n.step\nif x == 0: y = 0"
        for (i = 1; i < 1000; i++) print "else if x == " i ": y = " i * 7
        print "else: -> A"
    }' >"$dir/chain.sm"
    awk 'BEGIN {
        print "[state_vector]\nU64 G\nU32 S\nF64 x\nI32 n"
        for (i = 0; i < 1000; i++) print "[S" i "]\n.entry\nx = " i "\n.step\nT > " i ": -> S" (i * 7 + 1) % 1000 "\n.exit\nx = x + 1\nn = n * x / 3 - T"
    }' >"$dir/states.sm"
}

# C and C++ keep names with an underscore in front or two in a row for themselves; some compilers would take them.
reserved_names() {
    if sed -e 's,//.*,,' -e '/^#/d' -e 's/"[^"]*"//g' "$@" | grep -v '__GNUC__\|__clang__\|_MATH__' | grep -n '\(^\|[^A-Za-z0-9_]\)_[A-Za-z0-9_]\|[A-Za-z0-9]__' >"$dir/log"; then
        fail "names: some are reserved"
    else
        pass
    fi
}

matrix() {
    for machine in "$root"/examples/*/*.sm "$here"/machines/*.sm; do
        name=$(basename "$machine" .sm)
        sv=$(ls "$(dirname "$machine")"/*.sv 2>/dev/null | head -1)
        case $machine in
        */machines/valve.sm | */machines/pump.sm) compile_machine every_compiler "$name" "$machine" --sv "$sv" ;;
        */machines/*) compile_machine every_compiler "$name" "$machine" ;;
        */dualdeploy/channel.sm)
            compile_machine every_compiler "$name" "$machine" --sv "$sv" --bind=go=apogee,fire=drogueFire,state=drogueState ;;
        *) compile_machine every_compiler "$name" "$machine" ${sv:+--sv "$sv"} ;;
        esac
        if [ "$machine" = "$here/machines/arithmetic.sm" ]; then
            compile_machine every_compiler arithmetic0 -O0 "$machine"
            compile_machine every_compiler arithmetic1 --track-stores "$machine"
            compile_machine every_compiler arithmetic4 --soft --track-stores "$machine"
            every_compiler compile_one sm_soft
            strict="$strict -I$root -DSM_F64_SOFT=1" compile_machine every_compiler arithmetic5 --soft --runtime "$machine"
            strict="$strict -I$root" compile_machine every_compiler arithmetic2 --runtime "$machine"
            strict="$strict -I$root" compile_machine every_compiler arithmetic3 --runtime --track-stores "$machine"
        fi
    done
    reserved_names "$dir/names.h" "$dir/names.c"
    compile_machine every_compiler bus "$here/machines/bus.sv"
    make_large
    for name in nested deep chain states; do
        compile_machine few_compilers $name "$dir/$name.sm"
    done
    if [ "$(grep -c 'switch (' "$dir/states.c")" -eq 32 ] && ! grep -q '(\*' "$dir/states.c"; then pass; else fail 'states: a step dispatches more than once'; fi
    if grep -q 'static SM_NOINLINE int32_t sm_to_i32' "$dir/states.c"; then pass; else fail 'states: what is called a thousand times is inlined'; fi
    run_large
}

# The large ones also run as they should.
run_large() {
    printf '[options]\ndelta_t 1\n[all_states]\ntrue: x = x * 3 - T * 700 + G\nG == 300: @stop\n' >"$dir/large.ss"
    for name in nested deep chain states; do
        if "$smc" test -w "$dir/$name.sm" "$dir/large.ss" --engine=all >"$dir/out" 2>"$dir/log"; then pass; else fail "$name: not as the reference"; fi
    done
}

# ---- flags: the reference's bits, or nothing ----

run_on_all() {      # MACHINE COMPILER: exit code of a run in lock step
    CC=$2 "$smc" test "$here/machines/$1.sm" "$here/machines/$1.ss" --engine=all >"$dir/out" 2>"$dir/log"
}

knows() {           # COMPILER OPTIONS: whether it takes them at all
    echo 'int main(void) { return 0; }' >"$dir/empty.c"
    $1 $2 "$dir/empty.c" -o "$dir/empty" >"$dir/log" 2>&1 && [ ! -s "$dir/log" ]
}

try_flags() {       # WANT OPTIONS COMPILER
    run_on_all arithmetic "$3 $2"
    code=$?
    result=different
    [ $code -eq 0 ] && result=same
    [ $code -eq 3 ] && grep -q 'this code needs\|constants_are_double\|it does not start' "$dir/log" && result=refused
    case $1-$result in
    same-same | refused-refused | either-same | either-refused) pass ;;
    *) fail "$3 $2: $result, wanted $1" ;;
    esac
}

flags() {
    for compiler in gcc clang-19; do
        if ! present $compiler; then
            skipped=$((skipped + 1))
            continue
        fi
        before=$((passed + failed))
        while read -r want options; do
            case $want in
            '#' | '') continue ;;
            fma) grep -q ' fma .* avx2 ' /proc/cpuinfo 2>/dev/null || continue
                 want=${options%% *} options=${options#* } ;;
            esac
            options=$(echo $options)
            case $options in
            *fpack-struct*) ;;                        # warns of itself
            -m32*) makes_32 "$compiler -m32" && knows "$compiler" "$options" || continue ;;
            *) knows $compiler "$options" || continue ;;
            esac
            try_flags "$want" "$options" $compiler
        done <"$here/flags.txt"
        if [ $((passed + failed - before)) -ge 20 ]; then pass; else fail "$compiler knows only $((passed + failed - before)) of the options of flags.txt"; fi
    done
    if present tcc; then
        try_flags same "" tcc
    else
        skipped=$((skipped + 1))
    fi
    for machine in names integers; do
        if run_on_all $machine "${CC:-cc}"; then pass; else fail "$machine: not as the reference"; fi
    done
}

# ---- recommended: the options that an #error recommends have a row in flags.txt, or are --soft, which is tested above ----

recommended() {
    found=0
    for text in "$root/compiler/emit/c/guard.c" "$root/stdlib/f64.h"; do
        grep '#error.* with -' "$text" | sed 's/.* with \(-[^"\\,]*\).*/\1/' >"$dir/recommended"
        while read -r options; do
            found=$((found + 1))
            if [ "$options" = -DSM_F64_SOFT=1 ] || grep -q -- "^same  *-m32 $options\$" "$here/flags.txt"; then pass; else fail "recommended: $options has no row in flags.txt"; fi
        done <"$dir/recommended"
    done
    if [ $found -ge 3 ]; then pass; else fail "recommended: only $found #error lines recommend an option"; fi
}

# ---- use: programs around machines ----

build_and_run() {   # PROGRAM SOURCES COMPILER
    if $3 $strict -I"$dir" -o "$dir/$1" $2 -lm >"$dir/log" 2>&1 && [ ! -s "$dir/log" ] && "$dir/$1" >"$dir/log" 2>&1; then
        pass
    else
        fail "$1: $3"
    fi
}

# With numbers in software: the reference's bits, and no arithmetic on floats is left to refuse.
soft_machine() {    # COMPILER
    for machine in arithmetic integers names; do
        rm -f "$dir/log"
        if CC=$1 "$smc" test "$here/machines/$machine.sm" "$here/machines/$machine.ss" --engine=ref,c-soft >"$dir/out" 2>"$dir/log"; then
            pass
        else
            fail "$machine: --soft, $1"
        fi
    done
}

use() {
    for m in valve pump; do
        "$smc" build -w "$here/machines/$m.sm" --sv "$here/machines/bus.sv" --emit=c --track-stores -o "$dir/$m.c" >"$dir/log" 2>&1
    done
    "$smc" build "$here/machines/bus.sv" --emit=c -o "$dir/bus.c" >"$dir/log" 2>&1
    "$smc" build -w "$here/machines/arithmetic.sm" --emit=c -o "$dir/arithmetic.c" >"$dir/log" 2>&1
    every_compiler soft_machine
    every_compiler build_and_run two_machines "$here/two_machines.c $dir/valve.c $dir/pump.c $dir/bus.c"
    for compiler in gcc clang-19; do
        if present $compiler; then
            build_and_run modes "$here/modes.c $dir/arithmetic.c" "$compiler -O2 -frounding-math"
            compile_one valve "$compiler -std=c99 -ffreestanding"
            compile_one valve "$compiler -x c++ -std=c++11 -fno-exceptions -fno-rtti"
        else
            skipped=$((skipped + 1))
        fi
    done
}

# ---- foreign: the header can be read by programs that know C's declarations but do not calculate ----

foreign() {
    printf '[state_vector]\nU64 G\nU32 S\nF32 x @read_only\nF64 least\n[local]\nU16 steps = 0\nF64 limit = 5\n[A]\n.step\nsteps = steps + 1\nleast = roll_min(x, 100)\nx > limit * 100: -> B\n[B]\n' >"$dir/far.sm"
    "$smc" build -w "$dir/far.sm" --emit=c -o "$dir/far.c" >"$dir/log" 2>&1
    sed -e 's,//.*,,' -e '/^#/d' "$dir/far.h" | grep '[?]\|sizeof\|<<' >"$dir/log"
    if [ ! -s "$dir/log" ]; then pass; else fail "foreign: the header calculates"; fi
    if sed -n '/never stored/,/^}/p' "$dir/far.h" | grep -q '^    double   limit;' && ! sed -n '/never stored/,/^}/p' "$dir/far.h" | grep -q steps; then
        pass
    else
        fail "foreign: the header does not say which locals are never stored"
    fi
    if ! present python3 || ! python3 -c 'import cffi' 2>/dev/null; then
        skipped=$((skipped + 1))
        return
    fi
    sed '/^#include/d' "$dir/far.h" | ${CC:-cc} -E -P -x c - >"$dir/far.i"
    if ${CC:-cc} -shared -fPIC "$dir/far.c" -o "$dir/far.so" 2>"$dir/log" && python3 "$here/foreign.py" "$dir/far.i" "$dir/far.so" 2>"$dir/log"; then
        pass
    else
        fail "foreign: cffi"
    fi
}

# ---- size: what makes machines small ----

# count_functions PATTERN OBJECT…: how many functions of the objects have such names
count_functions() {
    pattern=$1
    shift
    nm "$@" | grep -c " [tTwW] .*$pattern"
}

size() {
    if ! present nm; then
        skipped=$((skipped + 1))
        return
    fi
    "$smc" build -w "$root/examples/mission/mission.sm" --sv "$root/examples/mission/rocket.sv" --emit=c -o "$dir/mission.c" >"$dir/log" 2>&1
    "$smc" build -w "$root/examples/mission/airbrakes.sm" --sv "$root/examples/mission/rocket.sv" --emit=c -o "$dir/airbrakes.c" >"$dir/log" 2>&1
    gcc -std=c99 -Os -c "$dir/mission.c" -o "$dir/mission.o" 2>"$dir/log"
    if [ "$(count_functions 'sm_roll_\(key\|value\|load\|store\|shift\|row_bytes\|extreme_of_two\)' "$dir/mission.o")" -eq 0 ]; then
        pass
    else
        fail "size: at -Os short functions of windows are called"
    fi
    for compiler in "gcc -std=c99" tcc "g++ -x c++"; do
        try "$compiler" share_self_test
    done
}

# One machine has the self-test for both.
share_self_test() {
    rm -f "$dir/log"
    if $1 $strict -DSM_SHARED_SELF_TEST=1 -c "$dir/mission.c" -o "$dir/mission.o" && $1 $strict -DSM_SHARED_SELF_TEST=0 -c "$dir/airbrakes.c" -o "$dir/airbrakes.o" &&
        [ "$(count_functions is_fit "$dir/mission.o" "$dir/airbrakes.o")" -eq 1 ] && nm "$dir/mission.o" | grep -q ' T sm_is_fit$'; then
        pass
    else
        fail "size: the self-test is not shared, $1"
    fi
}

# ---- readings: what no machine stores.  An element that is NaN reads as 0, though C does not look where a condition comes out the
# same; a U64 beyond 2^53 as the nearest F64, although it can be counted exactly ----

# A state each for relations of x and f with numbers, alone, two together, and one that is asked for twice.
make_readings() {
    awk 'function pick(list, n) { return list[int(rand() * n) + 1] }
    function relation(v) { return (rand() < 0.15 ? "not " : "") "(" v " " pick(op, 6) " " pick(number, 7) ")" }
    function state(first, condition) {
        print "[N" ++n "]\n.step\n" first "\nif " condition " { seen = 1 }\nelse { seen = 2 }\n-> N" n + 1
    }
    BEGIN {
        split("< <= > >= == !=", op); split("-1000.5 -5 -0.5 0 0.5 5 y", number); split("x f", v); split("and or", and)
        print "[state_vector]\nU64 G\nU32 S\nF64 x @read_only\nF32 f @read_only\nF64 y @read_only\nU8 seen\nbool also\nU64 n"
        state("also = true\nn = n + 1", "x < y")
        for (i = 1; i <= 2; i++) for (o = 1; o <= 6; o++) for (c = 1; c <= 7; c++) state("also = true", v[i] " " op[o] " " number[c])
        for (i = 0; i < 300; i++) {
            e = pick(v, 2); a = relation(e); b = relation(rand() < 0.8 ? e : pick(v, 2))
            state("also = " (i % 3 ? "true" : b), a " " pick(and, 2) " " b (i % 2 ? "" : " " pick(and, 2) " " b " " pick(and, 2) " " relation("y")))
        }
        print "[N" n + 1 "]"
    }'
}

readings() {
    make_readings >"$dir/readings.sm"
    for level in -O0 -O1 -O2; do
        rm -f "$dir/readings.c"
        "$smc" build -w $level "$dir/readings.sm" --emit=c -o "$dir/readings.c" >"$dir/log" 2>&1
        few_compilers build_and_run readings "$here/readings.c $dir/readings.c"
        try "gcc $x86_32 -O1" build_and_run readings "$here/readings.c $dir/readings.c"
    done
    rm -f "$dir/readings.c"
    "$smc" build -w --soft "$dir/readings.sm" --emit=c -o "$dir/readings.c" >"$dir/log" 2>&1
    for compiler in "gcc -std=c99" tcc; do
        try "$compiler" build_and_run readings "-I$root $here/readings.c $dir/readings.c $(echo "$root"/stdlib/soft_*.c)"
    done
}

# ---- parameters: they are read and set through a struct ----

parameters() {
    for level in -O0 -O2; do
        rm -f "$dir/deploy.c"
        "$smc" build -w $level "$here/machines/deploy.sm" --emit=c -o "$dir/deploy.c" >"$dir/log" 2>&1
        every_compiler build_and_run parameters "$here/parameters.c $dir/deploy.c"
    done
}

# ---- wide: integers of 64 bits beyond 2^53, which no state script stores ----

wide() {
    for level in -O0 -O1 -O2; do
        rm -f "$dir/wide.c"
        "$smc" build -w $level "$here/machines/wide.sm" --emit=c -o "$dir/wide.c" >"$dir/log" 2>&1
        every_compiler build_and_run wide "$here/wide.c $dir/wide.c"
        compilers_32 build_and_run wide "$here/wide.c $dir/wide.c"
    done
}

# ---- straight: conditionals that only say which come out without a jump, and what decides an `and` stands for it: tcc 0.9.27 compiles
# false && 0.0 <= (x != 0.0 || false ? 1.0 : 0.0) to a jump past the end of the function ----

straight() {
    for level in -O1 -O2; do
        "$smc" build $level "$root/examples/tank/tank.sm" --emit=c -o "$dir/tank.c" >"$dir/log" 2>&1
        for line in 'sv->valveOpen = test1;' 'm->counter = sm_count_up_if(m->counter, test1);'; do
            if grep -qF "$line" "$dir/tank.c"; then pass; else fail "straight: tank $level has no '$line'"; fi
        done
    done
    printf '[state_vector]\nU64 G\nU32 S\nbool b\n[Run]\n.step\nif 0 and 0 <= (S or 0): b = true\n' >"$dir/decided.sm"
    "$smc" build -w -O0 "$dir/decided.sm" --emit=c -o "$dir/decided.c" >"$dir/log" 2>&1
    if grep -q 'decided_Run_step(void)' "$dir/decided.c"; then pass; else fail "straight: what an 'and' with false decides is asked for"; fi
}

# ---- cases: every machine of conformance/, at -O0, -O1 and -O2; takes minutes ----

cases() {
    for file in $(find "$root/conformance" -name '*.smt' | sort); do
        rm -f "$dir"/case.*
        awk -v dir="$dir" '/^-- .* --$/ { out = $2 ~ /\.s[mv]$/ ? dir "/case" substr($2, length($2) - 2) : ""; next } out { print >out }' "$file"
        [ -f "$dir/case.sm" ] || continue
        sv=
        [ -f "$dir/case.sv" ] && sv="--sv $dir/case.sv"
        for level in -O0 -O1 -O2; do
            "$smc" build -w $level "$dir/case.sm" $sv --emit=c -o "$dir/case.c" 2>/dev/null || continue
            echo "$file" >"$dir/log"
            few_compilers compile_one case
        done
    done
}

for part in ${*:-matrix flags recommended use foreign size readings parameters wide straight}; do
    $part
done
echo "emitc: $passed passed, $failed failed, $skipped skipped"
[ "$failed" -eq 0 ] && [ $((passed + skipped)) -gt 0 ]
