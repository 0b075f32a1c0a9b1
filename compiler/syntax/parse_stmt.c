// SPDX-License-Identifier: Apache-2.0
// Parses statements of machines and items of scripts, which share one grammar. Reports statements and items in a file whose kind does not
// allow them.
#include "compiler/syntax/hints.h"
#include "compiler/syntax/lexer.h"
#include "compiler/syntax/parser.h"

static void parse_statement(Parser *p, AstStmts *into);

static AstStmt *add_stmt(Parser *p, AstStmtKind kind, AstStmts *into)
{
    AstStmt *s = ARENA_NEW(p->arena, AstStmt);

    if (kind == AST_IF)
        s->arms = ARENA_NEW(p->arena, AstArms);
    s->kind = kind;
    s->span = parser_token_span(p);
    vec_push(p->arena, into, s);
    return s;
}

static bool in_script(const Parser *p) { return p->kind == FILE_SS; }

// ---- error recovery ----

static void parse_braces(Parser *p, AstStmts *into, Span *span);

// After an error: skips to the next statement. Parses blocks in braces on the way, so that their } is not reported as unmatched.
static void recover_statement(Parser *p)
{
    AstStmts ignored = {0};
    Span span;

    p->lost_body = true;
    while (!parser_at_end_of_block(p) && !p->tok.first) {
        if (p->tok.kind != TOK_LBRACE) {
            parser_advance(p);
            continue;
        }
        p->failed = false;
        parse_braces(p, &ignored, &span);
        p->lost_body = true;
        break;
    }
    p->failed = false;
}

// Reports text after a statement on its line. After an error in the statement, skips the rest of the statement.
static void finish_statement(Parser *p)
{
    if (!p->failed && !parser_at_end_of_statement(p))
        hint_explain(p, HINT_AT_END, NULL);
    if (p->failed && !p->tok.first)
        recover_statement(p);
    p->lost_body = p->lost_body || p->failed;
    p->failed = false;
}

// ---- blocks ----

// Reports an @allow at the end of a list of statements, where no statement follows that it could cover.
static void report_allow_of_nothing(Parser *p, const AstStmts *list)
{
    const AstStmt *last = list->n ? list->at[list->n - 1] : NULL;

    if (last && last->kind == AST_ALLOWED && !p->lost_body)
        parser_report(p, DIAG_allow_of_nothing, last->span);
}

enum { ITEMS_AT_ONCE = 256 };         // number of items of a script after which the visitor receives them

// Parses statements up to }, a label, a header or the end.
void parse_block(Parser *p, AstStmts *into)
{
    const bool outer_lost_body = p->lost_body;
    bool claimed;                               // the statement probably belongs to a condition whose error is already reported
    size_t errors;
    uint32_t at;

    p->lost_body = false;
    for (;;) {
        p->failed = false;
        if (p->tok.kind == TOK_RBRACE && p->braces == 0) {
            Diag *d = parser_report(p, DIAG_stray_brace, parser_token_span(p));
            d->follows = p->is_foreign_header;
            parser_advance(p);
            continue;
        }
        if (parser_at_end_of_block(p))
            break;
        at = p->tok.at;
        errors = p->diags->errors;
        if (p->nesting && into->n && into->at[into->n - 1]->kind == AST_STOP)
            parser_report(p, DIAG_after_stop, parser_token_span(p));
        parse_statement(p, into);
        if (p->tok.at == at && !parser_at_end_of_block(p))         // the token begins no statement: skip it
            parser_advance(p);
        finish_statement(p);
        claimed = at < p->lex.hinted || at < p->indented;
        if (into->n)
            into->at[into->n - 1]->flawed |= p->diags->errors > errors || claimed;
        p->lost_body |= claimed;
        if (into == p->visited && into->n == ITEMS_AT_ONCE)
            parser_visit_items(p);
    }
    report_allow_of_nothing(p, into);
    p->lost_body = outer_lost_body;
}

