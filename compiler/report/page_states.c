// SPDX-License-Identifier: Apache-2.0
// A description of each state, and the table of all transitions.
#include "compiler/report/comment.h"
#include "compiler/report/describe.h"
#include "compiler/report/page.h"
#include "compiler/report/page_text.h"
#include "compiler/report/written.h"

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

// The predecessors of a state, each once: states, and sections [all_states].
typedef struct Predecessors { VEC(const char *) name; const void *last; } Predecessors;

// Returns the name of where a transition comes from, in markup.
static const char *origin_name(const Report *r, const WrittenTransition *t)
{
    return t->all ? written_section_name(r->arena, r->analysis.p, t->all, "^") : format_in(r->arena, "^%s^", t->copy.at[0]->from->name->text);
}

// Returns the names of the predecessors of each state, by State.number.
static Predecessors *list_predecessors(const Report *r, const WrittenTransitions *all)
{
    Predecessors *of = ARENA_ARRAY(r->arena, Predecessors, r->analysis.p->state.n + 1u);

    for (size_t i = 0; i < all->n; i++) {
        const WrittenTransition *t = &all->at[i];
        const void *from = t->all ? (const void *)t->all : t->copy.at[0]->from;
        Predecessors *s = &of[t->copy.at[0]->to->number];
        if (s->last != from)                      // transitions are sorted by their source
            vec_push(r->arena, &s->name, origin_name(r, t));
        s->last = from;
    }
    return of;
}

// The sentence that lists the states from which this state is entered.
static void add_predecessors(const Report *r, Doc *d, const Predecessors *s)
{
    Buf b;

    if (s->name.n == 0)
        return;
    buf_init(&b, r->arena);
    buf_str(&b, "Entered from ");
    for (size_t i = 0; i < s->name.n; i++)
        buf_printf(&b, "%s%s", describe_separator(i, s->name.n), s->name.at[i]);
    buf_char(&b, '.');
    doc_add_paragraph(d, buf_text(&b));
}

// ---- in all states ----

// Starts with a capital: "All states except ^Abort^".
static const char *section_heading(const Report *r, const AllStates *all)
{
    const char *name = written_section_name(r->arena, r->analysis.p, all, "^");

    return format_in(r->arena, "%c%s", name[0] - 'a' + 'A', name + 1);
}

// Describes the statements of the sections [all_states], which the descriptions of the states do not repeat.
void report_add_all_states(Report *r, Doc *d)
{
    const Program *p = r->analysis.p;

    if (p->all_states.n == 0)
        return;
    doc_add_section(d, "all-states", "In all states");
    doc_add_legend(d, TEXT_ALL_STATES);
    for (size_t i = 0; i < p->all_states.n; i++) {
        const AllStates *all = p->all_states.at[i];
        const Stmts stmts = written_section_stmts(p, all);
        doc_add_heading(d, format_in(r->arena, "all-states-%lu", (unsigned long)i + 1), section_heading(r, all));
        doc_add_quote(d, comment_around(r->arena, (Span){all->span.src, all->span.at, 0}));
        describe_block(doc_add_list(d, format_in(r->arena, "%lu.step", (unsigned long)i + 1), "In each step, the machine"), &stmts);
    }
}

// Appends the names of the [all_states] sections that run in the state; if not `running`, of those that do not.
static size_t write_sections(const Report *r, Buf *out, const State *s, bool running)
{
    const Program *p = r->analysis.p;
    size_t n = 0, i = 0;

    for (size_t k = 0; k < p->all_states.n; k++)
        n += p->all_states.at[k]->excepted[s->number] != running;
    for (size_t k = 0; k < p->all_states.n; k++)
        if (p->all_states.at[k]->excepted[s->number] != running) {
            buf_printf(out, "%s\"%s\"", describe_separator(i, n), written_section_name(r->arena, p, p->all_states.at[k], "^"));
            i++;
        }
    return n;
}

// Adds which statements of all states run in the state.
static void add_sections_of_state(const Report *r, Doc *d, const State *s)
{
    Buf run, skipped;
    size_t runs, skips;

    buf_init(&run, r->arena);
    buf_init(&skipped, r->arena);
    runs = write_sections(r, &run, s, true);
    skips = write_sections(r, &skipped, s, false);
    if (runs)
        doc_add_paragraph(d, format_in(r->arena, "Each step begins with the statements of %s.", buf_text(&run)));
    if (skips)
        doc_add_paragraph(d, format_in(r->arena, "The statements of %s do not run in this state.", buf_text(&skipped)));
}

// ---- a state ----

