#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Makes each call to the system fail in turn, in several commands: the command must say so and end with exit code 3, or
# end as ever; each output file must be whole, the old one or the new one; nothing may be left lying about.
#     command.sh SMC SHIM        CASE=words runs only the commands that contain them
smc=$(realpath "$1") shim=$(realpath "$2")
examples=$(realpath examples)
passed=0 failed=0
dir=$(mktemp -d "${TMPDIR:-/tmp}/smc-fault.XXXXXX") || exit 1
trap 'rm -rf "$dir"' EXIT
trap 'exit 130' INT TERM
mkdir "$dir/tmp" "$dir/expected" "$dir/work"
export TMPDIR="$dir/tmp"

cp "$examples/tank/tank.sm" "$examples/tank/tank.ss" "$dir/work/"
mkdir "$dir/work/cases"
cat >"$dir/work/cases/one.smt" <<'END'
-- a.sm --
[state_vector]
U64 G
U32 S
[A]
-- a.ss --
[options]
delta_t 1
[A]
true: @stop
END
"$smc" build "$dir/work/tank.sm" -g -o "$dir/work/image.smb" || exit 1

# What the folder holds beside the inputs, by name and content.
listing() { (cd "$1" && ls -A | sort && cat out.* 2>/dev/null | cksum); }

complain() {
    failed=$((failed + 1))
    echo "smc $command"
    echo "    $fault: $*"
    sed 's/^/    /' "$dir/err" | head -5
}

# An output file must be as it was before or as it becomes.
judge_files() {
    for name in $outputs; do
        if [ -e "$dir/work/$name" ]; then
            cmp -s "$dir/work/$name" "$dir/expected/$name" || cmp -s "$dir/work/$name" "$dir/old" || { complain "$name is neither the old nor the new file"; return 1; }
        elif [ -n "$over" ]; then
            complain "$name is gone"
            return 1
        fi
    done
    extra=$(cd "$dir/work" && ls -A | grep -vxF "$(printf '%s\n' $inputs $outputs)")
    [ -z "$extra" ] || { complain "left behind: $extra"; return 1; }
    [ -z "$(ls -A "$dir/tmp")" ] || { complain "left behind in TMPDIR: $(ls -A "$dir/tmp")"; rm -rf "$dir/tmp/"*; return 1; }
}

judge() {
    case $1 in
    0)
        for name in $outputs; do
            cmp -s "$dir/work/$name" "$dir/expected/$name" || { complain "exit 0, but $name is not what it should be"; return 1; }
        done
        cmp -s "$dir/out" "$dir/expected.out" || { complain "exit 0, but it printed something else"; return 1; } ;;
    3)
        [ -s "$dir/err" ] || [ "${fault#*write}" != "$fault" ] || { complain "exit 3 and no message"; return 1; } ;;
    *)
        complain "exit code $1"
        return 1 ;;
    esac
    judge_files
}

clean_outputs() {
    for name in $outputs; do
        rm -f "$dir/work/$name"
        [ -z "$over" ] || cp "$dir/old" "$dir/work/$name"
    done
}

run() { (cd "$dir/work" && eval "$1 \"\$smc\" $command" >"$dir/out" 2>"$dir/err" <tank.sm); }

# try OUTPUTS COMMAND…: the command with every kind of fault, at every call
try() {
    outputs=$1
    shift
    command=$*
    case $command in *"$CASE"*) ;; *) return ;; esac
    inputs="tank.sm tank.ss cases image.smb"
    clean_outputs
    run ""
    code=$?
    [ $code -eq 0 ] || { fault="no fault"; complain "exit code $code"; return; }
    cp "$dir/out" "$dir/expected.out"
    for name in $outputs; do
        cp "$dir/work/$name" "$dir/expected/$name"
    done
    for kind in memory open read write half-write close fsync fchmod rename mkstemp mkdtemp opendir spawn socketpair send recv; do
        n=1
        while [ $n -le ${MOST:-60} ]; do
            fault=$kind:$n
            rm -f "$dir/mark"
            clean_outputs
            run "LD_PRELOAD=\"\$shim\" SMC_FAULT=$fault SMC_FAULT_MARK=\"\$dir/mark\""
            code=$?
            [ -e "$dir/mark" ] || break
            judge $code && passed=$((passed + 1))
            n=$((n + 1))
        done
    done
}

echo "an old file" >"$dir/old"
(command=--version && run "LD_PRELOAD=\"\$shim\" SMC_FAULT=write:1 SMC_FAULT_MARK=\"\$dir/mark\"")
[ -e "$dir/mark" ] || { echo "faults cannot be injected here: 0 passed, 0 failed, 1 skipped"; exit 0; }

over=
try "out.smb" build tank.sm -o out.smb
try "out.c out.h" build tank.sm --emit=c -o out.c
try "" build - -o -
try "" check tank.sm tank.ss
try "" disasm image.smb
try "" verify image.smb
try "" test tank.sm tank.ss
try "out.trace out.xml" test tank.sm tank.ss --engine=all --trace=out.trace --junit=out.xml
try "" test cases
try "" explain E0204
try "" --help
over=yes
try "out.smb out.d" build tank.sm -o out.smb -MD -MF out.d
try "out.c out.h" build tank.sm --emit=c -o out.c
echo "$passed passed, $failed failed"
[ $failed -eq 0 ]
