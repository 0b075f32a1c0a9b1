// SPDX-License-Identifier: Apache-2.0
// Hints about text that other languages have and this one does not: their comments, numbers, state headers, ranges and semicolons. Reports
// it and returns the token that the user meant.
#include <string.h>

#include "compiler/syntax/hint_lines.h"
#include "compiler/syntax/hint_text.h"
#include "compiler/syntax/hint_unit.h"
#include "compiler/syntax/hint_words.h"

// ---- search ----

typedef struct HintText {
    const char *spelling;
    size_t len;
    TokenKind after;          // only after a token of this kind; TOK_END: after any
    HintResult (*read)(Lexer *l, Token *t);      // NULL: the row is an operator
    TokenKind kind;           // of an operator
    const char *native, *label;
} HintText;

static const HintText rows[] = {
#define HINT_TEXT(spelling, read) {spelling, sizeof spelling - 1, TOK_END, hint_##read, TOK_ERROR, NULL, NULL},
#define HINT_AFTER(kind, read) {"", 0, TOK_##kind, hint_##read, TOK_ERROR, NULL, NULL},
#define HINT_OPERATOR(spelling, kind, native) {spelling, sizeof spelling - 1, TOK_END, NULL, TOK_##kind, native, NULL},
#define HINT_ABSENT_OPERATOR(spelling, kind, label) {spelling, sizeof spelling - 1, TOK_END, NULL, TOK_##kind, NULL, label},
#include "compiler/syntax/hints.def"
};

// Whether the row's spelling is at s. A word must be the first of its line and end where the spelling ends.
static bool is_spelling_at(const HintText *row, const char *s, bool first)
{
    for (size_t i = 0; i < row->len; i++)
        if (s[i] != row->spelling[i])
            return false;
    return !lex_is_letter(*s) || (first && !lexer_is_word(s[row->len]) && !(s[row->len] & 0x80));
}

void hint_init(Lexer *l)
{
    for (size_t row = LEX_HINTS; row > 0; row--) {
        uint8_t *first = &l->first_hint[(unsigned char)*rows[row - 1].spelling];     // [0]: rows of HINT_AFTER, which have no spelling
        l->next_hint[row - 1] = *first;
        *first = (uint8_t)row;
    }
}

// Returns what the first row that matches returns, from row `first` on; HINT_NONE if none matches.
static HintResult apply_rows_from(Lexer *l, Token *t, uint8_t first)
{
    const char *s = l->src->text + l->at;                          // terminated by a NUL
    HintResult read = HINT_NONE;

    for (size_t i = first; i > 0 && read == HINT_NONE; i = l->next_hint[i - 1]) {
        const HintText *row = &rows[i - 1];
        if (row->after != TOK_END ? row->after != l->last : !is_spelling_at(row, s, t->first))
            continue;
        if (row->read) {
            t->len = (uint32_t)row->len;
            read = row->read(l, t);
        } else {
            lexer_finish_token(l, t, row->kind, l->at + (uint32_t)row->len);
            hint_report_operator(l, t, row->spelling, row->native, row->label);
            read = HINT_READ;
        }
    }
    return read;
}

HintResult hint_read_foreign_text(Lexer *l, Token *t)
{
    const char c = l->src->text[l->at];
    HintResult read = HINT_NONE;

    if (l->last == TOK_ANNOTATION)
        read = apply_rows_from(l, t, l->first_hint[0]);
    if (read == HINT_NONE && l->first_hint[(unsigned char)c] && (t->first || !lex_is_letter(c)))
        read = apply_rows_from(l, t, l->first_hint[(unsigned char)c]);
    return read;
}

// ---- words and lines ----

uint32_t hint_skip_spaces(const Lexer *l, uint32_t p)
{
    while (is_space_tab_or_return(lexer_byte(l, p)))
        p++;
    return p;
}

bool hint_ends_line(const Lexer *l, uint32_t p)
{
    return p == l->src->len || l->src->text[p] == '\n' || l->src->text[p] == '#';
}

bool hint_knows_word(const Lexer *l, uint32_t from, uint32_t end)
{
    return str_find(l->strings, l->src->text + from, end - from) != NULL;
}

bool hint_is_declared(const Lexer *l, uint32_t from, uint32_t end)
{
    Str word = str_find(l->strings, l->src->text + from, end - from);

    return word && (word->declared || strcmp(word->text, "T") == 0);
}

