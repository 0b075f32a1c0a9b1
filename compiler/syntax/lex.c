// SPDX-License-Identifier: Apache-2.0
// The scanner. It reads almost every byte once (punctuators are compared with several rows of tokens.def), and interns every name.
#include <string.h>

#include "compiler/syntax/hints.h"
#include "compiler/syntax/lexer.h"
#include "compiler/syntax/number.h"

// ---- tables ----

typedef struct Word { const char *spelling; TokenKind kind; SmType type; } Word;

static const Word words[] = {
#define WORD(kind, spelling) {spelling, TOK_##kind, SM_TYPE_COUNT},
#include "compiler/syntax/tokens.def"
#define SM_TYPE(name, wire, spelling, ctype, bytes, kind) {spelling, TOK_TYPE, SM_##name},
#include "stdlib/types.def"
#undef SM_TYPE
};

static const Word *find_reserved(Str s) { return s->mark ? &words[s->mark - 1] : NULL; }      // lex_init sets mark to 1 + the row of `words`

typedef struct Punctuator {
    const char *spelling;
    size_t len;
    TokenKind kind;
} Punctuator;

static const Punctuator punctuators[] = {
#define PUNCTUATOR(kind, spelling) {spelling, sizeof spelling - 1, TOK_##kind},
#include "compiler/syntax/tokens.def"
};

// Returns how a diagnostic names tokens of this kind: "+", "if", "name".
const char *lex_token_name(TokenKind kind)
{
    static const char *const name[] = {
#define TOKEN(kind, name) name,
#define WORD(kind, spelling) spelling,
#define PUNCTUATOR(kind, spelling) spelling,
#include "compiler/syntax/tokens.def"
    };
    return name[kind];
}

// ---- characters ----

bool lex_is_digit(char c) { return c >= '0' && c <= '9'; }
bool lex_is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
static bool is_hex(char c) { return lex_is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); }

bool lex_is_identifier(const char *s, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (!lexer_is_word(s[i]))
            return false;
    return n > 0 && !lex_is_digit(s[0]);
}

// Returns the end of the letters, digits and _ at p.
uint32_t lexer_skip_word(const Lexer *l, uint32_t p)
{
    const char *text = l->src->text;                               // terminated by a NUL

    while (lexer_is_word(text[p]))
        p++;
    return p;
}

// Returns a part of the source, cut to a readable length.
const char *lexer_text(const Lexer *l, uint32_t at, uint32_t end)
{
    const uint32_t most = 40;

    return format_in(l->diags->arena, "%.*s%s", (int)(end - at < most ? end - at : most), l->src->text + at,
                     end - at > most ? "..." : "");
}

// ---- spaces and comments ----

// Consumes the line end.
void lexer_end_line(Lexer *l)
{
    l->parens = 0;
    l->first = true;
    l->line_start = ++l->at;
}

void lexer_skip_comment(Lexer *l)
{
    const char *s = l->src->text + l->at, *end = memchr(s, '\n', l->src->len - l->at);
    uint32_t len = end ? (uint32_t)(end - s) : l->src->len - l->at;

    lexer_check_comment(l, l->at, l->at + len);
    l->at += len;
}

// Skips spaces, line ends and, unless keep_comments is set, comments.
static void skip_spaces(Lexer *l)
{
    const char *text = l->src->text;                               // terminated by a NUL
    uint32_t at = l->at;
    char c;

    for (;; at = l->at) {
        while ((c = text[at]) == ' ')
            at++;
        l->at = at;
        if (c == '\t' || (c == '\r' && lexer_byte(l, l->at + 1) == '\n'))
            l->at++;
        else if (c == '\n')
            lexer_end_line(l);
        else if (c == '#' && !l->keep_comments)
            lexer_skip_comment(l);
        else
            return;
    }
}

// ---- tokens ----

void lexer_finish_token(Lexer *l, Token *t, TokenKind kind, uint32_t end)
{
    t->kind = kind;
    t->len = end - t->at;
    l->at = end;
}

