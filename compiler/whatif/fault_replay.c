// SPDX-License-Identifier: Apache-2.0
// Finds pairs of faults that have the same effect as one of the two faults alone, without running the script.
//
// The run of each fault alone is recorded: what the script writes in each step, and the values that the script, the requirements and the comparison
// of outputs read after it.  The machine then steps with both faults and the recorded writes, without the script.  As long as the values equal the
// recorded ones, the script would have written the same.  If they are equal up to the end of the record, the outcome is that of the fault alone.
#include "compiler/whatif/fault_part.h"

#include <string.h>

enum { VALUES_MOST = 1 << 22 };       // the most writes and changes that all records of a trigger together can have

// An engine between the script and the engine with faulty sensors that records what the script writes and reads.
struct FaultTape {
    Engine engine;
    Engine *inner;
    FaultRunner *x;
    FaultRecord *to;          // NULL: nothing is recorded
    uint64_t *last;           // by slot of a record (count_slots): the value after the last recorded step
};

// ---- what scripts and requirements read ----

// Returns the index of an input, or the number of inputs.
static uint32_t find_input(const Faults *f, const Var *v)
{
    uint32_t i = 0;

    while (i < f->input.n && f->input.at[i].var != v)
        i++;
    return i;
}

// Finds, for each script, the variables that the script, the requirements or the comparison of outputs read after a step.
void fault_find_seen(FaultRunner *x)
{
    const Faults *f = x->f;
    const uint32_t vars = (uint32_t)f->p->var.n;

    x->seen = arena_array(x->arena, f->scripts, sizeof *x->seen);
    for (uint32_t s = 0; s < f->scripts; s++) {
        bool *seen = arena_alloc(x->arena, vars + f->script[s]->local.n + 1);
        FaultSeen *to = &x->seen[s];
        script_mark_reads(f->script[s], seen);
        if (f->options.requirements)
            requirements_mark_reads(f->options.requirements, seen);
        for (uint32_t i = 0; i < x->outputs; i++)
            seen[x->output[i]->index] = true;
        for (size_t i = 0; f->p->joint && i < x->machines; i++)
            if (f->p->joint->member.at[i].mode)
                seen[f->p->joint->member.at[i].mode->index] = true;
        for (uint32_t v = 0; v < vars; v++) {
            const Var *var = f->p->var.at[v];
            const uint32_t input = find_input(f, var);
            if (!seen[v] || var == f->p->g)
                continue;
            if (input == f->input.n || x->is_judged[input])
                vec_push(x->arena, &to->cell, v);
            if (input < f->input.n && fault_is_written(f->p, var))
                vec_push(x->arena, &to->outside, v);
        }
    }
}

// A step is recorded as slots: for each machine its next state, and whether that is in its first step and whether the machine ran; then the values of
// FaultSeen.cell, then those of .outside.
static uint32_t count_slots(const FaultRunner *x, const FaultSeen *s) { return 2 * (uint32_t)x->machines + s->cell.n + s->outside.n; }

// Returns one value of a step's record; `slot` is below count_slots.
static uint64_t read_slot(const FaultRunner *x, const FaultSeen *s, const EngineStep *out, uint32_t slot)
{
    const EngineNext next = slot < 2 * x->machines ? engine_next(out, slot / 2) : (EngineNext){0};

    if (slot < 2 * x->machines)
        return slot % 2 ? next.is_first + 2u * next.ran : next.state;
    slot -= 2 * (uint32_t)x->machines;
    return slot < s->cell.n ? out->cell[s->cell.at[slot]] : out->outside[s->outside.at[slot - s->cell.n]];
}

// ---- recording ----

static const FaultSeen *observed_in_script(const FaultWatch *w) { return &w->x->seen[w->healthy - w->x->healthy]; }

// Adds a step to the record of the current fault: its writes, and the slots whose values have changed.
static void record_step(FaultTape *k, const EngineWrite *write, uint32_t n, const EngineStep *out)
{
    FaultRunner *x = k->x;
    const FaultSeen *seen = observed_in_script(x->w);
    const bool is_first = k->to->end.n == 0;

    for (uint32_t i = 0; i < n; i++)
        vec_push(&x->tapes, &k->to->write, write[i]);
    for (uint32_t i = 0; i < count_slots(x, seen); i++) {
        const uint64_t value = read_slot(x, seen, out, i);
        if (is_first || value != k->last[i])
            vec_push(&x->tapes, &k->to->change, ((FaultSlot){i, value}));
        k->last[i] = value;
    }
    vec_push(&x->tapes, &k->to->end, ((FaultStepEnd){k->to->write.n, k->to->change.n}));
}

static EngineStatus tape_init(Engine *e, uint32_t state, EngineStep *out)
{
    FaultTape *k = e->self;

    return k->inner->init(k->inner, state, out);
}

// Runs a step, and records it if a fault's record is open and not too large.
static EngineStatus tape_step(Engine *e, const EngineWrite *write, uint32_t n, EngineStep *out)
{
    FaultTape *k = e->self;
    const EngineStatus status = k->inner->step(k->inner, write, n, out);

    e->error = k->inner->error;
    if (k->to && status == ENGINE_OK && k->x->taped < VALUES_MOST) {
        const uint32_t before = k->to->write.n + k->to->change.n;
        record_step(k, write, n, out);
        k->x->taped += k->to->write.n + k->to->change.n - before;
    } else if (k->to)
        k->to->is_cut = true;
    return status;
}

static void tape_close(Engine *e) { (void)e; }

Engine *fault_tape_open(FaultRunner *x, Engine *inner, uint32_t script)
{
    FaultTape *k = ARENA_NEW(&x->run, FaultTape);

    *k = (FaultTape){{"tape", inner->program, NULL, k, tape_init, tape_step, tape_close, inner}, inner, x, NULL, NULL};
    k->last = ARENA_ARRAY(&x->run, uint64_t, count_slots(x, &x->seen[script]));
    x->w->tape = k;
    return &k->engine;
}

void fault_tape_reset(FaultRunner *x)
{
    arena_reset(&x->tapes);
    x->taped = 0;
    x->record = ARENA_ARRAY(&x->tapes, FaultRecord, x->single.n + 1);
}

void fault_tape_begin(FaultRunner *x, uint32_t single) { x->w->tape->to = &x->record[single]; }

// ---- replaying ----

bool fault_pair_repeats(FaultRunner *x, uint32_t single, const Fault *both)
{
    const FaultRecord *k = &x->record[single];
    const FaultSeen *seen = observed_in_script(x->w);
    Engine *e = x->w->tape->inner;
    EngineStep *out = &x->w->r->answer[0];
    uint64_t *expected = x->w->tape->last;
    uint32_t write = 0, change = 0;

    if (k->is_cut || k->end.n == 0)
        return false;
    fault_engine_begin(x->w->e, both, 2);
    for (uint32_t i = 0; i < k->end.n; i++) {
        if (e->step(e, k->write.at + write, k->end.at[i].write - write, out) != ENGINE_OK)
            return false;
        write = k->end.at[i].write;
        for (; change < k->end.at[i].change; change++)
            expected[k->change.at[change].slot] = k->change.at[change].value;
        for (uint32_t n = 0; n < count_slots(x, seen); n++)
            if (read_slot(x, seen, out, n) != expected[n])
                return false;
    }
    return true;
}