static void parse_braces(Parser *p, AstStmts *into, Span *span)
{
    Span open = parser_token_span(p);

    parser_advance(p);
    p->braces++;
    parse_block(p, into);
    p->braces--;
    if (p->tok.kind == TOK_RBRACE) {
        parser_advance(p);
    } else {
        Diag *d = parser_report(p, DIAG_brace_unclosed, open);
        diag_label(p->diags, d, DIAG_label_close_after_last);
        diag_note(p->diags, d, parser_token_span(p), DIAG_note_brace_until, parser_describe(p, &p->tok));
    }
    *span = parser_span_since(p, open.at);
}

// Enters one nesting level. If there are too many levels, reports that, ends parsing of the file, and returns false.
static bool enter_nesting(Parser *p)
{
    if (++p->nesting <= AST_DEPTH_MAX)
        return true;
    parser_fail(p, DIAG_nested_too_deep, parser_token_span(p), format_in(p->arena, "%d", AST_DEPTH_MAX));
    parser_stop(p);
    return false;
}

static void report_unguarded_braces(Parser *p)
{
    AstStmts ignored = {0};
    Span span;
    Diag *d;

    if (hint_report_guard_in_braces(p))
        return;
    d = parser_report(p, DIAG_braces_without_guard, parser_token_span(p));
    if (p->last.kind == TOK_LABEL)
        diag_label(p->diags, d, DIAG_label_no_block_braces);
    if (!enter_nesting(p))
        return;
    parse_braces(p, &ignored, &span);
    p->nesting--;
}

// ---- assignment, transition, assert, stop ----

// Reports an item of a script that is outside every conditional.
static void report_if_unguarded(Parser *p, const AstStmt *s)
{
    if (!in_script(p) || p->nesting > 0 || p->reported_unguarded || s->span.at < p->lex.hinted || s->span.at < p->indented)
        return;
    p->reported_unguarded = true;
    if (!p->tok.first && parser_at_when(p)) {
        const char *const when = parser_text_of_line(p, p->tok.at);
        diag_label(p->diags, parser_fail(p, DIAG_script_unguarded, s->span), DIAG_label_write,
                   format_in(p->arena, "%s: %s", when, parser_text(p, s->span)));
    } else {
        diag_label(p->diags, parser_report(p, DIAG_script_unguarded, s->span), DIAG_label_say_when);
    }
}

static void parse_if(Parser *p, AstStmts *into, AstExpr *guard);

static void parse_assignment(Parser *p, AstStmts *into)
{
    AstStmt *s = add_stmt(p, AST_ASSIGN, into);
    bool after_colon = p->last.kind == TOK_COLON;        // after a colon, `x = 1: y = 2` is two statements

    s->name = p->tok.text;
    s->name_span = s->span;
    parser_advance(p);
    p->assign_operator = parser_token_span(p);
    if (p->tok.kind != TOK_ASSIGN)
        hint_explain(p, HINT_AT_ASSIGN, NULL);
    parser_advance(p);
    s->value = parse_value_of(p, false);
    s->span = parser_span_since(p, s->span.at);
    if (!p->failed && !p->tok.first && (p->tok.kind == TOK_COLON || p->tok.kind == TOK_LBRACE) && !after_colon) {
        hint_explain(p, HINT_AFTER_ASSIGNMENT, NULL);  // `x = 5:` is a guard in which = means ==
        into->n--;
        parse_if(p, into, s->value);
    } else {
        report_if_unguarded(p, s);
    }
}

static void parse_transition(Parser *p, AstStmts *into)
{
    AstStmt *s = add_stmt(p, AST_TRANSITION, into);

    parser_advance(p);
    if (p->tok.kind == TOK_NAME && !p->tok.first) {
        s->name = p->tok.text;
        s->name_span = parser_token_span(p);
        parser_advance(p);
        s->span = parser_span_since(p, s->span.at);
        if (p->tok.kind == TOK_NAME && !p->tok.first && (p->ahead.first || p->ahead.kind == TOK_RBRACE || p->ahead.kind == TOK_END))
            s->kind = AST_STMT_ERROR;           // two names, as in `-> Tank Vent`: which state is meant is unknown
        if (in_script(p))
            diag_label(p->diags, parser_report(p, DIAG_script_transition, s->span), DIAG_label_script_transition, s->name->text, s->name->text);
        return;
    }
    s->kind = AST_STMT_ERROR;
    if (hint_explain(p, HINT_AT_TARGET, NULL) == HINT_SKIPPED)
        return;
    if (p->tok.kind == TOK_ERROR)
        p->failed = true;
    parser_fail(p, DIAG_transition_without_state, parser_missing_span(p), parser_describe_found(p));
}

