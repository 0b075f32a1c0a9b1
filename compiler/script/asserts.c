// SPDX-License-Identifier: Apache-2.0
// Evaluates @assert, @fail, @expect, @print and @stop after a step (language.md 8.18 to 8.20, 8.31 to 8.36), and reports one that is not met
// with the values of its operands.
#include "compiler/script/script_run.h"

#include <inttypes.h>
#include <string.h>

// ---- the operands of an assert ----

enum { OPERANDS_MOST = 8, OPERAND_LENGTH = 40 };      // the most operands in a label; the most bytes of source of one operand

// The operands of an assert with their values, collected for a label.
typedef struct Operands {
    ScriptRun *r;
    const RefWindows *windows;
    Buf text;                 // the label: "valveOpen = false, tankPressure = 776"
    const Expr *shown[OPERANDS_MOST];         // the n expressions in `text`
    size_t n;
} Operands;

// Whether a message that shows the n expressions of `shown` with their values can show e too: its source is on one line of at most `most`
// bytes, and differs from theirs.
bool run_can_show(const Expr *const *shown, size_t n, const Expr *e, size_t most)
{
    const Span s = e->span;

    if (!s.src || s.len == 0 || s.len > most || memchr(s.src->text + s.at, '\n', s.len))
        return false;
    for (size_t i = 0; i < n; i++) {
        const Span other = shown[i]->span;
        if (shown[i] == e || (other.len == s.len && memcmp(other.src->text + other.at, s.src->text + s.at, s.len) == 0))
            return false;
    }
    return true;
}

// Appends the value of e in the format of diagnostics.
void run_append_value(ScriptRun *r, const Expr *e, const RefWindows *w, Buf *out)
{
    const Program *p = e->kind == EX_VAR ? e->var->state_of : NULL;

    if (p && r->cell[e->var->index] - 1 < p->state.n)
        buf_printf(out, "%s, number %lu", p->state.at[r->cell[e->var->index] - 1]->name->text, (unsigned long)r->cell[e->var->index]);
    else if (e->kind == EX_VAR)
        format_cell_shortest(out, e->var->type, r->cell[e->var->index]);
    else
        format_number_shortest(out, ref_eval(e, r->cell, w));
}

// Whether e compares its operands.
static bool is_relation(const Expr *e)
{
    if (e->kind != EX_BINARY)
        return e->kind == EX_CHAIN;
    return sm_op_info[e->op].op_class == SM_CLASS_RELATION || sm_op_info[e->op].op_class == SM_CLASS_EQUALITY;
}

// Returns an expression for the variable G in an EX_AT such as `G == 500`, with the position of its name.
static const Expr *time_of_at(Arena *arena, const Expr *at)
{
    Expr *g = ARENA_NEW(arena, Expr);

    g->kind = EX_VAR;
    g->var = at->var;
    g->span = (Span){at->span.src, at->span.at, at->window};
    return g;
}

// Adds the variables and calls anywhere in e, and the operands of comparisons.  `is_compared`: e is an operand of a comparison.
static void add_operands(Operands *o, const Expr *e, bool is_compared)
{
    if (e->kind == EX_NUMBER || expr_is_negative_number(e) || o->n == OPERANDS_MOST)
        return;
    if (e->kind == EX_AT)
        e = time_of_at(o->r->arena, e);
    if (e->kind != EX_ROLL)                           // the operands of a sampled call may have changed since they were sampled
        for (uint32_t i = 0; i < e->n; i++)
            add_operands(o, e->arg[i], is_relation(e));
    if (o->n == OPERANDS_MOST || !(e->kind == EX_VAR || e->kind == EX_CALL || e->kind == EX_ROLL || is_compared) ||
        !run_can_show(o->shown, o->n, e, OPERAND_LENGTH))
        return;
    buf_str(&o->text, o->n ? ", " : "");
    buf_put(&o->text, e->span.src->text + e->span.at, e->span.len);
    buf_str(&o->text, " = ");
    run_append_value(o->r, e, o->windows, &o->text);
    o->shown[o->n++] = e;
}

