// SPDX-License-Identifier: Apache-2.0
// Writes a scenario as a state script.  Its inputs become items by time; the asserts come from a run of the scenario.
//
// 1. A value that the machine never stores is set once, `at` its time.  The machine could replace any other, so that is set in every step.
// 2. A copy reads its source as it is when the step begins, so copies of inputs come before the items that set inputs (language.md 8.16).
// 3. The run is divided at each change of the state or of an output.  Outputs that change often are asserted only at the end.
#include "compiler/search/script_writer.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compiler/script/script.h"
#include "compiler/search/search.h"
#include "stdlib/convert.h"

enum {
    LINE_MOST = 100,          // columns of a comment
    TERMS_MOST = 70,          // columns of the condition of an assert
    SPANS_MOST = 10,          // lines of the time line
    CHANGES_MOST = 6,         // an output that changes more often is asserted only at the end
    REPEATED_MOST = 4         // with more outputs, a line of the time line has only those that have changed
};

typedef enum Rank { RANK_EARLY, RANK_INPUT, RANK_ASSERT, RANK_STOP } Rank;

// An item of the script: its guard, and a line of text for each item of its body.  A guard that begins with # is a comment without a body.
typedef struct TimelineItem {
    uint64_t step;            // the first step in which the guard can be true
    Rank rank;                // order among the items of one step
    const char *guard;
    VEC(const char *) body;
    bool is_block;            // the body is written in braces, even if it is one line
    uint32_t number;          // order in which items were added: the last key of the sort
} TimelineItem;

typedef struct Writer {
    Arena *arena;
    const ScriptPage *page;
    const Program *p;
    const Scenario *s;
    VEC(TimelineItem) item;
    VEC(const Var *) output;  // the outputs of the time line
    VEC(const Var *) busy;    // outputs that are asserted only at the end
    const char **phase;       // by loop: the name of the time since the current round began
} Writer;

// ---- values ----

// Returns the double with the fewest decimal digits that is stored as `cell`.
static double shortest_double(SmType type, uint64_t cell, double x)
{
    char digits[40];

    for (int precision = 1; precision < 17; precision++) {
        double y;
        snprintf(digits, sizeof digits, "%.*g", precision, x);
        y = strtod(digits, NULL);
        if (sm_cell_from_f64(type, y) == cell)
            return y;
    }
    return x;
}

void script_write_value(Buf *out, SmType type, double x)
{
    const uint64_t cell = sm_cell_from_f64(type, x);
    const double stored = sm_cell_to_f64(type, cell);

    if (type == SM_BOOL)
        buf_str(out, cell ? "true" : "false");
    else if (stored - stored != 0 && type == SM_F32)
        buf_str(out, stored < 0 ? "-1e39" : "1e39");            // beyond the range of F32: it becomes infinite when it is stored
    else if (stored - stored != 0)
        buf_str(out, stored < 0 ? "-1e308 * 10" : "1e308 * 10");
    else if (type == SM_F32)
        format_number_shortest(out, shortest_double(type, cell, stored));
    else
        format_number_shortest(out, stored);
}

void script_write_time(Buf *out, TimeUnit unit, uint64_t g)
{
    static const struct { TimeUnit from; uint64_t least, whole; TimeUnit unit; double factor; } row[] = {
        {TIME_US, 1000000, 10000, TIME_S, 1e6}, {TIME_US, 1000, 10, TIME_MS, 1e3}, {TIME_MS, 1000, 10, TIME_S, 1e3}};

    for (size_t i = 0; i < sizeof row / sizeof *row; i++)
        if (row[i].from == unit && g >= row[i].least && g % row[i].whole == 0 && g < UINT64_C(1) << 52) {
            format_number_shortest(out, (double)g / row[i].factor);
            buf_printf(out, " %s", time_unit_name(row[i].unit));
            return;
        }
    buf_printf(out, "%llu", (unsigned long long)g);
    if (g > 0)
        buf_printf(out, " %s", time_unit_name(unit));
}

static const char *value_text(const Writer *w, SmType type, double x)
{
    Buf out;

    buf_init(&out, w->arena);
    script_write_value(&out, type, x);
    return buf_text(&out);
}

static const char *time_text(const Writer *w, uint64_t step)
{
    Buf out;

    buf_init(&out, w->arena);
    script_write_time(&out, w->p->time_unit, (step - 1) * w->s->delta_t);
    return buf_text(&out);
}

