// SPDX-License-Identifier: Apache-2.0
// Hints in statements: words of other languages, conditions without their statements, values where a statement should be.
#include "compiler/syntax/hint_lines.h"
#include "compiler/syntax/hint_rules.h"
#include "compiler/syntax/hint_unit.h"
#include "compiler/syntax/hint_words.h"
#include "compiler/syntax/lexer.h"
#include "compiler/syntax/time_unit.h"

// ---- the rest of the line ----

// Returns the word or number after spaces at *at, and moves *at to its end; returns "" if neither follows.
const char *hint_read_word(const Parser *p, uint32_t *at)
{
    const char *text = p->lex.src->text;
    uint32_t from, end;

    for (from = *at; text[from] == ' '; from++)
        ;
    for (end = from; lex_is_letter(text[end]) || lex_is_digit(text[end]) || text[end] == '.'; end++)
        ;
    *at = end;
    return parser_text(p, (Span){p->lex.src, from, end - from});
}

// Returns the value at *at, with its unit if that is a time, and moves *at to its end.
const char *hint_read_value(const Parser *p, uint32_t *at)
{
    const char *value = hint_read_word(p, at);
    uint32_t end = *at;
    const char *unit = hint_read_word(p, &end);

    if (!lex_is_digit(*value) || time_unit_find(unit) == TIME_NONE)
        return value;
    *at = end;
    return format_in(p->arena, "%s %s", value, unit);
}

// Returns the advice to write a <= x <= b for `x between a and b`. The current token is `between`; e is x.
static const char *format_between(const Parser *p, const AstExpr *e)
{
    uint32_t at = p->ahead.at;
    const char *lo = hint_read_value(p, &at);
    const bool known = strcmp(hint_read_word(p, &at), "and") == 0;
    const char *hi = known ? hint_read_value(p, &at) : "";

    return format_in(p->arena, "write %s <= %s <= %s", *hi ? lo : "3", parser_text(p, e->span), *hi ? hi : "5");
}

// Returns the advice for `x > 5 for 3 s` and `x > 5 for 3 samples`. The current token is `for`; e is the condition.
const char *hint_format_held(const Parser *p, const AstExpr *e)
{
    uint32_t at = p->ahead.at;
    const char *n = hint_read_word(p, &at), *unit = hint_read_word(p, &at), *known = hint_find_synonym(HINT_UNITS, unit);
    const bool is_number = lex_is_digit(*n), is_time = time_unit_find(known ? known : unit) != TIME_NONE;

    return format_in(p->arena, "held(%s, %s %s)", parser_text(p, e->span), is_number ? n : "500", is_time ? known ? known : unit : is_number ? "steps" : "ms");
}

// ---- after a guard ----

// Reports = after an expression that is not a name, as in x + 1 = 3.
HintResult hint_report_assign_to_expression(HintCase *c)
{
    Parser *p = c->p;

    if (hint_line_is_guard(p)) {
        hint_report_assign_in_guard(p, c->e, parser_token_span(p));
        p->failed = true;
    } else {
        parser_fail(p, DIAG_assign_target, c->e->span, parser_text(p, c->e->span));
    }
    return HINT_SKIPPED;
}

// Reports two names in a row, as in close valve: prose, or a statement of another language.
HintResult hint_report_no_statement(HintCase *c)
{
    Parser *p = c->p;
    AstExpr *e = c->e;
    Diag *d;

    if (p->has_if || e->kind != AST_NAME || hint_is_word(&p->tok, "then"))
        return HINT_NONE;
    d = parser_fail(p, DIAG_no_statement, e->span, e->name->text);
    if (hint_is_word(&p->tok, "between"))
        diag_label(p->diags, d, DIAG_label_text, format_between(p, e));
    else if (!hint_label_prose(p, d, e))
        diag_label(p->diags, d, DIAG_label_statements);
    e->kind = AST_ERROR;
    return HINT_SKIPPED;
}

