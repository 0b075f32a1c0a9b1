// SPDX-License-Identifier: Apache-2.0
// Hints about comments of other languages: // -- % and /* */. The same characters can also be an operator: a // b divides in other
// languages, a -- b subtracts a negative number, and p > 50 % is a percentage.
#include <string.h>

#include "compiler/syntax/hint_text.h"
#include "compiler/syntax/hint_words.h"

// Whether a line that begins with `//` continues the expression of the line above: it closes a parenthesis that is open at its start.
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

// Whether only a type and a name precede the text on its line, as in F64 pressure // bar.
static bool follows_declared_name(const Lexer *l)
{
    const uint32_t type = hint_skip_spaces(l, l->line_start), type_end = lexer_skip_word(l, type), name = hint_skip_spaces(l, type_end);
    TokenKind kind;
    Str word = str_find(l->strings, l->src->text + type, type_end - type);

    return word && lex_find_reserved(word, &kind) && kind == TOK_TYPE && hint_skip_spaces(l, lexer_skip_word(l, name)) == l->at;
}

// `a // b` is a division in other languages. Returns how likely it is: 0 impossible, 1 it could also be a comment, 2 certain, because the
// expression continues after b.
static int estimate_division(const Lexer *l)
{
    uint32_t p, end, after;
    bool known, spaced;

    if (!hint_follows_value(l, false) || l->src->text[l->at + 1] != '/' || follows_declared_name(l))
        return 0;
    if (l->first)
        return divides_line_above(l) ? 2 : 0;
    p = hint_skip_spaces(l, l->at + 2);
    if (lexer_byte(l, p) == '-' || lexer_byte(l, p) == '+')
        p = hint_skip_spaces(l, p + 1);
    end = lexer_skip_word(l, p);
    after = hint_skip_spaces(l, end);
    if (hint_is_prose(l, p))
        return 0;
    if (lexer_byte(l, p) == '(')
        return hint_is_prose(l, hint_skip_spaces(l, p + 1)) ? 0 : 2;
    if (end == p)
        return 0;
    if (hint_ends_line(l, after) ? lex_is_digit(lexer_byte(l, p)) : strchr(":<>=!+-*/)&|{", lexer_byte(l, after)) != NULL)
        return 2;
    known = lex_is_digit(lexer_byte(l, p)) ? hint_skip_name(l, after) == after || hint_is_operator_word(l->src->text, after)
                                           : hint_is_declared(l, p, end);
    if (!hint_ends_line(l, after))
        return known && lexer_byte(l, after) != '.';
    // In `x = 1   // open` and `x = 1 //open` the spaces around the slashes are those of a comment, not of an operator.
    spaced = is_space_tab_or_return(l->src->text[l->at - 1]) && (p == l->at + 2 || is_space_tab_or_return(l->src->text[l->at - 2]));
    return known || !spaced;
}

// Proposes to replace a comment in /* */, at `at` to `end`, with a # comment, if the comment ends its line.
static void propose_closed_comment(Lexer *l, Diag *d, uint32_t at, uint32_t end)
{
    if (memchr(l->src->text + at, '\n', end - at) || !hint_ends_line(l, hint_skip_spaces(l, end)))
        return;
    diag_edit(l->diags, d, lexer_span(l, at, 2), "#");
    diag_edit(l->diags, d, lexer_span(l, end - 2, 2), "");
}

// Whether % follows a number and means percent, as in `p > 50 % of limit: -> Vent`: the text after % contains a declared name, or the colon
// or brace of a body. Otherwise the text can be a comment.
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

// Whether a condition precedes the foreign comment and a colon or brace is inside the comment, as in `p > 5 -- high: -> Vent`. Replacing
// `--` with # would then hide the body of the condition.
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

// Reads // or /* as the comment of another language, reports it, and skips to where that comment ends.
HintResult hint_read_slashes(Lexer *l, Token *t)
{
    uint32_t at = l->at, p = at + t->len;
    const int division = estimate_division(l);
    Diag *d;

    if (division == 2) {                      // `//` for division without remainder: it is read as /
        d = diag_report(l->diags, DIAG_absent_operator, lexer_span(l, at, 2), "//");
        diag_label(l->diags, d, DIAG_label_floor);
        lexer_finish_token(l, t, TOK_SLASH, at + 2);
        return HINT_READ;
    }
    d = diag_report(l->diags, DIAG_foreign_comment, lexer_span(l, at, p - at), lexer_text(l, at, p));
    if (is_percentage(l))
        diag_label(l->diags, d, DIAG_label_percentage);
    else
        diag_label(l->diags, d, division ? DIAG_label_comment_or_floor : DIAG_label_comment);
    if ((l->src->text[at] == '(' || l->src->text[at] == '/') && l->src->text[at + 1] == '*' && !l->no_comment_end) {
        const char last = l->src->text[at] == '(' ? ')' : '/';
        while (p + 1 < l->src->len && !(l->src->text[p] == '*' && l->src->text[p + 1] == last))
            p++;
        l->no_comment_end = p + 1 >= l->src->len;
        if (!l->no_comment_end) {
            if (memchr(l->src->text + at, '\n', p - at))
                diag_label(l->diags, d, DIAG_label_comment_lines);
            propose_closed_comment(l, d, at, p + 2);
        }
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

// Reports the % of `x > 50%`, after which no operand follows, and skips it.
HintResult hint_read_percent(Lexer *l, Token *t)
{
    const uint32_t p = hint_skip_spaces(l, t->at + 1), end = lexer_skip_word(l, p);
    const bool at_word = (end - p == 3 && memcmp(l->src->text + p, "and", 3) == 0) || (end - p == 2 && memcmp(l->src->text + p, "or", 2) == 0);

    if (l->first || l->last != TOK_NUMBER || (!hint_ends_line(l, p) && !at_word && !strchr(":{}),<>=*/", lexer_byte(l, p))))
        return HINT_NONE;
    diag_label(l->diags, diag_report(l->diags, DIAG_absent_operator, lexer_span(l, t->at, 1), "%"), DIAG_label_percentage);
    l->at++;
    return HINT_SKIPPED;
}

// Reads `-- …` or `% …` as a comment if the text after it cannot continue an expression: it is prose, or for a % one name that is not
// declared.
HintResult hint_read_remark(Lexer *l, Token *t)
{
    const uint32_t p = hint_skip_spaces(l, l->at + t->len), end = hint_skip_name(l, p);
    const bool after_truth = l->last == TOK_TRUE || l->last == TOK_FALSE;
    const bool lone_name = !l->stores && !hint_is_declared(l, p, end) && hint_ends_line(l, hint_skip_spaces(l, end));

    if (!hint_is_prose(l, p) && !(t->len == 1 && (l->first || after_truth || lone_name)))
        return HINT_NONE;
    return hint_read_slashes(l, t);
}
