// SPDX-License-Identifier: Apache-2.0
// Hints about malformed tokens: 5psi, 1__0, größe, [two words].
#include <stdlib.h>
#include <string.h>

#include "compiler/syntax/hint_lists.h"
#include "compiler/syntax/hint_text.h"
#include "compiler/syntax/hint_unit.h"

// ---- numbers ----

// Whether the word before `at` takes a name as its argument: task, machine, @mode and others.
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

// Whether the text is a number in binary, as in 0b101.
static bool is_binary_number(const Lexer *l, uint32_t at, uint32_t stop)
{
    const char *s = l->src->text;

    return s[at] == '0' && (s[at + 1] == 'b' || s[at + 1] == 'B') && stop - at > 2 && stop - at <= 34 &&
           strspn(s + at + 2, "01") == stop - at - 2;
}

// Whether the letters after a number give its type in other languages, as in 5.0f or 5UL.
static bool is_type_suffix(const char *letters)
{
    static const char *const suffixes[] = {"f", "F", "u", "U", "l", "L", "ul", "UL", "ull", "ULL", "ll", "LL", "lu", "LU"};
    size_t i = 0;

    while (i < sizeof suffixes / sizeof *suffixes && strcmp(letters, suffixes[i]) != 0)
        i++;
    return i < sizeof suffixes / sizeof *suffixes;
}

// Reports a number with letters after it, such as 5psi or 0x1G, or a name that begins with a digit. The number ends at `end`, the letters
// at `stop`.
static void report_number_run_on(Lexer *l, uint32_t at, uint32_t end, uint32_t stop)
{
    Diag *d = diag_report(l->diags, DIAG_number_run_on, lexer_span(l, at, stop - at), lexer_text(l, at, end),
                          lexer_text(l, end, stop));

    if (l->last == TOK_TYPE)
        diag_label(l->diags, d, DIAG_label_name_first);
    else if (is_binary_number(l, at, stop))
        diag_label(l->diags, d, DIAG_label_write, format_in(l->diags->arena, "%lu", strtoul(l->src->text + at + 2, NULL, 2)));
    else if (!lexer_is_hex_prefix(l, at) && lex_is_identifier(l->src->text + end, stop - end) && hint_knows_word(l, end, stop) &&
             !hint_is_time_unit(lexer_text(l, end, stop)))
        diag_label(l->diags, d, DIAG_label_multiply, lexer_text(l, at, end), lexer_text(l, end, stop));
    else if (is_type_suffix(lexer_text(l, end, stop)))
        diag_label(l->diags, d, DIAG_label_write, lexer_text(l, at, end));
    else if (!lexer_is_hex_prefix(l, at))
        hint_label_unit(l->diags, d, lexer_text(l, at, end), lexer_text(l, end, stop), lexer_span(l, at, stop - at));
}