// Returns the start of the text on the line of `at`.
static uint32_t start_of_line(const Parser *p, uint32_t at)
{
    const char *text = p->lex.src->text;

    while (at > 0 && text[at - 1] != '\n')
        at--;
    return at + (uint32_t)strspn(text + at, " \t");
}

// Reports `then` in if x then ..., and reads it as a colon.
HintResult hint_read_then(HintCase *c)
{
    Parser *p = c->p;
    uint32_t from = p->last.at + p->last.len;
    Diag *d = parser_report(p, DIAG_foreign_word, parser_token_span(p), p->tok.text->text);

    if (p->ahead.first) {
        const uint32_t line = start_of_line(p, p->tok.at), end = hint_brace_indented_lines(p->diags, d, p->lex.src, p->tok.at, p->tok.len);
        d->follows = hint_follows_indented(p, line);
        diag_label(p->diags, d, DIAG_label_braces_instead);
        hint_cover_indented(p);
        p->indented = end > p->indented ? end : p->indented;
    } else {
        uint32_t end = 0;
        const uint32_t closing = hint_find_end_if(p->lex.src, p->ahead.at, &end);
        diag_label(p->diags, d, DIAG_label_colon_instead);
        if (closing) {                        // y := 1; END_IF;
            diag_edit(p->diags, d, (Span){p->lex.src, closing, end - closing}, "");
            p->lex.hinted = end;
            p->open_blocks++;
        }
        if (p->ahead.kind != TOK_NUMBER && (closing || p->ahead.kind == TOK_COLON || !hint_is_first_of_several(p->lex.src, p->ahead.at)))
            diag_edit(p->diags, d, (Span){p->lex.src, from, p->tok.at + p->tok.len - from}, p->ahead.kind == TOK_COLON ? "" : ":");
    }
    parser_advance(p);
    if (p->tok.kind == TOK_COLON && !p->tok.first)
        parser_advance(p);
    return HINT_READ;
}

// Reports a unit after the last number of a guard, as in `T > 5 s: ...`.
HintResult hint_report_unit_in_guard(HintCase *c)
{
    Parser *p = c->p;

    if (!(p->lex.src->text[p->tok.at] & 0x80))         // a word such as ° that is not ASCII is already reported
        hint_label_unit(p->diags, parser_report(p, DIAG_expected_end, parser_token_span(p), parser_describe(p, &p->tok)),
                        parser_text(p, parser_span(p, &p->last)),
                        format_in(p->arena, "%.*s", (int)strcspn(p->lex.src->text + p->tok.at, " \t:{"), p->lex.src->text + p->tok.at),
                        span_join(parser_span(p, &p->last), parser_token_span(p)));
    p->failed = true;
    return HINT_SKIPPED;
}

// Reports a comma where the colon should be, as in x > 5, y = 1.
HintResult hint_report_comma_for_colon(HintCase *c)
{
    Parser *p = c->p;

    if (c->e->kind == AST_NAME)
        return HINT_NONE;
    diag_label(p->diags, parser_fail(p, DIAG_guard_without_body, parser_gap_span(p), parser_describe_found(p)),
               hint_line_is_guard(p) ? DIAG_label_and_instead : DIAG_label_colon_instead);            // in `x > 5, y:` the comma means `and`
    return HINT_SKIPPED;
}

// Reports text after a guard that is not a statement, as in `x between 3 and 5: ...`, where inserting a colon would not help.
HintResult hint_report_prose_in_guard(HintCase *c)
{
    Parser *p = c->p;
    Diag *d;

    if (!hint_line_is_guard(p))
        return HINT_NONE;
    d = parser_fail(p, DIAG_guard_without_body, parser_token_span(p), parser_describe_found(p));
    if (hint_is_word(&p->tok, "between"))
        diag_label(p->diags, d, DIAG_label_text, format_between(p, c->e));
    else if (hint_is_word(&p->tok, "for"))
        diag_label(p->diags, d, DIAG_label_write, hint_format_held(p, c->e));
    return HINT_SKIPPED;
}

