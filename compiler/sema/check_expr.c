// SPDX-License-Identifier: Apache-2.0
// Checks expressions (language.md 3) and builds typed ones: binds names, flattens chains of relations, drops parentheses and unary plus.
// Functions that return an Expr return NULL after an error, which they or the functions that they call have reported.
// Recursion depth equals the depth of the tree, which AST_DEPTH_MAX bounds.
#include "compiler/sema/sema.h"

#include <string.h>

#include "compiler/syntax/lex.h"
#include "stdlib/convert.h"
#include "stdlib/math.h"

Expr *expr_new(Sema *s, ExprKind kind, Span span, uint32_t args)
{
    const size_t ops = kind == EX_CHAIN ? (args - 1) * sizeof(SmOperator) : 0;
    Expr *e = arena_alloc(s->nodes, sizeof *e + args * sizeof *e->arg + ops);

    e->kind = kind;
    e->span = sema_span(s, span);
    e->n = args & 0xffffff;              // e->n has 24 bits, and AST_DEPTH_MAX limits the number of arguments
    return e;
}

// Checks all n arguments, even after an error in one, so that all errors are found.  Returns whether all are valid.
static bool check_args(Sema *s, AstExpr *const *in, uint32_t n, Expr **out)
{
    bool good = true;

    for (uint32_t i = 0; i < n; i++) {
        out[i] = check_expr(s, in[i]);
        good = good && out[i];
    }
    return good;
}

// ---- names ----

// Returns whether the initial value of a local can read v: a local that is declared before it, has a value, and is no parameter.  Reports the use if
// not, unless v has no value because of an error.
static bool check_use_in_initial(Sema *s, const Var *v, const AstExpr *e)
{
    Diag *d;

    if (v->kind != VAR_LOCAL)
        d = diag_report(s->diags, DIAG_initial_value_varies, e->span, s->local->name->text, e->name->text,
                        v->kind == VAR_TIME ? "the time in the state" : "an element");
    else if (v == s->local)
        d = diag_report(s->diags, DIAG_initial_value_of_itself, e->span, e->name->text);
    else if (v->index > s->local->index)
        d = diag_report(s->diags, DIAG_initial_value_later, e->span, s->local->name->text, e->name->text);
    else if (v->parameter) {
        report_parameter_in_initial(s, v, e);
        return false;
    } else
        return !s->no_value[v->index];
    if (v != s->local)
        scope_note_declared(s, d, e->name);
    return false;
}

// Returns whether the size of a window can depend on v.  Reports v if it is not a local: the size is computed at compile time, from the
// initial values of locals.
static bool check_use_in_size(Sema *s, Var *v, const AstExpr *e)
{
    SizeUse use = {v, e->span};
    Diag *d;

    if (v->kind != VAR_LOCAL) {
        d = diag_report(s->diags, DIAG_window_size_varies, e->span, s->size_of->text, e->name->text,
                        v->kind == VAR_TIME ? "the time in the state" : "an element");
        scope_note_declared(s, d, e->name);
        return false;
    }
    if (v->parameter) {
        report_parameter_in_size(s, v, e);
        return false;
    }
    v->sizes |= !s->in_script;
    vec_push(s->arena, &s->size_use, use);
    return !s->no_value || !s->no_value[v->index];
}

static Expr *check_name(Sema *s, const AstExpr *e)
{
    Var *v = scope_find_variable(s, e->name);
    Define *define;
    Expr *out;

    if (!v && (define = map_find(&s->defines, e->name)) != NULL)
        return expand_definition(s, define, e);
    if (!v) {
        scope_report_unknown(s, e->name, e->span);
        return NULL;
    }
    if (!s->in_script)
        v->read = true;
    s->varies |= v->kind != VAR_LOCAL;
    s->knows_a_name |= v != s->p->g && !v->state_of && v->kind != VAR_TIME;
    if (scope_is_doubtful(s, e->name) || (s->at == EXPR_IN_INITIAL && !check_use_in_initial(s, v, e)) ||
        (s->at == EXPR_IN_SIZE && !check_use_in_size(s, v, e)))
        return NULL;
    out = expr_new(s, EX_VAR, e->span, 0);
    out->var = v;
    return out;
}

