// SPDX-License-Identifier: Apache-2.0
// Checks characters. A comment must be UTF-8 text without control characters and without characters that change the direction of writing.
// A source must be text, not binary data.
#include <string.h>

#include "compiler/base/utf8.h"
#include "compiler/syntax/lexer.h"

// Returns true when first called for the current line, so that only the first wrong character of a line is reported.
bool lexer_mark_line_reported(Lexer *l)
{
    bool first = l->reported_line != l->line_start + 1;

    if (first)
        l->reported_before = l->reported_line;
    l->reported_line = l->line_start + 1;
    return first;
}

// Whether the line that begins at line - 1 contains the byte at `at`.
static bool is_in_line(const Lexer *l, uint32_t line, uint32_t at)
{
    const uint32_t from = line - 1;

    return line > 0 && from <= at && !memchr(l->src->text + from, '\n', at - from);
}

bool lexer_is_line_reported(const Lexer *l, uint32_t at)
{
    if (at >= l->line_start)
        return l->reported_line == l->line_start + 1;
    return is_in_line(l, l->reported_line, at) || is_in_line(l, l->reported_before, at);     // once a line, where the lexer is ahead
}

// ---- comments ----

// Whether a control character other than a tab or part of a line end is at `at`.
static bool is_control(const Lexer *l, uint32_t at)
{
    unsigned char c = (unsigned char)l->src->text[at];

    return (c < 0x20 && c != '\t' && !(c == '\r' && lexer_byte(l, at + 1) == '\n')) || c == 0x7f;
}

void lexer_report_control(Lexer *l, uint32_t at)
{
    unsigned char c = (unsigned char)l->src->text[at];
    Diag *d;

    if (!lexer_mark_line_reported(l))
        return;
    d = diag_report(l->diags, DIAG_control_character, lexer_span(l, at, 1), format_in(l->diags->arena, "0x%02X", c));
    if (c == '\r')
        diag_label(l->diags, d, DIAG_label_carriage_return);
}

// Reports a byte that is not UTF-8; returns 1.
uint32_t lexer_report_not_utf8(Lexer *l, uint32_t at)
{
    if (lexer_mark_line_reported(l))
        diag_label(l->diags, diag_report(l->diags, DIAG_not_utf8, lexer_span(l, at, 1),
                                         format_in(l->diags->arena, "0x%02X", (unsigned)(unsigned char)l->src->text[at])),
                   DIAG_label_save_file_utf8);
    return 1;
}

// Checks a character of a comment that is not ASCII, and returns its length. Reports a character that changes the direction of writing: it
// can make a reviewer see a different source from the one that the compiler reads.
static uint32_t check_comment_character(Lexer *l, uint32_t at)
{
    uint32_t code = 0;
    size_t len = utf8_decode(l->src->text + at, l->src->len - at, &code);
    const bool changes_direction = (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);

    if (len == 0)
        return lexer_report_not_utf8(l, at);
    if (changes_direction && lexer_mark_line_reported(l))
        diag_report(l->diags, DIAG_hidden_direction, lexer_span(l, at, (uint32_t)len),
                    format_in(l->diags->arena, "U+%04X", (unsigned)code));
    return (uint32_t)len;
}

// Reports characters that a comment must not contain.
void lexer_check_comment(Lexer *l, uint32_t at, uint32_t end)
{
    for (; at < end; at++)
        if ((unsigned char)l->src->text[at] >= 0x80)
            at += check_comment_character(l, at) - 1;
        else if (is_control(l, at))
            lexer_report_control(l, at);
}

// ---- the whole source ----

// Returns the format of a source that is not text, such as "UTF-16" or "binary data"; NULL for text.
static const char *find_binary_format(const Source *s)
{
    uint32_t n = s->len < 512 ? s->len : 512, controls = 0, zeros = 0;

    if (s->len >= 2 && (memcmp(s->text, "\xff\xfe", 2) == 0 || memcmp(s->text, "\xfe\xff", 2) == 0))
        return "UTF-16";
    while (zeros < n && s->text[zeros] == 0)
        zeros++;
    if (zeros > 1)
        return zeros == n ? "nothing but NUL bytes" : "binary data";
    if (n >= 4 && ((s->text[0] == 0 && s->text[2] == 0) || (s->text[1] == 0 && s->text[3] == 0)))  // every second of the first four bytes is zero
        return "UTF-16";
    for (uint32_t i = 0; i < n; i++)
        controls += (unsigned char)s->text[i] < 0x20 && !strchr("\t\n\r\f", s->text[i] ? s->text[i] : '?');
    return controls > 4 && controls > n / 10 ? "binary data" : NULL;
}

// Returns false after reporting that the source is not text.
bool lexer_check_is_text(Lexer *l)
{
    const char *format = find_binary_format(l->src);
    Diag *d;

    if (!format)
        return true;
    d = diag_report(l->diags, DIAG_not_text, lexer_span(l, 0, 0), format);
    if (strcmp(format, "UTF-16") == 0)
        diag_label(l->diags, d, DIAG_label_save_utf8);
    return false;
}
