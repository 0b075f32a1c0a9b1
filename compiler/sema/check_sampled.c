// SPDX-License-Identifier: Apache-2.0
// Calls that sample an argument at the start of every step (language.md 7): roll_avg and similar, prev, rising, falling, held and rate.  Each
// becomes statistics of windows.
#include "compiler/sema/sema.h"

#include "stdlib/convert.h"
#include "stdlib/math.h"

// ---- the second argument: a size or a time that is known at compile time ----

// What the second argument of a call means.
typedef enum Duration { DURATION_INVALID, DURATION_STEPS, DURATION_NUMBER, DURATION_TIME } Duration;

// Reads the size of a window, or the time of held: sets *value to the number, or the time in units of G. Returns DURATION_INVALID after a report.
static Duration read_duration(Sema *s, const AstExpr *call, SmF64 *value)
{
    const AstExpr *n = call->args->at[1];
    const bool steps = n->kind == AST_STEPS;
    Diag *d;
    Expr *e;

    s->at = EXPR_IN_SIZE;
    s->size_of = call->name;
    e = check_expr(s, steps ? n->a : n);
    s->at = EXPR_IN_STEP;
    if (!e)
        return DURATION_INVALID;
    *value = expr_constant_value(e);
    if (e->kind == EX_NUMBER && e->unit != TIME_NONE && !steps)
        return DURATION_TIME;
    if (!expr_contains_time(e))
        return steps ? DURATION_STEPS : DURATION_NUMBER;
    d = diag_report(s->diags, DIAG_window_size_of_time, n->span, call->name->text);
    if (e->kind == EX_VAR && e->var->init_value->kind == EX_NUMBER && !steps)
        diag_label(s->diags, d, DIAG_label_time_definition, e->var->name->text);
    return DURATION_INVALID;
}

// Returns the number of steps as an integer; 0 after reporting that it is not a whole number from 1 to SM_WINDOW_MAX.
static uint32_t check_step_count(Sema *s, const AstExpr *call, SmF64 x)
{
    const Span span = call->args->at[1]->span;

    if (!sm_eq(sm_trunc(x), x))
        diag_report(s->diags, DIAG_window_size_not_whole, span, call->name->text, const_text(s->arena, x));
    else if (sm_lt(x, sm_from_i32(1)) || sm_lt(sm_from_u32(SM_WINDOW_MAX), x))
        diag_report(s->diags, DIAG_window_size_range, span, call->name->text, const_text(s->arena, x));
    else
        return sm_to_u32(x);
    return 0;
}

// Returns how many steps the window of a roll call or a rate has, or 0 after a report.
static uint32_t check_window_size(Sema *s, const AstExpr *call, bool *in_time)
{
    SmF64 x;
    const Duration d = read_duration(s, call, &x);

    *in_time = d == DURATION_TIME;
    if (d == DURATION_INVALID || (*in_time && !check_window_time(s, call->args->at[1], call->name->text, x, &x)))
        return 0;
    return check_step_count(s, call, x);
}

// Reports a number without a unit. A fraction cannot be a number of steps. Only a number or a name can precede `steps`, and only a number a unit.
static void report_held_number(Sema *s, const AstExpr *n, SmF64 limit)
{
    const char *const number = n->kind == AST_NUMBER ? sema_quote_source(s, n->span) : const_text(s->arena, limit);
    Diag *d = diag_report(s->diags, DIAG_held_number, n->span);

    if (sm_eq(sm_trunc(limit), limit))
        diag_label(s->diags, d, DIAG_label_held, n->kind == AST_NAME ? n->name->text : number, number,
                   s->p->time_unit == TIME_NONE ? "ms" : time_unit_name(s->p->time_unit));
    else
        diag_label(s->diags, d, DIAG_label_held_unit, number);
}

// Checks the time or the number of steps of held. Sets *limit to it, or to 0 after a report.
static Duration check_held_duration(Sema *s, const AstExpr *call, SmF64 *limit)
{
    const Duration d = read_duration(s, call, limit);
    const Span span = call->args->at[1]->span;
    const char *number = sema_quote_source(s, span);

    if (d == DURATION_STEPS) {
        *limit = sm_from_u32(check_step_count(s, call, *limit));
        return d;
    }
    if (d == DURATION_TIME && sm_eq(sm_trunc(*limit), *limit) && sm_le(sm_from_i32(1), *limit) && sm_le(*limit, sm_from_u64(UINT64_C(1) << 53)))
        return d;
    if (d == DURATION_TIME)
        diag_report(s->diags, DIAG_held_time, span, number, time_unit_name(s->p->time_unit));
    else if (d == DURATION_NUMBER)
        report_held_number(s, call->args->at[1], *limit);
    *limit = sm_from_i32(0);
    return d;
}

// Builds a statistic of a window of `size` samples.
static Expr *new_statistic(Sema *s, const AstExpr *call, Expr *sample, uint32_t size, SmStat stat)
{
    Expr *e = expr_new(s, EX_ROLL, call->span, 1);
    const Window w = {.sample = sample, .size = size, .stat = stat, .time = s->p->g, .span = e->span};

    e->arg[0] = sample;
    e->stat = stat;
    e->window = (uint32_t)s->windows->n;
    vec_push(s->arena, s->windows, w);
    return e;
}

// Returns whether a function that samples its argument is allowed in the current context; reports the call if it is not.
static bool check_samples_allowed(Sema *s, const AstExpr *call)
{
    s->varies = true;
    if (s->at == EXPR_IN_INITIAL)
        diag_report(s->diags, DIAG_initial_value_rolls, ast_op_span(call), s->local->name->text, call->name->text);
    else if (s->at == EXPR_IN_SIZE)
        diag_report(s->diags, DIAG_window_size_rolls, ast_op_span(call), s->size_of->text, call->name->text);
    return s->at == EXPR_IN_STEP;
}

