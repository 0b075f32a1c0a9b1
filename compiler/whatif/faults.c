// SPDX-License-Identifier: Apache-2.0
// All faults of a trigger share the run before it: that run is copied at the trigger, with everything that it has allocated, and each fault
// returns to the copy.  A script with recorded data has files open, so each of its faults runs from the first step.
#include "compiler/whatif/faults.h"

#include <stdlib.h>
#include <string.h>

#include "compiler/cover/cover.h"
#include "compiler/script/script_run.h"

const char *const fault_outcome_name[] = {
#define OUTCOME(constant, name, words) name,
    FAULT_OUTCOMES(OUTCOME)
#undef OUTCOME
};
const char *const fault_outcome_words[] = {
#define OUTCOME(constant, name, words) words,
    FAULT_OUTCOMES(OUTCOME)
#undef OUTCOME
};

// A change of an output in the run without a fault.
typedef struct Change {
    uint64_t step, cell;
    uint32_t output;
} Change;

// The run of a script without a fault.
typedef struct Healthy {
    VEC(Change) change;
    uint64_t steps;
    const State *end;
} Healthy;

// A visit of a state, from its first step to its last one.
typedef struct Visit { uint64_t first, last; } Visit;

// What is observed in a run.  It is in the arena of the run, so that a copy of the run contains it.
typedef struct FaultWatch {
    FaultRunner *x;
    ScriptRun *r;
    FaultEngine *e;
    Healthy *healthy;
    bool is_healthy;          // the run has no fault, and is recorded instead of compared
    uint64_t *cell;           // by output: the value without a fault
    uint32_t next;            // index into healthy->change
    Monitor *monitor;         // judges the true values
    bool judges_truth;        // a requirement reads a faulty input, so the true values can have another result than the readings
    void *situation;
    const State *last;        // the state that the step before ran
    FaultMoment aborted;      // the first step that ran in an @abort state; step 0: none
    FaultResult result;       // only what is seen after a step
} FaultWatch;

struct FaultRunner {
    Faults *f;
    Arena *arena;             // of the results
    Arena run, copy;          // of the current run; of its copy
    ArenaCopy saved;
    FlatMachine *flat;
    ScriptOptions o;
    const Var **output;
    uint32_t outputs;         // elements that the machine writes, and then S
    Healthy *healthy;         // by script
    Visit *visit;             // by State.number - 1: the longest one of the current script
    VEC(Fault) single;        // the faults that apply
    uint8_t *is_required;      // by input: a requirement reads it
    uint8_t *is_judged;        // by input: a requirement, an assert or an @compare reads it
    uint8_t *reads;           // by State.number - 1 and input: a state that can follow reads it, or this one
    uint8_t *alone;           // by single fault: its outcome at the current trigger
    uint8_t *is_repeated;     // by single fault: an earlier one of the same input reads the same constant there
    uint32_t at, i, k;        // the next run: its trigger; its fault, or its two faults i and k
    bool in_pairs;            // the single faults of the trigger have been run
    bool is_prepared;         // the current run is before trigger `at`
    FaultWatch *w;                 // of the current run
    FaultWrites *writes;      // what faults_record collects; NULL: nothing
};

// ---- inputs ----

// Whether the script writes v to the machine.
static bool script_writes(const Script *s, const Var *v)
{
    for (size_t i = 0; s->data && i < s->data->column.n; i++)
        if (s->data->column.at[i].var == v)
            return true;
    for (size_t i = 0; i < s->section.n; i++)
        for (size_t j = 0; j < s->section.at[i].item.n; j++) {
            const ScriptItem *item = s->section.at[i].item.at[j];
            for (size_t k = 0; k < item->inputs.n; k++)
                if (item->inputs.at[k]->var == v)
                    return true;
        }
    return false;
}

bool fault_is_input(const Var *v, const Script *const *script, uint32_t scripts)
{
    const Program *p = scripts ? script[0]->program : NULL;

    if (!p || v->kind != VAR_ELEMENT || v == p->g || v == p->s || !v->read)
        return false;
    for (uint32_t i = 0; i < scripts; i++)
        if (script_writes(script[i], v))
            return true;
    return v->read_only;
}