// Returns the end of the identifier at p that is not a word of the language; `p` if there is none.
static uint32_t skip_name(const Lexer *l, uint32_t p)
{
    uint32_t end = lexer_skip_word(l, p);
    TokenKind reserved;

    if (!lex_is_identifier(l->src->text + p, end - p))
        return p;
    return lex_find_reserved(str_intern(l->strings, l->src->text + p, end - p), &reserved) ? p : end;
}

// Whether two words in a row begin at p. They are prose, unless an expression could continue with the second: size AND, size then.
static bool is_prose(const Lexer *l, uint32_t p)
{
    uint32_t end = skip_name(l, p), next = hint_skip_spaces(l, end);

    return end > p && next > end && skip_name(l, next) > next &&
           !(hint_is_declared(l, p, end) && hint_is_operator_word(l->src->text, next));
}

bool hint_follows_value(const Lexer *l, bool first)
{
    return !first && (l->last == TOK_NAME || l->last == TOK_NUMBER || l->last == TOK_RPAREN || l->last == TOK_TRUE ||
                      l->last == TOK_FALSE || l->last == TOK_ERROR);
}

// ---- comments ----

// Whether `-- …` or `% …`, with a mark of `len` bytes, is a comment: no expression can continue like this.
static bool is_remark(const Lexer *l, uint32_t len)
{
    uint32_t p = hint_skip_spaces(l, l->at + len), end = skip_name(l, p);

    if (is_prose(l, p))
        return true;
    return len == 1 && (l->first || l->last == TOK_TRUE || l->last == TOK_FALSE ||
                        (!l->stores && !hint_is_declared(l, p, end) && hint_ends_line(l, hint_skip_spaces(l, end))));
}

// Whether the // at `at` is separated from the preceding text like a comment, and is not an operator: `x = 1   // open`, `x = 1 //open`.
// `text` is where the text after it begins.
static bool has_comment_spacing(const Lexer *l, uint32_t at, uint32_t text)
{
    const char *s = l->src->text;

    return is_space_tab_or_return(s[at - 1]) && (text == at + 2 || is_space_tab_or_return(s[at - 2]));
}

// Whether a line that begins with `//` continues the expression of the line above: it closes a parenthesis of that line.
static bool divides_line_above(const Lexer *l)
{
    const char *text = l->src->text;
    uint32_t p = hint_skip_operand(text, l->at + 2), depth = 0;

    if (l->open_parens == 0 || p == l->at + 2 || !strchr(")+-*/", lexer_byte(l, hint_skip_spaces(l, p))))
        return false;
    for (; !hint_ends_line(l, p); p++) {
        if (text[p] == ')' && depth-- == 0)
            return true;
        depth += text[p] == '(';
    }
    return false;
}

// `a // b` is a division in other languages. Returns how likely it is: 0 impossible, 1 it could also be a comment, 2 certain, because the
// expression continues after b.
static int estimate_division(const Lexer *l)
{
    uint32_t p, end, after;
    bool known;

    if (!hint_follows_value(l, false) || l->src->text[l->at + 1] != '/')
        return 0;
    if (l->first)
        return divides_line_above(l) ? 2 : 0;
    p = hint_skip_spaces(l, l->at + 2);
    if (lexer_byte(l, p) == '-' || lexer_byte(l, p) == '+')
        p = hint_skip_spaces(l, p + 1);
    end = lexer_skip_word(l, p);
    after = hint_skip_spaces(l, end);
    if (is_prose(l, p))
        return 0;
    if (lexer_byte(l, p) == '(')
        return is_prose(l, hint_skip_spaces(l, p + 1)) ? 0 : 2;
    if (end == p)
        return 0;
    if (hint_ends_line(l, after) ? lex_is_digit(lexer_byte(l, p)) : strchr(":<>=!+-*/)&|{", lexer_byte(l, after)) != NULL)
        return 2;
    known = lex_is_digit(lexer_byte(l, p)) ? skip_name(l, after) == after || hint_is_operator_word(l->src->text, after)
                                           : hint_is_declared(l, p, end);
    if (!hint_ends_line(l, after))
        return known && lexer_byte(l, after) != '.';
    return known || !has_comment_spacing(l, l->at, p);
}