Expr *check_roll_call(Sema *s, const AstExpr *call, const SmBuiltinInfo *fn)
{
    Expr *sample, *out;
    uint32_t size;
    bool in_time;

    if (!check_samples_allowed(s, call))
        return NULL;
    sample = check_expr(s, call->args->at[0]);                 // checked first, so that windows in the sample have lower indices
    size = check_window_size(s, call, &in_time);
    if (!sample || !size)
        return NULL;
    out = new_statistic(s, call, sample, size, fn->stat);
    s->windows->at[out->window].in_time = in_time;
    return out;
}

// ---- functions that remember their argument ----

static Expr *new_not(Sema *s, const AstExpr *call, Expr *x)
{
    Expr *e = expr_new(s, EX_UNARY, call->span, 1);

    sema_record_operator(s, SM_OP_NOT);
    e->op = SM_OP_NOT;
    e->arg[0] = x;
    return e;
}

static Expr *new_number(Sema *s, const AstExpr *call, SmF64 number)
{
    Expr *e = expr_new(s, EX_NUMBER, call->span, 0);

    e->number = number;
    return e;
}

static Expr *new_operation(Sema *s, const AstExpr *call, SmOperator op, Expr *a, Expr *b)
{
    Expr *e = expr_new(s, EX_BINARY, call->span, 2);

    sema_record_operator(s, op);
    e->op = op;
    e->arg[0] = a;
    e->arg[1] = b;
    return e;
}

// Warns of a held in a machine without a step, which cannot recognize gaps in the data (language.md 7.33).
static void warn_of_held_without_step(Sema *s, const AstExpr *call)
{
    if (s->building && s->step == 0)
        diag_label(s->diags, diag_report(s->diags, DIAG_held_without_step, call->span), DIAG_label_held_step);
}

// Builds held(c, t) and held(c, n steps): the time, or the number of steps, of the run of true samples of c.
static Expr *check_held(Sema *s, const AstExpr *call)
{
    Expr *c = check_expr(s, call->args->at[0]), *run;
    SmF64 limit;
    const bool in_steps = check_held_duration(s, call, &limit) == DURATION_STEPS;
    const uint64_t gap = s->p->step <= UINT64_MAX / 2 ? 2 * s->p->step : 0;

    if (!c || sm_eq(limit, sm_from_i32(0)))
        return NULL;
    warn_of_held_without_step(s, call);
    if (gap)
        new_statistic(s, call, new_number(s, call, sm_from_i32(1)), 2, SM_STAT_ELAPSED);
    run = new_statistic(s, call, new_not(s, call, new_not(s, call, c)), in_steps ? sm_to_u32(limit) : 1,
                        in_steps ? SM_STAT_RUN_STEPS : SM_STAT_RUN_TIME);
    s->windows->at[run->window].gap = gap;
    s->windows->at[run->window].clock = run->window - (gap > 0);
    return new_operation(s, call, SM_OP_GE, run, new_number(s, call, limit));
}

// Builds rate(x, n): the change of x in the last n steps, divided by the time from the first to the last of them in seconds. While there is one
// sample, the change is 0, and a time of one unit avoids a division by zero.
static Expr *check_rate(Sema *s, const AstExpr *call)
{
    static const int units_a_second[TIME_UNITS] = {[TIME_US] = 1000000, [TIME_MS] = 1000, [TIME_S] = 1};
    Expr *x = check_expr(s, call->args->at[0]), *elapsed;
    bool in_time;
    const uint32_t n = check_window_size(s, call, &in_time);

    if (x && n == 1)
        diag_report(s->diags, DIAG_rate_of_one, call->args->at[1]->span);
    if (!x || n < 2)
        return NULL;
    if (s->building)
        s->building->uses_time_unit = true;
    elapsed = expr_new(s, EX_CALL, call->span, 2);
    elapsed->fn = SM_FN_max;
    elapsed->arg[0] = new_statistic(s, call, new_number(s, call, sm_from_i32(1)), n, SM_STAT_ELAPSED);
    elapsed->arg[1] = new_number(s, call, sm_from_i32(1));
    return new_operation(s, call, SM_OP_DIV, new_statistic(s, call, x, n, SM_STAT_CHANGE),
                         new_operation(s, call, SM_OP_DIV, elapsed, new_number(s, call, sm_from_i32(units_a_second[s->p->time_unit]))));
}

// Builds held(c), rate(x), prev(x), rising(c) or falling(c).  The last three read the oldest, and the newest, of the last two samples.  In the first
// step both are the same sample.
Expr *check_sampled_call(Sema *s, const AstExpr *call, SmBuiltin fn)
{
    Expr *x, *old, *new;

    if (!check_samples_allowed(s, call))
        return NULL;
    if (fn == SM_FN_held || fn == SM_FN_rate)
        return fn == SM_FN_held ? check_held(s, call) : check_rate(s, call);
    if (!(x = check_expr(s, call->args->at[0])))
        return NULL;
    if (fn != SM_FN_prev)
        x = new_not(s, call, new_not(s, call, x));             // `not not x` is 1 or 0
    old = new_statistic(s, call, x, 2, SM_STAT_OLDEST);
    if (fn == SM_FN_prev)
        return old;
    new = new_statistic(s, call, x, 2, SM_STAT_NEWEST);
    return fn == SM_FN_rising ? new_operation(s, call, SM_OP_AND, new, new_not(s, call, old))
                              : new_operation(s, call, SM_OP_AND, new_not(s, call, new), old);
}
