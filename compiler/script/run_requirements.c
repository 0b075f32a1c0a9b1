// SPDX-License-Identifier: Apache-2.0
// Requirements in the run of a script (requirements.md 13.14 to 13.17): judges them after each step, and reports those that are violated with
// the values of their operands.
#include "compiler/script/script_run.h"

#include <inttypes.h>
#include <string.h>

// ---- the run ----

void requirement_begin_run(ScriptRun *r)
{
    r->monitor = monitor_new(r->arena, r->o->requirements, r->s->delta_t);
    r->situation = arena_alloc(r->arena, r->monitor->size);
    monitor_start(r->monitor, r->situation);
    r->requirement = ARENA_ARRAY(r->arena, RequirementRun, r->o->requirements->at.n);
    r->violation = ARENA_ARRAY(r->arena, Diag *, r->o->requirements->at.n);
    r->result.requirement = r->requirement;
    r->result.ran = r->ran;
}

// Counts a step that violates requirement `i`.  Returns whether it is the first one.
static bool count_violation(ScriptRun *r, size_t i)
{
    RequirementRun *run = &r->requirement[i];

    run->last_step = r->result.steps;
    run->last_g = r->g;
    if (run->violations++ > 0)
        return false;
    run->first_step = r->result.steps;
    run->first_g = r->g;
    r->violated = r->violated ? r->violated : &r->o->requirements->at.at[i];
    return true;
}

bool requirement_check_step(ScriptRun *r)
{
    const uint64_t next = run_next_g(r, 0);
    bool is_new = false;

    r->monitor->step = next == UINT64_MAX ? 1 : next - r->g;
    for (size_t i = 0; r->p->joint && i < r->machines; i++)
        r->monitor->ran[i] = r->answer[0].machine[i].ran;
    monitor_step(r->monitor, r->situation, r->cell);
    for (size_t i = 0; i < r->o->requirements->at.n; i++) {
        if (r->o->ignored && r->o->ignored[i])
            r->monitor->result[i] = MONITOR_IDLE;
        r->requirement[i].judged += r->monitor->result[i] != MONITOR_IDLE;
        if (r->monitor->result[i] == MONITOR_VIOLATED)
            is_new |= count_violation(r, i);
    }
    return is_new;
}

// Returns the condition whose value violates a requirement.
static const Expr *deciding_condition(const Requirement *r)
{
    return r->kind == REQUIREMENT_ALWAYS || r->kind == REQUIREMENT_LEADS_TO ? r->b : r->a;
}

void requirement_end_run(ScriptRun *r)
{
    for (size_t i = 0; i < r->o->requirements->at.n; i++) {
        RequirementRun *run = &r->requirement[i];
        run->undecided = monitor_is_open(r->monitor, r->situation, i, &run->since) && run->violations == 0 && !(r->o->ignored && r->o->ignored[i]);
    }
}

// ---- reports ----

static const char *number_text(const ScriptRun *r, uint64_t n) { return format_in(r->arena, "%" PRIu64, n); }

// Returns the source of a condition, cut to a readable length.
static const char *source_text(Arena *arena, const Expr *e)
{
    enum { MOST = 60 };
    const char *s = e->span.src->text + e->span.at;
    uint32_t n = 0;

    while (n < e->span.len && n < MOST && s[n] != '\n' && s[n] != '\r' && s[n] != '#')
        n++;
    return format_in(arena, "%.*s%s", (int)n, s, n < e->span.len ? "..." : "");
}

// Adds a note about the earlier step that makes this step a violation, such as the last step with b.
static void add_reason(ScriptRun *r, Diag *d, const Requirement *what, uint64_t since)
{
    const char *at = number_text(r, since);

    switch (what->kind) {
    case REQUIREMENT_NEVER: case REQUIREMENT_ALWAYS: break;
    case REQUIREMENT_BEFORE:
        diag_note(r->diags, d, what->b->span, DIAG_note_requirement_before, source_text(r->arena, what->b));
        break;
    case REQUIREMENT_AFTER:
        diag_note(r->diags, d, what->c->span, DIAG_note_requirement_after, source_text(r->arena, what->b), at, source_text(r->arena, what->c));
        break;
    case REQUIREMENT_LEADS_TO:
        diag_note(r->diags, d, what->a->span, DIAG_note_requirement_late, source_text(r->arena, what->a), at, source_text(r->arena, what->b),
                  number_text(r, r->g));
        break;
    }
}

// Reports that this step violates requirement `i`.  `with_history`: adds the steps and transitions before.
static void report_violation(ScriptRun *r, size_t i, bool with_history)
{
    const Requirement *what = &r->o->requirements->at.at[i];
    const Expr *e = deciding_condition(what);
    Diag *d = diag_report(r->diags, DIAG_requirement_violated, e->span, what->id->text, number_text(r, r->result.steps), number_text(r, r->g),
                          run_state_text(r), what->text->text);
    uint64_t since = 0;

    r->violation[i] = d;
    monitor_is_open(r->monitor, r->situation, i, &since);
    run_label_operands(r, d, e, &r->monitor->windows);
    diag_note(r->diags, d, run_start_of_script(r), DIAG_note_run_of);
    add_reason(r, d, what, since);
    if (!with_history)
        return;
    r->failed = e;
    r->reports_violation = true;
    history_add(r, d);
    r->failed = NULL;
    r->reports_violation = false;
}

