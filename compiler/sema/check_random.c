// SPDX-License-Identifier: Apache-2.0
// random(lo, hi) and noise(sigma), which only scripts have (language.md 8.48 to 8.53): gives each call a number, and checks its arguments.
#include "compiler/sema/sema.h"

#include <string.h>

static bool is_noise(Str name) { return strcmp(name->text, "noise") == 0; }

bool is_random_function(Str name) { return strcmp(name->text, "random") == 0 || is_noise(name); }

// ---- numbering of calls, in the order of the text ----

static bool is_at(Span a, Span b) { return a.src == b.src && a.at == b.at; }

// Returns the number of the call whose name is at `name`, from 0; a new one if it has none.  Calls come in the order of the text, except those
// in definitions, which are checked again for each use.
static uint32_t number_call(Sema *s, Span name)
{
    const ScriptRandoms *all = s->random;
    ScriptRandom new = {.span = name};
    uint32_t i = all->n;
    const bool is_next = i == 0 || all->at[i - 1].span.src != name.src || all->at[i - 1].span.at < name.at;

    if (s->inside || !is_next)
        while (i > 0)
            if (is_at(all->at[--i].span, name))
                return i;
    vec_push(s->arena, s->random, new);
    return all->n - 1;
}

// Numbers the calls in the expression of a definition.
static void number_calls_in(Sema *s, const AstExpr *e)
{
    if (e->kind == AST_CALL && is_random_function(e->name))
        number_call(s, ast_op_span(e));
    if (e->a)
        number_calls_in(s, e->a);
    if (e->b)
        number_calls_in(s, e->b);
    for (size_t i = 0; e->args && i < e->args->n; i++)
        number_calls_in(s, e->args->at[i]);
}

// Numbers the calls of random functions in the script's definitions.
void number_random_definitions(Sema *s, const AstFile *ss)
{
    for (size_t i = 0; i < ss->sections.n; i++)
        for (size_t k = 0; k < ss->sections.at[i]->definitions.n; k++)
            number_calls_in(s, ss->sections.at[i]->definitions.at[k].value);
}

// ---- calls ----

static Expr *report_misplaced_call(Sema *s, const AstExpr *e)
{
    diag_report(s->diags, DIAG_random_place, e->span, e->name->text, s->at == EXPR_IN_INITIAL ? "an initial value" : "the size of a window");
    return NULL;
}

static Expr *report_argument_count(Sema *s, const AstExpr *e)
{
    Diag *d = diag_report(s->diags, DIAG_argument_count, ast_op_span(e), e->name->text, is_noise(e->name) ? "1 argument" : "2 arguments",
                          format_in(s->arena, "%lu", (unsigned long)e->args->n));

    diag_label(s->diags, d, DIAG_label_write_call, e->name->text, is_noise(e->name) ? "(sigma)" : "(lo, hi)");
    return NULL;
}

// Checks an argument, which is a constant: then the value is a function of the seed, the number of the call and the step alone.
static bool check_argument(Sema *s, const AstExpr *call, const AstExpr *in, double *out)
{
    const Expr *e = check_expr(s, in);
    Diag *d;

    if (!e)
        return false;
    if (expr_is_constant(e)) {
        *out = expr_constant_value(e);
        return true;
    }
    d = diag_report(s->diags, DIAG_random_argument, in->span, call->name->text);
    if (is_noise(call->name))
        diag_label(s->diags, d, DIAG_label_random_scale, sema_quote_source(s, in->span));
    return false;
}

Expr *check_random_call(Sema *s, const AstExpr *e)
{
    const size_t arguments = is_noise(e->name) ? 1 : 2;
    double value[2] = {0, 0};
    uint32_t number;
    bool good = true;
    Expr *out;

    if (s->at != EXPR_IN_STEP)
        return report_misplaced_call(s, e);
    number = number_call(s, ast_op_span(e));
    if (e->args->n != arguments)
        return report_argument_count(s, e);
    for (size_t i = 0; i < arguments; i++)
        good &= check_argument(s, e, e->args->at[i], &value[i]);
    if (!good)
        return NULL;
    s->random->at[number].is_noise = is_noise(e->name);
    s->random->at[number].a = value[0];
    s->random->at[number].b = value[1];
    s->varies = true;
    out = expr_new(s, EX_RANDOM, e->span, 0);
    out->window = number;
    return out;
}

void report_random_in_machine(Sema *s, const AstExpr *e) { diag_report(s->diags, DIAG_random_in_machine, ast_op_span(e), e->name->text); }