// Whether the current token is an arrow spelled => or as one character, as in p > 5 => Idle. The lexer has then already reported the missing
// colon.
static bool is_foreign_arrow(const Parser *p)
{
    const char first = p->lex.src->text[p->tok.at];

    return p->tok.kind == TOK_ARROW && (first == '=' || (first & 0x80));
}

// Proposes to insert a colon after the guard, unless more statements follow: then it is unclear which of them the guard controls.  Text that an
// earlier edit removes, as the `end if` of a conditional, needs no colon.
static void propose_colon(Parser *p, Diag *d)
{
    if (p->tok.at >= p->lex.hinted && !hint_is_first_of_several(p->lex.src, p->tok.at))
        diag_edit(p->diags, d, parser_gap_span(p), ":");
}

// Reports the colon missing between a guard and a statement on its line, as in x > 5 y = 1.
HintResult hint_report_missing_colon(HintCase *c)
{
    Parser *p = c->p;
    Diag *d;

    if (is_foreign_arrow(p))
        return HINT_READ;
    d = parser_report(p, DIAG_guard_without_body, parser_gap_span(p), parser_describe_found(p));
    diag_label(p->diags, d, DIAG_label_insert_colon);
    propose_colon(p, d);
    return HINT_READ;
}

static bool is_label_name(const AstExpr *e) { return e->kind == AST_NAME && hint_is_label(e->name->text) && !e->name->declared; }

// Reports a label such as `entry` that lacks its dot, and proposes to insert the dot.
static Diag *report_label_without_dot(Parser *p, AstExpr *e)
{
    Diag *d = parser_report(p, DIAG_label_without_dot, e->span, e->name->text);

    diag_edit(p->diags, d, (Span){e->span.src, e->span.at, 0}, ".");
    e->kind = AST_ERROR;
    return d;
}

// Reports a label without its dot: `step` on a line of its own.
HintResult hint_report_label_alone(HintCase *c)
{
    if (c->p->has_if || !is_label_name(c->e) || !parser_at_end_of_statement(c->p))
        return HINT_NONE;
    report_label_without_dot(c->p, c->e);
    return HINT_READ;
}

// ---- a value alone on its line ----

// Reports a value alone on its line if the next line begins with `and` or `or`, and skips that next line.
HintResult hint_skip_rest_of_guard(HintCase *c)
{
    Parser *p = c->p;

    diag_label(p->diags, hint_report_general(c), DIAG_label_line_break);
    do
        parser_advance(p);
    while (!p->tok.first && p->tok.kind != TOK_RBRACE);
    return HINT_READ;
}

// Reports a comparison as a statement, as in valveOpen == true.
HintResult hint_report_comparison_alone(HintCase *c)
{
    Parser *p = c->p;
    const AstExpr *e = c->e;

    if (e->kind != AST_BINARY)
        return HINT_NONE;
    if (p->kind == FILE_SS)
        diag_label(p->diags, hint_report_general(c), DIAG_label_write_assert, parser_text(p, e->span));
    else if (e->op == SM_OP_EQ && e->a->kind == AST_NAME)
        diag_label(p->diags, hint_report_general(c), DIAG_label_store,
                   format_in(p->arena, "%s = %s", e->a->name->text, parser_text(p, e->b->span)));
    else if (e->op >= SM_OP_EQ && e->op <= SM_OP_GE) {
        diag_label(p->diags, hint_report_general(c), DIAG_label_condition_alone);
        if (p->tok.kind == TOK_ARROW && p->indented <= p->tok.at)      // the transition below probably depends on the condition
            p->indented = p->tok.at + 1;
    } else
        return HINT_NONE;
    return HINT_READ;
}

// ---- after a colon, else and -> ----

