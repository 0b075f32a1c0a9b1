// SPDX-License-Identifier: Apache-2.0
// Handles what other languages have and this one does not: their comments, units, state headers, ranges and operators. Reports them here
// and returns the token that the user meant.
#include <string.h>

#include "compiler/syntax/hint_lines.h"
#include "compiler/syntax/hint_unit.h"
#include "compiler/syntax/hint_words.h"
#include "compiler/syntax/lexer.h"

// ---- comments, numbers, headers ----

enum { FAR = 200 };           // bytes: hostile text must not cost time quadratic in its length

static bool is_gap(char c) { return c == ' ' || c == '\t' || c == '\r'; }

static uint32_t skip_gap(const Lexer *l, uint32_t p)
{
    while (is_gap(lexer_byte(l, p)))
        p++;
    return p;
}

static bool ends_line(const Lexer *l, uint32_t p)
{
    return p == l->src->len || l->src->text[p] == '\n' || l->src->text[p] == '#';
}

// Returns the end of the identifier at p that is not a word of the language; `p` if there is none.
static uint32_t skip_name(const Lexer *l, uint32_t p)
{
    uint32_t end = lexer_skip_word(l, p);
    TokenKind reserved;

    if (!is_identifier(l->src->text + p, end - p))
        return p;
    return lex_is_reserved(str_intern(l->strings, l->src->text + p, end - p), &reserved) ? p : end;
}

// Two words in a row are prose, unless an expression could continue with the second: size AND, size then.
static bool is_prose(const Lexer *l, uint32_t p)
{
    uint32_t end = skip_name(l, p), next = skip_gap(l, end);

    return end > p && next > end && skip_name(l, next) > next &&
           !(lexer_is_declared(l, p, end) && hint_is_operator_word(l->src->text, next));
}

// `-- …` and `% …`: a comment, if no expression can continue like this.
bool lex_hint_is_remark(const Lexer *l)
{
    uint32_t len = l->src->text[l->at] == '%' ? 1 : 2, p = skip_gap(l, l->at + len), end = skip_name(l, p);

    if (is_prose(l, p))
        return true;
    return len == 1 && (l->first || l->last == TOK_TRUE || l->last == TOK_FALSE ||
                        (!l->stores && !lexer_is_declared(l, p, end) && ends_line(l, skip_gap(l, end))));
}

// Whether the last token ends a value. Then a binary operator or a closing bar can follow; otherwise an operand is missing.
static bool follows_value(const Lexer *l, bool first)
{
    return !first && (l->last == TOK_NAME || l->last == TOK_NUMBER || l->last == TOK_RPAREN || l->last == TOK_TRUE || l->last == TOK_FALSE ||
                      l->last == TOK_ERROR);
}

// Whether the sign is separated from the preceding text like a comment, and is not an operator: `x = 1   // open`, `x = 1 //open`.
static bool is_set_off(const Lexer *l, uint32_t at, uint32_t text)
{
    const char *s = l->src->text;

    return is_gap(s[at - 1]) && (text == at + 2 || is_gap(s[at - 2]));
}

// `a // b` is a division in other languages. Returns how likely it is: 0 impossible, 1 it could also be a comment, 2 certain, because the
// expression continues after b.
static int is_division(const Lexer *l)
{
    uint32_t p, end, after;
    bool known;

    if (!follows_value(l, l->first) || l->src->text[l->at + 1] != '/')
        return 0;
    p = skip_gap(l, l->at + 2);
    if (lexer_byte(l, p) == '-' || lexer_byte(l, p) == '+')
        p = skip_gap(l, p + 1);
    end = lexer_skip_word(l, p);
    after = skip_gap(l, end);
    if (is_prose(l, p))
        return 0;
    if (lexer_byte(l, p) == '(')
        return is_prose(l, skip_gap(l, p + 1)) ? 0 : 2;
    if (end == p)
        return 0;
    if (ends_line(l, after) ? is_digit(lexer_byte(l, p)) : strchr(":<>=!+-*/)&|{", lexer_byte(l, after)) != NULL)
        return 2;
    known = is_digit(lexer_byte(l, p)) ? skip_name(l, after) == after || hint_is_operator_word(l->src->text, after) : lexer_is_declared(l, p, end);
    if (!ends_line(l, after))
        return known && lexer_byte(l, after) != '.';
    return known || !is_set_off(l, l->at, p);
}

