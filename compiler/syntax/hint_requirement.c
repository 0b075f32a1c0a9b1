// SPDX-License-Identifier: Apache-2.0
// Hints in requirements: other languages' spellings of time limits and consequences, as in `always a implies b within 1 s` for `leads to`.
#include <string.h>

#include "compiler/syntax/hint_rules.h"

// Returns the text from `at` to the end of its line, without blanks and comments at its end.
static Span rest_of_line(const Parser *p, uint32_t at)
{
    const char *text = p->lex.src->text;
    uint32_t end = at + (uint32_t)strcspn(text + at, "#;\r\n");

    while (end > at && (text[end - 1] == ' ' || text[end - 1] == '\t'))
        end--;
    return (Span){p->lex.src, at, end - at};
}

static bool is_one_of(const Token *t, const char *const *words, size_t n)
{
    bool found = false;

    for (size_t i = 0; i < n; i++)
        found = found || hint_is_word(t, words[i]);
    return found;
}

// ---- before never and always ----

// Reports and skips a sign between the text and the demand, as in R1 "no fire": never fire.
HintResult hint_skip_sign_before_demand(HintCase *c)
{
    Parser *p = c->p;
    const Span sign = parser_token_span(p);
    Diag *d;

    if (!hint_is_word(&p->ahead, "never") && !hint_is_word(&p->ahead, "always"))
        return HINT_NONE;
    d = parser_report(p, DIAG_requirement_kind, sign, parser_describe(p, &p->tok));
    diag_label(p->diags, d, DIAG_label_leave_out);
    diag_edit(p->diags, d, sign, "");
    parser_advance(p);
    return HINT_READ;
}

// Labels d with the requirement for `if p > 50 then valve`, whose condition is at `condition`.
static void label_consequence(Parser *p, Diag *d, uint32_t condition)
{
    const char *text = parser_text(p, rest_of_line(p, condition)), *then = strstr(text, " then "), *sign = strpbrk(text, ",:");
    const char *end = then ? then : sign, *rest = then ? then + strlen(" then ") : sign ? sign + 1 + strspn(sign + 1, " ") : "";

    if (end)
        diag_label(p->diags, d, DIAG_label_write,
                   format_in(p->arena, "always %.*s %s %s", (int)(end - text), text, strstr(rest, " within ") ? "leads to" : "implies", rest));
    else
        diag_label(p->diags, d, DIAG_label_write, format_in(p->arena, "always %s implies ...", text));
}

// Whether the text can be a condition: it has a comparison or is one word, and no verbs of a sentence.
static bool is_condition(const char *text)
{
    static const char *const verbs[] = {" must ", " shall ", " should ", " is ",  " be ", " has ",
                                        " may ",  " can ",   " never",   " always", ":",   "{"};
    bool can_be = strpbrk(text, "<>=") || !strchr(text, ' ');

    for (size_t i = 0; i < sizeof verbs / sizeof *verbs; i++)
        can_be = can_be && !strstr(text, verbs[i]);
    return can_be;
}

// Reports always if x > 5 then valve.
HintResult hint_report_demand_if(HintCase *c)
{
    Parser *p = c->p;

    if (p->kind != FILE_RQ || !hint_is_word(&p->last, "always"))
        return HINT_NONE;
    label_consequence(p, hint_report_general(c), p->ahead.at);
    return HINT_READ;
}