// Builds a literal.  Records whether the machine has a literal of 2^53 or more: analyses that need every whole number to be exact in F64
// then find less.
static Expr *check_number(Sema *s, const AstExpr *e)
{
    Expr *out = expr_new(s, EX_NUMBER, e->span, 0);

    out->number = e->unit ? check_time_literal(s, e) : e->number;
    out->unit = e->unit;
    if (s->building && e->number >= 9007199254740992.0)          // 2^53
        s->building->large_numbers = true;
    return out;
}

// ---- operators ----

static SmOpClass operator_class(const AstExpr *e)
{
    return sm_op_info[e->op].op_class;
}

static bool is_relation(const AstExpr *e)
{
    return e->kind == AST_BINARY && operator_class(e) == SM_CLASS_RELATION;
}

void sema_record_operator(Sema *s, SmOperator op)
{
    s->operators |= 1u << op;
    if (s->building)
        s->building->operators |= 1u << op;
}

// Returns a part of the source for a diagnostic: on one line, shortened to a readable length.
const char *sema_quote_source(Sema *s, Span span)
{
    enum { LONGEST = 60 };
    const char *text = span.src->text + span.at;
    uint32_t n = 0;

    while (n < span.len && n < LONGEST && text[n] != '\n' && text[n] != '\r' && text[n] != '#')
        n++;
    return format_in(s->arena, "%.*s%s", (int)n, text, n < span.len ? " ..." : "");
}

// Returns the source text from position `from` to the end of `to`.
static Span span_between(uint32_t from, Span to)
{
    Span span = {to.src, from, to.at + to.len - from};
    return span;
}

// Warns of `not a == b`: it means `(not a) == b`, which is rarely intended.  The diagnostic shows both readings (language.md 3.13).
// Called for every operator of an expression, outer ones first.  Operators that are nested on the left share one leftmost operand, which
// only the first of these calls examines.
static void warn_of_leading_not(Sema *s, const AstExpr *e)
{
    const AstExpr *left = e;
    bool searched = s->searched_left == e;
    Diag *d;

    if (operator_class(e) == SM_CLASS_LOGIC)
        return;
    s->searched_left = e->a;
    if (searched)
        return;
    while (left->kind == AST_BINARY)
        left = left->a;
    if (left->kind != AST_UNARY || left->op != SM_OP_NOT)
        return;
    d = diag_report(s->diags, DIAG_not_binds_tight, left->span);
    diag_note(s->diags, d, (Span){0}, DIAG_note_not_as_written, sema_quote_source(s, left->a->span),
              sema_quote_source(s, span_between(left->span.at + left->span.len, e->span)));
    diag_note(s->diags, d, (Span){0}, DIAG_note_not_of_all, sema_quote_source(s, span_between(left->a->span.at, e->span)));
}

// Returns the last comparison in e, the left side of an `and` or `or`: for `x or a == 1` the `a == 1`.  NULL if e does not end with one.
static const AstExpr *comparison_before(const AstExpr *e)
{
    while (e->kind == AST_BINARY && operator_class(e) == SM_CLASS_LOGIC)
        e = e->b;
    return e->kind == AST_BINARY && (operator_class(e) == SM_CLASS_RELATION || operator_class(e) == SM_CLASS_EQUALITY) ? e : NULL;
}

// Whether a number may be intended as a condition: 0, 1, true or false, as in `steps and 1`.  After a comparison such as `mode == 2`, a 0
// or 1 is probably another value of `mode`.
static bool may_be_switch(const AstExpr *number, const char *text, const AstExpr *before)
{
    const bool is_word = strcmp(text, "true") == 0 || strcmp(text, "false") == 0;

    return is_word || ((sm_eq(number->number, sm_from_i32(0)) || sm_eq(number->number, sm_from_i32(1))) &&
                       !(before && before->op == SM_OP_EQ && before->b->kind == AST_NUMBER));
}