static void add_input(FaultRunner *x, const Var *v)
{
    FaultInput in = {.var = v};

    if (v->range) {
        in.lo = v->range->lo;
        in.hi = v->range->hi;
        in.has_range = in.lo < in.hi;
    }
    vec_push(x->arena, &x->f->input, in);
}

static void list_inputs(FaultRunner *x)
{
    const Faults *f = x->f;

    for (uint32_t i = 0; i < f->options.inputs; i++)
        add_input(x, f->options.input[i]);
    for (size_t i = 0; f->options.inputs == 0 && i < f->p->var.n; i++)
        if (fault_is_input(f->p->var.at[i], f->script, f->scripts))
            add_input(x, f->p->var.at[i]);
}

static bool is_input(const Faults *f, const Var *v)
{
    for (uint32_t i = 0; i < f->input.n; i++)
        if (f->input.at[i].var == v)
            return true;
    return false;
}

static void list_outputs(FaultRunner *x)
{
    const Program *p = x->f->p;

    x->output = ARENA_ARRAY(x->arena, const Var *, p->var.n);
    for (size_t i = 0; i < p->var.n; i++) {
        const Var *v = p->var.at[i];
        if (v->kind == VAR_ELEMENT && v->written && v != p->s && v != p->g && !is_input(x->f, v))
            x->output[x->outputs++] = v;
    }
    x->output[x->outputs++] = p->s;
}

bool fault_applies(const FaultInput *in, FaultKind kind)
{
    const bool is_bool = in->var->type == SM_BOOL, is_float = in->var->type == SM_F32 || in->var->type == SM_F64;

    switch (kind) {
    case FAULT_STUCK: case FAULT_DEAD: case FAULT_LATE: case FAULT_DROPPED: return true;
    case FAULT_NAN: return is_float;
    case FAULT_HIGH: return is_bool || in->has_range;
    case FAULT_LOW: case FAULT_BELOW: case FAULT_ABOVE: case FAULT_NOISY: return !is_bool && in->has_range;
    case FAULT_FLIPPED: return is_bool;
    case FAULT_KIND_COUNT: break;
    }
    return false;
}

static void list_single_faults(FaultRunner *x)
{
    const Faults *f = x->f;

    for (uint32_t i = 0; i < f->input.n; i++)
        for (int k = 0; k < FAULT_KIND_COUNT; k++) {
            const Fault fault = {i, (FaultKind)k};
            if (f->options.kinds >> k & 1 && fault_applies(&f->input.at[i], fault.kind))
                vec_push(x->arena, &x->single, fault);
        }
    x->alone = arena_alloc(x->arena, x->single.n + 1);
    x->is_repeated = arena_alloc(x->arena, x->single.n + 1);
}

// Where the inputs that an expression reads are marked, by input.
typedef struct Marks { const Faults *f; uint8_t *at; } Marks;

static void mark_inputs(Expr *e, void *context)
{
    Marks *m = context;

    for (uint32_t i = 0; e->kind == EX_VAR && i < m->f->input.n; i++)
        m->at[i] |= m->f->input.at[i].var == e->var;
}

static void mark_statements(const Stmts *list, Marks *m, uint8_t *targets)
{
    for (uint32_t i = 0; i < list->n; i++) {
        const Stmt *s = list->at[i];
        if (s->value)
            expr_walk(s->value, mark_inputs, m);
        if (s->kind == ST_TRANSITION)
            targets[s->target->number - 1] = 1;
        mark_statements(&s->then, m, targets);
        mark_statements(&s->otherwise, m, targets);
    }
}