// ---- reporting ----

// Returns the text and the requirement of an assert for the end of a message: ": the valve opens (R7)"; "" if it has neither.
static const char *remark_text(const ScriptRun *r, const ScriptAssert *a)
{
    const Str text = a->remark ? a->remark->text : NULL, requirement = a->remark ? a->remark->requirement : NULL;

    return format_in(r->arena, "%s%s%s%s%s", text ? ": " : "", text ? text->text : "", requirement ? " (" : "",
                     requirement ? requirement->text : "", requirement ? ")" : "");
}

static const char *number_text(const ScriptRun *r, uint64_t n) { return format_in(r->arena, "%" PRIu64, n); }

// A message about an included file is the same for every script that includes it: adds where this script includes it.
void script_note_include(Diags *diags, const Script *s, Diag *d)
{
    for (size_t i = 0; i < s->part.n; i++)
        if (s->part.at[i].src == d->span.src)
            diag_note(diags, d, s->part.at[i].include, DIAG_note_included_here);
}

// Reports an assert that failed, with the step, the time, the state and the remark of the script.
static Diag *report_failed(const ScriptRun *r, const ScriptAssert *a)
{
    const char *step = number_text(r, r->result.steps), *g = number_text(r, r->g), *state = run_state_text(r), *remark = remark_text(r, a);

    if (a->kind == SCRIPT_FAIL)
        return diag_report(r->diags, DIAG_fail_reached, a->remark->span, step, g, state, remark);
    if (a->kind == SCRIPT_EXPECT)
        return diag_report(r->diags, DIAG_expect_failed, a->condition->span, number_text(r, a->remark->within), number_text(r, r->failed_since), step,
                           g,
                           state, remark);
    return diag_report(r->diags, DIAG_assert_failed, a->condition->span, step, g, state, remark);
}

void run_label_operands(ScriptRun *r, Diag *d, const Expr *e, const RefWindows *w)
{
    Operands o = {.r = r, .windows = w};

    buf_init(&o.text, r->arena);
    add_operands(&o, e, false);
    if (o.n)
        diag_label(r->diags, d, DIAG_label_operands, buf_text(&o.text));
}

// Reports the assert that failed, with the values of its operands and the history of the run.
void assert_report_failure(ScriptRun *r)
{
    Diag *d = report_failed(r, r->result.failed);

    run_label_operands(r, d, r->failed, &r->windows);
    script_note_include(r->diags, r->s, d);
    history_add(r, d);
}

// ---- @print ----

enum { PRINTED_MOST = 1000 };         // the most lines that @print shows in a run

static void print_values(ScriptRun *r, const ScriptAssert *a)
{
    const ScriptRemark *p = a->remark;

    if (r->prints++ >= PRINTED_MOST)
        return;
    buf_printf(&r->printed, "step %" PRIu64 " (G = %" PRIu64 ")%s%s: ", r->result.steps, r->g, p->text ? ", " : "", p->text ? p->text->text : "");
    for (size_t i = 0; i < p->printed.n; i++) {
        const Span s = p->printed.at[i]->span;
        buf_str(&r->printed, i ? ", " : "");
        buf_put(&r->printed, s.src->text + s.at, s.len);
        buf_str(&r->printed, " = ");
        run_append_value(r, p->printed.at[i], &r->windows, &r->printed);
    }
    buf_char(&r->printed, '\n');
}

const char *assert_finish_printing(ScriptRun *r)
{
    if (r->prints > PRINTED_MOST)
        buf_printf(&r->printed, "and %" PRIu64 " more lines\n", r->prints - PRINTED_MOST);
    return buf_text(&r->printed);
}

// ---- evaluating ----

