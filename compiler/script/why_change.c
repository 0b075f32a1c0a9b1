// SPDX-License-Identifier: Apache-2.0
// Finds inputs that would have changed the outcome of a step.  The script runs again to the state of the machine before the step; from there
// the step runs once for each candidate: an input with a value at the limit of a comparison, just above it or just below it.  A parameter has
// one value in a whole run, so the whole script runs again with it.
#include <string.h>

#include "compiler/script/why_run.h"
#include "stdlib/convert.h"
#include "stdlib/math.h"

enum {
    CHANGES_MOST = 6,                // the most changes that an answer lists
    PARAMETER_STEPS_MOST = 4000000   // the most steps of all runs with other values of parameters together
};

// A value of a parameter that was tried.
typedef struct TriedValue { const Var *var; uint64_t cell; } TriedValue;

// ---- the machine before the step ----

// An engine that saves the state of its machine, and the writes of the script, just before the step in question.
typedef struct Before {
    Engine engine;
    Engine *ref;
    Engine *saved, *again;    // the machine before the step in question; an engine that runs that step again with other inputs
    EngineWrite *write, *tried;       // what the script writes before that step; the same with one change
    uint32_t writes;
    uint64_t step;            // number of the step in question
    const WhyRun *run;        // the run in which the state is saved
    const WhyRun *result;     // the run of the question, with the outcome that is to be changed
    EngineStep answer;
    VEC(TriedValue) parameter;
    uint64_t parameter_steps; // number of steps of the runs with the values in `parameter`
    bool is_cut;              // not all values of parameters were tried, because of PARAMETER_STEPS_MOST
} Before;

// Adds a write to b->write.  A later write of the same variable replaces the earlier one.
static void add_write(Before *b, uint32_t var, uint64_t cell)
{
    uint32_t i = 0;

    while (i < b->writes && b->write[i].var != var)
        i++;
    b->write[i] = (EngineWrite){var, cell};
    b->writes += i == b->writes;
}

static EngineStatus before_init(Engine *e, uint32_t state, EngineStep *out)
{
    return ((Before *)e->self)->ref->init(((Before *)e->self)->ref, state, out);
}

// Saves the situation and the writes of the step in question before it runs.
static EngineStatus before_step(Engine *e, const EngineWrite *write, uint32_t n, EngineStep *out)
{
    Before *b = e->self;

    if (b->run->run.result.steps + 1 == b->step) {
        engine_ref_copy(b->saved, b->ref);
        b->writes = 0;
        for (uint32_t i = 0; i < n; i++)
            add_write(b, write[i].var, write[i].cell);
    }
    return b->ref->step(b->ref, write, n, out);
}

static void before_close(Engine *e) { ((Before *)e->self)->ref->close(((Before *)e->self)->ref); }

// Wraps the reference engine so that the situation before the step in question is saved, from which variants of the step are then run.
static Engine *wrap_to_save_step(void *context, WhyRun *r, Engine *ref)
{
    Before *b = context;
    const Program *p = ref->program;

    b->run = r;
    b->ref = ref;
    b->saved = engine_ref_open(r->arena, p);
    b->again = engine_ref_open(r->arena, p);
    b->write = ARENA_ARRAY(r->arena, EngineWrite, p->var.n);
    b->tried = ARENA_ARRAY(r->arena, EngineWrite, p->var.n);
    engine_step_init(&b->answer, r->arena, p);
    b->engine = (Engine){ref->name, p, NULL, b, before_init, before_step, before_close, ref};
    return &b->engine;
}

// ---- trying ----

// Returns the engine after the step whose outcome is to be changed.
static const Engine *outcome_of(const Before *b) { return b->result->machine[b->result->q.machine]; }

// Whether the outcome of the step with change c is one that the question asks for.
static bool is_asked(const Before *b, const WhyChange *c)
{
    const WhyQuestion *q = &b->result->q;
    const Watch *w = b->result->watch[q->machine];
    const Stmt *was = engine_ref_transition(outcome_of(b));

    if (q->of)
        return c->var != q->of && c->stored != engine_ref_view(outcome_of(b)).cell[q->of->index];
    if (c->next == (was ? was->target : NULL))
        return false;
    return !q->to || w->state == q->to || (was && was->target == q->to) || c->next == q->to;
}

// ---- a parameter ----

// An engine that notes which state its machine runs in the step in question.
typedef struct Noting {
    Engine engine;
    Engine *ref;
    const WhyRun *run;
    uint64_t step;            // number of the step in question
    uint32_t next;            // State.number of the state that the machine's next step runs
    uint32_t state;           // State.number of the state that the step in question ran; 0: the machine has not run that step
} Noting;