// Finds which inputs a state and all that can follow it read, windows included, whatever the guards.
static void find_reads(FaultRunner *x)
{
    const Program *p = x->f->p;
    const uint32_t n = (uint32_t)p->state.n, inputs = x->f->input.n;
    uint8_t *targets = arena_alloc(x->arena, (size_t)n * n + 1);
    bool changed = true;

    x->reads = arena_alloc(x->arena, (size_t)n * inputs + 1);
    for (uint32_t s = 0; s < n; s++) {
        Marks m = {x->f, x->reads + (size_t)s * inputs};
        for (int b = 0; b < BLOCK_COUNT; b++)
            mark_statements(&p->state.at[s]->block[b], &m, targets + (size_t)s * n);
    }
    while (changed) {
        changed = false;
        for (uint32_t s = 0; s < n; s++)
            for (uint32_t t = 0; t < n; t++)
                for (uint32_t i = 0; targets[(size_t)s * n + t] && i < inputs; i++)
                    if (x->reads[(size_t)t * inputs + i] && !x->reads[(size_t)s * inputs + i])
                        changed = (x->reads[(size_t)s * inputs + i] = 1) != 0;
    }
}

// Marks the inputs that asserts read.
static void find_judged(FaultRunner *x, Marks *m)
{
    for (uint32_t i = 0; i < x->f->scripts; i++) {
        const Script *s = x->f->script[i];
        for (uint32_t k = 0; k < s->section.n; k++)
            for (uint32_t j = 0; j < s->section.at[k].item.n; j++)
                for (uint32_t a = 0; a < s->section.at[k].item.at[j]->asserts.n; a++)
                    if (s->section.at[k].item.at[j]->asserts.at[a].condition)
                        expr_walk(s->section.at[k].item.at[j]->asserts.at[a].condition, mark_inputs, m);
        for (uint32_t k = 0; s->data && k < s->data->compare.n; k++)
            for (uint32_t n = 0; n < x->f->input.n; n++)
                m->at[n] |= x->f->input.at[n].var == s->data->compare.at[k].column.var;
    }
}

// Marks the inputs that requirements read.
static void find_required(FaultRunner *x)
{
    const Requirements *rq = x->f->options.requirements;

    Marks required = {x->f, arena_alloc(x->arena, x->f->input.n + 1)}, judged = {x->f, arena_alloc(x->arena, x->f->input.n + 1)};

    x->is_required = required.at;
    x->is_judged = judged.at;
    find_judged(x, &judged);
    for (uint32_t i = 0; rq && i < rq->at.n; i++) {
        Expr *const condition[] = {rq->at.at[i].a, rq->at.at[i].b, rq->at.at[i].c};
        for (int k = 0; k < 3; k++)
            if (condition[k]) {
                expr_walk(condition[k], mark_inputs, &required);
                expr_walk(condition[k], mark_inputs, &judged);
            }
    }
}

// ---- what a step shows ----

// Widens the range of each input that has none of its own to its true value.
static void widen_ranges(FaultWatch *w, bool is_first)
{
    Faults *f = w->x->f;

    for (uint32_t i = 0; i < f->input.n; i++) {
        FaultInput *in = &f->input.at[i];
        const double x = ref_read(in->var->type, fault_engine_true_cell(w->e, i));
        const bool begins = is_first && w->healthy == &w->x->healthy[0];
        if (in->var->range || in->var->type == SM_BOOL)
            continue;
        in->range_is_seen = true;
        in->lo = begins || x < in->lo ? x : in->lo;
        in->hi = begins || x > in->hi ? x : in->hi;
        in->has_range = in->lo < in->hi;
    }
}

static void record_outputs(FaultWatch *w, const ScriptStep *step)
{
    for (uint32_t i = 0; i < w->x->outputs; i++) {
        const Change c = {step->number, step->cell[w->x->output[i]->index], i};
        if (step->number > 1 && c.cell == w->cell[i])
            continue;
        w->cell[i] = c.cell;
        vec_push(w->x->arena, &w->healthy->change, c);
    }
}