// Replaces Python's floor division with the single / that the user meant.
static void floor_division(Lexer *l, Token *t)
{
    Diag *d = diag_report(l->diags, DIAG_absent_operator, lexer_span(l, l->at, 2), "//");

    diag_label(l->diags, d, DIAG_label_floor);
    lexer_finish(l, t, TOK_SLASH, l->at + 2);
}

// Changes a comment that is closed on its line, with nothing after it, to a comment of this language.
static void edit_closed_comment(Lexer *l, Diag *d, uint32_t at, uint32_t end)
{
    if (memchr(l->src->text + at, '\n', end - at) || !ends_line(l, skip_gap(l, end)))
        return;
    diag_edit(l->diags, d, lexer_span(l, at, 2), "#");
    diag_edit(l->diags, d, lexer_span(l, end - 2, 2), "");
}

// p > 50 % of limit: -> Vent. The text after the sign is not only prose: it contains a declared name or begins a body.
static bool is_percentage(const Lexer *l)
{
    uint32_t p = l->at + 1, end;

    if (l->src->text[l->at] != '%' || l->last != TOK_NUMBER || l->annotated || l->first)
        return false;
    for (; !ends_line(l, p); p = end) {
        end = lexer_skip_word(l, p);
        if (strchr(":{", lexer_byte(l, p)) || (end > p && lexer_is_declared(l, p, end)))
            return true;
        end += end == p;
    }
    return false;
}

// p > 5 -- high: -> Vent. A condition precedes the sign and a colon or brace follows it, so the text may be part of the statement.
static bool hides_body(const Lexer *l)
{
    const char *s = l->src->text;
    bool compares = false;
    uint32_t p = l->at - l->line_start > FAR ? l->at - FAR : l->line_start;

    for (; p < l->at; p++) {
        if (s[p] == ':' || s[p] == '{')
            return false;
        compares = compares || s[p] == '<' || s[p] == '>' || (s[p] == '=' && s[p + 1] == '=');
    }
    while (compares && !ends_line(l, p) && s[p] != ':' && s[p] != '{')
        p++;
    return compares && !ends_line(l, p);
}

// `// …`, `/* … */`, `-- …` and `% …` of other languages; true: it was a division.
bool lex_hint_comment(Lexer *l, Token *t)
{
    uint32_t at = l->at, p = at + (l->src->text[at] == '%' ? 1 : 2);
    const int division = is_division(l);
    Diag *d;

    if (division == 2)
        return floor_division(l, t), true;
    d = diag_report(l->diags, DIAG_foreign_comment, lexer_span(l, at, p - at), lexer_text(l, at, p));
    if (is_percentage(l))
        diag_label(l->diags, d, DIAG_label_text, "write a percentage as a factor, as in 0.5 * x; a comment begins with #");
    else
        diag_label(l->diags, d, division ? DIAG_label_floor : DIAG_label_comment);
    if (l->src->text[at] == '/' && l->src->text[at + 1] == '*' && !l->no_comment_end) {
        while (p + 1 < l->src->len && !(l->src->text[p] == '*' && l->src->text[p + 1] == '/'))
            p++;
        l->no_comment_end = p + 1 >= l->src->len;
        if (!l->no_comment_end)
            edit_closed_comment(l, d, at, p + 2);
        for (; !l->no_comment_end && l->at < p + 2; )
            if (l->src->text[l->at] == '\n')
                lexer_end_line(l);
            else
                l->at++;
    }
    if (l->at == at) {
        if (!division && !is_percentage(l) && !hides_body(l))
            diag_edit(l->diags, d, lexer_span(l, at, p - at), "#");
        lexer_skip_comment(l);
    }
    return false;
}

// Whether a name follows the preceding word: task, machine, @mode.
static bool is_name_place(const Lexer *l, uint32_t at)
{
    uint32_t end, from;
    const char *s = l->src->text;

    while (at && (s[at - 1] == ' ' || s[at - 1] == '\t'))
        at--;
    for (from = end = at; from && lexer_is_word(s[from - 1]); )
        from--;
    return (end - from == 4 && memcmp(s + from, "task", 4) == 0) || (end - from == 7 && memcmp(s + from, "machine", 7) == 0) ||
           (from && s[from - 1] == '@' && (end - from != 8 || memcmp(s + from, "priority", 8) != 0));
}

