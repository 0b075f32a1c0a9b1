// SPDX-License-Identifier: Apache-2.0
// Reports values whose units do not fit each other (language.md 2.29 to 2.38), in machines and in scripts.  Infers the unit of each expression
// from the variables and definitions that have an @unit.  Reads the Program as written, and no facts.  Does nothing without an @unit.
#include "compiler/analysis/analysis.h"
#include "compiler/analysis/quantity.h"

// The first value with a unit with which an element has been compared; text NULL: none has been.
typedef struct ComparedUnit { Measure unit; const char *text; Span span; } ComparedUnit;

typedef struct UnitCheck {
    Arena *arena;
    Diags *diags;
    const Program *p;
    const Script *script;         // NULL: the machine is checked
    bool *judged;                 // by Define.number: the definition's expression has been compared with its unit
    ComparedUnit *compared;       // by Var.index: the unit with which an element without an @unit has been compared; NULL: not noted
} UnitCheck;

static Quantity infer(UnitCheck *k, const Expr *e);

// ---- reports ----

enum { QUOTED_MAX = 60 };

// Returns a part of the source for a message: on one line, of readable length.
static const char *quote_source(UnitCheck *k, Span span)
{
    const char *text = span.src->text + span.at;
    uint32_t n = 0;

    while (n < span.len && n < QUOTED_MAX && text[n] != '\n' && text[n] != '\r' && text[n] != '#')
        n++;
    return format_in(k->arena, "%.*s%s", (int)n, text, n < span.len ? " ..." : "");
}

static const char *text_of(UnitCheck *k, const Quantity *q) { return measure_text(k->diags->arena, &q->unit); }

static const char *number_text(UnitCheck *k, double x) { return format_in(k->diags->arena, "%.6g", x); }

// Returns a number with its unit; a plain number has none.
static const char *amount_text(UnitCheck *k, double x, const char *unit)
{
    return unit[0] == '1' && !unit[1] ? number_text(k, x) : format_in(k->diags->arena, "%.6g %s", x, unit);
}

static bool is_gram(const Measure *u) { return u->text && u->text[0] == 'g' && u->text[1] == 0; }

// Adds to d how a value in unit a is converted to unit b, or that the units measure different things.
static void label_conversion(UnitCheck *k, Diag *d, const Measure *a, const Measure *b)
{
    const char *from = measure_text(k->diags->arena, a), *to = measure_text(k->diags->arena, b);
    const double zero = (a->zero - b->zero) / b->scale;

    if (!measure_is_same_kind(a, b))
        diag_label(k->diags, d, is_gram(a) || is_gram(b) ? DIAG_label_unit_gram : DIAG_label_unit_other);
    else if (a->zero != b->zero && a->scale != b->scale)
        diag_label(k->diags, d, DIAG_label_unit_zero_factor, from, number_text(k, zero), to, from, number_text(k, a->scale / b->scale), to);
    else if (a->zero != b->zero && b->zero != 0 && a->zero == 0)
        label_conversion(k, d, b, a);
    else if (a->zero != b->zero)
        diag_label(k->diags, d, DIAG_label_unit_difference, from, number_text(k, zero), to, to);
    else
        diag_label(k->diags, d, DIAG_label_unit_factor, amount_text(k, 1, from), amount_text(k, a->scale / b->scale, to));
}

// Reports that b, at `span`, does not fit a.
static void report_difference(UnitCheck *k, QuantityFit fit, const Quantity *a, const char *name, const Quantity *b, Span span)
{
    const DiagCode code = fit == QUANTITY_DIFFERS ? DIAG_units_differ : DIAG_units_may_differ;
    const Measure missing = measure_product(&a->unit, &b->unit, -1);
    Diag *d;

    if (fit == QUANTITY_MAY_DIFFER && k->script)              // the inputs of a script are a model with numbers of all units
        return;
    d = diag_report(k->diags, code, span, name, text_of(k, a), quote_source(k, span), text_of(k, b));
    if (fit == QUANTITY_DIFFERS)
        label_conversion(k, d, &b->unit, &a->unit);
    else if (b->scaled && !a->scaled)
        diag_label(k->diags, d, DIAG_label_unit_of_number, measure_text(k->diags->arena, &missing));
}