// Warns of an operand such as the 2 in `mode == 1 or 2`: the user means `mode == 2`, but every number except 0 is true.
static void warn_of_number_as_condition(Sema *s, const AstExpr *logic, const AstExpr *number)
{
    const AstExpr *before = number == logic->b ? comparison_before(logic->a) : NULL;
    const char *text;
    Diag *d;

    if (number->kind != AST_NUMBER)
        return;
    text = sema_quote_source(s, number->span);
    if (may_be_switch(number, text, before))
        return;
    d = diag_report(s->diags, DIAG_number_as_condition, number->span, text, sm_to_bool(number->number) ? "always" : "never");
    if (before)
        diag_label(s->diags, d, DIAG_label_did_you_mean,
                   format_in(s->arena, "%s %s %s", sema_quote_source(s, before->a->span), sm_op_info[before->op].spelling, text));
}

// Warns of a right side such as in `mode == not 5`: the user means `mode != 5`, but `not 5` is 0.
static void warn_of_negated_number(Sema *s, const AstExpr *e)
{
    const AstExpr *not = e->b, *number = not->a;
    Diag *d;

    if (not->kind != AST_UNARY || not->op != SM_OP_NOT || number->kind != AST_NUMBER ||
        may_be_switch(number, sema_quote_source(s, number->span), NULL))
        return;
    d = diag_report(s->diags, DIAG_number_as_condition, not->span, sema_quote_source(s, not->span), "never");
    if (e->op == SM_OP_EQ)
        diag_label(s->diags, d, DIAG_label_did_you_mean,
                   format_in(s->arena, "%s != %s", sema_quote_source(s, e->a->span), sema_quote_source(s, number->span)));
}

// Warns of time literals that a comparison or a product of a and b probably misuses.
static void warn_of_times(Sema *s, SmOperator op, const AstExpr *a, const AstExpr *b)
{
    const SmOpClass class = sm_op_info[op].op_class;

    if (op == SM_OP_MUL || op == SM_OP_DIV)
        warn_of_time_factors(s, a, b);
    if (class == SM_CLASS_RELATION || class == SM_CLASS_EQUALITY) {
        warn_of_time_fraction(s, a, b);
        warn_of_time_fraction(s, b, a);
    }
}

static Expr *check_binary(Sema *s, const AstExpr *e)
{
    AstExpr *operands[2] = {e->a, e->b};
    Expr *out;

    if (check_state_names(s, e, &out))
        return out;
    for (int k = 0; k < 2 && operator_class(e) == SM_CLASS_LOGIC; k++)
        warn_of_number_as_condition(s, e, operands[k]);
    if (operator_class(e) == SM_CLASS_EQUALITY) {
        if (s->in_script && report_compared_state_value(s, e))
            return NULL;
        warn_of_negated_number(s, e);
        warn_of_state_number(s, e);
    }
    warn_of_times(s, e->op, e->a, e->b);
    sema_record_operator(s, e->op);
    out = expr_new(s, EX_BINARY, e->span, 2);
    out->op = e->op;
    return check_args(s, operands, 2, out->arg) ? out : NULL;
}

// Flattens (a < b) <= c without parentheses into one EX_CHAIN of a, b, c.
static Expr *check_chain(Sema *s, const AstExpr *e)
{
    uint32_t n = 2, i;
    const AstExpr *first = e->a;
    AstExpr **operand;
    Expr *out;

    for (; is_relation(first); first = first->a)
        n++;
    out = expr_new(s, EX_CHAIN, e->span, n);
    operand = ARENA_ARRAY(s->arena, AstExpr *, n);
    for (i = n - 1; i > 0; i--, e = e->a) {
        operand[i] = e->b;
        operand[0] = e->a;
        expr_ops(out)[i - 1] = e->op;
        sema_record_operator(s, e->op);
        warn_of_times(s, e->op, is_relation(e->a) ? e->a->b : e->a, e->b);
    }
    s->searched_left = operand[0];
    return check_args(s, operand, n, out->arg) ? out : NULL;
}

static Expr *check_unary(Sema *s, const AstExpr *e)
{
    Expr *out;

    if (e->op == SM_OP_PLUS)
        return check_expr(s, e->a);
    sema_record_operator(s, e->op);
    out = expr_new(s, EX_UNARY, e->span, 1);
    out->op = e->op;
    out->arg[0] = check_expr(s, e->a);
    return out->arg[0] ? out : NULL;
}

// ---- calls ----

