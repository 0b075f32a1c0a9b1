// SPDX-License-Identifier: Apache-2.0
#include "compiler/report/traceability.h"

#include <string.h>

#include "compiler/base/path.h"
#include "compiler/report/written.h"

const char *const traced_kind_name[TRACED_KINDS] = {"state", "all_states", "transition", "output"};
const char *const traced_by_name[] = {"", "itself", "conditional", "state", "contents"};

// ---- requirements ----

// Returns the index of a requirement, which is added if it is new.
static uint32_t index_of(Traceability *t, Str id)
{
    uint32_t *number = map_find(&t->by_id, id);
    TracedRequirement r = {.id = id, .proof = "not tried", .result = "untested"};

    if (number)
        return *number;
    number = ARENA_NEW(t->arena, uint32_t);
    *number = t->requirement.n;
    map_put(&t->by_id, id, number);
    vec_push(t->arena, &t->requirement, r);
    return *number;
}

// Adds the index unless the list has it.
static void add_index(Arena *arena, TraceIndices *list, uint32_t index)
{
    for (size_t i = 0; i < list->n; i++)
        if (list->at[i] == index)
            return;
    vec_push(arena, list, index);
}

const char *traceability_place(Arena *arena, Span s)
{
    return format_in(arena, "%s:%lu", source_short_name(s.src), (unsigned long)source_position(s.src, s.at).line);
}

const char *traceability_ids(const Traceability *t, const TraceIndices *list)
{
    Buf out;

    buf_init(&out, t->arena);
    for (size_t i = 0; i < list->n; i++)
        buf_printf(&out, "%s%s", i ? "; " : "", t->requirement.at[list->at[i]].id->text);
    return buf_text(&out);
}

// ---- marks ----

// The [all_states] section whose text contains the span, or NULL.
static const AllStates *section_of(const Program *p, Span span)
{
    for (size_t i = 0; i < p->all_states.n; i++) {
        const Span all = p->all_states.at[i]->span;
        if (span.src == all.src && span.at >= all.at && span.at < all.at + all.len)
            return p->all_states.at[i];
    }
    return NULL;
}

// Returns the only statement that a conditional leads to; the statement itself if it is no conditional, or has several statements.
static const Stmt *effect_of(const Stmt *s)
{
    return s->kind == ST_IF && s->then.n == 1 && s->otherwise.n == 0 ? effect_of(s->then.at[0]) : s;
}

// The part of the program that the mark covers, as a name: a state, a section, a transition or a statement.
static const char *mark_name(const Traceability *t, const RequirementMark *m)
{
    const AllStates *all = section_of(t->program, m->span);
    const char *where = all ? written_section_name(t->arena, t->program, all, "") : m->state ? m->state->name->text : "";
    const Stmt *s = m->stmt ? effect_of(m->stmt) : NULL;

    if (!s)
        return all ? where : format_in(t->arena, "state %s", where);
    if (s->kind == ST_TRANSITION)
        return format_in(t->arena, "%s -> %s", where, s->target->name->text);
    return format_in(t->arena, "%s: %s%s", where, s->kind == ST_IF ? "if " : "",
                     source_text(t->arena, s->kind == ST_IF ? s->value->span : s->span));
}

static void add_marks(Traceability *t)
{
    for (size_t i = 0; i < t->program->mark.n; i++) {
        const RequirementMark *m = &t->program->mark.at[i];
        const TracedMark mark = {mark_name(t, m), m->span};
        const uint32_t r = index_of(t, m->requirement);
        vec_push(t->arena, &t->requirement.at[r].mark, mark);
    }
}

// ---- parts of the machine ----

// Adds the requirements of the marks on a statement, or on a state or section if `stmt` is NULL.
static void add_marked_requirements(Traceability *t, TracedPart *part, const Stmt *stmt, const State *state, const AllStates *all, TracedBy by)
{
    for (size_t i = 0; i < t->program->mark.n; i++) {
        const RequirementMark *m = &t->program->mark.at[i];
        const bool is_here = stmt ? m->stmt == stmt : !m->is_statement &&
            (all ? section_of(t->program, m->span) == all : m->state && m->state == state);
        if (!is_here)
            continue;
        add_index(t->arena, &part->requirement, index_of(t, m->requirement));
        if (part->by == TRACED_BY_NONE)
            part->by = by;
    }
}

