// SPDX-License-Identifier: Apache-2.0
// Hints in statements: words of other languages with which a statement begins.
#include "compiler/syntax/hint_lines.h"
#include "compiler/syntax/hint_rules.h"
#include "compiler/syntax/lexer.h"
#include "compiler/syntax/time_unit.h"

typedef enum HintEffect {
    HINT_IF, HINT_ELSE, HINT_ARROW,       // the word is read as `if`, `else` or ->
    HINT_DROP,                            // the word is skipped
    HINT_CLOSE,                           // the word is read as the } that an open brace lacks
    HINT_SKIP,                            // the statement is skipped up to the next one
    HINT_BLOCK,                           // the statement is skipped with its block, in braces or indented
    HINT_WAIT                             // the statement is skipped, and the advice contains the time to wait
} HintEffect;

static const struct { const char *word; HintEffect effect; const char *text; } foreign_words[] = {
#define HINT_WORD(word, effect, text) {word, HINT_##effect, text},
#include "compiler/syntax/hints.def"
};

// Whether the word is used as in another language, rather than as the name of a variable.
static bool is_used_as_foreign(const Parser *p, HintEffect effect)
{
    const Token *next = &p->ahead;
    const bool gives_up = effect == HINT_SKIP || effect == HINT_BLOCK || effect == HINT_WAIT || effect == HINT_CLOSE;

    if ((next->kind == TOK_COLON || next->kind == TOK_LBRACE) && effect == HINT_BLOCK)
        return !p->tok.text->declared;                            // try: or do {
    if (next->first && effect == HINT_ELSE)
        return hint_follows_indented(p, p->tok.at);               // ELSE, below IF x > 5 THEN and its statements
    if (next->first)
        return gives_up && next->kind != TOK_LBRACE;              // `stop` followed by a { on the next line is a guard
    if (effect == HINT_ARROW && next->kind == TOK_HEADER)
        return true;                                              // goto [Idle]
    if (effect == HINT_ELSE)
        return next->kind == TOK_IF || next->kind == TOK_NAME || next->kind == TOK_ARROW;     // `ELSE:` can be a guard, if ELSE is a variable
    return hint_begins_value(next) && (next->kind != TOK_LPAREN || effect == HINT_IF || gives_up);
}

// Returns the advice for wait(200), delay(200) or sleep(2), which contains the time to wait. In other languages delay takes milliseconds
// and sleep takes seconds.
static const char *format_wait(const Parser *p)
{
    static const char general[] = "put what follows in braces, under a limit to the time in the state: T >= 100 ms { ... }";
    uint32_t at = p->ahead.at + (p->ahead.kind == TOK_LPAREN);
    const char *number = p->ahead.first ? "" : hint_read_word(p, &at), *unit = "", *word;
    bool is_guess;

    if (strcmp(number, "until") == 0 && p->kind == FILE_SM)
        return "put what follows in braces, under the condition: x > 5 { ... }";
    if (!lex_is_digit(*number))
        return p->kind == FILE_SS ? "put what follows in braces, under a time of the run: at 100 ms { ... }" : general;
    if (hint_is_word(&p->tok, "sleep"))
        unit = " s";
    else if (hint_is_word(&p->tok, "delay"))
        unit = " ms";
    else
        unit = strlen(number) > 2 ? " ms" : " s";
    word = hint_read_word(p, &at);
    is_guess = hint_is_word(&p->tok, "wait") && time_unit_find(word) == TIME_NONE;
    if (time_unit_find(word) != TIME_NONE)
        unit = format_in(p->arena, " %s", word);
    return format_in(p->arena, "put what follows in braces%s: %s %s%s { ... }", is_guess ? ", with the unit of the time" : "",
                     p->kind == FILE_SS ? "at" : "T >=", number, unit);
}

// Returns the advice for switch (mode), with the name that is compared.
static const char *format_switch(const Parser *p)
{
    uint32_t at = p->ahead.at + (p->ahead.kind == TOK_LPAREN);
    const char *name = p->ahead.first ? "" : hint_read_word(p, &at);

    return lex_is_identifier(name, strlen(name)) ? format_in(p->arena, "write it as if %s == 1 ... else if %s == 2 ... else", name, name)
                                                 : "write it as if ... else if ... else";
}

// Reads `goto` and `transition to` as an arrow. In a script, the transition itself is the mistake, and the parser reports it.
static void read_as_arrow(Parser *p)
{
    const Span word = parser_token_span(p);
    const char *const written = p->tok.text->text;

    if (hint_is_word(&p->ahead, "to") && !p->ahead.first)              // go to, transition to
        parser_advance(p);
    p->tok.kind = TOK_ARROW;
    if (p->kind == FILE_SM) {
        Diag *d = parser_report(p, DIAG_foreign_word, word, written);
        diag_label(p->diags, d, DIAG_label_write, "->");
        diag_edit(p->diags, d, (Span){p->lex.src, word.at, p->tok.at + p->tok.len - word.at}, "->");
    }
}

enum { BRACE_SEARCHES_MAX = 100 };    // in a file, so that hostile text cannot cost time quadratic in its length

// Whether a brace that is open here has no } in its section.
static bool is_brace_missing(Parser *p)
{
    const char *text = p->lex.src->text;
    unsigned open = p->braces;

    if (p->brace_searches++ >= BRACE_SEARCHES_MAX)
        return false;
    for (uint32_t at = p->tok.at; text[at] && open > 0; at++) {
        if (text[at] == '#')
            at += (uint32_t)strcspn(text + at, "\n");
        if (text[at] == '\n' && text[at + 1 + strspn(text + at + 1, " \t")] == '[')
            break;
        open += text[at] == '{';
        open -= text[at] == '}';
        if (!text[at])
            break;
    }
    return open > 0;
}