// Replaces Python's floor division with the single / that the user meant.
static void read_floor_division(Lexer *l, Token *t)
{
    Diag *d = diag_report(l->diags, DIAG_absent_operator, lexer_span(l, l->at, 2), "//");

    diag_label(l->diags, d, DIAG_label_floor);
    lexer_finish_token(l, t, TOK_SLASH, l->at + 2);
}

// Changes a comment that is closed on its line, with nothing after it, to a comment of this language.
static void propose_closed_comment(Lexer *l, Diag *d, uint32_t at, uint32_t end)
{
    if (memchr(l->src->text + at, '\n', end - at) || !hint_ends_line(l, hint_skip_spaces(l, end)))
        return;
    diag_edit(l->diags, d, lexer_span(l, at, 2), "#");
    diag_edit(l->diags, d, lexer_span(l, end - 2, 2), "");
}

// Whether % follows a number and is meant as percent, as in p > 50 % of limit: -> Vent. The text after it is not a comment, because it
// contains a declared name or begins a body.
static bool is_percentage(const Lexer *l)
{
    uint32_t p = l->at + 1, end;

    if (l->src->text[l->at] != '%' || l->last != TOK_NUMBER || l->annotated || l->first)
        return false;
    for (; !hint_ends_line(l, p); p = end) {
        end = lexer_skip_word(l, p);
        if (strchr(":{", lexer_byte(l, p)) || (end > p && hint_is_declared(l, p, end)))
            return true;
        end += end == p;
    }
    return false;
}

// Whether a condition precedes the foreign comment and a colon or brace is inside it, as in p > 5 -- high: -> Vent. A # would hide that
// body.
static bool contains_guard_body(const Lexer *l)
{
    const char *s = l->src->text;
    bool compares = false;
    uint32_t p = l->at - l->line_start > HINT_FAR ? l->at - HINT_FAR : l->line_start;

    for (; p < l->at; p++) {
        if (s[p] == ':' || s[p] == '{')
            return false;
        compares = compares || s[p] == '<' || s[p] == '>' || (s[p] == '=' && s[p + 1] == '=');
    }
    while (compares && !hint_ends_line(l, p) && s[p] != ':' && s[p] != '{')
        p++;
    return compares && !hint_ends_line(l, p);
}

HintResult hint_read_slashes(Lexer *l, Token *t)
{
    uint32_t at = l->at, p = at + t->len;
    const int division = estimate_division(l);
    Diag *d;

    if (division == 2)
        return read_floor_division(l, t), HINT_READ;
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
            propose_closed_comment(l, d, at, p + 2);
        for (; !l->no_comment_end && l->at < p + 2; )
            if (l->src->text[l->at] == '\n')
                lexer_end_line(l);
            else
                l->at++;
    }
    if (l->at == at) {
        if (!division && !is_percentage(l) && !contains_guard_body(l))
            diag_edit(l->diags, d, lexer_span(l, at, p - at), "#");
        lexer_skip_comment(l);
    }
    return HINT_SKIPPED;
}

HintResult hint_read_remark(Lexer *l, Token *t)
{
    return is_remark(l, t->len) ? hint_read_slashes(l, t) : HINT_NONE;
}

// ---- numbers, names, headers ----

// Whether a name follows the preceding word: task, machine, @mode.
static bool is_name_expected(const Lexer *l, uint32_t at)
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

// Reports a number with letters after it, as 5psi or 0x1G, or a name that begins with a digit. The number ends at `end`, the word at
// `stop`.
static void report_number_run_on(Lexer *l, uint32_t at, uint32_t end, uint32_t stop)
{
    Diag *d = diag_report(l->diags, DIAG_number_run_on, lexer_span(l, at, stop - at), lexer_text(l, at, end),
                          lexer_text(l, end, stop));

    if (l->last == TOK_TYPE)
        diag_label(l->diags, d, DIAG_label_name_first);
    else if (!lexer_is_hex_prefix(l, at) && lex_is_identifier(l->src->text + end, stop - end) && hint_knows_word(l, end, stop) &&
             !hint_is_time_unit(lexer_text(l, end, stop)))
        diag_label(l->diags, d, DIAG_label_multiply, lexer_text(l, at, end), lexer_text(l, end, stop));
    else if (!lexer_is_hex_prefix(l, at))
        hint_label_unit(l->diags, d, lexer_text(l, at, end), lexer_text(l, end, stop));
}