// Notes the first output that differs from the run without a fault.  S is the last one, so that another output explains more.
static void compare_outputs(FaultWatch *w, const ScriptStep *step)
{
    const Healthy *h = w->healthy;

    for (; w->next < h->change.n && h->change.at[w->next].step <= step->number; w->next++)
        w->cell[h->change.at[w->next].output] = h->change.at[w->next].cell;
    for (uint32_t i = 0; i < w->x->outputs && !w->result.differs && step->number <= h->steps; i++) {
        const uint64_t cell = step->cell[w->x->output[i]->index];
        if (cell == w->cell[i])
            continue;
        w->result.differs = w->x->output[i];
        w->result.differs_at = (FaultMoment){step->number, step->g};
        w->result.cell = cell;
        w->result.healthy_cell = w->cell[i];
    }
}

// Notes the first requirement that the step violates: for what the machine reads, or else for the true values.
static void judge_requirements(FaultWatch *w, const ScriptStep *step)
{
    const Requirements *rq = w->x->f->options.requirements;
    const bool in_truth = w->judges_truth && monitor_step(w->monitor, w->situation, fault_engine_outside(w->e));

    for (uint32_t i = 0; rq && !w->result.violated && i < rq->at.n; i++) {
        const bool is_read = step->results[i] == MONITOR_VIOLATED;
        if (!is_read && !(in_truth && w->monitor->result[i] == MONITOR_VIOLATED))
            continue;
        w->result.violated = i + 1;
        w->result.violated_in_truth = !is_read;
        w->result.violated_at = (FaultMoment){step->number, step->g};
    }
}

static void add_trigger(FaultRunner *x, FaultTrigger t)
{
    vec_push(x->arena, &x->f->trigger, t);
}

// Whether the current script already has a trigger at this transition.
static bool has_transition(const FaultWatch *w, const State *from, const State *to)
{
    const Faults *f = w->x->f;

    for (uint32_t i = f->trigger.n; i-- > 0 && &w->x->healthy[f->trigger.at[i].script] == w->healthy; )
        if (f->trigger.at[i].from == from && f->trigger.at[i].state == to)
            return true;
    return false;
}

static uint32_t script_of(const FaultWatch *w) { return (uint32_t)(w->healthy - w->x->healthy); }

// Adds the triggers by time that this step is the first one to reach.
static void add_timed_triggers(FaultWatch *w, const ScriptStep *step)
{
    const FaultOptions *o = &w->x->f->options;
    bool is_reached = false;

    for (uint32_t i = 0; i < o->times; i++)
        is_reached |= step->g >= o->at[i] && (step->number == 1 || w->result.end_g < o->at[i]);
    if (is_reached)
        add_trigger(w->x, (FaultTrigger){script_of(w), step->number, step->g, NULL, step->state, true});
}

// Adds a trigger at each first transition of its kind, and at the start; extends the visit of the state.
static void add_state_triggers(FaultWatch *w, const ScriptStep *step)
{
    const bool is_first = w->r->machine[0].start_step == step->number;
    Visit *v = &w->x->visit[step->state->number - 1];

    if (is_first && !has_transition(w, w->last, step->state))
        add_trigger(w->x, (FaultTrigger){script_of(w), step->number, step->g, w->last, step->state, false});
    if (step->number - w->r->machine[0].start_step >= v->last - v->first)
        *v = (Visit){w->r->machine[0].start_step, step->number};
}

static void watch_step(void *context, const ScriptStep *step)
{
    FaultWatch *w = context;

    if (w->is_healthy) {
        widen_ranges(w, step->number == 1);
        record_outputs(w, step);
        if (w->x->f->options.times)
            add_timed_triggers(w, step);
        else
            add_state_triggers(w, step);
        w->last = step->state;
        w->result.end_g = step->g;
        return;
    }
    compare_outputs(w, step);
    judge_requirements(w, step);
    if (step->state->is_abort && w->aborted.step == 0)
        w->aborted = (FaultMoment){step->number, step->g};
    w->result.end_g = step->g;
}

// ---- runs ----

// Between the faulty sensors and the machine: notes the writes that change a cell of the machine.
typedef struct FaultRecorder {
    Engine engine;
    Engine *inner;
    FaultRunner *x;
    uint64_t step;
} FaultRecorder;

static EngineStatus recorder_init(Engine *e, uint32_t state, EngineStep *out)
{
    FaultRecorder *k = e->self;

    k->step = 0;
    return k->inner->init(k->inner, state, out);
}

