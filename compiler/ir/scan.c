// SPDX-License-Identifier: Apache-2.0
// Scans the words and numbers of IR text for ir_read.c.
#include "compiler/ir/scan.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

// Sets the error unless an earlier error is set; always returns false.
bool scan_fail(IrScan *s, const char *format, ...)
{
    va_list args;
    Buf b;
    char text[160];

    if (s->error)
        return false;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    buf_init(&b, s->arena);
    buf_printf(&b, "line %lu: %s", (unsigned long)s->line, text);
    s->error = buf_text(&b);
    return false;
}

// ---- characters and words ----

static void skip_space_and_comment(IrScan *s)
{
    while (s->at < s->end && (*s->at == ' ' || *s->at == '\t' || *s->at == '\r'))
        s->at++;
    if (s->at < s->end && *s->at == '#')
        while (s->at < s->end && *s->at != '\n')
            s->at++;
}

// Whether only whitespace and a comment are left on the line.
bool scan_at_line_end(IrScan *s)
{
    skip_space_and_comment(s);
    return s->at == s->end || *s->at == '\n';
}

// Skips to the next nonempty line; false at the end of the input.
bool scan_next_line(IrScan *s)
{
    while (scan_at_line_end(s) && s->at < s->end) {
        s->at++;
        s->line++;
    }
    return s->at < s->end;
}

static bool is_word_char(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '%' || c == '-' || c == '.';
}

// Reads the next word; NULL if none: the error says `expected`.
Str scan_word(IrScan *s, const char *expected)
{
    const char *start;

    skip_space_and_comment(s);
    start = s->at;
    while (s->at < s->end && is_word_char(*s->at))
        s->at++;
    if (s->at == start) {
        scan_fail(s, "expected %s", expected);
        return NULL;
    }
    return str_intern(s->strings, start, (size_t)(s->at - start));
}

bool scan_word_is(Str w, const char *text)
{
    return w && strcmp(w->text, text) == 0;
}

// Consumes c if it is next, and returns whether it was; no error.
bool scan_match_char(IrScan *s, char c)
{
    skip_space_and_comment(s);
    if (s->at == s->end || *s->at != c)
        return false;
    s->at++;
    return true;
}

// Consumes c; an error if c is not next.
bool scan_expect_char(IrScan *s, char c)
{
    return scan_match_char(s, c) || scan_fail(s, "expected '%c'", c);
}

// Consumes the word if it is next, and returns whether it was; no error.
bool scan_match_word(IrScan *s, const char *text)
{
    size_t n = strlen(text);

    skip_space_and_comment(s);
    if ((size_t)(s->end - s->at) < n || memcmp(s->at, text, n) != 0 || (s->at + n < s->end && is_word_char(s->at[n])))
        return false;
    s->at += n;
    return true;
}

bool scan_expect_word(IrScan *s, const char *text)
{
    return scan_match_word(s, text) || scan_fail(s, "expected '%s'", text);
}

// Returns the value of a hexadecimal digit, in lower case; -1 for other characters.
static int hex_digit(char c)
{
    if (c >= '0' && c <= '9')
        return c - '0';
    if (c >= 'a' && c <= 'f')
        return c - 'a' + 10;
    return -1;
}

// Reads a text in quotes.  Returns false after an error.
bool scan_quoted(IrScan *s, Str *out)
{
    Buf b;

    buf_init(&b, s->arena);
    if (!scan_expect_char(s, '"'))
        return false;
    while (s->at < s->end && *s->at != '"' && *s->at != '\n') {
        char c = *s->at++;
        if (c == '\\') {
            if (s->end - s->at < 2 || hex_digit(s->at[0]) < 0 || hex_digit(s->at[1]) < 0)
                return scan_fail(s, "expected two hexadecimal digits after the backslash");
            c = (char)(unsigned char)(hex_digit(s->at[0]) * 16 + hex_digit(s->at[1]));
            s->at += 2;
        }
        buf_char(&b, c);
    }
    *out = str_intern(s->strings, buf_text(&b), b.n);
    return scan_expect_char(s, '"');
}

