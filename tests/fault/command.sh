#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Makes each call to the system fail in turn, in several commands: the command must report it and end with exit code 3, or
# end as ever; each output file must be whole, the old one or the new one; nothing may be left lying about.
#     command.sh SMC SHIM        CASE=words runs only the commands that contain them
smc=$(realpath "$1") shim=$(realpath "$2")
examples=$(realpath examples)
passed=0 failed=0
dir=$(mktemp -d "${TMPDIR:-/tmp}/smc-fault.XXXXXX") || exit 1
trap 'rm -rf "$dir"' EXIT
trap 'exit 130' INT TERM
mkdir "$dir/tmp" "$dir/expected" "$dir/at"
export TMPDIR="$dir/tmp"

cp "$examples/tank/tank.sm" "$examples/tank/tank.ss" "$dir/at/"
mkdir "$dir/at/cases"
cat >"$dir/at/cases/one.smt" <<'END'
-- a.sm --
[state_vector]
U64 G
U32 S
[A]
-- a.ss --
[options]
delta_t 1
[A]
true {
    @assert T == G
    @stop
}
END
"$smc" build "$dir/at/tank.sm" -g -o "$dir/at/image.smb" && "$smc" key "$dir/at/image.key" || exit 1

complain() {
    failed=$((failed + 1))
    echo "smc $command"
    echo "    $fault: $*"
    sed 's/^/    /' "$dir/err" | head -5
}

# An output file must be as it was before or as it becomes.  A report in XML may tell of the failure; it must be whole.
# A trace may end with the step at which an engine broke down.
is_beginning() { head -c "$(wc -c <"$1")" "$2" | cmp -s - "$1"; }

# But for the time that tests took.
is_equal() {
    case $1 in *.xml) sed -i 's/ time="[^"]*"//g' "$1" "$2" ;; esac
    cmp -s "$1" "$2"
}

judge_files() {
    for name in $outputs; do
        if [ "${name%.xml}" != "$name" ] && [ -e "$dir/at/$name" ]; then
            [ "$(tail -n 1 "$dir/at/$name")" = "</testsuites>" ] || { complain "$name is not whole"; return 1; }
        elif [ "${name%.trace}" != "$name" ] && [ "$code" -eq 4 ]; then
            is_beginning "$dir/at/$name" "$dir/expected/$name" || { complain "$name is not the beginning of what it should be"; return 1; }
        elif [ -e "$dir/at/$name" ]; then
            cmp -s "$dir/at/$name" "$dir/expected/$name" || cmp -s "$dir/at/$name" "$dir/old" || { complain "$name is neither the old nor the new file"; return 1; }
        elif [ -n "$over" ]; then
            complain "$name is gone"
            return 1
        fi
    done
    extra=$(cd "$dir/at" && ls -A | grep -vxF "$(printf '%s\n' $inputs $outputs)")
    [ -z "$extra" ] || { complain "left behind: $extra"; return 1; }
    case $kind in memory | opendir) rm -rf "$dir/tmp/"* ;; esac      # a folder is emptied by opening it
    [ -z "$(ls -A "$dir/tmp")" ] || { complain "left behind in TMPDIR: $(ls -A "$dir/tmp")"; rm -rf "$dir/tmp/"*; return 1; }
}

# The command can go on without an engine that is missing, if it reports that.
judge() {
    missing=$(grep -c "was left out" "$dir/err")
    case $1 in
    0)
        [ "$missing" -eq 0 ] || { judge_files; return; }
        case $kind in read | write | half-write | fsync | rename) complain "exit 0: the failure was not noticed"; return 1 ;; esac
        for name in $outputs; do
            is_equal "$dir/at/$name" "$dir/expected/$name" || { complain "exit 0, but $name is not what it should be"; return 1; }
        done
        cmp -s "$dir/out" "$dir/expected.out" || { complain "exit 0, but it printed something else"; return 1; } ;;
    3)
        [ -s "$dir/err" ] || [ "${fault#*write}" != "$fault" ] || { complain "exit 3 and no message"; return 1; } ;;
    4)
        grep -q "engine c failed" "$dir/err" "$dir/out" || { complain "exit code $1"; return 1; } ;;    # its process broke down
    *)
        complain "exit code $1"
        return 1 ;;
    esac
    judge_files
}