static EngineStatus recorder_step(Engine *e, const EngineWrite *write, uint32_t n, EngineStep *out)
{
    FaultRecorder *k = e->self;
    const Program *p = e->program;
    uint64_t g = 0;

    k->step++;
    for (uint32_t i = 0; i < n; i++)
        g = write[i].var == p->g->index ? write[i].cell : g;
    for (uint32_t i = 0; i < n; i++) {
        const FaultWrite w = {k->step, g, p->var.at[write[i].var], write[i].cell};
        bool is_last = true;
        for (uint32_t j = i + 1; j < n; j++)
            is_last &= write[j].var != write[i].var;
        if (is_last && w.var != p->g && out->cell[write[i].var] != write[i].cell)
            vec_push(k->x->arena, k->x->writes, w);
    }
    return k->inner->step(k->inner, write, n, out);
}

static void recorder_close(Engine *e) { (void)e; }

static Engine *open_recorder(FaultRunner *x, Engine *inner)
{
    FaultRecorder *k = ARENA_NEW(&x->run, FaultRecorder);

    *k = (FaultRecorder){{"recorder", inner->program, NULL, k, recorder_init, recorder_step, recorder_close}, inner, x, 0};
    return &k->engine;
}

static void begin_watching(FaultRunner *x, uint32_t script)
{
    FaultWatch *w = x->w;
    const Requirements *rq = x->f->options.requirements;

    w->x = x;
    w->healthy = &x->healthy[script];
    w->cell = ARENA_ARRAY(&x->run, uint64_t, x->outputs);
    if (!rq)
        return;
    w->monitor = monitor_new(&x->run, rq, x->f->script[script]->delta_t);
    w->situation = arena_alloc(&x->run, w->monitor->size);
}

// Begins to judge the true values.  Until a fault begins, they are what the machine reads.
static void begin_judging_truth(FaultWatch *w, const Fault *fault, uint32_t n)
{
    for (uint32_t i = 0; w->monitor && i < n; i++)
        w->judges_truth |= w->x->is_required[fault[i].input];
    if (w->judges_truth)
        memcpy(w->situation, w->r->situation, w->monitor->size);
}

// Starts a run of a script, before its first step.
static void start_run(FaultRunner *x, uint32_t script)
{
    const Script *s = x->f->script[script];
    FaultSizes sizes = x->f->options.sizes;
    ScriptOptions *o;
    Diags *unused;
    Engine **engine, *inner;

    arena_reset(&x->run);
    x->w = ARENA_NEW(&x->run, FaultWatch);
    unused = ARENA_NEW(&x->run, Diags);
    diags_init(unused, &x->run);
    unused->muted = true;
    o = arena_copy(&x->run, &x->o, sizeof x->o);
    o->context = x->w;
    sizes.seed = x->f->options.has_seed ? sizes.seed : s->seed;
    o->seed = arena_copy(&x->run, &sizes.seed, sizeof sizes.seed);
    inner = engine_flat_open(&x->run, x->f->p, x->flat);
    if (x->writes)
        inner = open_recorder(x, inner);
    x->w->e = fault_engine_open(&x->run, inner, x->f->input.at, x->f->input.n, &sizes, (uint32_t)s->random.n);
    engine = ARENA_NEW(&x->run, Engine *);
    *engine = fault_engine(x->w->e);
    x->w->r = ARENA_NEW(&x->run, ScriptRun);
    *x->w->r = (ScriptRun){.arena = &x->run, .diags = unused, .s = s, .p = x->f->p, .engine = engine, .engines = 1, .o = o};
    begin_watching(x, script);
    run_begin(x->w->r);
}

static const State *next_state(const ScriptRun *r) { return r->p->state.at[engine_next(&r->answer[0], 0).state - 1]; }

static bool is_healthy_run_good(const ScriptRun *r)
{
    bool violated = false;

    for (size_t i = 0; r->requirement && i < r->o->requirements->at.n; i++)
        violated |= r->requirement[i].violated;
    return r->result.outcome == SCRIPT_PASSED && r->result.failures == 0 && !violated;
}

