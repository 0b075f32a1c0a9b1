#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Checks the messages of commits against CONTRIBUTING.md.
#     commits.sh RANGE      of these commits, as main..HEAD
#     commits.sh -f FILE    of the message in FILE; as a hook:  echo 'sh tests/check/commits.sh -f "$1"' >.git/hooks/commit-msg
#
#   1. The title is `part: what is different`, in at most 120 characters, without a full stop.
#   2. A blank line separates it from the text.
#   3. There are no trailers such as Signed-off-by.
#   4. The words of words.txt do not occur.
here=$(dirname "$0")
passed=0 failed=0
dir=$(mktemp -d "${TMPDIR:-/tmp}/smc-commits.XXXXXX") || exit 1
trap 'rm -rf "$dir"' EXIT
grep '^word ' "$here/words.txt" >"$dir/words.txt"

complain() { echo "$name: $*"; bad=1; }

check_message() {       # NAME, with the message in $dir/message
    name=$1 bad=
    title=$(sed -n 1p "$dir/message")
    printf '%s\n' "$title" | grep -Eq '^[a-zA-Z][a-zA-Z0-9_./,+ -]*: [^ ]' || complain "the title must begin with the part, as in 'vm: verify sizes before offsets': $title"
    [ ${#title} -le 120 ] || complain "the title has ${#title} characters, at most 120 are allowed"
    case $title in *.) complain "the title ends with a full stop" ;; esac
    [ -z "$(sed -n 2p "$dir/message")" ] || complain "the second line must be blank"
    grep -Ein '^(co-authored|signed-off|reviewed|acked|change)-[a-z-]*:|^generated (with|by)' "$dir/message" && complain "remove these lines"
    echo "$dir/message" | awk -v least=1 -f "$here/words.awk" "$dir/words.txt" - >"$dir/words" || { grep -v ' passed, ' "$dir/words" | sed "s|^$dir/message:|$name: line |"; bad=1; }
    if [ "$bad" ]; then failed=$((failed + 1)); else passed=$((passed + 1)); fi
}

case $1 in
-f) grep -v '^#' "$2" >"$dir/message"
    check_message "commit message" ;;
*)  for commit in $(git rev-list --no-merges "$1" --); do
        git log -1 --format=%B "$commit" >"$dir/message"
        check_message "$(git rev-parse --short "$commit")"
    done ;;
esac
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