// Reports a malformed number such as 5psi, 1__0, 0x, 1e or 1.2.3, which is well formed up to `end`. Returns the end of the whole word.
static uint32_t report_malformed_number(Lexer *l, uint32_t at, uint32_t end)
{
    uint32_t stop = lexer_skip_word(l, end + (lexer_byte(l, end) == '\''));
    char c = lexer_byte(l, end), before = lexer_byte(l, end - 1);
    const char *whole;
    Diag *d;

    while (lexer_byte(l, stop) == '.' && lexer_is_word(lexer_byte(l, stop + 1)))
        stop = lexer_skip_word(l, stop + 1);
    whole = lexer_text(l, at, stop);
    if (c == '_' || (before == '_' && lex_is_digit(c)))
        diag_report(l->diags, DIAG_number_underscore, lexer_span(l, end, 1), whole);
    else if (c == '\'') {
        d = diag_report(l->diags, DIAG_number_run_on, lexer_span(l, at, stop - at), lexer_text(l, at, end), lexer_text(l, end, stop));
        diag_label(l->diags, d, DIAG_label_write, format_in(l->diags->arena, "%s%s", lexer_text(l, at, end), lexer_text(l, end + 1, stop)));
    } else if (c == '.')
        diag_report(l->diags, DIAG_number_point, lexer_span(l, at, stop - at), whole);
    else if (lexer_is_hex_prefix(l, at) && end == at + 1)
        diag_report(l->diags, DIAG_number_incomplete, lexer_span(l, at, stop - at), whole, "a hexadecimal digit", "0x");
    else if ((c | 0x20) == 'e' && end + 1 == stop)
        diag_report(l->diags, DIAG_number_incomplete, lexer_span(l, at, stop - at), whole, "a digit",
                    lexer_text(l, end, end + 1));
    else if (l->config && is_name_expected(l, at))
        diag_report(l->diags, DIAG_app_name_digit, lexer_span(l, at, stop - at), whole);
    else if (l->config)
        diag_label(l->diags, diag_report(l->diags, DIAG_unit_apart, lexer_span(l, at, stop - at), whole), DIAG_label_write,
                   format_in(l->diags->arena, "%s %s", lexer_text(l, at, end), lexer_text(l, end, stop)));
    else
        report_number_run_on(l, at, end, stop);
    return stop;
}

// Returns a header such as [Hold Pressure] or [Vent-Fast] with _ between the words; NULL if the error is a different one.
static const char *join_header_words(Arena *arena, Str name)
{
    char *fixed = (char *)format_in(arena, "[%s]", name->text);

    for (char *c = fixed; *c; c++)
        if (*c == ' ' || *c == '-' || *c == '\t')
            *c = '_';
    return lex_is_header_name(fixed + 1, name->len) ? fixed : NULL;
}

// Returns a header such as [Abort @abort] with the annotations after the brackets; NULL if the error is a different one.
static const char *move_annotations_outside(Arena *arena, Str name)
{
    const char *at = strchr(name->text, '@');
    size_t n = at ? (size_t)(at - name->text) : 0;

    while (n && (name->text[n - 1] == ' ' || name->text[n - 1] == '\t'))
        n--;
    return lex_is_header_name(name->text, n) ? format_in(arena, "[%.*s] %s", (int)n, name->text, at) : NULL;
}

// Reports a header whose name is malformed, as [two words]. It begins at l->at; its ] is at `end`.
static void report_header_name(Lexer *l, uint32_t end, Str name)
{
    const uint32_t from = l->at + 1;
    Span whole = lexer_span(l, l->at, end + 1 - l->at);
    Diag *d = diag_report(l->diags, DIAG_header_name, lexer_span(l, from, end - from), lexer_text(l, l->at, end + 1));
    const char *fixed = move_annotations_outside(l->diags->arena, name);

    if (lex_is_header_name(name->text, name->len))
        fixed = format_in(l->diags->arena, "[%s]", name->text);
    if (fixed) {
        diag_label(l->diags, d, DIAG_label_write, fixed);
        diag_edit(l->diags, d, whole, fixed);
    } else if ((fixed = join_header_words(l->diags->arena, name)) != NULL) {
        diag_label(l->diags, d, DIAG_label_write, fixed);
    } else {
        for (size_t i = 0; i < name->len; i++)
            if (name->text[i] & 0x80) {
                diag_label(l->diags, d, DIAG_label_name_ascii);
                return;
            }
    }
}

