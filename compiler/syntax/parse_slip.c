// SPDX-License-Identifier: Apache-2.0
// Slips: what people write who know other languages, who do not program, or who type fast.  Where the grammar has no way on,
// these functions find the likeliest reason and say that instead of what token was expected.
#include "compiler/syntax/parser.h"

// ---- words ----

static bool same_letters(const char *a, const char *lower)
{
    for (; *a && *lower; a++, lower++)
        if ((*a >= 'A' && *a <= 'Z' ? *a - 'A' + 'a' : *a) != *lower)
            return false;
    return !*a && !*lower;
}

static bool is_word(const Token *t, const char *lower) { return t->kind == TOK_NAME && same_letters(t->text->text, lower); }

static bool begins_value(const Token *t)
{
    return t->kind == TOK_NAME || t->kind == TOK_NUMBER || t->kind == TOK_LPAREN || t->kind == TOK_TRUE ||
           t->kind == TOK_FALSE || t->kind == TOK_NOT || t->kind == TOK_BANG;
}

// Says how the word at hand is written here, and takes it for that.
static void replace_word(Parser *p, const char *native, TokenKind kind)
{
    Diag *d = parser_report(p, DIAG_foreign_word, parser_here(p), p->tok.text->text);

    diag_label(p->diags, d, DIAG_label_write, native);
    diag_edit(p->diags, d, parser_here(p), native);
    p->tok.kind = kind;
}

// ---- in expressions ----

void slip_prefix(Parser *p)
{
    if (is_word(&p->tok, "not") && begins_value(&p->ahead) && (p->parens || !p->ahead.first))
        replace_word(p, "not", TOK_NOT);
}

static const struct { const char *word, *native; TokenKind kind; } infix[] = {
    {"and", "and", TOK_AND}, {"or", "or", TOK_OR}, {"is", "==", TOK_EQ}, {"equals", "==", TOK_EQ}, {"eq", "==", TOK_EQ},
    {"ne", "!=", TOK_NE}, {"gt", ">", TOK_GT}, {"lt", "<", TOK_LT}, {"ge", ">=", TOK_GE}, {"le", "<=", TOK_LE}};

enum { NO_INFIX = sizeof infix / sizeof *infix };

// The row of the word at hand where it stands as an operator of another language would.
static size_t infix_row(const Parser *p)
{
    size_t i = 0;

    while (i < NO_INFIX && (!is_word(&p->tok, infix[i].word) || !begins_value(&p->ahead)))
        i++;
    return i;
}

// IF(a; b; c) of spreadsheets: no value begins with it.
bool slip_choice(const Parser *p) { return is_word(&p->tok, "if") && p->ahead.kind == TOK_LPAREN && !p->ahead.first; }

const char *function_usage(const SmBuiltinInfo *fn)
{
    static const char *const usage[] = {"()", "(x)", "(a, b)", "(x, lo, hi)"};

    return fn->is_roll ? "(x, n)" : usage[fn->arguments];
}

static int find_function(Str name)
{
    int i = 0;

    while (i < SM_FN_COUNT && strcmp(name->text, sm_builtin_info[i].name) != 0)
        i++;
    return i;
}

// abs x, with the operand at hand, of which nothing could follow an element called like that.
bool slip_operand(Parser *p, AstExpr *name)
{
    int fn = find_function(name->name);
    Span operand = parser_here(p);
    Diag *d;

    if (fn == SM_FN_COUNT || p->tok.first || (p->tok.kind != TOK_NAME && p->tok.kind != TOK_NUMBER) ||
        p->ahead.kind == TOK_ASSIGN || infix_row(p) < NO_INFIX || is_word(&p->tok, "then") || is_word(&p->tok, "do") || is_word(&p->tok, "between"))
        return false;
    d = parser_report(p, DIAG_function_without_call, name->span, name->name->text, name->name->text,
                      function_usage(&sm_builtin_info[fn]));
    parser_next(p);
    if (sm_builtin_info[fn].arguments != 1 ||
        (!p->tok.first && (p->tok.kind == TOK_NAME || p->tok.kind == TOK_NUMBER || p->tok.kind == TOK_LPAREN))) {
        p->failed = true;
        return true;
    }
    diag_edit(p->diags, d, (Span){operand.src, name->span.at + name->span.len, operand.at - name->span.at - name->span.len}, "(");
    diag_edit(p->diags, d, (Span){operand.src, operand.at + operand.len, 0}, ")");
    return true;
}

