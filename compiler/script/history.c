// SPDX-License-Identifier: Apache-2.0
// The history of a failed run: the last steps with the relevant values, and the last transitions with their source lines.  A run
// does not record its history.  A script that failed runs again on the reference interpreter, which knows the statement of each
// transition.  Scripts that pass therefore have no extra cost.
#include "compiler/script/script_run.h"

#include <inttypes.h>
#include <string.h>

enum {
    STEPS = 5, TRANSITIONS = 3, COLUMNS = 6, COLUMN_WIDTH = 40, STOPS = 3,
    WORK_MOST = 1000000000            // limit for samples read in the second run: a few seconds
};

typedef struct PastStep {
    uint64_t number, g;
    const State *state;
    const char *value[COLUMNS];
} PastStep;

typedef struct PastTransition {
    uint64_t step, g;
    const State *from;
    const Stmt *stmt;
} PastTransition;

typedef struct History {
    Run *failed;
    Run run;                          // the second run of the same script
    const Expr *column[COLUMNS];
    size_t columns;
    PastStep step[STEPS];             // the last steps, in order
    size_t steps;
    PastTransition transition[TRANSITIONS];
    size_t transitions;               // the last transitions, in order
} History;

static const char *count_text(Arena *arena, uint64_t n) { return format_in(arena, "%" PRIu64, n); }

// ---- columns of the table ----

static bool is_column(const History *h, const Expr *e)
{
    for (size_t i = 0; i < h->columns; i++)
        if (h->column[i] == e || span_same_text(h->column[i]->span, e->span))
            return true;
    return false;
}

// Adds the variables and windows that an expression reads, except constants.
static void add_columns(History *h, const Expr *e)
{
    const bool is_value = e->kind == EX_ROLL || (e->kind == EX_VAR && !e->var->is_constant);

    if (is_value && h->columns < COLUMNS && e->span.src && e->span.len <= COLUMN_WIDTH && !memchr(e->span.src->text + e->span.at, '\n', e->span.len) &&
        !is_column(h, e) && !(e->kind == EX_VAR && e->var == h->failed->p->g))          // G has its own column
        h->column[h->columns++] = e;
    for (uint32_t i = 0; i < e->n && e->kind != EX_ROLL; i++)
        add_columns(h, e->arg[i]);
}

// ---- the second run ----

static const char *value_text(Run *r, const Expr *e)
{
    Buf text;

    buf_init(&text, r->arena);
    run_put_value(r, e, &text);
    return buf_text(&text);
}

static void record_step(History *h)
{
    Run *r = &h->run;
    PastStep *s;

    if (r->result.steps + STEPS <= h->failed->result.steps)
        return;
    s = &h->step[h->steps++];
    s->number = r->result.steps;
    s->g = r->g;
    s->state = r->state;
    for (size_t i = 0; i < h->columns; i++)
        s->value[i] = value_text(r, h->column[i]);
}

static void record_transition(History *h)
{
    Run *r = &h->run;
    const Stmt *stmt = engine_ref_transition(r->engine[0]);

    if (!stmt)
        return;
    if (h->transitions == TRANSITIONS)
        memmove(h->transition, h->transition + 1, --h->transitions * sizeof *h->transition);
    h->transition[h->transitions++] = (PastTransition){r->result.steps, r->g, r->state, stmt};
}

static void record_after_step(void *context, const ScriptStep *step)
{
    (void)step;
    record_step(context);
    record_transition(context);
}

// The reference interpreter reads every sample of every window in each step.
static bool is_too_long(const Run *r)
{
    uint64_t work = 1;

    for (size_t i = 0; i < r->p->window.n; i++)
        work += r->p->window.at[i].size;
    for (size_t i = 0; i < r->s->window.n; i++)
        work += r->s->window.at[i].size;
    return r->result.steps > WORK_MOST / work;
}

// Runs the script again.  Returns whether its final values equal those of the failed run.
static bool replay(History *h)
{
    const Run *failed = h->failed;
    const ScriptOptions o = {failed->result.steps, record_after_step, h, true};
    Engine *ref = engine_ref_open(failed->arena, failed->p);
    Diags silent;

    diags_init(&silent, failed->arena);
    silent.muted = true;
    h->run = (Run){.arena = failed->arena, .diags = &silent, .s = failed->s, .p = failed->p, .engine = &ref, .engines = 1, .o = &o};
    run_to_the_end(&h->run);
    return h->run.result.steps == failed->result.steps && memcmp(h->run.cell, failed->cell, failed->p->var.n * sizeof *failed->cell) == 0;
}

// ---- notes of the diagnostic ----

static size_t max_size(size_t a, size_t b) { return a > b ? a : b; }

static void end_row(Buf *out)
{
    while (out->n && out->at[out->n - 1] == ' ')
        out->at[--out->n] = '\0';
}

