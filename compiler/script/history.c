// SPDX-License-Identifier: Apache-2.0
// The history of a failed run: the last steps with the relevant values, and the last transitions with their source lines.  A run
// does not record its history.  A script that failed runs again on the reference interpreter, which knows the statement of each
// transition.  Scripts that pass therefore have no extra cost.
#include "compiler/script/script_run.h"

#include <inttypes.h>
#include <string.h>

enum {
    STEPS = 5, TRANSITIONS = 3, STOPS = 3,        // the most steps, transitions and @stops that are shown
    COLUMNS = 6, COLUMN_WIDTH = 40,               // the most columns of values; the most bytes of source of a column's expression
    WORK_MOST = 1000000000                        // the most samples of windows that the second run may read: a few seconds of work
};

// A step that is shown.
typedef struct PastStep {
    uint64_t number, g;
    const char *state;                // name of the state; for an application, the states of all machines as text
    const char *value[COLUMNS];       // by column: the value as text
} PastStep;

typedef struct PastTransition {
    uint64_t step, g;
    const State *from;
    const Stmt *stmt;
} PastTransition;

typedef struct History {
    ScriptRun *failed;
    ScriptRun run;                    // the second run of the same script
    const Expr *column[COLUMNS];
    size_t columns;
    PastStep step[STEPS];             // the last steps, the oldest first
    size_t steps;
    PastTransition transition[TRANSITIONS];
    size_t transitions;               // number of entries of `transition`, the oldest first
    Watch **watch;                    // by machine: what it did in the second run; NULL: machines are not watched
} History;

static const char *count_text(Arena *arena, uint64_t n) { return format_in(arena, "%" PRIu64, n); }

// ---- columns of the table ----

// Adds a column for each variable, except constants, and each rolling statistic that an expression reads.
static void add_columns(History *h, const Expr *e)
{
    const bool is_value = e->kind == EX_ROLL || (e->kind == EX_VAR && !e->var->is_constant && e->var != h->failed->p->g);   // G has its own column

    if (is_value && h->columns < COLUMNS && run_can_show(h->column, h->columns, e, COLUMN_WIDTH))
        h->column[h->columns++] = e;
    for (uint32_t i = 0; i < e->n && e->kind != EX_ROLL; i++)
        add_columns(h, e->arg[i]);
}

// ---- the second run ----

// Records the transition that a machine took in a step; NULL: none.
static void record_transition(History *h, const ScriptStep *step, const State *from, const Stmt *transition)
{
    if (!transition)
        return;
    if (h->transitions == TRANSITIONS)
        memmove(h->transition, h->transition + 1, --h->transitions * sizeof *h->transition);
    h->transition[h->transitions++] = (PastTransition){step->number, step->g, from, transition};
}

// Called after each step of the second run: records the step if it is one of the last, and the transition that it took.
static void record_after_step(void *context, const ScriptStep *step)
{
    History *h = context;
    ScriptRun *r = &h->run;

    if (step->number + STEPS > h->failed->result.steps) {
        PastStep *s = &h->step[h->steps++];
        *s = (PastStep){step->number, step->g, run_state_text(r), {NULL}};
        for (size_t i = 0; i < h->columns; i++) {
            Buf text;
            buf_init(&text, r->arena);
            run_append_value(r, h->column[i], h->failed->reports_violation ? &r->monitor->windows : &r->windows, &text);
            s->value[i] = buf_text(&text);
        }
    }
    for (size_t i = 0; i < r->machines; i++)
        if (engine_next(&r->answer[0], i).ran)
            record_transition(h, step, r->machine[i].state, engine_ref_transition(engine_app_machine(r->engine[0], i)));
}

