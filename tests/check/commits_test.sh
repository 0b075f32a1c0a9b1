#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# commits.sh itself: which messages it accepts.
passed=0 failed=0
message=$(mktemp "${TMPDIR:-/tmp}/smc-message.XXXXXX") || exit 1
trap 'rm -f "$message" "$message.out"' EXIT

# expect CODE TEXT MESSAGE: commits.sh ends with CODE on the message, and prints TEXT
expect() {
    printf '%s\n' "$3" >"$message"
    sh tests/check/commits.sh -f "$message" >"$message.out" 2>&1
    if [ $? -eq "$1" ] && grep -q "$2" "$message.out"; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "not exit $1 and '$2' for:"
        cat "$message" "$message.out"
    fi
}

expect 0 '^1 passed, 0 failed' "$(printf 'vm: verify sizes before offsets\n\nAn offset past the end was read first.\n')"
expect 0 '^1 passed, 0 failed' "$(printf 'psl/avr: pins are set by one function; test: a case of it\n')"
expect 1 'must begin with the part' "$(printf 'Fixed a bug\n')"
expect 1 'full stop' "$(printf 'vm: verify sizes.\n')"
expect 1 'has 124 characters' "$(printf 'vm: %0120d\n' 7)"
expect 1 'second line must be blank' "$(printf 'vm: verify sizes\nbefore offsets\n')"
expect 1 'remove these lines' "$(printf 'vm: verify sizes\n\nSigned-off-by: N N\n')"
expect 1 "'nobody': write name the actor" "$(printf 'vm: a size that nobody has verified\n')"
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