// Reports a label without its dot and with a colon: `step:` on a line of its own.
HintResult hint_report_label_with_colon(HintCase *c)
{
    Parser *p = c->p;
    const Span colon = parser_span(p, &p->last);

    if (!c->e || !is_label_name(c->e))
        return HINT_NONE;
    diag_edit(p->diags, report_label_without_dot(p, c->e), colon, "");
    return HINT_READ;
}

// Reports a line that ends after the colon of a guard, or of `else` (c->e is NULL).
HintResult hint_report_line_end_after_colon(HintCase *c)
{
    Parser *p = c->p;
    const Span colon = parser_span(p, &p->last);
    Diag *d = parser_report(p, DIAG_colon_line_break, colon, c->e ? "the condition" : "'else'", parser_describe_found(p));

    d->follows = !c->e && hint_follows_indented(p, start_of_line(p, colon.at));
    if (c->e && c->e->kind == AST_NAME && !c->e->name->declared && !p->has_if && p->kind == FILE_SM &&
        (c->e->span.at == 0 || p->lex.src->text[c->e->span.at - 1] == '\n')) {        // Hold:
        diag_label(p->diags, d, DIAG_label_perhaps_state, c->e->name->text, c->e->name->text);
        c->e->kind = AST_ERROR;
        return HINT_READ;
    }
    if (p->tok.first && p->tok.kind != TOK_ELSE && !parser_at_end_of_block(p)) {
        diag_label(p->diags, d, DIAG_label_braces_instead);
        const uint32_t end = hint_brace_indented_lines(p->diags, d, colon.src, colon.at, 1);
        p->indented = end > p->indented ? end : p->indented;
    } else {
        diag_label(p->diags, d, DIAG_label_statement_here);
    }
    diag_note(p->diags, d, (Span){0}, DIAG_note_write_braces, c->e ? parser_text(p, c->e->span) : "else");
    return HINT_READ;
}

// Reports a = after a colon, as in x: = 1.
HintResult hint_report_assign_after_colon(HintCase *c)
{
    Parser *p = c->p;
    Diag *d = parser_fail(p, DIAG_expected_statement, parser_token_span(p), "'='");

    if (c->e && c->e->kind == AST_NAME) {
        diag_label(p->diags, d, DIAG_label_store, format_in(p->arena, "%s = ...", c->e->name->text));
        diag_edit(p->diags, d, parser_span(p, &p->last), "");
    }
    return HINT_SKIPPED;
}

// Reports `else` without a colon or brace, as in else x = 1.
HintResult hint_report_else_without_body(HintCase *c)
{
    Parser *p = c->p;
    Diag *d;

    if (is_foreign_arrow(p))
        return HINT_READ;
    d = parser_report(p, DIAG_else_without_body, parser_gap_span(p), parser_describe_found(p));
    if (p->tok.first && hint_follows_indented(p, p->last.at)) {
        d->follows = true;
        const uint32_t end = hint_brace_indented_lines(p->diags, d, p->lex.src, p->last.at + p->last.len, 0);
        p->indented = end > p->indented ? end : p->indented;
    }
    if (!p->tok.first && !parser_at_end_of_block(p)) {
        diag_label(p->diags, d, DIAG_label_insert_colon);
        propose_colon(p, d);
    }
    return HINT_READ;
}

// Reports brackets around the state in -> [Idle].
HintResult hint_skip_bracketed_state(HintCase *c)
{
    Parser *p = c->p;
    Diag *d = parser_report(p, DIAG_transition_without_state, parser_token_span(p), parser_describe(p, &p->tok));

    diag_label(p->diags, d, DIAG_label_write, p->tok.text->text);
    diag_edit(p->diags, d, parser_token_span(p), p->tok.text->text);
    parser_advance(p);
    return HINT_SKIPPED;
}

// ---- a condition inside braces ----

// Returns the length of `x = 2 ` in `x = 2 -> Abort }`, which is all on one line; 0 if the text is anything else.
static uint32_t length_of_braced_guard(const char *text)
{
    const uint32_t n = (uint32_t)strcspn(text, "-:;{}#\n");
    uint32_t end = n;

    while (text[end] == '-' && text[end + 1] != '>')
        end += 1 + (uint32_t)strcspn(text + end + 1, "-:;{}#\n");
    if (text[end] != '-' || strspn(text, " \t") == end)
        return 0;
    return end;
}

