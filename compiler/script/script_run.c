// SPDX-License-Identifier: Apache-2.0
// Runs a state script (language.md 8).  For each step:
// 1. The sections for the current state write their inputs and note their asserts.
// 2. Every engine runs the step.
// 3. The requirements are judged, and the noted asserts are evaluated.
// The script sees the values of the first engine.  The others must produce the same values, bit for bit.
#include "compiler/script/script_run.h"

#include <inttypes.h>
#include <string.h>

void run_finish(ScriptRun *r, ScriptOutcome outcome)
{
    r->result.outcome = outcome;
    r->ended = true;
}

bool script_has_stopped(const ScriptResult *r) { return r->outcome == SCRIPT_PASSED || (r->outcome == SCRIPT_FAILED && !r->failed); }

bool run_is_complete(const ScriptRun *r) { return script_has_stopped(&r->result) || r->result.outcome == SCRIPT_ENDLESS; }

// ---- before the step ----

// Sets a variable for this step: for the guards of the script, and for every engine.  No engine knows the script's own variables.
static void write_input(ScriptRun *r, const Var *v, uint64_t cell)
{
    EngineWrite w = {v->index, cell};

    r->cell[v->index] = cell;
    if (!v->of_script)
        vec_push(r->arena, &r->write, w);
}

// Sets S and T of a machine to their values in the step that it is about to run.
static void update_machine(ScriptRun *r, ScriptMachine *m, EngineNext next)
{
    m->state = r->p->state.at[next.state - 1];
    if (next.is_first)
        m->start = r->g, m->start_step = r->result.steps + 1;
    if (!m->is_due)
        return;
    r->cell[m->t->index] = r->g - m->start;
    r->cell[m->s->index] = next.state - m->first;
    r->active[r->actives++] = m->state;
}

// Sets G, and T and S of each machine that is due, to their values in the next step, because guards and inputs may read them.
static void update_time_and_state(ScriptRun *r)
{
    r->actives = 0;
    write_input(r, r->p->g, r->g);
    for (size_t i = 0; i < r->machines; i++) {
        ScriptMachine *m = &r->machine[i];
        m->is_due = m->wait == 0 && (!m->mode || r->cell[m->mode->index] == MODE_ENABLED);
        update_machine(r, m, engine_next(&r->answer[0], i));
    }
}

// Sets the parameters before the first step.  The caller's setting of a parameter replaces that of the script.
static void write_settings(ScriptRun *r)
{
    for (size_t i = 0; i < r->s->setting.n; i++)
        write_input(r, r->s->setting.at[i].parameter, r->s->setting.at[i].cell);
    for (size_t i = 0; i < r->o->settings; i++)
        write_input(r, r->o->setting[i].parameter, r->o->setting[i].cell);
}

static void write_recorded(void *context, const Var *v, double value) { write_input(context, v, ref_convert(v->type, value)); }

// Writes the recorded data of this step.
static void write_data(ScriptRun *r)
{
    if (r->replay && !replay_advance(r->replay, r->g, write_recorded, r))
        run_finish(r, SCRIPT_NO_DATA);
}

static void write_inputs_of_item(ScriptRun *r, const ScriptItem *item)
{
    for (size_t i = 0; i < item->inputs.n; i++) {
        const ScriptInput *in = &item->inputs.at[i];
        write_input(r, in->var, ref_convert(in->var->type, ref_eval(in->value, r->cell, &r->windows)));
    }
}

// Notes the asserts of an item and its @stop, to be evaluated after the step.
static void note_asserts(ScriptRun *r, const ScriptItem *item)
{
    size_t n = item->asserts.n + item->stop;

    for (size_t i = 0; i < n; i++) {
        NotedAssert note = {item, i};
        vec_push(r->arena, &r->noted, note);
    }
}

// Whether the guard of an item was true when this step evaluated it.  A guard that the step did not evaluate is false.
static bool is_taken(const ScriptRun *r, const ScriptItem *item) { return r->true_in[item->number] == r->result.steps + 1; }