// Reports a word that is neither `never` nor `always`, where a requirement must have one of these.
HintResult hint_report_demand_word(HintCase *c)
{
    static const char *const words[] = {"never", "always"}, *const ifs[] = {"if", "when", "whenever", "while"},
                      *const alwayses[] = {"assert", "must", "shall", "should", "require", "globally", "invariant", "forall", "expect",
                                           "ensure", "return", "verify", "check"},
                      *const some_times[] = {"eventually", "finally", "sometimes", "once"};
    Parser *p = c->p;
    const char *word = p->tok.kind == TOK_NAME && !parser_at_requirement(p) ? p->tok.text->text : "", *near;
    const bool is_below = p->tok.first && (*word || p->tok.kind == TOK_IF);       // the demand is on the line after the text
    Diag *d;

    if (strcmp(word, "never") == 0 || strcmp(word, "always") == 0)
        return HINT_NONE;
    if (p->tok.kind == TOK_ERROR)
        p->failed = true;
    d = parser_fail(p, DIAG_requirement_kind, is_below ? parser_token_span(p) : parser_missing_span(p),
                    is_below ? parser_describe(p, &p->tok) : parser_describe_found(p));
    if (p->tok.first && !is_below)
        return HINT_SKIPPED;
    if (p->tok.kind == TOK_IF || is_one_of(&p->tok, ifs, sizeof ifs / sizeof *ifs))
        label_consequence(p, d, p->ahead.at);
    else if (is_one_of(&p->tok, alwayses, sizeof alwayses / sizeof *alwayses))
        diag_label(p->diags, d, DIAG_label_write, format_in(p->arena, "always %s", parser_text(p, rest_of_line(p, p->ahead.at))));
    else if (is_one_of(&p->tok, some_times, sizeof some_times / sizeof *some_times))
        diag_label(p->diags, d, DIAG_label_leads_to, "CONDITION", parser_text(p, rest_of_line(p, p->ahead.at)), "within 500 ms");
    else if ((near = str_nearest(word, words, 2)) != NULL)
        diag_label(p->diags, d, DIAG_label_did_you_mean, near);
    else if (is_condition(parser_text(p, rest_of_line(p, p->tok.at))))
        diag_label(p->diags, d, DIAG_label_never_or_always, parser_text(p, rest_of_line(p, p->tok.at)));
    else
        diag_label(p->diags, d, DIAG_label_never_or_always_condition);
    return HINT_SKIPPED;
}

// ---- after a condition ----

// Reports a time limit without `leads to`, as in a implies b within 1 s. The current token is `within`.
static void report_limit(HintCase *c)
{
    Parser *p = c->p;
    Diag *d = hint_report_general(c);
    AstExpr *e = c->e;

    if (e->kind == AST_IMPLIES) {
        diag_label(p->diags, d, DIAG_label_leads_to_within, parser_text(p, e->a->span), parser_text(p, e->b->span),
                   parser_text(p, rest_of_line(p, p->tok.at)));
        diag_edit(p->diags, d, ast_op_span(e), "leads to");
    } else {
        const char *limit = parser_text(p, rest_of_line(p, p->tok.at)), *after = strstr(limit, " after ");
        diag_label(p->diags, d, DIAG_label_leads_to, after ? after + strlen(" after ") : "CONDITION", parser_text(p, e->span),
                   after ? format_in(p->arena, "%.*s", (int)(after - limit), limit) : limit);
    }
}

// Reports a time for which a condition is true, as in never valve for 5 s. The current token is the word.
static bool report_duration(HintCase *c)
{
    Parser *p = c->p;
    Span rest, whole;
    const char *time, *text;
    Diag *d;

    if (p->ahead.kind != TOK_NUMBER || p->ahead.first)
        return false;
    rest = rest_of_line(p, p->ahead.at);
    whole = span_join(c->e->span, rest);
    time = parser_text(p, rest);
    text = format_in(p->arena, "held(%s, %s)", parser_text(p, c->e->span), time);
    d = hint_report_general(c);
    diag_label(p->diags, d, DIAG_label_write, text);
    if (strspn(time, "0123456789. mus") == strlen(time))
        diag_edit(p->diags, d, whole, text);
    return true;
}

// Reports a consequence that is written as in other languages: a -> b, a then b.
static void report_consequence(HintCase *c)
{
    Parser *p = c->p;
    const Span sign = parser_token_span(p);
    const bool is_phrase = c->e->kind != AST_IMPLIES;
    Diag *d = hint_report_general(c);

    diag_label(p->diags, d, DIAG_label_write, is_phrase ? "implies" : "and before 'implies': a and b implies c");
    if (is_phrase)
        diag_edit(p->diags, d, sign, "implies");
}

// Reports text after the condition of a requirement.
HintResult hint_report_requirement_end(HintCase *c)
{
    Parser *p = c->p;

    if (p->kind != FILE_RQ || !c->e)
        return HINT_NONE;
    if (hint_is_word(&p->tok, "within"))
        report_limit(c);
    else if (p->tok.kind == TOK_ARROW || hint_is_word(&p->tok, "then"))
        report_consequence(c);
    else if (hint_is_word(&p->tok, "after") && c->e->kind == AST_IMPLIES && p->ahead.kind == TOK_NUMBER)
        diag_label(p->diags, hint_report_general(c), DIAG_label_leads_to_after, parser_text(p, c->e->a->span),
                   parser_text(p, c->e->b->span), parser_text(p, rest_of_line(p, p->ahead.at)));
    else if (!(hint_is_word(&p->tok, "for") || hint_is_word(&p->tok, "during")) || !report_duration(c))
        return HINT_NONE;
    return HINT_SKIPPED;
}
