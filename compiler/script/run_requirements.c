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
    r->result.requirement = r->requirement;
}

bool requirement_check_step(ScriptRun *r)
{
    bool violated;

    for (size_t i = 0; r->p->joint && i < r->machines; i++)
        r->monitor->ran[i] = r->answer[0].machine[i].ran;
    violated = monitor_step(r->monitor, r->situation, r->cell);
    for (size_t i = 0; i < r->o->requirements->at.n; i++) {
        r->requirement[i].judged += r->monitor->result[i] != MONITOR_IDLE;
        r->requirement[i].violated = r->monitor->result[i] == MONITOR_VIOLATED;
    }
    return violated;
}

// Returns the condition whose value violates a requirement.
static const Expr *deciding_condition(const Requirement *r)
{
    return r->kind == REQUIREMENT_ALWAYS || r->kind == REQUIREMENT_LEADS_TO ? r->b : r->a;
}

void requirement_fail(ScriptRun *r)
{
    for (size_t i = 0; i < r->o->requirements->at.n && !r->violated; i++)
        if (r->requirement[i].violated)
            r->violated = &r->o->requirements->at.at[i];
    r->failed = deciding_condition(r->violated);
    run_finish(r, SCRIPT_FAILED);
}

void requirement_end_run(ScriptRun *r)
{
    for (size_t i = 0; i < r->o->requirements->at.n; i++)
        r->requirement[i].undecided = monitor_is_open(r->monitor, r->situation, i, &r->requirement[i].since);
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

// Adds what the steps before have to do with the violation.
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

static void report_violation(ScriptRun *r, const Requirement *what, uint64_t since)
{
    const Expr *e = deciding_condition(what);
    Diag *d = diag_report(r->diags, DIAG_requirement_violated, e->span, what->id->text, number_text(r, r->result.steps), number_text(r, r->g),
                          run_state_text(r), what->text->text);

    run_label_operands(r, d, e, &r->monitor->windows);
    add_reason(r, d, what, since);
    if (what == r->violated)
        history_add(r, d);
}

void requirement_report_violations(ScriptRun *r)
{
    for (size_t i = 0; i < r->o->requirements->at.n; i++)
        if (r->requirement[i].violated)
            report_violation(r, &r->o->requirements->at.at[i], r->requirement[i].since);
}

// A run that failed ended too early to decide what it could, so this is not reported.
void requirement_report_undecided(const ScriptRun *r)
{
    const bool is_complete = r->result.outcome == SCRIPT_PASSED || r->result.outcome == SCRIPT_ENDLESS;

    for (size_t i = 0; r->monitor && is_complete && i < r->o->requirements->at.n; i++) {
        const Requirement *what = &r->o->requirements->at.at[i];
        if (r->requirement[i].undecided)
            diag_report(r->diags, DIAG_requirement_undecided, what->span, what->id->text, source_text(r->arena, what->a),
                        number_text(r, r->requirement[i].since), source_text(r->arena, what->b));
    }
}

// ---- all runs of a call ----

void requirement_add_run(RequirementTotal *total, const Requirements *what, const ScriptResult *r)
{
    for (size_t i = 0; r->requirement && i < what->at.n; i++) {
        const RequirementRun *run = &r->requirement[i];
        total[i].judged += run->judged;
        total[i].scripts += run->judged > 0;
        total[i].violated += run->violated;
        total[i].undecided += run->undecided;
    }
}

const char *requirement_verdict(const RequirementTotal *t)
{
    return t->violated ? "violated" : t->undecided ? "undecided" : t->judged ? "met" : "never judged";
}

void requirement_report_unjudged(Diags *diags, const Requirements *what, const RequirementTotal *total)
{
    for (size_t i = 0; i < what->at.n; i++)
        if (total[i].judged == 0 && total[i].undecided == 0)
            diag_report(diags, DIAG_requirement_unjudged, what->at.at[i].span, what->at.at[i].id->text, what->at.at[i].text->text);
}
