// SPDX-License-Identifier: Apache-2.0
#include "compiler/cover/mutant_runs.h"

#include <stdlib.h>
#include <string.h>

#include "compiler/cover/cover.h"
#include "compiler/script/script_run.h"
#include "stdlib/convert.h"

enum {
    POINTS_MOST = 128,        // the most points (saved states) of a run
    POINT_STEPS = 8,          // the fewest steps between two points
    VALUES_MOST = 1 << 23     // the most values that all records together can have; a run that would exceed it is not recorded
};

// The state of an unchanged run before a step.
typedef struct RecordPoint {
    void *machine;            // the state of MutantRuns.original
    RunPoint *script;
} RecordPoint;

// The record of a script's run with the unchanged machine, from which runs of mutants start.
typedef struct Record {
    const Script *script;
    uint64_t steps;
    ScriptOptions options;    // the options with which the script runs on mutants
    bool is_complete;         // the whole run was recorded
    uint64_t every;           // steps between two points
    VEC(RecordPoint) point;
    VEC(EngineWrite) write;   // what the script wrote in all steps
    VEC(uint32_t) write_end;  // by step, from 0: index in `write` after the last write of the step
    VEC(uint8_t *) executed;  // by point, then by Stmt.number: 1 if the statement was executed between this point and the next one
    uint8_t *reached;         // by Stmt.number: 1 if the run executed the statement
    const uint32_t *seen;     // the variables that the script reads (Var.index), `seens` of them, without constants
    uint32_t seens;
    bool reads_constants;     // the script reads constants of the machine
    VEC(uint64_t) value;      // for each step 2 + seens values: next_state and next_is_first of EngineStep, and the cells of `seen`
    ScriptRun run;            // the run of the script, to be continued from its points
    uint32_t noticed;         // number of mutants that the script has noticed
    bool is_left_out;         // the script fails on the unchanged machine
} Record;

typedef VEC(ScenarioChange) InputChanges;

struct MutantRuns {
    Arena *arena;
    const Program *p;
    Record *record;
    uint32_t records;
    uint32_t *order;          // indices of the scripts in the order in which they are tried
    FlatMachine *original;
    void *state, *at_point;   // the states of the current mutant: now, and at the last point
    size_t values;            // number of values in all records
    Cover *cover;             // counts what the unchanged runs execute
    Engine *engine;           // runs the current mutant
    Engine *whole;            // `engine`, or that of the application which contains it
    Diags muted;
    const Requirements *requirements; // judged in every run; or NULL
    const Requirement *violated;      // the requirement that the last run violated; NULL: none
    Baseline baseline;        // the runs on the unchanged machine
};

// ---- what a script and the requirements read ----

// Sets r->seen to the variables of the machine that the script or a requirement reads.
static void list_seen(Arena *arena, const Program *p, const Requirements *rq, const uint32_t *var_of, Record *r)
{
    const Script *s = r->script;
    bool *seen = arena_alloc(arena, p->var.n + s->local.n);
    uint32_t *list = ARENA_ARRAY(arena, uint32_t, p->var.n);

    script_mark_reads(s, seen);
    if (rq)
        requirements_mark_reads(rq, seen);
    for (uint32_t v = 0; v < p->var.n; v++)
        if (seen[v] && var_of[v] != IR_NONE)
            list[r->seens++] = v;
        else
            r->reads_constants = r->reads_constants || seen[v];
    r->seen = list;
}

// ---- recording ----

// An engine that records the writes and the results of each step, which `machine` runs.
typedef struct Recorder {
    Engine engine;
    Engine *machine;
    Arena *arena;
    Record *record;
} Recorder;

static EngineStatus recorder_init(Engine *e, uint32_t state, EngineStep *out)
{
    Recorder *c = e->self;

    return c->machine->init(c->machine, state, out);
}

// Runs a step and records the writes of the script and what the step has stored.
static EngineStatus recorder_step(Engine *e, const EngineWrite *write, uint32_t n, EngineStep *out)
{
    Recorder *c = e->self;
    Record *r = c->record;
    const EngineStatus status = c->machine->step(c->machine, write, n, out);

    for (uint32_t i = 0; i < n; i++)
        vec_push(c->arena, &r->write, write[i]);
    vec_push(c->arena, &r->write_end, r->write.n);
    vec_push(c->arena, &r->value, out->next_state);
    vec_push(c->arena, &r->value, out->next_is_first);
    for (uint32_t i = 0; i < r->seens; i++)
        vec_push(c->arena, &r->value, out->cell[r->seen[i]]);
    return status;
}

// Adds a point at the current step of the run.
static void add_point(MutantRuns *u, Record *r)
{
    const RecordPoint p = {arena_copy(u->arena, engine_flat_run(u->engine), u->original->size), run_save_point(&r->run, u->arena)};

    vec_push(u->arena, &r->point, p);
}

