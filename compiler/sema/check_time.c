// SPDX-License-Identifier: Apache-2.0
// The unit and the step of time of a machine, and time literals (language.md 1.36 to 1.39, 5.56 to 5.60).
#include "compiler/sema/sema.h"

#include <string.h>

#include "stdlib/convert.h"
#include "stdlib/math.h"

// ---- literals ----

// Computes the value of a number with or without a unit, in the unit of time `unit`. Returns false if it is too large for an F64.
static bool literal_value(const AstExpr *e, TimeUnit unit, SmF64 *value)
{
    *value = e->number;
    return e->unit == TIME_NONE || time_to_f64(e->span.src->text + e->op_at, e->op_len, e->unit, unit, value);
}

// Returns the value of a literal that has a unit. Records in the machine being checked that its meaning depends on the unit of G.
SmF64 check_time_literal(Sema *s, const AstExpr *e)
{
    SmF64 value;

    if (s->building)
        s->building->uses_time_unit = true;
    if (s->p->joint && s->p->time_unit == TIME_NONE)
        diag_report(s->diags, DIAG_app_time_literal, e->span, sema_quote_source(s, e->span), app_time_text(s->arena, s->p->joint->unit));
    if (!literal_value(e, s->p->time_unit, &value))
        diag_report(s->diags, DIAG_number_too_large, e->span, sema_quote_source(s, e->span));
    return value;
}

static bool is_time_literal(const AstExpr *e) { return e->kind == AST_NUMBER && e->unit != TIME_NONE; }

static bool is_whole(SmF64 x) { return sm_eq(sm_trunc(x), x); }

// Returns e without parentheses and signs, and with the names of definitions replaced by their expressions; *named: e without parentheses and
// signs only.
// The loop ends, because a definition can only use earlier ones.
static const AstExpr *find_literal(const Sema *s, const AstExpr *e, const AstExpr **named)
{
    uint32_t before = s->inside ? s->inside->number : UINT32_MAX;

    for (*named = NULL;;) {
        const Define *d;
        while (e->kind == AST_PAREN || (e->kind == AST_UNARY && (e->op == SM_OP_NEG || e->op == SM_OP_PLUS)))
            e = e->a;
        if (!*named)
            *named = e;
        d = e->kind == AST_NAME ? map_find(&s->defines, e->name) : NULL;
        if (!d || d->number >= before)
            return e;
        before = d->number;
        e = d->value;
    }
}

// Formats a number of units of G. Unlike const_text, does not shorten 1000000 to 1e+06: a second has so many microseconds.
static const char *units_text(Sema *s, SmF64 units)
{
    const bool is_short = is_whole(units) && sm_lt(units, sm_from_u64(UINT64_C(1) << 53));

    return is_short && sm_le(sm_from_i32(0), units) ? format_in(s->arena, "%llu", (unsigned long long)sm_to_u64(units)) : const_text(s->arena, units);
}

// Returns how a message names a literal: as the user wrote it, or by the name of its definition.
static const char *literal_text(Sema *s, const AstExpr *literal, const AstExpr *named)
{
    return named == literal ? sema_quote_source(s, named->span) : format_in(s->arena, "'%s'", named->name->text);
}

// Warns of a literal that is no whole number of units beside T or G in a comparison: T is never equal to it, and < and <= are the same.
// Both can also be in parentheses, or definitions.
void warn_of_time_fraction(Sema *s, const AstExpr *time, const AstExpr *number)
{
    const AstExpr *named, *literal = find_literal(s, number, &named), *as_written;
    const Var *v;
    SmF64 value;

    if (!is_time_literal(literal) || !literal_value(literal, s->p->time_unit, &value) || is_whole(value))
        return;
    time = find_literal(s, time, &as_written);
    v = time->kind == AST_NAME ? scope_find_variable(s, time->name) : NULL;
    if (v && (v == s->p->t || v == s->p->g))
        diag_report(s->diags, DIAG_time_fraction, named->span, literal_text(s, literal, named), const_text(s->arena, value),
                    time_unit_name(s->p->time_unit), time->name->text);
}

// Warns of a literal that is multiplied or divided, as in `v * 20 ms`: without a unit it is not a number of seconds.
// The operand can also be in parentheses, or a definition of such a literal.
static void warn_of_time_factor(Sema *s, const AstExpr *operand)
{
    const AstExpr *named, *literal;
    SmF64 value;
    Diag *d;

    literal = find_literal(s, operand, &named);
    if (!is_time_literal(literal) || !literal_value(literal, s->p->time_unit, &value))
        return;
    d = diag_report(s->diags, DIAG_time_factor, named->span, literal_text(s, literal, named), units_text(s, value));
    if (s->p->time_unit != TIME_S && literal_value(literal, TIME_S, &value))
        diag_label(s->diags, d, DIAG_label_time_in_seconds, const_text(s->arena, value));
}

void warn_of_time_factors(Sema *s, const AstExpr *a, const AstExpr *b)
{
    warn_of_time_factor(s, a);
    warn_of_time_factor(s, b);
}

void warn_of_time_as_guard(Sema *s, const AstExpr *guard)
{
    const char *text;
    SmF64 value;

    if (!is_time_literal(guard) || !literal_value(guard, s->p->time_unit, &value))
        return;
    text = sema_quote_source(s, guard->span);
    diag_label(s->diags, diag_report(s->diags, DIAG_number_as_condition, guard->span, text, sm_to_bool(value) ? "always" : "never"),
               DIAG_label_did_you_mean, format_in(s->arena, "%s %s", s->in_script ? "G ==" : "T >=", text));
}

