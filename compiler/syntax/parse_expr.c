// SPDX-License-Identifier: Apache-2.0
// Parses expressions by precedence climbing over operators.def. A loop handles operators of one precedence. Only parentheses, calls, prefix
// operators and operators of higher precedence recurse, and p->depth bounds the recursion.
#include "compiler/syntax/hints.h"
#include "compiler/syntax/parser.h"

static AstExpr *parse_level(Parser *p, int least);
static AstExpr *parse_enclosed(Parser *p);
static AstExpr *parse_missing_value(Parser *p);

// ---- nodes ----

static AstExpr *new_expr(Parser *p, AstExprKind kind, Span span)
{
    AstExpr *e = ARENA_NEW(p->arena, AstExpr);

    e->kind = kind;
    e->span = span;
    e->depth = 1;
    return e;
}

static void set_operator_span(AstExpr *e, Span span)
{
    e->op_at = span.at;
    e->op_len = span.len;
}

static AstExpr *new_error_expr(Parser *p) { return new_expr(p, AST_ERROR, parser_token_span(p)); }

static AstExpr *report_too_deep(Parser *p, Span span)
{
    parser_fail(p, DIAG_expression_too_deep, span, format_in(p->arena, "%d", AST_DEPTH_MAX));
    return new_error_expr(p);
}

// Increases the depth of `e` for its operand `a`, and returns `e`; returns an error node if the depth exceeds the limit.
static AstExpr *check_depth(Parser *p, AstExpr *e, const AstExpr *a)
{
    if (a->depth >= e->depth)
        e->depth = a->depth + 1;
    if (e->depth <= AST_DEPTH_MAX)
        return e;
    return report_too_deep(p, ast_op_span(e));
}

// Counts one level of recursion in p->depth; reports an error and returns false if there are too many levels.
static bool enter_recursion(Parser *p)
{
    if (p->depth < AST_DEPTH_MAX) {
        p->depth++;
        return true;
    }
    report_too_deep(p, parser_token_span(p));
    return false;
}

// Whether a line end ends the expression before the next token. Inside parentheses it does not.
static bool is_at_line_end(const Parser *p) { return p->tok.first && p->parens == 0; }

// ---- values ----

// Returns the unit of time that follows the last token, a number; TIME_NONE if no unit follows it (language.md 1.36). The lexer has reported a unit
// without a blank before it.
static TimeUnit find_unit(const Parser *p)
{
    const char *number = p->lex.src->text + p->last.at;

    if (p->tok.kind != TOK_NAME || p->tok.first || (p->ahead.kind == TOK_LPAREN && !p->ahead.first) || number[1] == 'x' || number[1] == 'X')
        return TIME_NONE;
    return time_unit_find(p->tok.text->text);
}

// Parses a number, and the unit of time after it if there is one.
AstExpr *parse_number(Parser *p)
{
    AstExpr *e = new_expr(p, AST_NUMBER, parser_token_span(p));
    const bool is_word = p->tok.kind != TOK_NUMBER;

    set_operator_span(e, e->span);
    e->number = is_word ? sm_from_u32(p->tok.kind == TOK_TRUE) : p->tok.number;
    parser_advance(p);
    if (is_word || (e->unit = find_unit(p)) == TIME_NONE)
        return e;
    parser_advance(p);
    e->span = parser_span_since(p, e->span.at);
    return e;
}

// Consumes the ) that closes the ( at `open`, or reports that it is missing.
static void expect_close(Parser *p, Span open)
{
    Diag *d;

    p->parens--;
    if (p->failed)
        return;
    if (p->tok.kind == TOK_RPAREN) {
        parser_advance(p);
        return;
    }
    if (p->tok.kind == TOK_ERROR || (p->tok.kind == TOK_COMMA && p->ahead.kind == TOK_ERROR)) {
        p->failed = true;
        return;
    }
    if (hint_explain(p, HINT_AT_CLOSE, NULL) != HINT_NONE)
        return;
    d = parser_fail(p, DIAG_paren_unclosed, parser_missing_span(p), parser_describe_found(p));
    diag_note(p->diags, d, open, DIAG_note_paren_opened);
}

static AstExpr *parse_paren(Parser *p)
{
    Span open = parser_token_span(p);
    AstExpr *e = new_expr(p, AST_PAREN, open);

    parser_advance(p);
    p->parens++;
    e->a = parse_enclosed(p);
    expect_close(p, open);
    e->span = parser_span_since(p, open.at);
    set_operator_span(e, e->span);
    return check_depth(p, e, e->a);
}

// Whether the current token is the word `steps` that ends an argument.
bool parser_is_steps(const Parser *p)
{
    return p->tok.kind == TOK_NAME && strcmp(p->tok.text->text, "steps") == 0 && (p->ahead.kind == TOK_RPAREN || p->ahead.kind == TOK_COMMA);
}

