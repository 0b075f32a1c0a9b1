// SPDX-License-Identifier: Apache-2.0
// A description of each state, and the table of all transitions.
#include "compiler/report/comment.h"
#include "compiler/report/describe.h"
#include "compiler/report/page.h"
#include "compiler/report/page_text.h"

// Whether some block of the state can run.
static bool is_reached(const Report *r, const State *s)
{
    for (int b = 0; b < BLOCK_COUNT; b++)
        if (facts_may_reach(r->analysis.facts, s->number - 1u, b))
            return true;
    return false;
}

// Sets the badge beside the heading of a state: its most important property.
static void set_badge(const Report *r, const State *s, DocPart *heading)
{
    heading->state = s->name->text;
    heading->tone = s->is_abort ? "bad" : s->is_safe ? "good" : "note";
    if (s->is_abort)
        heading->badge = s->is_safe ? "abort, safe to stay" : "abort";
    else if (s->is_safe)
        heading->badge = "safe to stay";
    else if (!is_reached(r, s))
        heading->badge = "unreachable";
    else if (s->number == 1)
        heading->badge = "initial state";
    if (s->allows_swap)
        heading->badge = heading->badge ? format_in(r->arena, "%s, swap", heading->badge) : "swap";
}

// ---- predecessors ----

typedef struct Predecessors { VEC(const State *) from; } Predecessors;  // the predecessors of a state, each once

static Predecessors *find_predecessors(const Report *r)
{
    const Transitions *t = &r->analysis.transition;
    Predecessors *of = ARENA_ARRAY(r->arena, Predecessors, r->analysis.p->state.n + 1u);

    for (size_t i = 0; i < t->n; i++) {
        Predecessors *s = &of[t->at[i].to->number];
        if (s->from.n == 0 || s->from.at[s->from.n - 1] != t->at[i].from)     // transitions are sorted by state
            vec_push(r->arena, &s->from, t->at[i].from);
    }
    return of;
}

static void add_predecessors(const Report *r, Doc *d, const Predecessors *s)
{
    Buf b;

    if (s->from.n == 0)
        return;
    buf_init(&b, r->arena);
    buf_str(&b, "Entered from ");
    for (size_t i = 0; i < s->from.n; i++)
        buf_printf(&b, "%s^%s^", describe_separator(i, s->from.n), s->from.at[i]->name->text);
    buf_char(&b, '.');
    doc_add_paragraph(d, buf_text(&b));
}

// ---- a state ----

static void add_blocks(const Report *r, Doc *d, const State *s)
{
    static const char *const label[BLOCK_COUNT] = {"On entry, the machine", "In each step, the machine", "On exit, the machine"};
    static const char *const key[BLOCK_COUNT] = {"entry", "step", "exit"};
    bool any = false;

    for (int b = 0; b < BLOCK_COUNT; b++)
        if (s->block[b].n) {
            describe_block(doc_add_list(d, format_in(r->arena, "%s.%s", s->name->text, key[b]), label[b]), &s->block[b]);
            any = true;
        }
    if (!any)
        doc_add_paragraph(d, TEXT_STATE_EMPTY);
}

void report_add_states(Report *r, Doc *d)
{
    const Program *p = r->analysis.p;
    const Predecessors *from = find_predecessors(r);

    doc_add_section(d, "states", "States");
    doc_add_paragraph(d, TEXT_STATES);
    for (size_t i = 0; i < p->state.n; i++) {
        const State *s = p->state.at[i];
        set_badge(r, s, doc_add_heading(d, NULL, format_in(r->arena, "%u. %s", (unsigned)s->number, s->name->text)));
        doc_add_quote(d, comment_around(r->arena, s->span));
        add_blocks(r, d, s);
        add_predecessors(r, d, &from[s->number]);
    }
}

// ---- transitions ----

static const DocColumn transition_columns[] = {
    {"number", "No."}, {"from", "From"}, {"to", "To"}, {"when", "Condition"}, {"block", "Block"}, {"line", "Line"}, {"note", "Remark"},
    {"comment", "Comment"}};

// Returns the comment after the transition. If there is none and the transition is the only statement of its guard, the comment after the guard.
static const char *comment_of_transition(const Report *r, const Transition *t)
{
    const char *comment = comment_after_lines(r->arena, t->stmt->span);
    const Stmt *guard = t->when && t->when->holds ? t->when->stmt : NULL;

    return comment || !guard || guard->then.n != 1 ? comment : comment_after_lines(r->arena, guard->span);
}

void report_add_transitions(Report *r, Doc *d)
{
    static const char *const block[BLOCK_COUNT] = {".entry", ".step", ".exit"};
    const Transitions *all = &r->analysis.transition;
    DocTable *table;

    doc_add_section(d, "transitions", "Transitions");
    if (all->n == 0) {
        doc_add_paragraph(d, TEXT_TRANSITIONS_NONE);
        return;
    }
    doc_add_paragraph(d, TEXT_TRANSITIONS);
    table = DOC_ADD_TABLE(d, "transitions", transition_columns);
    for (size_t i = 0; i < all->n; i++) {
        const Transition *t = &all->at[i];
        const char *when = condition_text(r->arena, t->when);
        doc_add_number_cell(table, t->number + 1u);
        doc_add_state_cell(table, t->from->name->text);
        doc_add_state_cell(table, t->to->name->text);
        if (*when)
            doc_add_code_cell(table, when);
        else
            doc_add_plain_cell(table, "always");
        doc_add_plain_cell(table, block[t->block]);
        doc_add_line_cell(table, report_line_of(t->stmt->span));
        doc_add_plain_cell(table, !r->analysis.stmt[t->stmt->number].reached ? "can never be taken" : t->to->is_abort ? "abort" : "");
        doc_add_plain_cell(table, comment_of_transition(r, t));
    }
}