// Returns an array by Stmt.number: 1 if the statement was executed since the last call.
static uint8_t *collect_executed(MutantRuns *u)
{
    const Cover *c = u->cover;
    uint8_t *executed = arena_alloc(u->arena, u->p->stmts + 1);

    for (uint32_t s = 1; s <= u->p->stmts; s++)
        executed[s] = c->hits[c->probes.stmt[s]] > 0;
    memset(c->hits, 0, c->probes.counters * sizeof *c->hits);
    return executed;
}

// Begins the run of the script on an engine; r->run can then be continued.
static void begin_run(MutantRuns *u, Record *r, Engine **engine)
{
    r->run = (ScriptRun){.arena = u->arena, .diags = &u->muted, .s = r->script, .p = u->p, .engine = engine, .engines = 1, .o = &r->options};
    run_begin(&r->run);
}

// Runs the script again, and records it.
static void record_run(MutantRuns *u, Record *r)
{
    Recorder recorder = {.machine = u->engine, .arena = u->arena, .record = r};
    Engine *engine = &recorder.engine;

    recorder.engine = *u->engine;
    recorder.engine.self = &recorder;
    recorder.engine.init = recorder_init;
    recorder.engine.step = recorder_step;
    r->every = r->steps / POINTS_MOST + 1 > POINT_STEPS ? r->steps / POINTS_MOST + 1 : POINT_STEPS;
    engine_flat_set(u->engine, u->cover->flat, engine_flat_run(u->engine));
    begin_run(u, r, &engine);
    while (!r->run.ended && u->values + r->write.n + r->value.n < VALUES_MOST) {
        add_point(u, r);
        run_continue(&r->run, r->run.result.steps + r->every);
        vec_push(u->arena, &r->executed, collect_executed(u));
    }
    r->is_complete = r->run.ended;
    u->values += r->write.n + r->value.n;
    r->run.engine = arena_copy(u->arena, &u->engine, sizeof u->engine);
}

// Returns the requirement that has ended a run.
static const Requirement *find_violated(const MutantRuns *u, const ScriptResult *result)
{
    size_t i = 0;

    while (result->requirement[i].violations == 0)
        i++;
    return &u->requirements->at.at[i];
}

// Runs the script once from its start to its end, without using records.  Returns whether it passes.
static bool run_whole(MutantRuns *u, Record *r, Arena *work)
{
    ScriptResult result = script_run(work, &u->muted, r->script, &u->whole, 1, &r->options);

    u->violated = result.is_violated ? find_violated(u, &result) : NULL;
    return result.outcome == SCRIPT_PASSED;
}

// Runs one script on the original machine.  Returns whether it counts.
static bool run_original(MutantRuns *u, Record *r)
{
    ScriptResult result;
    bool counts;
    Arena work;

    arena_init_within(&work, u->arena);
    result = script_run(&work, &u->muted, r->script, &u->whole, 1, &r->options);
    r->steps = result.steps;
    counts = baseline_add(&u->baseline, r->script->src->name, r->script, &result);
    arena_free(&work);
    return counts;
}

// Runs one script on the original machine and records the run, to be replayed on each mutant.
static void add_record(MutantRuns *u, uint32_t script, uint64_t max_steps)
{
    Record *r = &u->record[script];
    bool counts;

    r->options = (ScriptOptions){.max_steps = max_steps, .is_silent = true, .is_compared = true, .requirements = u->requirements};
    engine_flat_set(u->engine, u->cover->flat, engine_flat_run(u->engine));
    counts = run_original(u, r);
    r->is_left_out = !counts;
    r->options.ends_at_violation = true;
    r->options.ignored = u->baseline.run.at[script].ignored;
    r->reached = collect_executed(u);
    if (u->whole == u->engine)
        list_seen(u->arena, u->p, u->requirements, u->original->m->var_of, r);
    if (u->whole == u->engine && counts && run_has_points(r->script))
        record_run(u, r);
    r->options.max_steps = r->steps < UINT64_MAX / 8 ? 4 * r->steps + 1000 : r->steps;
}

MutantRuns *mutant_runs_new(Arena *arena, const Program *p, size_t member, const Script *const *script, uint32_t scripts, const Requirements *rq,
                            uint64_t max_steps)
{
    MutantRuns *u = ARENA_NEW(arena, MutantRuns);

    u->arena = arena;
    u->p = engine_program(p, member);
    u->requirements = rq;
    u->records = scripts;
    baseline_init(&u->baseline, arena, rq);
    u->record = arena_array(arena, scripts, sizeof *u->record);
    u->order = ARENA_ARRAY(arena, uint32_t, scripts);
    u->original = flat_new(arena, ir_build(arena, u->p), NULL);
    u->state = arena_alloc(arena, u->original->size);
    u->at_point = arena_alloc(arena, u->original->size);
    u->cover = cover_new(arena, u->p);
    u->engine = cover_open_engine(u->cover);
    u->whole = p->joint ? engine_flat_open_machines(arena, p, flat_new_machines(arena, p), u->engine, member) : u->engine;
    diags_init(&u->muted, arena);
    u->muted.muted = true;
    for (uint32_t i = 0; i < scripts; i++) {
        u->record[i].script = script[i];
        u->order[i] = i;
        add_record(u, i, max_steps);
    }
    return u;
}