// ---- items of scripts ----

typedef struct ItemWord { const char *word; AstStmtKind kind; } ItemWord;

static const ItemWord item_words[] = {
    {"assert", AST_ASSERT}, {"stop", AST_STOP}, {"fail", AST_FAIL}, {"expect", AST_EXPECT}, {"print", AST_PRINT}};

// Returns the item of a script that an annotation begins; NULL: none.
static const ItemWord *find_item_word(Str word)
{
    for (size_t i = 0; i < sizeof item_words / sizeof *item_words; i++)
        if (strcmp(item_words[i].word, word->text) == 0)
            return &item_words[i];
    return NULL;
}

static bool at_requirement(const Parser *p) { return p->tok.kind == TOK_ANNOTATION && strcmp(p->tok.text->text, "req") == 0; }

// Parses `@req R7`.
static void parse_requirement(Parser *p, AstRemark *r)
{
    Span at = parser_token_span(p);

    parser_advance(p);
    if (p->tok.first || p->tok.kind != TOK_NAME) {
        parser_fail(p, DIAG_requirement_name, parser_missing_span(p), parser_describe_found(p));
        return;
    }
    if (r->requirement)
        parser_report(p, DIAG_remark_twice, at, "requirement");
    r->requirement = p->tok.text;
    parser_advance(p);
}

// Parses `@req R7` after a statement of a machine, any number of times (requirements.md 13.19).
static void parse_marks(Parser *p, const AstStmts *list)
{
    AstStmt *s = list->n ? list->at[list->n - 1] : NULL;

    while (s && !p->failed && !p->tok.first && at_requirement(p)) {
        parser_advance(p);
        if (p->tok.first || p->tok.kind != TOK_NAME) {
            parser_fail(p, DIAG_requirement_name, parser_missing_span(p), parser_describe_found(p));
            return;
        }
        if (!s->marks)
            s->marks = ARENA_NEW(p->arena, AstNames);
        vec_push(p->arena, &s->marks->at, p->tok.text);
        vec_push(p->arena, &s->marks->span, parser_token_span(p));
        parser_advance(p);
    }
}

// Reports a comma between an item and its text, as in other languages.
static void skip_comma_before_text(Parser *p)
{
    Diag *d;

    if (p->tok.kind != TOK_COMMA || p->tok.first || p->ahead.kind != TOK_TEXT)
        return;
    d = parser_report(p, DIAG_comma_before_text, parser_token_span(p));
    diag_edit(p->diags, d, parser_token_span(p), "");
    parser_advance(p);
}

// Parses the text and the requirement of an item: `"the valve opens" @req R7`.
static void parse_remark(Parser *p, AstRemark *r)
{
    skip_comma_before_text(p);
    while (!p->failed && !p->tok.first && (p->tok.kind == TOK_TEXT || at_requirement(p))) {
        if (p->tok.kind == TOK_ANNOTATION) {
            parse_requirement(p, r);
            continue;
        }
        if (r->text)
            parser_report(p, DIAG_remark_twice, parser_token_span(p), "text");
        r->text = p->tok.text;
        parser_advance(p);
    }
}

// Parses `within 500 ms`.
static void parse_within(Parser *p, AstRemark *r)
{
    if (p->failed)
        return;
    if (p->tok.first || p->tok.kind != TOK_NAME || strcmp(p->tok.text->text, "within") != 0) {
        parser_fail(p, DIAG_expect_without_time, parser_missing_span(p), parser_describe_found(p));
        return;
    }
    parser_advance(p);
    r->within = parse_value_of(p, false);
}

// Parses the values of an @print.
static void parse_printed(Parser *p, AstRemark *r)
{
    AstExpr *value = parse_value_of(p, false);

    vec_push(p->arena, &r->values, value);
    while (!p->failed && p->tok.kind == TOK_COMMA && !p->tok.first && p->ahead.kind != TOK_TEXT) {
        parser_advance(p);
        value = parse_value_of(p, false);
        vec_push(p->arena, &r->values, value);
    }
}

