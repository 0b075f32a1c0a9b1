# SPDX-License-Identifier: Apache-2.0
# Which changes of tests/cover/verdicts.sm `smc mutate --generate` proves to make no difference: those of verdicts.txt and no other.
#     sh tests/cover/verdicts.sh SMC
smc=$1
dir=$(mktemp -d) || exit 1
trap 'rm -rf "$dir"' EXIT

"$smc" mutate -w tests/cover/verdicts.sm tests/cover/verdicts.ss --generate --format=json -o "$dir/list.json" || exit 1
sed -n -e 's/,"if":"only inputs change"/,if only inputs change/' \
    -e 's/{"line":\([0-9]*\),"column":\([0-9]*\),.*"old":"\(.*\)","new":"\(.*\)","danger".*"equivalent"\(.*\)}.*/\1:\2 \3 -> \4\5/p' "$dir/list.json" >"$dir/equivalent"
unknown=$(grep -c '"unnoticed"}' "$dir/list.json")
if ! diff -u tests/cover/verdicts.txt "$dir/equivalent" || test "$unknown" -gt 3; then
    echo "mutation-verdicts: 0 passed, 1 failed ($unknown unknown)"
    exit 1
fi
echo "mutation-verdicts: $(grep -c . "$dir/equivalent") passed, 0 failed ($unknown unknown)"