static void put_right(Buf *out, const char *text, size_t width)
{
    buf_spaces(out, width > strlen(text) ? width - strlen(text) : 0);
    buf_str(out, text);
}

static size_t width_of(const History *h, size_t column)
{
    size_t width = h->column[column]->span.len;

    for (size_t i = 0; i < h->steps; i++)
        width = max_size(width, strlen(h->step[i].value[column]));
    return width;
}

static void add_steps(History *h, Diag *d)
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
        states = max_size(states, h->step[i].state->name->len);
    }
    buf_char(&table, '\n');
    put_right(&table, "step", steps);
    put_right(&table, "G", gs + 2);
    buf_printf(&table, "  %-*s", (int)states, "state");
    for (size_t i = 0; i < h->columns; i++) {
        const Span s = h->column[i]->span;
        buf_spaces(&table, 2 + width_of(h, i) - s.len);
        buf_put(&table, s.src->text + s.at, s.len);
    }
    for (size_t i = 0; i < h->steps; i++) {
        end_row(&table);
        buf_char(&table, '\n');
        put_right(&table, count_text(arena, h->step[i].number), steps);
        put_right(&table, count_text(arena, h->step[i].g), gs + 2);
        buf_printf(&table, "  %-*s", (int)states, h->step[i].state->name->text);
        for (size_t c = 0; c < h->columns; c++)
            put_right(&table, h->step[i].value[c], width_of(h, c) + 2);
    }
    end_row(&table);
    diag_note(h->failed->diags, d, (Span){0}, h->steps == 1 ? DIAG_note_only_step : DIAG_note_last_steps, buf_text(&table));
}

static void add_transitions(History *h, Diag *d)
{
    const Run *r = h->failed;

    for (size_t i = 0; i < h->transitions; i++) {
        const PastTransition *t = &h->transition[i];
        diag_note(r->diags, d, t->stmt->span, DIAG_note_transition_made, count_text(r->arena, t->step), count_text(r->arena, t->g),
                  t->from->name->text, t->stmt->target->name->text);
    }
    if (h->transitions == 0 && r->failed)
        diag_note(r->diags, d, (Span){0}, DIAG_note_no_transition, r->s->init_state->name->text);
}

// For a run that did not stop: adds the machine's current state.
static void add_state(const Run *r, Diag *d)
{
    const uint64_t step = r->answer[0].next_is_first ? r->result.steps + 1 : r->start / r->s->delta_t + 1;
    const State *state = r->p->state.at[r->answer[0].next_state - 1];

    if (step > 1 && step - 1 <= UINT64_MAX / r->s->delta_t)
        diag_note(r->diags, d, (Span){0}, DIAG_note_state_since, state->name->text, count_text(r->arena, step),
                  count_text(r->arena, (step - 1) * r->s->delta_t));
    else if (step == 1)
        diag_note(r->diags, d, (Span){0}, DIAG_note_no_transition, state->name->text);
}

static void note_stop(const Run *r, Diag *d, const ScriptSection *section, uint64_t ran, Span stop)
{
    if (!section->state)
        diag_note(r->diags, d, stop, DIAG_note_stop_never_true);
    else if (ran == 0)
        diag_note(r->diags, d, stop, DIAG_note_stop_never_run, section->state->name->text);
    else
        diag_note(r->diags, d, stop, DIAG_note_stop_last_run, section->state->name->text, count_text(r->arena, ran),
                  count_text(r->arena, (ran - 1) * r->s->delta_t));
}

static void note_stops(const Run *r, Diag *d)
{
    size_t shown = 0;

    for (size_t i = 0; i < r->s->section.n; i++)
        for (size_t j = 0; j < r->s->section.at[i].item.n && shown < STOPS; j++)
            if (r->s->section.at[i].item.at[j].stop) {
                note_stop(r, d, &r->s->section.at[i], r->ran[i], r->s->section.at[i].item.at[j].stop_span);
                shown++;
            }
}

void history_add(Run *failed, Diag *d)
{
    History *h = ARENA_NEW(failed->arena, History);
    const ScriptItem *stop = failed->failed ? NULL : script_first_stop(failed->s);

    h->failed = failed;
    if (failed->failed)
        add_columns(h, failed->failed);
    if (failed->failed && h->columns == 0)
        add_columns(h, failed->failed_item->guard);       // for @assert false: the operands of its guard
    if (stop)
        add_columns(h, stop->guard);
    if (!failed->failed) {
        note_stops(failed, d);
        add_state(failed, d);
    }
    if (is_too_long(failed)) {
        diag_note(failed->diags, d, (Span){0}, DIAG_note_too_long);
    } else if (!replay(h)) {
        diag_note(failed->diags, d, (Span){0}, DIAG_note_other_values, failed->engine[0]->name);
    } else {
        add_steps(h, d);
        add_transitions(h, d);
    }
}