// Adds the requirements of all marks inside a state or a section.
static void add_contents(Traceability *t, TracedPart *part, const State *state, const AllStates *all)
{
    for (size_t i = 0; i < t->program->mark.n; i++) {
        const RequirementMark *m = &t->program->mark.at[i];
        const AllStates *section = section_of(t->program, m->span);
        if (!m->is_statement || (all ? section != all : section || m->state != state))
            continue;
        add_index(t->arena, &part->requirement, index_of(t, m->requirement));
        part->by = TRACED_BY_CONTENTS;
    }
}

// Adds a state or an [all_states] section as a part of its own; without a mark it takes the requirements of its contents.
static void add_header(Traceability *t, const State *state, const AllStates *all)
{
    TracedPart part = {.kind = all ? TRACED_ALL_STATES : TRACED_STATE, .state = state, .text = "", .span = all ? all->span : state->span};

    part.where = part.name = all ? written_section_name(t->arena, t->program, all, "") : state->name->text;
    add_marked_requirements(t, &part, NULL, state, all, TRACED_BY_ITSELF);
    if (part.by == TRACED_BY_NONE)
        add_contents(t, &part, state, all);
    vec_push(t->arena, &t->part, part);
}

typedef struct PartWalk { Traceability *t; const State *state; const AllStates *all; } PartWalk;

// Adds a transition or an assignment to an output as a part, with the requirements of its own marks, of enclosing conditions and of its state. `by`
// tells which of these is nearest.
static void add_statement(const StmtLocation *at, void *context)
{
    PartWalk *w = context;
    Traceability *t = w->t;
    const Stmt *s = at->stmt;
    TracedPart part = {.stmt = s, .state = w->all ? NULL : at->state, .span = s->span};

    if (at->state != w->state || written_section(t->program, s->span) != w->all ||
        (s->kind == ST_ASSIGN ? s->var->kind != VAR_ELEMENT : s->kind == ST_IF))
        return;
    part.kind = s->kind == ST_TRANSITION ? TRACED_TRANSITION : TRACED_OUTPUT;
    part.where = w->all ? written_section_name(t->arena, t->program, w->all, "") : at->state->name->text;
    part.name = s->kind == ST_TRANSITION ? format_in(t->arena, "%s -> %s", part.where, s->target->name->text)
                                         : format_in(t->arena, "%s: %s", part.where, s->var->name->text);
    part.text = s->kind == ST_TRANSITION ? condition_text(t->arena, at->when) : source_text(t->arena, s->span);
    add_marked_requirements(t, &part, s, NULL, NULL, TRACED_BY_ITSELF);
    for (const Condition *c = at->when; c; c = c->outer)
        add_marked_requirements(t, &part, c->stmt, NULL, NULL, TRACED_BY_CONDITIONAL);
    add_marked_requirements(t, &part, NULL, at->state, w->all, TRACED_BY_STATE);
    vec_push(t->arena, &t->part, part);
}

// Adds a state or a section, and then what is in it.
static void add_parts(Traceability *t, const State *state, const AllStates *all)
{
    PartWalk w = {t, state, all};

    add_header(t, state, all);
    if (state)
        each_stmt_location(t->arena, t->program, add_statement, &w);
}

Traceability *traceability_new(Arena *arena, const Program *p, const Requirements *what)
{
    Traceability *t = ARENA_NEW(arena, Traceability);

    t->arena = t->by_id.arena = arena;
    t->program = p;
    t->visited = ARENA_ARRAY(arena, bool, p->state.n);
    t->what = what;
    for (size_t i = 0; what && i < what->at.n; i++) {
        const uint32_t r = index_of(t, what->at.at[i].id);
        t->requirement.at[r].what = &what->at.at[i];
    }
    add_marks(t);
    for (size_t i = 0; i < p->all_states.n; i++)
        add_parts(t, written_first_state(p, p->all_states.at[i]), p->all_states.at[i]);
    for (size_t i = 0; i < p->state.n; i++)
        add_parts(t, p->state.at[i], NULL);
    return t;
}

// ---- runs ----

static const char *result_of_assert(const ScriptAssert *a, const ScriptResult *r, uint32_t number)
{
    if (r->failed == a || (r->undecided && r->undecided[number] && r->failed))
        return "failed";
    if (a->kind == SCRIPT_FAIL)
        return r->evaluated[number] ? "failed" : script_has_stopped(r) ? "passed" : "never evaluated";
    return r->evaluated[number] == 0 ? "never evaluated" : r->undecided && r->undecided[number] ? "undecided" : "passed";
}