void slip_infix(Parser *p)
{
    Diag *d;

    if (p->tok.kind == TOK_NAME) {
        size_t row = infix_row(p);
        if (row < NO_INFIX)
            replace_word(p, infix[row].native, infix[row].kind);
        return;
    }
    if (p->tok.kind != TOK_ASSIGN || (!p->is_guard && p->parens == 0))
        return;
    if (p->last.first && p->parens)                    // a new statement: the parenthesis before was never closed
        return;
    d = parser_report(p, DIAG_assign_in_guard, parser_here(p));
    diag_label(p->diags, d, DIAG_label_write, "==");
    diag_edit(p->diags, d, parser_here(p), "==");
    p->tok.kind = TOK_EQ;
}

bool slip_unit_step(Parser *p)
{
    const char *text = p->lex.src->text;
    uint32_t at = p->last.at;
    char sign[2] = "?";
    Diag *d;

    if ((p->last.kind != TOK_PLUS && p->last.kind != TOK_MINUS) || at == 0 || text[at - 1] != text[at] || !p->tok.first)
        return false;
    sign[0] = text[at];
    d = parser_fail(p, DIAG_op_assign, (Span){p->lex.src, at - 1, 2}, format_in(p->arena, "%s%s", sign, sign));
    diag_label(p->diags, d, DIAG_label_write, format_in(p->arena, "x = x %s 1", sign));
    return true;
}

static bool touches(const Token *a, const Token *b) { return a->at + a->len == b->at; }

static bool is_label_word(const char *s)
{
    return strcmp(s, "entry") == 0 || strcmp(s, "step") == 0 || strcmp(s, "exit") == 0;
}

bool slip_dotted_name(Parser *p, Span name)
{
    if (!touches(&p->last, &p->tok) || p->tok.kind != TOK_LABEL || is_label_word(p->tok.text->text))
        return false;
    name.len += p->tok.len;
    parser_fail(p, DIAG_name_with_dot, name, parser_text(p, name));
    parser_next(p);
    return true;
}

void slip_after_name(Parser *p, AstExpr *name)
{
    Span both = name->span;

    if (!touches(&p->last, &p->tok))
        return;
    both.len += p->tok.len;
    if (slip_dotted_name(p, name->span)) {
        name->kind = AST_ERROR;
    } else if (p->tok.kind == TOK_HEADER && !is_identifier(p->tok.text->text, p->tok.text->len)) {
        name->kind = AST_ERROR;
        parser_fail(p, DIAG_no_lists, both, parser_text(p, both));
        parser_next(p);
    }
}

void slip_equality_chain(Parser *p, const AstExpr *e)
{
    const AstExpr *a = e->a;
    Diag *d = parser_report(p, DIAG_equality_chain, ast_op_span(e), sm_op_info[a->op].spelling, sm_op_info[e->op].spelling);

    diag_label(p->diags, d, DIAG_label_did_you_mean,
               format_in(p->arena, "%s and %s %s %s", parser_text(p, a->span), parser_text(p, a->b->span),
                         sm_op_info[e->op].spelling, parser_text(p, e->b->span)));
}

static bool is_comparison(TokenKind k)
{
    return k == TOK_LT || k == TOK_LE || k == TOK_GT || k == TOK_GE || k == TOK_EQ || k == TOK_NE;
}