static void parse_item(Parser *p, AstStmtKind kind, AstStmts *into)
{
    AstStmt *s = add_stmt(p, kind, into);
    AstRemark r = {0};

    parser_advance(p);
    p->is_expect = kind == AST_EXPECT;
    if (kind == AST_ASSERT || kind == AST_EXPECT)
        s->value = parse_value_of(p, true);
    p->is_expect = false;
    if (kind == AST_EXPECT)
        parse_within(p, &r);
    if (kind == AST_PRINT)
        parse_printed(p, &r);
    if (kind != AST_STOP)
        parse_remark(p, &r);
    if (kind == AST_FAIL && r.text && r.text->len == 0)
        parser_report(p, DIAG_fail_without_text, parser_span_since(p, s->span.at), "an empty text");
    if (kind == AST_FAIL && !r.text)
        parser_fail(p, DIAG_fail_without_text, parser_missing_span(p), parser_describe_found(p));
    if (kind == AST_PRINT && r.requirement)
        parser_report(p, DIAG_requirement_of_print, s->span);
    if (r.text || r.requirement || (kind != AST_ASSERT && kind != AST_STOP))
        s->remark = arena_copy(p->arena, &r, sizeof r);
    s->span = parser_span_since(p, s->span.at);
    report_if_unguarded(p, s);
}

static void parse_annotated(Parser *p, AstStmts *into)
{
    const ItemWord *item = find_item_word(p->tok.text);

    if (!item) {
        parser_report_annotation_in_block(p);
        return;
    }
    if (!in_script(p))
        diag_label(p->diags, parser_report(p, DIAG_script_only, parser_token_span(p), p->tok.text->text), DIAG_label_for_scripts);
    parse_item(p, item->kind, into);
}

// ---- @allow ----

// Parses the @allow annotations at the current token. The statement that they cover can follow on the same line.
static void parse_allows(Parser *p, AstStmts *into)
{
    while (parser_is_allow(&p->tok) && !p->failed) {
        AstStmt *s = add_stmt(p, AST_ALLOWED, into);
        if ((s->allow = parse_allow(p)) == NULL) {
            s->kind = AST_STMT_ERROR;
            return;
        }
        s->span = s->allow->span;
        if (p->tok.first)
            return;
    }
}

// ---- conditionals ----

// After an error in a guard: skips to the : or { that follows the guard, so that the statements after it are still parsed as a body.
static void recover_guard(Parser *p)
{
    while (!parser_at_end_of_block(p) && p->tok.kind != TOK_COLON && p->tok.kind != TOK_LBRACE && !p->tok.first)
        parser_advance(p);
    if (p->tok.kind == TOK_COLON || p->tok.kind == TOK_LBRACE)
        p->failed = false;
}

static void parse_colon_body(Parser *p, const AstStmt *s, AstStmts *into, bool *braces, Span *span)
{
    Span colon = parser_token_span(p);

    parser_advance(p);
    if (p->tok.kind == TOK_LBRACE) {
        Diag *d = parser_report(p, DIAG_colon_and_braces, colon);
        diag_label(p->diags, d, DIAG_label_no_colon);
        diag_edit(p->diags, d, colon, "");
        *braces = true;
        parse_braces(p, into, span);
        return;
    }
    if (p->tok.first || p->tok.kind == TOK_ASSIGN || p->tok.kind == TOK_ELSE || parser_at_end_of_block(p)) {
        const bool lines_below = p->tok.first && !parser_at_end_of_block(p) && p->tok.kind != TOK_ELSE;
        hint_explain(p, HINT_AFTER_COLON, s->arms->has_else ? NULL : s->value);
        if (lines_below)                      // the body is probably on the next line
            parse_statement(p, into);
        p->lost_body = true;
    } else {
        parse_statement(p, into);
    }
    report_allow_of_nothing(p, into);
    *span = parser_span_since(p, into->n ? into->at[0]->span.at : colon.at);
}