// Counts a failed assert; stores the first one, which the result of the run names.
static void fail_assert(ScriptRun *r, const ScriptItem *item, const ScriptAssert *a)
{
    r->failed_asserts[item->first_assert + (size_t)(a - item->asserts.at)] = 1;
    if (r->result.failures++ == 0) {
        r->failed = a->condition ? a->condition : item->guard;
        r->failed_item = item;
        r->result.failed = a;
        r->result.failed_step = r->result.steps;
        r->result.failed_g = r->g;
    }
    if (!r->o->continues)
        run_finish(r, SCRIPT_FAILED);
}

static bool is_true(const ScriptRun *r, const ScriptAssert *a) { return ref_true(ref_eval(a->condition, r->cell, &r->windows)); }

// Counts a pending @expect as failed, because its time has passed or the run ends.
static void fail_pending(ScriptRun *r, const PendingExpect *e)
{
    r->failed_since = r->result.failures ? r->failed_since : e->since;
    fail_assert(r, e->item, &e->item->asserts.at[e->assert]);
}

// Whether no later step can meet an @expect, because the next step is after its time limit.
static bool is_expired(const ScriptRun *r, const PendingExpect *e)
{
    const uint64_t next = run_next_g(r, e->item->machine);

    return next == UINT64_MAX || next - e->since > e->item->asserts.at[e->assert].remark->within;
}

// Whether the asserts of an item are evaluated in this step: in the script of an application, asserts in the section of a machine's state are
// evaluated only in the ticks in which that machine steps.
static bool counts_now(const ScriptRun *r, const ScriptItem *item) { return item->machine == 0 || r->machine[item->machine - 1].is_due; }

// Evaluates a pending @expect.  Returns whether it stays pending.
static bool check_pending(ScriptRun *r, const PendingExpect *e)
{
    const ScriptAssert *a = &e->item->asserts.at[e->assert];

    if (is_true(r, a)) {
        r->result.asserts_passed++;
        r->is_pending[e->item->first_assert + e->assert] = 0;
        return false;
    }
    if (!is_expired(r, e))
        return true;
    fail_pending(r, e);
    r->is_pending[e->item->first_assert + e->assert] = r->ended;
    return r->ended;
}

// Evaluates the @expects that earlier steps began, in the order in which they began.
static void check_all_pending(ScriptRun *r)
{
    size_t left = 0;

    for (size_t i = 0; i < r->pending.n; i++) {
        const PendingExpect e = r->pending.at[i];
        if (r->ended || !counts_now(r, e.item) || check_pending(r, &e))
            r->pending.at[left++] = e;
    }
    r->pending.n = (uint32_t)left;
}

// Begins an @expect whose guard was true, unless it is pending.
static void begin_expect(ScriptRun *r, const NotedAssert *note)
{
    const PendingExpect e = {note->item, note->assert, r->g};
    uint8_t *is_pending = &r->is_pending[note->item->first_assert + note->assert];

    if (*is_pending || !check_pending(r, &e))
        return;
    *is_pending = 1;
    vec_push(r->arena, &r->pending, e);
}

// Evaluates an assert that was noted in this step.
static void evaluate_assert(ScriptRun *r, const NotedAssert *note)
{
    const ScriptAssert *a = &note->item->asserts.at[note->assert];

    r->evaluated[note->item->first_assert + note->assert]++;
    switch (a->kind) {
    case SCRIPT_ASSERT:
        if (is_true(r, a))
            r->result.asserts_passed++;
        else
            fail_assert(r, note->item, a);
        break;
    case SCRIPT_FAIL:   fail_assert(r, note->item, a); break;
    case SCRIPT_EXPECT: begin_expect(r, note); break;
    case SCRIPT_PRINT:  print_values(r, a); break;
    }
}

// Ends the run at a @stop.  It has failed if an @expect is still pending.
static void stop_run(ScriptRun *r)
{
    if (r->pending.n)
        fail_pending(r, &r->pending.at[0]);
    if (!r->ended)
        run_finish(r, SCRIPT_PASSED);
}

