// SPDX-License-Identifier: Apache-2.0
// The scanner.  It goes over each byte once (a sign is compared with the rows of tokens.def), and every name is interned
// where it is met.
#include "compiler/syntax/lex.h"

#include <string.h>

#include "compiler/base/utf8.h"
#include "compiler/syntax/number.h"

// ---- tables ----

typedef struct Word { const char *spelling; TokenKind kind; SmType type; } Word;

static const Word words[] = {
#define TOKEN(kind, name)
#define WORD(kind, spelling) {spelling, TOK_##kind, SM_TYPE_COUNT},
#define SIGN(kind, spelling)
#define FOREIGN(spelling, kind, native)
#define ABSENT(spelling, kind, label)
#include "compiler/syntax/tokens.def"
#undef WORD
#undef SIGN
#undef FOREIGN
#undef ABSENT
#define SM_TYPE(name, wire, spelling, ctype, bytes, kind) {spelling, TOK_TYPE, SM_##name},
#include "stdlib/types.def"
#undef SM_TYPE
};

typedef struct Sign {
    const char *spelling;
    size_t len;
    TokenKind kind;
    const char *native;       // FOREIGN: how it is written here
    const char *label;        // ABSENT: what to do
} Sign;

static const Sign signs[] = {
#define WORD(kind, spelling)
#define SIGN(kind, spelling) {spelling, sizeof spelling - 1, TOK_##kind, NULL, NULL},
#define FOREIGN(spelling, kind, native) {spelling, sizeof spelling - 1, TOK_##kind, native, NULL},
#define ABSENT(spelling, kind, label) {spelling, sizeof spelling - 1, TOK_##kind, NULL, label},
#include "compiler/syntax/tokens.def"
#undef TOKEN
#undef WORD
#undef SIGN
#undef FOREIGN
#undef ABSENT
};

// Characters that word processors and mathematics put where ASCII has a sign.
static const struct { uint32_t code; const char *ascii; TokenKind kind; } lookalikes[] = {
    {0xa0, " ", TOK_END}, {0x2007, " ", TOK_END}, {0x2009, " ", TOK_END}, {0x202f, " ", TOK_END},
    {0x2010, "-", TOK_MINUS}, {0x2011, "-", TOK_MINUS}, {0x2012, "-", TOK_MINUS}, {0x2013, "-", TOK_MINUS},
    {0x2014, "-", TOK_MINUS}, {0x2212, "-", TOK_MINUS}, {0xd7, "*", TOK_STAR}, {0xb7, "*", TOK_STAR},
    {0x22c5, "*", TOK_STAR}, {0x2217, "*", TOK_STAR}, {0xf7, "/", TOK_SLASH}, {0x2044, "/", TOK_SLASH},
    {0x2215, "/", TOK_SLASH}, {0x2264, "<=", TOK_LE}, {0x2a7d, "<=", TOK_LE}, {0x2265, ">=", TOK_GE},
    {0x2a7e, ">=", TOK_GE}, {0x2260, "!=", TOK_NE}, {0x2192, "->", TOK_ARROW}, {0x21d2, "->", TOK_ARROW},
    {0xac, "!", TOK_BANG}, {0x2227, " and ", TOK_AND}, {0x2228, " or ", TOK_OR}, {0xff1a, ":", TOK_COLON},
    {0x2236, ":", TOK_COLON}, {0xff1d, "=", TOK_ASSIGN}, {0xff08, "(", TOK_LPAREN}, {0xff09, ")", TOK_RPAREN}};

enum { NO_LOOKALIKE = sizeof lookalikes / sizeof *lookalikes };

const char *token_name(TokenKind kind)
{
    static const char *const name[] = {
#define TOKEN(kind, name) name,
#define WORD(kind, spelling) spelling,
#define SIGN(kind, spelling) spelling,
#define FOREIGN(spelling, kind, native)
#define ABSENT(spelling, kind, label)
#include "compiler/syntax/tokens.def"
#undef TOKEN
#undef WORD
#undef SIGN
#undef FOREIGN
#undef ABSENT
    };
    return name[kind];
}

// ---- characters ----

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
static bool is_word(char c) { return is_letter(c) || is_digit(c); }
static bool is_hex(char c) { return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); }

bool is_identifier(const char *s, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (!is_word(s[i]))
            return false;
    return n > 0 && !is_digit(s[0]);
}

