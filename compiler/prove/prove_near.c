// SPDX-License-Identifier: Apache-2.0
#include "compiler/prove/prove_near.h"

#include <string.h>

#include "compiler/prove/prove_near_parts.h"
#include "stdlib/convert.h"

enum {
    TAIL = 4,                 // steps that a run goes on after those with changed inputs
    MOST_TAIL = 2000,         // the most steps that are added to TAIL for the time of a `leads to`
    MOST_LASTING = 4000,      // the most steps after the changes of a run that goes on because it still differs (`lasts`)
    MOST_VISIT = 1500         // the most steps with changed inputs if they last until the state is left
};

// ---- runs ----

void near_begin(NearSearch *k, const Scenario *s)
{
    flat_start(k->f, k->block, s->init_state->number);
    monitor_start(k->monitor, k->block + k->f->size);
}

size_t near_set_inputs(NearSearch *k, const Scenario *s, size_t next, uint64_t step)
{
    uint64_t *cell = flat_cells(k->f, k->block);

    for (; next < s->changes && s->change[next].step <= step; next++) {
        const ScenarioChange *c = &s->change[next];
        if (k->m->var_of[c->var] != IR_NONE)
            cell[k->m->var_of[c->var]] = scenario_cell(k->p, c, step, NULL);
    }
    return next;
}

void near_read_cells(NearSearch *k)
{
    const uint64_t *cell = flat_cells(k->f, k->block);

    for (uint32_t v = 0; v < k->p->var.n; v++)
        k->cell[v] = k->m->var_of[v] == IR_NONE ? k->p->var.at[v]->init : cell[k->m->var_of[v]];
}

MonitorResult near_run_step(NearSearch *k, uint64_t step)
{
    flat_cells(k->f, k->block)[k->m->g] = (step - 1) * k->g->delta_t;
    flat_step(k->f, k->block);
    near_read_cells(k);
    monitor_step(k->monitor, k->block + k->f->size, k->cell);
    k->steps++;
    return (MonitorResult)k->monitor->result[k->g->requirement];
}

NearTrace near_trace(const NearSearch *k)
{
    NearTrace t = {near_state(k), 0};

    for (uint32_t v = 0; v < k->p->var.n; v++) {
        const Var *var = k->p->var.at[v];
        if (var->written && var != k->p->t)
            t.stored = (t.stored ^ k->cell[v]) * UINT64_C(0x9e3779b97f4a7c15) + v;
    }
    return t;
}

// ---- changed inputs ----

// A run close to a given one.
typedef struct Variant {
    const NearStep *at;       // the first step with changed inputs
    NearValue value[NEAR_INPUTS];     // the `values` inputs that are changed, and their values
    uint32_t values;
    uint64_t most;            // the most steps for which the inputs are changed
    bool for_visit;           // the inputs are changed only until the state is left
    uint64_t end;             // the first step after the changed ones; 0: not there yet
    uint64_t given[NEAR_INPUTS];      // by index in `value`: what the given run has instead
    bool lasting;             // the run goes on to the end of the given run, as long as what it has stored differs
    uint64_t violated;        // the step that violates the requirement; 0: none
} Variant;

// Returns how many steps a variant of the run goes on after its change: as long as the requirement waits, within a limit.
static uint64_t tail_of(const NearSearch *k)
{
    const uint64_t within = k->what->kind == REQUIREMENT_LEADS_TO ? k->what->within / k->g->delta_t : 0;

    return TAIL + (within < MOST_TAIL ? within : MOST_TAIL);
}

// Sets the inputs that the variant changes.
static void set_values(NearSearch *k, const Variant *x)
{
    uint64_t *cell = flat_cells(k->f, k->block);

    for (uint32_t i = 0; i < x->values; i++)
        cell[k->m->var_of[x->value[i].var]] = x->value[i].cell;
}

// Exchanges the values of the changed inputs for those that the given run has.
static void set_given(NearSearch *k, const Variant *x)
{
    uint64_t *cell = flat_cells(k->f, k->block);

    for (uint32_t i = 0; i < x->values; i++)
        cell[k->m->var_of[x->value[i].var]] = x->given[i];
}

