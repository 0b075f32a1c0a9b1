// SPDX-License-Identifier: Apache-2.0
// Hints about declarations that this language has in another form, or does not have: enum Mode {A, B}, i : INT := 0, let a = 3.
#include <stdlib.h>
#include <string.h>

#include "compiler/syntax/hint_rules.h"
#include "compiler/syntax/hint_words.h"
#include "compiler/syntax/lexer.h"

enum { VALUES_SHOWN = 8 };

// Returns the name of the type that another language writes as `word`; "F64" if it is unknown.
static const char *find_type(const char *word)
{
    const char *type = hint_find_synonym(HINT_TYPES, word);

    return type ? type : "F64";
}

// Returns the end of the braces that open after the current token, with a name and a ';' that follow them; 0 if no braces open there.
static uint32_t end_of_braces(const Parser *p)
{
    const char *text = p->lex.src->text;
    const uint32_t open = p->tok.at + (uint32_t)strcspn(text + p->tok.at, "{[#\n;="), close = open + (uint32_t)strcspn(text + open, "}[");
    uint32_t at = close + 1;

    if (text[open] != '{' || text[close] != '}')
        return 0;
    hint_read_word(p, &at);
    return at + (text[at] == ';');
}

// Skips to `end`, the end of the braces of a declaration; if that is 0, skips its first word and lets the caller skip the line.
static void skip_braces(Parser *p, uint32_t end)
{
    if (end) {
        hint_skip_to(p, end);
        return;
    }
    p->failed = true;
    parser_advance(p);
}

// Returns the start of the next name of an enum at or after `at`: skips spaces, commas and comments.
static uint32_t skip_between_values(const char *text, uint32_t at)
{
    for (;;) {
        at += (uint32_t)strspn(text + at, " \t\r\n,");
        if (text[at] != '#')
            return at;
        at += (uint32_t)strcspn(text + at, "\n");
    }
}

// Returns the definitions for the names in the braces of an enum, as in "A = 0, B = 1". A value follows the one before it, as in C.
static const char *format_values(const Parser *p, uint32_t end)
{
    const char *text = p->lex.src->text;
    uint32_t at = skip_between_values(text, p->tok.at + (uint32_t)strcspn(text + p->tok.at, "{") + 1);
    unsigned value = 0;
    Buf out;

    buf_init(&out, p->arena);
    for (int i = 0; i < VALUES_SHOWN && at < end && lex_is_letter(text[at]); i++, value++) {
        const uint32_t from = at, stop = lexer_skip_word(&p->lex, at);
        at = stop + (uint32_t)strspn(text + stop, " \t=");
        if (lex_is_digit(text[at]))
            value = (unsigned)strtoul(text + at, NULL, 0);
        buf_printf(&out, "%s%.*s = %u", i ? ", " : "", (int)(stop - from), text + from, value);
        at = skip_between_values(text, at + (uint32_t)strcspn(text + at, ",}#"));
    }
    return buf_text(&out);
}

// Reports enum Mode {A, B} and skips it.
HintResult hint_report_enum(HintCase *c)
{
    Parser *p = c->p;
    const uint32_t end = end_of_braces(p);
    const char *values = end ? format_values(p, end) : "";
    Diag *d;

    if (p->tok.text->declared)
        return HINT_NONE;
    d = parser_report(p, DIAG_foreign_word, parser_token_span(p), p->tok.text->text);
    diag_label(p->diags, d, DIAG_label_enum, *values ? values : "A = 0, B = 1");
    skip_braces(p, end);
    return HINT_SKIPPED;
}

// Reports struct P { ... } and skips it.
HintResult hint_report_struct(HintCase *c)
{
    Parser *p = c->p;
    const uint32_t end = end_of_braces(p);

    if (p->tok.text->declared)
        return HINT_NONE;
    diag_label(p->diags, parser_report(p, DIAG_foreign_word, parser_token_span(p), p->tok.text->text), DIAG_label_no_structures);
    skip_braces(p, end);
    return HINT_SKIPPED;
}

// Returns the declaration that `i : INT := 0` means; *at is after its colon, and moves to the end of the value.
static const char *format_iec_decl(const Parser *p, const char *name, uint32_t *at)
{
    const char *text = p->lex.src->text, *type = find_type(hint_read_word(p, at)), *value = "";

    *at += (uint32_t)strspn(text + *at, " \t:=");
    if (text[*at - 1] == '=')
        value = "0";
    else if (text[*at] != ';' && text[*at] != '\n')
        value = hint_read_word(p, at);
    return format_in(p->arena, *value ? "%s %s = %s" : "%s %s", type, name, value);
}

// Reports a declaration of IEC 61131, as i : INT := 0, and skips its line. The current token is the name.
HintResult hint_report_iec_decl(HintCase *c)
{
    Parser *p = c->p;
    const char *text = p->lex.src->text, *name = p->tok.text->text;
    uint32_t at = p->ahead.at + 1;

    if (p->ahead.first)
        return HINT_NONE;
    diag_label(p->diags, parser_report(p, DIAG_decl_without_type, parser_token_span(p), name), DIAG_label_write, format_iec_decl(p, name, &at));
    hint_skip_to(p, at + (uint32_t)strcspn(text + at, "\n"));
    return HINT_SKIPPED;
}

// Reports a declaration with a word in place of the type, as in let a = 3.
HintResult hint_report_untyped_decl(HintCase *c)
{
    Parser *p = c->p;
    const char *text = p->lex.src->text;
    uint32_t end = p->ahead.at + (uint32_t)strcspn(text + p->ahead.at, "#;\r\n"), at = p->ahead.at, colon;
    const char *rest, *word, *type;
    Diag *d = parser_fail(p, DIAG_foreign_word, parser_token_span(p), p->tok.text->text);

    while (text[end - 1] == ' ' || text[end - 1] == '\t')
        end--;
    word = hint_read_word(p, &at);
    rest = parser_text(p, (Span){p->lex.src, p->ahead.at, end - p->ahead.at});
    type = hint_find_synonym(HINT_TYPES, word);
    colon = at + (uint32_t)strspn(text + at, " \t");
    if (text[colon] == ':') {                   // VAR limit : REAL := 500.0
        colon++;
        diag_label(p->diags, d, DIAG_label_write, format_iec_decl(p, word, &colon));
    } else if (type && lex_is_letter(text[colon])) {                      // const float k = 5.0
        diag_label(p->diags, d, DIAG_label_write,
                   format_in(p->arena, "%s %s", type, parser_text(p, (Span){p->lex.src, colon, end > colon ? end - colon : 0})));
    } else {
        diag_label(p->diags, d, DIAG_label_type_instead, rest, rest);
    }
    parser_advance(p);                          // parser_skip_line would stop before the first token of a line, which the word is
    return HINT_SKIPPED;
}