// The byte at p; '\0' behind the end, where no rule goes on.
static char byte_at(const Lexer *l, uint32_t p) { return p < l->src->len ? l->src->text[p] : '\0'; }
static Span span_at(const Lexer *l, uint32_t at, uint32_t len) { return (Span){l->src, at, len}; }

static uint32_t skip_word(const Lexer *l, uint32_t p)
{
    while (is_word(byte_at(l, p)))
        p++;
    return p;
}

static const char *text_of(const Lexer *l, uint32_t at, uint32_t end)
{
    const uint32_t most = 40;

    return format_in(l->diags->arena, "%.*s%s", (int)(end - at < most ? end - at : most), l->src->text + at,
                     end - at > most ? "..." : "");
}

// ---- characters that have no place ----

// One report a line will do: what follows on it is mostly of the same kind.
static bool first_on_line(Lexer *l)
{
    bool first = l->reported_line != l->line_start + 1;

    l->reported_line = l->line_start + 1;
    return first;
}

static void report_control(Lexer *l, uint32_t at)
{
    unsigned char c = (unsigned char)l->src->text[at];
    Diag *d;

    if (!first_on_line(l))
        return;
    d = diag_report(l->diags, DIAG_control_character, span_at(l, at, 1), format_in(l->diags->arena, "0x%02X", c));
    if (c == '\r')
        diag_label(l->diags, d, DIAG_label_carriage_return);
}

static size_t lookalike_of(uint32_t code)
{
    size_t i = 0;

    while (i < NO_LOOKALIKE && lookalikes[i].code != code)
        i++;
    return i;
}

static bool is_quote(uint32_t code)
{
    return code == '"' || code == '\'' || (code >= 0x2018 && code <= 0x201f) || code == 0xab || code == 0xbb;
}

static void report_non_ascii(Lexer *l, uint32_t at, uint32_t len, uint32_t code)
{
    const char *shown = utf8_is_hidden(code) || code == 0xa0 ? format_in(l->diags->arena, "U+%04X", (unsigned)code)
                                                              : text_of(l, at, at + len);
    size_t like = lookalike_of(code);
    const char *ascii = like < NO_LOOKALIKE ? lookalikes[like].ascii : NULL;
    Diag *d;

    if (!ascii && !first_on_line(l))
        return;
    d = diag_report(l->diags, DIAG_not_ascii, span_at(l, at, len), shown);
    if (!ascii)
        return;
    if (*ascii == ' ' && !ascii[1])
        diag_label(l->diags, d, DIAG_label_plain_blank);
    else
        diag_label(l->diags, d, DIAG_label_write, ascii);
    diag_edit(l->diags, d, span_at(l, at, len), ascii);
}

// Reports what stands at `at` and is neither ASCII nor, in a comment, UTF-8.  Returns its length.
static uint32_t report_byte(Lexer *l, uint32_t at)
{
    uint32_t code = 0;
    size_t len = utf8_decode(l->src->text + at, l->src->len - at, &code);

    if (len > 0) {
        report_non_ascii(l, at, (uint32_t)len, code);
        return (uint32_t)len;
    }
    if (first_on_line(l))
        diag_report(l->diags, DIAG_not_utf8, span_at(l, at, 1),
                    format_in(l->diags->arena, "0x%02X", (unsigned)(unsigned char)l->src->text[at]));
    return 1;
}

// ---- blanks and comments ----

static void end_line(Lexer *l)
{
    l->parens = 0;
    l->first = true;
    l->line_start = ++l->at;
}

// To the end of the line.
static void skip_comment(Lexer *l)
{
    while (l->at < l->src->len && l->src->text[l->at] != '\n') {
        unsigned char c = (unsigned char)l->src->text[l->at];
        uint32_t code;
        if (c >= 0x80) {
            size_t len = utf8_decode(l->src->text + l->at, l->src->len - l->at, &code);
            l->at += len ? (uint32_t)len : report_byte(l, l->at);
            continue;
        }
        if ((c < 0x20 && c != '\t' && !(c == '\r' && byte_at(l, l->at + 1) == '\n')) || c == 0x7f)
            report_control(l, l->at);
        l->at++;
    }
}

