# SPDX-License-Identifier: Apache-2.0
# For tests of smc.exe and smc.dll, to be read in by `. tests/windows/wine.sh`, after these are set:
#     make, build, cc        as in the Makefile           machine: x86_64 or i686
# It builds them, and makes $folder with an empty Wine and $smc, a command that runs smc.exe.  Without a compiler or Wine it ends the script with what
# to install, and with exit code 1 if MUST_RUN is 1.
for tool in "$machine-w64-mingw32-gcc" wine; do
    if ! command -v "$tool" >/dev/null 2>&1; then
        echo "no $tool here (apt-get install wine wine64 gcc-mingw-w64-$(echo "$machine" | tr _ -)): 0 passed, 0 failed, 1 skipped"
        exit ${MUST_RUN:-0}
    fi
done
$make -s B="$build" BUILD_CC="$cc" CFLAGS='-O2 -Werror' "windows-$machine" >/dev/null || { echo "make windows-$machine failed: 0 passed, 1 failed"; exit 1; }
files=$(cd "$build/windows-$machine" && pwd)
folder=$(cd "$build" && pwd)/windows-test-$machine
mkdir -p "$folder/tmp" "$folder/wine"
export WINEPREFIX="$folder/wine" WINEDEBUG=-all WINEDLLOVERRIDES='mscoree,mshtml='
unset DISPLAY CC
# One server of Wine for the whole script.  Debian's wineserver is `wineserver -p0`, which ends with the last program, so that each command would start
# Wine again.  The server needs the folder.
wineserver -k 2>/dev/null
wineserver -w 2>/dev/null
wineserver -p 2>/dev/null
trap 'wineserver -k' EXIT
[ -f "$WINEPREFIX/system.reg" ] || wine wineboot -i >"$folder/wineboot.log" 2>&1
if ! wine "$files/smc.exe" --version >"$folder/version.log" 2>&1 </dev/null; then
    echo "Wine does not run $machine programs here: 0 passed, 0 failed, 1 skipped"
    exit ${MUST_RUN:-0}
fi
smc=$folder/smc
printf '#!/bin/sh\nexec wine "%s/smc.exe" "$@"\n' "$files" >"$smc"
chmod +x "$smc"