// ---- items ----

// Returns the guard that is true in the steps from `from` up to `to`, which is not included; to 0: up to the end.
static const char *guard_of(const Writer *w, uint64_t from, uint64_t to)
{
    if (to == from + 1 || (to == 0 && from == w->s->steps))
        return format_in(w->arena, "at %s", time_text(w, from));
    if (to == 0)
        return from == 1 ? "true" : format_in(w->arena, "after %s", time_text(w, from));
    return format_in(w->arena, "from %s to %s", time_text(w, from), time_text(w, to));
}

// Adds a line of the script for this step; items are later sorted by step and rank.
static TimelineItem *add_item(Writer *w, uint64_t step, Rank rank, const char *guard)
{
    const TimelineItem item = {.step = step, .rank = rank, .guard = guard, .number = w->item.n};

    vec_push(w->arena, &w->item, item);
    return &w->item.at[w->item.n - 1];
}

// Adds a line to the item with this guard.  The order of early items matters, so each is one line.
static void add_line(Writer *w, uint64_t step, Rank rank, const char *guard, const char *line)
{
    TimelineItem *item = NULL;

    for (uint32_t i = 0; i < w->item.n; i++)
        if (rank != RANK_EARLY && w->item.at[i].rank == rank && w->item.at[i].step == step && strcmp(w->item.at[i].guard, guard) == 0)
            item = &w->item.at[i];
    if (!item)
        item = add_item(w, step, rank, guard);
    vec_push(w->arena, &item->body, line);
}

// ---- inputs ----

// Returns the step of the next change of the same variable; 0: there is none.
static uint64_t step_of_next_change(const Writer *w, const ScenarioChange *c)
{
    for (const ScenarioChange *n = c + 1; n < w->s->change + w->s->changes; n++)
        if (n->var == c->var)
            return n->step;
    return 0;
}

// Whether the scenario changes this variable.
static bool is_input_changed(const Writer *w, uint32_t var)
{
    for (size_t i = 0; i < w->s->changes; i++)
        if (w->s->change[i].var == var)
            return true;
    return false;
}

// Sets a value that alternates with another one.  `every` counts from G = 0, so the two change places if the change is in an even step.
static void add_alternation(Writer *w, const ScenarioChange *c, uint64_t to)
{
    const Var *v = w->p->var.at[c->var];
    const bool is_even = c->step % 2 == 0;
    const char *every = format_in(w->arena, "every %s", time_text(w, 3));
    const char *first = format_in(w->arena, "%s = %s", v->name->text, value_text(w, v->type, is_even ? c->b : c->a));
    const char *other = format_in(w->arena, "%s = %s", v->name->text, value_text(w, v->type, is_even ? c->a : c->b));

    if (c->step == 1 && to == 0) {
        TimelineItem *item = add_item(w, 1, RANK_INPUT, every);
        vec_push(w->arena, &item->body, first);
        item = add_item(w, 1, RANK_INPUT, "else");
        vec_push(w->arena, &item->body, other);
    } else {
        TimelineItem *item = add_item(w, c->step, RANK_INPUT, guard_of(w, c->step, to));
        vec_push(w->arena, &item->body, format_in(w->arena, "%s: %s", every, first));
        vec_push(w->arena, &item->body, format_in(w->arena, "else:%*s%s", (int)strlen(every) - 3, "", other));
    }
}

// Returns the assignment, as text, with the value that the change has in its first step.
static const char *first_assignment(const Writer *w, const ScenarioChange *c)
{
    const Var *v = w->p->var.at[c->var];

    return format_in(w->arena, "%s = %s", v->name->text, value_text(w, v->type, sm_cell_to_f64(v->type, scenario_cell(w->p, c, c->step, NULL))));
}

// Whether adding b in each step stores the same cells as the value of the ramp does (scenario_cell).
static bool can_add(const Writer *w, const ScenarioChange *c, uint64_t end)
{
    const SmType type = w->p->var.at[c->var]->type;
    uint64_t cell = scenario_cell(w->p, c, c->step, NULL);

    if (w->p->var.at[c->var]->written)
        return false;
    for (uint64_t step = c->step + 1; step < end; step++) {
        cell = sm_cell_from_f64(type, sm_cell_to_f64(type, cell) + c->b);
        if (cell != scenario_cell(w->p, c, step, NULL))
            return false;
    }
    return true;
}