uint32_t hint_report_malformed_token(Lexer *l, const Token *t, TokenKind kind, uint32_t end)
{
    if (kind == TOK_NUMBER)
        return report_malformed_number(l, l->at, end);
    if (kind == TOK_NAME)
        return hint_skip_foreign_letters(l, end);
    report_header_name(l, end, t->text);
    return end;
}

// ---- lines ----

// Reads `state Hold:` and `def hold():`, at the start of a line, as the header [Hold].
HintResult hint_read_state(Lexer *l, Token *t)
{
    const uint32_t from = hint_skip_spaces(l, t->at + t->len), end = skip_name(l, from);
    uint32_t p = hint_skip_spaces(l, end);
    const char *written;
    Diag *d;

    if (l->config || end == from)
        return HINT_NONE;
    if (lexer_byte(l, p) == '(' && lexer_byte(l, hint_skip_spaces(l, p + 1)) == ')')
        p = hint_skip_spaces(l, hint_skip_spaces(l, p + 1) + 1);
    if (lexer_byte(l, p) == ':' || lexer_byte(l, p) == '{')
        p++;
    if (!hint_ends_line(l, hint_skip_spaces(l, p)))
        return HINT_NONE;
    d = diag_report(l->diags, DIAG_foreign_word, lexer_span(l, t->at, t->len), lexer_text(l, t->at, t->at + t->len));
    written = format_in(l->diags->arena, "[%.*s]", (int)(end - from), l->src->text + from);
    diag_label(l->diags, d, DIAG_label_write, written);
    diag_edit(l->diags, d, lexer_span(l, t->at, p - t->at), written);
    t->at = from - 1;
    t->text = str_intern(l->strings, l->src->text + from, end - from);
    lexer_finish_token(l, t, TOK_HEADER, end);
    l->at = p;
    return HINT_READ;
}

// Whether the rest of the line from p on is a file name, as "common.sm", <common.sm> or common.
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
    return end > p && hint_ends_line(l, hint_skip_spaces(l, end));
}

// Reports and skips a line such as `include "common.sm"` or `import common`.
HintResult hint_read_include(Lexer *l, Token *t)
{
    Diag *d;

    if (l->config || !is_file_name(l, hint_skip_spaces(l, t->at + t->len)))
        return HINT_NONE;
    d = diag_report(l->diags, DIAG_foreign_word, lexer_span(l, t->at, t->len), lexer_text(l, t->at, t->at + t->len));
    diag_label(l->diags, d, DIAG_label_text,
               "a file cannot include another: copy the lines that it needs; what machines share is in the state vector (--sv=FILE)");
    lexer_skip_comment(l);
    return HINT_SKIPPED;
}

// ---- ranges ----

// Returns the end of the number at p, with or without a sign; p if there is none. A digit must follow a point: 0..5.
static uint32_t skip_plain_number(const Lexer *l, uint32_t p)
{
    uint32_t at = p + (lexer_byte(l, p) == '-' || lexer_byte(l, p) == '+'), end = at;

    while (lex_is_digit(lexer_byte(l, end)))
        end++;
    if (lexer_byte(l, end) == '.' && lex_is_digit(lexer_byte(l, end + 1)))
        for (end++; lex_is_digit(lexer_byte(l, end)); )
            end++;
    return end > at ? end : p;
}

// Returns the end of the separator that other languages have between two numbers: 0, 5 or 0..5 or 0 to 5. Returns `p` if there is none.
static uint32_t skip_range_separator(const Lexer *l, uint32_t p)
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
    lexer_finish_token(l, t, TOK_ERROR, end);
}

// Whether the text at p can follow a range: another annotation, a comment, or the end of the line.
static bool ends_range(const Lexer *l, uint32_t p)
{
    const char c = lexer_byte(l, p);

    return hint_ends_line(l, p) || c == '@' || (c == '/' && strchr("/*", lexer_byte(l, p + 1))) ||
           (c == ';' && hint_ends_line(l, hint_skip_spaces(l, p + 1)));
}

