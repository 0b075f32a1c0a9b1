// SPDX-License-Identifier: Apache-2.0
// Guards by time and `state Burn`, which only scripts have (language.md 8.39 to 8.46).  They become comparisons with G and S.
#include "compiler/sema/sema.h"

#include "compiler/syntax/lex.h"
#include "stdlib/convert.h"
#include "stdlib/math.h"

// ---- expressions ----

// Returns an expression that reads the variable.
static Expr *new_variable(Sema *s, Var *v, Span span)
{
    Expr *e = expr_new(s, EX_VAR, span, 0);

    e->var = v;
    return e;
}

static Expr *new_comparison(Sema *s, SmOperator op, Expr *a, Expr *b, Span span)
{
    Expr *e = expr_new(s, EX_BINARY, span, 2);

    e->op = op;
    e->arg[0] = a;
    e->arg[1] = b;
    return e;
}

// Returns a <= G < b.
static Expr *new_range(Sema *s, Expr *a, Expr *b, const AstExpr *in)
{
    Expr *e = expr_new(s, EX_CHAIN, in->span, 3);

    e->arg[0] = a;
    e->arg[1] = new_variable(s, s->p->g, (Span){in->span.src, in->span.at, 0});
    e->arg[2] = b;
    expr_ops(e)[0] = SM_OP_LE;
    expr_ops(e)[1] = SM_OP_LT;
    return e;
}

// Returns the value of a guard such as `every 10 ms`.  The number is checked when delta_t is known.
static Expr *new_every(Sema *s, const Expr *period, const AstExpr *in)
{
    Expr *e = expr_new(s, EX_EVERY, in->span, 0);

    e->number = period->number;
    e->var = s->p->g;
    return e;
}

// Returns the value of a guard such as `at 5 s` or `G == 5000`; name: length of the name of G in the source, 0 after `at`.
static Expr *new_at(Sema *s, const Expr *time, Span span, uint32_t name)
{
    Expr *e = expr_new(s, EX_AT, span, 0);

    e->number = time->number;
    e->window = name;
    e->var = s->p->g;
    return e;
}

// Checks an expression that contains no windows.  Its nodes are temporary, because the caller only needs its value.
static Expr *check_unkept(Sema *s, const AstExpr *e)
{
    Expr *out;

    s->nodes = s->scratch;
    out = check_expr(s, e);
    s->nodes = s->arena;
    return out;
}

static bool is_global_time(const Sema *s, const AstExpr *e) { return e->kind == AST_NAME && scope_find_variable(s, e->name) == s->p->g; }

Expr *check_guard(Sema *s, const AstExpr *e)
{
    const bool is_at = e->kind == AST_BINARY && e->op == SM_OP_EQ && is_global_time(s, e->a) && e->b->kind == AST_NUMBER;
    const Expr *both = is_at ? check_unkept(s, e) : NULL;

    if (!is_at)
        return check_expr(s, e);
    return both ? new_at(s, both->arg[1], e->span, e->a->span.len) : NULL;
}

Expr *check_when(Sema *s, const AstExpr *e)
{
    const bool is_one_node = e->when == AST_AT || e->when == AST_EVERY;
    Expr *a = is_one_node ? check_unkept(s, e->a) : check_expr(s, e->a), *b = e->b ? check_expr(s, e->b) : NULL;
    const Span at = {e->span.src, e->span.at, 0};        // position of the node for G, which the text does not contain

    if (!a || (e->b && !b))
        return NULL;
    switch ((int)e->when) {
    case AST_AT:    return new_at(s, a, e->span, 0);
    case AST_AFTER: return new_comparison(s, SM_OP_GE, new_variable(s, s->p->g, at), a, e->span);
    case AST_FROM:  return new_range(s, a, b, e);
    default:        return new_every(s, a, e);
    }
}

Expr *check_state_value(Sema *s, const AstExpr *e)
{
    const State *state = scope_find_state(s, s->p, e->name, ast_op_span(e));
    const Joint *j = s->p->joint;
    const Member *m = state && j ? &j->member.at[joint_machine_of(j, state->number)] : NULL;
    Expr *number;

    if (!state)
        return NULL;
    number = expr_new(s, EX_NUMBER, ast_op_span(e), 0);
    number->number = sm_from_u32(state->number - (m ? m->first : 0));
    return new_comparison(s, SM_OP_EQ, new_variable(s, m ? m->s : s->p->s, (Span){e->span.src, e->span.at, 0}), number, e->span);
}

