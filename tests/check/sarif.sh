#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# sarif.sh SMC FOLDER CASE.smt…   Writes the findings of smc check in the machines of the cases as SARIF and validates them with the schema of
# OASIS.  The schema is no part of this tree: sarif_schema.sh gets it; python3 with jsonschema reads it.
smc=$1
folder=$2
shift 2
schema=$folder/schema.json
python=
for p in python3 /usr/bin/python3; do
    "$p" -c 'import jsonschema' 2>/dev/null && { python=$p; break; }
done
if [ -z "$python" ] || ! [ -f "$schema" ]; then
    echo "sarif: wants python3-jsonschema and the schema, from: sh tests/check/sarif_schema.sh $schema"
    echo "0 passed, 0 failed, 1 skipped"
    exit 0
fi

rm -rf "$folder/case"
mkdir -p "$folder/case"
n=0
for file; do
    n=$((n + 1))
    here=$folder/case/$n
    mkdir "$here"
    awk -v out="$here" '/^-- [a-z0-9_.-]+ --\r?$/ { name = $2; next } name ~ /^[a-z0-9_-]+\.(sv|sm|ss)$/ { print >(out "/" name) }' "$file"
    set -- "$here"/*.sm
    [ -f "$1" ] || continue
    sv=$(ls "$here"/*.sv 2>/dev/null | head -n 1)
    "$smc" check "$@" ${sv:+--sv "$sv"} -Weverything --message-file="$here/found.sarif" 2>/dev/null
done
mkdir "$folder/case/none"
"$smc" check "$folder/case/none/there-is-none.sm" --message-file="$folder/case/none/found.sarif" 2>/dev/null
"$python" tests/check/sarif.py "$schema" "$folder"/case/*/found.sarif