static int compare_triggers(const void *a, const void *b)
{
    const FaultTrigger *x = a, *y = b;

    if (x->script != y->script)
        return x->script < y->script ? -1 : 1;
    return x->step < y->step ? -1 : x->step > y->step;
}

// Adds a trigger in the middle of the longest visit of each state, unless the visit is too short to have a middle.
static void add_middles(FaultRunner *x, uint32_t script)
{
    for (uint32_t s = 0; s < x->f->p->state.n; s++) {
        const Visit *v = &x->visit[s];
        if (v->last - v->first >= 2)
            add_trigger(x, (FaultTrigger){script, v->first + (v->last - v->first + 1) / 2, 0, NULL, x->f->p->state.at[s], false});
    }
}

// Runs a script without a fault.  Sets its triggers, sorted by step.
static void run_healthy(FaultRunner *x, uint32_t script)
{
    const uint32_t first = x->f->trigger.n;
    Healthy *h = &x->healthy[script];
    ScriptRun *r;

    memset(x->visit, 0, x->f->p->state.n * sizeof *x->visit);
    x->o.max_steps = x->f->options.max_steps;
    x->o.continues = false;                           // a failure ends the run, and the campaign
    start_run(x, script);
    r = x->w->r;
    x->w->is_healthy = true;
    run_continue(r, x->o.max_steps);
    run_end(r);
    h->steps = r->result.steps;
    h->end = next_state(r);
    if (!is_healthy_run_good(r) && x->f->failing == x->f->scripts)
        x->f->failing = script;
    if (x->f->options.times == 0)
        add_middles(x, script);
    if (x->f->trigger.n > first)
        qsort(x->f->trigger.at + first, x->f->trigger.n - first, sizeof *x->f->trigger.at, compare_triggers);
    x->o.continues = true;
}

Faults *faults_new(Arena *arena, const Program *p, const Script *const *script, uint32_t scripts, const FaultOptions *o)
{
    Faults *f = ARENA_NEW(arena, Faults);
    FaultRunner *x = ARENA_NEW(arena, FaultRunner);

    *f = (Faults){.p = p, .script = script, .scripts = scripts, .options = *o, .failing = scripts, .runner = x};
    x->f = f;
    x->arena = arena;
    arena_init(&x->run, arena->alloc, arena->context, arena->oom);
    arena_init(&x->copy, arena->alloc, arena->context, arena->oom);
    x->flat = flat_new(arena, ir_build(arena, p), NULL);
    x->o = (ScriptOptions){.after_step = watch_step, .is_silent = true, .is_compared = true, .requirements = o->requirements,
                           .setting = o->setting, .settings = o->settings};
    x->healthy = arena_array(arena, scripts, sizeof *x->healthy);
    x->visit = arena_array(arena, p->state.n, sizeof *x->visit);
    list_inputs(x);
    list_outputs(x);
    find_required(x);
    find_reads(x);
    for (uint32_t i = 0; i < scripts; i++)
        run_healthy(x, i);
    list_single_faults(x);
    return f;
}

uint32_t faults_find_failing(const Faults *f) { return f->failing; }

void faults_end(Faults *f)
{
    arena_free(&f->runner->run);
    arena_free(&f->runner->copy);
}

// ---- a fault ----

static bool can_copy(const FaultRunner *x, uint32_t script) { return !x->f->script[script]->data; }

// Takes the current run to just before a trigger.  Without recorded data it continues from the trigger before.
static void prepare_trigger(FaultRunner *x, uint32_t trigger)
{
    FaultTrigger *t = &x->f->trigger.at[trigger];
    const bool continues = trigger > 0 && t[-1].script == t->script && x->is_prepared && can_copy(x, t->script);

    x->o.max_steps = 2 * x->healthy[t->script].steps + 100;
    if (continues)
        arena_restore(&x->run, &x->saved);
    else
        start_run(x, t->script);
    run_continue(x->w->r, t->step - 1);
    t->g = x->w->r->g;
    if (!can_copy(x, t->script)) {
        run_end(x->w->r);                             // closes the data
        return;
    }
    arena_reset(&x->copy);
    arena_save(&x->run, &x->copy, &x->saved);
}