// Whether the conditionals around an item lead to it in this step.
static bool is_reached(const ScriptRun *r, const ScriptItem *item)
{
    for (; item->parent; item = item->parent)
        if (!item->otherwise)
            return is_taken(r, item->parent);         // an item was reached if its parent was taken
        else if (is_taken(r, item->parent))
            return false;
    return true;
}

// Executes the items whose section and guard match: writes their inputs, and notes their asserts.
static void run_sections(ScriptRun *r)
{
    for (size_t i = 0; i < r->actives; i++) {
        r->ran[r->active[i]->number - 1] = r->result.steps + 1;
        r->ran_at[r->active[i]->number - 1] = r->g;
    }
    schedule_find_due(r->schedule, r->active, r->actives, r->cell, &r->due);
    for (size_t i = 0; i < r->due.n; i++) {
        const ScriptItem *item = r->due.at[i];
        if (is_reached(r, item) && ref_true(ref_eval(item->guard, r->cell, &r->windows))) {
            r->true_in[item->number] = r->result.steps + 1;
            write_inputs_of_item(r, item);
            note_asserts(r, item);
        }
    }
}

// ---- the step ----

Span run_start_of_script(const ScriptRun *r) { return (Span){r->s->src, 0, 0}; }

static void report_broken_engine(ScriptRun *r, const Engine *e, const char *why)
{
    r->result.difference = why;
    diag_report(r->diags, DIAG_engine_broken, run_start_of_script(r), e->name, why);
    run_finish(r, SCRIPT_BROKEN);
}

// Checks the results of all engines after init or a step: for errors, and for differences.
static void check_answers(ScriptRun *r)
{
    for (size_t i = 0; i < r->engines && !r->ended; i++) {
        const Engine *e = r->engine[i];
        const char *difference;

        if (r->answer[i].status == ENGINE_BROKEN) {
            report_broken_engine(r, e, e->error ? e->error : "no reason given");
        } else if (i > 0 && (difference = engine_compare(r->arena, r->engine[0], &r->answer[0], e, &r->answer[i])) != NULL) {
            r->result.difference = difference;
            diag_report(r->diags, DIAG_engines_differ, run_start_of_script(r),
                        format_in(r->arena, "%" PRIu64, r->result.steps), difference);
            run_finish(r, SCRIPT_DIFFERENT);
        }
    }
    if (!r->ended && r->answer[0].status == ENGINE_REFUSED)
        report_broken_engine(r, r->engine[0], "refused a step although G advanced");
    for (size_t i = 0; i < r->machines && !r->ended; i++)
        if (engine_next(&r->answer[0], i).state - 1 >= r->p->state.n)
            report_broken_engine(r, r->engine[0], "is in a state that the machine does not have");
}

// Starts all engines in the script's first state.
static void init_engines(ScriptRun *r)
{
    for (size_t i = 0; r->p->joint && i < r->engines; i++)
        engine_app_set_rows(r->engine[i], r->s->by_rows);
    for (size_t i = 0; i < r->engines; i++)
        r->answer[i].status = r->engine[i]->init(r->engine[i], r->s->init_state->number, &r->answer[i]);
    check_answers(r);
    memcpy(r->cell, r->answer[0].cell, r->p->var.n * sizeof *r->cell);
    if (r->p->joint)
        r->g = r->cell[r->p->g->index];               // [start] of an application can set G
    for (size_t i = 0; i < r->s->local.n; i++)
        r->cell[r->s->local.at[i]->index] = r->s->local.at[i]->init;
}

// In an application, sets the time at which the state of each machine that ran began: G minus T.
static void update_starts(ScriptRun *r)
{
    for (size_t i = 0; r->p->joint && i < r->machines; i++)
        if (engine_next(&r->answer[0], i).ran)
            r->machine[i].start = r->g - r->cell[r->machine[i].t->index];
}

// Runs one step on all engines and compares their results.
static void step_engines(ScriptRun *r)
{
    for (size_t i = 0; i < r->engines; i++)
        r->answer[i].status = r->engine[i]->step(r->engine[i], r->write.at, r->write.n, &r->answer[i]);
    r->result.steps++;
    check_answers(r);
    if (r->ended)
        return;
    memcpy(r->cell, r->answer[0].cell, r->p->var.n * sizeof *r->cell);
    update_starts(r);
}