// Stores what the given run would have set these inputs to.
static void get_given(const NearSearch *k, Variant *x)
{
    const uint64_t *cell = flat_cells(k->f, k->block);

    for (uint32_t i = 0; i < x->values; i++)
        x->given[i] = cell[k->m->var_of[x->value[i].var]];
}

// Whether the current run, which has run `step`, is worth running to the end of the given run: b of an `after` was in its changed steps, or it has
// the state of the given run and something else stored.
static bool is_different(const NearSearch *k, const Variant *x, uint64_t step, uint64_t *how)
{
    const Scenario *s = &k->g->given[x->at->given];
    const NearTrace now = near_trace(k), *given = &k->trace[x->at->given][step];
    uint64_t since;

    if (step >= s->steps || step >= x->end + MOST_LASTING)
        return false;
    if (k->what->kind == REQUIREMENT_AFTER) {
        monitor_is_open(k->monitor, k->block + k->f->size, k->g->requirement, &since);
        if (since >= (x->at->step - 1) * k->g->delta_t && since < x->end * k->g->delta_t) {
            *how = now.stored * 2 + 1;
            return true;
        }
    }
    *how = (now.stored ^ given->stored) * 2;
    return now.state == given->state && now.stored != given->stored;
}

// Whether a variant whose changed steps have ended runs on.  The first time, `how` it differs decides: one run for each difference
// from a given run.
static bool lasts(NearSearch *k, const Variant *x, uint64_t step)
{
    const bool is_first = step + 1 == x->end + tail_of(k);
    uint64_t how = 0;

    if (!x->lasting || !is_different(k, x, step, &how))
        return false;
    how = (how * 64 + near_state(k)) * 64 + x->at->given;
    for (uint32_t i = 0; is_first && i < k->lasted.n; i++)
        if (k->lasted.at[i] == how)
            return false;
    if (is_first)
        vec_push(k->work, &k->lasted, how);
    return k->steps < k->limit;
}

// Runs a variant.  Returns whether it violates the requirement.
static bool run_variant(NearSearch *k, Variant *x)
{
    const Scenario *s = &k->g->given[x->at->given];
    const uint64_t first = x->at->step, tail = tail_of(k);
    size_t next = x->at->change;
    uint32_t state;

    memcpy(k->block, x->at->snapshot, k->size);
    state = near_state(k);
    x->end = 0;
    x->violated = 0;
    get_given(k, x);
    for (uint64_t step = first; x->end == 0 || step < x->end + tail || lasts(k, x, step - 1); step++) {
        MonitorResult r;
        set_given(k, x);
        next = near_set_inputs(k, s, next, step);
        get_given(k, x);
        if (x->end == 0 && (step == first + x->most || (x->for_visit && near_state(k) != state)))
            x->end = step;
        if (x->end == 0)
            set_values(k, x);
        r = near_run_step(k, step);
        k->premise_seen |= r != MONITOR_IDLE;
        if (r == MONITOR_VIOLATED) {
            x->violated = step;
            x->end = x->end ? x->end : step + 1;
            return true;
        }
    }
    return false;
}

// ---- scenarios ----

// Returns the index of a variable in the variant's list of changed inputs; x->values if the variant leaves it as it is.
static uint32_t index_in(const Variant *x, uint32_t var)
{
    uint32_t i = 0;

    while (i < x->values && x->value[i].var != var)
        i++;
    return i;
}