// Returns the end of ` Abort }`; NULL if the text is anything else.
static const char *end_of_braced_target(const char *text)
{
    const char *at = text + strspn(text, " \t"), *name = at;

    while (lexer_is_word(*at))
        at++;
    if (at == name)
        return NULL;
    at += strspn(at, " \t");
    return *at == '}' ? at + 1 : NULL;
}

// Returns the condition, of n bytes at `text`, with == in place of each =; sets *assigns if it contains a =.
static const char *braced_condition(Parser *p, const char *text, uint32_t n, bool *assigns)
{
    Buf out;

    buf_init(&out, p->arena);
    while (n > 0 && (text[n - 1] == ' ' || text[n - 1] == '\t'))
        n--;
    for (uint32_t i = (uint32_t)strspn(text, " \t"); i < n; i++) {
        const bool is_assign = text[i] == '=' && text[i + 1] != '=' && !strchr("=<>!", text[i - 1]);
        *assigns = *assigns || is_assign;
        buf_str(&out, is_assign ? "=" : "");
        buf_char(&out, text[i]);
    }
    return buf_text(&out);
}

bool hint_report_guard_in_braces(Parser *p)
{
    const char *text = p->lex.src->text + p->tok.at + 1;
    const uint32_t n = length_of_braced_guard(text);
    const char *end = n ? end_of_braced_target(text + n + 2) : NULL, *fixed;
    bool assigns = false;
    uint32_t length;
    Diag *d;

    if (!end)
        return false;
    fixed = braced_condition(p, text, n, &assigns);
    length = (uint32_t)strcspn(text + n, "}");
    while (text[n + length - 1] == ' ' || text[n + length - 1] == '\t')
        length--;
    fixed = format_in(p->arena, "%s: %.*s", fixed, (int)length, text + n);
    d = parser_report(p, DIAG_braces_without_guard, parser_token_span(p));
    diag_label(p->diags, d, DIAG_label_write, fixed);
    if (!assigns)                                     // no edit if the braces contain a single =, which can be an assignment before the transition
        diag_edit(p->diags, d, (Span){p->lex.src, p->tok.at, (uint32_t)(end - text) + 1}, fixed);
    while (p->tok.kind != TOK_RBRACE && p->tok.kind != TOK_END)
        parser_advance(p);
    parser_advance(p);
    return true;
}

// ---- statements of other languages ----

// Reports an assignment with an operator, as in x += 1. The current token is +=.
HintResult hint_report_op_assign(HintCase *c)
{
    Parser *p = c->p;
    const char *sign = parser_text(p, parser_token_span(p)), *name = parser_text(p, parser_span(p, &p->last));
    Diag *d = parser_report(p, DIAG_op_assign, parser_token_span(p), sign);
    const char *text = p->lex.src->text;
    uint32_t end = hint_skip_operand(text, p->tok.at + p->tok.len), operand = p->tok.at + p->tok.len, operand_end = end;
    bool one_operand;                         // the right side is one operand, so it needs no parentheses

    operand += (uint32_t)strspn(text + operand, " \t");
    end += (uint32_t)strspn(text + end, " \t\r");
    one_operand = !text[end] || strchr("\n#;}", text[end]);
    if (p->kind == FILE_RQ)
        diag_label(p->diags, d, DIAG_label_changes_nothing);
    else if (one_operand)
        diag_label(p->diags, d, DIAG_label_write,
                   format_in(p->arena, "%s = %s %c %.*s", name, name, sign[0], (int)(operand_end - operand), text + operand));
    else
        diag_label(p->diags, d, DIAG_label_write, format_in(p->arena, "%s = %s %c (...)", name, name, sign[0]));
    return HINT_READ;
}