// Adds the lines that change an input by the same amount in each step, up to step `to`.
static void add_ramp(Writer *w, const ScenarioChange *c, uint64_t to)
{
    const Var *v = w->p->var.at[c->var];
    const char *name = v->name->text, *by = value_text(w, SM_F64, c->b < 0 ? -c->b : c->b), *sign = c->b < 0 ? "-" : "+";
    const uint64_t end = to ? to : w->s->steps + 1;

    if (!can_add(w, c, end)) {
        add_line(w, c->step, RANK_INPUT, guard_of(w, c->step, to),
                 format_in(w->arena, "%s = %s %s %s * ((%s - %llu) / %llu)", name, value_text(w, SM_F64, c->a), sign, by, w->p->g->name->text,
                           (unsigned long long)((c->step - 1) * w->s->delta_t), (unsigned long long)w->s->delta_t));
        return;
    }
    add_line(w, c->step, RANK_INPUT, guard_of(w, c->step, c->step + 1), first_assignment(w, c));
    if (end > c->step + 1)
        add_line(w, c->step + 1, RANK_INPUT, guard_of(w, c->step + 1, to), format_in(w->arena, "%s = %s %s %s", name, name, sign, by));
}

// Adds the lines for one change of an input, which lasts until the next change of that input.
static void add_change(Writer *w, const ScenarioChange *c)
{
    const Var *v = w->p->var.at[c->var];
    const uint64_t to = step_of_next_change(w, c);
    const bool is_single = to == c->step + 1 || (to == 0 && c->step == w->s->steps);

    if (c->kind == SCENARIO_COPY)
        add_line(w, c->step, is_input_changed(w, c->source) ? RANK_EARLY : RANK_INPUT, guard_of(w, c->step, to),
                 format_in(w->arena, "%s = %s", v->name->text, w->p->var.at[c->source]->name->text));
    else if (c->kind == SCENARIO_HOLD || is_single)
        add_line(w, c->step, RANK_INPUT, guard_of(w, c->step, v->written ? to : c->step + 1), first_assignment(w, c));
    else if (c->kind == SCENARIO_ALTERNATE)
        add_alternation(w, c, to);
    else
        add_ramp(w, c, to);
}

// ---- loops ----

static bool is_name_used(const Program *p, const char *name)
{
    for (uint32_t i = 0; i < p->var.n; i++)
        if (strcmp(p->var.at[i]->name->text, name) == 0)
            return true;
    for (uint32_t i = 0; i < p->state.n; i++)
        if (strcmp(p->state.at[i]->name->text, name) == 0)
            return true;
    return false;
}

// Names the time since the round of each loop began.
static void name_phases(Writer *w)
{
    uint32_t number = 0;

    w->phase = arena_array(w->arena, w->s->loops + 1, sizeof *w->phase);
    for (size_t i = 0; i < w->s->loops; i++)
        do {
            number++;
            w->phase[i] = number == 1 ? "phase" : format_in(w->arena, "phase%u", number);
        } while (is_name_used(w->p, w->phase[i]));
}

// Returns how many changes a loop repeats, and sets *i to the index of the first of them.
static size_t find_changes(const Scenario *s, const ScenarioLoop *l, size_t *i)
{
    size_t n = 0;

    for (*i = 0; *i < s->changes && s->change[*i].step < l->from; ++*i) { }
    while (*i + n < s->changes && s->change[*i + n].step < l->from + l->period)
        n++;
    return n;
}

// Adds a loop: an item for its whole time, with a line for each change of a round.
static bool add_loop(Writer *w, const ScenarioLoop *l, const char *phase)
{
    size_t from, width = 0, n = find_changes(w->s, l, &from);
    const char **guard = arena_array(w->arena, n + 1, sizeof *guard);
    TimelineItem *item;

    for (size_t i = 0; i < n; i++) {
        const ScenarioChange *c = &w->s->change[from + i];
        if (c->kind != SCENARIO_HOLD || w->p->var.at[c->var]->written || w->p->var.at[c->var]->parameter)
            return false;
        guard[i] = format_in(w->arena, "%s == %s:", phase, time_text(w, c->step - l->from + 1));
        width = strlen(guard[i]) > width ? strlen(guard[i]) : width;
    }
    item = add_item(w, l->from, RANK_INPUT, guard_of(w, l->from, l->to > w->s->steps ? 0 : l->to));
    item->is_block = true;
    for (size_t i = 0; i < n; i++)
        vec_push(w->arena, &item->body, format_in(w->arena, "%s%*s %s", guard[i], (int)(width - strlen(guard[i])), "",
                                                  first_assignment(w, &w->s->change[from + i])));
    return true;
}