// Returns the scenario of a variant: the changes of the given run, with the variant's values for its inputs in its steps.
static Scenario scenario_of(const NearSearch *k, Arena *arena, const Variant *x)
{
    const Scenario *s = &k->g->given[x->at->given];
    ScenarioChange *change = ARENA_ARRAY(arena, ScenarioChange, s->changes + 2 * NEAR_INPUTS);
    Scenario out = {.init_state = s->init_state, .delta_t = s->delta_t, .steps = x->violated, .change = change};
    uint64_t was[NEAR_INPUTS] = {0};
    size_t c = 0;

    for (; c < s->changes && s->change[c].step < x->at->step; c++) {
        const uint32_t i = index_in(x, s->change[c].var);
        change[out.changes++] = s->change[c];
        if (i < x->values)
            was[i] = scenario_cell(k->p, &s->change[c], s->change[c].step, NULL);
    }
    for (uint32_t i = 0; i < x->values; i++)
        change[out.changes++] = (ScenarioChange){.step = x->at->step, .var = x->value[i].var,
                                                 .a = sm_cell_to_f64(k->p->var.at[x->value[i].var]->type, x->value[i].cell)};
    for (bool ended = false; ; c++) {
        const uint64_t step = c < s->changes ? s->change[c].step : UINT64_MAX;
        uint32_t i;
        if (!ended && step > x->end) {
            for (i = 0; i < x->values && x->end <= x->violated; i++)
                change[out.changes++] = (ScenarioChange){.step = x->end, .var = x->value[i].var,
                                                         .a = sm_cell_to_f64(k->p->var.at[x->value[i].var]->type, was[i])};
            ended = true;
        }
        if (step > x->violated)
            break;
        i = index_in(x, s->change[c].var);
        if (i < x->values)
            was[i] = scenario_cell(k->p, &s->change[c], step, NULL);
        if (i == x->values || ended)
            change[out.changes++] = s->change[c];
    }
    return out;
}

// Runs a variant of a given run; if it violates the requirement, confirms that on the reference interpreter.
static bool try_variant(NearSearch *k, Arena *arena, Variant *x, NearFound *found)
{
    Scenario s;
    const Scenario *confirmed;

    if (!run_variant(k, x))
        return false;
    s = scenario_of(k, arena, x);
    confirmed = goal_end_scenario(arena, k->g, &s);
    if (!confirmed)
        return false;
    found->scenario = confirmed;
    found->given = x->at->given;
    found->from = x->at->step;
    found->to = x->end - 1;
    found->turns = x->values;
    for (uint32_t i = 0; i < x->values; i++)
        found->turn[i] = (NearTurn){k->p->var.at[x->value[i].var], sm_cell_to_f64(k->p->var.at[x->value[i].var]->type, x->value[i].cell)};
    return true;
}

// ---- phases ----

typedef enum NearPhase { ONE_STEP, ONE_WINDOW, TWO_STEP, LASTING_STEP, LASTING_WINDOW, ONE_VISIT, TWO_WINDOW, NEAR_PHASES } NearPhase;

// two: inputs are changed in pairs; window: for as many steps as a window has samples; visit: until the state is left; lasting: Variant.lasting;
// percent: how much of the steps that are left the phase can run
static const struct { bool two, window, visit, lasting; uint32_t percent; } phase_info[NEAR_PHASES] = {
    [ONE_STEP] = {.percent = 30},
    [ONE_WINDOW] = {.window = true, .percent = 45},
    [TWO_STEP] = {.two = true, .percent = 70},
    [LASTING_STEP] = {.lasting = true, .percent = 30},
    [LASTING_WINDOW] = {.window = true, .lasting = true, .percent = 50},
    [ONE_VISIT] = {.visit = true, .percent = 85},
    [TWO_WINDOW] = {.two = true, .window = true, .percent = 100},
};

// Most requirements are violated soon after the changed inputs, or not at all.  In `never a after b`, the step with a can come much later.
static const NearPhase usual_order[NEAR_PHASES] = {ONE_STEP, ONE_WINDOW, TWO_STEP, LASTING_STEP, LASTING_WINDOW, ONE_VISIT, TWO_WINDOW};
static const NearPhase order_of_after[NEAR_PHASES] = {ONE_STEP, LASTING_WINDOW, LASTING_STEP, TWO_STEP, ONE_VISIT, TWO_WINDOW, ONE_WINDOW};

// Tries a variant for as long as the phase says.
static bool try_lasting(NearSearch *k, Arena *arena, NearPhase phase, Variant *x, NearFound *found)
{
    uint32_t samples = 1;

    for (uint32_t i = 0; i < x->values; i++)
        samples = x->value[i].samples > samples ? x->value[i].samples : samples;
    if (!phase_info[phase].window) {
        x->for_visit = phase_info[phase].visit;
        x->most = x->for_visit ? MOST_VISIT : 1;
        return try_variant(k, arena, x, found);
    }
    for (uint32_t more = 0; samples > 1 && more < 2; more++) {
        x->most = samples + more;
        if (try_variant(k, arena, x, found))
            return true;
    }
    return false;
}

