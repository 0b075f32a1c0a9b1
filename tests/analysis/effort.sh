# SPDX-License-Identifier: Apache-2.0
# The effort of trial runs is bounded: a machine of 400 elements in one state, on which the checks of outputs and of time limits once ran
# for more than a minute, is checked in a few seconds.
#     effort.sh SMC
smc=$1
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
awk '/^-- app.sm --$/ { on = 1; next } /^-- / { on = 0 } on' conformance/05-machines/four-hundred-elements.smt >"$out/elements.sm"
if [ -s "$out/elements.sm" ] && timeout 100 "$smc" check -Wflight "$out/elements.sm" 2>"$out/said"; then
    echo "effort: 1 passed, 0 failed"
else
    cat "$out/said" >&2
    echo "effort: 0 passed, 1 failed (the check takes more than 100 s, or fails)"
    exit 1
fi