clean_outputs() {
    rm -f "$dir"/at/out.*
    for name in $outputs; do
        [ -z "$over" ] || cp "$dir/old" "$dir/at/$name"
    done
}

run() { (cd "$dir/at" && eval "$1 \"\$smc\" $command" >"$dir/out" 2>"$dir/err" <tank.sm); }

# Faults that were put in, by kind: "KIND NUMBER" a line for each command.
met=$dir/met

# at_least NUMBER KIND: at least NUMBER failures of this kind were injected in all commands together; a call that the command does not make any more,
# or that does not come by the shim, would take its cases along without a word.
at_least() {
    n=$(awk -v kind="$2" '$1 == kind { n += $2 } END { print n + 0 }' "$met")
    if [ "$n" -ge "$1" ]; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "only $n calls of the kind $2 were made to fail; there should be at least $1"
    fi
}

# try OUTPUTS COMMAND…: the command with every kind of fault, at every call
try() {
    outputs=$1
    shift
    command=$*
    case $command in *"$CASE"*) ;; *) return ;; esac
    inputs="tank.sm tank.ss cases image.smb image.key"
    clean_outputs
    run ""
    code=$?
    [ $code -eq 0 ] || { fault="no fault"; complain "exit code $code"; return; }
    cp "$dir/out" "$dir/expected.out"
    for name in $outputs; do
        cp "$dir/at/$name" "$dir/expected/$name"
    done
    for kind in memory open read write half-write close fsync fchmod rename mkstemp mkdtemp opendir spawn socketpair send recv; do
        n=1 most=${MOST:-60}
        case $kind in send | recv) most=5 ;; esac             # one exchange a step
        while [ $n -le $most ]; do
            fault=$kind:$n
            rm -f "$dir/mark"
            clean_outputs
            run "LD_PRELOAD=\"\$shim\" SMC_FAULT=$fault SMC_FAULT_MARK=\"\$dir/mark\""
            code=$?
            [ -e "$dir/mark" ] || break
            judge $code && passed=$((passed + 1))
            n=$((n + 1))
        done
        echo "$kind $((n - 1))" >>"$met"
    done
    # Each output is made under another name, brought to the disk, and then renamed: its own three calls at least.
    for kind in fsync rename mkstemp; do
        files=$(for name in $outputs; do case $name in *.trace) ;; *) echo "$name" ;; esac; done | wc -l)
        [ "$(grep "^$kind " "$met" | tail -n 1 | cut -d ' ' -f 2)" -ge "$files" ] && continue
        fault=$kind complain "not each of $outputs is written with that call"
    done
}

echo "// an old file.  Made by smc from something." >"$dir/old"
(command=--version && run "LD_PRELOAD=\"\$shim\" SMC_FAULT=write:1 SMC_FAULT_MARK=\"\$dir/mark\"")
[ -e "$dir/mark" ] || { echo "faults cannot be injected here: 0 passed, 0 failed, 1 skipped"; exit 0; }

over=
try "out.smb" build tank.sm -o out.smb
try "out.c out.h" build tank.sm --emit=c -o out.c
try "" build - -o -
try "" check tank.sm tank.ss
try "" disasm image.smb
try "" verify image.smb
try "out.smb" sign image.smb --key=image.key --number=7 -o out.smb
try "" test tank.sm tank.ss
try "out.trace out.xml" test tank.sm tank.ss --engine=all --trace=out.trace --junit=out.xml
try "" test cases --engine=vm
try "" explain E0204
try "" --help
over=yes
try "out.smb out.d" build tank.sm -o out.smb -MD -MF out.d
try "out.c out.h" build tank.sm --emit=c -o out.c
if [ -z "$CASE" ]; then
    for floor in 80:memory 12:open 24:read 14:write 14:half-write 20:close 9:fsync 9:fchmod 9:rename 9:mkstemp 1:mkdtemp 1:opendir 3:spawn \
        1:socketpair 5:send 5:recv; do
        at_least "${floor%:*}" "${floor#*:}"
    done
fi
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