// ---- values that need the same unit ----

// Values that must have one unit, as the operands of min: each is compared with the first of them that has a unit.
typedef struct UnitGroup {
    Quantity all;                 // what is known about the result, which is one of the values
    Quantity first;               // the first that has a unit
    const char *name;             // source text of `first`, for messages
    bool any, differs;            // a value has been added; the unit of some value differs from that of `first`
} UnitGroup;

// Adds a value to group g, whose values must have one unit, and reports the value if its unit differs.
static void add_to_group(UnitCheck *k, UnitGroup *g, const Quantity *q, Span span)
{
    const bool is_first = q->kind == QUANTITY_UNIT && g->first.kind != QUANTITY_UNIT;
    const QuantityFit fit = quantity_fit(&g->first, q, QUANTITY_COMPARED);

    if (fit != QUANTITY_FITS)
        report_difference(k, fit, &g->first, g->name, q, span);
    g->differs |= fit == QUANTITY_DIFFERS;
    g->all = g->any ? quantity_one_of(&g->all, q) : *q;
    g->any = true;
    if (is_first) {
        g->first = *q;
        g->name = quote_source(k, span);
    }
}

// Returns the element without an @unit that e is, or of which it is a statistic with the same unit; NULL: e is something else.
static const Var *unmarked_element(const Expr *e)
{
    if (e->kind == EX_ROLL && (e->stat == SM_STAT_MIN || e->stat == SM_STAT_MAX || e->stat == SM_STAT_AVG || e->stat == SM_STAT_MEDIAN))
        e = e->arg[0];
    return e->kind == EX_VAR && e->var->kind == VAR_ELEMENT && !e->var->unit && e->var->type != SM_BOOL ? e->var : NULL;
}

// Notes that an element without an @unit is compared with a value that has one.  Reports two such values that measure different things.
static void note_comparison(UnitCheck *k, const Expr *element, const Expr *value, const Quantity *q)
{
    const Var *v = unmarked_element(element);
    ComparedUnit *first = v && k->compared && q->kind == QUANTITY_UNIT && q->constant ? &k->compared[v->index] : NULL;
    Diag *d;

    if (!first)
        return;
    if (!first->text) {
        first->unit = q->unit;
        first->text = quote_source(k, value->span);
        first->span = value->span;
    } else if (!measure_is_same_kind(&first->unit, &q->unit)) {
        d = diag_report(k->diags, DIAG_mixed_units, value->span, v->name->text, quote_source(k, value->span), text_of(k, q));
        diag_note(k->diags, d, first->span, DIAG_note_compared_here, first->text, measure_text(k->diags->arena, &first->unit));
    }
}

// Returns the quantity of the arguments of min, max or a comparison, which must have one unit.
static Quantity infer_group(UnitCheck *k, const Expr *e)
{
    UnitGroup g = {0};

    for (uint32_t i = 0; i < e->n; i++) {
        const Quantity q = infer(k, e->arg[i]);
        add_to_group(k, &g, &q, e->arg[i]->span);
        for (uint32_t n = 0; n < e->n && e->n == 2; n++)
            if (n != i)
                note_comparison(k, e->arg[n], e->arg[i], &q);
    }
    return g.differs ? quantity_of_kind(QUANTITY_UNKNOWN) : g.all;
}

// ---- operators ----