bool report_compared_state_value(Sema *s, const AstExpr *e)
{
    const AstExpr *name = e->a->kind == AST_STATE_NAME ? e->a : e->b, *other = name == e->a ? e->b : e->a;
    const Var *v = name->kind == AST_STATE_NAME && other->kind == AST_NAME ? scope_find_variable(s, other->name) : NULL;
    Diag *d;

    if (!v || !v->state_of)
        return false;
    d = diag_report(s->diags, DIAG_state_compared, name->span, sema_quote_source(s, name->span));
    diag_label(s->diags, d, DIAG_label_write, name->name->text);
    diag_edit(s->diags, d, name->span, name->name->text);
    return true;
}

// ---- times ----

// Whether a clock that starts at 0 and advances by delta_t is ever equal to x.
bool is_reached_time(SmF64 x, uint64_t delta_t)
{
    const SmF64 limit = sm_from_u64(0x20000000000000u);          // 2^53: above it, not every whole number is an F64

    if (sm_lt(x, sm_from_i32(0)) || !sm_eq(sm_trunc(x), x))
        return false;
    return !sm_lt(x, limit) || sm_to_u64(x) % delta_t == 0;
}

// Returns the smallest multiple of delta_t that is not below x, which is at least 0.
static SmF64 next_step(SmF64 x, uint64_t delta_t)
{
    const SmF64 step = sm_from_u64(delta_t);

    return sm_mul(sm_ceil(sm_div(x, step)), step);
}

// Returns the value of a number with or without a unit.
static SmF64 time_of_number(const Sema *s, const AstExpr *e)
{
    SmF64 value = e->number;

    if (e->unit != TIME_NONE)
        time_to_f64(e->span.src->text + e->op_at, e->op_len, e->unit, s->p->time_unit, &value);
    return value;
}

// ---- comparisons with G that a guard by time can replace ----

// A comparison that limits G: G == time, G >= time or G < time.
typedef struct Bound { SmOperator op; const AstExpr *time; } Bound;

// Whether e is written as a number that is a whole time, other than in hexadecimal.
static bool is_whole_time(const Sema *s, const AstExpr *e)
{
    const char *text = e->span.src->text + e->span.at;

    return e->kind == AST_NUMBER && lex_is_digit(text[0]) && text[1] != 'x' && text[1] != 'X' && is_reached_time(time_of_number(s, e), 1) &&
           sm_lt(time_of_number(s, e), sm_from_u64(UINT64_C(1) << 53));
}

// Finds the bound in `a op b`, where one operand is G.
static bool find_bound(const Sema *s, SmOperator op, const AstExpr *a, const AstExpr *b, Bound *out)
{
    static const SmOperator turned[SM_OP_COUNT] = {[SM_OP_EQ] = SM_OP_EQ, [SM_OP_LE] = SM_OP_GE, [SM_OP_GT] = SM_OP_LT};
    const bool on_left = is_global_time(s, a);

    out->op = on_left ? op : turned[op];
    out->time = on_left ? b : a;
    return (on_left || is_global_time(s, b)) && is_whole_time(s, out->time) && (out->op == SM_OP_EQ || out->op == SM_OP_GE || out->op == SM_OP_LT);
}

static bool is_comparison(const AstExpr *e)
{
    return e->kind == AST_BINARY && (sm_op_info[e->op].op_class == SM_CLASS_RELATION || sm_op_info[e->op].op_class == SM_CLASS_EQUALITY);
}

// Finds the bounds of a guard such as 5 <= G < 6, or G >= 5 and G < 6. Returns their number; 0: the guard contains something else.
static int find_bounds(const Sema *s, const AstExpr *e, Bound out[2])
{
    if (e->kind == AST_BINARY && e->op == SM_OP_AND)
        return is_comparison(e->a) && is_comparison(e->b) && !is_comparison(e->a->a) && find_bound(s, e->a->op, e->a->a, e->a->b, &out[0]) &&
                       find_bound(s, e->b->op, e->b->a, e->b->b, &out[1])
                   ? 2
                   : 0;
    if (!is_comparison(e))
        return 0;
    if (!is_comparison(e->a))
        return find_bound(s, e->op, e->a, e->b, &out[0]);
    return is_global_time(s, e->a->b) && find_bound(s, e->a->op, e->a->a, e->a->b, &out[0]) && find_bound(s, e->op, e->a->b, e->b, &out[1]) ? 2 : 0;
}