// Whether a ? follows the last token.
static bool is_before_choice(const Parser *p)
{
    const char *text = p->lex.src->text + p->last.at + p->last.len;

    return text[strspn(text, " \t")] == '?';
}

// Reports an expression that is neither a statement nor, because it has no body, a guard. With `if` before it, reports the missing body.
static void report_lone_value(Parser *p, AstExpr *e)
{
    if (is_before_choice(p))
        p->failed = true;                     // the lexer has reported `c ? a : b`
    else if (p->has_if)
        diag_label(p->diags, parser_fail(p, DIAG_guard_without_body, parser_gap_span(p), parser_describe_found(p)), DIAG_label_insert_braces),
        hint_cover_indented(p);
    else if (lexer_is_line_reported(&p->lex, e->span.at))
        e->kind = AST_ERROR;                  // print("on"), whose quoted text the lexer has reported
    else if (p->kind == FILE_SM && (e->kind == AST_NAME || e->kind == AST_CALL))
        e->alone = true;                      // the checker, which knows the declarations, reports it
    else
        hint_explain(p, HINT_AT_LONE_VALUE, e);
}

// Called if neither : nor { follows a guard or an `else`: reports that, and parses a statement on the same line as the body.
static void parse_bare_body(Parser *p, const AstStmt *s, AstStmts *into)
{
    if (p->failed)
        return;
    if (s->arms->has_else) {
        hint_explain(p, HINT_AFTER_ELSE, NULL);
    } else if (hint_explain(p, HINT_AFTER_GUARD, s->value) == HINT_NONE) {
        if (parser_at_end_of_statement(p))
            report_lone_value(p, s->value);
        else
            hint_explain(p, HINT_AT_END, NULL);
        if (p->failed && lexer_is_line_reported(&p->lex, s->value->span.at))
            s->value->kind = AST_ERROR;       // echo "on"
    }
    if (!p->failed && !p->tok.first &&
        (p->tok.kind == TOK_ARROW || p->tok.kind == TOK_NAME || p->tok.kind == TOK_ANNOTATION || p->tok.kind == TOK_IF))
        parse_statement(p, into);
    else
        p->failed = true;
}

static void parse_body(Parser *p, const AstStmt *s, AstStmts *into, bool *braces, Span *span)
{
    if (p->tok.kind == TOK_LBRACE) {
        *braces = true;
        parse_braces(p, into, span);
    } else if (p->tok.kind == TOK_COLON && !p->tok.first) {
        parse_colon_body(p, s, into, braces, span);
    } else {
        *span = parser_gap_span(p);
        parse_bare_body(p, s, into);
    }
    if (p->failed) {
        recover_statement(p);
        p->lost_body = true;
    }
}

// Reports an empty body of a script, unless an error inside it has been reported.
static void check_script_body(Parser *p, const AstStmts *body, Span span, size_t errors)
{
    if (in_script(p) && p->diags->errors == errors && body->n == 0)
        parser_report(p, DIAG_script_empty, span);
}

// Parses `else …` after s. Returns the conditional of an `else if`, whose guard comes next; else NULL.
static AstStmt *parse_else(Parser *p, AstStmt *s)
{
    const size_t errors = p->diags->errors;

    if (p->tok.kind != TOK_ELSE)
        return NULL;
    s->arms->has_else = true;
    s->arms->else_span = parser_token_span(p);
    parser_advance(p);
    if (p->tok.kind == TOK_IF && !p->tok.first)
        return add_stmt(p, AST_IF, &s->arms->otherwise);
    parse_body(p, s, &s->arms->otherwise, &s->arms->else_braces, &s->arms->else_body_span);
    check_script_body(p, &s->arms->otherwise, s->arms->else_span, errors);
    return NULL;
}