// Reads the notations of other languages after @range: [0, 5], closed or not, 0..5, and 0, 5. In 0,5 10 the comma is a decimal comma.
HintResult hint_read_range(Lexer *l, Token *t)
{
    static const char word[] = "@range";
    const char *s = l->src->text, open = s[l->at];
    bool brackets = open == '[' || open == '(', closed;
    uint32_t back = l->at, lo = hint_skip_spaces(l, l->at + brackets), lo_end = skip_plain_number(l, lo), sign = hint_skip_spaces(l, lo_end);
    uint32_t sign_end = skip_range_separator(l, sign), hi = hint_skip_spaces(l, sign_end);
    uint32_t hi_end = skip_plain_number(l, hi), end = hint_skip_spaces(l, hi_end);

    while (back && is_space_tab_or_return(s[back - 1]))
        back--;
    if (back < sizeof word - 1 || memcmp(s + back - (sizeof word - 1), word, sizeof word - 1) != 0 || lo_end == lo || hi_end == hi)
        return HINT_NONE;
    closed = brackets && s[end] == (open == '[' ? ']' : ')');
    if (brackets ? !closed && !hint_ends_line(l, end)
                 : sign_end == sign || !ends_range(l, end) || (s[sign] == ',' && sign == lo_end && hi == sign_end))
        return HINT_NONE;
    report_range(l, t, brackets ? lexer_span(l, l->at, 1) : lexer_span(l, sign, sign_end - sign), lexer_span(l, lo, lo_end - lo),
                 lexer_span(l, hi, hi_end - hi), closed ? end + 1 : hi_end);
    return HINT_READ;
}

// ---- semicolons and choices ----

// Whether the line has a comma directly between digits. Where ; separates values, this is a decimal comma.
static bool has_decimal_comma(const Lexer *l)
{
    const char *s = l->src->text;
    const uint32_t from = l->at - l->line_start > HINT_FAR ? l->at - HINT_FAR : l->line_start;

    for (uint32_t p = from + 1; p < l->at + HINT_FAR && p + 1 < l->src->len && s[p] != '\n' && s[p] != '#'; p++)
        if (s[p] == ',' && lex_is_digit(s[p - 1]) && lex_is_digit(s[p + 1]))
            return true;
    return false;
}

// Reads the ; of f(a; b) as a comma.
static void read_semicolon_as_comma(Lexer *l, Token *t)
{
    Diag *d = diag_report(l->diags, DIAG_foreign_operator, lexer_span(l, l->at, 1), ";", ",");

    diag_label(l->diags, d, DIAG_label_write, ",");
    if (!has_decimal_comma(l))
        diag_edit(l->diags, d, lexer_span(l, l->at, 1), ",");
    lexer_finish_token(l, t, TOK_COMMA, l->at + 1);
}

static bool is_else(const Lexer *l, uint32_t p)
{
    return lexer_skip_word(l, p) - p == 4 && memcmp(l->src->text + p, "else", 4) == 0;
}

// Skips the ';' and reads the next token as the first of a line.
static void skip_semicolon(Lexer *l)
{
    const Span span = lexer_span(l, l->at, 1);
    const uint32_t next = hint_skip_spaces(l, l->at + 1);
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
    } else if ((l->hinted = hint_label_shared_line(l->diags, d, l->src, span.at, HINT_SEMICOLON)) == 0) {
        diag_label(l->diags, d, DIAG_label_own_line_or_braces);
        l->hinted = next + 1;
    }
}

HintResult hint_read_semicolon(Lexer *l, Token *t)
{
    if (l->parens == 0) {
        skip_semicolon(l);
        return HINT_SKIPPED;
    }
    read_semicolon_as_comma(l, t);
    return HINT_READ;
}

const char *const hint_no_choice = "write it as if ...: x = a, and on the next line else: x = b";

// Reports the ? of c ? a : b, and skips the rest of the line, which belongs to the operator.
HintResult hint_read_choice(Lexer *l, Token *t)
{
    Diag *d = diag_report(l->diags, DIAG_absent_operator, lexer_span(l, t->at, t->len), "?");

    diag_label(l->diags, d, DIAG_label_text, hint_no_choice);
    hint_skip_choice(l);
    return HINT_SKIPPED;
}

void hint_skip_choice(Lexer *l)
{
    while (l->at < l->src->len && !strchr("\n#}", l->src->text[l->at] ? l->src->text[l->at] : 'x'))
        l->at++;
}