// 5psi, 0x1G; or a name that begins with a digit
static void number_run_on(Lexer *l, uint32_t at, uint32_t end, uint32_t stop)
{
    Diag *d = diag_report(l->diags, DIAG_number_run_on, lexer_span(l, at, stop - at), lexer_text(l, at, end),
                          lexer_text(l, end, stop));

    if (l->last == TOK_TYPE)
        diag_label(l->diags, d, DIAG_label_name_first);
    else if (!lexer_is_hex_prefix(l, at) && is_identifier(l->src->text + end, stop - end) && lexer_knows_word(l, end, stop) &&
             !hint_is_time_unit(lexer_text(l, end, stop)))
        diag_label(l->diags, d, DIAG_label_multiply, lexer_text(l, at, end), lexer_text(l, end, stop));
    else if (!lexer_is_hex_prefix(l, at))
        hint_unit(l->diags, d, lexer_text(l, at, end), lexer_text(l, end, stop));
}

// More characters follow the number at..end: 5psi, 1__0, 0x, 1e, 1.2.3. Reports this; returns the end of those characters.
uint32_t lex_hint_number(Lexer *l, uint32_t at, uint32_t end)
{
    uint32_t stop = lexer_skip_word(l, end + (lexer_byte(l, end) == '\''));
    char c = lexer_byte(l, end), before = lexer_byte(l, end - 1);
    const char *whole;

    while (lexer_byte(l, stop) == '.' && lexer_is_word(lexer_byte(l, stop + 1)))
        stop = lexer_skip_word(l, stop + 1);
    whole = lexer_text(l, at, stop);
    if (c == '_' || (before == '_' && is_digit(c)))
        diag_report(l->diags, DIAG_number_underscore, lexer_span(l, end, 1), whole);
    else if (c == '\'')
        diag_label(l->diags, diag_report(l->diags, DIAG_number_run_on, lexer_span(l, at, stop - at), lexer_text(l, at, end), lexer_text(l, end, stop)),
                   DIAG_label_write, format_in(l->diags->arena, "%s%s", lexer_text(l, at, end), lexer_text(l, end + 1, stop)));
    else if (c == '.')
        diag_report(l->diags, DIAG_number_point, lexer_span(l, at, stop - at), whole);
    else if (lexer_is_hex_prefix(l, at) && end == at + 1)
        diag_report(l->diags, DIAG_number_incomplete, lexer_span(l, at, stop - at), whole, "a hexadecimal digit", "0x");
    else if ((c | 0x20) == 'e' && end + 1 == stop)
        diag_report(l->diags, DIAG_number_incomplete, lexer_span(l, at, stop - at), whole, "a digit",
                    lexer_text(l, end, end + 1));
    else if (l->config && is_name_place(l, at))
        diag_report(l->diags, DIAG_app_name_digit, lexer_span(l, at, stop - at), whole);
    else if (l->config)
        diag_label(l->diags, diag_report(l->diags, DIAG_unit_apart, lexer_span(l, at, stop - at), whole), DIAG_label_write,
                   format_in(l->diags->arena, "%s %s", lexer_text(l, at, end), lexer_text(l, end, stop)));
    else
        number_run_on(l, at, end, stop);
    return stop;
}

// `Hold Pressure`, `Vent-Fast`: returns the name with _ between the words; NULL if the error is a different one.
static const char *joined(Arena *arena, Str name)
{
    char *fixed = (char *)format_in(arena, "[%s]", name->text);

    for (char *c = fixed; *c; c++)
        if (*c == ' ' || *c == '-' || *c == '\t')
            *c = '_';
    return lex_is_header_name(fixed + 1, name->len) ? fixed : NULL;
}

// `Abort @abort`: the annotations are inside the brackets. Returns the correct form; NULL if the error is a different one.
static const char *annotations_outside(Arena *arena, Str name)
{
    const char *at = strchr(name->text, '@');
    size_t n = at ? (size_t)(at - name->text) : 0;

    while (n && (name->text[n - 1] == ' ' || name->text[n - 1] == '\t'))
        n--;
    return lex_is_header_name(name->text, n) ? format_in(arena, "[%.*s] %s", (int)n, name->text, at) : NULL;
}