// For a min or max with too many arguments, suggests nested calls, such as max(max(a, b), c), and proposes the edits.
static void suggest_nested_calls(Sema *s, Diag *d, const AstExpr *e)
{
    const AstArgs *args = e->args;
    const Span first = args->at[0]->span;
    const char *calls = "", *text = sema_quote_source(s, first);

    for (size_t i = 1; i < args->n; i++) {
        const Span span = args->at[i]->span;
        const bool last = i + 1 == args->n;
        text = format_in(s->arena, "%s(%s, %s)", e->name->text, text, sema_quote_source(s, span));
        if (!last) {
            calls = format_in(s->arena, "%s%s(", calls, e->name->text);
            diag_edit(s->diags, d, (Span){span.src, span.at + span.len, 0}, ")");
        }
    }
    diag_edit(s->diags, d, (Span){first.src, first.at, 0}, calls);
    diag_label(s->diags, d, DIAG_label_write, text);
}

// Returns the comma after e if it is directly between the digits of two whole numbers, as in 0,5; otherwise an empty span.
static Span decimal_comma_after(const AstExpr *e)
{
    const char *text = e->span.src->text;
    const uint32_t comma = e->span.at + e->span.len;
    uint32_t from = comma, end = comma + 1;

    if (text[comma] != ',')
        return (Span){e->span.src, comma, 0};
    while (from > e->span.at && (lex_is_letter(text[from - 1]) || lex_is_digit(text[from - 1]) || text[from - 1] == '.'))
        from--;
    while (lex_is_letter(text[end]) || lex_is_digit(text[end]) || text[end] == '.')
        end++;
    for (uint32_t at = from; at < end; at++)
        if (at != comma && !lex_is_digit(text[at]))
            return (Span){e->span.src, comma, 0};
    return (Span){e->span.src, comma, from < comma && end > comma + 1};
}

// Reports a call such as sqrt(0,5), where a comma in a number adds an argument.  Returns false, and reports nothing, if there is no such comma.
// With `is_valid`, as in min(p, 0,5), the report is a warning, because the call has a meaning.
static bool report_decimal_comma(Sema *s, const AstExpr *e, bool is_valid)
{
    for (size_t i = 0; i + 1 < e->args->n; i++) {
        const Span comma = decimal_comma_after(e->args->at[i]);
        if (comma.len > 0) {
            const char *text = comma.src->text;
            uint32_t from = comma.at, end = comma.at + 1;
            while (lex_is_digit(text[from - 1]))
                from--;
            while (lex_is_digit(text[end]))
                end++;
            const char *whole = format_in(s->arena, "%.*s", (int)(comma.at - from), text + from);
            const char *part = format_in(s->arena, "%.*s", (int)(end - comma.at - 1), text + comma.at + 1);
            diag_label(s->diags, is_valid ? diag_report(s->diags, DIAG_two_numbers, comma, whole, part)
                       : diag_report(s->diags, DIAG_decimal_comma, comma),
                       DIAG_label_decimal_point, whole, part);
            return true;
        }
    }
    return false;
}

static void report_argument_count(Sema *s, const AstExpr *e, const SmBuiltinInfo *fn)
{
    const bool is_list = fn->most > fn->arguments;
    const char *wanted = is_list ? format_in(s->arena, "%u to %u arguments", fn->arguments, fn->most)
                                 : format_in(s->arena, "%u argument%s", fn->arguments, fn->arguments == 1 ? "" : "s");
    const char *found = format_in(s->arena, "%lu", (unsigned long)e->args->n);
    const char *first = e->args->n ? sema_quote_source(s, e->args->at[0]->span) : "";
    const SmBuiltin id = (SmBuiltin)(fn - sm_builtin_info);
    const bool is_extremum = id == SM_FN_min || id == SM_FN_max;
    Diag *d = diag_report(s->diags, DIAG_argument_count, ast_op_span(e), fn->name, wanted, found);

    if (is_extremum && e->args->n > fn->most)
        suggest_nested_calls(s, d, e);
    else if (is_list && e->args->n == 1)
        diag_label(s->diags, d, DIAG_label_write_call, e->name->text,
                   format_in(s->arena, "(a, b), or for the last n steps roll_%s(%s, n)", id == SM_FN_average ? "avg" : e->name->text, first));
    else if (id == SM_FN_round && e->args->n == 2)
        diag_label(s->diags, d, DIAG_label_round_digits, first);
    else
        diag_label(s->diags, d, DIAG_label_write_call, fn->name, fn->usage);
}