// Returns the run to the trigger for another fault.
static void return_to_trigger(FaultRunner *x, const FaultTrigger *t)
{
    if (can_copy(x, t->script)) {
        arena_restore(&x->run, &x->saved);
        return;
    }
    start_run(x, t->script);
    run_continue(x->w->r, t->step - 1);
}

static FaultOutcome judge_result(const FaultResult *r, const FaultWatch *w)
{
    const bool failed = w->r->result.outcome == SCRIPT_FAILED || w->r->result.failures > 0;
    const bool failed_before = failed && (w->aborted.step == 0 || (r->failed && r->failed_at.step < w->aborted.step));

    if (r->violated)
        return FAULT_HAS_VIOLATED;
    if (r->end->is_abort && !r->healthy_end->is_abort && !failed_before)
        return FAULT_HAS_ABORTED;
    if (failed)
        return FAULT_HAS_FAILED;
    if (r->end != r->healthy_end)
        return FAULT_HAS_ELSEWHERE;
    if (w->r->result.outcome != SCRIPT_PASSED)
        return FAULT_HAS_ENDLESS;
    return r->differs ? FAULT_HAS_DIFFERS : FAULT_HAS_NONE;
}

// Runs n faults from the trigger to the end of the script.
static FaultResult run_faults(FaultRunner *x, uint32_t trigger, const Fault *fault, uint32_t n)
{
    const FaultTrigger *t = &x->f->trigger.at[trigger];
    FaultResult result;
    ScriptRun *r;

    r = x->w->r;
    begin_judging_truth(x->w, fault, n);
    fault_engine_begin(x->w->e, fault, n);
    run_continue(r, r->o->max_steps);
    run_end(r);
    result = x->w->result;
    result.trigger = trigger;
    memcpy(result.fault, fault, n * sizeof *fault);
    result.faults = n;
    result.failed = r->result.failed;
    result.failed_at = (FaultMoment){r->result.failed_step, r->result.failed_g};
    result.end = next_state(r);
    result.healthy_end = x->healthy[t->script].end;
    result.steps = r->result.steps;
    result.outcome = judge_result(&result, x->w);
    return result;
}

// ---- all of them ----

// Whether a fault reads a constant from its trigger on; sets *x to the value that the machine sees.
static bool reads_constant(const FaultRunner *x, const Fault *fault, double *value)
{
    const FaultInput *in = &x->f->input.at[fault->input];

    switch ((int)fault->kind) {
    case FAULT_STUCK:
        if (x->w->r->result.steps == 0)
            return false;                             // it will be what the first step has
        *value = ref_read(in->var->type, fault_engine_true_cell(x->w->e, fault->input));
        return true;
    case FAULT_DEAD: case FAULT_NAN: *value = 0; return true;
    case FAULT_LOW: *value = in->lo; return true;
    case FAULT_HIGH: *value = in->var->type == SM_BOOL ? 1 : in->hi; return true;
    default: return false;
    }
}

// Finds the faults of which a pair needs only one, because the machine reads the same constant.
static void find_repeated(FaultRunner *x)
{
    for (uint32_t i = 0; i < x->single.n; i++) {
        double a, b;
        x->is_repeated[i] = 0;
        for (uint32_t k = 0; k < i && !x->is_repeated[i]; k++)
            x->is_repeated[i] = x->single.at[k].input == x->single.at[i].input && reads_constant(x, &x->single.at[k], &a) &&
                                reads_constant(x, &x->single.at[i], &b) && a == b;
    }
}

// Moves to the next pair of faults of two inputs.  Returns false after the last one.
static bool next_pair(FaultRunner *x)
{
    for (; x->i < x->single.n; x->i++, x->k = x->i)
        while (++x->k < x->single.n)
            if (x->single.at[x->i].input != x->single.at[x->k].input && !x->is_repeated[x->i] && !x->is_repeated[x->k])
                return true;
    return false;
}