// Whether what stands here is a guard: its line, which goes on inside parentheses, holds a : or a {, or a { stands below.
static bool is_guard(const Parser *p)
{
    const Source *s = p->lex.src;
    uint32_t depth = 0, i = p->tok.at;
    bool below = false;                                // behind the line's end, where only '{' may follow

    for (; i < s->len; i++) {
        const char c = s->text[i];
        if (c == '#')
            i += (uint32_t)strcspn(s->text + i, "\n") - 1;
        else if (c == '\n')
            below |= depth == 0;
        else if (below && c != ' ' && c != '\t' && c != '\r')
            return c == '{';
        else if (c == ':' || c == '{' || c == '}')
            return true;
        else if (c == '(' || (c == ')' && depth > 0))
            depth += c == '(' ? 1u : UINT32_MAX;
    }
    return false;
}

// The line ended with an operator, and the next one looks like what should follow it: it has been spoken of then.
static void skip_continuation(Parser *p)
{
    while (begins_value(&p->tok) && p->ahead.kind != TOK_ASSIGN && !is_guard(p)) {
        parser_next(p);
        while (!p->tok.first)
            parser_next(p);
        if (p->last.kind != TOK_AND && p->last.kind != TOK_OR && p->last.kind != TOK_PLUS && p->last.kind != TOK_MINUS)
            break;
    }
}

void slip_missing_value(Parser *p, Diag *d)
{
    if (p->tok.first && p->tok.kind != TOK_END && p->last.kind != TOK_ASSIGN) {
        diag_label(p->diags, d, DIAG_label_line_break);
        skip_continuation(p);
    } else if ((p->last.kind == TOK_AND || p->last.kind == TOK_OR) && is_comparison(p->tok.kind)) {
        diag_label(p->diags, d, DIAG_label_repeat_name, parser_text(p, parser_here(p)));
    } else if (p->tok.kind == TOK_IF) {
        diag_label(p->diags, d, DIAG_label_text, lex_no_choice);
        if (!p->ahead.first)
            lex_skip_choice(&p->lex);
    } else if ((p->tok.kind == TOK_AND || p->tok.kind == TOK_OR) && p->ahead.kind == TOK_LPAREN) {
        diag_label(p->diags, d, DIAG_label_write, format_in(p->arena, "a %s b", p->tok.kind == TOK_AND ? "and" : "or"));
    } else if (p->last.kind == TOK_MINUS && p->tok.kind == TOK_GT && p->ahead.kind == TOK_NAME) {
        diag_label(p->diags, d, DIAG_label_write, "->");
    }
}

// ---- where a statement should end ----

// 60,000 may be sixty thousand; 0,125 and 3,14 may not.
static bool may_be_thousands(const Parser *p)
{
    return p->ahead.len == 3 && p->lex.src->text[p->last.at] != '0';
}

// 3,14
bool slip_decimal_comma(Parser *p)
{
    const char *before, *after;
    Diag *d;

    if (p->tok.kind != TOK_COMMA || p->last.kind != TOK_NUMBER || p->ahead.kind != TOK_NUMBER ||
        !touches(&p->last, &p->tok) || !touches(&p->tok, &p->ahead))
        return false;
    before = parser_text(p, parser_span(p, &p->last));
    after = parser_text(p, parser_span(p, &p->ahead));
    d = parser_fail(p, DIAG_decimal_comma, parser_here(p));
    if (may_be_thousands(p)) {
        diag_label(p->diags, d, DIAG_label_comma_in_number, before, after, before, after);
    } else {
        diag_label(p->diags, d, DIAG_label_write, format_in(p->arena, "%s.%s", before, after));
        diag_edit(p->diags, d, parser_here(p), ".");
    }
    return true;
}

// T > 5 ms
static bool unit_after_number(const Parser *p)
{
    return p->last.kind == TOK_NUMBER && p->tok.kind == TOK_NAME && (p->ahead.first || p->ahead.kind == TOK_COLON);
}

// x = true, y = true; x = true y = true; x = true -> Idle
static bool begins_statement(const Parser *p)
{
    return p->tok.kind == TOK_ARROW || (p->tok.kind == TOK_COMMA && p->ahead.kind == TOK_NAME) ||
           (p->tok.kind == TOK_NAME && p->ahead.kind == TOK_ASSIGN && !p->ahead.first);
}