static void call_after_step(ScriptRun *r)
{
    const ScriptStep step = {.number = r->result.steps, .g = r->g, .state = r->machine[0].state, .cell = r->cell,
                             .results = r->monitor ? r->monitor->result : NULL, .recorded = r->replay ? replay_recorded(r->replay) : NULL,
                             .states = r->p->joint ? r->states : NULL, .program = r->p};

    for (size_t i = 0; i < r->machines; i++)
        r->states[i] = r->machine[i].state;
    if (r->o->after_step)
        r->o->after_step(r->o->context, &step);
}

// Compares the elements with the recording after a step.
static void compare_with_data(ScriptRun *r)
{
    if (r->replay && !replay_compare(r->replay, r->g, r->cell))
        run_finish(r, SCRIPT_NO_DATA);
}

// Adds n ticks of an application to the time at which G is *g and *rest nanoseconds have passed since. Returns false if G would reach 2^64-1.
static bool add_ticks(const Joint *j, uint64_t n, uint64_t *g, uint64_t *rest)
{
    const uint64_t period = n * j->tick, part = *rest + period % j->unit;         // no overflow, because a period is at most an hour
    const uint64_t units = period / j->unit + part / j->unit;

    if (*g >= UINT64_MAX - units)
        return false;
    *g += units;
    *rest = part % j->unit;
    return true;
}

uint64_t run_next_g(const ScriptRun *r, uint32_t machine)
{
    uint64_t g = r->g, rest = r->rest;

    if (r->s->by_rows)                                // each row is a tick; for a machine of an application this is the earliest possible time
        return replay_find_next_time(r->replay, &g) ? g : UINT64_MAX;
    if (r->p->joint)
        return add_ticks(r->p->joint, machine ? r->machine[machine - 1].every : 1, &g, &rest) ? g : UINT64_MAX;
    return r->g < UINT64_MAX - r->s->delta_t ? r->g + r->s->delta_t : UINT64_MAX;
}

// Sets how many ticks each machine waits, counted from the next tick, in which G is `next`.
static void advance_waits(ScriptRun *r, uint64_t next)
{
    const Joint *j = r->p->joint;

    for (size_t i = 0; i < r->machines; i++) {
        ScriptMachine *m = &r->machine[i];
        if (j && r->s->by_rows)
            m->wait = joint_periods_until(j, m->every, next) == joint_periods_until(j, m->every, r->g);
        else
            m->wait = m->wait ? m->wait - 1 : m->every - 1;
    }
}

// Moves to the time of the next step; ends the run if no step follows.
static void advance_time(ScriptRun *r)
{
    const uint64_t next = run_next_g(r, 0);

    advance_waits(r, next);

    r->result.data_ended = next == UINT64_MAX && r->s->by_rows;
    if (next == UINT64_MAX)
        run_finish(r, r->result.data_ended ? SCRIPT_NO_DATA : SCRIPT_TIME_OVERFLOW);
    else if (r->p->joint && !r->s->by_rows)
        add_ticks(r->p->joint, 1, &r->g, &r->rest);
    else
        r->g = next;
}

// Runs one step of the script: inputs, the machine, asserts, requirements.
static void run_step(ScriptRun *r)
{
    bool is_new;

    // With faulty sensors, r->cell still has the readings, which the asserts of the last step judged.  Guards and inputs of the script see the
    // true values.
    if (r->answer[0].outside)
        memcpy(r->cell, r->answer[0].outside, r->p->var.n * sizeof *r->cell);
    r->write.n = 0;
    r->noted.n = 0;
    r->random.step = r->result.steps + 1;
    update_time_and_state(r);
    if (r->result.steps == 0)
        write_settings(r);
    write_data(r);
    if (r->ended)
        return;
    ref_windows_sample(&r->windows, r->cell);
    run_sections(r);
    step_engines(r);
    if (r->ended)
        return;
    is_new = r->monitor && requirement_check_step(r);
    compare_with_data(r);
    if (r->ended)
        return;
    call_after_step(r);
    if (is_new)
        requirement_report_new_violations(r);
    if (is_new && r->o->ends_at_violation)
        run_finish(r, SCRIPT_FAILED);
    else
        assert_check_step(r);
    if (!r->ended && r->o->is_cancelled && r->o->is_cancelled(r->o->context))
        run_finish(r, SCRIPT_CANCELLED);
    if (!r->ended)
        advance_time(r);
}

