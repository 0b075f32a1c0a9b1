// SPDX-License-Identifier: Apache-2.0
// All faults of a trigger share the run before it: that run is copied at the trigger, with everything that it has allocated, and each fault
// returns to the copy.  A script with recorded data has files open, so each of its faults runs from the first step.
#include "compiler/whatif/fault_part.h"

#include <stdlib.h>
#include <string.h>

const char *const fault_outcome_name[] = {
#define OUTCOME(constant, name, words) name,
#include "compiler/whatif/fault_outcomes.def"
#undef OUTCOME
};
const char *const fault_outcome_words[] = {
#define OUTCOME(constant, name, words) words,
#include "compiler/whatif/fault_outcomes.def"
#undef OUTCOME
};

// ---- runs ----

// An engine between the engine with faulty sensors and the machine: lists the writes that change a cell of the machine.
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

    *k = (FaultRecorder){{"recorder", inner->program, NULL, k, recorder_init, recorder_step, recorder_close, inner}, inner, x, 0};
    return &k->engine;
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
    o->ignored = script < x->f->baseline.run.n ? x->f->baseline.run.at[script].ignored : NULL;
    sizes.seed = x->f->options.has_seed ? sizes.seed : s->seed;
    o->seed = arena_copy(&x->run, &sizes.seed, sizeof sizes.seed);
    inner = engine_flat_open_machines(&x->run, x->f->p, x->flat, NULL, 0);
    if (x->writes)
        inner = open_recorder(x, inner);
    x->w->e = fault_engine_open(&x->run, inner, x->f->input.at, x->f->input.n, &sizes, (uint32_t)s->random.n);
    engine = ARENA_NEW(&x->run, Engine *);
    *engine = fault_tape_open(x, fault_engine(x->w->e), script);
    x->w->r = ARENA_NEW(&x->run, ScriptRun);
    *x->w->r = (ScriptRun){.arena = &x->run, .diags = unused, .s = s, .p = x->f->p, .engine = engine, .engines = 1, .o = o};
    fault_begin_watching(x, script);
    run_begin(x->w->r);
}

static const State *next_state(const ScriptRun *r, size_t machine) { return r->p->state.at[engine_next(&r->answer[0], machine).state - 1]; }

static int compare_triggers(const void *a, const void *b)
{
    const FaultTrigger *x = a, *y = b;

    if (x->script != y->script)
        return x->script < y->script ? -1 : 1;
    return x->step < y->step ? -1 : x->step > y->step;
}

static bool has_trigger(const FaultRunner *x, uint32_t script, uint64_t step)
{
    for (uint32_t i = x->f->trigger.n; i-- > 0 && x->f->trigger.at[i].script == script; )
        if (x->f->trigger.at[i].step == step)
            return true;
    return false;
}

// Adds a trigger in the middle of the longest visit of each state, unless the visit is too short to have a middle.  The states of two machines of an
// application can have the same middle, which is one trigger.
static void add_middles(FaultRunner *x, uint32_t script)
{
    for (uint32_t s = 0; s < x->f->p->state.n; s++) {
        const Visit *v = &x->visit[s];
        const uint64_t middle = v->first + (v->last - v->first + 1) / 2;
        if (v->last - v->first >= 2 && !has_trigger(x, script, middle))
            vec_push(x->arena, &x->f->trigger, ((FaultTrigger){script, middle, 0, NULL, x->f->p->state.at[s], false}));
    }
}

// Runs a script without a fault.  Sets its triggers, sorted by step.
static void run_healthy(FaultRunner *x, uint32_t script)
{
    const uint32_t first = x->f->trigger.n;
    Healthy *h = &x->healthy[script];
    ScriptRun *r;

    h->last = ARENA_ARRAY(x->arena, uint64_t, x->f->p->state.n);
    memset(x->visit, 0, x->f->p->state.n * sizeof *x->visit);
    x->o.max_steps = x->f->options.max_steps;
    x->o.continues = false;                           // an assert that fails ends the run, and the script is left out
    start_run(x, script);
    r = x->w->r;
    x->w->is_healthy = true;
    run_continue(r, x->o.max_steps);
    run_end(r);
    h->steps = r->result.steps;
    h->end = ARENA_ARRAY(x->arena, const State *, x->machines);
    for (size_t i = 0; i < x->machines; i++)
        h->end[i] = next_state(r, i);
    if (!baseline_add(&x->f->baseline, r->s->src->name, r->s, &r->result))
        x->f->trigger.n = first;
    else if (x->f->options.times == 0)
        add_middles(x, script);
    if (x->f->trigger.n > first)
        qsort(x->f->trigger.at + first, x->f->trigger.n - first, sizeof *x->f->trigger.at, compare_triggers);
    x->o.continues = true;
}