static EngineStatus noting_init(Engine *e, uint32_t state, EngineStep *out)
{
    Noting *k = e->self;

    k->next = state;
    return k->ref->init(k->ref, state, out);
}

// Notes in which state the machine was in the step in question.
static EngineStatus noting_step(Engine *e, const EngineWrite *write, uint32_t n, EngineStep *out)
{
    Noting *k = e->self;
    const EngineStatus status = k->ref->step(k->ref, write, n, out);

    if (k->run->run.result.steps + 1 == k->step)
        k->state = k->next;
    k->next = out->next_state;
    return status;
}

static void noting_close(Engine *e) { ((Noting *)e->self)->ref->close(((Noting *)e->self)->ref); }

// Wraps the reference engine so that the state of one step is noted.
static Engine *wrap_noting(void *context, WhyRun *r, Engine *ref)
{
    Noting *k = context;

    k->run = r;
    k->ref = ref;
    k->engine = (Engine){ref->name, ref->program, NULL, k, noting_init, noting_step, noting_close, ref};
    return &k->engine;
}

// Whether a value of a parameter can be tried: it has not been tried yet, and a further run does not exceed PARAMETER_STEPS_MOST.
static bool can_try_parameter(Before *b, const WhyChange *c)
{
    for (uint32_t i = 0; i < b->parameter.n; i++)
        if (b->parameter.at[i].var == c->var && b->parameter.at[i].cell == c->cell)
            return false;                             // the value has been tried for another condition with the same limit
    b->is_cut |= b->parameter_steps + b->step > PARAMETER_STEPS_MOST;
    return !b->is_cut;
}

// Runs the script with another value of a parameter.  Returns whether the step then runs the same state with another outcome, and stores that
// outcome in c.
static bool try_parameter(Before *b, WhyChange *c)
{
    const WhyRun *r = b->result;
    const Joint *j = r->s->program->joint;
    ScriptOptions o = *r->given;
    ScriptSetting *setting = ARENA_ARRAY(r->arena, ScriptSetting, o.settings + 1);
    WhyQuestion q = r->q;
    Noting noting = {.step = b->step};
    const Stmt *taken;
    WhyRun again;

    if (!can_try_parameter(b, c))
        return false;
    for (size_t i = 0; i < o.settings; i++)
        setting[i] = o.setting[i];
    setting[o.settings].parameter = j ? j->member.at[q.machine].var[c->var->index] : c->var;
    if (parameter_judge(c->var, sm_cell_to_f64(c->var->type, c->cell), &setting[o.settings].cell) != SM_REFUSAL_NONE)
        return false;
    vec_push(r->arena, &b->parameter, ((TriedValue){c->var, c->cell}));
    o.setting = setting;
    o.settings++;
    q.at_step = b->step;
    q.has_g = false;
    why_run(&again, r->arena, r->s, &o, &q, wrap_noting, &noting);
    b->parameter_steps += again.run.result.steps;
    if (again.run.result.steps != b->step || noting.state != r->watch[q.machine]->state->number)
        return false;
    taken = engine_ref_transition(noting.ref);
    c->next = taken ? taken->target : NULL;
    c->stored = q.of ? engine_ref_view(noting.ref).cell[q.of->index] : 0;
    return is_asked(b, c);
}

// Runs the step with change c.  Returns whether the outcome then differs, and stores it in c.
static bool try_change(Before *b, WhyChange *c)
{
    const WhyQuestion *q = &b->result->q;
    bool is_written = false;
    const Stmt *taken;

    if (c->var->parameter)
        return try_parameter(b, c);
    for (uint32_t i = 0; i < b->writes; i++) {
        b->tried[i] = b->write[i];
        if (b->write[i].var == c->var->index) {
            b->tried[i].cell = c->cell;
            is_written = true;
        }
    }
    if (!is_written)
        b->tried[b->writes] = (EngineWrite){c->var->index, c->cell};
    engine_ref_copy(b->again, b->saved);
    if (b->again->step(b->again, b->tried, b->writes + !is_written, &b->answer) != ENGINE_OK)
        return false;
    taken = engine_ref_transition(b->again);
    c->next = taken ? taken->target : NULL;
    c->stored = q->of ? b->answer.cell[q->of->index] : 0;
    return is_asked(b, c);
}

// Whether `out` already contains a change of variable v.
static bool has_change_of(const WhyChanges *out, const Var *v)
{
    for (uint32_t i = 0; i < out->n; i++)
        if (out->at[i].var == v)
            return true;
    return false;
}