static bool add_loops(Writer *w)
{
    size_t from;

    name_phases(w);
    for (size_t i = 0; i < w->s->loops; i++)
        if (find_changes(w->s, &w->s->loop[i], &from) > 0 && !add_loop(w, &w->s->loop[i], w->phase[i]))
            return false;
    return true;
}

// Defines the time since the current round of each loop began.
static void write_phases(const Writer *w, Buf *out)
{
    const char *g = w->p->g->name->text;
    bool is_first = true;
    size_t at;

    for (size_t i = 0; i < w->s->loops; i++) {
        const unsigned long long period = w->s->loop[i].period * w->s->delta_t, from = (w->s->loop[i].from - 1) * w->s->delta_t;
        if (find_changes(w->s, &w->s->loop[i], &at) == 0)
            continue;
        buf_printf(out, is_first ? "\n[define]\n%s = " : "%s = ", w->phase[i]);
        is_first = false;
        if (from)
            buf_printf(out, "%s - %llu - %llu * floor((%s - %llu) / %llu)", g, from, period, g, from, period);
        else
            buf_printf(out, "%s - %llu * floor(%s / %llu)", g, period, g, period);
        buf_str(out, "    # since a round began: it is repeated every ");
        script_write_time(out, w->p->time_unit, period);
        buf_str(out, "\n");
    }
}

// ---- all inputs ----

// Adds the copies (an input gets the value of another) in an order in which each runs before the copies that change what it reads.  Returns false if
// there is no such order, because they form a circle.
static bool add_early_copies(Writer *w)
{
    bool *is_done = arena_array(w->arena, w->s->changes + 1, sizeof *is_done);

    for (size_t left = w->s->changes, before = left + 1; left > 0 && left < before; ) {
        before = left;
        left = 0;
        for (size_t i = w->s->changes; i-- > 0; ) {           // an item runs before those that change what it reads
            const ScenarioChange *c = &w->s->change[i];
            bool waits = false;
            if (is_done[i] || c->kind != SCENARIO_COPY || !is_input_changed(w, c->source))
                continue;
            for (size_t k = 0; k < w->s->changes; k++) {
                const ScenarioChange *o = &w->s->change[k];
                waits = waits || (!is_done[k] && k != i && o->kind == SCENARIO_COPY && o->source == c->var && o->var != c->var);
            }
            is_done[i] = !waits;
            left += waits;
            if (!waits)
                add_change(w, c);
        }
        if (left == before)
            return false;
    }
    return true;
}

static bool add_inputs(Writer *w)
{
    for (size_t i = 0; i < w->s->changes; i++) {
        const ScenarioChange *c = &w->s->change[i];
        const Var *source = w->p->var.at[c->source];
        if (c->kind == SCENARIO_COPY && (source == w->p->g || source == w->p->s || source == w->p->t))
            return false;
        if (w->p->var.at[c->var]->parameter && (c->step > 1 || c->kind != SCENARIO_HOLD || step_of_next_change(w, c)))
            return false;
    }
    if (!add_early_copies(w) || !add_loops(w))
        return false;
    for (size_t i = 0; i < w->s->changes; i++) {
        const ScenarioChange *c = &w->s->change[i];
        if (scenario_loop_at(w->s, c->step))
            continue;
        if ((c->kind != SCENARIO_COPY || !is_input_changed(w, c->source)) && !w->p->var.at[c->var]->parameter)
            add_change(w, c);
    }
    return true;
}

// ---- the run ----

// A part of the run without a change of the state, or of an output of the time line.
typedef struct Part {
    uint64_t step;            // its first step
    uint32_t *state;          // State.number; of an application, that of each machine's state in the joined Program
    uint64_t *cell;           // by output of the time line
} Part;

typedef struct RunRecord {
    const Writer *w;
    Part *part;               // a ring of SPANS_MOST + 1
    uint64_t parts;           // how many the run had; the last ones are in the ring
    uint64_t *changes;        // by Var.index: how often the output has changed in the run
    uint64_t *last;           // by Var.index: cells after the last step
} RunRecord;