// Blanks, line ends and, unless they are wanted, comments.
static void skip_blanks(Lexer *l)
{
    for (; l->at < l->src->len; ) {
        char c = l->src->text[l->at];
        if (c == ' ' || c == '\t' || (c == '\r' && byte_at(l, l->at + 1) == '\n'))
            l->at++;
        else if (c == '\n')
            end_line(l);
        else if (c == '#' && !l->keep_comments)
            skip_comment(l);
        else
            return;
    }
}

// `// …` and `/* … */` of other languages.
static void foreign_comment(Lexer *l)
{
    uint32_t at = l->at, p = at + 2;
    Diag *d = diag_report(l->diags, DIAG_foreign_comment, span_at(l, at, 2), text_of(l, at, p));

    diag_label(l->diags, d, DIAG_label_comment);
    if (l->src->text[at + 1] == '*' && !l->no_comment_end) {
        while (p + 1 < l->src->len && !(l->src->text[p] == '*' && l->src->text[p + 1] == '/'))
            p++;
        l->no_comment_end = p + 1 >= l->src->len;
        for (; !l->no_comment_end && l->at < p + 2; )
            if (l->src->text[l->at] == '\n')
                end_line(l);
            else
                l->at++;
    }
    if (l->at == at) {
        diag_edit(l->diags, d, span_at(l, at, 2), "#");
        skip_comment(l);
    }
}

// ---- tokens ----

static void finish(Lexer *l, Token *t, TokenKind kind, uint32_t end)
{
    t->kind = kind;
    t->len = end - t->at;
    l->at = end;
}

// The letter of another alphabet at p, if there is one: its length.
static size_t other_letter(const Lexer *l, uint32_t p)
{
    uint32_t code = 0;
    size_t len = utf8_decode(l->src->text + p, l->src->len - p, &code);

    return len > 1 && lookalike_of(code) == NO_LOOKALIKE && !is_quote(code) && !utf8_is_hidden(code) ? len : 0;
}

static void lex_word(Lexer *l, Token *t)
{
    uint32_t end = skip_word(l, l->at);
    const Word *w;

    while (other_letter(l, end))                                // one word, reported once
        end = skip_word(l, end + report_byte(l, end));
    t->text = str_intern(l->strings, l->src->text + l->at, end - l->at);
    w = map_find(&l->words, t->text);
    if (w)
        t->type = w->type;
    finish(l, t, w ? w->kind : TOK_NAME, end);
}

// Digits with single underscores between them.
static uint32_t skip_digits(const Lexer *l, uint32_t p, bool (*belongs)(char c))
{
    while (belongs(byte_at(l, p)))
        p += byte_at(l, p + 1) == '_' && belongs(byte_at(l, p + 2)) ? 2 : 1;
    return p;
}

static uint32_t skip_decimal(const Lexer *l, uint32_t p)
{
    uint32_t e;

    p = skip_digits(l, p, is_digit);
    if (byte_at(l, p) == '.')
        p = skip_digits(l, p + 1, is_digit);
    if ((byte_at(l, p) | 0x20) != 'e')
        return p;
    e = p + 1;
    e += byte_at(l, e) == '+' || byte_at(l, e) == '-';
    return is_digit(byte_at(l, e)) ? skip_digits(l, e, is_digit) : p;
}

static bool is_hex_prefix(const Lexer *l, uint32_t p)
{
    return byte_at(l, p) == '0' && (byte_at(l, p + 1) | 0x20) == 'x';
}

static uint32_t skip_number(const Lexer *l, uint32_t p)
{
    if (is_hex_prefix(l, p) && is_hex(byte_at(l, p + 2)))
        return skip_digits(l, p + 2, is_hex);
    return skip_decimal(l, p);
}

// The number at..end runs on: 5psi, 1__0, 0x, 1e, 1.2.3.  Reports it; returns where it stops.
static uint32_t report_run_on(Lexer *l, uint32_t at, uint32_t end)
{
    uint32_t stop = skip_word(l, end);
    char c = byte_at(l, end), before = byte_at(l, end - 1);
    const char *whole;

    while (byte_at(l, stop) == '.' && is_word(byte_at(l, stop + 1)))
        stop = skip_word(l, stop + 1);
    whole = text_of(l, at, stop);
    if (c == '_' || (before == '_' && is_digit(c)))
        diag_report(l->diags, DIAG_number_underscore, span_at(l, end, 1), whole);
    else if (c == '.')
        diag_report(l->diags, DIAG_number_point, span_at(l, at, stop - at), whole);
    else if (is_hex_prefix(l, at) && end == at + 1)
        diag_report(l->diags, DIAG_number_incomplete, span_at(l, at, stop - at), whole, "a hexadecimal digit", "0x");
    else if ((c | 0x20) == 'e' && end + 1 == stop)
        diag_report(l->diags, DIAG_number_incomplete, span_at(l, at, stop - at), whole, "a digit",
                    text_of(l, end, end + 1));
    else
        diag_report(l->diags, DIAG_number_run_on, span_at(l, at, stop - at), text_of(l, at, end),
                    text_of(l, end, stop));
    return stop;
}

