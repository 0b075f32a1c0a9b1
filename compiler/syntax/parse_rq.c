// SPDX-License-Identifier: Apache-2.0
// Parses a file of requirements (docs/requirements.md): each is a name, a text in quotes, and what must never or always be.
#include "compiler/syntax/ast_rq.h"
#include "compiler/syntax/hints.h"
#include "compiler/syntax/parser.h"

#define EXAMPLE "R1 \"no pyro on the pad\" never S == Pad and drogue"

// Whether the next tokens begin a requirement.
bool parser_at_requirement(const Parser *p)
{
    return p->tok.first && p->tok.kind == TOK_NAME && p->ahead.kind == TOK_TEXT && !p->ahead.first;
}

bool parser_is_word(const Parser *p, const char *word)
{
    return p->tok.kind == TOK_NAME && !p->tok.first && strcmp(p->tok.text->text, word) == 0;
}

// Consumes the next token if it is this word. Otherwise reports what was expected, and returns false.
static bool expect_word(Parser *p, const char *word)
{
    if (!p->failed && !parser_is_word(p, word))
        parser_fail(p, DIAG_requirement_word, parser_missing_span(p), word, parser_describe_found(p));
    if (p->failed)
        return false;
    parser_advance(p);
    return true;
}

// ---- what must never or always be ----

// Reports an operand of before, after or without that is neither a name nor in parentheses.
static void check_operand(Parser *p, const AstExpr *e, const char *word)
{
    Diag *d;

    if (p->failed || e->kind == AST_NAME || e->kind == AST_PAREN || e->kind == AST_ERROR)
        return;
    d = parser_report(p, DIAG_requirement_operand, e->span, word);
    diag_label(p->diags, d, DIAG_label_write, format_in(p->arena, "(%s)", parser_text(p, e->span)));
    diag_edit(p->diags, d, (Span){e->span.src, e->span.at, 0}, "(");
    diag_edit(p->diags, d, (Span){e->span.src, e->span.at + e->span.len, 0}, ")");
}

static AstExpr *parse_operand(Parser *p, const char *word)
{
    AstExpr *e = parse_condition_of(p);

    check_operand(p, e, word);
    return e;
}

static void parse_never(Parser *p, AstRequirement *r)
{
    r->a = parse_condition_of(p);
    if (parser_is_word(p, "before") || parser_is_word(p, "after")) {
        const char *word = p->tok.text->text;
        r->kind = word[0] == 'b' ? AST_NEVER_BEFORE : AST_NEVER_AFTER;
        check_operand(p, r->a, word);
        parser_advance(p);
        r->b = parse_operand(p, word);
        if (r->kind == AST_NEVER_AFTER && expect_word(p, "without"))
            r->c = parse_operand(p, "without");
        return;
    }
    if (!p->failed && r->a->kind == AST_IMPLIES)
        diag_label(p->diags, parser_fail(p, DIAG_never_implies, ast_op_span(r->a)), DIAG_label_write,
                   format_in(p->arena, "always %s %s not (%s)", parser_text(p, r->a->a->span), parser_is_word(p, "within") ? "leads to" : "implies",
                             parser_text(p, r->a->b->span)));
}

static void parse_always(Parser *p, AstRequirement *r)
{
    r->kind = AST_ALWAYS;
    r->a = parse_condition_of(p);
    if (!parser_is_word(p, "leads"))
        return;
    r->kind = AST_LEADS_TO;
    parser_advance(p);
    if (!expect_word(p, "to"))
        return;
    r->b = parse_condition_of(p);
    if (expect_word(p, "within"))
        r->within = parse_value_of(p, false);
}

// Parses `never …` or `always …`. The word can be on the line after the text.
static void parse_demand(Parser *p, AstRequirement *r)
{
    const char *word;

    if (hint_explain(p, HINT_AT_DEMAND, NULL) == HINT_SKIPPED)
        return;
    word = p->tok.kind == TOK_NAME && !parser_at_requirement(p) ? p->tok.text->text : "";
    if (strcmp(word, "never") != 0 && strcmp(word, "always") != 0) {
        parser_fail(p, DIAG_requirement_kind, parser_missing_span(p), parser_describe_found(p));
        return;
    }
    parser_advance(p);
    if (strcmp(word, "never") == 0)
        parse_never(p, r);
    else
        parse_always(p, r);
}