// Returns the number of the state of machine i after a step.
static uint32_t state_after(const Program *p, const EngineStep *result, size_t i)
{
    return (uint32_t)(p->joint ? p->joint->member.at[i].first + result->cell[p->joint->member.at[i].s->index] : result->cell[p->s->index]);
}

static Part *part_at(const RunRecord *r, uint64_t i) { return &r->part[i % (SPANS_MOST + 1)]; }

// Called after each step of the scenario's run: begins a new part of the record where the state or a quiet output changes.
static void record_step(void *context, uint64_t step, const EngineStep *result)
{
    RunRecord *r = context;
    const Writer *w = r->w;
    const size_t machines = engine_machines(w->p);
    const Part *now = part_at(r, r->parts - 1);
    bool differs = step == 1;

    for (size_t i = 0; i < machines && !differs; i++)
        differs = state_after(w->p, result, i) != now->state[i];
    for (uint32_t i = 0; i < w->p->var.n; i++)
        r->changes[i] += step > 1 && result->cell[i] != r->last[i];
    for (uint32_t i = 0; i < w->output.n && !differs; i++)
        differs = result->cell[w->output.at[i]->index] != now->cell[i];
    memcpy(r->last, result->cell, w->p->var.n * sizeof *r->last);
    if (differs) {
        Part *part = part_at(r, r->parts++);
        part->step = step;
        for (size_t i = 0; i < machines; i++)
            part->state[i] = state_after(w->p, result, i);
        for (uint32_t i = 0; i < w->output.n; i++)
            part->cell[i] = result->cell[w->output.at[i]->index];
    }
}

// Runs the scenario.  Returns false if the engine refuses a step.
static bool record_run(Writer *w, RunRecord *r)
{
    *r = (RunRecord){.w = w, .part = arena_array(w->arena, SPANS_MOST + 1, sizeof *r->part),
                     .changes = arena_array(w->arena, w->p->var.n, sizeof *r->changes),
                     .last = arena_array(w->arena, w->p->var.n, sizeof *r->last)};
    for (uint32_t i = 0; i <= SPANS_MOST; i++) {
        r->part[i].cell = arena_array(w->arena, w->output.n + 1, sizeof *r->part[i].cell);
        r->part[i].state = arena_array(w->arena, engine_machines(w->p), sizeof *r->part[i].state);
    }
    return scenario_run(w->arena, w->p, w->s, w->page->engine, record_step, r) == ENGINE_OK;
}

// Moves the output with the most changes to those that are asserted only at the end.
static void drop_busiest(Writer *w, const RunRecord *r)
{
    uint32_t most = 0;

    for (uint32_t i = 1; i < w->output.n; i++)
        if (r->changes[w->output.at[i]->index] >= r->changes[w->output.at[most]->index])
            most = i;
    vec_push(w->arena, &w->busy, w->output.at[most]);
    memmove(&w->output.at[most], &w->output.at[most + 1], (w->output.n - most - 1) * sizeof *w->output.at);
    w->output.n--;
}

static uint64_t most_changes(const Writer *w, const RunRecord *r)
{
    uint64_t most = 0;

    for (uint32_t i = 0; i < w->output.n; i++)
        if (r->changes[w->output.at[i]->index] > most)
            most = r->changes[w->output.at[i]->index];
    return most;
}

// Whether the machine, or some machine of the application, writes the element.  A machine's S is no output.
static bool is_output(const Program *p, const Var *v)
{
    return v->kind == VAR_ELEMENT && !v->state_of && program_uses_of(p, v).written;
}

// Selects the outputs of the time line, and records the run.
static bool record_time_line(Writer *w, RunRecord *r)
{
    for (uint32_t i = 0; i < w->p->var.n; i++)
        if (is_output(w->p, w->p->var.at[i]))
            vec_push(w->arena, &w->output, w->p->var.at[i]);
    if (!record_run(w, r))
        return false;
    while (w->output.n && most_changes(w, r) > CHANGES_MOST)
        drop_busiest(w, r);
    while (record_run(w, r) && r->parts > SPANS_MOST && w->output.n)
        drop_busiest(w, r);
    return true;
}

// ---- asserts ----

