// SPDX-License-Identifier: Apache-2.0
#include "compiler/report/xml.h"

#include <string.h>

#include "compiler/base/utf8.h"

// XML 1.0, 2.2: characters.
static bool is_known(uint32_t code)
{
    return code >= 0x20 ? code != 0xFFFE && code != 0xFFFF : code == '\t' || code == '\n';
}

static void write_character(Buf *out, const char *s, size_t bytes, uint32_t code)
{
    switch (code) {
    case '&': buf_str(out, "&amp;"); break;
    case '<': buf_str(out, "&lt;"); break;
    case '>': buf_str(out, "&gt;"); break;
    case '"': buf_str(out, "&quot;"); break;
    case '\'': buf_str(out, "&#39;"); break;
    default: buf_put(out, s, bytes);
    }
}

void xml_put(Buf *out, const char *text)
{
    const size_t n = strlen(text);
    size_t bytes;

    for (size_t i = 0; i < n; i += bytes) {
        uint32_t code;
        bytes = utf8_decode(text + i, n - i, &code);
        if (bytes > 0 && is_known(code))
            write_character(out, text + i, bytes, code);
        else
            buf_str(out, "\xef\xbf\xbd");
        bytes += bytes == 0;
    }
}