// Moves to the next run.  Returns false after the last one.
static bool next_run(FaultRunner *x)
{
    if (x->single.n == 0)
        return false;
    while (x->at < x->f->trigger.n) {
        if (!x->is_prepared || x->i == UINT32_MAX) {
            prepare_trigger(x, x->at);
            x->is_prepared = true;
            x->in_pairs = false;
            x->i = 0;
            find_repeated(x);
            return true;
        }
        if (!x->in_pairs && ++x->i < x->single.n)
            return true;
        if (!x->in_pairs)
            x->i = x->k = 0;
        x->in_pairs = true;
        if (x->f->options.pairs && next_pair(x))
            return true;
        x->at++;
        x->i = UINT32_MAX;
    }
    return false;
}

// Whether anything can see a fault that begins at the current trigger: until it begins, the run is that without a fault.
static bool is_seen(const FaultRunner *x, const Fault *fault)
{
    const uint32_t state = x->f->trigger.at[x->at].state->number - 1;

    return x->is_judged[fault->input] || x->reads[(size_t)state * x->f->input.n + fault->input];
}

// The result of a fault that nothing sees.
static FaultResult result_unseen(const FaultRunner *x, const Fault *fault)
{
    const Healthy *h = &x->healthy[x->f->trigger.at[x->at].script];

    return (FaultResult){.trigger = x->at, .fault = {*fault}, .faults = 1, .end = h->end, .healthy_end = h->end, .steps = h->steps};
}

static void run_single(FaultRunner *x)
{
    const Fault *fault = &x->single.at[x->i];
    FaultResult r;

    if (is_seen(x, fault)) {
        return_to_trigger(x, &x->f->trigger.at[x->at]);
        r = run_faults(x, x->at, fault, 1);
        x->f->runs++;
    } else
        r = result_unseen(x, fault);
    x->alone[x->i] = (uint8_t)r.outcome;
    vec_push(x->arena, &x->f->result, r);
}

static void run_pair(FaultRunner *x)
{
    const Fault both[FAULTS_MOST] = {x->single.at[x->i], x->single.at[x->k]};
    FaultResult r;

    x->f->pairs++;
    if (!is_seen(x, &both[0]) || !is_seen(x, &both[1]))
        return;                                       // then it is as one of the two alone
    return_to_trigger(x, &x->f->trigger.at[x->at]);
    r = run_faults(x, x->at, both, 2);
    x->f->runs++;
    r.worse_than_alone = r.outcome > (FaultOutcome)x->alone[x->i] && r.outcome > (FaultOutcome)x->alone[x->k];
    if (!r.worse_than_alone)
        return;
    x->f->pairs_worse++;
    vec_push(x->arena, &x->f->result, r);
}

bool faults_run_next(Faults *f)
{
    FaultRunner *x = f->runner;

    if (!next_run(x))
        return false;
    if (f->runs == f->options.max_runs) {
        f->is_cut = true;
        return false;
    }
    f->faults++;
    if (x->in_pairs)
        run_pair(x);
    else
        run_single(x);
    return true;
}

FaultOutcome faults_find_worst(const Faults *f, uint32_t input, FaultKind kind)
{
    FaultOutcome worst = FAULT_HAS_NONE;

    for (uint32_t i = 0; i < f->result.n; i++) {
        const FaultResult *r = &f->result.at[i];
        if (r->faults == 1 && r->fault[0].input == input && r->fault[0].kind == kind && r->outcome > worst)
            worst = r->outcome;
    }
    return worst;
}

void faults_record(Faults *f, const FaultResult *r, FaultWrites *out)
{
    FaultRunner *x = f->runner;
    const FaultTrigger *t = &f->trigger.at[r->trigger];

    x->is_prepared = false;
    x->writes = out;
    x->o.max_steps = r->steps;
    start_run(x, t->script);
    run_continue(x->w->r, t->step - 1);
    run_faults(x, r->trigger, r->fault, r->faults);
    x->writes = NULL;
}