void slip_at_end(Parser *p)
{
    Diag *d;

    if (p->tok.kind == TOK_ERROR || (p->ahead.kind == TOK_ERROR && !p->ahead.first) ||
        (p->lex.src->text[p->tok.at] & 0x80)) {
        p->failed = true;                              // the line has been spoken of
        return;
    }
    if (slip_decimal_comma(p) || slip_remark(p))
        return;
    if (p->tok.kind == TOK_RPAREN) {
        parser_fail(p, DIAG_stray_paren, parser_here(p));
        return;
    }
    d = parser_fail(p, DIAG_expected_end, parser_here(p), parser_describe(p, &p->tok));
    if (p->tok.kind == TOK_ASSIGN)
        diag_label(p->diags, d, DIAG_label_one_assignment);
    else if (p->tok.kind == TOK_ELSE)
        diag_label(p->diags, d, DIAG_label_else_after_if);
    else if (unit_after_number(p))
        diag_label(p->diags, d, DIAG_label_no_unit);
    else if (p->tok.kind == TOK_IF)
        diag_label(p->diags, d, DIAG_label_condition_first);
    else if (annotation_is_allow(&p->tok))
        diag_label(p->diags, d, DIAG_label_allow_before);
    else if (begins_statement(p))
        diag_label(p->diags, d, DIAG_label_own_line);
    else if (p->tok.kind == TOK_COLON)
        diag_label(p->diags, d, DIAG_label_text, "one statement behind ':'; several stand in braces, each on a line of its own");
    else if (p->tok.kind == TOK_LPAREN)
        diag_label(p->diags, d, DIAG_label_text, "to multiply, write *");
}

// ---- expressions that stand alone ----

// T > 5 s: ...
static bool unit_in_guard(Parser *p)
{
    if (p->last.kind != TOK_NUMBER || p->tok.kind != TOK_NAME ||
        (p->ahead.kind != TOK_COLON && p->ahead.kind != TOK_LBRACE))
        return false;
    diag_label(p->diags, parser_report(p, DIAG_expected_end, parser_here(p), parser_describe(p, &p->tok)),
               DIAG_label_no_unit);
    p->failed = true;
    return true;
}

// `then` and `do`.
static void colon_word(Parser *p)
{
    uint32_t from = p->last.at + p->last.len;
    Diag *d = parser_report(p, DIAG_foreign_word, parser_here(p), p->tok.text->text);

    if (p->ahead.first) {
        diag_label(p->diags, d, DIAG_label_braces_instead);
    } else {
        diag_label(p->diags, d, DIAG_label_colon_instead);
        diag_edit(p->diags, d, (Span){p->lex.src, from, p->tok.at + p->tok.len - from}, ":");
    }
    parser_next(p);
    if (p->tok.kind == TOK_COLON && !p->tok.first)
        parser_next(p);
}

static const char *between_text(const Parser *p, const AstExpr *e)
{
    return format_in(p->arena, "write 3 <= %s <= 5", parser_text(p, e->span));
}

// Something follows the guard on its line that is no statement: a colon would not help.
static bool prose_in_guard(Parser *p, AstExpr *e)
{
    Diag *d;

    if (p->tok.kind == TOK_COMMA && e->kind != AST_NAME && p->ahead.kind == TOK_NAME)
        d = parser_fail(p, DIAG_guard_without_body, parser_gap(p), parser_found(p));
    else if (p->tok.kind == TOK_NAME && p->ahead.kind != TOK_ASSIGN && is_guard(p))
        d = parser_fail(p, DIAG_guard_without_body, parser_here(p), parser_found(p));
    else
        return false;
    if (p->tok.kind == TOK_COMMA)
        diag_label(p->diags, d, DIAG_label_colon_instead);
    else if (is_word(&p->tok, "between"))
        diag_label(p->diags, d, DIAG_label_text, between_text(p, e));
    return true;
}

// p > 5 => Idle: the lexer has said that a colon is missing too.
static bool is_foreign_arrow(const Parser *p) { return p->tok.kind == TOK_ARROW && p->lex.src->text[p->tok.at] == '='; }