// Returns the end of the name of a machine's variable, such as deploy.T, whose first part ends at `end`; `end` if it is no such name.
static uint32_t skip_member(const Lexer *l, uint32_t end)
{
    if (!(l->script || l->requirements) || lexer_byte(l, end) != '.' || !lex_is_letter(lexer_byte(l, end + 1)) ||
        find_reserved(str_intern(l->strings, l->src->text + l->at, end - l->at)))
        return end;
    return lexer_skip_word(l, end + 1);
}

void lexer_read_word(Lexer *l, Token *t)
{
    uint32_t end = skip_member(l, lexer_skip_word(l, l->at));
    const Word *w;

    if ((unsigned char)lexer_byte(l, end) >= 0x80)
        end = hint_report_malformed_token(l, t, TOK_NAME, end);
    t->text = str_intern(l->strings, l->src->text + l->at, end - l->at);
    w = find_reserved(t->text);
    if (w)
        t->type = w->type;
    lexer_finish_token(l, t, w ? w->kind : TOK_NAME, end);
}

// Returns the end of the digits at p, which can have single underscores between them. belongs(c): whether c is a digit of the number's base.
static uint32_t skip_digits(const Lexer *l, uint32_t p, bool (*belongs)(char c))
{
    while (belongs(lexer_byte(l, p)))
        p += lexer_byte(l, p + 1) == '_' && belongs(lexer_byte(l, p + 2)) ? 2 : 1;
    return p;
}

// Returns the end of the decimal number at p. An `e` without digits after it does not belong to the number.
static uint32_t skip_decimal(const Lexer *l, uint32_t p)
{
    uint32_t e;

    p = skip_digits(l, p, lex_is_digit);
    if (lexer_byte(l, p) == '.')
        p = skip_digits(l, p + 1, lex_is_digit);
    if ((lexer_byte(l, p) | 0x20) != 'e')
        return p;
    e = p + 1;
    e += lexer_byte(l, e) == '+' || lexer_byte(l, e) == '-';
    return lex_is_digit(lexer_byte(l, e)) ? skip_digits(l, e, lex_is_digit) : p;
}

// Whether 0x is at p.
bool lexer_is_hex_prefix(const Lexer *l, uint32_t p)
{
    return lexer_byte(l, p) == '0' && (lexer_byte(l, p + 1) | 0x20) == 'x';
}

static void lex_number(Lexer *l, Token *t)
{
    const bool hex = lexer_is_hex_prefix(l, l->at) && is_hex(lexer_byte(l, l->at + 2));
    uint32_t end = hex ? skip_digits(l, l->at + 2, is_hex) : skip_decimal(l, l->at);
    const char after = lexer_byte(l, end);
    bool runs_on = lexer_is_word(after) || ((after == '.' || after == '\'') && lex_is_digit(lexer_byte(l, end + 1)));

    if (!number_to_f64(l->src->text + l->at, end - l->at, &t->number) && !runs_on)
        diag_report(l->diags, DIAG_number_too_large, lexer_span(l, l->at, end - l->at), lexer_text(l, l->at, end));
    if (runs_on)
        lexer_finish_token(l, t, TOK_ERROR, hint_report_malformed_token(l, t, TOK_NUMBER, end));
    else
        lexer_finish_token(l, t, TOK_NUMBER, end);
}

// Reads an address of a .net, such as 10.0.0.2 or 10.0.0.2:5000. Returns false if the digits here do not begin one: an address has at least
// two dots with a digit after each. The checker reports an address with wrong numbers.
static bool lex_address(Lexer *l, Token *t)
{
    uint32_t end = l->at, dots = 0;

    if (!l->addresses)
        return false;
    while (lex_is_digit(lexer_byte(l, end)) ||
           ((lexer_byte(l, end) == '.' || (lexer_byte(l, end) == ':' && dots > 1)) && lex_is_digit(lexer_byte(l, end + 1))))
        dots += lexer_byte(l, end++) == '.';
    if (dots < 2 || lexer_is_word(lexer_byte(l, end)))
        return false;
    t->text = str_intern(l->strings, l->src->text + l->at, end - l->at);
    lexer_finish_token(l, t, TOK_ADDRESS, end);
    return true;
}