static Quantity infer_sum(UnitCheck *k, const Expr *e, bool minus)
{
    const Quantity a = infer(k, e->arg[0]), b = infer(k, e->arg[1]);
    const QuantityFit fit = quantity_fit(&a, &b, minus ? QUANTITY_SUBTRACTED : QUANTITY_ADDED);

    if (fit != QUANTITY_FITS)
        report_difference(k, fit, &a, quote_source(k, e->arg[0]->span), &b, e->arg[1]->span);
    if (fit == QUANTITY_DIFFERS)
        return quantity_of_kind(QUANTITY_UNKNOWN);
    if (fit == QUANTITY_MAY_DIFFER)
        return a.scaled && !b.scaled ? b : a;
    return quantity_sum(&a, &b, minus);
}

// Returns the unit of rate(x, n), which the checker builds as the change of x divided by a time in seconds; false: e is something else.
static bool infer_rate(UnitCheck *k, const Expr *e, Quantity *rate)
{
    const Measure second = measure_named("s");
    const Quantity seconds = quantity_of_unit(&second);
    Quantity x;

    if (e->arg[0]->kind != EX_ROLL || e->arg[0]->stat != SM_STAT_CHANGE || e->op != SM_OP_DIV)
        return false;
    x = infer(k, e->arg[0]);
    *rate = quantity_product(&x, &seconds, -1);
    return true;
}

static Quantity infer_binary(UnitCheck *k, const Expr *e)
{
    Quantity a, b;

    switch (sm_op_info[e->op].op_class) {
    case SM_CLASS_RELATION: case SM_CLASS_EQUALITY:
        infer_group(k, e);
        return quantity_of_kind(QUANTITY_PLAIN);
    case SM_CLASS_LOGIC:
        infer(k, e->arg[0]);
        infer(k, e->arg[1]);
        return quantity_of_kind(QUANTITY_PLAIN);
    default: break;
    }
    if (e->op == SM_OP_ADD || e->op == SM_OP_SUB)
        return infer_sum(k, e, e->op == SM_OP_SUB);
    if (infer_rate(k, e, &a))
        return a;
    a = infer(k, e->arg[0]);
    b = infer(k, e->arg[1]);
    return quantity_product(&a, &b, e->op == SM_OP_DIV ? -1 : 1);
}

// ---- functions ----

// Reports an argument that is certainly not in the unit `needs`: radians or a plain number.
static void check_argument(UnitCheck *k, const Expr *call, const Quantity *q, const char *needs)
{
    const Measure one = measure_of_number();
    const Quantity plain = quantity_of_unit(&one);
    const Span span = call->arg[sm_builtin_info[call->fn].units == SM_UNITS_POWER]->span;
    Diag *d;

    if (quantity_fit(q, &plain, QUANTITY_COMPARED) != QUANTITY_DIFFERS)
        return;
    d = diag_report(k->diags, DIAG_unit_of_argument, span, sm_builtin_info[call->fn].name, needs, quote_source(k, span), text_of(k, q));
    if (measure_is_number(&q->unit))
        diag_label(k->diags, d, DIAG_label_unit_multiply, number_text(k, q->unit.scale));
}

static Quantity infer_power(UnitCheck *k, const Expr *e)
{
    const Quantity a = infer(k, e->arg[0]), b = infer(k, e->arg[1]);

    check_argument(k, e, &b, "a plain number");
    if (expr_is_constant(e->arg[1]))
        return quantity_power(&a, expr_constant_value(e->arg[1]));
    return quantity_of_kind(a.kind == QUANTITY_UNIT && !measure_is_number(&a.unit) ? QUANTITY_UNKNOWN : QUANTITY_PLAIN);
}