// ---- numbers ----

// Parses a number, decimal, or after 0x hexadecimal.  Returns false, without an error, if the text is no number.
bool scan_try_parse_number(const char *text, uint64_t *out)
{
    uint64_t base = 10, v = 0;

    if (text[0] == '0' && text[1] == 'x') {
        base = 16;
        text += 2;
    }
    if (!*text)
        return false;
    for (; *text; text++) {
        int digit = hex_digit(*text);
        if (digit < 0 || (uint64_t)digit >= base || v > (UINT64_MAX - (uint64_t)digit) / base)
            return false;
        v = v * base + (uint64_t)digit;
    }
    *out = v;
    return true;
}

// Reads a number; `what` names it in the error.
bool scan_number(IrScan *s, const char *what, uint32_t *out)
{
    Str w = scan_word(s, what);
    uint64_t v;

    if (!w)
        return false;
    if (!scan_try_parse_number(w->text, &v) || v > UINT32_MAX)
        return scan_fail(s, "expected %s, found '%.40s'", what, w->text);
    *out = (uint32_t)v;
    return true;
}

// Reads a letter and a number: b7, w7.
bool scan_lettered_number(IrScan *s, char letter, const char *what, uint32_t *out)
{
    Str w = scan_word(s, what);
    uint64_t v;

    if (!w)
        return false;
    if (w->text[0] != letter || !scan_try_parse_number(w->text + 1, &v) || v > UINT32_MAX)
        return scan_fail(s, "expected %s, found '%.40s'", what, w->text);
    *out = (uint32_t)v;
    return true;
}

bool scan_type(IrScan *s, SmType *out)
{
    Str w = scan_word(s, "a type");

    for (int t = 0; w && t < SM_TYPE_COUNT; t++)
        if (scan_word_is(w, sm_type_info[t].spelling)) {
            *out = (SmType)t;
            return true;
        }
    return w && scan_fail(s, "expected a type, found '%.40s'", w->text);
}

// Sets *cell to the bits of a whole number in this type.  Returns false if the type cannot represent it exactly.
static bool convert_whole_number(SmType type, bool negative, uint64_t magnitude, uint64_t *cell)
{
    unsigned bits = 8u * sm_type_info[type].bytes;
    double d = negative ? -(double)magnitude : (double)magnitude;
    float f = (float)d;
    uint32_t low;

    switch (sm_type_info[type].kind) {
    case SM_KIND_BOOL: *cell = magnitude; return !negative && magnitude <= 1;
    case SM_KIND_UNSIGNED: *cell = magnitude; return !negative && (bits == 64 || magnitude >> bits == 0);
    case SM_KIND_SIGNED:
        *cell = (negative ? ~magnitude + 1 : magnitude) & UINT64_MAX >> (64 - bits);
        return magnitude <= (UINT64_C(1) << (bits - 1)) - !negative;
    case SM_KIND_FLOAT:
        if (type == SM_F32) {
            memcpy(&low, &f, sizeof low);
            *cell = low;
            return magnitude <= UINT64_C(1) << 53 && (double)f == d;
        }
        memcpy(cell, &d, sizeof *cell);
        return magnitude <= UINT64_C(1) << 53;
    }
    return false;
}

// Reads a whole number that fits the type, or a cell in hexadecimal.
bool scan_value(IrScan *s, SmType type, uint64_t *cell)
{
    Str w = scan_word(s, "a value");
    uint64_t v;
    bool negative, hex;

    if (!w)
        return false;
    negative = w->text[0] == '-';
    hex = w->text[0] == '0' && w->text[1] == 'x';
    if (!scan_try_parse_number(w->text + negative, &v))
        return scan_fail(s, "expected a value, found '%.40s'", w->text);
    if (hex)
        *cell = v;
    else if (!convert_whole_number(type, negative, v, cell))
        return scan_fail(s, "%.40s is no value of type %s", w->text, sm_type_info[type].spelling);
    return true;
}