void lex_hint_header(Lexer *l, uint32_t from, uint32_t end, Str name)
{
    Span whole = lexer_span(l, l->at, end + 1 - l->at);
    Diag *d = diag_report(l->diags, DIAG_header_name, lexer_span(l, from, end - from), lexer_text(l, l->at, end + 1));
    const char *fixed = annotations_outside(l->diags->arena, name);

    if (lex_is_header_name(name->text, name->len))
        fixed = format_in(l->diags->arena, "[%s]", name->text);
    if (fixed) {
        diag_label(l->diags, d, DIAG_label_write, fixed);
        diag_edit(l->diags, d, whole, fixed);
    } else if ((fixed = joined(l->diags->arena, name)) != NULL) {
        diag_label(l->diags, d, DIAG_label_write, fixed);
    } else {
        for (size_t i = 0; i < name->len; i++)
            if (name->text[i] & 0x80) {
                diag_label(l->diags, d, DIAG_label_name_ascii);
                return;
            }
    }
}

static bool is_state_word(const Lexer *l, const Token *t)
{
    static const char *const words[] = {"state", "State", "STATE", "def"};

    if (l->config || t->text->len > 5 || !strchr("sSd", t->text->text[0]))
        return false;
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (strcmp(t->text->text, words[i]) == 0)
            return true;
    return false;
}

// `state Hold:` and `def hold():` at the start of a line: [Hold].
bool lex_hint_state(Lexer *l, Token *t)
{
    uint32_t from, end, p;
    const char *written;
    Diag *d;

    if (!is_state_word(l, t))
        return false;
    from = skip_gap(l, t->at + t->len);
    end = skip_name(l, from);
    p = skip_gap(l, end);
    if (end == from)
        return false;
    if (lexer_byte(l, p) == '(' && lexer_byte(l, skip_gap(l, p + 1)) == ')')
        p = skip_gap(l, skip_gap(l, p + 1) + 1);
    if (lexer_byte(l, p) == ':' || lexer_byte(l, p) == '{')
        p++;
    if (!ends_line(l, skip_gap(l, p)))
        return false;
    d = diag_report(l->diags, DIAG_foreign_word, lexer_span(l, t->at, t->len), t->text->text);
    written = format_in(l->diags->arena, "[%.*s]", (int)(end - from), l->src->text + from);
    diag_label(l->diags, d, DIAG_label_write, written);
    diag_edit(l->diags, d, lexer_span(l, t->at, p - t->at), written);
    t->at = from - 1;
    t->text = str_intern(l->strings, l->src->text + from, end - from);
    lexer_finish(l, t, TOK_HEADER, end);
    l->at = p;
    return true;
}

static bool is_include_word(Str word)
{
    static const char *const words[] = {"include", "import", "using", "require"};

    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (strcmp(word->text, words[i]) == 0)
            return true;
    return false;
}

// Whether "common.sm", <common.sm> or common is the rest of the line from p on.
static bool is_file_name(const Lexer *l, uint32_t p)
{
    const char open = lexer_byte(l, p);
    uint32_t end = skip_name(l, p);

    if (open == '"' || open == '\'')
        return true;
    if (open == '<') {
        for (end = p + 1; lexer_is_word(lexer_byte(l, end)) || lexer_byte(l, end) == '.' || lexer_byte(l, end) == '/'; end++)
            ;
        if (end == p + 1 || lexer_byte(l, end++) != '>')
            return false;
    }
    return end > p && ends_line(l, skip_gap(l, end));
}

// `include "common.sm"`, `import common`: the line is skipped.
bool lex_hint_include(Lexer *l, const Token *t)
{
    Diag *d;

    if (l->config || !is_include_word(t->text) || !is_file_name(l, skip_gap(l, t->at + t->len)))
        return false;
    d = diag_report(l->diags, DIAG_foreign_word, lexer_span(l, t->at, t->len), t->text->text);
    diag_label(l->diags, d, DIAG_label_text,
               "a file cannot include another: copy the lines that it needs; what machines share is in the state vector (--sv=FILE)");
    lexer_skip_comment(l);
    return true;
}

// Returns the end of the number at p, with or without a sign; p if there is none. A digit must follow a point: 0..5.
static uint32_t skip_plain_number(const Lexer *l, uint32_t p)
{
    uint32_t at = p + (lexer_byte(l, p) == '-' || lexer_byte(l, p) == '+'), end = at;

    while (is_digit(lexer_byte(l, end)))
        end++;
    if (lexer_byte(l, end) == '.' && is_digit(lexer_byte(l, end + 1)))
        for (end++; is_digit(lexer_byte(l, end)); )
            end++;
    return end > at ? end : p;
}