static Expr *check_call(Sema *s, const AstExpr *e)
{
    const SmBuiltinInfo *fn = scope_find_function(s, e->name);
    bool readable = true;                         // false: an argument has a syntax error, so the number of arguments is uncertain
    size_t before;
    Expr *out;

    if (s->random && is_random_function(e->name))
        return check_random_call(s, e);
    if (fn && e->args->n >= fn->arguments && e->args->n <= fn->most) {
        if (fn->is_roll)
            return check_roll_call(s, e, fn);
        if (fn->is_sampled)
            return check_sampled_call(s, e, (SmBuiltin)(fn - sm_builtin_info));
        if (fn->most > fn->arguments)
            return report_decimal_comma(s, e, true), check_list_call(s, e, fn);
        out = expr_new(s, EX_CALL, e->span, fn->arguments);
        out->fn = (SmBuiltin)(fn - sm_builtin_info);
        return check_args(s, e->args->at, fn->arguments, out->arg) ? out : NULL;
    }
    for (size_t i = 0; i < e->args->n; i++)
        readable = readable && e->args->at[i]->kind != AST_ERROR;
    if (!fn && is_random_function(e->name))
        report_random_in_machine(s, e);
    else if (!fn)
        scope_report_unknown_function(s, e->name, ast_op_span(e));
    else if (readable && (e->args->n < fn->arguments || !report_decimal_comma(s, e, false)))
        report_argument_count(s, e, fn);
    before = s->diags->list.n;
    if (s->at == EXPR_IN_STEP)                    // checks the arguments only to report their errors
        for (size_t i = 0; i < e->args->n; i++)
            check_expr(s, e->args->at[i]);
    for (size_t i = before; i < s->diags->list.n; i++)
        s->diags->list.at[i]->follows |= !fn;     // digitalWrite(LED, HIGH) is one mistake
    return NULL;
}

// Builds `a implies b`: not a, or b.
static Expr *check_implication(Sema *s, const AstExpr *e)
{
    Expr *out = expr_new(s, EX_BINARY, e->span, 2), *not = expr_new(s, EX_UNARY, e->a->span, 1);

    sema_record_operator(s, SM_OP_NOT);
    sema_record_operator(s, SM_OP_OR);
    not->op = SM_OP_NOT;
    not->arg[0] = check_expr(s, e->a);
    out->op = SM_OP_OR;
    out->arg[0] = not;
    out->arg[1] = check_expr(s, e->b);
    return not->arg[0] && out->arg[1] ? out : NULL;
}

static Expr *check_kind(Sema *s, const AstExpr *e)
{
    switch (e->kind) {
    case AST_ERROR:  return NULL;
    case AST_NUMBER: return check_number(s, e);
    case AST_NAME:   return check_name(s, e);
    case AST_UNARY:  return check_unary(s, e);
    case AST_BINARY:
        warn_of_leading_not(s, e);
        return is_relation(e) && is_relation(e->a) ? check_chain(s, e) : check_binary(s, e);
    case AST_PAREN:  return check_expr(s, e->a);
    case AST_STEPS:
        diag_report(s->diags, DIAG_steps_misplaced, e->span, sema_quote_source(s, e->a->span));
        return NULL;
    case AST_IMPLIES: return check_implication(s, e);
    case AST_CALL:   return check_call(s, e);
    case AST_STATE_NAME: return check_state_value(s, e);
    case AST_WHEN:   return check_when(s, e);
    }
    return NULL;
}

// Checks an expression and returns its typed form; NULL after an error, which is reported.
Expr *check_expr(Sema *s, const AstExpr *e)
{
    Expr *out;

    s->depth++;
    out = check_kind(s, e);
    s->depth--;
    return out;
}

// ---- after all expressions ----

// Warns of windows whose size depends on a local that the machine assigns.
void check_size_uses(Sema *s)
{
    for (size_t i = 0; i < s->size_use.n; i++) {
        const SizeUse *use = &s->size_use.at[i];
        if (use->local->written) {
            Diag *d = diag_report(s->diags, DIAG_window_size_of_variable, use->span, use->local->name->text);
            diag_note(s->diags, d, use->local->span, DIAG_note_declared_here, use->local->name->text);
        }
    }
}
