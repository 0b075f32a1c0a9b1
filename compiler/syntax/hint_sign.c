// SPDX-License-Identifier: Apache-2.0
// Hints about signs of other languages at the start of a statement: --> Idle, ++x, *p = 1, this->x = 1.
#include <string.h>

#include "compiler/syntax/hint_rules.h"

// Reports an arrow that is too long, as in --> Idle, and reads it as ->.
HintResult hint_report_long_arrow(HintCase *c)
{
    Parser *p = c->p;
    const Span sign = {p->lex.src, p->tok.at, p->ahead.at + p->ahead.len - p->tok.at};
    Diag *d = parser_report(p, DIAG_foreign_operator, sign, parser_text(p, sign), "->");

    diag_label(p->diags, d, DIAG_label_write, "->");
    diag_edit(p->diags, d, sign, "->");
    parser_advance(p);
    return HINT_READ;
}

// Reports ++x and --x.
HintResult hint_report_increment_first(HintCase *c)
{
    Parser *p = c->p;
    const Span sign = {p->lex.src, p->tok.at, 2};
    uint32_t at = p->ahead.at + 1;
    const char *text = parser_text(p, sign), *name = hint_read_word(p, &at);

    at += (uint32_t)strspn(p->lex.src->text + at, " \t\r");
    if (p->tok.kind != p->ahead.kind || !hint_are_adjacent(&p->tok, &p->ahead) || !lex_is_identifier(name, strlen(name)) ||
        (p->lex.src->text[at] && !strchr(";#}\n", p->lex.src->text[at])) || hint_line_is_guard(p))            // the condition --x > 5 is -(-x) > 5
        return HINT_NONE;
    diag_label(p->diags, parser_fail(p, DIAG_op_assign, sign, text), DIAG_label_write, format_in(p->arena, "%s = %s %c 1", name, name, *text));
    parser_advance(p);
    return HINT_SKIPPED;
}

// Reports a formula as in a cell of a spreadsheet: = x + 1.
HintResult hint_report_target_missing(HintCase *c)
{
    Parser *p = c->p;
    const char *text = p->lex.src->text;
    uint32_t end = p->ahead.at + (uint32_t)strcspn(text + p->ahead.at, "#;}\r\n");
    Diag *d = parser_fail(p, DIAG_expected_statement, parser_token_span(p), "'='");

    while (end > p->ahead.at && (text[end - 1] == ' ' || text[end - 1] == '\t'))
        end--;
    diag_label(p->diags, d, DIAG_label_target_missing,
               p->ahead.first || end == p->ahead.at ? "..." : parser_text(p, (Span){p->lex.src, p->ahead.at, end - p->ahead.at}));
    parser_advance(p);
    return HINT_SKIPPED;
}

// Reports *p = 1.
HintResult hint_report_dereference(HintCase *c)
{
    Parser *p = c->p;

    diag_label(p->diags, parser_fail(p, DIAG_expected_statement, parser_token_span(p), "'*'"), DIAG_label_no_pointers);
    parser_advance(p);
    return HINT_SKIPPED;
}

// Reports this->x = 1.
HintResult hint_report_member(HintCase *c)
{
    Parser *p = c->p;
    const char *after = p->lex.src->text + p->ahead.at + p->ahead.len;

    if (p->has_if || c->e->kind != AST_NAME || c->e->name->declared || after[strspn(after, " \t")] != '=')
        return HINT_NONE;
    diag_label(p->diags, parser_fail(p, DIAG_name_with_dot, span_join(c->e->span, parser_span(p, &p->ahead)),
                                     format_in(p->arena, "%s->%s", c->e->name->text, p->ahead.text->text)), DIAG_label_write, p->ahead.text->text);
    c->e->kind = AST_ERROR;
    return HINT_SKIPPED;
}