// Returns a time as a script writes it: 5.25 s for 5250 where G counts milliseconds.
static const char *format_when(Sema *s, const AstExpr *time)
{
    static const char *const larger[TIME_UNITS] = {[TIME_US] = "ms", [TIME_MS] = "s"};
    const uint64_t units = sm_to_u64(time_of_number(s, time)), whole = units / 1000;
    unsigned part = (unsigned)(units % 1000);
    int digits = 3;

    if (time->unit != TIME_NONE || units == 0)
        return sema_quote_source(s, time->span);
    if (whole == 0 || !larger[s->p->time_unit])
        return format_in(s->arena, "%llu %s", (unsigned long long)units, time_unit_name(s->p->time_unit));
    if (part == 0)
        return format_in(s->arena, "%llu %s", (unsigned long long)whole, larger[s->p->time_unit]);
    for (; part % 10 == 0; part /= 10)
        digits--;
    return format_in(s->arena, "%llu.%0*u %s", (unsigned long long)whole, digits, part, larger[s->p->time_unit]);
}

// Returns the guard by time that means the same as the bounds; NULL if no guard by time means the same, or if no step is in it.
static const char *format_guard(Sema *s, const Bound *b, int n, uint64_t delta_t)
{
    if (n == 1 && b[0].op == SM_OP_EQ)
        return is_reached_time(time_of_number(s, b[0].time), delta_t) ? format_in(s->arena, "at %s", format_when(s, b[0].time)) : NULL;
    if (n == 1 && b[0].op == SM_OP_GE)
        return format_in(s->arena, "after %s", format_when(s, b[0].time));
    if (n == 2 && b[0].op == SM_OP_GE && b[1].op == SM_OP_LT &&
        sm_lt(next_step(time_of_number(s, b[0].time), delta_t), time_of_number(s, b[1].time)))
        return format_in(s->arena, "from %s to %s", format_when(s, b[0].time), format_when(s, b[1].time));
    return NULL;
}

void propose_when(Sema *s, const AstExpr *guard, uint64_t delta_t)
{
    Bound b[2];
    const int n = delta_t ? find_bounds(s, guard, b) : 0;
    const char *text = n ? format_guard(s, b, n, delta_t) : NULL;
    Diag *d;

    if (!text)
        return;
    d = diag_report(s->diags, DIAG_guard_by_time, guard->span, sema_quote_source(s, guard->span));
    diag_label(s->diags, d, DIAG_label_write, text);
    diag_edit(s->diags, d, guard->span, text);
}

// ---- times that steps have ----

static const char *format_units(const Sema *s, SmF64 units)
{
    if (s->p->joint && s->p->time_unit == TIME_NONE)
        return const_text(s->arena, units);
    return format_in(s->arena, "%s %s", const_text(s->arena, units), time_unit_name(s->p->time_unit));
}

// Reports an `at` time that no step reaches. delta_t: time between steps.
static void check_at(Sema *s, const Expr *guard, uint64_t delta_t)
{
    const SmF64 at = guard->number, above = next_step(at, delta_t);
    Diag *d;

    if (is_reached_time(at, delta_t))
        return;
    d = diag_report(s->diags, DIAG_at_never, guard->span, const_text(s->arena, at), format_units(s, sm_from_u64(delta_t)));
    diag_label(s->diags, d, DIAG_label_when_near,
               format_in(s->arena, "%s and %s", format_units(s, sm_sub(above, sm_from_u64(delta_t))), format_units(s, above)));
}

// Reports an `every` time that is not a positive multiple of the time between steps.
static void check_every(Sema *s, const Expr *guard, uint64_t delta_t)
{
    const SmF64 highest = sm_from_u64(UINT64_C(1) << 63);

    if (sm_lt(sm_from_i32(0), guard->number) && sm_le(guard->number, highest) && is_reached_time(guard->number, 1) &&
        sm_to_u64(guard->number) % delta_t == 0)
        return;
    diag_report(s->diags, DIAG_every_multiple, guard->span, sema_quote_source(s, guard->span), format_units(s, sm_from_u64(delta_t)));
}

// Warns of a range of times in which no step runs.
static void warn_of_empty_range(Sema *s, const Expr *guard, uint64_t delta_t)
{
    if (!sm_lt(next_step(guard->arg[0]->number, delta_t), guard->arg[2]->number))
        diag_report(s->diags, DIAG_time_range_empty, guard->span, sema_quote_source(s, guard->span), format_units(s, sm_from_u64(delta_t)));
}

void check_when_times(Sema *s, const Expr *guard, uint64_t delta_t)
{
    if (guard->kind == EX_EVERY)
        check_every(s, guard, delta_t);
    else if (guard->kind == EX_CHAIN)
        warn_of_empty_range(s, guard, delta_t);
    else if (guard->kind == EX_AT)
        check_at(s, guard, delta_t);
}