static void lex_number(Lexer *l, Token *t)
{
    uint32_t end = skip_number(l, l->at);
    bool runs_on = is_word(byte_at(l, end)) || (byte_at(l, end) == '.' && is_digit(byte_at(l, end + 1)));

    if (!number_value(l->src->text + l->at, end - l->at, &t->number) && !runs_on)
        diag_report(l->diags, DIAG_number_too_large, span_at(l, l->at, end - l->at), text_of(l, l->at, end));
    finish(l, t, TOK_NUMBER, runs_on ? report_run_on(l, l->at, end) : end);
}

bool lex_is_header_name(const char *s, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (!is_word(s[i]) && s[i] != '/')
            return false;
    return n > 0;
}

// [name.  Nothing closes it on this line, so it ends with what could be the name.
static void lex_open_header(Lexer *l, Token *t)
{
    uint32_t from = l->at + 1, end;
    Diag *d;

    while (byte_at(l, from) == ' ' || byte_at(l, from) == '\t')
        from++;
    for (end = from; is_word(byte_at(l, end)) || byte_at(l, end) == '/'; end++)
        ;
    t->text = str_intern(l->strings, l->src->text + from, end - from);
    d = diag_report(l->diags, DIAG_header_unclosed, span_at(l, l->at, end - l->at));
    if (end > from)
        diag_label(l->diags, d, DIAG_label_write, format_in(l->diags->arena, "[%s]", t->text->text));
    finish(l, t, TOK_HEADER, end > from ? end : l->at + 1);
}

static void report_header(Lexer *l, uint32_t from, uint32_t end, Str name)
{
    Span whole = span_at(l, l->at, end + 1 - l->at);
    Diag *d = diag_report(l->diags, DIAG_header_name, span_at(l, from, end - from), text_of(l, l->at, end + 1));

    if (lex_is_header_name(name->text, name->len)) {
        const char *fixed = format_in(l->diags->arena, "[%s]", name->text);
        diag_label(l->diags, d, DIAG_label_write, fixed);
        diag_edit(l->diags, d, whole, fixed);
    }
}

static void lex_header(Lexer *l, Token *t)
{
    uint32_t from = l->at + 1, end = from, to;
    const char *s = l->src->text;

    while (end < l->src->len && s[end] != ']' && s[end] != '\n' && s[end] != '#' && s[end] != '[')
        end++;
    if (byte_at(l, end) != ']') {
        lex_open_header(l, t);
        return;
    }
    for (to = end; to > from && (s[to - 1] == ' ' || s[to - 1] == '\t'); to--)
        ;
    while (from < to && (s[from] == ' ' || s[from] == '\t'))
        from++;
    t->text = str_intern(l->strings, s + from, to - from);
    if (!lex_is_header_name(s + l->at + 1, end - l->at - 1))
        report_header(l, l->at + 1, end, t->text);
    finish(l, t, TOK_HEADER, end + 1);
}

// .name and @name
static void lex_prefixed(Lexer *l, Token *t, TokenKind kind)
{
    uint32_t end = skip_word(l, l->at + 1);

    if (end == l->at + 1)
        diag_report(l->diags, kind == TOK_LABEL ? DIAG_lone_dot : DIAG_lone_at, span_at(l, l->at, 1));
    t->text = str_intern(l->strings, l->src->text + l->at + 1, end - l->at - 1);
    finish(l, t, end == l->at + 1 ? TOK_ERROR : kind, end);
}

// Text in quotes, to the closing one or the end of the line.
static void lex_string(Lexer *l, Token *t, uint32_t quote_len)
{
    uint32_t p = l->at + quote_len, code, len;

    while (p < l->src->len && l->src->text[p] != '\n') {
        len = (uint32_t)utf8_decode(l->src->text + p, l->src->len - p, &code);
        p += len ? len : 1;
        if (len && is_quote(code))
            break;
    }
    if (first_on_line(l))
        diag_report(l->diags, DIAG_string, span_at(l, l->at, p - l->at));
    finish(l, t, TOK_ERROR, p);
}

