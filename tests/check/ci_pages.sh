#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# ci_pages.sh SMC FOLDER: runs the recipe of docs/ci.md, and parses its examples for CI servers.  Wants python3 with yaml.
smc=$1 folder=$2
command -v python3 >/dev/null && python3 -c 'import yaml' 2>/dev/null ||
    { echo "ci_pages: wants python3-yaml"; echo "0 passed, 0 failed, 1 skipped"; exit 0; }
sh tests/check/docs.sh "$smc" "$folder" docs/ci.md || exit 1
python3 tests/check/ci_pages.py "$folder/docs_ci.md"