// Returns the end of the separator that other languages have between two numbers: 0, 5 or 0..5 or 0 to 5. Returns `p` if there is none.
static uint32_t skip_between(const Lexer *l, uint32_t p)
{
    const char *s = l->src->text + p;                              // terminated by a NUL

    if (*s == ',' || *s == ';' || *s == ':')
        return p + 1;
    if ((s[0] == 't' && s[1] == 'o' && !lexer_is_word(s[2])) || (s[0] == '.' && s[1] == '.'))
        return p + 2 + (s[2] == '.');
    return p;
}

static void report_range(Lexer *l, Token *t, Span wrong, Span lo, Span hi, uint32_t end)
{
    Arena *arena = l->diags->arena;
    const char *fixed = format_in(arena, "%s %s", lexer_text(l, lo.at, lo.at + lo.len), lexer_text(l, hi.at, hi.at + hi.len));
    Diag *d = diag_report(l->diags, DIAG_range_value, wrong, wrong.at < lo.at ? "lowest" : "highest",
                          format_in(arena, "'%s'", lexer_text(l, wrong.at, wrong.at + wrong.len)));

    diag_label(l->diags, d, DIAG_label_write, format_in(arena, "@range %s", fixed));
    diag_edit(l->diags, d, lexer_span(l, t->at, end - t->at), fixed);
    lexer_finish(l, t, TOK_ERROR, end);
}

// Whether the text at p can follow a range: another annotation, a comment, or the end of the line.
static bool ends_range(const Lexer *l, uint32_t p)
{
    const char c = lexer_byte(l, p);

    return ends_line(l, p) || c == '@' || (c == '/' && strchr("/*", lexer_byte(l, p + 1))) || (c == ';' && ends_line(l, skip_gap(l, p + 1)));
}

// After @range: [0, 5], closed or not, and 0..5 and 0, 5. 0,5 10 has a decimal comma.
bool lex_hint_range(Lexer *l, Token *t)
{
    static const char word[] = "@range";
    const char *s = l->src->text, open = s[l->at];
    bool brackets = open == '[' || open == '(', closed;
    uint32_t back = l->at, lo = skip_gap(l, l->at + brackets), lo_end = skip_plain_number(l, lo), sign = skip_gap(l, lo_end);
    uint32_t sign_end = skip_between(l, sign), hi = skip_gap(l, sign_end);
    uint32_t hi_end = skip_plain_number(l, hi), end = skip_gap(l, hi_end);

    while (back && is_gap(s[back - 1]))
        back--;
    if (back < sizeof word - 1 || memcmp(s + back - (sizeof word - 1), word, sizeof word - 1) != 0 || lo_end == lo || hi_end == hi)
        return false;
    closed = brackets && s[end] == (open == '[' ? ']' : ')');
    if (brackets ? !closed && !ends_line(l, end) : sign_end == sign || !ends_range(l, end) || (s[sign] == ',' && sign == lo_end && hi == sign_end))
        return false;
    report_range(l, t, brackets ? lexer_span(l, l->at, 1) : lexer_span(l, sign, sign_end - sign), lexer_span(l, lo, lo_end - lo),
                 lexer_span(l, hi, hi_end - hi), closed ? end + 1 : hi_end);
    return true;
}

// ---- signs ----

static bool begins_statement(const Lexer *l, const Token *t)
{
    return t->first || l->last == TOK_COLON || l->last == TOK_LBRACE || l->last == TOK_LABEL || l->last == TOK_HEADER;
}

// Whether a name is the last word of the line after the sign, and the next line with code does not begin with a brace.
static bool names_state(const Lexer *l, const Token *t)
{
    uint32_t from = skip_gap(l, t->at + t->len), end = lexer_skip_word(l, from), p = skip_gap(l, end);

    if (l->stores || l->annotated || l->parens || !is_identifier(l->src->text + from, end - from) ||
        !(ends_line(l, p) || lexer_byte(l, p) == '}'))
        return false;
    while (lexer_byte(l, p) == '\n' || lexer_byte(l, p) == '#') {
        p += (uint32_t)strcspn(l->src->text + p, "\n");
        p = lexer_byte(l, p) ? skip_gap(l, p + 1) : p;
    }
    return lexer_byte(l, p) != '{';
}