const Baseline *mutant_runs_baseline(const MutantRuns *u) { return &u->baseline; }

FlatMachine *mutant_runs_original(const MutantRuns *u) { return u->original; }

// Adds the inputs that a step writes, if they change.  cell: by Var.index, what was written last; is_set: whether anything was.
static void add_changes(const MutantRuns *u, Arena *arena, InputChanges *list, uint64_t step, const EngineWrite *write, uint32_t n, uint64_t *cell,
                        bool *is_set)
{
    for (uint32_t i = 0; i < n; i++) {
        const Var *v = u->p->var.at[write[i].var];
        const ScenarioChange change = {step, v->index, SCENARIO_HOLD, sm_cell_to_f64(v->type, write[i].cell), 0, 0};
        if (v == u->p->g || v == u->p->s || v->written || v->parameter || (is_set[v->index] && cell[v->index] == write[i].cell))
            continue;
        is_set[v->index] = true;
        cell[v->index] = write[i].cell;
        vec_push(arena, list, change);
    }
}

const Scenario *mutant_runs_scenario(const MutantRuns *u, Arena *arena, uint32_t script)
{
    const Record *r = &u->record[script];
    Scenario *s = ARENA_NEW(arena, Scenario);
    uint64_t *cell = ARENA_ARRAY(arena, uint64_t, u->p->var.n);
    bool *is_set = arena_alloc(arena, u->p->var.n);
    InputChanges list = {0};

    if (!r->is_complete)
        return NULL;
    for (uint64_t k = 0; k < r->steps; k++) {
        const uint32_t first = k ? r->write_end.at[k - 1] : 0;
        add_changes(u, arena, &list, k + 1, r->write.at + first, r->write_end.at[k] - first, cell, is_set);
    }
    *s = (Scenario){.init_state = r->script->init_state, .delta_t = r->script->delta_t, .steps = r->steps, .change = list.at, .changes = list.n};
    return s;
}

// ---- running mutants ----

// A mutant that runs with the recorded inputs of a script, and is compared with the recorded run.
typedef struct MutantReplay {
    MutantRuns *u;
    Record *r;
    FlatMachine *mutant;
    bool same_layout;         // the states of both machines have the same parts at the same offsets
    bool same_start;          // no initial value was changed
    const uint32_t *stmt;     // the changed statements, as in mutant_runs_find_noticing
    uint32_t stmts;
} MutantReplay;

// Whether a part of the run executes a changed statement.  executed: by Stmt.number, 1 if that part executes the statement.
static bool includes_change(const MutantReplay *c, const uint8_t *executed)
{
    for (uint32_t i = 0; i < c->stmts; i++)
        if (c->stmt[i] == MUTANT_EACH_STEP || c->stmt[i] == MUTANT_START || executed[c->stmt[i]])
            return true;
    return false;
}

// Returns the first point, from `point` on, after which the run executes a changed statement; the number of points if no later part does.
static uint32_t find_executed(const MutantReplay *c, uint32_t point)
{
    while (point < c->r->point.n && !includes_change(c, c->r->executed.at[point]))
        point++;
    return point;
}

// Writes the script's values to the variables of a machine's snapshot.
static void write_cells(const FlatMachine *f, void *state, const EngineWrite *write, uint32_t n)
{
    uint64_t *cell = flat_cells(f, state);

    for (uint32_t i = 0; i < n; i++)
        if (f->m->var_of[write[i].var] != IR_NONE)
            cell[f->m->var_of[write[i].var]] = write[i].cell;
}

// Whether a variable that the script reads has another value than in the recorded step.
static bool has_other_cells(const MutantReplay *c, const uint64_t *recorded)
{
    const uint64_t *cell = flat_cells(c->mutant, c->u->state);
    const uint32_t *var_of = c->mutant->m->var_of;

    for (uint32_t i = 0; i < c->r->seens; i++)
        if (cell[var_of[c->r->seen[i]]] != recorded[i])
            return true;
    return false;
}

