// SPDX-License-Identifier: Apache-2.0
#include "compiler/report/xml.h"

#include <string.h>

#include "compiler/base/utf8.h"

// Writes one character.  `len`: its number of bytes; 0 if they are not valid UTF-8.
static void write_character(Buf *out, const char *text, size_t len, uint32_t code)
{
    if (len == 0 || code == 0xFFFE || code == 0xFFFF)         // XML 1.0, 2.2; the other forbidden characters are hidden
        buf_str(out, "\xef\xbf\xbd");
    else if (code != '\n' && code != '\t' && utf8_is_hidden(code))
        buf_printf(out, "&lt;U+%04lX&gt;", (unsigned long)code);
    else if (code == '&')
        buf_str(out, "&amp;");
    else if (code == '<')
        buf_str(out, "&lt;");
    else if (code == '>')
        buf_str(out, "&gt;");
    else if (code == '"')
        buf_str(out, "&quot;");
    else if (code == '\'')
        buf_str(out, "&#39;");
    else
        buf_put(out, text, len);
}

// Writes the text with special characters escaped, also for attribute values.
void xml_write(Buf *out, const char *text, size_t n)
{
    while (n > 0) {
        uint32_t code = 0;
        const size_t len = utf8_decode(text, n, &code), used = len ? len : 1;
        write_character(out, text, len, code);
        text += used;
        n -= used;
    }
}

void xml_write_str(Buf *out, const char *text) { xml_write(out, text, strlen(text)); }
