// SPDX-License-Identifier: Apache-2.0
// Evaluates asserts and @stop after a step, and reports a false assert with the values of its operands.
#include "compiler/script/script_run.h"

#include <inttypes.h>
#include <string.h>

// ---- the operands of an assert ----

enum { OPERANDS_MOST = 8, OPERAND_LENGTH = 40 };      // limits of a label: number of operands, and length of the source of one

// The operands of an assert with their values, collected for a label.
typedef struct Operands {
    ScriptRun *r;
    Buf text;                 // "valveOpen = false, tankPressure = 776"
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
void run_append_value(ScriptRun *r, const Expr *e, Buf *out)
{
    const Program *p = r->s->program;

    if (e->kind == EX_VAR && e->var == p->s && r->cell[e->var->index] - 1 < p->state.n)
        buf_printf(out, "%s, number %lu", p->state.at[r->cell[e->var->index] - 1]->name->text, (unsigned long)r->cell[e->var->index]);
    else if (e->kind == EX_VAR)
        format_cell_shortest(out, e->var->type, r->cell[e->var->index]);
    else
        format_number_shortest(out, ref_eval(e, r->cell, &r->windows));
}

// Whether e compares its operands.
static bool is_relation(const Expr *e)
{
    if (e->kind != EX_BINARY)
        return e->kind == EX_CHAIN;
    return sm_op_info[e->op].op_class == SM_CLASS_RELATION || sm_op_info[e->op].op_class == SM_CLASS_EQUALITY;
}

// Adds the variables and calls anywhere in e, and the operands of comparisons.  `is_compared`: e is an operand of a comparison.
static void add_operands(Operands *o, const Expr *e, bool is_compared)
{
    if (e->kind == EX_NUMBER || o->n == OPERANDS_MOST)
        return;
    if (e->kind != EX_ROLL)                           // its operands may have changed since they were sampled
        for (uint32_t i = 0; i < e->n; i++)
            add_operands(o, e->arg[i], is_relation(e));
    if (o->n == OPERANDS_MOST || !(e->kind == EX_VAR || e->kind == EX_CALL || e->kind == EX_ROLL || is_compared) ||
        !run_can_show(o->shown, o->n, e, OPERAND_LENGTH))
        return;
    buf_str(&o->text, o->n ? ", " : "");
    buf_put(&o->text, e->span.src->text + e->span.at, e->span.len);
    buf_str(&o->text, " = ");
    run_append_value(o->r, e, &o->text);
    o->shown[o->n++] = e;
}

// Reports the assert that failed, with the values of its operands and the history of the run.
void assert_report_failure(ScriptRun *r)
{
    const Expr *assert = r->failed;
    Operands o = {.r = r};
    Diag *d = diag_report(r->diags, DIAG_assert_failed, assert->span, format_in(r->arena, "%" PRIu64, r->result.steps),
                          format_in(r->arena, "%" PRIu64, r->g), r->state->name->text);

    buf_init(&o.text, r->arena);
    add_operands(&o, assert, false);
    if (o.n)
        diag_label(r->diags, d, DIAG_label_operands, buf_text(&o.text));
    history_add(r, d);
}

// ---- evaluating ----

// Evaluates the asserts noted in this step, in order.
void assert_check_step(ScriptRun *r)
{
    for (size_t i = 0; i < r->noted.n && !r->ended; i++) {
        const NotedAssert *note = &r->noted.at[i];

        if (note->assert == note->item->asserts.n) {
            run_finish(r, SCRIPT_PASSED);
            continue;
        }
        r->evaluated[note->item->first_assert + note->assert] = 1;
        if (ref_true(ref_eval(note->item->asserts.at[note->assert], r->cell, &r->windows))) {
            r->result.asserts_passed++;
        } else {
            r->failed = note->item->asserts.at[note->assert];
            r->failed_item = note->item;
            run_finish(r, SCRIPT_FAILED);
        }
    }
}

// ---- asserts never evaluated ----

// Whether the assert is `@assert false`.  It states that its guard is never true, so the author intends that no step evaluates it.
static bool is_assert_false(const ScriptRun *r, const Expr *assert)
{
    return expr_is_constant(assert) && !ref_true(ref_eval(assert, r->cell, &r->windows));
}

// Asserts that were not evaluated for the same reason.  They share one warning, at the first of them.
typedef struct Unevaluated { const Expr *first; size_t n; } Unevaluated;

// Counts the asserts of an item that were not evaluated.
static void add_unevaluated(const ScriptRun *r, const ScriptItem *item, Unevaluated *u)
{
    for (size_t k = 0; k < item->asserts.n; k++) {
        const Expr *assert = item->asserts.at[k];
        if (r->evaluated[item->first_assert + k] || is_assert_false(r, assert))
            continue;
        u->first = u->n ? u->first : assert;
        u->n++;
    }
}

// Warns about the asserts in *u, and empties it.
static Diag *report_unevaluated(const ScriptRun *r, Unevaluated *u)
{
    Diag *d = diag_report(r->diags, DIAG_assert_never_evaluated, u->first->span);

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
            if (u.n && r->ran[i])
                diag_label(r->diags, report_unevaluated(r, &u), r->was_true[item->number] ? DIAG_label_stopped_before : DIAG_label_never_true);
        }
        if (u.n)
            diag_label(r->diags, report_unevaluated(r, &u), DIAG_label_never_in_state, section->state->name->text);
    }
}

static bool has_assert(const Script *s)
{
    for (size_t i = 0; i < s->section.n; i++)
        for (size_t j = 0; j < s->section.at[i].item.n; j++)
            if (s->section.at[i].item.at[j]->asserts.n)
                return true;
    return false;
}

// A run that failed has evaluated fewer asserts than it could, so the others are not reported.
void assert_report_unevaluated(const ScriptRun *r)
{
    if (r->result.outcome == SCRIPT_PASSED || r->result.outcome == SCRIPT_ENDLESS)
        report_all_unevaluated(r);
    if (r->result.outcome == SCRIPT_PASSED && !r->o->is_compared && !has_assert(r->s))
        diag_report(r->diags, DIAG_script_without_assert, script_first_stop(r->s)->stop_span);
}