// Evaluates the pending @expects, and then the asserts noted in this step, in order.
void assert_check_step(ScriptRun *r)
{
    check_all_pending(r);
    for (size_t i = 0; i < r->noted.n && !r->ended; i++)
        if (r->noted.at[i].assert == r->noted.at[i].item->asserts.n)
            stop_run(r);
        else
            evaluate_assert(r, &r->noted.at[i]);
}

// ---- asserts never evaluated ----

// Whether it is no mistake that no step evaluates the assert: it is an @fail, or an `@assert false`, which states that its guard is never true, or an
// @print, which tests nothing.
static bool may_stay_unevaluated(const ScriptRun *r, const ScriptAssert *a)
{
    return !a->condition || (a->kind == SCRIPT_ASSERT && expr_is_constant(a->condition) && !is_true(r, a));
}

// A group of n asserts that were not evaluated for the same reason.  They share one warning, at the first assert of the group.
typedef struct Unevaluated { const ScriptAssert *first; size_t n; } Unevaluated;

// Counts the asserts of an item that were not evaluated.
static void add_unevaluated(const ScriptRun *r, const ScriptItem *item, Unevaluated *u)
{
    for (size_t k = 0; k < item->asserts.n; k++) {
        const ScriptAssert *assert = &item->asserts.at[k];
        if (r->evaluated[item->first_assert + k] || may_stay_unevaluated(r, assert))
            continue;
        u->first = u->n ? u->first : assert;
        u->n++;
    }
}

// Warns about the asserts in *u, and empties it.
static Diag *report_unevaluated_asserts(const ScriptRun *r, Unevaluated *u)
{
    Diag *d = diag_report(r->diags, DIAG_assert_never_evaluated, u->first->condition->span);

    script_note_include(r->diags, r->s, d);
    if (u->n > 1)
        diag_note(r->diags, d, (Span){0}, DIAG_note_unevaluated_too, format_in(r->arena, "%lu", (unsigned long)u->n));
    *u = (Unevaluated){NULL, 0};
    return d;
}

static void report_all_unevaluated(const ScriptRun *r)
{
    for (size_t i = 0; i < r->s->section.n; i++) {
        const ScriptSection *section = &r->s->section.at[i];
        Unevaluated u = {NULL, 0};
        for (size_t j = 0; j < section->item.n; j++) {
            const ScriptItem *item = section->item.at[j];
            add_unevaluated(r, item, &u);
            if (u.n && run_last_of_section(r, section))
                diag_label(r->diags, report_unevaluated_asserts(r, &u), r->true_in[item->number] ? DIAG_label_stopped_before : DIAG_label_never_true);
        }
        if (u.n)
            diag_label(r->diags, report_unevaluated_asserts(r, &u), DIAG_label_never_in_state, section->state->name->text);
    }
}

// Whether an item of the script checks something, rather than only printing.
static bool item_tests(const ScriptItem *item)
{
    for (size_t i = 0; i < item->asserts.n; i++)
        if (item->asserts.at[i].kind != SCRIPT_PRINT)
            return true;
    return false;
}

// Whether the script tests anything: it has an assert other than @print, or a @compare.
static bool has_assert(const Script *s)
{
    if (s->data && s->data->compare.n)
        return true;
    for (size_t i = 0; i < s->section.n; i++)
        for (size_t j = 0; j < s->section.at[i].item.n; j++)
            if (item_tests(s->section.at[i].item.at[j]))
                return true;
    return false;
}

// After a run that an assert has ended nothing is reported, because it ended before it could evaluate the other asserts.
void assert_report_unevaluated(const ScriptRun *r)
{
    if (run_is_complete(r))
        report_all_unevaluated(r);
    if (r->result.outcome == SCRIPT_PASSED && !r->o->is_compared && !r->o->requirements && !has_assert(r->s))
        diag_report(r->diags, DIAG_script_without_assert, script_stop_span(script_first_stop(r->s)));
}