// ---- signs ----

static const Sign *find_sign(const Lexer *l)
{
    const char *s = l->src->text + l->at;
    uint32_t left = l->src->len - l->at;

    for (size_t i = 0; i < sizeof signs / sizeof *signs; i++)
        if (signs[i].spelling[0] == *s && signs[i].len <= left && memcmp(signs[i].spelling, s, signs[i].len) == 0)
            return &signs[i];
    return NULL;
}

static bool begins_statement(const Lexer *l, const Token *t)
{
    return t->first || l->last == TOK_COLON || l->last == TOK_LBRACE || l->last == TOK_LABEL || l->last == TOK_HEADER;
}

static void report_foreign(Lexer *l, Token *t, const Sign *s)
{
    bool arrow = strcmp(s->spelling, "=>") == 0 && begins_statement(l, t);
    const char *native = arrow ? "->" : s->native;
    Diag *d = diag_report(l->diags, DIAG_foreign_operator, span_at(l, t->at, t->len), s->spelling, native);
    bool blank = is_letter(*native);

    if (arrow)
        t->kind = TOK_ARROW;
    diag_label(l->diags, d, DIAG_label_write, native);
    diag_edit(l->diags, d, span_at(l, t->at, t->len),
              format_in(l->diags->arena, "%s%s%s", blank && t->at && is_word(l->src->text[t->at - 1]) ? " " : "", native,
                        blank && is_word(byte_at(l, t->at + t->len)) ? " " : ""));
}

static void lex_sign(Lexer *l, Token *t, const Sign *s)
{
    finish(l, t, s->kind, l->at + (uint32_t)s->len);
    l->parens += t->kind == TOK_LPAREN;
    l->parens -= t->kind == TOK_RPAREN && l->parens > 0;
    if (s->native)
        report_foreign(l, t, s);
    if (s->label) {
        Diag *d = diag_report(l->diags, DIAG_absent_operator, span_at(l, t->at, t->len), s->spelling);
        diag_label(l->diags, d, DIAG_label_text, s->label);
    }
}

// f(a; b)
static void semicolon_for_comma(Lexer *l, Token *t)
{
    Diag *d = diag_report(l->diags, DIAG_foreign_operator, span_at(l, l->at, 1), ";", ",");

    diag_label(l->diags, d, DIAG_label_write, ",");
    diag_edit(l->diags, d, span_at(l, l->at, 1), ",");
    finish(l, t, TOK_COMMA, l->at + 1);
}

// ; ends nothing here; what follows it is taken as if it stood on a line of its own.
static void skip_semicolon(Lexer *l)
{
    Span span = span_at(l, l->at, 1);
    Diag *d = diag_report(l->diags, DIAG_semicolon, span);

    l->at++;
    l->first = true;
    while (byte_at(l, l->at) == ' ' || byte_at(l, l->at) == '\t' || byte_at(l, l->at) == '\r')
        l->at++;
    if (byte_at(l, l->at) == '\n' || byte_at(l, l->at) == '#' || l->at == l->src->len) {
        diag_label(l->diags, d, DIAG_label_leave_out);
        diag_edit(l->diags, d, span, "");
    }
}

// c ? a : b of other languages; what follows belongs to it.
static void skip_choice(Lexer *l)
{
    Diag *d = diag_report(l->diags, DIAG_absent_operator, span_at(l, l->at, 1), "?");

    diag_label(l->diags, d, DIAG_label_text, "write it as if ...: x = a, and on the next line else: x = b");
    while (l->at < l->src->len && !strchr("\n#}", l->src->text[l->at] ? l->src->text[l->at] : 'x'))
        l->at++;
}

// What looks like a sign is taken for it; a blank, or a byte that is not UTF-8, is skipped.
static bool lex_lookalike(Lexer *l, Token *t, uint32_t code)
{
    size_t like = lookalike_of(code);
    uint32_t len = report_byte(l, l->at);

    if (like == NO_LOOKALIKE || lookalikes[like].kind == TOK_END) {
        l->at += len;
        return false;
    }
    finish(l, t, lookalikes[like].kind, l->at + len);
    return true;
}

