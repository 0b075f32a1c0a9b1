// SPDX-License-Identifier: Apache-2.0
#include "compiler/base/json.h"

#include <string.h>

#include "compiler/base/utf8.h"

// Appends the first character of the n bytes at s to a JSON string, escaped if necessary.  Returns how many bytes of s it used.  A byte
// that is not UTF-8 becomes U+FFFD.
static size_t put_json_character(Buf *out, const char *s, size_t n)
{
    uint32_t code = 0;
    size_t len = utf8_decode(s, n, &code);

    if (len == 0)
        buf_str(out, "\\ufffd");
    else if (*s == '"' || *s == '\\')
        buf_printf(out, "\\%c", *s);
    else if (code < 0x20 || code == 0x7f)
        buf_printf(out, "\\u%04x", (unsigned)code);
    else
        buf_put(out, s, len);
    return len ? len : 1;
}

void json_put_string(Buf *out, const char *s)
{
    size_t n;

    if (!s) {
        buf_str(out, "null");
        return;
    }
    buf_char(out, '"');
    for (n = strlen(s); n; ) {
        size_t len = put_json_character(out, s, n);
        s += len;
        n -= len;
    }
    buf_char(out, '"');
}