// Returns a condition that is true of the value of a cell: the value itself, or of a long fraction the bounds of its first six digits.
static const char *term_of(const Writer *w, const Var *v, uint64_t cell)
{
    const double x = sm_cell_to_f64(v->type, cell);
    char digits[40];
    double rounded, part = 1e-290;
    const double size = x < 0 ? -x : x;
    const char *name = v->name->text;

    if (v->type == SM_BOOL)
        return format_in(w->arena, "%s%s", cell ? "" : "not ", name);
    if (x - x != 0)
        return format_in(w->arena, x < 0 ? "%s < -1e38" : "%s > 1e38", name);
    snprintf(digits, sizeof digits, "%.6g", x);
    rounded = strtod(digits, NULL);
    if (rounded == x || sm_type_info[v->type].kind != SM_KIND_FLOAT || size > 1e290 || size < 1e-280)
        return format_in(w->arena, "%s == %s", name, value_text(w, SM_F64, x));
    while (part * 1e6 < size)
        part *= 10;                                             // `part` becomes the power of ten that is one to ten units of the sixth digit
    snprintf(digits, sizeof digits, "%.6g", x - part);
    rounded = strtod(digits, NULL);
    snprintf(digits, sizeof digits, "%.6g", x + part);
    return format_in(w->arena, "%s < %s < %s", value_text(w, SM_F64, rounded), name, value_text(w, SM_F64, strtod(digits, NULL)));
}

// Adds terms joined by `and`, in as many asserts as lines of a usual length need.
static void add_asserts(Writer *w, uint64_t step, const char *guard, const char *const *term, uint32_t terms)
{
    Buf out;

    buf_init(&out, w->arena);
    for (uint32_t i = 0; i < terms; i++) {
        if (out.n && out.n + strlen(term[i]) > TERMS_MOST) {
            add_line(w, step, RANK_ASSERT, guard, format_in(w->arena, "@assert %s", buf_text(&out)));
            out.n = 0;
        }
        buf_printf(&out, "%s%s", out.n ? " and " : "", term[i]);
    }
    if (out.n)
        add_line(w, step, RANK_ASSERT, guard, format_in(w->arena, "@assert %s", buf_text(&out)));
}

// Adds an assert of the state and outputs for one part of the run, in which they do not change.
static void add_part(Writer *w, const RunRecord *r, uint64_t i, uint64_t first)
{
    const Part *part = part_at(r, i), *before = i > first ? part_at(r, i - 1) : NULL;
    const uint64_t to = i + 1 < r->parts ? part_at(r, i + 1)->step : 0;
    const char *guard = guard_of(w, part->step, to);
    const size_t machines = engine_machines(w->p);
    VEC(const char *) term = {NULL, 0, 0};
    Buf states;

    buf_init(&states, w->arena);
    for (size_t m = 0; m < machines; m++)
        buf_printf(&states, "%s%s", m ? ", " : "", w->p->state.at[part->state[m] - 1]->name->text);
    if (w->page->is_skeleton) {
        add_item(w, part->step, RANK_ASSERT,
                 format_in(w->arena, "# %s, in %s: what must be true?", strcmp(guard, "true") == 0 ? "always" : guard, buf_text(&states)));
        return;
    }
    for (size_t m = 0; m < machines; m++)
        if (machines <= REPEATED_MOST || !before || part->state[m] != before->state[m])
            vec_push(w->arena, &term, format_in(w->arena, "state %s", w->p->state.at[part->state[m] - 1]->name->text));
    for (uint32_t k = 0; k < w->output.n; k++)
        if (w->output.n <= REPEATED_MOST || !before || part->cell[k] != before->cell[k])
            vec_push(w->arena, &term, term_of(w, w->output.at[k], part->cell[k]));
    add_asserts(w, part->step, guard, term.at, term.n);
}

// Adds an assert at the last step, of the outputs that change too often to be asserted in each part.
static void add_end(Writer *w, const RunRecord *r)
{
    const char *guard = guard_of(w, w->s->steps, w->s->steps + 1);
    VEC(const char *) term = {NULL, 0, 0};

    for (uint32_t k = 0; k < w->busy.n; k++)
        vec_push(w->arena, &term, term_of(w, w->busy.at[k], r->last[w->busy.at[k]->index]));
    if (!w->page->is_skeleton)
        add_asserts(w, w->s->steps, guard, term.at, term.n);
    if (w->page->not_entered)
        add_line(w, w->s->steps, RANK_ASSERT, guard, format_in(w->arena, "@assert not state %s", w->page->not_entered->name->text));
    add_line(w, w->s->steps, RANK_STOP, guard, "@stop");
}