// Whether the name after the sign is a declared value, not a state: a comparison whose body is missing.
static bool names_declared(const Lexer *l, const Token *t)
{
    const uint32_t from = skip_gap(l, t->at + t->len);

    return lexer_is_declared(l, from, lexer_skip_word(l, from));
}

// fault & 4, ~3: the user means bits, which the language does not have. In p > 5 & 3 < x this is not the case.
static bool is_about_bits(const Lexer *l, const Token *t)
{
    const uint32_t p = skip_gap(l, t->at + 1), behind = skip_gap(l, lexer_skip_word(l, p));

    return t->len == 1 && strchr("&|~", l->src->text[t->at]) && is_digit(lexer_byte(l, p)) && lexer_byte(l, behind) != '<' &&
           lexer_byte(l, behind) != '>' && lexer_byte(l, behind) != '.';
}

// The text on one side of a & or |, up to the next sign or word that joins conditions, within the same parentheses.
typedef struct Side {
    bool compares;            // contains a comparison
    enum { SIDE_END, SIDE_AND, SIDE_OR, SIDE_BIT_AND, SIDE_BIT_OR } until;
} Side;

static bool is_text(const char *s, uint32_t at, uint32_t end, const char *word)
{
    return end - at == strlen(word) && memcmp(s + at, word, end - at) == 0;
}

// Returns what kind of sign or word at `p` joins conditions; *len: its length.
static int joins(const Lexer *l, uint32_t p, uint32_t *len)
{
    const char *s = l->src->text;
    const uint32_t end = lexer_skip_word(l, p);

    *len = end > p ? end - p : 1;
    if (end > p)
        return is_text(s, p, end, "and") || is_text(s, p, end, "AND") ? SIDE_AND : is_text(s, p, end, "or") || is_text(s, p, end, "OR") ? SIDE_OR : SIDE_END;
    if (s[p] != '&' && s[p] != '|')
        return SIDE_END;
    *len = lexer_byte(l, p + 1) == s[p] ? 2 : 1;
    if (*len == 2)
        return s[p] == '&' ? SIDE_AND : SIDE_OR;
    return s[p] == '&' ? SIDE_BIT_AND : SIDE_BIT_OR;
}

static bool compares_at(const char *s, uint32_t p)
{
    return s[p] == '<' || s[p] == '>' || (s[p] == '=' && (s[p + 1] == '=' || (p > 0 && s[p - 1] == '!')));
}

static Side right_side(const Lexer *l, uint32_t p)
{
    const char *s = l->src->text;
    const uint32_t most = p + FAR;
    Side side = {false, SIDE_END};
    uint32_t depth = 0, len = 1;

    for (; p < most && p < l->src->len && !strchr(":{}#\n", s[p]); p += len) {
        int joined = joins(l, p, &len);
        if (depth == 0 && (joined || s[p] == ')')) {
            side.until = (unsigned)joined;
            break;
        }
        depth += s[p] == '(';
        depth -= s[p] == ')';
        side.compares |= compares_at(s, p);
    }
    return side;
}

// Scans the sides before a sign, from the start of its parentheses or of the line. Only the last one counts.
static Side left_side(const Lexer *l, uint32_t at)
{
    const char *s = l->src->text;
    uint32_t from = at, depth = 0, len = 1;
    Side side = {false, SIDE_END};

    while (from > l->line_start && at - from < FAR && !strchr(":{}", s[from - 1]) && (s[from - 1] != '(' || depth > 0)) {
        from--;
        depth += s[from] == ')';
        depth -= s[from] == '(';
    }
    depth = 0;
    for (uint32_t p = from; p < at; p += len) {
        int joined = joins(l, p, &len);
        if (depth == 0 && joined)
            side = (Side){false, (unsigned)joined};
        depth += s[p] == '(';
        depth -= s[p] == ')' && depth > 0;
        side.compares |= compares_at(s, p);
    }
    return side;
}

// `status & mask`, `x = ~mask`: perhaps bits are meant. Or a | next to an `and`: in other languages their precedence is reversed.
static bool may_be_bits(const Lexer *l, const Token *t)
{
    const char sign = l->src->text[t->at];
    Side left, right;

    if (t->len > 1 || sign == '~')
        return t->len == 1 && l->stores && !t->first;      // at a first token l->stores describes the previous line
    if (sign != '&' && sign != '|')
        return false;
    left = left_side(l, t->at);
    right = right_side(l, t->at + 1);
    if (sign == '|' && (left.until == SIDE_AND || right.until == SIDE_AND))
        return true;
    return !left.compares || (!right.compares && right.until >= SIDE_BIT_AND);
}

