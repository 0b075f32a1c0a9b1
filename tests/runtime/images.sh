#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# The images that the tests run, as C.     images.sh SMC
dir=$(mktemp -d "${TMPDIR:-/tmp}/smc-images.XXXXXX") || exit 1
trap 'rm -rf "$dir"' EXIT
smc=$1

# image NAME BUILD-ARGUMENTS…
image() {
    name=$1
    shift
    "$smc" build -w -o "$dir/image" "$@" || exit 1
    echo "static const uint8_t ${name}_image[] = {"
    od -An -v -tx1 "$dir/image" | sed 's/ *\([0-9a-f][0-9a-f]\)/0x\1, /g'
    echo '};'
}

echo '#include <stdint.h>'
here=tests/runtime
image tester -g --sv $here/stand.sv $here/tester.sm
image stripped --sv $here/stand.sv $here/tester.sm
image pair -g --sv $here/stand.sv $here/bystander.sm $here/tester.sm
image picker --sv $here/many.sv $here/picker.sm
image pins --sv $here/pins.sv --io $here/pins.io $here/pinned.sm
image second --sv $here/shared.sv $here/second.sm