Faults *faults_new(Arena *arena, const Program *p, const Script *const *script, uint32_t scripts, const FaultOptions *o)
{
    Faults *f = ARENA_NEW(arena, Faults);
    FaultRunner *x = ARENA_NEW(arena, FaultRunner);

    *f = (Faults){.p = p, .script = script, .scripts = scripts, .options = *o, .runner = x};
    x->f = f;
    x->arena = arena;
    arena_init(&x->run, arena->alloc, arena->context, arena->oom);
    arena_init(&x->copy, arena->alloc, arena->context, arena->oom);
    arena_init(&x->tapes, arena->alloc, arena->context, arena->oom);
    x->flat = flat_new_machines(arena, p);
    x->machines = engine_machines(p);
    x->o = (ScriptOptions){.after_step = fault_watch_step, .is_silent = true, .is_compared = true, .requirements = o->requirements,
                           .setting = o->setting, .settings = o->settings};
    x->healthy = arena_array(arena, scripts, sizeof *x->healthy);
    x->visit = arena_array(arena, p->state.n, sizeof *x->visit);
    baseline_init(&f->baseline, arena, o->requirements);
    fault_find_inputs(x);
    fault_find_seen(x);
    for (uint32_t i = 0; i < scripts; i++)
        run_healthy(x, i);
    fault_list_single(x);
    return f;
}

void faults_end(Faults *f)
{
    arena_free(&f->runner->run);
    arena_free(&f->runner->copy);
    arena_free(&f->runner->tapes);
}

// ---- a fault ----

static bool can_copy(const FaultRunner *x, uint32_t script) { return !x->f->script[script]->data; }

// Continues the current run to the step before a trigger, from the previous trigger if the run can be copied there, else from the start.
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
        run_end(x->w->r);                             // closes the file with recorded data
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

// Sets the end of the run with a fault and without: of the first machine that ends in @abort because of the fault; or else of the first one that ends
// elsewhere; or else of the first one.  Returns the index of the machine.
static size_t set_ends(const FaultRunner *x, const Healthy *h, FaultResult *r)
{
    size_t shown = 0;

    for (size_t i = x->machines; i-- > 0; )
        shown = next_state(x->w->r, i) != h->end[i] ? i : shown;
    for (size_t i = x->machines; i-- > 0; )
        shown = next_state(x->w->r, i)->is_abort && !h->end[i]->is_abort ? i : shown;
    r->end = next_state(x->w->r, shown);
    r->healthy_end = h->end[shown];
    return shown;
}

// Returns the worst of what happened in a run with faults, compared with the run without a fault.  aborted: the first step in an @abort state.
static FaultOutcome judge_result(const FaultResult *r, const FaultWatch *w, FaultMoment aborted)
{
    const bool failed = w->r->result.outcome == SCRIPT_FAILED || w->r->result.failures > 0;
    const bool failed_before = failed && (aborted.step == 0 || (r->failed && r->failed_at.step < aborted.step));

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
    size_t machine;

    r = x->w->r;
    fault_begin_judging_truth(x->w, fault, n);
    memset(x->w->visited, 0, x->f->p->state.n);
    fault_engine_begin(x->w->e, fault, n);
    run_continue(r, r->o->max_steps);
    run_end(r);
    result = x->w->result;
    result.trigger = trigger;
    memcpy(result.fault, fault, n * sizeof *fault);
    result.faults = n;
    result.failed = r->result.failed;
    result.failed_at = (FaultMoment){r->result.failed_step, r->result.failed_g};
    machine = set_ends(x, &x->healthy[t->script], &result);
    result.steps = r->result.steps;
    result.outcome = judge_result(&result, x->w, x->w->aborted[machine]);
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
            return false;                             // the sensor keeps the reading of the first step, which is not known yet
        *value = ref_read(in->var->type, fault_engine_true_cell(x->w->e, fault->input));
        return true;
    case FAULT_DEAD: case FAULT_NAN: *value = 0; return true;
    case FAULT_LOW: *value = in->lo; return true;
    case FAULT_HIGH: *value = in->var->type == SM_BOOL ? 1 : in->hi; return true;
    default: return false;
    }
}