// Whether `at` follows only a name in its statement: x := 1.
static bool is_after_target(const Lexer *l, uint32_t at)
{
    const char *s = l->src->text;

    while (at > l->line_start && is_gap(s[at - 1]))
        at--;
    while (at > l->line_start && lexer_is_word(s[at - 1]))
        at--;
    while (at > l->line_start && is_gap(s[at - 1]))
        at--;
    return at == l->line_start || strchr(":{};", s[at - 1]);
}

static void report_foreign(Lexer *l, Token *t, const char *spelling, const char *native)
{
    bool arrow = strcmp(spelling, "=>") == 0, blank, names_value = false;
    uint32_t from = t->at;
    Diag *d;

    if (arrow && begins_statement(l, t))
        native = "->";
    else if (arrow && names_state(l, t) && !(names_value = names_declared(l, t)))
        native = ": ->";
    if (native[strlen(native) - 1] == '>')
        t->kind = TOK_ARROW;
    blank = is_letter(*native);
    d = diag_report(l->diags, DIAG_foreign_operator, lexer_span(l, t->at, t->len), spelling, native);
    if (may_be_bits(l, t)) {
        diag_label(l->diags, d, DIAG_label_no_bits, native);
        return;
    }
    diag_label(l->diags, d, DIAG_label_write, native);
    if (names_value || (*native == 'n' && !hint_is_negated_alone(l->src->text, t->at + t->len)) || (*spelling == ':' && !is_after_target(l, t->at)))
        return;
    while (*native == ':' && from && is_gap(l->src->text[from - 1]))
        from--;
    diag_edit(l->diags, d, lexer_span(l, from, t->at + t->len - from),
              format_in(l->diags->arena, "%s%s%s", blank && t->at && lexer_is_word(l->src->text[t->at - 1]) ? " " : "",
                        native, blank && lexer_is_word(lexer_byte(l, t->at + t->len)) ? " " : ""));
}

// |a - |b||: which bars belong together is ambiguous. Skips up to the last one.
static void skip_nested_bars(Lexer *l, Token *t)
{
    uint32_t at = l->at, end = at + 1;
    Diag *d;

    for (uint32_t p = end; !ends_line(l, p); p++)
        if (lexer_byte(l, p) == '|')
            end = p + 1;
    d = diag_report(l->diags, DIAG_absent_operator, lexer_span(l, at, end - at), lexer_text(l, at, end));
    diag_label(l->diags, d, DIAG_label_write, "abs(x)");
    lexer_finish(l, t, TOK_ERROR, end);
}

// Whether the text between two bars is one value.
static bool is_between_bars(const Lexer *l, uint32_t at, uint32_t end)
{
    const char *s = l->src->text;
    uint32_t depth = 0, last = end;

    at = skip_gap(l, at);
    while (last > at && is_gap(s[last - 1]))
        last--;
    if (last == at || !(lexer_is_word(s[last - 1]) || s[last - 1] == ')' || s[last - 1] == '.') || !(lexer_is_word(s[at]) || strchr("(-+.", s[at])))
        return false;
    for (; at < last; at++) {
        depth += s[at] == '(';
        if (strchr(",;:{}\"", s[at]) || (s[at] == ')' && depth-- == 0))
            return false;
    }
    return depth == 0;
}

// |x| of mathematics is read as (x).
bool lex_hint_bars(Lexer *l, Token *t)
{
    uint32_t at = l->at, end = at + 1;
    const char *fixed;
    Diag *d;

    if (at == l->bar && at > 0) {
        lexer_finish(l, t, TOK_RPAREN, end);
        return true;
    }
    if (follows_value(l, t->first) || (lexer_byte(l, end) == '|' && is_gap(lexer_byte(l, end + 1))))
        return false;
    end += lexer_byte(l, end) == '|';                  // ||a| - b|
    while (lexer_byte(l, end) != '|' && !ends_line(l, end))
        end++;
    if (lexer_byte(l, end) != '|')
        return false;
    if (lexer_byte(l, at + 1) == '|' || lexer_byte(l, end + 1) == '|' || !is_between_bars(l, at + 1, end)) {
        skip_nested_bars(l, t);
        return true;
    }
    fixed = format_in(l->diags->arena, "abs(%s)", lexer_text(l, at + 1, end));
    d = diag_report(l->diags, DIAG_absent_operator, lexer_span(l, at, end + 1 - at), lexer_text(l, at, end + 1));
    diag_label(l->diags, d, DIAG_label_write, fixed);
    diag_edit(l->diags, d, lexer_span(l, at, 1), at > 0 && lexer_is_word(l->src->text[at - 1]) ? " abs(" : "abs(");
    diag_edit(l->diags, d, lexer_span(l, end, 1), ")");
    l->bar = end;
    lexer_finish(l, t, TOK_LPAREN, at + 1);
    return true;
}