// The statements of .entry, .step and .exit in words; statements of [all_states] sections are listed with their section.
static void add_blocks(const Report *r, Doc *d, const State *s)
{
    static const char *const label[BLOCK_COUNT] = {"On entry, the machine", "In each step, the machine", "On exit, the machine"};
    static const char *const key[BLOCK_COUNT] = {"entry", "step", "exit"};
    bool any = false;

    for (int b = 0; b < BLOCK_COUNT; b++) {
        const Stmts own = written_own_stmts(s, (BlockKind)b);
        if (own.n == 0)
            continue;
        describe_block(doc_add_list(d, format_in(r->arena, "%s.%s", s->name->text, key[b]), label[b]), &own);
        any = true;
    }
    if (!any)
        doc_add_paragraph(d, s->block[BLOCK_STEP].n ? TEXT_STATE_EMPTY_OF_ITS_OWN : TEXT_STATE_EMPTY);
}

void report_add_states(Report *r, Doc *d)
{
    const Program *p = r->analysis.p;
    const WrittenTransitions transitions = written_transitions(r->arena, p, &r->analysis.transition);
    const Predecessors *from = list_predecessors(r, &transitions);

    doc_add_section(d, "states", "States");
    doc_add_legend(d, TEXT_STATES);
    for (size_t i = 0; i < p->state.n; i++) {
        const State *s = p->state.at[i];
        set_badge(r, s, doc_add_heading(d, NULL, format_in(r->arena, "%u. %s", (unsigned)s->number, s->name->text)));
        doc_add_quote(d, comment_around(r->arena, s->span));
        add_sections_of_state(r, d, s);
        add_blocks(r, d, s);
        add_predecessors(r, d, &from[s->number]);
    }
}

// ---- transitions ----

static const DocColumn transition_columns[] = {
    {"number", "No."}, {"from", "From"}, {"to", "To"}, {"when", "Condition"}, {"block", "Block"}, {"line", "Line"}, {"note", "Remark"},
    {"comment", "Comment"}};

// Returns the comment after the transition. If it has no comment and the transition is the only statement of its guard, the comment after the guard.
static const char *comment_of_transition(const Report *r, const Transition *t)
{
    const char *comment = comment_after_lines(r->arena, t->stmt->span);
    const Stmt *guard = t->when && t->when->holds ? t->when->stmt : NULL;

    return comment || !guard || guard->then.n != 1 ? comment : comment_after_lines(r->arena, guard->span);
}

// Whether some run can take the transition in some state.
static bool can_be_taken(const Report *r, const WrittenTransition *t)
{
    for (size_t i = 0; i < t->copy.n; i++)
        if (r->analysis.stmt[t->copy.at[i]->stmt->number].reached)
            return true;
    return false;
}

static void add_transition(const Report *r, DocTable *table, const WrittenTransition *written, size_t number)
{
    static const char *const block[BLOCK_COUNT] = {".entry", ".step", ".exit"};
    const Transition *t = written->copy.at[0];
    const char *when = condition_text(r->arena, t->when);

    doc_add_number_cell(table, number);
    if (written->all)
        doc_add_plain_cell(table, written_section_name(r->arena, r->analysis.p, written->all, ""));
    else
        doc_add_state_cell(table, t->from->name->text);
    doc_add_state_cell(table, t->to->name->text);
    if (*when)
        doc_add_code_cell(table, when);
    else
        doc_add_plain_cell(table, "always");
    doc_add_plain_cell(table, block[t->block]);
    doc_add_line_cell(table, report_line_of(t->stmt->span));
    doc_add_plain_cell(table, !can_be_taken(r, written) ? "can never be taken" : t->to->is_abort ? "abort" : "");
    doc_add_plain_cell(table, comment_of_transition(r, t));
}

// Adds the table of all transitions.  Those of [all_states] come first, as in a step.
void report_add_transitions(Report *r, Doc *d)
{
    const WrittenTransitions all = written_transitions(r->arena, r->analysis.p, &r->analysis.transition);
    size_t number = 0;
    DocTable *table;

    doc_add_section(d, "transitions", "Transitions");
    if (all.n == 0) {
        doc_add_paragraph(d, TEXT_TRANSITIONS_NONE);
        return;
    }
    doc_add_paragraph(d, all.at[all.n - 1].all ? TEXT_TRANSITIONS_OF_ALL : TEXT_TRANSITIONS);
    table = DOC_ADD_TABLE(d, "transitions", transition_columns);
    for (int own = 0; own < 2; own++)
        for (size_t i = 0; i < all.n; i++)
            if ((all.at[i].all == NULL) == own)
                add_transition(r, table, &all.at[i], ++number);
}
