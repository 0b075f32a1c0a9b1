#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# tests/library/api in a locale whose decimal separator is a comma.       locale.sh API
api=$1
. tests/checks.sh
dir=$(mktemp -d) || exit 1
trap 'rm -rf "$dir"' EXIT

if has localedef && [ -e /usr/share/i18n/locales/de_DE ]; then
    localedef -i de_DE -f UTF-8 "$dir/de_DE.UTF-8" 2>/dev/null
    check "numbers have points" env LOCPATH="$dir" COMMA_LOCALE=de_DE.UTF-8 "$api"
else
    skip "a locale with commas (apt-get install locales)"
fi
finish library-locale