bool lex_is_member(const char *s, size_t n)
{
    const char *dot = memchr(s, '.', n);

    return dot && lex_is_identifier(s, (size_t)(dot - s)) && lex_is_identifier(dot + 1, n - 1 - (size_t)(dot - s));
}

bool lex_is_header_name(const char *s, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (!lexer_is_word(s[i]) && s[i] != '/')
            return false;
    return n > 0;
}

// Reports a header without a closing bracket on its line, such as `[name`. The token ends after the longest possible name.
static void lex_unclosed_header(Lexer *l, Token *t)
{
    uint32_t from = l->at + 1, end;
    Diag *d;

    while (lexer_byte(l, from) == ' ' || lexer_byte(l, from) == '\t')
        from++;
    for (end = from; lexer_is_word(lexer_byte(l, end)) || lexer_byte(l, end) == '/'; end++)
        ;
    t->text = str_intern(l->strings, l->src->text + from, end - from);
    d = diag_report(l->diags, DIAG_header_unclosed, lexer_span(l, l->at, end - l->at));
    if (end > from)
        diag_label(l->diags, d, DIAG_label_write, format_in(l->diags->arena, "[%s]", t->text->text));
    lexer_finish_token(l, t, TOK_HEADER, end > from ? end : l->at + 1);
}

static void lex_header(Lexer *l, Token *t)
{
    uint32_t from = l->at + 1, end = from, to;
    const char *s = l->src->text;

    while (end < l->src->len && s[end] != ']' && s[end] != '\n' && s[end] != '#' && s[end] != '[')
        end++;
    if (lexer_byte(l, end) != ']') {
        lex_unclosed_header(l, t);
        return;
    }
    for (to = end; to > from && (s[to - 1] == ' ' || s[to - 1] == '\t'); to--)
        ;
    while (from < to && (s[from] == ' ' || s[from] == '\t'))
        from++;
    t->text = str_intern(l->strings, s + from, to - from);
    // After =, as in `x = [1, 2]`, the parser reports that the value is missing.
    if (!lex_is_header_name(s + l->at + 1, end - l->at - 1) && !(l->script && lex_is_member(s + l->at + 1, end - l->at - 1))
        && (t->first || l->last != TOK_ASSIGN))
        hint_report_malformed_token(l, t, TOK_HEADER, end);
    lexer_finish_token(l, t, TOK_HEADER, end + 1);
}

// Reads a label (.name) or an annotation (@name).
static void lex_prefixed(Lexer *l, Token *t, TokenKind kind)
{
    uint32_t end = lexer_skip_word(l, l->at + 1);

    if (end == l->at + 1)
        diag_report(l->diags, kind == TOK_LABEL ? DIAG_lone_dot : DIAG_lone_at, lexer_span(l, l->at, 1));
    t->text = str_intern(l->strings, l->src->text + l->at + 1, end - l->at - 1);
    lexer_finish_token(l, t, end == l->at + 1 ? TOK_ERROR : kind, end);
}

bool lexer_may_be_remark(const Lexer *l)
{
    const TokenKind last = l->last;

    return l->texts && l->open_parens == 0 &&
           (last == TOK_NAME || last == TOK_NUMBER || last == TOK_RPAREN || last == TOK_TRUE || last == TOK_FALSE || last == TOK_ANNOTATION ||
            last == TOK_COMMA || last == TOK_TEXT);
}

// Reads text in quotes: the reason of an @allow, a file name, or the text of an item of a script. It can contain the characters that a comment can
// contain. Returns false if the position allows no text, or the text does not end on its line.
static bool lex_text(Lexer *l, Token *t)
{
    const char *s = l->src->text;
    const uint32_t from = l->at + 1;
    uint32_t end = from;

    if (s[l->at] != '"' || (l->allow == LEX_NO_ALLOW && !l->config && !l->data && !lexer_may_be_remark(l)))
        return false;
    while (end < l->src->len && s[end] != '\n' && (s[end] != '"' || (lexer_may_be_remark(l) && hint_read_escaped_quote(l, from, end))))
        end++;
    if (lexer_byte(l, end) != '"')
        return false;
    t->text = str_intern(l->strings, s + from, end - from);
    lexer_check_comment(l, from, end);
    lexer_finish_token(l, t, TOK_TEXT, end + 1);
    return true;
}

