// SPDX-License-Identifier: Apache-2.0
// Observes the steps of runs.  Without a fault: records outputs and the steps at which faults can begin.  With a fault: compares outputs with these
// records, and judges requirements.
#include "compiler/whatif/fault_part.h"

#include <string.h>

// Widens the range of each input without a @range so that it contains the current true value.
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

// Notes the first output that differs from the run without a fault.  S is compared last, because another output explains more.
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
    bool in_truth = false;

    for (size_t i = 0; w->judges_truth && w->monitor->ran && i < w->x->machines; i++)
        w->monitor->ran[i] = engine_next(&w->r->answer[0], i).ran;
    if (w->judges_truth)
        in_truth = monitor_step(w->monitor, w->situation, fault_engine_outside(w->e));

    for (uint32_t i = 0; rq && !w->result.violated && i < rq->at.n; i++) {
        const bool is_read = step->results[i] == MONITOR_VIOLATED, counts = !w->r->o->ignored || !w->r->o->ignored[i];
        if (!is_read && !(in_truth && counts && w->monitor->result[i] == MONITOR_VIOLATED))
            continue;
        w->result.violated = i + 1;
        w->result.violated_in_truth = !is_read;
        w->result.violated_at = (FaultMoment){step->number, step->g};
    }
}

// Adds a trigger, unless another machine of the application has one at the same step.
static void add_trigger(FaultRunner *x, FaultTrigger t)
{
    const FaultTrigger *last = x->f->trigger.n ? &x->f->trigger.at[x->f->trigger.n - 1] : NULL;

    if (!last || last->script != t.script || last->step != t.step)
        vec_push(x->arena, &x->f->trigger, t);
}

// Returns the state of a machine in this step.
static const State *state_in(const ScriptStep *step, size_t machine) { return step->states ? step->states[machine] : step->state; }

// Whether the current script already has a trigger at this transition.
static bool has_transition(const FaultWatch *w, const State *from, const State *to)
{
    const Faults *f = w->x->f;

    for (uint32_t i = f->trigger.n; i-- > 0 && &w->x->healthy[f->trigger.at[i].script] == w->healthy; )
        if (f->trigger.at[i].from == from && f->trigger.at[i].state == to)
            return true;
    return false;
}

static uint32_t script_index(const FaultWatch *w) { return (uint32_t)(w->healthy - w->x->healthy); }

// Adds the triggers by time that this step is the first one to reach.
static void add_timed_triggers(FaultWatch *w, const ScriptStep *step)
{
    const FaultOptions *o = &w->x->f->options;
    bool is_reached = false;

    for (uint32_t i = 0; i < o->times; i++)
        is_reached |= step->g >= o->at[i] && (step->number == 1 || w->result.end_g < o->at[i]);
    if (is_reached)
        add_trigger(w->x, (FaultTrigger){script_index(w), step->number, step->g, NULL, step->state, true});
}

// Adds a trigger at each first transition of its kind, and at the start; extends the visit of the state.
static void add_state_triggers(FaultWatch *w, const ScriptStep *step, size_t machine)
{
    const State *state = state_in(step, machine);
    const uint64_t start = w->r->machine[machine].start_step;
    Visit *v = &w->x->visit[state->number - 1];

    if (start == step->number && !has_transition(w, w->last[machine], state))
        add_trigger(w->x, (FaultTrigger){script_index(w), step->number, step->g, w->last[machine], state, false});
    if (step->number - start >= v->last - v->first)
        *v = (Visit){start, step->number};
}

// Records what a machine has done in a step of the run without a fault.  A machine of an application that did not step has the state of its next
// step, which does not count.
static void record_machine(FaultWatch *w, const ScriptStep *step, size_t machine)
{
    if (!engine_next(&w->r->answer[0], machine).ran)
        return;
    if (w->x->f->options.times == 0)
        add_state_triggers(w, step, machine);
    w->last[machine] = state_in(step, machine);
    w->healthy->last[w->last[machine]->number - 1] = step->number;
}

static void watch_machine(FaultWatch *w, const ScriptStep *step, size_t machine)
{
    const State *state = state_in(step, machine);

    if (!engine_next(&w->r->answer[0], machine).ran)
        return;
    w->visited[state->number - 1] = 1;
    if (state->is_abort && w->aborted[machine].step == 0)
        w->aborted[machine] = (FaultMoment){step->number, step->g};
}

void fault_watch_step(void *context, const ScriptStep *step)
{
    FaultWatch *w = context;

    if (w->is_healthy) {
        widen_ranges(w, step->number == 1);
        record_outputs(w, step);
        if (w->x->f->options.times)
            add_timed_triggers(w, step);
        for (size_t i = 0; i < w->x->machines; i++)
            record_machine(w, step, i);
    } else {
        for (size_t i = 0; i < w->x->machines; i++)
            watch_machine(w, step, i);
        compare_outputs(w, step);
        judge_requirements(w, step);
    }
    w->result.end_g = step->g;
}

void fault_begin_watching(FaultRunner *x, uint32_t script)
{
    FaultWatch *w = x->w;
    const Requirements *rq = x->f->options.requirements;

    w->x = x;
    w->healthy = &x->healthy[script];
    w->cell = ARENA_ARRAY(&x->run, uint64_t, x->outputs);
    w->visited = arena_alloc(&x->run, x->f->p->state.n);
    w->last = ARENA_ARRAY(&x->run, const State *, x->machines);
    w->aborted = ARENA_ARRAY(&x->run, FaultMoment, x->machines);
    if (!rq)
        return;
    w->monitor = monitor_new(&x->run, rq, x->f->script[script]->delta_t);
    w->situation = arena_alloc(&x->run, w->monitor->size);
}

void fault_begin_judging_truth(FaultWatch *w, const Fault *fault, uint32_t n)
{
    for (uint32_t i = 0; w->monitor && i < n; i++)
        w->judges_truth |= w->x->is_required[fault[i].input];
    if (w->judges_truth)
        memcpy(w->situation, w->r->situation, w->monitor->size);
}

