// SPDX-License-Identifier: Apache-2.0
// Parses what only scripts have in conditions (language.md 8.39 to 8.46): whole guards by time, as in `from 1 s to 2 s:`, and `state Burn`.
// Their words are names everywhere else, so a number or a name has to follow on the line.
#include "compiler/syntax/parser.h"

const char *const parser_when_words[AST_WHENS] = {[AST_AT] = "at", [AST_FROM] = "from", [AST_AFTER] = "after", [AST_EVERY] = "every"};

AstWhen parser_find_when(const Token *t)
{
    AstWhen w = AST_AT;

    if (t->kind != TOK_NAME)
        return AST_WHENS;
    while (w < AST_WHENS && strcmp(parser_when_words[w], t->text->text) != 0)
        w++;
    return w;
}

bool parser_is_before_number(const Parser *p)
{
    return !p->ahead.first && (p->ahead.kind == TOK_NUMBER || p->ahead.kind == TOK_ERROR);
}

bool parser_at_when(const Parser *p)
{
    return p->kind == FILE_SS && parser_find_when(&p->tok) != AST_WHENS && parser_is_before_number(p);
}

// ---- guards by time ----

static AstExpr *new_node(Parser *p, AstExprKind kind)
{
    AstExpr *e = ARENA_NEW(p->arena, AstExpr);

    e->kind = kind;
    e->depth = 2;
    e->span = parser_token_span(p);
    e->op_at = e->span.at;
    e->op_len = e->span.len;
    return e;
}

// Parses a number and its unit of time into *into; returns false after reporting an error.
static bool parse_time(Parser *p, AstExpr **into)
{
    if (p->tok.kind != TOK_NUMBER) {
        p->failed = true;
        return false;
    }
    *into = parse_number(p);
    return true;
}

AstExpr *parse_when(Parser *p)
{
    AstExpr *e = new_node(p, AST_WHEN);
    bool good;

    e->when = parser_find_when(&p->tok);
    parser_advance(p);
    good = parse_time(p, &e->a);
    if (good && e->when == AST_FROM) {
        if (p->tok.kind != TOK_NAME || p->tok.first || strcmp(p->tok.text->text, "to") != 0 || !parser_is_before_number(p)) {
            hint_explain(p, HINT_AT_TO, e);
            return e;
        }
        parser_advance(p);
        good = parse_time(p, &e->b);
    }
    e->span = parser_span_since(p, e->span.at);
    if (!good)
        e->kind = AST_ERROR;
    else if (!p->tok.first && p->tok.kind != TOK_COLON && p->tok.kind != TOK_LBRACE && !parser_at_end_of_block(p))
        hint_explain(p, HINT_AFTER_WHEN, e);
    return e;
}

// ---- `state Burn` ----

// Whether the word after `state` has its own meaning there, as it had before scripts had `state NAME`.
static bool has_other_meaning(const Parser *p)
{
    const char *text = p->lex.src->text, *word = p->ahead.text->text;
    uint32_t end = p->ahead.at + p->ahead.len;

    if (strcmp(word, "steps") == 0) {
        while (text[end] == ' ' || text[end] == '\t')
            end++;
        return text[end] == ')' || text[end] == ',';
    }
    if (strcmp(word, "within") == 0)
        return p->is_expect;
    if (strcmp(word, "in") == 0) {                   // in `state in (Hold, Burn)`, `in` is no state
        const char next = text[end + strspn(text + end, " \t")];
        return next == '(' || next == '[' || lex_is_letter(next);
    }
    return hint_is_phrase(p, &p->ahead);
}

bool parser_at_state(const Parser *p)
{
    return p->tok.kind == TOK_NAME && p->ahead.kind == TOK_NAME && !p->ahead.first && strcmp(p->tok.text->text, "state") == 0 &&
           !has_other_meaning(p);
}

AstExpr *parse_state_value(Parser *p)
{
    AstExpr *e = new_node(p, AST_STATE_NAME);

    e->depth = 1;
    parser_advance(p);
    e->op_at = p->tok.at;
    e->op_len = p->tok.len;
    e->name = p->tok.text;
    parser_advance(p);
    e->span = parser_span_since(p, e->span.at);
    return e;
}