// Reads the text after @unit on its line, up to a blank, a comment or another annotation. Returns false if the line has no such text.
static bool lex_unit(Lexer *l, Token *t)
{
    const char *s = l->src->text;
    uint32_t end = l->at;

    while (lexer_is_word(s[end]) || (s[end] && strchr("*/^().-+%", s[end])) || (unsigned char)s[end] >= 0x80)
        end++;
    if (t->first || end == l->at)
        return false;
    t->text = str_intern(l->strings, s + l->at, end - l->at);
    lexer_finish_token(l, t, TOK_UNIT, end);
    return true;
}

// ---- punctuators ----

// Returns the longest punctuator that begins at the current position, or NULL.  The rows whose spellings begin with the same character are
// linked from the longest to the shortest, so the first match is the longest.
static const Punctuator *find_punctuator(const Lexer *l)
{
    const char *s = l->src->text + l->at;                          // terminated by a NUL, which no punctuator contains
    size_t row = (unsigned char)*s < sizeof l->first_punctuator ? l->first_punctuator[(unsigned char)*s] : 0;

    for (; row > 0; row = l->next_punctuator[row - 1]) {
        const Punctuator *at_row = &punctuators[row - 1];
        size_t same = 1;
        while (same < at_row->len && at_row->spelling[same] == s[same])
            same++;
        if (same == at_row->len)
            return at_row;
    }
    return NULL;
}

// Reads a punctuator, and counts parentheses. A punctuator that cannot be inside parentheses resets open_parens. Returns false if no
// punctuator is at the current position.
static bool lex_punctuator(Lexer *l, Token *t)
{
    const Punctuator *s = find_punctuator(l);

    if (!s)
        return false;
    lexer_finish_token(l, t, s->kind, l->at + (uint32_t)s->len);
    l->parens += s->kind == TOK_LPAREN;
    l->parens -= s->kind == TOK_RPAREN && l->parens > 0;
    l->open_parens += s->kind == TOK_LPAREN;
    l->open_parens -= s->kind == TOK_RPAREN && l->open_parens > 0;
    if (s->kind == TOK_ASSIGN || s->kind == TOK_COLON || s->kind == TOK_ARROW || s->kind == TOK_LBRACE || s->kind == TOK_RBRACE)
        l->open_parens = 0;
    return true;
}

bool lex_find_reserved(Str word, TokenKind *kind)
{
    const Word *w = find_reserved(word);

    if (w)
        *kind = w->kind;
    return w != NULL;
}

// ---- the next token ----

// Reads the next token into t. Returns false if it skipped text instead.
static bool lex_try_token(Lexer *l, Token *t)
{
    const char c = l->src->text[l->at];
    const bool may_be_foreign = l->first_hint[(unsigned char)c] != 0 || l->last == TOK_ANNOTATION;
    const bool is_unit = l->last == TOK_ANNOTATION && l->unit && lex_unit(l, t);
    const HintResult foreign = may_be_foreign && !is_unit ? hint_read_foreign_text(l, t) : HINT_NONE;

    if (is_unit)
        return true;
    if (foreign != HINT_NONE)
        return foreign == HINT_READ;
    if (lex_is_letter(c))
        lexer_read_word(l, t);
    else if (lex_is_digit(c) || (c == '.' && lex_is_digit(lexer_byte(l, l->at + 1)))) {
        if (!lex_address(l, t))
            lex_number(l, t);
    } else if (c == '[')
        lex_header(l, t);
    else if (c == '.')
        lex_prefixed(l, t, TOK_LABEL);
    else if (c == '@')
        lex_prefixed(l, t, TOK_ANNOTATION);
    else if (!lex_text(l, t) && !lex_punctuator(l, t))
        return hint_read_stray_text(l, t) == HINT_READ;
    return true;
}