// Parses the guard, the body and every `else if` of a conditional. Each `else if` is one level deeper in the tree, so it counts as nesting.
static void parse_branches(Parser *p, AstStmt *s)
{
    while (s) {
        size_t errors = p->diags->errors;
        if (!enter_nesting(p)) {
            s->kind = AST_STMT_ERROR;
            return;
        }
        p->has_if = p->tok.kind == TOK_IF;
        if (p->has_if)
            parser_advance(p);
        if (p->has_if && (p->tok.first || p->tok.kind == TOK_COLON || p->tok.kind == TOK_LBRACE || parser_at_end_of_block(p)) && !s->value)
            parser_fail(p, DIAG_if_without_guard, parser_span(p, &p->last));
        if (!s->value && parser_at_when(p))
            s->value = parse_when(p);
        if (!s->value)
            s->value = p->has_if ? parse_value_of(p, true) : parse_expr(p, false);
        s->span = parser_span_since(p, s->span.at);
        if (p->failed)
            recover_guard(p);
        parse_body(p, s, &s->arms->then, &s->arms->braces, &s->arms->body_span);
        if (s->value->kind != AST_ERROR)
            check_script_body(p, &s->arms->then, s->span, errors);
        s = parse_else(p, s);
    }
}

// Parses a conditional. `guard`: the guard, if it has already been parsed; else NULL.
static void parse_if(Parser *p, AstStmts *into, AstExpr *guard)
{
    unsigned nesting = p->nesting;
    AstStmt *s = add_stmt(p, AST_IF, into);

    s->value = guard;
    if (guard)
        s->span = guard->span;
    parse_branches(p, s);
    p->nesting = nesting;
}

// Reports an `else` that follows no conditional, and skips its body.
static void report_stray_else(Parser *p)
{
    AstArms arms = {0};
    AstStmt s = {.arms = &arms};

    if (!p->lost_body)
        diag_label(p->diags, parser_report(p, DIAG_else_without_if, parser_token_span(p)), DIAG_label_else_alone);
    p->lost_body = true;
    if (!enter_nesting(p))
        return;
    arms.has_else = true;
    parser_advance(p);
    if (p->tok.first)
        p->failed = true;
    else if (p->tok.kind == TOK_IF && !p->tok.first)
        parse_if(p, &arms.otherwise, NULL);
    else
        parse_body(p, &s, &arms.otherwise, &arms.else_braces, &arms.else_body_span);
    p->nesting--;
}

// ---- a statement ----

static bool begins_guard(TokenKind k)
{
    return k == TOK_IF || k == TOK_NAME || k == TOK_NUMBER || k == TOK_LPAREN || k == TOK_TRUE || k == TOK_FALSE ||
           k == TOK_NOT || k == TOK_BANG || k == TOK_MINUS || k == TOK_PLUS;
}

static bool is_assignment_operator(TokenKind k)
{
    return k == TOK_ASSIGN || k == TOK_OP_ADD || k == TOK_OP_SUB || k == TOK_OP_MUL || k == TOK_OP_DIV;
}

// Parses a statement without the marks after it.
static void parse_unmarked(Parser *p, AstStmts *into)
{
    if (!in_script(p) && parser_is_allow(&p->tok)) {
        parse_allows(p, into);
        if (p->failed || p->tok.first || parser_at_end_of_block(p))
            return;
    }
    if (p->tok.kind == TOK_ERROR)
        p->failed = true;
    else if (parser_at_include(p))
        parser_report_late_include(p);
    else if (parser_at_when(p))
        parse_if(p, into, NULL);
    else if (hint_explain(p, HINT_AT_STATEMENT, NULL) == HINT_SKIPPED)
        return;
    else if (p->tok.kind == TOK_NAME && is_assignment_operator(p->ahead.kind) && !p->ahead.first)
        parse_assignment(p, into);
    else if (p->tok.kind == TOK_ARROW)
        parse_transition(p, into);
    else if (p->tok.kind == TOK_ELSE)
        report_stray_else(p);
    else if (p->tok.kind == TOK_LBRACE)
        report_unguarded_braces(p);
    else if (p->tok.kind == TOK_ANNOTATION)
        parse_annotated(p, into);
    else if (begins_guard(p->tok.kind))
        parse_if(p, into, NULL);
    else
        parser_fail(p, DIAG_expected_statement, parser_token_span(p), parser_describe(p, &p->tok));
}

static void parse_statement(Parser *p, AstStmts *into)
{
    const size_t before = into->n;

    parse_unmarked(p, into);
    if (p->tok.kind == TOK_ANNOTATION && !in_script(p) && into->n > before)
        parse_marks(p, into);
}