// Sets is_repeated of faults with which the machine reads the same constant as with an earlier fault of the same input: pairs do not need both.
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
            if (x->f->options.pairs)
                fault_tape_reset(x);
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

// Marks the states in which the run without a fault is from the current trigger on.
static void mark_healthy(const FaultRunner *x, uint8_t *visited)
{
    const FaultTrigger *t = &x->f->trigger.at[x->at];

    for (uint32_t s = 0; s < x->f->p->state.n; s++)
        visited[s] = x->healthy[t->script].last[s] >= t->step;
}

static uint8_t *visited_by(const FaultRunner *x, uint32_t single) { return x->visited + single * x->f->p->state.n; }

// Returns the result of a fault of an input that nothing reads: that of the run without a fault.
static FaultResult result_unread(const FaultRunner *x, const Fault *fault)
{
    const Healthy *h = &x->healthy[x->f->trigger.at[x->at].script];

    return (FaultResult){.trigger = x->at, .fault = {*fault}, .faults = 1, .end = h->end[0], .healthy_end = h->end[0], .steps = h->steps};
}

// Runs the next single fault from the current trigger; without a run if no visited state reads its input.
static void run_single_fault(FaultRunner *x)
{
    const Fault *fault = &x->single.at[x->i];
    uint8_t *visited = visited_by(x, x->i);
    FaultResult r;

    mark_healthy(x, visited);
    if (x->f->options.runs_all || fault_is_read(x, fault->input, visited)) {
        return_to_trigger(x, &x->f->trigger.at[x->at]);
        if (x->f->options.pairs && can_copy(x, x->f->trigger.at[x->at].script))
            fault_tape_begin(x, x->i);
        r = run_faults(x, x->at, fault, 1);
        memcpy(visited, x->w->visited, x->f->p->state.n);
        x->f->runs++;
    } else
        r = result_unread(x, fault);
    x->alone[x->i] = (uint8_t)r.outcome;
    vec_push(x->arena, &x->f->result, r);
}

// Whether a pair can be worse than each of its faults alone.  It cannot if one of these is as bad as possible, or if nothing in the run of one
// reads the input of the other.
static bool can_be_worse(const FaultRunner *x)
{
    return x->alone[x->i] < FAULT_OUTCOME_COUNT - 1 && x->alone[x->k] < FAULT_OUTCOME_COUNT - 1 &&
           fault_is_read(x, x->single.at[x->i].input, visited_by(x, x->k)) && fault_is_read(x, x->single.at[x->k].input, visited_by(x, x->i));
}

// Whether replay shows that a pair has the same effect as one of its two faults alone.  Tries the more dangerous fault first, because it more likely
// determines the effect of the pair.
static bool repeats_single(FaultRunner *x, const Fault *both)
{
    const FaultTrigger *t = &x->f->trigger.at[x->at];
    const bool is_later_worse = x->alone[x->k] > x->alone[x->i];
    const uint32_t single[] = {is_later_worse ? x->k : x->i, is_later_worse ? x->i : x->k};

    if (!can_copy(x, t->script))
        return false;
    for (int i = 0; i < 2; i++) {
        return_to_trigger(x, t);
        if (fault_pair_repeats(x, single[i], both))
            return true;
    }
    return false;
}

// Runs the next pair of faults from the current trigger, unless it cannot be worse than a fault alone, or does the same as one.
static void run_pair(FaultRunner *x)
{
    const Fault both[FAULTS_MOST] = {x->single.at[x->i], x->single.at[x->k]};
    FaultResult r;

    x->f->pairs++;
    if (!x->f->options.runs_all && !can_be_worse(x))
        return;
    if (!x->f->options.runs_all && repeats_single(x, both)) {
        x->f->repeated++;
        return;
    }
    x->f->runs++;
    return_to_trigger(x, &x->f->trigger.at[x->at]);
    r = run_faults(x, x->at, both, 2);
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
        run_single_fault(x);
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