// Parses the word `steps` after an argument that is a number or a name, as in roll_avg(x, 5 steps).
static AstExpr *parse_steps(Parser *p, AstExpr *a)
{
    const bool is_count = (a->kind == AST_NUMBER && a->unit == TIME_NONE) || a->kind == AST_NAME;
    AstExpr *e;

    if (p->failed || !is_count || !parser_is_steps(p))
        return a;
    e = new_expr(p, AST_STEPS, a->span);
    e->a = a;
    parser_advance(p);
    e->span = parser_span_since(p, a->span.at);
    return check_depth(p, e, a);
}

static AstExpr *parse_call(Parser *p)
{
    bool has_error = false;                            // an argument contains an error that the lexer has reported
    AstExpr *e = new_expr(p, AST_CALL, parser_token_span(p));
    Span open;

    e->name = p->tok.text;
    e->args = ARENA_NEW(p->arena, AstArgs);
    set_operator_span(e, e->span);
    parser_advance(p);
    open = parser_token_span(p);
    parser_advance(p);
    p->parens++;
    while (p->tok.kind != TOK_RPAREN) {                // if there are no arguments, the checker reports how many are required
        AstExpr *a = parse_steps(p, parse_enclosed(p));
        vec_push(p->arena, e->args, a);
        has_error = has_error || p->last.kind == TOK_ERROR;
        if (a->depth >= e->depth)
            e->depth = a->depth + 1;
        if (p->failed || p->tok.kind != TOK_COMMA)
            break;
        parser_advance(p);
        if (p->tok.kind == TOK_RPAREN)
            parse_missing_value(p);
    }
    expect_close(p, open);
    e->span = parser_span_since(p, e->span.at);
    if (p->failed || has_error)                        // an error node, because the intended number of arguments is unknown
        e->kind = AST_ERROR;
    if (e->depth <= AST_DEPTH_MAX)
        return e;
    return report_too_deep(p, ast_op_span(e));
}

static AstExpr *parse_name(Parser *p)
{
    AstExpr *e;

    if (p->ahead.kind == TOK_LPAREN && (p->parens || !p->ahead.first))
        return parse_call(p);
    if (p->kind == FILE_SS && parser_at_state(p))
        return parse_state_value(p);
    e = new_expr(p, AST_NAME, parser_token_span(p));
    e->name = p->tok.text;
    parser_advance(p);
    if (hint_explain(p, HINT_AFTER_NAME, e) == HINT_SKIPPED)
        e->kind = AST_ERROR;
    return e;
}

static AstExpr *parse_missing_value(Parser *p)
{
    AstExpr *e = new_error_expr(p);

    if (p->tok.kind == TOK_ERROR)                      // the lexer has reported the token: treat it as a value
        parser_advance(p);
    else
        hint_explain(p, HINT_AT_VALUE, NULL);
    return e;
}

static AstExpr *parse_value(Parser *p)
{
    switch ((int)p->tok.kind) {
    case TOK_NUMBER: case TOK_TRUE: case TOK_FALSE: return parse_number(p);
    case TOK_NAME:   return parse_name(p);
    case TOK_LPAREN: return parse_paren(p);
    default:         return parse_missing_value(p);
    }
}

// ---- operators ----

static bool match_prefix_operator(TokenKind kind, SmOperator *op)
{
    if (kind == TOK_NOT || kind == TOK_BANG)
        return *op = SM_OP_NOT, true;
    if (kind == TOK_MINUS)
        return *op = SM_OP_NEG, true;
    if (kind == TOK_PLUS)
        return *op = SM_OP_PLUS, true;
    return false;
}

static bool match_infix_operator(TokenKind kind, SmOperator *op)
{
    static const struct { TokenKind kind; SmOperator op; } infix[] = {
        {TOK_PLUS, SM_OP_ADD}, {TOK_MINUS, SM_OP_SUB}, {TOK_STAR, SM_OP_MUL}, {TOK_SLASH, SM_OP_DIV},
        {TOK_LT, SM_OP_LT}, {TOK_LE, SM_OP_LE}, {TOK_GT, SM_OP_GT}, {TOK_GE, SM_OP_GE},
        {TOK_EQ, SM_OP_EQ}, {TOK_NE, SM_OP_NE}, {TOK_AND, SM_OP_AND}, {TOK_OR, SM_OP_OR}};

    for (size_t i = 0; i < sizeof infix / sizeof *infix; i++)
        if (infix[i].kind == kind)
            return *op = infix[i].op, true;
    return false;
}