// ---- the run ----

// How many items and asserts a script has, to allocate arrays.
typedef struct ScriptTotals { size_t items, asserts; } ScriptTotals;

static ScriptTotals count_script_items(const Script *s)
{
    ScriptTotals t = {0, 0};

    for (size_t i = 0; i < s->section.n; i++)
        for (size_t j = 0; j < s->section.at[i].item.n; j++) {
            t.items++;
            t.asserts += s->section.at[i].item.at[j]->asserts.n;
        }
    return t;
}

static void allocate_machines(ScriptRun *r)
{
    r->machines = engine_machines(r->p);
    r->machine = ARENA_ARRAY(r->arena, ScriptMachine, r->machines);
    r->active = ARENA_ARRAY(r->arena, const State *, r->machines);
    r->states = ARENA_ARRAY(r->arena, const State *, r->machines);
    r->machine[0] = (ScriptMachine){.s = r->p->s, .t = r->p->t, .every = 1};
    for (size_t i = 0; r->p->joint && i < r->machines; i++) {
        const Member *m = &r->p->joint->member.at[i];
        r->machine[i] = (ScriptMachine){.s = m->s, .t = m->t, .mode = m->mode, .every = m->every, .first = m->first};
    }
}

static void allocate_run(ScriptRun *r)
{
    ScriptTotals t = count_script_items(r->s);

    r->answer = ARENA_ARRAY(r->arena, EngineStep, r->engines);
    for (size_t i = 0; i < r->engines; i++)
        engine_step_init(&r->answer[i], r->arena, r->p);
    r->cell = ARENA_ARRAY(r->arena, uint64_t, r->p->var.n + r->s->local.n);
    ref_windows_init(&r->windows, r->arena, &r->s->window);
    ref_random_init(&r->random, r->arena, &r->s->random, r->result.seed);
    r->windows.random = &r->random;
    r->evaluated = ARENA_ARRAY(r->arena, uint64_t, t.asserts);
    r->failed_asserts = arena_alloc(r->arena, t.asserts);
    r->is_pending = arena_alloc(r->arena, t.asserts);
    buf_init(&r->printed, r->arena);
    r->true_in = ARENA_ARRAY(r->arena, uint64_t, t.items);
    r->ran = ARENA_ARRAY(r->arena, uint64_t, r->p->state.n);
    r->ran_at = ARENA_ARRAY(r->arena, uint64_t, r->p->state.n);
    allocate_machines(r);
}

const char *run_state_text(const ScriptRun *r)
{
    const char *text = "";

    for (size_t i = 0; i < r->machines; i++)
        text = format_in(r->arena, "%s%s%s", text, i ? ", " : "", r->machine[i].state->name->text);
    return text;
}

uint64_t run_last_of_section(const ScriptRun *r, const ScriptSection *section)
{
    return section->state ? r->ran[section->state->number - 1] : 1;
}

// Returns the first item with a @stop; NULL only in a script with errors.
const ScriptItem *script_first_stop(const Script *s)
{
    for (size_t i = 0; i < s->section.n; i++)
        for (size_t j = 0; j < s->section.at[i].item.n; j++)
            if (s->section.at[i].item.at[j]->stop)
                return s->section.at[i].item.at[j];
    return NULL;
}

static void report_endless_script(ScriptRun *r)
{
    const ScriptItem *stop = script_first_stop(r->s);
    Diag *d = diag_report(r->diags, DIAG_script_endless, stop ? script_stop_span(stop) : run_start_of_script(r),
                          format_in(r->arena, "%" PRIu64, r->o->max_steps));

    script_note_include(r->diags, r->s, d);
    history_add(r, d);
}