// Returns the value of l->allow after token t. The position is considered to be in an @allow until a token that cannot be part of one.
static LexAllow next_allow_state(const Lexer *l, const Token *t)
{
    static const char word[] = "allow";

    if (t->kind == TOK_ANNOTATION)
        return t->text->len == sizeof word - 1 && memcmp(t->text->text, word, t->text->len) == 0 ? LEX_ALLOW : LEX_NO_ALLOW;
    if (l->allow == LEX_NO_ALLOW)
        return LEX_NO_ALLOW;
    if (l->allow == LEX_ALLOW && (t->kind == TOK_LPAREN || t->first))
        return t->first ? LEX_NO_ALLOW : LEX_IN_ALLOW;
    return t->kind == TOK_RPAREN || t->kind == TOK_HEADER || t->kind == TOK_LABEL || t->kind == TOK_LBRACE || t->kind == TOK_RBRACE ||
           t->kind == TOK_END ? LEX_NO_ALLOW : l->allow;
}

// Whether quoted text can follow token t of a script in its statement.
static bool precedes_text(const Token *t)
{
    static const char *const items[] = {"assert", "fail", "expect", "print"};

    for (size_t i = 0; t->kind == TOK_ANNOTATION && i < sizeof items / sizeof *items; i++)
        if (strcmp(t->text->text, items[i]) == 0)
            return true;
    return t->kind == TOK_NAME && t->first && strcmp(t->text->text, "include") == 0;
}

void lex_next(Lexer *l, Token *t)
{
    bool is_enclosed = l->open_parens > 0;               // inside parentheses a line end counts as a space

    do {
        skip_spaces(l);
        memset(t, 0, sizeof *t);
        t->at = l->at;
        t->first = l->first;
        t->kind = TOK_END;
        if (l->at == l->src->len)
            break;
        if (l->src->text[l->at] == '#') {
            lexer_skip_comment(l);
            lexer_finish_token(l, t, TOK_COMMENT, l->at);
            return;
        }
    } while (!lex_try_token(l, t));
    if (t->kind == TOK_END)
        t->first = true;
    l->stores = (l->stores && !t->first) || t->kind == TOK_ASSIGN;
    l->annotated = (l->annotated && !t->first) || t->kind == TOK_ANNOTATION;
    if (l->script && t->kind == TOK_HEADER)
        l->data = strcmp(t->text->text, "data") == 0;
    if (l->script)
        l->texts = (l->texts && (!t->first || is_enclosed)) || precedes_text(t);
    if (l->open_parens > 0 && l->requirements && t->first && t->kind == TOK_NAME && l->src->text[l->at + strspn(l->src->text + l->at, " \t")] == '"')
        l->parens = l->open_parens = 0, is_enclosed = false;      // a requirement begins; that of an earlier line has left a ( open
    if (l->requirements)
        l->texts = t->first ? t->kind == TOK_NAME && !is_enclosed : l->texts && t->kind != TOK_TEXT;
    l->first = false;
    l->last = t->kind;
    if (t->kind == TOK_ANNOTATION)
        l->unit = strcmp(t->text->text, "unit") == 0;
    l->allow = next_allow_state(l, t);
}

// Continues at `at`, the start of a line.
void lex_skip_to(Lexer *l, uint32_t at)
{
    l->at = l->line_start = at;
    l->first = true;
}

void lex_init(Lexer *l, StrPool *strings, Diags *diags, const Source *src)
{
    memset(l, 0, sizeof *l);
    l->src = src;
    l->strings = strings;
    l->diags = diags;
    l->first = true;
    for (size_t row = LEX_PUNCTUATORS; row > 0; row--) {
        uint8_t *first = &l->first_punctuator[(unsigned char)punctuators[row - 1].spelling[0]];
        l->next_punctuator[row - 1] = *first;
        *first = (uint8_t)row;
    }
    hint_init(l);
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        str_mark(strings, words[i].spelling, (uint8_t)(i + 1));
    if (src->len >= 3 && memcmp(src->text, "\xef\xbb\xbf", 3) == 0)
        l->at = l->line_start = 3;
    if (!lexer_check_is_text(l))
        l->at = src->len;
}