// Tries a value of variable v, unless another value of v has already changed the outcome.
static void try_value(Before *b, const Var *v, uint64_t cell, double limit, int side, WhyChanges *out)
{
    WhyChange c = {.var = v, .cell = cell, .was = engine_ref_view(outcome_of(b)).cell[v->index], .limit = limit, .side = side};

    if (out->n < CHANGES_MOST && !has_change_of(out, v) && cell != c.was && try_change(b, &c))
        vec_push(b->result->arena, out, c);
}

// Whether an input or a parameter can be changed: a variable that the machine never assigns, and that is no time and no state.
static bool can_change(const Program *p, const Var *v)
{
    return v != p->g && v->kind != VAR_TIME && !v->state_of && !v->is_constant && !v->written && !v->sizes;
}

// Returns the next value of a type above x (side 1) or below it (side -1).
static double next_value(SmType type, double x, int side)
{
    const bool away = x != 0 && (x > 0) == (side > 0);
    const uint64_t cell = ref_convert(type, x);

    if (sm_type_info[type].kind != SM_KIND_FLOAT)
        return side > 0 ? sm_floor(x) + 1 : -(sm_floor(-x) + 1);
    if (x == 0)
        return ref_read(type, side > 0 ? 1 : type == SM_F32 ? UINT64_C(0x80000001) : UINT64_C(0x8000000000000001));
    if (ref_read(type, cell) != x)                    // x is not a value of F32, and the nearest F32 is above or below x
        return (side > 0) == (ref_read(type, cell) > x) ? ref_read(type, cell) : next_value(type, ref_read(type, cell), side);
    return ref_read(type, away ? cell + 1 : cell - 1);
}

// Tries to change v to `limit`, the number with which a condition compares v, and to the next values of its type above and below.
static void try_around(Before *b, const Var *v, double limit, WhyChanges *out)
{
    static const int sides[] = {0, 1, -1};

    for (size_t i = 0; i < sizeof sides / sizeof *sides; i++) {
        const double x = sides[i] ? next_value(v->type, limit, sides[i]) : limit;
        const uint64_t cell = ref_convert(v->type, x);
        if (x - x == 0 && ref_read(v->type, cell) == x)            // infinite values are not tried as inputs
            try_value(b, v, cell, limit, sides[i], out);
    }
}

// Tries the variables of a comparison: each at the values with which it is compared.
static void try_comparison(Before *b, const WatchStmt *s, const Expr *e, WhyChanges *out)
{
    double limit;

    for (uint32_t i = 0; i < e->n; i++)
        for (uint32_t k = i ? i - 1 : 1; e->arg[i]->kind == EX_VAR && can_change(b->engine.program, e->arg[i]->var) && k <= i + 1 && k < e->n; k++)
            if (k != i && why_operand(s, e->arg[k], &limit) && limit - limit == 0)
                try_around(b, e->arg[i]->var, limit, out);
}

// Tries the variables of a condition.
static void try_condition(Before *b, const WatchStmt *s, const Expr *e, WhyChanges *out)
{
    while (e->kind == EX_UNARY && e->op == SM_OP_NOT)
        e = e->arg[0];
    if (e->kind == EX_VAR && can_change(b->engine.program, e->var)) {
        try_value(b, e->var, ref_convert(e->var->type, 0), 0, 0, out);
        try_value(b, e->var, ref_convert(e->var->type, 1), 1, 0, out);
    } else if (watch_is_relation(e)) {
        try_comparison(b, s, e, out);
    }
}

bool why_find_changes(const WhyRun *r, const WatchStmt *const *guard, size_t guards, WhyChanges *out)
{
    WhyQuestion q = r->q;
    Before b = {.result = r, .step = r->watch[q.machine]->step};
    WhyRun again;

    q.at_step = b.step;
    q.has_g = false;
    why_run(&again, r->arena, r->s, r->given, &q, wrap_to_save_step, &b);
    for (size_t i = 0; b.writes && i < guards; i++)
        for (uint32_t k = 0; k < guard[i]->nodes; k++)
            if (guard[i]->node[k].kind == WATCH_LEAF)
                try_condition(&b, guard[i], guard[i]->node[k].e, out);
    return !b.is_cut;
}

const char *why_change_text(const WhyRun *r, const WhyChange *c)
{
    const bool is_next = c->side && sm_type_info[c->var->type].kind == SM_KIND_FLOAT;
    Buf out;

    buf_init(&out, r->arena);
    buf_printf(&out, "%s %s ", c->var->name->text, !is_next ? "=" : c->side > 0 ? "just above" : "just below");
    if (is_next)
        format_number_shortest(&out, c->limit);
    else
        why_append_cell(c->var, c->cell, &out);
    buf_printf(&out, "%s (it was ", c->var->parameter ? " in the whole run" : "");
    why_append_cell(c->var, c->was, &out);
    buf_char(&out, ')');
    return buf_text(&out);
}