static void report_time_overflow(ScriptRun *r)
{
    Diag *d = diag_report(r->diags, DIAG_script_time_over, r->s->delta_t_span, format_in(r->arena, "%" PRIu64, r->result.steps));

    script_note_include(r->diags, r->s, d);
    history_add(r, d);
}

// Opens the recorded data.  If it cannot be read, no step runs.
static void open_data(ScriptRun *r)
{
    if (r->s->data && !r->ended && (r->replay = replay_open(r->arena, r->diags, r->s)) == NULL)
        run_finish(r, SCRIPT_NO_DATA);
}

// Closes the recorded data.  A @compare that was not met makes the run fail.
static void close_data(ScriptRun *r)
{
    if (!r->replay)
        return;
    replay_close(r->replay);
    replay_set_result(r->replay, &r->result);
    if (r->result.outcome == SCRIPT_PASSED && replay_differs(r->replay))
        r->result.outcome = SCRIPT_FAILED;
}

void run_begin(ScriptRun *r)
{
    r->result.is_random = r->s->random.n > 0;
    r->result.seed = r->o->seed ? *r->o->seed : r->s->seed;
    allocate_run(r);
    r->result.cell = r->cell;
    r->result.evaluated = r->evaluated;
    r->result.failed_asserts = r->failed_asserts;
    r->result.undecided = r->is_pending;
    if (r->o->requirements)
        requirement_begin_run(r);
    init_engines(r);
    open_data(r);
    r->schedule = schedule_new(r->arena, r->s, r->cell);
}

void run_continue(ScriptRun *r, uint64_t steps)
{
    while (!r->ended && r->result.steps < steps)
        run_step(r);
}

void run_end(ScriptRun *r)
{
    if (!r->ended)
        run_finish(r, SCRIPT_ENDLESS);
    close_data(r);
    r->result.printed = assert_finish_printing(r);
    r->result.is_violated = r->violated != NULL;
    if (r->result.outcome == SCRIPT_PASSED && r->violated && !r->o->continues)
        r->result.outcome = SCRIPT_FAILED;
    if (r->monitor)
        requirement_end_run(r);
}

void run_to_the_end(ScriptRun *r)
{
    run_begin(r);
    run_continue(r, r->o->max_steps);
    run_end(r);
}

// Reports that the data ended before a @stop.  An error in reading the data has been reported already.
static void report_data_ended(ScriptRun *r)
{
    Diag *d;

    if (!r->result.data_ended)
        return;
    d = diag_report(r->diags, DIAG_data_ended, r->s->delta_t_span, format_in(r->arena, "%" PRIu64, r->g));
    script_note_include(r->diags, r->s, d);
    history_add(r, d);
}

// Runs the engines in lock step on one script.
ScriptResult script_run(Arena *arena, Diags *diags, const Script *s, Engine **engine, size_t engines, const ScriptOptions *o)
{
    ScriptRun r = {.arena = arena, .diags = diags, .s = s, .p = s->program, .engine = engine, .engines = engines, .o = o};

    run_to_the_end(&r);
    if (o->is_silent)
        return r.result;
    requirement_report_repetitions(&r);
    switch (r.result.outcome) {
    case SCRIPT_FAILED:
        if (r.result.failed)
            assert_report_failure(&r);
        break;
    case SCRIPT_NO_DATA: report_data_ended(&r); break;
    case SCRIPT_ENDLESS: report_endless_script(&r); break;
    case SCRIPT_TIME_OVERFLOW: report_time_overflow(&r); break;
    case SCRIPT_PASSED: case SCRIPT_BROKEN: case SCRIPT_DIFFERENT: break;
    case SCRIPT_CANCELLED: return r.result;
    }
    assert_report_unevaluated(&r);
    requirement_report_undecided(&r);
    if (r.replay)
        replay_report(r.replay, r.result.outcome != SCRIPT_BROKEN && r.result.outcome != SCRIPT_DIFFERENT && r.result.outcome != SCRIPT_NO_DATA,
                      &r.result);
    return r.result;
}