// Another statement follows the guard on its line, or a word that other languages have there.
static bool missing_colon(Parser *p, AstExpr *e)
{
    Diag *d;

    if (p->tok.first)
        return false;
    if (is_word(&p->tok, "then") || is_word(&p->tok, "do")) {
        colon_word(p);
        return true;
    }
    if (unit_in_guard(p) || prose_in_guard(p, e))
        return true;
    if (p->tok.kind != TOK_ARROW && p->tok.kind != TOK_NAME && p->tok.kind != TOK_ANNOTATION && p->tok.kind != TOK_IF)
        return false;
    if (is_foreign_arrow(p))
        return true;
    d = parser_report(p, DIAG_guard_without_body, parser_gap(p), parser_found(p));
    diag_label(p->diags, d, DIAG_label_insert_colon);
    diag_edit(p->diags, d, parser_gap(p), ":");
    return true;
}

static void assign_to_expression(Parser *p, const AstExpr *e)
{
    if (is_guard(p)) {
        Diag *d = parser_fail(p, DIAG_assign_in_guard, parser_here(p));
        diag_label(p->diags, d, DIAG_label_write, "==");
        diag_edit(p->diags, d, parser_here(p), "==");
    } else {
        parser_fail(p, DIAG_assign_target, e->span, parser_text(p, e->span));
    }
}

static void no_effect(Parser *p, AstExpr *e)
{
    Diag *d;

    if (e->kind == AST_NAME && is_label_word(e->name->text)) {
        d = parser_report(p, DIAG_label_without_dot, e->span, e->name->text);
        diag_edit(p->diags, d, (Span){e->span.src, e->span.at, 0}, ".");
        e->kind = AST_ERROR;
        return;
    }
    e->alone = p->kind == FILE_SM && (e->kind == AST_NAME || e->kind == AST_CALL);
    if (e->alone)
        return;
    d = parser_report(p, DIAG_no_effect, e->span);
    if (e->kind == AST_BINARY && e->op == SM_OP_EQ && e->a->kind == AST_NAME)
        diag_label(p->diags, d, DIAG_label_store,
                   format_in(p->arena, "%s = %s", e->a->name->text, parser_text(p, e->b->span)));
    else
        diag_label(p->diags, d, DIAG_label_statements);
}

// Two names in a row: prose, or something of another language.
static void no_statement(Parser *p, AstExpr *e)
{
    Diag *d = parser_fail(p, DIAG_no_statement, e->span, e->name->text);

    if (is_word(&p->tok, "between"))
        diag_label(p->diags, d, DIAG_label_text, between_text(p, e));
    else
        diag_label(p->diags, d, DIAG_label_statements);
    e->kind = AST_ERROR;
}

void slip_expression(Parser *p, AstExpr *e, bool has_if)
{
    if (p->failed)
        return;
    if (p->tok.kind == TOK_ASSIGN && !p->tok.first)
        assign_to_expression(p, e);
    else if (!has_if && e->kind == AST_NAME && p->tok.kind == TOK_NAME && !p->tok.first && !is_word(&p->tok, "then"))
        no_statement(p, e);
    else if (missing_colon(p, e))
        return;
    else if (!parser_at_end_of_statement(p))
        slip_at_end(p);
    else if (has_if)
        parser_fail(p, DIAG_guard_without_body, parser_gap(p), parser_found(p));
    else
        no_effect(p, e);
}

void slip_colon(Parser *p, AstExpr *guard, Span colon)
{
    const char *before = guard ? parser_text(p, guard->span) : "else";
    Diag *d;

    if (guard && guard->kind == AST_NAME && is_label_word(guard->name->text) && p->tok.first) {
        d = parser_report(p, DIAG_label_without_dot, guard->span, guard->name->text);
        diag_edit(p->diags, d, (Span){colon.src, guard->span.at, 0}, ".");
        diag_edit(p->diags, d, colon, "");
        guard->kind = AST_ERROR;
        return;
    }
    d = parser_report(p, DIAG_colon_line_break, colon, guard ? "the condition" : "'else'", parser_found(p));
    diag_label(p->diags, d, DIAG_label_statement_here);
    diag_note(p->diags, d, (Span){0}, DIAG_note_write_braces, before);
}