// Parses a value with its prefix operators.
static AstExpr *parse_prefixed(Parser *p)
{
    SmOperator op;
    AstExpr *e;

    if (!enter_recursion(p))
        return new_error_expr(p);
    hint_explain(p, HINT_AT_OPERAND, NULL);
    if (match_prefix_operator(p->tok.kind, &op)) {
        e = new_expr(p, AST_UNARY, parser_token_span(p));
        e->op = op;
        set_operator_span(e, e->span);
        parser_advance(p);
        e->a = is_at_line_end(p) ? parse_missing_value(p) : parse_prefixed(p);
        e->span = parser_span_since(p, e->span.at);
        e = check_depth(p, e, e->a);
    } else {
        e = parse_value(p);
    }
    p->depth--;
    return e;
}

static bool is_equality(const AstExpr *e)
{
    return e->kind == AST_BINARY && (e->op == SM_OP_EQ || e->op == SM_OP_NE);
}

static AstExpr *new_binary(Parser *p, SmOperator op, Span op_span, AstExpr *a, AstExpr *b)
{
    AstExpr *e = new_expr(p, AST_BINARY, a->span);

    e->op = op;
    set_operator_span(e, op_span);
    e->a = a;
    e->b = b;
    e->span = parser_span_since(p, a->span.at);
    if (is_equality(e) && is_equality(a) && !is_equality(a->a) && !p->failed) {            // a == b == c
        Diag *d = parser_report(p, DIAG_equality_chain, op_span, sm_op_info[a->op].spelling, sm_op_info[op].spelling);
        diag_label(p->diags, d, DIAG_label_did_you_mean,
                   format_in(p->arena, "%s and %s %s %s", parser_text(p, a->span), parser_text(p, a->b->span), sm_op_info[op].spelling,
                             parser_text(p, b->span)));
    }
    return check_depth(p, check_depth(p, e, a), b);
}

// Parses the right operand of an operator whose precedence is `above`: an expression of operators of higher precedence.
static AstExpr *parse_right(Parser *p, int above)
{
    AstExpr *e;

    if (is_at_line_end(p))
        return parse_missing_value(p);
    if (!enter_recursion(p))
        return new_error_expr(p);
    e = parse_level(p, above + 1);
    p->depth--;
    return e;
}

// Parses operators of precedence `least` and above.
static AstExpr *parse_level(Parser *p, int least)
{
    AstExpr *e = parse_prefixed(p);
    SmOperator op;

    while (!p->failed && !is_at_line_end(p)) {
        Span op_span;
        if (hint_explain(p, HINT_AT_OPERATOR, e) == HINT_SKIPPED || !match_infix_operator(p->tok.kind, &op) || sm_op_info[op].precedence < least)
            break;
        op_span = parser_token_span(p);
        parser_advance(p);
        e = new_binary(p, op, op_span, e, parse_right(p, sm_op_info[op].precedence));
    }
    return e;
}

// ---- implications, in requirements ----

static bool at_implies(const Parser *p)
{
    return p->kind == FILE_RQ && !p->failed && !is_at_line_end(p) && p->tok.kind == TOK_NAME && strcmp(p->tok.text->text, "implies") == 0;
}

// Parses `implies b` after `a`, if it follows (requirements.md 13.6).
static AstExpr *parse_implication(Parser *p, AstExpr *a)
{
    AstExpr *e;

    if (!at_implies(p))
        return a;
    e = new_expr(p, AST_IMPLIES, a->span);
    set_operator_span(e, parser_token_span(p));
    parser_advance(p);
    e->a = a;
    e->b = parse_right(p, 0);
    e->span = parser_span_since(p, a->span.at);
    if (at_implies(p))
        diag_label(p->diags, parser_fail(p, DIAG_implies_chain, parser_token_span(p)), DIAG_label_write,
                   format_in(p->arena, "%s and %s implies ...", parser_text(p, a->span), parser_text(p, e->b->span)));
    return check_depth(p, check_depth(p, e, a), e->b);
}

// Parses an expression between parentheses.
static AstExpr *parse_enclosed(Parser *p) { return parse_implication(p, parse_level(p, 1)); }

AstExpr *parse_condition_of(Parser *p) { return parse_implication(p, parse_value_of(p, true)); }

// Parses an expression from the next token on, on this line or a later one.
AstExpr *parse_expr(Parser *p, bool is_guard)
{
    AstExpr *e;

    p->is_guard = is_guard;
    p->parens = p->depth = 0;
    e = parse_level(p, 1);
    p->is_guard = false;
    return e;
}

// Parses an expression that must begin on this line.
AstExpr *parse_value_of(Parser *p, bool is_guard)
{
    p->parens = 0;
    return is_at_line_end(p) || parser_at_end_of_block(p) ? parse_missing_value(p) : parse_expr(p, is_guard);
}
