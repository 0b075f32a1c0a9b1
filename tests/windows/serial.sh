#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# smc.exe and boards at COM ports of Wine: an image is sent to an emulated board through a bridged line; a port that is missing, that another program
# has opened, that is pulled out.     serial.sh MAKE BUILD CC MACHINE
make=$1 build=$2 cc=$3 machine=$4
. tests/windows/wine.sh
. tests/checks.sh
dir=$folder/tmp
native=$(cd "$build" && pwd)/smc
bridge= board=
trap 'for p in $bridge $board; do kill $p 2>/dev/null; done; wineserver -k' EXIT
$cc -std=gnu99 -O1 -Wall -Wextra tests/windows/bridge.c -o "$dir/bridge" || { echo "0 passed, 1 failed"; exit 1; }

# connect: a line, one end of which is COM33 of Wine, the other the terminal device $end
connect()
{
    rm -f "$dir/lines"
    "$dir/bridge" "$dir/lines" &
    bridge=$!
    until [ -f "$dir/lines" ] && [ "$(wc -l <"$dir/lines")" -ge 2 ]; do
        kill -0 $bridge 2>/dev/null || { echo "there is no line: 0 passed, 1 failed"; exit 1; }
        sleep 0.05
    done
    end=$(sed -n 2p "$dir/lines")
    ln -sf "$(sed -n 1p "$dir/lines")" "$WINEPREFIX/dosdevices/com33"
}
disconnect() { kill "$bridge"; wait "$bridge" 2>/dev/null; bridge=; }
within() { want=$1; shift; timeout 60 "$@" >"$dir/out" 2>&1; [ $? -eq "$want" ] || { cat "$dir/out"; return 1; }; }

"$native" build -g -w examples/tank/tank.sm --sv=tests/avr/tank.sv --io=tests/avr/tank.io -o "$dir/tank.smb" || exit 1
check "a port that is missing" within 3 "$smc" flash "$dir/tank.smb" --port=COM44
check "and why" grep -q "cannot open 'COM44': No such file or directory" "$dir/out"
check "a file is no port" within 3 "$smc" flash "$dir/tank.smb" --port="$dir/tank.smb"
check "and why not" grep -q "it is no serial line" "$dir/out"

connect
rm -f "$dir/board.memory"*
"$build/device/board" "$end" "$dir/board.memory" >"$dir/board.log" 2>&1 &
board=$!
check "flash through COM33" within 0 "$smc" flash "$dir/tank.smb" --port=COM33
check "the board lists it" within 0 "$smc" device list --port=COM33
cp "$dir/out" "$dir/there.list"
check "it is confirmed" within 0 "$smc" device confirm --port='\\.\COM33'
check "and started" within 0 "$smc" device log --port=COM33
check "the board runs" kill -0 $board
kill $board
wait $board 2>/dev/null
board=

# Pulled out while the command waits for an answer, and while it sends.
within 3 "$smc" device list --port=COM33 &
waiting=$!
sleep 1
begin=$(date +%s)
disconnect
check "a port that is pulled out ends the command with exit code 3" wait $waiting
check "soon" test $(($(date +%s) - begin)) -le 10
check "a port that has gone" within 3 "$smc" device list --port=COM33
finish windows-serial