// Reports a number with several points: 1.2.3, or a range as in x in 3..5.
static void report_points(Lexer *l, uint32_t at, uint32_t stop)
{
    const char *s = l->src->text;
    const uint32_t dots = at + (uint32_t)strspn(s + at, "0123456789");
    Diag *d = diag_report(l->diags, DIAG_number_point, lexer_span(l, at, stop - at), lexer_text(l, at, stop));
    uint32_t end = at, in, from;

    if (s[dots] != '.' || s[dots + 1] != '.' || !lex_is_digit(lexer_byte(l, dots + 2)))
        return;
    while (end > 0 && is_space_tab_or_return(s[end - 1]))
        end--;
    for (in = end; in > 0 && lexer_is_word(s[in - 1]); in--) {}
    for (end = in; end > 0 && is_space_tab_or_return(s[end - 1]); end--) {}
    for (from = end; from > 0 && lexer_is_word(s[from - 1]); from--) {}
    diag_label(l->diags, d, DIAG_label_write,
               format_in(l->diags->arena, "%s <= %s <= %s", lexer_text(l, at, dots), s[in] == 'i' && end > from ? lexer_text(l, from, end) : "x",
                         lexer_text(l, dots + 2, stop)));
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
        report_points(l, at, stop);
    else if (lexer_is_hex_prefix(l, at) && end == at + 1)
        diag_report(l->diags, DIAG_number_incomplete, lexer_span(l, at, stop - at), whole, "a hexadecimal digit", "0x");
    else if ((c | 0x20) == 'e' && end + 1 == stop)
        diag_label(l->diags, diag_report(l->diags, DIAG_number_incomplete, lexer_span(l, at, stop - at), whole, "a digit",
                                         lexer_text(l, end, end + 1)), DIAG_label_write,
                   format_in(l->diags->arena, "%s, or a power of ten as in %se3", lexer_text(l, at, end), lexer_text(l, at, end)));
    else if (l->config && is_name_expected(l, at))
        diag_report(l->diags, DIAG_app_name_digit, lexer_span(l, at, stop - at), whole);
    else if (l->config)
        diag_label(l->diags, diag_report(l->diags, DIAG_unit_apart, lexer_span(l, at, stop - at), whole), DIAG_label_write,
                   format_in(l->diags->arena, "%s %s", lexer_text(l, at, end), lexer_text(l, end, stop)));
    else
        report_number_run_on(l, at, end, stop);
    return stop;
}

// ---- headers ----

// For a header with several words, such as [Hold Pressure] or [Vent-Fast], returns the header with _ between the words; else NULL.
static const char *join_header_words(Arena *arena, Str name)
{
    char *fixed = (char *)format_in(arena, "[%s]", name->text);

    for (char *c = fixed; *c; c++)
        if (*c == ' ' || *c == '-' || *c == '\t')
            *c = '_';
    return lex_is_header_name(fixed + 1, name->len) ? fixed : NULL;
}

// For a header with annotations inside the brackets, such as [Abort @abort], returns the header with them after the brackets; else NULL.
static const char *move_annotations_outside(Arena *arena, Str name)
{
    const char *at = strchr(name->text, '@');
    size_t n = at ? (size_t)(at - name->text) : 0;

    while (n && (name->text[n - 1] == ' ' || name->text[n - 1] == '\t'))
        n--;
    return lex_is_header_name(name->text, n) ? format_in(arena, "[%.*s] %s", (int)n, name->text, at) : NULL;
}

// Reports a header whose name is malformed, such as [two words]. The header begins at l->at; its ] is at `end`.
static void report_header_name(Lexer *l, bool first, uint32_t end, Str name)
{
    const uint32_t from = l->at + 1;
    Span whole = lexer_span(l, l->at, end + 1 - l->at);
    const char *fixed = move_annotations_outside(l->diags->arena, name);
    Diag *d;

    if (l->last == TOK_NAME && hint_report_brackets(l->diags, l->src, l->at, end + 1))
        return;
    if (!first && (l->last == TOK_LPAREN || l->last == TOK_COMMA || l->last == TOK_ASSIGN))
        return;                               // max([p, q]): the parser reports a list in place of a value
    d = diag_report(l->diags, DIAG_header_name, lexer_span(l, from, end - from), lexer_text(l, l->at, end + 1));
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
        if (strpbrk(name->text, "<>="))        // the brackets contain a condition, as in Stateflow: `[p > 5] -> Vent`
            diag_label(l->diags, d, DIAG_label_guard_in_brackets, name->text);
        else
            diag_label(l->diags, d, DIAG_label_section_name);
    }
}

// ---- all of them ----

// Reports a token of this kind that is well formed only up to `end`: 5psi, größe, [two words].  Returns the end of the malformed token.
uint32_t hint_report_malformed_token(Lexer *l, const Token *t, TokenKind kind, uint32_t end)
{
    if (kind == TOK_NUMBER)
        return report_malformed_number(l, l->at, end);
    if (kind == TOK_NAME)
        return hint_skip_foreign_letters(l, end);
    report_header_name(l, t->first, end, t->text);
    return end;
}