// ---- a requirement ----

// Whether the current line begins with a word that belongs to the requirement of the line above.
static bool at_continuation(Parser *p)
{
    static const char *const word[] = {"leads", "to", "implies", "within", "before", "after", "without", "and", "or"};
    const char *text = parser_text(p, parser_token_span(p));

    for (size_t i = 0; i < sizeof word / sizeof *word; i++)
        if (strcmp(text, word[i]) == 0)
            return true;
    return false;
}

// Reports text that begins no requirement.
static void report_other_line(Parser *p)
{
    Diag *d;

    if (p->tok.kind == TOK_ERROR)
        p->failed = true;
    if (p->tok.kind == TOK_HEADER) {
        d = parser_fail(p, DIAG_requirement_section, parser_token_span(p));
        diag_label(p->diags, d, strcmp(p->tok.text->text, "define") == 0 ? DIAG_label_define_in_machine : DIAG_label_leave_out);
        return;
    }
    if (p->tok.first && at_continuation(p)) {
        parser_fail(p, DIAG_requirement_goes_on, parser_token_span(p), parser_text(p, parser_token_span(p)));
        return;
    }
    if (p->tok.kind == TOK_NAME && p->tok.first && (p->ahead.first || p->ahead.kind == TOK_END))
        d = parser_fail(p, DIAG_requirement_text, parser_span(p, &p->tok), p->tok.text->text, "the end of the line");
    else if (p->tok.kind == TOK_NAME && p->ahead.at == p->tok.at + p->tok.len &&
             (p->ahead.kind == TOK_MINUS || p->ahead.kind == TOK_LABEL || p->ahead.kind == TOK_NUMBER)) {
        diag_label(p->diags, parser_fail(p, DIAG_requirement_line, parser_span(p, &p->ahead), parser_describe(p, &p->ahead)),
                   DIAG_label_name_letters);
        return;
    }
    else if (p->tok.kind == TOK_NAME && (p->ahead.kind == TOK_COLON || p->ahead.kind == TOK_MINUS)) {
        d = parser_fail(p, DIAG_requirement_text, parser_span(p, &p->ahead), p->tok.text->text, parser_describe(p, &p->ahead));
        diag_label(p->diags, d, DIAG_label_leave_out);
        return;
    } else if (p->tok.kind == TOK_NAME)
        d = parser_fail(p, DIAG_requirement_text, parser_span(p, &p->ahead), p->tok.text->text, parser_describe(p, &p->ahead));
    else
        d = parser_fail(p, DIAG_requirement_line, parser_token_span(p), parser_describe(p, &p->tok));
    diag_label(p->diags, d, DIAG_label_as_in, EXAMPLE);
}

static void parse_requirement(Parser *p, AstRequirements *into)
{
    AstRequirement r = {.id = p->tok.text, .id_span = parser_token_span(p), .text = p->ahead.text};

    if (strspn(r.text->text, " \t") == r.text->len)
        parser_report(p, DIAG_requirement_text, parser_span(p, &p->ahead), r.id->text, "an empty text");
    parser_advance(p);
    parser_advance(p);
    parse_demand(p, &r);
    r.span = parser_span_since(p, r.id_span.at);
    if (!p->failed && p->tok.kind != TOK_END && !p->tok.first)
        hint_explain(p, HINT_AT_END, r.a);
    if (!p->failed)
        vec_push(p->arena, &into->at, r);
}

// After an error: skips to the next line that begins a requirement.
static void recover(Parser *p, AstRequirements *into)
{
    into->lost = true;
    while (p->tok.kind != TOK_END && !parser_at_requirement(p))
        parser_advance(p);
}

void parse_requirements(Parser *p, AstRequirements *into)
{
    const size_t errors = p->diags->errors_seen;

    while (p->tok.kind != TOK_END) {
        p->failed = false;
        if (parser_at_requirement(p))
            parse_requirement(p, into);
        else
            report_other_line(p);
        if (p->failed)
            recover(p, into);
    }
    p->failed = false;
    into->lost = into->lost || p->diags->errors_seen > errors;
    if (into->at.n == 0 && !into->lost)
        diag_label(p->diags, parser_report(p, DIAG_requirements_none, (Span){p->lex.src, 0, 0}), DIAG_label_as_in, EXAMPLE);
}
