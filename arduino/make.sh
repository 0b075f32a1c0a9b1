#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Makes the Arduino library of this tree.     make.sh SMC OUT VERSION URL SOURCE…     OUT is its folder, removed before; OUT.zip where
# there is zip.  What the sources include comes along.
smc=$1 out=$2 version=$3 url=$4
shift 4
here=$(dirname "$0")
rm -rf "$out" "$out.zip"
mkdir -p "$out/src" || exit 1

for f in library.properties library.json; do
    sed -e "s|@VERSION@|$version|" -e "s|@URL@|$url|" "$here/$f" >"$out/$f" || exit 1
done
cp "$here/keywords.txt" LICENSE "$out" && sed "s|](\([a-z-]*\.md\)|]($url/blob/HEAD/docs/\1|g" docs/arduino.md >"$out/README.md" && cp "$here/smc.h" "$here/smc_config.h" "$out/src" || exit 1

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

# What sketches run: logic of this tree, made into what each of them includes.  A sketch that has the VM takes the C's headers alone.
mkdir "$out/examples" && cp -r "$here/examples/Firmware" "$out/examples" || exit 1
for sketch in "$here"/examples/Tank*/; do
    to=$out/examples/$(basename "$sketch")
    mkdir "$to" && cp "$sketch"* examples/tank/tank.sm "$to" && "$smc" build "$to/tank.sm" --emit=c --soft -o "$to/tank.c" || exit 1
done
rm "$out/examples/TankImage/"*.[cS]
"$smc" build "$out/examples/TankImage/tank.sm" --emit=array -o "$out/examples/TankImage/tank_image.h" || exit 1

if command -v zip >/dev/null 2>&1; then
    (cd "$(dirname "$out")" && find "$(basename "$out")" -type f | LC_ALL=C sort | zip -q -X "$(basename "$out").zip" -@)
fi
