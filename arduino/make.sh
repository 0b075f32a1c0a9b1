#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Makes the Arduino library of this tree.     make.sh SMC OUT VERSION URL SOURCE…     OUT is its folder, removed before; OUT.zip where
# there is zip.  URL: where the project is published; may be empty.  What the sources include comes along.
smc=$1 out=$2 version=$3 url=$4
shift 4
here=$(dirname "$0")
rm -rf "$out" "$out.zip"
mkdir -p "$out/src" || exit 1

for f in library.properties library.json; do
    sed -e "s|@VERSION@|$version|" -e "s|@URL@|$url|" "$here/$f" >"$out/$f" || exit 1
done
if [ -n "$url" ]; then
    sed "s|](\([a-z-]*\.md\)|]($url/blob/HEAD/docs/\1|g" docs/arduino.md >"$out/README.md" || exit 1
else                      # without an address to link to, the name of the file remains
    sed '/"homepage"/d' "$out/library.json" >"$out/library.new" && mv "$out/library.new" "$out/library.json" || exit 1
    sed -e :all -e '$!{' -e N -e ball -e '}' -e 's|\[\([^]]*\)\](\([a-z-]*\.md\))|\1 (docs/\2 of smc)|g' docs/arduino.md >"$out/README.md" || exit 1
fi
cp "$here/keywords.txt" LICENSE "$out" && cp "$here/smc.h" "$here/smc_config.h" "$out/src" || exit 1

# take FILE…: into src, with what they include by its path from the root
take() {
    while [ $# -gt 0 ]; do
        if [ ! -e "$out/src/$1" ]; then
            mkdir -p "$out/src/$(dirname "$1")" && cp "$1" "$out/src/$1" || exit 1
            set -- "$@" $(sed -n 's|^#include "\(.*/.*\)".*|\1|p' "$1")
        fi
        shift
    done
}
take "$@" $(sed -n 's|^#include "\(.*/.*\)".*|\1|p' "$here/smc.h" "$here/smc_config.h")

# The image that is built into the firmware.
safe=bytecode-vm/firmware/safe
"$smc" build -w $safe.sm --sv $safe.sv --io $safe.io -o "$out/safe.smb" || exit 1
od -An -v -tx1 "$out/safe.smb" | sed 's/ \(..\)/0x\1,/g' >"$out/src/safe_image.inc"
rm "$out/safe.smb"

# What sketches run: logic of this tree, made into what each of them includes.
mkdir "$out/examples" && cp -r "$here/examples/Firmware" "$out/examples" || exit 1
for sketch in "$here"/examples/Tank*/; do
    to=$out/examples/$(basename "$sketch")
    mkdir "$to" && cp "$sketch"* examples/tank/tank.sm "$to" && "$smc" build "$to/tank.sm" --emit=c --soft -o "$to/tank.c" || exit 1
done

# join FORM: the two forms of the C as one file, from which the compiler chooses as stdlib/f64.h does
join() {
    printf '#if SM_F64_SOFT\n' && cat "$to/tank.$1" && printf '#else\n' && cat "$to/double/tank.$1" && printf '#endif\n'
}
to=$out/examples/TankC
mkdir "$to/double" && "$smc" build "$to/tank.sm" --emit=c -o "$to/double/tank.c" || exit 1
{ printf '#include <float.h>\n\n' && sed -n '/^#ifndef SM_F64_SOFT$/,/^#if !/ { /^#if !/!p; }' stdlib/f64.h && join h; } >"$to/tank.h.new" &&
    { printf '#include "tank.h"\n\n' && join c; } >"$to/tank.c.new" && mv "$to/tank.h.new" "$to/tank.h" && mv "$to/tank.c.new" "$to/tank.c" && rm -r "$to/double" || exit 1

# A sketch that has the VM needs the C's headers alone.
rm "$out/examples/TankImage/"*.[cS]
"$smc" build "$out/examples/TankImage/tank.sm" --emit=array -o "$out/examples/TankImage/tank_image.h" || exit 1

if command -v zip >/dev/null 2>&1; then
    (cd "$(dirname "$out")" && find "$(basename "$out")" -type f | LC_ALL=C sort | zip -q -X "$(basename "$out").zip" -@)
fi