void lex_hint_sign(Lexer *l, Token *t, const char *spelling, const char *native, const char *label)
{
    if (native && is_about_bits(l, t)) {
        diag_label(l->diags, diag_report(l->diags, DIAG_absent_operator, lexer_span(l, t->at, t->len), spelling), DIAG_label_bits);
        t->kind = *spelling == '~' ? TOK_MINUS : TOK_STAR;
    } else if (native) {
        report_foreign(l, t, spelling, native);
    } else if (label) {
        Diag *d = diag_report(l->diags, DIAG_absent_operator, lexer_span(l, t->at, t->len), spelling);
        diag_label(l->diags, d, DIAG_label_text, label);
    }
}

// Whether the line has a comma directly between digits. Where ; separates values, this is a decimal comma.
static bool has_decimal_comma(const Lexer *l)
{
    const char *s = l->src->text;
    const uint32_t from = l->at - l->line_start > FAR ? l->at - FAR : l->line_start;

    for (uint32_t p = from + 1; p < l->at + FAR && p + 1 < l->src->len && s[p] != '\n' && s[p] != '#'; p++)
        if (s[p] == ',' && is_digit(s[p - 1]) && is_digit(s[p + 1]))
            return true;
    return false;
}

// f(a; b)
static void semicolon_for_comma(Lexer *l, Token *t)
{
    Diag *d = diag_report(l->diags, DIAG_foreign_operator, lexer_span(l, l->at, 1), ";", ",");

    diag_label(l->diags, d, DIAG_label_write, ",");
    if (!has_decimal_comma(l))
        diag_edit(l->diags, d, lexer_span(l, l->at, 1), ",");
    lexer_finish(l, t, TOK_COMMA, l->at + 1);
}

static bool is_else(const Lexer *l, uint32_t p)
{
    return lexer_skip_word(l, p) - p == 4 && memcmp(l->src->text + p, "else", 4) == 0;
}

// Skips the ';' and reads the next token as the first of a line.
static void skip_semicolon(Lexer *l)
{
    const Span span = lexer_span(l, l->at, 1);
    const uint32_t next = skip_gap(l, l->at + 1);
    Diag *d;

    l->at = next;
    l->first = true;
    if (span.at < l->hinted)
        return;
    d = diag_report(l->diags, DIAG_semicolon, span);
    if (next == l->src->len || strchr("\n#}", lexer_byte(l, next)) || is_else(l, next)) {
        diag_label(l->diags, d, DIAG_label_leave_out);
        diag_edit(l->diags, d, span, "");
    } else if (l->config) {
        diag_label(l->diags, d, DIAG_label_own_line);
    } else if ((l->hinted = hint_shared_line(l->diags, d, l->src, span.at, HINT_SEMICOLON)) == 0) {
        diag_label(l->diags, d, DIAG_label_own_line_or_braces);
        l->hinted = next + 1;
    }
}

bool lex_hint_semicolon(Lexer *l, Token *t)
{
    if (l->parens == 0) {
        skip_semicolon(l);
        return false;
    }
    semicolon_for_comma(l, t);
    return true;
}

const char *const lex_no_choice = "write it as if ...: x = a, and on the next line else: x = b";

// c ? a : b of other languages; the text that follows belongs to it.
void lex_hint_choice(Lexer *l)
{
    Diag *d = diag_report(l->diags, DIAG_absent_operator, lexer_span(l, l->at, 1), "?");

    diag_label(l->diags, d, DIAG_label_text, lex_no_choice);
    lex_skip_choice(l);
}

void lex_skip_choice(Lexer *l)
{
    while (l->at < l->src->len && !strchr("\n#}", l->src->text[l->at] ? l->src->text[l->at] : 'x'))
        l->at++;
}