// Runs the mutant from a point to the next one.  Returns whether the script sees a difference to the recorded run.
static bool run_to_next_point(MutantReplay *c, uint32_t point)
{
    const Record *r = c->r;
    const FlatState *s = c->u->state;
    const uint64_t from = point * r->every, to = from + r->every < r->steps ? from + r->every : r->steps;

    for (uint64_t k = from; k < to; k++) {
        const uint32_t first = k ? r->write_end.at[k - 1] : 0;
        const uint64_t *recorded = r->value.at + k * (2 + r->seens);
        write_cells(c->mutant, c->u->state, r->write.at + first, r->write_end.at[k] - first);
        flat_step(c->mutant, c->u->state);
        if (s->state != recorded[0] || s->first != recorded[1] || has_other_cells(c, recorded + 2))
            return true;
    }
    return false;
}

static void go_to_point(MutantReplay *c, uint32_t point) { memcpy(c->u->state, c->r->point.at[point].machine, c->u->original->size); }

// Whether the script can see an initial value that was changed, before the first step.
static bool reads_initial_value(const MutantReplay *c)
{
    const uint64_t *cell = flat_cells(c->mutant, c->u->state), *original = flat_cells(c->u->original, c->r->point.at[0].machine);
    const uint32_t *var_of = c->mutant->m->var_of;

    flat_start(c->mutant, c->u->state, c->r->script->init_state->number);
    for (uint32_t i = 0; i < c->r->seens; i++)
        if (cell[var_of[c->r->seen[i]]] != original[var_of[c->r->seen[i]]])
            return true;
    return c->r->reads_constants;
}

// Whether the recorded run can be used for this mutant, instead of a run of the script.
static bool can_replay(MutantReplay *c) { return c->r->is_complete && c->same_layout && (c->same_start || !reads_initial_value(c)); }

// Returns the index of the last point before the script reads a value that differs from the recorded one; the number of points: none differs.
static uint32_t find_difference(MutantReplay *c)
{
    const size_t size = c->u->original->size;
    uint32_t point = find_executed(c, 0);

    if (point == c->r->point.n)
        return point;
    go_to_point(c, point);
    if (!c->same_start)
        flat_start(c->mutant, c->u->state, c->r->script->init_state->number);
    for (;;) {
        memcpy(c->u->at_point, c->u->state, size);
        if (run_to_next_point(c, point))
            return point;
        if (++point == c->r->point.n)
            return point;
        if (memcmp(c->u->state, c->r->point.at[point].machine, size) != 0)
            continue;
        point = find_executed(c, point);
        if (point == c->r->point.n)
            return point;
        go_to_point(c, point);
    }
}

// Runs the script on the mutant from a point on.  Returns whether it passes.
static bool passes_from_point(MutantReplay *c, uint32_t point)
{
    ScriptRun *run = &c->r->run;

    run_restore_point(run, c->r->point.at[point].script);
    memcpy(c->u->state, c->u->at_point, c->u->original->size);
    engine_flat_set(c->u->engine, c->mutant, c->u->state);
    run_continue(run, c->r->options.max_steps);
    c->u->violated = run->violated;
    return run->ended && run->result.outcome == SCRIPT_PASSED;
}

// Runs the script on the mutant.  Returns whether it passes.
static bool passes_script(MutantReplay *c, Arena *work)
{
    uint32_t point;

    if (c->r->is_left_out || !includes_change(c, c->r->reached))
        return true;
    if (can_replay(c)) {
        point = find_difference(c);
        return point == c->r->point.n || passes_from_point(c, point);
    }
    engine_flat_set(c->u->engine, c->mutant, arena_alloc(work, c->mutant->size));
    return run_whole(c->u, c->r, work);
}

// Whether script x is tried before y: it notices more, or it is shorter.
static bool is_before(const MutantRuns *u, uint32_t x, uint32_t y)
{
    const Record *a = &u->record[x], *b = &u->record[y];

    return a->noticed != b->noticed ? a->noticed > b->noticed : a->steps < b->steps;
}

// Moves the script at `i` in the order towards the start, before scripts that have noticed fewer mutants.
static void move_up(MutantRuns *u, uint32_t i)
{
    for (; i > 0 && is_before(u, u->order[i], u->order[i - 1]); i--) {
        const uint32_t other = u->order[i - 1];
        u->order[i - 1] = u->order[i];
        u->order[i] = other;
    }
}

uint32_t mutant_runs_find_noticing(MutantRuns *u, Arena *work, FlatMachine *mutant, const uint32_t *stmt, uint32_t n, const Requirement **violated)
{
    MutantReplay c = {u, NULL, mutant, flat_have_same_layout(u->p, u->original, mutant), true, stmt, n};

    *violated = NULL;
    for (uint32_t i = 0; i < n; i++)
        c.same_start = c.same_start && stmt[i] != MUTANT_START;
    for (uint32_t i = 0; i < u->records; i++) {
        const uint32_t script = u->order[i];
        c.r = &u->record[script];
        if (passes_script(&c, work))
            continue;
        *violated = u->violated;
        c.r->noticed++;
        move_up(u, i);
        return script;
    }
    return u->records;
}
