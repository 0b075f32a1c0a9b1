#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# smc.exe with names and disks that are hard to handle: umlauts, blanks, both slashes, 300 characters, a full disk,
# keys.  An output appears whole or not at all.     files.sh MAKE BUILD CC MACHINE
make=$1 build=$2 cc=$3 machine=$4
. tests/windows/wine.sh
. tests/checks.sh
dir=$folder/tmp
root=$(pwd)
export LC_ALL=C.UTF-8
rm -rf "$dir/files" && mkdir -p "$dir/files" && cd "$dir/files" || exit 1
cp "$root/examples/tank/tank.sm" "$root/examples/tank/tank.ss" .
native=$(cd "$root/$build" 2>/dev/null || cd "$build"; pwd)/smc
"$native" build -g tank.sm -o expected.smb || exit 1

# built SOURCE OUTPUT FILE: smc.exe writes OUTPUT, which is FILE here, with the bytes that smc writes
built() { "$smc" build -g "$1" -o "$2" && "$native" build -g "$(echo "$1" | sed 's/^z://' | tr '\\' /)" -o "$dir/want" --force && cmp "$dir/want" "$3"; }
mkdir -p 'ü ö'
cp tank.sm 'ü ö/größe € 火.sm'
check "umlauts and blanks" built 'ü ö/größe € 火.sm' 'ü ö/größe € 火.smb' 'ü ö/größe € 火.smb'
check "backslashes" built 'ü ö\größe € 火.sm' 'ü ö\b.smb' 'ü ö/b.smb'
check "a folder with a backslash" built tank.sm 'ü ö\' 'ü ö/tank.smb'
check "a new folder with a backslash" built tank.sm 'new ä\' 'new ä/tank.smb'
check "an absolute path with a drive" built "z:$PWD/tank.sm" "Z:$(echo "$PWD" | tr / '\\')\\drive.smb" drive.smb

# 300 characters in all, in folders of 60; and a name of 255 bytes is the most that the file system below holds.
part=$(printf 'längerer-Name-%.0s' 1 2 3 4)
long=$part/$part/$part/$part/$part/$part
mkdir -p "$long"
cp tank.sm "$long/tank.sm"
check "the path has 300 characters" test ${#long} -ge 300
check "300 characters" built "$long/tank.sm" "$long/long.smb" "$long/long.smb"
check "300 characters, other slashes, and a report" sh -c "'$smc' report '$(echo "$long" | tr / '\\')\\tank.sm' tank.ss -o '$long/r.html' && grep -q '</html>' '$long/r.html'"
check "300 characters in a folder of cases" sh -c "cp '$root/conformance/01-basics'/*.smt '$long' 2>/dev/null || cp \$(ls '$root'/conformance/*/*.smt | head -n 3) '$long'; '$smc' test '$long' | grep -q '[1-9][0-9]* passed, 0 failed'"

check "standard input and output" sh -c "'$smc' build -g - -o - <tank.sm >stdout.smb && [ -s stdout.smb ] && '$smc' verify stdout.smb >/dev/null && ! grep -q \"\$(printf '\\r')\" stdout.smb"
check "/dev/stdout and /dev/null" sh -c "'$smc' build -g tank.sm -o /dev/stdout --force | cmp - expected.smb && '$smc' build tank.sm -o /dev/null && '$smc' build tank.sm -o NUL"
check "lines that end with CR LF" sh -c "sed 's/\$/\\r/' tank.sm >crlf.sm && '$smc' build crlf.sm -o crlf.smb"
code_of() { want=$1; shift; "$@"; [ $? -eq "$want" ]; }
check "an input that is missing" sh -c "'$smc' build missing/ü.sm -o - 2>&1 | grep -x \"smc: cannot read 'missing/ü.sm': No such file or directory\""
check "with exit code 3" code_of 3 "$smc" build missing/x.sm -o -
check "a folder that is missing" sh -c "'$smc' build tank.sm -o missing/x.smb 2>&1 | grep -x \"smc: cannot write 'missing/x.smb': No such file or directory\""
check "a name that Windows does not have" sh -c "'$smc' build tank.sm -o 'a|b?.smb'; [ \$? -eq 3 ] || [ -f 'a|b?.smb' ]"

check "no temporary file is left" sh -c "! find . | grep -E '\\.(smb|html)\\.[a-z0-5]{6}\$'"

# A full disk: a file system of 64 KB, or the device /dev/full where none can be mounted.
check "a device that is full" sh -c "'$smc' build tank.sm -o /dev/full 2>&1 | grep -x \"smc: cannot write '/dev/full': No space left on device\""
mkdir -p full
if mount -t tmpfs -o size=64k tmpfs full 2>/dev/null; then
    cp expected.smb full/old.smb
    dd if=/dev/zero of=full/rest bs=1k count=200 >/dev/null 2>&1
    "$smc" report tank.sm tank.ss -o full/r.html 2>full.err
    check "a full disk: exit code 3" test $? -eq 3
    check "a full disk: the reason" grep -qx "smc: cannot write 'full/r.html': No space left on device" full.err
    "$smc" build tank.sm -o full/old.smb --force 2>full.err
    check "a full disk: exit code 3 for a file that is there" test $? -eq 3
    check "a full disk: the old file stays" cmp expected.smb full/old.smb
    "$smc" test tank.sm tank.ss --trace=full/trace.csv >full.out 2>full.err
    check "a full disk: a trace is refused" test $? -eq 3
    check "a full disk: nothing else is left" sh -c "[ \"\$(ls full | tr '\n' ' ')\" = 'old.smb rest ' ]"
    umount full
else
    skip "a full disk (mount needs root)"
fi

# Keys are files that other users cannot read.
check "a key" sh -c "'$smc' key k.key && [ \$(wc -c <k.key) -eq 33 ] && [ -z \"\$(find k.key -perm /007)\" ]"
check "is not replaced" sh -c "cp k.key k.old; ! '$smc' key k.key && cmp k.key k.old"
check "and signs what the other smc accepts" sh -c "'$smc' sign expected.smb --key=k.key --number=7 -o signed.smb && chmod 600 k.key && '$native' sign expected.smb --key=k.key --number=7 -o here.smb && cmp signed.smb here.smb"
finish windows-files
