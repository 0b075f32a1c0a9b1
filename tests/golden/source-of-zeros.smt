# A file of zeros is no text in UTF-16, which has a zero beside each character.
args --version >/dev/null; printf '\0\0\0\0\0\0\0\0' >a.sm; "$SMC" check a.sm
args --version >/dev/null; printf '\0\0' >a.sm; "$SMC" check a.sm
args --version >/dev/null; printf '[\0A\0]\0' >a.sm; "$SMC" check a.sm
args --version >/dev/null; printf '\0[\0A\0]' >a.sm; "$SMC" check a.sm

-- stderr --
a.sm:1:1: error: this file is not plain text: it looks like nothing but NUL bytes [E0104]
    1 | \x00\x00\x00\x00\x00\x00\x00\x00
      | ^~~~
1 error
a.sm:1:1: error: this file is not plain text: it looks like nothing but NUL bytes [E0104]
    1 | \x00\x00
      | ^~~~
1 error
a.sm:1:1: error: this file is not plain text: it looks like UTF-16 [E0104]
    1 | [\x00A\x00]\x00
      | ^ save it as UTF-8
1 error
a.sm:1:1: error: this file is not plain text: it looks like UTF-16 [E0104]
    1 | \x00[\x00A\x00]
      | ^~~~ save it as UTF-8
1 error
-- exit --
1 1 1 1