static Quantity infer_call(UnitCheck *k, const Expr *e)
{
    const Measure radian = measure_named("rad");
    Quantity a;

    switch (sm_builtin_info[e->fn].units) {
    case SM_UNITS_SAME: return infer_group(k, e);
    case SM_UNITS_NUMBER:
        infer(k, e->arg[0]);
        return quantity_of_kind(QUANTITY_PLAIN);
    case SM_UNITS_OF_ANGLE:
        a = infer(k, e->arg[0]);
        check_argument(k, e, &a, "radians");
        return quantity_of_kind(QUANTITY_PLAIN);
    case SM_UNITS_ANGLE:
        a = infer(k, e->arg[0]);
        check_argument(k, e, &a, "a plain number");
        return quantity_of_unit(&radian);
    case SM_UNITS_DIRECTION:
        infer_group(k, e);
        return quantity_of_unit(&radian);
    case SM_UNITS_ROOT:
        a = infer(k, e->arg[0]);
        return quantity_power(&a, 0.5);
    case SM_UNITS_POWER: return infer_power(k, e);
    case SM_UNITS_SAMPLES: break;                                     // not reached: an EX_ROLL, never a call
    }
    return quantity_of_kind(QUANTITY_UNKNOWN);
}

// ---- samples ----

static Quantity infer_statistic(UnitCheck *k, const Expr *e)
{
    Quantity x = infer(k, e->arg[0]);

    if (e->stat == SM_STAT_ELAPSED || e->stat == SM_STAT_RUN_STEPS || e->stat == SM_STAT_RUN_TIME)
        return quantity_of_kind(QUANTITY_UNKNOWN);
    if (e->stat == SM_STAT_RANGE || e->stat == SM_STAT_CHANGE)
        return quantity_sum(&x, &x, true);
    x.constant = false;
    return x;
}

// ---- values ----

static Quantity quantity_of_time(const Program *p)
{
    const Measure unit = measure_named(time_unit_name(p->time_unit));

    return p->time_unit == TIME_NONE ? quantity_of_kind(QUANTITY_UNKNOWN) : quantity_of_unit(&unit);
}

static Quantity quantity_of_variable(UnitCheck *k, const Var *v)
{
    Quantity q;

    if (v == k->p->g || v->kind == VAR_TIME) {
        q = quantity_of_time(k->p);
        q.scaled = k->script != NULL;                     // an input of a script can be a ramp: `pressure = T` is 1 bar per ms
        return q;
    }
    if (!v->unit)
        return quantity_of_kind(v->type == SM_BOOL ? QUANTITY_PLAIN : QUANTITY_UNKNOWN);
    q = quantity_of_unit(v->unit);
    q.constant = v->is_constant;
    return q;
}

static Quantity infer_expression(UnitCheck *k, const Expr *e)
{
    switch (e->kind) {
    case EX_NUMBER: return e->unit == TIME_NONE ? quantity_of_number(e->number) : quantity_of_time(k->p);
    case EX_VAR:    return quantity_of_variable(k, e->var);
    case EX_UNARY: {
        const Quantity a = infer(k, e->arg[0]);
        return e->op == SM_OP_NOT ? quantity_of_kind(QUANTITY_PLAIN) : quantity_negated(a);
    }
    case EX_BINARY: return infer_binary(k, e);
    case EX_CHAIN:  infer_group(k, e); return quantity_of_kind(QUANTITY_PLAIN);
    case EX_CALL:   return infer_call(k, e);
    case EX_ROLL:   return infer_statistic(k, e);
    case EX_EVERY: case EX_AT: return quantity_of_kind(QUANTITY_PLAIN);
    case EX_RANDOM: break;
    }
    return quantity_of_kind(QUANTITY_UNKNOWN);
}

// ---- definitions ----

static const Define *definition_number(const UnitCheck *k, uint32_t number)
{
    return number < k->p->define.n ? k->p->define.at[number] : k->script->define.at[number - k->p->define.n];
}

// Reports a value that does not fit the variable or definition `name`, which has the unit.
static void check_store(UnitCheck *k, const Measure *unit, const char *name, const Quantity *value, Span span)
{
    const Quantity to = quantity_of_unit(unit);
    const QuantityFit fit = quantity_fit(&to, value, QUANTITY_COMPARED);

    if (fit != QUANTITY_FITS)
        report_difference(k, fit, &to, name, value, span);
}

