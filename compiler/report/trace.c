// SPDX-License-Identifier: Apache-2.0
#include "compiler/report/trace.h"

#include <string.h>

#include "stdlib/convert.h"

double trace_cell_value(SmType type, uint64_t cell)
{
    unsigned char memory[8] = {0};
    uint64_t bits;
    double x;

    sm_cell_store(type, memory, cell);
    bits = sm_bits(sm_load(type, memory));
    memcpy(&x, &bits, sizeof x);
    return x;
}

// Returns number of buckets in use.
size_t trace_buckets(const Trace *t) { return (size_t)((t->steps + t->per - 1) / t->per); }

void trace_init(Trace *t, Arena *arena, const Program *p, const Transitions *transition)
{
    size_t transitions = 0;           // number of transitions of the states before the current one

    memset(t, 0, sizeof *t);
    t->arena = arena;
    t->p = p;
    t->transition = transition;
    t->first = ARENA_ARRAY(arena, size_t, p->state.n);
    t->taken = ARENA_ARRAY(arena, uint64_t, transition->n);
    for (size_t s = 0; s < p->state.n; s++) {
        while (transitions < transition->n && transition->at[transitions].from->number < s + 1)
            transitions++;
        t->first[s] = transitions;
    }
    t->per = 1;
    t->entered = ARENA_ARRAY(arena, uint64_t, p->state.n);
    t->spent = ARENA_ARRAY(arena, uint64_t, p->state.n);
    for (size_t i = 0; i < p->var.n; i++) {
        const Var *v = p->var.at[i];
        if (v != p->g && v != p->s && (v->kind == VAR_ELEMENT || (v->kind == VAR_LOCAL && !v->is_constant))) {
            TraceSeries *s = ARENA_NEW(arena, TraceSeries);
            s->v = v;
            vec_push(arena, &t->series, s);
        }
    }
}

// ---- buckets ----

// Merges two buckets.  One without a value (NaN) does not count.
static TraceBucket merge_buckets(const TraceBucket *a, const TraceBucket *b)
{
    if (a->first != a->first || b->first != b->first)
        return a->first != a->first ? *b : *a;
    return (TraceBucket){a->first, a->lo < b->lo ? a->lo : b->lo, a->hi > b->hi ? a->hi : b->hi, b->last};
}

static void merge_pairs_of_series(TraceSeries *s)
{
    for (size_t k = 0; k < TRACE_BUCKETS / 2; k++)
        s->at[k] = merge_buckets(&s->at[2 * k], &s->at[2 * k + 1]);
}

// Halves the number of buckets in use: each now covers twice as many steps.
static void merge_bucket_pairs(Trace *t)
{
    for (size_t i = 0; i < t->series.n; i++)
        merge_pairs_of_series(t->series.at[i]);
    for (size_t i = 0; i < t->recorded.n; i++)
        merge_pairs_of_series(t->recorded.at[i]);
    t->per *= 2;
}

// Adds the value of a series in a step, which is counted from 0.
static void add_value(Trace *t, TraceSeries *s, uint64_t step, double x)
{
    TraceBucket *b = &s->at[step / t->per], alone = {x, x, x, x};

    s->infinite = s->infinite || x - x != 0;
    s->changes = s->changes || (step > 0 && x != s->at[0].first);
    *b = step % t->per == 0 ? alone : merge_buckets(b, &alone);
}

void trace_begin_recorded(Trace *t, const ScriptData *d)
{
    for (size_t i = 0; i < d->compare.n; i++) {
        TraceSeries *s = ARENA_NEW(t->arena, TraceSeries);
        s->v = d->compare.at[i].column.var;
        vec_push(t->arena, &t->recorded, s);
    }
}

// Adds the recorded values of the latest step, one for each recorded series.
void trace_add_recorded(Trace *t, const double *value)
{
    for (size_t i = 0; t->steps > 0 && i < t->recorded.n; i++)
        add_value(t, t->recorded.at[i], t->steps - 1, value[i]);
}

// ---- a step ----

// Counts a move between two states at the first transition that leads from one to the other.
static void count_transition(Trace *t, uint32_t from, uint32_t to)
{
    for (size_t i = t->first[from - 1]; i < t->transition->n && t->transition->at[i].from->number == from; i++)
        if (t->transition->at[i].to->number == to) {
            t->taken[i]++;
            return;
        }
}

// Records that the machine entered `state` at time g. All visits are counted, only the first TRACE_VISITS_MAX are kept.
static void record_visit(Trace *t, const State *state, uint64_t g)
{
    TraceVisit v = {state, t->steps, g, (double)t->steps};

    if (t->steps > 0)
        count_transition(t, t->last, state->number);
    t->entered[state->number - 1]++;
    if (t->visits++ < TRACE_VISITS_MAX)
        vec_push(t->arena, &t->visit, v);
}

// Adds one step to the trace. `cell`: values of all variables after the step.
static void record_step(Trace *t, const uint64_t *cell)
{
    const uint64_t number = cell[t->p->s->index], g = cell[t->p->g->index];

    if (number < 1 || number > t->p->state.n)
        return;
    if (t->steps == (uint64_t)TRACE_BUCKETS * t->per)
        merge_bucket_pairs(t);
    if (t->steps == 0)
        t->first_g = g;
    t->last_g = g;
    if (cell[t->p->t->index] == 0)                    // T is 0 in the first step of a state only
        record_visit(t, t->p->state.at[number - 1], g);
    t->last = (uint32_t)number;
    t->spent[number - 1]++;
    for (size_t i = 0; i < t->series.n; i++)
        add_value(t, t->series.at[i], t->steps, trace_cell_value(t->series.at[i]->v->type, cell[t->series.at[i]->v->index]));
    t->steps++;
}

// ---- the engine ----

typedef struct TraceEngine {
    Engine engine;
    Engine *inner;
    Trace *trace;
} TraceEngine;

// Copies the message of the traced engine, so that callers find it in this one.
static EngineStatus forward_error(Engine *e, EngineStatus status)
{
    e->error = ((TraceEngine *)e->self)->inner->error;
    return status;
}

static EngineStatus traced_init(Engine *e, uint32_t state, EngineStep *out)
{
    Engine *inner = ((TraceEngine *)e->self)->inner;

    return forward_error(e, inner->init(inner, state, out));
}

static EngineStatus traced_step(Engine *e, const EngineWrite *write, uint32_t n, EngineStep *out)
{
    TraceEngine *t = e->self;
    const EngineStatus status = t->inner->step(t->inner, write, n, out);

    if (status == ENGINE_OK)
        record_step(t->trace, out->cell);
    return forward_error(e, status);
}

static void traced_close(Engine *e)
{
    Engine *inner = ((TraceEngine *)e->self)->inner;

    inner->close(inner);
}

// Returns an engine that passes every call to `inner` and records every step in t.
Engine *trace_wrap_engine(Trace *t, Engine *inner)
{
    TraceEngine *e = ARENA_NEW(t->arena, TraceEngine);

    e->inner = inner;
    e->trace = t;
    e->engine = *inner;
    e->engine.self = e;
    e->engine.init = traced_init;
    e->engine.step = traced_step;
    e->engine.close = traced_close;
    return &e->engine;
}
