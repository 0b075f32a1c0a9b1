// SPDX-License-Identifier: Apache-2.0
// Searches the rows of hints.def for the lexer. Also contains the hints about state headers, includes, ranges, semicolons and ?: of other
// languages: they report the text and return the token that the user meant.
#include <string.h>

#include "compiler/syntax/hint_lines.h"
#include "compiler/syntax/hint_text.h"
#include "compiler/syntax/hint_words.h"

// ---- search ----

typedef struct HintText {
    const char *spelling;
    size_t len;
    TokenKind after;          // the row applies only after a token of this kind; TOK_END: after any token
    HintResult (*read)(Lexer *l, Token *t);      // NULL: the row is an operator
    TokenKind kind;           // in a row of an operator: the token that replaces it
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

// Links the rows of the table of hints by the first character of their spelling, in the order of the table.
void hint_init(Lexer *l)
{
    for (size_t row = LEX_HINTS; row > 0; row--) {
        uint8_t *first = &l->first_hint[(unsigned char)*rows[row - 1].spelling];     // rows of HINT_AFTER have the spelling "", so they are in [0]
        l->next_hint[row - 1] = *first;
        *first = (uint8_t)row;
    }
}

// Applies the first row that matches, in the list that begins with row `first` (1 + its index), and returns its result; HINT_NONE if no row
// matches.
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

// Tries the rows of HINT_AFTER if the last token is an annotation, and then the rows whose spelling begins with the next character.
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

// Whether a line end, a comment or the end of the source is at p.
bool hint_ends_line(const Lexer *l, uint32_t p)
{
    return p == l->src->len || l->src->text[p] == '\n' || l->src->text[p] == '#';
}

// Whether the word appeared earlier in the sources, so that it may be declared.
bool hint_knows_word(const Lexer *l, uint32_t from, uint32_t end)
{
    return str_find(l->strings, l->src->text + from, end - from) != NULL;
}

// Whether the word is an element or a variable that is declared before this position; true for T.
bool hint_is_declared(const Lexer *l, uint32_t from, uint32_t end)
{
    Str word = str_find(l->strings, l->src->text + from, end - from);

    return word && (word->declared || strcmp(word->text, "T") == 0);
}

// Returns the end of the identifier at p; p if no identifier begins there or it is a reserved word.
uint32_t hint_skip_name(const Lexer *l, uint32_t p)
{
    uint32_t end = lexer_skip_word(l, p);
    TokenKind reserved;

    if (!lex_is_identifier(l->src->text + p, end - p))
        return p;
    return lex_find_reserved(str_intern(l->strings, l->src->text + p, end - p), &reserved) ? p : end;
}

// Whether prose begins at p: two words in a row. `size AND` and `size then` are no prose if `size` is declared.
bool hint_is_prose(const Lexer *l, uint32_t p)
{
    uint32_t end = hint_skip_name(l, p), next = hint_skip_spaces(l, end);

    return end > p && next > end && hint_skip_name(l, next) > next &&
           !(hint_is_declared(l, p, end) && hint_is_operator_word(l->src->text, next));
}

// Whether the last token ends a value. `first`: whether the next token is the first on its line; then the result is false.
bool hint_follows_value(const Lexer *l, bool first)
{
    return !first && (l->last == TOK_NAME || l->last == TOK_NUMBER || l->last == TOK_RPAREN || l->last == TOK_TRUE ||
                      l->last == TOK_FALSE || l->last == TOK_ERROR);
}

bool hint_follows_state(const Lexer *l, uint32_t at)
{
    const char *text = l->src->text;
    uint32_t from;

    while (at > 0 && is_space_tab_or_return(text[at - 1]))
        at--;
    for (from = at; from > 0 && lexer_is_word(text[from - 1]); from--) {}
    return at - from == 5 && (memcmp(text + from, "state", 5) == 0 || memcmp(text + from, "State", 5) == 0) && !hint_is_declared(l, from, at);
}

// Reads the := of `state := Hold` as =.  The assignment itself is the mistake, and the checker reports it.
HintResult hint_read_state_assignment(Lexer *l, Token *t)
{
    if (!hint_follows_state(l, l->at))
        return HINT_NONE;
    lexer_finish_token(l, t, TOK_ASSIGN, l->at + 2);
    return HINT_READ;
}

// ---- whole lines in the syntax of other languages ----

// Reads `state Hold:` and `def hold():`, at the start of a line, as the header [Hold].
HintResult hint_read_state(Lexer *l, Token *t)
{
    const uint32_t from = hint_skip_spaces(l, t->at + t->len), end = hint_skip_name(l, from);
    const bool is_def = l->src->text[t->at] == 'd';
    uint32_t p = hint_skip_spaces(l, end);
    const char *written;
    Diag *d;

    if (l->config || end == from || (is_def && t->at > l->line_start))
        return HINT_NONE;                              // below a label, def begins a function
    if (lexer_byte(l, p) == '(' && lexer_byte(l, hint_skip_spaces(l, p + 1)) == ')')
        p = hint_skip_spaces(l, hint_skip_spaces(l, p + 1) + 1);
    if (lexer_byte(l, p) == ':' || lexer_byte(l, p) == '{')
        p++;
    if (!hint_ends_line(l, hint_skip_spaces(l, p)) || (l->script && lexer_byte(l, p - 1) == '{'))
        return HINT_NONE;                              // in a script `state Hold {` is a guard
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

// Whether the rest of the line from p on is a file name, such as "common.sm", <common.sm> or common.
static bool is_file_name(const Lexer *l, uint32_t p)
{
    const char open = lexer_byte(l, p);
    uint32_t end = hint_skip_name(l, p);

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

// Whether a text in quotes is at p: "plant.ss".
static bool is_text(const Lexer *l, uint32_t p)
{
    const char *s = l->src->text + p, *end = *s == '"' ? memchr(s + 1, '"', l->src->len - p - 1) : NULL;

    return end && !memchr(s, '\n', (size_t)(end - s));
}

static bool is_path_character(char c) { return lexer_is_word(c) || c == '.' || c == '/' || c == '-'; }

// Reports a line of a script such as `include plant.ss`, <plant.ss> or `import "plant.ss"`, and skips it.
static HintResult read_script_include(Lexer *l, const Token *t)
{
    const uint32_t start = hint_skip_spaces(l, t->at + t->len);
    const char open = lexer_byte(l, start);
    const bool is_enclosed = open == '"' || open == '\'' || open == '<';
    uint32_t from = start + is_enclosed, end = from;
    Diag *d;

    while (is_path_character(lexer_byte(l, end)))
        end++;
    if (end == from || (!is_enclosed && (!memchr(l->src->text + from, '.', end - from) || !hint_ends_line(l, hint_skip_spaces(l, end)))))
        return HINT_NONE;
    d = diag_report(l->diags, DIAG_include_form, lexer_span(l, t->at, t->len));
    diag_label(l->diags, d, DIAG_label_write, format_in(l->diags->arena, "include \"%.*s\"", (int)(end - from), l->src->text + from));
    lexer_skip_comment(l);
    return HINT_SKIPPED;
}

// Reports and skips a line such as `include "common.sm"` or `import common`.
HintResult hint_read_include(Lexer *l, Token *t)
{
    static const char word[] = "include";
    Diag *d;

    if (l->script && t->len == sizeof word - 1 && memcmp(l->src->text + t->at, word, t->len) == 0 &&
        is_text(l, hint_skip_spaces(l, t->at + t->len)))
        return HINT_NONE;
    if (l->script)
        return read_script_include(l, t);
    if (l->config || !is_file_name(l, hint_skip_spaces(l, t->at + t->len)))
        return HINT_NONE;
    d = diag_report(l->diags, DIAG_foreign_word, lexer_span(l, t->at, t->len), lexer_text(l, t->at, t->at + t->len));
    diag_label(l->diags, d, DIAG_label_include);
    lexer_skip_comment(l);
    return HINT_SKIPPED;
}

// ---- ranges ----

// Returns the end of the number at p, with or without a sign; p if no number begins there. A point belongs to the number only if a digit follows:
// in 0..5 the number is 0.
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

// Returns the end of the separator that other languages have between two numbers: 0, 5 or 0..5 or 0 to 5. Returns `p` if no separator is there.
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

// Reports the range notations of other languages after @range: [0, 5], closed or not, 0..5, and 0, 5. Does not apply to `0,5 10`, where
// the comma is a decimal comma.
HintResult hint_read_range(Lexer *l, Token *t)
{
    static const char word[] = "@range";
    const char *s = l->src->text, open = s[l->at];
    bool brackets = open == '[' || open == '(', closed;
    uint32_t back = l->at, lo = hint_skip_spaces(l, l->at + brackets), lo_end = skip_plain_number(l, lo), sign = hint_skip_spaces(l, lo_end);
    uint32_t sign_end = skip_range_separator(l, sign), hi = hint_skip_spaces(l, sign_end);
    uint32_t hi_end = skip_plain_number(l, hi), end = hint_skip_spaces(l, hi_end);
    // whether another annotation, a comment or the end of the line follows the range
    const bool is_last = hint_ends_line(l, end) || s[end] == '@' || (s[end] == '/' && strchr("/*", lexer_byte(l, end + 1))) ||
                         (s[end] == ';' && hint_ends_line(l, hint_skip_spaces(l, end + 1)));

    while (back && is_space_tab_or_return(s[back - 1]))
        back--;
    if (back < sizeof word - 1 || memcmp(s + back - (sizeof word - 1), word, sizeof word - 1) != 0 || lo_end == lo || hi_end == hi)
        return HINT_NONE;
    closed = brackets && s[end] == (open == '[' ? ']' : ')');
    if (brackets ? !closed && !hint_ends_line(l, end)
                 : sign_end == sign || !is_last || (s[sign] == ',' && sign == lo_end && hi == sign_end))
        return HINT_NONE;
    report_range(l, t, brackets ? lexer_span(l, l->at, 1) : lexer_span(l, sign, sign_end - sign), lexer_span(l, lo, lo_end - lo),
                 lexer_span(l, hi, hi_end - hi), closed ? end + 1 : hi_end);
    return HINT_READ;
}

// ---- semicolons and choices ----

// Whether the line has a comma directly between digits. If ; separates the arguments, such a comma is a decimal comma.
static bool has_decimal_comma(const Lexer *l)
{
    const char *s = l->src->text;
    const uint32_t from = l->at - l->line_start > HINT_FAR ? l->at - HINT_FAR : l->line_start;

    for (uint32_t p = from + 1; p < l->at + HINT_FAR && p + 1 < l->src->len && s[p] != '\n' && s[p] != '#'; p++)
        if (s[p] == ',' && lex_is_digit(s[p - 1]) && lex_is_digit(s[p + 1]))
            return true;
    return false;
}

// Reads the ; of f(a; b) as a comma. Skips any other ; and reads the next token as if it were the first on its line.
HintResult hint_read_semicolon(Lexer *l, Token *t)
{
    const Span span = lexer_span(l, l->at, 1);
    const uint32_t next = hint_skip_spaces(l, l->at + 1);
    const bool else_follows = lexer_skip_word(l, next) - next == 4 && memcmp(l->src->text + next, "else", 4) == 0;
    Diag *d;

    if (l->parens > 0) {
        d = diag_report(l->diags, DIAG_foreign_operator, span, ";", ",");
        diag_label(l->diags, d, DIAG_label_write, ",");
        if (!has_decimal_comma(l))
            diag_edit(l->diags, d, span, ",");
        lexer_finish_token(l, t, TOK_COMMA, l->at + 1);
        return HINT_READ;
    }
    l->at = next;
    l->first = true;
    if (span.at < l->hinted)                  // an earlier report already covers this line
        return HINT_SKIPPED;
    d = diag_report(l->diags, DIAG_semicolon, span);
    if (next == l->src->len || strchr("\n#}", lexer_byte(l, next)) || else_follows) {
        diag_label(l->diags, d, DIAG_label_leave_out);
        diag_edit(l->diags, d, span, "");
    } else if (l->config) {
        diag_label(l->diags, d, DIAG_label_own_line);
    } else if ((l->hinted = hint_label_shared_line(l->diags, d, l->src, span.at, HINT_SEMICOLON)) == 0) {
        diag_label(l->diags, d, DIAG_label_own_line_or_braces);
        l->hinted = next + 1;
    }
    return HINT_SKIPPED;
}

const char *const hint_no_choice = "write it as if ...: x = a, and on the next line else: x = b";

// Reports the ? of `c ? a : b`, and skips the rest of the line, which belongs to this operator.
HintResult hint_read_choice(Lexer *l, Token *t)
{
    Diag *d = diag_report(l->diags, DIAG_absent_operator, lexer_span(l, t->at, t->len), "?");

    diag_label(l->diags, d, DIAG_label_text, hint_no_choice);
    hint_skip_choice(l);
    return HINT_SKIPPED;
}

// Skips the rest of c ? a : b or IF(c, a, b), up to the end of the line.
void hint_skip_choice(Lexer *l)
{
    while (l->at < l->src->len && !strchr("\n#}", l->src->text[l->at] ? l->src->text[l->at] : 'x'))
        l->at++;
}