// Returns the unit of a use of the definition.  At the first use, compares the definition's @unit with the unit of its expression.
static Quantity infer_definition(UnitCheck *k, const Expr *e, uint32_t number)
{
    const Define *d = definition_number(k, number);
    Quantity q;

    if (!k->judged[number]) {
        k->judged[number] = true;
        q = d->names ? infer_definition(k, e, d->names - 1) : infer_expression(k, e);
        check_store(k, d->unit, d->name->text, &q, d->value_span);
    }
    q = quantity_of_unit(d->unit);
    q.constant = expr_is_constant(e);
    return q;
}

static Quantity infer(UnitCheck *k, const Expr *e) { return e->define ? infer_definition(k, e, e->define - 1) : infer_expression(k, e); }

// ---- statements ----

static void check_assignment(UnitCheck *k, const Var *v, const Expr *value)
{
    const Quantity q = infer(k, value);

    if (v->unit)
        check_store(k, v->unit, v->name->text, &q, value->span);
}

static void check_stmt(const Stmt *stmt, void *context)
{
    UnitCheck *k = context;

    if (stmt->kind == ST_ASSIGN)
        check_assignment(k, stmt->var, stmt->value);
    else if (stmt->kind == ST_IF)
        infer(k, stmt->value);
}

// Reports an @unit of G that is not the unit that G counts.
static void check_clock(UnitCheck *k)
{
    const Var *g = k->p->g;
    const Quantity time = quantity_of_time(k->p);

    if (g && g->unit)
        check_store(k, g->unit, g->name->text, &time, g->span);
}

static void check_machine(Analysis *a, ComparedUnit *compared)
{
    UnitCheck k = {a->arena, a->diags, a->p, NULL, NULL, compared};

    if (!a->p->has_units)
        return;
    k.judged = ARENA_ARRAY(a->arena, bool, a->p->define.n + 1);
    check_clock(&k);
    for (size_t i = 0; i < a->p->var.n; i++)
        if (a->p->var.at[i]->init_value)
            check_assignment(&k, a->p->var.at[i], a->p->var.at[i]->init_value);
    each_stmt(a->p, check_stmt, &k);
}

void analyse_units(Analysis *a) { check_machine(a, NULL); }

// What units differ is reported once, whichever of the two runs.
void analyse_mixed_units(Analysis *a) { check_machine(a, ARENA_ARRAY(a->arena, ComparedUnit, a->p->var.n + 1)); }

// ---- scripts ----

static void check_item(UnitCheck *k, const ScriptItem *item)
{
    infer(k, item->guard);
    for (size_t i = 0; i < item->inputs.n; i++)
        check_assignment(k, item->inputs.at[i].var, item->inputs.at[i].value);
    for (size_t i = 0; i < item->asserts.n; i++) {
        const ScriptAssert *a = &item->asserts.at[i];
        if (a->condition)
            infer(k, a->condition);
        for (size_t n = 0; a->remark && n < a->remark->printed.n; n++)
            infer(k, a->remark->printed.at[n]);
    }
}

void analyse_units_of_script(Arena *arena, Diags *diags, const Script *script)
{
    const Program *p = script->program;
    UnitCheck k = {arena, diags, p, script, NULL, NULL};

    if (!p->has_units && !script->has_units)
        return;
    k.judged = ARENA_ARRAY(arena, bool, p->define.n + script->define.n + 1);
    for (size_t i = 0; i < p->define.n; i++)
        k.judged[i] = true;                               // the machine's own check has compared these
    for (size_t i = 0; i < script->local.n; i++)
        if (script->local.at[i]->init_value)
            check_assignment(&k, script->local.at[i], script->local.at[i]->init_value);
    for (size_t s = 0; s < script->section.n; s++)
        for (size_t i = 0; i < script->section.at[s].item.n; i++)
            check_item(&k, script->section.at[s].item.at[i]);
}
