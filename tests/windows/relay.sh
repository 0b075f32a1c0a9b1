# SPDX-License-Identifier: Apache-2.0
# Gives programs under Wine a C compiler `cc`, until the script ends.  To be read in after wine.sh.
relay=$folder/relay
rm -rf "$relay" && mkdir -p "$relay/bin" || exit 1
"$machine-w64-mingw32-gcc" -O1 -s tests/windows/cc.c -o "$relay/bin/cc.exe" || exit 1
sh tests/windows/cc.sh "$machine-w64-mingw32-gcc" "$relay" &
relay_process=$!
trap 'kill $relay_process 2>/dev/null; wineserver -k' EXIT
export RELAY="$relay" TMPDIR="$folder/tmp" WINEPATH="Z:$(echo "$relay/bin" | tr / '\\\\')"