// Reads `end` as the } that an open brace lacks. If none lacks one, the word ends a block whose begin is reported.
static HintResult read_as_brace(Parser *p, const char *text)
{
    Diag *d = parser_report(p, DIAG_foreign_word, parser_token_span(p), p->tok.text->text);

    diag_label(p->diags, d, DIAG_label_text, text);
    if (is_brace_missing(p)) {
        p->tok.kind = TOK_RBRACE;
    } else {
        d->follows = p->open_blocks > 0;
        p->open_blocks -= p->open_blocks > 0;
        p->failed = true;
        parser_advance(p);
    }
    return HINT_SKIPPED;
}

// Words whose advice, `text`, is another one in a script, in a machine, or with a value after the word.
static const struct { const char *word; FileKind kind; bool before_value; const char *text; } other_advice[] = {
    {"for",    FILE_SS, false, "there are no loops: each condition of a script is tested in every step"},
    {"while",  FILE_SS, false, "there are no loops: each condition of a script is tested in every step"},
    {"repeat", FILE_SS, false, "there are no loops: each condition of a script is tested in every step"},
    {"loop",   FILE_SS, false, "there are no loops: each condition of a script is tested in every step"},
    {"until",  FILE_SS, false, "there are no loops: each condition of a script is tested in every step"},
    {"do",     FILE_SS, false, "there are no loops: each condition of a script is tested in every step"},
    {"return", FILE_SS, false, "to end the run, write @stop under a condition, as in at 5 s: @stop"},
    {"return", FILE_SM, true,  "there are no functions to return from: assign the value to an element, as in x = 5"},
    {"assert", FILE_SM, false, "write @assert in a script (.ss) that tests the machine"},
    {"expect", FILE_SM, false, "write @expect in a script (.ss) that tests the machine"},
    {"check",  FILE_SM, false, "write @assert in a script (.ss) that tests the machine"},
    {"verify", FILE_SM, false, "write @assert in a script (.ss) that tests the machine"}};

// Returns the advice for the current word, whose row of hints.def has `text`.
static const char *find_advice(const Parser *p, const char *text)
{
    if (hint_is_word(&p->tok, "switch") || hint_is_word(&p->tok, "case"))
        return format_switch(p);
    for (size_t i = 0; i < sizeof other_advice / sizeof *other_advice; i++)
        if (hint_is_word(&p->tok, other_advice[i].word) && p->kind == other_advice[i].kind &&
            (!other_advice[i].before_value || (!p->ahead.first && hint_begins_value(&p->ahead))))
            return other_advice[i].text;
    return text;
}

static HintResult apply_foreign_word(Parser *p, HintEffect effect, const char *text)
{
    Diag *d;

    switch (effect) {
    case HINT_IF: case HINT_ELSE:
        d = hint_replace_word(p, text, effect == HINT_IF ? TOK_IF : TOK_ELSE);
        d->follows = hint_follows_indented(p, p->tok.at);              // elif
        if (effect == HINT_ELSE && p->ahead.first) {
            const uint32_t end = hint_brace_indented_lines(p->diags, d, p->lex.src, p->tok.at + p->tok.len, 0);
            p->indented = end > p->indented ? end : p->indented;
        }
        if (effect == HINT_IF)
            return HINT_READ;
        p->lost_body = true;
        return HINT_READ;
    case HINT_ARROW:
        read_as_arrow(p);
        return HINT_READ;
    case HINT_CLOSE:
        return read_as_brace(p, text);
    case HINT_DROP:
        d = parser_report(p, DIAG_foreign_word, parser_token_span(p), p->tok.text->text);
        diag_label(p->diags, d, DIAG_label_leave_out);
        diag_edit(p->diags, d, (Span){p->lex.src, p->tok.at, p->ahead.at - p->tok.at}, "");
        parser_advance(p);
        return HINT_READ;
    case HINT_SKIP: case HINT_BLOCK: case HINT_WAIT:
        break;
    }
    text = effect == HINT_WAIT ? format_wait(p) : find_advice(p, text);
    d = parser_fail(p, DIAG_foreign_word, parser_token_span(p), p->tok.text->text);
    diag_label(p->diags, d, DIAG_label_text, text);
    if (effect == HINT_BLOCK)
        hint_skip_block(p);
    else
        parser_advance(p);
    return HINT_SKIPPED;
}

// Reads or skips a word of another language at the start of a statement: `when x: ...`, `goto Idle`, `while x`.
HintResult hint_read_foreign_word(HintCase *c)
{
    Parser *p = c->p;
    const Token *next = &p->ahead;

    if (!next->first && !hint_begins_value(next) && next->kind != TOK_IF && next->kind != TOK_ARROW && next->kind != TOK_COLON &&
        next->kind != TOK_LBRACE && next->kind != TOK_HEADER)
        return HINT_NONE;                     // the word is the name of a variable, mostly with = after it
    for (size_t i = 0; i < sizeof foreign_words / sizeof *foreign_words; i++)
        if (hint_is_word(&p->tok, foreign_words[i].word) && is_used_as_foreign(p, foreign_words[i].effect))
            return apply_foreign_word(p, foreign_words[i].effect, foreign_words[i].text);
    return HINT_NONE;
}