// Whether a second run would take too long.  The reference interpreter reads every sample of every rolling window in each step.
static bool is_replay_too_slow(const ScriptRun *r)
{
    uint64_t work = 1;

    for (size_t m = 0; m < r->machines; m++) {
        const Windows *w = r->p->joint ? &r->p->joint->member.at[m].program->window : &r->p->window;
        for (size_t i = 0; i < w->n; i++)
            work += w->at[i].size;
    }
    for (size_t i = 0; i < r->s->window.n; i++)
        work += r->s->window.at[i].size;
    for (size_t i = 0; r->o->requirements && i < r->o->requirements->window.n; i++)
        work += r->o->requirements->window.at[i].size;
    return r->result.steps > WORK_MOST / work;
}

// Runs the script again.  Returns whether its final values equal those of the failed run.
static bool replay_run(History *h)
{
    const ScriptRun *failed = h->failed;
    const ScriptOptions o = {.max_steps = failed->result.steps, .seed = &failed->result.seed, .after_step = record_after_step, .context = h,
                             .is_compared = true, .is_silent = true, .setting = failed->o->setting, .settings = failed->o->settings,
                             .requirements = failed->o->requirements};
    Engine *ref = engine_ref_open(failed->arena, failed->p);
    Diags silent;

    diags_init(&silent, failed->arena);
    silent.muted = true;
    h->run = (ScriptRun){.arena = failed->arena, .diags = &silent, .s = failed->s, .p = failed->p, .engine = &ref, .engines = 1, .o = &o};
    h->watch = why_short_watch(failed, ref, &h->run.result.steps);
    run_to_the_end(&h->run);
    return h->run.result.steps == failed->result.steps && memcmp(h->run.cell, failed->cell, failed->p->var.n * sizeof *failed->cell) == 0;
}

// ---- notes of the diagnostic ----

static size_t max_size(size_t a, size_t b) { return a > b ? a : b; }

// Removes the spaces at the end of a row.
static void trim_row(Buf *out)
{
    while (out->n && out->at[out->n - 1] == ' ')
        out->at[--out->n] = '\0';
}

static void append_right_aligned(Buf *out, const char *text, size_t width)
{
    buf_spaces(out, width > strlen(text) ? width - strlen(text) : 0);
    buf_str(out, text);
}

static size_t column_width(const History *h, size_t column)
{
    size_t width = h->column[column]->span.len;

    for (size_t i = 0; i < h->steps; i++)
        width = max_size(width, strlen(h->step[i].value[column]));
    return width;
}

// Adds a note with a table of the last steps.
static void add_step_table(History *h, Diag *d)
{
    Arena *arena = h->failed->arena;
    size_t steps = 4, gs = 1, states = 5;
    Buf table;

    if (h->steps == 0)
        return;
    buf_init(&table, arena);
    for (size_t i = 0; i < h->steps; i++) {
        steps = max_size(steps, strlen(count_text(arena, h->step[i].number)));
        gs = max_size(gs, strlen(count_text(arena, h->step[i].g)));
        states = max_size(states, strlen(h->step[i].state));
    }
    buf_char(&table, '\n');
    append_right_aligned(&table, "step", steps);
    append_right_aligned(&table, "G", gs + 2);
    buf_printf(&table, "  %-*s", (int)states, "state");
    for (size_t i = 0; i < h->columns; i++) {
        const Span s = h->column[i]->span;
        buf_spaces(&table, 2 + column_width(h, i) - s.len);
        buf_put(&table, s.src->text + s.at, s.len);
    }
    for (size_t i = 0; i < h->steps; i++) {
        trim_row(&table);
        buf_char(&table, '\n');
        append_right_aligned(&table, count_text(arena, h->step[i].number), steps);
        append_right_aligned(&table, count_text(arena, h->step[i].g), gs + 2);
        buf_printf(&table, "  %-*s", (int)states, h->step[i].state);
        for (size_t c = 0; c < h->columns; c++)
            append_right_aligned(&table, h->step[i].value[c], column_width(h, c) + 2);
    }
    trim_row(&table);
    diag_note(h->failed->diags, d, (Span){0}, h->steps == 1 ? DIAG_note_only_step : DIAG_note_last_steps, buf_text(&table));
}