// x: = 1
void slip_colon_assign(Parser *p, const AstExpr *guard, Span colon)
{
    Diag *d = parser_fail(p, DIAG_expected_statement, parser_here(p), "'='");

    if (guard && guard->kind == AST_NAME) {
        diag_label(p->diags, d, DIAG_label_store, format_in(p->arena, "%s = ...", guard->name->text));
        diag_edit(p->diags, d, colon, "");
    }
}

// -> [Idle]
bool slip_bracketed_state(Parser *p)
{
    Diag *d;

    if (p->tok.kind != TOK_HEADER || p->tok.first)
        return false;
    d = parser_report(p, DIAG_transition_without_state, parser_here(p), parser_describe(p, &p->tok));
    diag_label(p->diags, d, DIAG_label_write, p->tok.text->text);
    diag_edit(p->diags, d, parser_here(p), p->tok.text->text);
    parser_next(p);
    return true;
}

void slip_else(Parser *p)
{
    Diag *d;

    if (is_foreign_arrow(p))
        return;
    d = parser_report(p, DIAG_else_without_body, parser_gap(p), parser_found(p));
    if (p->tok.first || parser_at_end_of_block(p))
        return;
    diag_label(p->diags, d, DIAG_label_insert_colon);
    diag_edit(p->diags, d, parser_gap(p), ":");
}

// ---- statements of other languages ----

// `-- …` where an expression cannot stand: a comment.
bool slip_remark(Parser *p)
{
    const Source *src = p->lex.src;
    Span sign = parser_here(p);
    Diag *d;

    if (p->tok.kind != TOK_MINUS || p->ahead.kind != TOK_MINUS || !touches(&p->tok, &p->ahead) || is_guard(p))
        return false;
    sign.len = 2;
    d = parser_fail(p, DIAG_foreign_comment, sign, "--");
    diag_label(p->diags, d, DIAG_label_comment);
    diag_edit(p->diags, d, sign, "#");
    while (p->lex.at < src->len && src->text[p->lex.at] != '\n')
        p->lex.at++;
    parser_next(p);
    return true;
}

void slip_op_assign(Parser *p, Span name)
{
    const char *sign = parser_text(p, parser_here(p));
    Diag *d = parser_report(p, DIAG_op_assign, parser_here(p), sign);

    diag_label(p->diags, d, DIAG_label_write,
               format_in(p->arena, "%s = %s %c ...", parser_text(p, name), parser_text(p, name), sign[0]));
}

typedef enum SlipDoes { SLIP_IF, SLIP_ELSE, SLIP_ARROW, SLIP_DROP, SLIP_SKIP } SlipDoes;

// `does`: what the word is taken for; SKIP: the statement is given up.
static const struct { const char *word; SlipDoes does; const char *say; } slips[] = {
    {"if", SLIP_IF, "if"}, {"when", SLIP_IF, "if"}, {"elif", SLIP_IF, "else if"}, {"elseif", SLIP_IF, "else if"},
    {"elsif", SLIP_IF, "else if"}, {"iff", SLIP_IF, "if"},
    {"else", SLIP_ELSE, "else"}, {"otherwise", SLIP_ELSE, "else"},
    {"goto", SLIP_ARROW, "->"}, {"go", SLIP_ARROW, "->"}, {"transition", SLIP_ARROW, "->"},
    {"let", SLIP_DROP, NULL}, {"set", SLIP_DROP, NULL}, {"var", SLIP_DROP, NULL}, {"const", SLIP_DROP, NULL},
    {"while", SLIP_SKIP, "there are no loops: .step is run again at every step"},
    {"for", SLIP_SKIP, "there are no loops: .step is run again at every step"},
    {"repeat", SLIP_SKIP, "there are no loops: .step is run again at every step"},
    {"loop", SLIP_SKIP, "there are no loops: .step is run again at every step"},
    {"switch", SLIP_SKIP, "write it as if ... else if ... else"}, {"case", SLIP_SKIP, "write it as if ... else if ... else"},
    {"return", SLIP_SKIP, "put what follows into an else"}, {"break", SLIP_SKIP, "put what follows into an else"},
    {"wait", SLIP_SKIP, "compare the time in the state: T >= 100: ..."},
    {"delay", SLIP_SKIP, "compare the time in the state: T >= 100: ..."},
    {"sleep", SLIP_SKIP, "compare the time in the state: T >= 100: ..."},
    {"end", SLIP_SKIP, "braces are closed with }"}, {"endif", SLIP_SKIP, "braces are closed with }"},
    {"assert", SLIP_SKIP, "it is written @assert"}, {"stop", SLIP_SKIP, "it is written @stop"}};

