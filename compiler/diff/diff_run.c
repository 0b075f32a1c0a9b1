// SPDX-License-Identifier: Apache-2.0
// Runs a script on both machines and finds the first step after which they differ in the state that ran or in an element.  The first run is
// recorded as the changes from step to step, and the second one is compared with it.
#include <inttypes.h>

#include "compiler/cover/cover.h"
#include "compiler/diff/diff_part.h"
#include "stdlib/convert.h"

typedef struct RecordedChange { uint64_t step; uint32_t var; uint64_t cell; } RecordedChange;
typedef struct RecordedStep { uint64_t step, g; uint32_t state; } RecordedStep;

typedef struct DiffRecording {
    ProgramDiff *d;
    DiffRun *run;
    uint64_t *now;                // by variable of the old machine: the value after the last step
    VEC(RecordedChange) change;
    VEC(RecordedStep) state;      // each step that ran another state than the step before
    uint64_t steps;
    size_t next_change, next_state;           // indexes into `change` and `state`: what the comparison reads next
    uint32_t at_state;            // number of the state that the old machine ran in the compared step
    bool is_over;                 // a difference has been found
} DiffRecording;

// Called after each step of the old machine: records the variables that changed.
static void record_step(void *context, const ScriptStep *s)
{
    DiffRecording *r = context;

    for (uint32_t i = 0; i < r->d->old.p->var.n; i++)
        if (s->number == 1 || s->cell[i] != r->now[i]) {
            r->now[i] = s->cell[i];
            vec_push(r->d->arena, &r->change, ((RecordedChange){s->number, i, s->cell[i]}));
        }
    if (s->number == 1 || r->state.at[r->state.n - 1].state != s->state->number)
        vec_push(r->d->arena, &r->state, ((RecordedStep){s->number, s->g, s->state->number}));
    r->steps = s->number;
}

static const char *cell_text(Arena *arena, SmType type, uint64_t cell)
{
    Buf out;

    buf_init(&out, arena);
    format_cell_shortest(&out, type, cell);
    return buf_text(&out);
}

// Whether two values are equal for code that reads them: every NaN reads as 0, and every byte of a bool but 0 as 1.
static bool same_cell(const Var *a, uint64_t x, const Var *b, uint64_t y)
{
    const double p = sm_cell_to_f64(a->type, x), q = sm_cell_to_f64(b->type, y);

    return a->type == b->type ? x == y : p == q;
}

// Called after each step of the new machine: compares it with the recorded step of the old one, and records the first difference in r->run.
static void compare_step(void *context, const ScriptStep *s)
{
    DiffRecording *r = context;
    const ProgramDiff *d = r->d;
    const Program *p = d->old.p, *q = d->new.p;
    DiffRun *run = r->run;
    bool other_state;

    if (r->is_over || s->number > r->steps)
        return;
    for (; r->next_change < r->change.n && r->change.at[r->next_change].step <= s->number; r->next_change++)
        r->now[r->change.at[r->next_change].var] = r->change.at[r->next_change].cell;
    for (; r->next_state < r->state.n && r->state.at[r->next_state].step <= s->number; r->next_state++)
        r->at_state = r->state.at[r->next_state].state;
    other_state = d->state_of[r->at_state] != s->state->number;
    for (uint32_t i = 0; i < p->var.n; i++) {
        const Var *a = p->var.at[i], *b = d->var_of[i];
        if (a->kind != VAR_ELEMENT || !b || a == p->g || a == p->s || same_cell(a, r->now[i], b, s->cell[b->index]))
            continue;
        if (run->values < DIFF_VALUES_MAX)
            run->value[run->values++] = (DiffValue){b->name->text, cell_text(d->arena, a->type, r->now[i]),
                                                    cell_text(d->arena, b->type, s->cell[b->index])};
    }
    run->steps = s->number;
    if (!other_state && run->values == 0)
        return;
    r->is_over = true;
    run->same = false;
    run->step = s->number;
    run->g = s->g;
    run->old_state = p->state.at[r->at_state - 1]->name->text;
    run->new_state = q->state.at[s->state->number - 1]->name->text;
}

static const char *result_text(Arena *arena, const ScriptResult *r)
{
    static const char *const outcome[] = {"passed", "failed", "did not stop", "ran out of time", "has no data", "was cancelled", "broke down",
                                          "differed"};

    return format_in(arena, "%s after %" PRIu64 " step%s", outcome[r->outcome], r->steps, r->steps == 1 ? "" : "s");
}

// Runs a script on a machine and calls `after` after each step. Drops the diagnostics.
static ScriptResult run_one_script(DiffRecording *r, const Program *p, const Script *s, uint64_t max_steps, void (*after)(void *, const ScriptStep *))
{
    const ScriptOptions o = {.max_steps = max_steps, .after_step = after, .context = r, .is_silent = true, .is_compared = true};
    Arena *arena = r->d->arena;
    Engine *e = engine_flat_open(arena, p, flat_new(arena, ir_build(arena, p), NULL));
    Diags unused;

    diags_init(&unused, arena);
    unused.muted = true;
    return script_run(arena, &unused, s, &e, 1, &o);
}

// Runs a script on both machines and adds where they first differ. A script is NULL if it has errors for that machine.
void diff_run_script(ProgramDiff *d, const char *name, const Script *old, const Script *new, uint64_t max_steps)
{
    DiffRun run = {.script = name, .same = true};
    DiffRecording r = {.d = d, .run = &run};
    ScriptResult a, b;

    if (!old || !new) {
        run.problem = !old && !new ? "it has errors for both machines" : old
            ? "it has errors for the new machine" : "it has errors for the old machine";
        vec_push(d->arena, &d->run, run);
        return;
    }
    r.now = ARENA_ARRAY(d->arena, uint64_t, d->old.p->var.n + 1u);
    a = run_one_script(&r, old->program, old, max_steps, record_step);
    b = run_one_script(&r, new->program, new, max_steps, compare_step);
    run.old_result = result_text(d->arena, &a);
    run.new_result = result_text(d->arena, &b);
    run.same = run.same && a.outcome == b.outcome && a.steps == b.steps;
    vec_push(d->arena, &d->run, run);
}