// Computes the value of a literal that is a whole number of units from 0 to 2^63. Returns false for anything else.
bool literal_units(const AstExpr *e, TimeUnit unit, uint64_t *units)
{
    const SmF64 highest = sm_from_u64(0x8000000000000000u);
    SmF64 x;

    if (!literal_value(e, unit, &x) || !is_whole(x) || sm_lt(x, sm_from_i32(0)) || sm_lt(highest, x))
        return false;
    *units = sm_to_u64(x);
    return true;
}

// ---- the length of a step ----

// Returns the value of the option, a whole number from 1 to 2^63, in the unit `unit`; 0 for anything else.
uint64_t option_step(const AstOption *o, TimeUnit unit)
{
    uint64_t step = 0;

    return o->number && literal_units(o->number, unit, &step) ? step : 0;
}

// Returns how much G advances per step in the script, where the machine counts time in `unit`; 0 if the script has no valid delta_t.
uint64_t script_delta_t(const AstFile *ss, TimeUnit unit)
{
    uint64_t found = 0;

    for (size_t i = 0; i < ss->sections.n; i++)
        for (size_t o = 0; ss->sections.at[i]->kind == AST_OPTIONS && o < ss->sections.at[i]->options.n; o++)
            if (strcmp(ss->sections.at[i]->options.at[o].name->text, "delta_t") == 0)
                found = option_step(&ss->sections.at[i]->options.at[o], unit);
    return found;
}

// ---- windows in time ----

bool expr_contains_time(const Expr *e)
{
    if (e->kind == EX_NUMBER)
        return e->unit != TIME_NONE;
    if (e->kind == EX_VAR)
        return e->var->kind == VAR_LOCAL && e->var->init_value && expr_contains_time(e->var->init_value);
    for (uint32_t i = 0; i < e->n; i++)
        if (expr_contains_time(e->arg[i]))
            return true;
    return false;
}

// Formats a number of units of G as a time, as in `40 ms`.
static const char *format_time(Sema *s, SmF64 units)
{
    return format_in(s->arena, "%s %s", units_text(s, units), time_unit_name(s->p->time_unit));
}

// Computes how many samples a window of the last `time` units of G has.
bool check_window_time(Sema *s, const AstExpr *size, const char *name, SmF64 time, SmF64 *samples)
{
    const SmF64 step = sm_from_u64(s->step), steps = sm_div(time, step), below = sm_mul(sm_floor(steps), step);
    Diag *d;

    if (s->step == 0) {
        d = diag_report(s->diags, DIAG_window_without_step, size->span, name);
        if (!s->in_script)
            diag_label(s->diags, d, DIAG_label_declare_step);
        return false;
    }
    if (!is_whole(time) || (sm_le(time, sm_from_u64(UINT64_C(1) << 53)) && sm_to_u64(time) % s->step != 0)) {
        d = diag_report(s->diags, DIAG_window_time_fraction, size->span, name, sema_quote_source(s, size->span), format_time(s, step));
        diag_label(s->diags, d, DIAG_label_multiples, format_time(s, below), format_time(s, sm_add(below, step)));
        return false;
    }
    *samples = sm_add(steps, sm_from_i32(1));
    return true;
}

// ---- the options of a machine ----

// Returns the last option with this name in the [options] of a machine; NULL if they do not contain it. Reports an option that is given twice.
static const AstOption *find_option(Sema *s, const AstFile *sm, const char *name)
{
    const AstOption *found = NULL;

    for (size_t i = 0; i < sm->sections.n; i++)
        for (size_t k = 0; sm->sections.at[i]->kind == AST_OPTIONS && k < sm->sections.at[i]->options.n; k++) {
            const AstOption *o = &sm->sections.at[i]->options.at[k];
            if (strcmp(o->name->text, name) != 0)
                continue;
            if (found)
                diag_note(s->diags, diag_report(s->diags, DIAG_option_repeated, o->name_span, name), found->name_span, DIAG_note_first_here);
            found = o;
        }
    return found;
}

// Sets the machine's unit and step of time.
void check_time_options(Sema *s, Program *p, const AstFile *sm)
{
    const AstOption *unit = find_option(s, sm, "time_unit"), *step = find_option(s, sm, "step");

    p->time_unit = unit ? time_unit_find(unit->word->text) : TIME_MS;
    if (!step)
        return;
    p->step = option_step(step, p->time_unit);
    p->step_span = step->value_span;
    s->step = p->step;
    p->uses_time_unit = true;
    if (p->step == 0)
        diag_report(s->diags, DIAG_step_value, step->value_span, "step");
}

// ---- applications ----

// Reports a machine whose behaviour depends on the unit of G, or that declares a step, in an application with another unit or period.  Any other
// machine counts the application's unit, which matters to units of measurement.
// `unit`, `period`: in nanoseconds; 0: unknown.
void check_app_machine_time(const CheckContext *c, Program *p, Span named, uint64_t unit, uint64_t period)
{
    static const uint64_t ns[TIME_UNITS] = {[TIME_US] = 1000, [TIME_MS] = 1000000, [TIME_S] = 1000000000};
    const uint64_t own = ns[p->time_unit];
    const bool other_unit = p->uses_time_unit && unit && unit != own;

    if (other_unit)
        diag_report(c->diags, DIAG_app_time_unit, named, p->name->text, time_unit_name(p->time_unit), app_time_text(c->arena, unit));
    else if (p->step && unit && period && (p->step > UINT64_MAX / own || p->step * own != period))
        diag_note(c->diags, diag_report(c->diags, DIAG_app_time_step, named, p->name->text,
                                        format_in(c->arena, "%llu %s", (unsigned long long)p->step, time_unit_name(p->time_unit)),
                                        app_time_text(c->arena, period)),
                  p->step_span, DIAG_note_declared_here, "step");
    else if (unit && !p->uses_time_unit)
        p->time_unit = time_unit_of_period(unit);
}