// Something that begins no token.  True if it gave one all the same.
static bool lex_stray(Lexer *l, Token *t)
{
    unsigned char c = (unsigned char)l->src->text[l->at];
    uint32_t code = c;
    size_t len = utf8_decode(l->src->text + l->at, l->src->len - l->at, &code);

    if (len && is_quote(code)) {
        lex_string(l, t, (uint32_t)len);
        return true;
    }
    if (other_letter(l, l->at)) {
        lex_word(l, t);
        return true;
    }
    if (c >= 0x80)
        return lex_lookalike(l, t, code);
    if (c < 0x20 || c == 0x7f)
        report_control(l, l->at);
    else if (first_on_line(l))
        diag_report(l->diags, DIAG_stray_character, span_at(l, l->at, 1), text_of(l, l->at, l->at + 1));
    l->at++;
    return false;
}

bool lex_is_reserved(const Lexer *l, Str word, TokenKind *kind)
{
    const Word *w = map_find(&l->words, word);

    if (w)
        *kind = w->kind;
    return w != NULL;
}

// ---- the next token ----

// False if what stands here was skipped.
static bool lex_one(Lexer *l, Token *t)
{
    char c = l->src->text[l->at];
    const Sign *s;

    if (is_letter(c))
        lex_word(l, t);
    else if (is_digit(c) || (c == '.' && is_digit(byte_at(l, l->at + 1))))
        lex_number(l, t);
    else if (c == '[')
        lex_header(l, t);
    else if (c == '.')
        lex_prefixed(l, t, TOK_LABEL);
    else if (c == '@')
        lex_prefixed(l, t, TOK_ANNOTATION);
    else if (c == '/' && (byte_at(l, l->at + 1) == '/' || byte_at(l, l->at + 1) == '*'))
        return foreign_comment(l), false;
    else if (c == ';' && l->parens > 0)
        semicolon_for_comma(l, t);
    else if (c == ';')
        return skip_semicolon(l), false;
    else if (c == '?')
        return skip_choice(l), false;
    else if ((s = find_sign(l)) != NULL)
        lex_sign(l, t, s);
    else
        return lex_stray(l, t);
    return true;
}

static void lex_comment(Lexer *l, Token *t)
{
    skip_comment(l);
    finish(l, t, TOK_COMMENT, l->at);
}

void lex_next(Lexer *l, Token *t)
{
    do {
        skip_blanks(l);
        memset(t, 0, sizeof *t);
        t->at = l->at;
        t->first = l->first;
        t->kind = TOK_END;
        if (l->at == l->src->len)
            break;
        if (l->src->text[l->at] == '#') {
            lex_comment(l, t);
            return;
        }
    } while (!lex_one(l, t));
    if (t->kind == TOK_END)
        t->first = true;
    l->first = false;
    l->last = t->kind;
}

// What is no text is not read: one message, not one for every byte of it.
static const char *other_than_text(const Source *s)
{
    uint32_t n = s->len < 512 ? s->len : 512, controls = 0;

    if (s->len >= 2 && (memcmp(s->text, "\xff\xfe", 2) == 0 || memcmp(s->text, "\xfe\xff", 2) == 0))
        return "UTF-16";
    for (uint32_t i = 0; i < n; i++)
        controls += (unsigned char)s->text[i] < 0x20 && !strchr("\t\n\r\f", s->text[i] ? s->text[i] : '?');
    return controls > 4 && controls > n / 10 ? "binary data" : NULL;
}

void lex_skip_to(Lexer *l, uint32_t at)
{
    l->at = l->line_start = at;
    l->first = true;
}

void lex_init(Lexer *l, Arena *arena, StrPool *strings, Diags *diags, const Source *src)
{
    const char *other;

    memset(l, 0, sizeof *l);
    l->src = src;
    l->strings = strings;
    l->diags = diags;
    l->first = true;
    l->words.arena = arena;
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        map_put(&l->words, str_c(strings, words[i].spelling), (void *)(size_t)&words[i]);
    if (src->len >= 3 && memcmp(src->text, "\xef\xbb\xbf", 3) == 0)
        l->at = l->line_start = 3;
    other = other_than_text(src);
    if (other) {
        diag_report(diags, DIAG_not_text, span_at(l, 0, 0), other);
        l->at = src->len;
    }
}
