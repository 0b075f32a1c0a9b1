// SPDX-License-Identifier: Apache-2.0
// Hints about statements in prose: close valve, v = true for 1 s, k mod 2.
#include <string.h>

#include "compiler/syntax/hint_rules.h"
#include "compiler/syntax/hint_words.h"

// ---- two names in a row ----

// Verbs, and the assignment that they mean; %s is the name after the verb. NULL: the verb means no assignment.
static const struct { const char *verb, *assignment; } verbs[] = {
    {"toggle", "%s = not %s"},     {"invert", "%s = not %s"},  {"flip", "%s = not %s"},      {"open", "%s = true"},
    {"start", "%s = true"},        {"enable", "%s = true"},    {"activate", "%s = true"},    {"energize", "%s = true"},
    {"fire", "%s = true"},         {"set", "%s = true"},       {"turn_on", "%s = true"},     {"close", "%s = false"},
    {"disable", "%s = false"},     {"deactivate", "%s = false"}, {"clear", "%s = false"},    {"reset", "%s = false"},
    {"turn_off", "%s = false"},    {"increment", "%s = %s + 1"}, {"decrement", "%s = %s - 1"}};

// Returns the assignment that `close valve` means; NULL if the first word is no verb, or more follows on the line.
static const char *format_verb(const Parser *p, const char *verb)
{
    const char *name = p->tok.text->text;

    if (!p->ahead.first && p->ahead.kind != TOK_RBRACE && p->ahead.kind != TOK_END)
        return NULL;
    for (size_t i = 0; i < sizeof verbs / sizeof *verbs; i++)
        if (strcmp(verbs[i].verb, verb) == 0)
            return format_in(p->arena, verbs[i].assignment, name, name);
    return NULL;
}

// Returns the remainder that `k mod 2` means; NULL if the operand on the right is no single value.
static const char *format_remainder(const Parser *p, const AstExpr *e)
{
    uint32_t at = p->ahead.at;
    const char *left = parser_text(p, e->span), *right = p->ahead.first ? "" : hint_read_word(p, &at);

    return *right ? format_in(p->arena, "%s - %s * floor(%s / %s)", left, right, left, right) : NULL;
}

bool hint_label_prose(Parser *p, Diag *d, const AstExpr *e)
{
    const bool is_guard = !p->ahead.first && (p->ahead.kind == TOK_COLON || p->ahead.kind == TOK_LBRACE);
    const char *word = e->name->text, *text = format_verb(p, word);

    if (strcmp(word, "print") == 0) {
        if (p->kind == FILE_SS)
            diag_label(p->diags, d, DIAG_label_write, format_in(p->arena, "@print %s", p->tok.text->text));
        else
            diag_label(p->diags, d, DIAG_label_print_in_script);
        return true;
    }
    if (strcmp(word, "string") == 0 || strcmp(word, "String") == 0 || strcmp(word, "str") == 0) {
        diag_label(p->diags, d, DIAG_label_no_texts);
        return true;
    }
    if (is_guard && (strcmp(word, "state") == 0 || strcmp(word, "in") == 0)) {
        text = format_in(p->arena, "S == %s", p->tok.text->text);
        diag_edit(p->diags, d, span_join(e->span, parser_token_span(p)), text);
    } else if (hint_is_word(&p->tok, "for")) {
        text = hint_format_held(p, e);
    } else if (hint_is_word(&p->tok, "mod")) {
        text = format_remainder(p, e);
    }
    if (text)
        diag_label(p->diags, d, DIAG_label_write, text);
    return text != NULL;
}

// ---- after a statement ----

// Reports a duration after an assignment, as in v = true for 1 s.
HintResult hint_report_duration(HintCase *c)
{
    Parser *p = c->p;
    const char *text = p->lex.src->text;
    uint32_t at = p->ahead.at, from = p->tok.at, end = p->tok.at;
    const char *number = hint_read_word(p, &at), *unit = hint_read_word(p, &at), *known = hint_find_synonym(HINT_UNITS, unit);
    const char *statement, *time;

    if (p->kind == FILE_RQ || !lex_is_digit(*number))
        return HINT_NONE;
    while (from > 0 && !strchr("\n:{}", text[from - 1]))
        from--;
    from += (uint32_t)strspn(text + from, " \t");
    while (end > from && (text[end - 1] == ' ' || text[end - 1] == '\t'))
        end--;
    statement = parser_text(p, (Span){p->lex.src, from, end - from});
    if (!strchr(statement, '='))
        return HINT_NONE;
    time = hint_is_time_unit(unit) ? format_in(p->arena, "%s %s", number, known ? known : unit) : number;
    diag_label(p->diags, hint_report_general(c), p->kind == FILE_SS ? DIAG_label_duration_in_script : DIAG_label_duration, statement, time);
    return HINT_READ;
}

// Reports `default:`, the last case of a switch in other languages, unless a variable has that name.
HintResult hint_report_default(HintCase *c)
{
    Parser *p = c->p;

    if (p->tok.text->declared)
        return HINT_NONE;
    diag_label(p->diags, parser_fail(p, DIAG_foreign_word, parser_token_span(p), p->tok.text->text), DIAG_label_write, "else");
    parser_advance(p);
    return HINT_SKIPPED;
}
