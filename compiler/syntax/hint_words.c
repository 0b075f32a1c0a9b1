// SPDX-License-Identifier: Apache-2.0
#include "compiler/syntax/hint_words.h"

#include <string.h>

#include "compiler/syntax/lexer.h"

static const HintPhrase phrases[] = {
#define HINT_PHRASE(words, native, kind) {words, native, TOK_##kind},
#include "compiler/syntax/hints.def"
};

static uint32_t skip_spaces(const char *text, uint32_t p)
{
    while (text[p] == ' ' || text[p] == '\t' || text[p] == '\r')
        p++;
    return p;
}

static char to_lower_case(char c) { return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c; }

// Returns the end of the text at p if it equals `words`; else 0. A space in `words` matches any number of spaces.
static uint32_t skip_words(const char *text, uint32_t p, const char *words)
{
    for (; *words; words++)
        if (*words == ' ' && (text[p] == ' ' || text[p] == '\t'))
            p = skip_spaces(text, p);
        else if (to_lower_case(text[p++]) != *words)
            return 0;
    return lexer_is_word(text[p]) ? 0 : p;
}

// Returns the longest operator in words that begins at `at`, and its end in *end; NULL if no operator begins there.
const HintPhrase *hint_find_phrase(const char *text, uint32_t at, uint32_t *end)
{
    for (size_t i = 0; i < sizeof phrases / sizeof *phrases; i++)
        if ((*end = skip_words(text, at, phrases[i].words)) > 0)
            return &phrases[i];
    return NULL;
}

// Whether the word at `at` continues or ends a condition: and, or, then, do, is, gt and others; case does not matter.
bool hint_is_operator_word(const char *text, uint32_t at)
{
    uint32_t end;

    return hint_find_phrase(text, at, &end) || skip_words(text, at, "then") || skip_words(text, at, "do");
}

enum { PARENS_MAX = 1000 };   // bytes that a scan for parentheses reads at most, so that hostile text cannot cost time quadratic in its length

// Returns the end of the parentheses that open at p; p if they do not close on the line.
static uint32_t skip_parens(const char *text, uint32_t p)
{
    uint32_t depth = 0;

    for (uint32_t at = p; at - p < PARENS_MAX && text[at] && text[at] != '\n' && text[at] != '#'; at++) {
        depth += text[at] == '(';
        if (text[at] == ')' && --depth == 0)
            return at + 1;
    }
    return p;
}

// Returns the end of the number at p, with any letters directly after it.
static uint32_t skip_number(const char *text, uint32_t p)
{
    while (lexer_is_word(text[p]) || (text[p] == '.' && lex_is_digit(text[p + 1])))
        p++;
    return p;
}

// Returns the end of the operand at `at`; `at` if no operand begins there.
uint32_t hint_skip_operand(const char *text, uint32_t at)
{
    uint32_t p = skip_spaces(text, at), end;

    if (text[p] == '-' || text[p] == '+')
        p = skip_spaces(text, p + 1);
    if (lex_is_digit(text[p]) || text[p] == '.')
        return skip_number(text, p);
    for (end = p; lexer_is_word(text[end]); end++)
        ;
    if (text[skip_spaces(text, end)] == '(')
        end = skip_parens(text, skip_spaces(text, end));
    return end > p ? end : at;
}

// Whether the text at p ends a condition or joins another condition to it: a line end, a colon, `and`, `then` and others.
static bool ends_condition(const char *text, uint32_t p)
{
    p = skip_spaces(text, p);
    return !text[p] || strchr("\n#:;{})", text[p]) || skip_words(text, p, "and") || skip_words(text, p, "or") || skip_words(text, p, "then") ||
           skip_words(text, p, "do") || strncmp(text + p, "&&", 2) == 0 || strncmp(text + p, "||", 2) == 0;
}

// Whether `or 6`, `and 6` or `or burning` is at p, after a comparison: the user may mean to compare with this value, too.
static bool adds_another_value(const char *text, uint32_t p)
{
    uint32_t value, is_or;

    p = skip_spaces(text, p);
    is_or = strncmp(text + p, "||", 2) == 0 ? p + 2 : skip_words(text, p, "or");
    value = skip_spaces(text, is_or ? is_or : strncmp(text + p, "&&", 2) == 0 ? p + 2 : skip_words(text, p, "and"));
    if (value == 0 || (!is_or && !lex_is_digit(text[value])))
        return false;
    return lexer_is_word(text[value]) && ends_condition(text, skip_number(text, value));
}

// Whether the text after a comparison operator, which begins at `at`, has more than one meaning: not 5, 5 or 6, between 3 and 5.
bool hint_is_doubtful_comparison(const char *text, uint32_t at)
{
    const uint32_t p = skip_spaces(text, at), negated = text[p] == '!' ? p + 1 : skip_words(text, p, "not");
    uint32_t end, next;

    if (negated)
        return lex_is_digit(text[skip_spaces(text, negated)]) || skip_words(text, skip_spaces(text, negated), "not");
    if (text[p] && strchr("=<>", text[p]))
        return true;                                   // two operators in a row, as in `p = > 5`
    end = hint_skip_operand(text, p);
    next = skip_spaces(text, end);
    if (next > end && lexer_is_word(text[next]) && lex_is_letter(text[p])) {
        const uint32_t then = skip_words(text, next, "then");            // `than` is often misspelt, as in `is greater then 5`
        if (then ? lex_is_digit(text[skip_spaces(text, then)]) : !hint_is_operator_word(text, next))
            return true;                               // two words in a row are prose
    }
    return adds_another_value(text, end);
}

// Returns the position of the ( that encloses `at`; `at` if no ( encloses it within PARENS_MAX bytes on the line.
static uint32_t find_open_paren(const char *text, uint32_t at)
{
    uint32_t depth = 0;

    for (uint32_t p = at; p > 0 && at - p < PARENS_MAX && text[p - 1] != '\n'; p--)
        if (text[p - 1] == ')')
            depth++;
        else if (text[p - 1] == '(' && depth-- == 0)
            return p - 1;
    return at;
}

// Whether the '=' at `at`, inside parentheses, can mean an assignment or a named argument: (x = p) > 3, roll_avg(p, n = 5).
bool hint_stores_in_parens(const char *text, uint32_t at)
{
    const uint32_t open = find_open_paren(text, at), close = skip_parens(text, open);
    uint32_t end = open, from;

    while (end > 0 && (text[end - 1] == ' ' || text[end - 1] == '\t'))
        end--;
    for (from = end; from > 0 && lexer_is_word(text[from - 1]); from--)
        ;
    if (open == at || close == open)
        return true;
    if (end > from && !hint_is_operator_word(text, from) && !skip_words(text, from, "if") && !skip_words(text, from, "not"))
        return true;                                   // a function name precedes the parenthesis
    end = skip_spaces(text, close);
    return text[end] && strchr("<>=!+-*/%^", text[end]);
}

// Whether a `not` before `at` negates only the operand at `at` in every language: no comparison or calculation follows the operand.
bool hint_is_negated_alone(const char *text, uint32_t at)
{
    const uint32_t end = hint_skip_operand(text, at);

    return end > at && ends_condition(text, end);
}