// The first report of a step has the history.
void requirement_report_new_violations(ScriptRun *r)
{
    size_t reports = 0;

    for (size_t i = 0; i < r->o->requirements->at.n && !r->o->is_silent; i++)
        if (r->requirement[i].violations == 1 && r->requirement[i].first_step == r->result.steps)
            report_violation(r, i, reports++ == 0);
}

void requirement_report_repetitions(ScriptRun *r)
{
    for (size_t i = 0; r->monitor && i < r->o->requirements->at.n; i++) {
        const RequirementRun *run = &r->requirement[i];
        if (run->violations > 1)
            diag_note(r->diags, r->violation[i], (Span){0}, DIAG_note_violated_again, number_text(r, run->violations - 1),
                      run->violations == 2 ? "" : "s", number_text(r, run->last_step), number_text(r, run->last_g));
    }
}

// After a run that an assert has ended nothing is reported, because it ended before it could decide the other requirements.
void requirement_report_undecided(const ScriptRun *r)
{
    for (size_t i = 0; r->monitor && run_is_complete(r) && i < r->o->requirements->at.n; i++) {
        const Requirement *what = &r->o->requirements->at.at[i];
        if (r->requirement[i].undecided)
            diag_note(r->diags,
                      diag_report(r->diags, DIAG_requirement_undecided, what->span, what->id->text, source_text(r->arena, what->a),
                                  number_text(r, r->requirement[i].since), source_text(r->arena, what->b)),
                      run_start_of_script(r), DIAG_note_run_of);
    }
}

// ---- all runs of a call ----

void requirement_add_run(RequirementTotal *total, const Requirements *what, const ScriptResult *r)
{
    for (size_t i = 0; r->requirement && i < what->at.n; i++) {
        const RequirementRun *run = &r->requirement[i];
        total[i].judged += run->judged;
        total[i].scripts += run->judged > 0;
        total[i].violated += run->violations > 0;
        total[i].undecided += run->undecided;
    }
}

void requirement_add_visits(bool *visited, const Program *p, const ScriptResult *r)
{
    for (size_t s = 0; r->ran && s < p->state.n; s++)
        visited[s] |= r->ran[s] > 0;
}

// The context of the walk that marks the states that conditions name.
typedef struct NamedStates {
    const Program *p;
    bool *is_named;           // by State.number - 1: a condition names the state
} NamedStates;

// Returns the index in Program.state of the first state of the machine whose S is v; UINT32_MAX: v is the S of no machine.
static uint32_t first_state_of(const Program *p, const Var *v)
{
    if (!p->joint)
        return v == p->s ? 0 : UINT32_MAX;
    for (size_t m = 0; m < p->joint->member.n; m++)
        if (p->joint->member.at[m].s == v)
            return p->joint->member.at[m].first;
    return UINT32_MAX;
}

static void note_named_state(Expr *e, void *context)
{
    const NamedStates *named = context;
    const bool is_equality = e->kind == EX_BINARY && (e->op == SM_OP_EQ || e->op == SM_OP_NE);

    for (uint32_t s = 0; is_equality && s < 2; s++) {
        const Expr *state = e->arg[s], *number = e->arg[!s];
        const uint32_t first = state->kind == EX_VAR && number->kind == EX_NUMBER ? first_state_of(named->p, state->var) : UINT32_MAX;
        if (first != UINT32_MAX && number->number >= 1 && first + number->number <= (double)named->p->state.n)
            named->is_named[first + (uint32_t)number->number - 1] = true;
    }
}

const char *requirement_unvisited(Arena *arena, const Requirement *what, const Program *p, const bool *visited)
{
    const NamedStates named = {p, ARENA_ARRAY(arena, bool, p->state.n)};
    Expr *const condition[] = {what->a, what->b, what->c};
    Buf out;

    for (size_t i = 0; i < sizeof condition / sizeof *condition; i++)
        if (condition[i])
            expr_walk(condition[i], note_named_state, (void *)&named);
    buf_init(&out, arena);
    for (size_t s = 0; s < p->state.n; s++)
        if (named.is_named[s] && !visited[s])
            buf_printf(&out, "%s%s", out.n ? ", " : "", p->state.at[s]->name->text);
    return buf_text(&out);
}

const char *requirement_verdict(const RequirementTotal *t)
{
    return t->violated ? "violated" : t->undecided ? "undecided" : t->judged ? "met" : "never judged";
}

// Sets the first held(c, t) of a condition.
static void find_held_time(Expr *e, void *context)
{
    const Expr **found = context;

    if (e->kind == EX_ROLL && e->stat == SM_STAT_RUN_TIME && !*found)
        *found = e;
}

void requirement_report_unjudged(Diags *diags, const Requirements *what, const RequirementTotal *total)
{
    for (size_t i = 0; i < what->at.n; i++)
        if (total[i].judged == 0 && total[i].undecided == 0) {
            const Requirement *r = &what->at.at[i];
            Diag *d = diag_report(diags, DIAG_requirement_unjudged, r->span, r->id->text, r->text->text);
            const Expr *held = NULL;
            if (r->a)
                expr_walk(r->a, find_held_time, &held);
            if (held)
                diag_note(diags, d, held->span, DIAG_note_held_samples);
        }
}