// Stands as a word of another language would, and not as a name of this one.
static bool stands_foreign(const Parser *p, SlipDoes does)
{
    const Token *next = &p->ahead;

    if (next->first)
        return does == SLIP_SKIP && next->kind != TOK_LBRACE;     // `stop` and { on the next line: a guard
    if (does == SLIP_ELSE)
        return next->kind == TOK_IF || next->kind == TOK_NAME || next->kind == TOK_ARROW;     // ELSE: may be a guard
    return begins_value(next) && (next->kind != TOK_LPAREN || does == SLIP_IF || does == SLIP_SKIP);
}

// Whether the token behind a statement's first word lets any word stand as foreign; behind a name of this language there is mostly `=`.
static bool may_follow_foreign(const Token *next)
{
    return next->first || begins_value(next) || next->kind == TOK_IF || next->kind == TOK_ARROW;
}

// The declaration of a variable, in the midst of statements.
static void misplaced_decl(Parser *p)
{
    parser_fail(p, DIAG_decl_in_state, parser_here(p));
}

// goto Idle, go to Idle, transition to Idle
static void replace_arrow(Parser *p)
{
    Diag *d = parser_report(p, DIAG_foreign_word, parser_here(p), p->tok.text->text);
    uint32_t at = p->tok.at;

    if (is_word(&p->ahead, "to") && !p->ahead.first)
        parser_next(p);
    diag_label(p->diags, d, DIAG_label_write, "->");
    diag_edit(p->diags, d, (Span){p->lex.src, at, p->tok.at + p->tok.len - at}, "->");
    p->tok.kind = TOK_ARROW;
}

static bool apply_slip(Parser *p, SlipDoes does, const char *say)
{
    Diag *d;

    switch (does) {
    case SLIP_IF:    replace_word(p, say, TOK_IF); return false;
    case SLIP_ELSE:  replace_word(p, say, TOK_ELSE); p->lost_body = true; return false;
    case SLIP_ARROW: replace_arrow(p); return false;
    case SLIP_DROP:  break;
    case SLIP_SKIP:
        d = parser_fail(p, DIAG_foreign_word, parser_here(p), p->tok.text->text);
        diag_label(p->diags, d, DIAG_label_text, say);
        parser_next(p);
        return true;
    }
    d = parser_report(p, DIAG_foreign_word, parser_here(p), p->tok.text->text);
    diag_label(p->diags, d, DIAG_label_leave_out);
    diag_edit(p->diags, d, (Span){p->lex.src, p->tok.at, p->ahead.at - p->tok.at}, "");
    parser_next(p);
    return false;
}

bool slip_statement(Parser *p)
{
    if (slip_remark(p))
        return true;
    if (p->tok.kind == TOK_TYPE && p->ahead.kind == TOK_NAME && !p->ahead.first) {
        misplaced_decl(p);
        return true;
    }
    if (p->tok.kind != TOK_NAME || !may_follow_foreign(&p->ahead))
        return false;
    for (size_t i = 0; i < sizeof slips / sizeof *slips; i++)
        if (is_word(&p->tok, slips[i].word) && stands_foreign(p, slips[i].does))
            return apply_slip(p, slips[i].does, slips[i].say);
    return false;
}