// Runs the scenario and adds the asserts of what the machine does.
static bool add_run(Writer *w)
{
    RunRecord r;
    uint64_t first;

    if (!record_time_line(w, &r))
        return false;
    first = r.parts > SPANS_MOST ? r.parts - SPANS_MOST : 0;
    for (uint64_t i = first; i < r.parts; i++)
        add_part(w, &r, i, first);
    add_end(w, &r);
    return true;
}

// ---- text ----

// Appends a sentence as comment lines; an empty one is an empty comment.
static void write_comment(const char *text, Buf *out)
{
    if (!*text)
        buf_str(out, "#\n");
    while (*text) {
        size_t n = strlen(text), most = LINE_MOST - 2;
        if (n > most) {
            for (n = most; n > 0 && text[n] != ' '; n--)
                ;
            n = n ? n : strcspn(text, " ");
        }
        buf_printf(out, "# %.*s\n", (int)n, text);
        text += n + (text[n] == ' ');
    }
}

static void write_options(const Writer *w, Buf *out)
{
    if (w->p->joint)                  // the .app has the time between ticks, and the first states
        return;
    buf_str(out, "\n[options]\ndelta_t    ");
    script_write_time(out, w->p->time_unit, w->s->delta_t);
    buf_printf(out, "\ninit_state %s\n", w->s->init_state->name->text);
    for (size_t i = 0; i < w->s->changes; i++) {
        const Var *v = w->p->var.at[w->s->change[i].var];
        if (v->parameter)
            buf_printf(out, "set        %s %s\n", v->name->text, value_text(w, v->type, w->s->change[i].a));
    }
}

static int compare_items(const void *a, const void *b)
{
    const TimelineItem *x = a, *y = b;

    if ((x->rank == RANK_EARLY) != (y->rank == RANK_EARLY))
        return x->rank == RANK_EARLY ? -1 : 1;
    if (x->step != y->step && x->rank != RANK_EARLY)
        return x->step < y->step ? -1 : 1;
    if (x->rank != y->rank)
        return x->rank < y->rank ? -1 : 1;
    return x->number < y->number ? -1 : 1;
}

static bool is_line(const TimelineItem *i) { return i->body.n == 1 && !i->is_block; }

static void write_item(const TimelineItem *item, size_t width, Buf *out)
{
    if (item->body.n == 0) {
        buf_printf(out, "%s\n", item->guard);
    } else if (is_line(item)) {
        const size_t n = strlen(item->guard) + 1;
        buf_printf(out, "%s:", item->guard);
        buf_spaces(out, n < width ? width - n : 0);
        buf_printf(out, " %s\n", item->body.at[0]);
    } else {
        buf_printf(out, "%s {\n", item->guard);
        for (uint32_t i = 0; i < item->body.n; i++)
            buf_printf(out, "    %s\n", item->body.at[i]);
        buf_str(out, "}\n");
    }
}

static void write_items(Writer *w, Buf *out)
{
    size_t width = 0;

    qsort(w->item.at, w->item.n, sizeof *w->item.at, compare_items);
    for (uint32_t i = 0; i < w->item.n; i++)
        if (is_line(&w->item.at[i]) && strlen(w->item.at[i].guard) + 1 > width)
            width = strlen(w->item.at[i].guard) + 1;
    buf_str(out, "\n[all_states]\n");
    for (uint32_t i = 0; i < w->item.n; i++)
        write_item(&w->item.at[i], width, out);
}

bool script_write(Arena *arena, const ScriptPage *page, Buf *out)
{
    Writer w = {.arena = arena, .page = page, .p = page->p, .s = page->scenario};
    const Scenario unrolled = scenario_unroll(arena, page->scenario);
    bool can_write = add_inputs(&w);

    if (!can_write && page->scenario->loops) {        // a loop has a change, such as a ramp, that a script cannot repeat: write out all rounds
        w = (Writer){.arena = arena, .page = page, .p = page->p, .s = &unrolled};
        can_write = add_inputs(&w);
    }
    if (!can_write || !add_run(&w))
        return false;
    for (size_t i = 0; i < page->comments; i++)
        write_comment(page->comment[i], out);
    write_options(&w, out);
    write_phases(&w, out);
    write_items(&w, out);
    return true;
}