static void add_assert(Traceability *t, const ScriptAssert *a, const ScriptItem *item, uint32_t number, const ScriptResult *r)
{
    TracedAssert out = {.script = t->script.n - 1, .kind = a->kind, .evaluated = r->evaluated[number], .result = result_of_assert(a, r, number)};

    out.span = a->remark ? a->remark->span : a->condition ? a->condition->span : item->guard->span;
    out.text = a->remark && a->remark->text ? a->remark->text->text : a->condition ? source_text(t->arena, a->condition->span) : "";
    if (a->remark && a->remark->requirement) {
        const uint32_t requirement = index_of(t, a->remark->requirement);
        out.requirement = requirement + 1;
        vec_push(t->arena, &t->requirement.at[requirement].assert, t->assert.n);
        if (strcmp(out.result, "passed") == 0 || strcmp(out.result, "failed") == 0)
            add_index(t->arena, &t->script.at[out.script].requirement, requirement);
    }
    vec_push(t->arena, &t->assert, out);
}

// Adds how often the latest script judged, violated or left undecided each requirement.
static void add_judged_requirements(Traceability *t, const ScriptResult *r)
{
    for (uint32_t i = 0; t->what && r->requirement && i < t->what->at.n; i++) {
        TracedRequirement *q = &t->requirement.at[i];
        const TracedRun run = {t->script.n - 1, r->requirement[i].judged};
        q->total.judged += run.judged;
        q->total.scripts += run.judged > 0;
        q->total.violated += r->requirement[i].violations > 0;
        q->total.undecided += r->requirement[i].undecided;
        if (run.judged == 0)
            continue;
        vec_push(t->arena, &q->run, run);
        add_index(t->arena, &t->script.at[run.script].requirement, i);
    }
}

void traceability_add_run(Traceability *t, const char *name, const Script *s, const ScriptResult *r)
{
    const TracedScript script = {s ? source_short_name(s->src) : path_portable_name(name), r->outcome, {NULL, 0, 0}};

    vec_push(t->arena, &t->script, script);
    add_judged_requirements(t, r);
    requirement_add_visits(t->visited, t->program, r);
    for (size_t i = 0; r->evaluated && i < s->section.n; i++)
        for (size_t k = 0; k < s->section.at[i].item.n; k++) {
            const ScriptItem *item = s->section.at[i].item.at[k];
            for (uint32_t n = 0; n < item->asserts.n; n++)
                if (item->asserts.at[n].kind != SCRIPT_PRINT)
                    add_assert(t, &item->asserts.at[n], item, item->first_assert + n, r);
        }
}

void traceability_set_proof(Traceability *t, Str id, const char *proof)
{
    const uint32_t r = index_of(t, id);

    t->requirement.at[r].proof = proof;
}

// ---- results ----

// Whether an assert of the requirement ended with this result.
static bool has_assert(const Traceability *t, const TracedRequirement *q, const char *result)
{
    for (size_t i = 0; i < q->assert.n; i++)
        if (strcmp(t->assert.at[q->assert.at[i]].result, result) == 0)
            return true;
    return false;
}

void traceability_finish(Traceability *t)
{
    memset(&t->counts, 0, sizeof t->counts);
    for (size_t i = 0; i < t->requirement.n; i++) {
        TracedRequirement *q = &t->requirement.at[i];
        const bool is_violated = q->total.violated || has_assert(t, q, "failed"), is_undecided = q->total.undecided || has_assert(t, q, "undecided");
        const bool is_tested = q->total.judged || has_assert(t, q, "passed");
        uint32_t *count = is_violated ? &t->counts.violated : is_undecided
            ? &t->counts.undecided : is_tested ? &t->counts.tested : &t->counts.untested;
        q->unvisited = q->what ? requirement_unvisited(t->arena, q->what, t->program, t->visited) : "";
        q->result = is_violated ? "violated" : is_undecided ? "undecided" : is_tested ? "tested" : "untested";
        ++*count;
    }
    for (size_t i = 0; i < t->part.n; i++)
        t->counts.unmarked[t->part.at[i].kind] += t->part.at[i].requirement.n == 0;
}