// Adds a note for each of the last transitions.
static void add_transition_notes(History *h, Diag *d)
{
    const ScriptRun *r = h->failed;

    for (size_t i = 0; i < h->transitions; i++) {
        const PastTransition *t = &h->transition[i];
        diag_note(r->diags, d, t->stmt->span, DIAG_note_transition_made, count_text(r->arena, t->step), count_text(r->arena, t->g),
                  t->from->name->text, t->stmt->target->name->text);
    }
    if (h->transitions == 0 && r->failed)
        diag_note(r->diags, d, (Span){0}, DIAG_note_no_transition, run_state_text(r));
}

// Adds a note with the current state of a machine and the step in which it was entered, for a run that did not stop.
static void add_state_note(const ScriptRun *r, size_t machine, Diag *d)
{
    const EngineNext next = engine_next(&r->answer[0], machine);
    const bool is_new = next.is_first;
    const uint64_t step = is_new ? r->result.steps + 1 : r->machine[machine].start_step;
    const State *state = r->p->state.at[next.state - 1];

    if (step > 1 && !(is_new && r->result.outcome != SCRIPT_ENDLESS))         // otherwise the state would begin in a next step, whose G is unknown
        diag_note(r->diags, d, (Span){0}, DIAG_note_state_since, state->name->text, count_text(r->arena, step),
                  count_text(r->arena, is_new ? r->g : r->machine[machine].start));
    else if (step == 1)
        diag_note(r->diags, d, (Span){0}, DIAG_note_no_transition, state->name->text);
}

// Adds a note about each @stop, none of which ended the run.
static void add_stop_notes(const ScriptRun *r, Diag *d)
{
    size_t shown = 0;

    for (size_t i = 0; i < r->s->section.n; i++) {
        const ScriptSection *section = &r->s->section.at[i];
        for (size_t j = 0; j < section->item.n && shown < STOPS; j++) {
            const Span stop = script_stop_span(section->item.at[j]);
            const uint64_t last = run_last_of_section(r, section);
            if (!section->item.at[j]->stop)
                continue;
            shown++;
            if (!section->state)
                diag_note(r->diags, d, stop, DIAG_note_stop_never_true);
            else if (last == 0)
                diag_note(r->diags, d, stop, DIAG_note_stop_never_run, section->state->name->text);
            else
                diag_note(r->diags, d, stop, DIAG_note_stop_last_run, section->state->name->text, count_text(r->arena, last),
                          count_text(r->arena, r->ran_at[section->state->number - 1]));
        }
    }
}

// Adds notes with the last steps and transitions to d, which reports a run that failed.
void history_add(ScriptRun *failed, Diag *d)
{
    History *h = ARENA_NEW(failed->arena, History);
    const ScriptItem *stop = failed->failed ? NULL : script_first_stop(failed->s);

    h->failed = failed;
    if (failed->failed)
        add_columns(h, failed->failed);
    // An `@assert false` has no operands itself: add those of the item's guard, or else of an enclosing guard.
    for (const ScriptItem *item = failed->failed_item; failed->failed && h->columns == 0 && item; item = item->parent)
        add_columns(h, item->guard);
    if (stop)
        add_columns(h, stop->guard);
    if (!failed->failed) {
        add_stop_notes(failed, d);
        for (size_t i = 0; i < failed->machines; i++)
            add_state_note(failed, i, d);
    }
    if (is_replay_too_slow(failed)) {
        diag_note(failed->diags, d, (Span){0}, DIAG_note_too_long);
    } else if (!replay_run(h)) {
        diag_note(failed->diags, d, (Span){0}, DIAG_note_other_values, failed->engine[0]->name);
    } else {
        add_step_table(h, d);
        add_transition_notes(h, d);
        if (h->watch)
            why_short_add(failed, d, h->watch);
    }
    if (failed->result.is_random)
        diag_note(failed->diags, d, (Span){0}, DIAG_note_seed, count_text(failed->arena, failed->result.seed));
}