// Takes the run back to a step of the given run, and lists the values of inputs that are worth a try there.
static void prepare_values(NearSearch *k, const NearStep *at)
{
    memcpy(k->block, at->snapshot, k->size);
    near_set_inputs(k, &k->g->given[at->given], at->change, at->step);
    flat_cells(k->f, k->block)[k->m->g] = (at->step - 1) * k->g->delta_t;
    near_read_cells(k);
    near_list_values(k, near_state(k));
}

// Whether two values are tried together: they are of different inputs, and the requirement compares at least one of them.
static bool is_pair(const NearValue *a, const NearValue *b) { return a->var != b->var && (a->is_required || b->is_required); }

// Tries all changes of one phase at a step of a given run.
static bool try_step(NearSearch *k, Arena *arena, NearPhase phase, const NearStep *at, NearFound *found)
{
    Variant x = {.at = at, .values = phase_info[phase].two ? 2 : 1, .lasting = phase_info[phase].lasting};

    prepare_values(k, at);
    for (uint32_t i = 0; i < k->value.n && k->steps < k->limit; i++) {
        x.value[0] = k->value.at[i];
        if (x.lasting && k->what->kind == REQUIREMENT_AFTER && !x.value[0].is_required)
            continue;                                 // the value cannot change whether b is true
        if (x.values == 1 && try_lasting(k, arena, phase, &x, found))
            return true;
        for (uint32_t j = 0; x.values == 2 && j < i && k->steps < k->limit; j++) {
            x.value[1] = k->value.at[j];
            if (is_pair(&x.value[0], &x.value[1]) && try_lasting(k, arena, phase, &x, found))
                return true;
        }
    }
    return false;
}

static bool goes_on(const NearSearch *k) { return k->steps < k->limit && (!k->g->go_on || k->g->go_on(k->g->context)); }

// Tries the changes of one phase at all steps that were chosen, the most promising steps first.
static bool try_phase(NearSearch *k, Arena *arena, NearPhase phase, NearFound *found)
{
    for (uint32_t i = 0; i < k->step.n && goes_on(k); i++)
        if (try_step(k, arena, phase, &k->step.at[i], found))
            return true;
    return false;
}

void near_open(NearSearch *k, Arena *work, const IrMachine *m, const GoalSearch *g)
{
    *k = (NearSearch){.work = work, .g = g, .p = g->all->program, .m = m, .what = &g->all->at.at[g->requirement]};
    arena_reset(work);
    k->input = goal_inputs(work, k->p);
    k->f = flat_new(work, m, NULL);
    k->monitor = monitor_new(work, g->all, g->delta_t);
    monitor_judge_only(k->monitor, g->requirement);
    k->size = k->f->size + k->monitor->size;
    k->block = arena_alloc(work, k->size);
    k->cell = ARENA_ARRAY(work, uint64_t, k->p->var.n + 1);
    k->limit = (g->effort - 1) / goal_cost_of_step(k->monitor) + 1;
}

NearFound near_search(Arena *arena, Arena *work, const IrMachine *m, const GoalSearch *g)
{
    NearSearch k;
    NearFound found = {.scenario = NULL};
    uint64_t effort;

    near_open(&k, work, m, g);
    effort = k.limit;
    near_find_leaves(&k);
    near_find_steps(&k);
    for (int i = 0; i < NEAR_PHASES && !found.scenario; i++) {
        const NearPhase phase = (k.what->kind == REQUIREMENT_AFTER ? order_of_after : usual_order)[i];
        k.limit = k.steps + (effort > k.steps ? (effort - k.steps) * phase_info[phase].percent / 100 : 0);
        try_phase(&k, arena, phase, &found);
    }
    found.premise_seen = k.premise_seen;
    found.steps = k.steps;
    return found;
}
