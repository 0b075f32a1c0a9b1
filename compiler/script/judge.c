// SPDX-License-Identifier: Apache-2.0
// Asserts and @stop after a step, and what to say of an assert that does not hold: the values it was made of.
#include "compiler/script/run.h"

#include <inttypes.h>
#include <string.h>

// ---- the operands of an assert ----

enum { OPERANDS_MOST = 8, OPERAND_LENGTH = 40 };      // a label stays readable

typedef struct Operands {
    Run *r;
    Buf text;                 // "valveOpen = false, tankPressure = 776"
    const Expr *seen[OPERANDS_MOST];
    size_t n;
} Operands;

static bool same_text(Span a, Span b)
{
    return a.len == b.len && memcmp(a.src->text + a.at, b.src->text + b.at, a.len) == 0;
}

static bool was_seen(const Operands *o, const Expr *e)
{
    for (size_t i = 0; i < o->n; i++)
        if (o->seen[i] == e || same_text(o->seen[i]->span, e->span))
            return true;
    return false;
}

// As the user wrote it, on one line.
static bool is_showable(Span s)
{
    return s.src && s.len > 0 && s.len <= OPERAND_LENGTH && !memchr(s.src->text + s.at, '\n', s.len);
}

static void put_operand_value(Operands *o, const Expr *e)
{
    double x;

    if (e->kind == EX_VAR) {
        format_cell_exact(&o->text, e->var->type, o->r->cell[e->var->index]);
        return;
    }
    x = ref_eval(e, o->r->cell, &o->r->windows);
    format_number_exact(&o->text, x);
}

static void add_operand(Operands *o, const Expr *e)
{
    if (o->n == OPERANDS_MOST || !is_showable(e->span) || was_seen(o, e))
        return;
    buf_str(&o->text, o->n ? ", " : "");
    buf_put(&o->text, e->span.src->text + e->span.at, e->span.len);
    buf_str(&o->text, " = ");
    put_operand_value(o, e);
    o->seen[o->n++] = e;
}

static bool is_relation(const Expr *e)
{
    if (e->kind != EX_BINARY)
        return e->kind == EX_CHAIN;
    return sm_op_info[e->op].op_class == SM_CLASS_RELATION || sm_op_info[e->op].op_class == SM_CLASS_EQUALITY;
}

// Variables and calls wherever they stand, and what a comparison compares.
static void add_operands(Operands *o, const Expr *e, bool is_compared)
{
    if (e->kind == EX_NUMBER || o->n == OPERANDS_MOST)
        return;
    if (e->kind != EX_ROLL)                           // a window's sample is not what it was
        for (uint32_t i = 0; i < e->n; i++)
            add_operands(o, e->arg[i], is_relation(e));
    if (e->kind == EX_VAR || e->kind == EX_CALL || e->kind == EX_ROLL || is_compared)
        add_operand(o, e);
}

static void report_failure(Run *r, const Expr *assert)
{
    Operands o = {.r = r};
    Diag *d = diag_report(r->diags, DIAG_assert_failed, assert->span, format_in(r->arena, "%" PRIu64, r->result.steps),
                          format_in(r->arena, "%" PRIu64, r->g), r->state->name->text);

    buf_init(&o.text, r->arena);
    add_operands(&o, assert, false);
    if (o.n)
        diag_label(r->diags, d, DIAG_label_operands, buf_text(&o.text));
}

// ---- judging ----

void judge_step(Run *r)
{
    for (size_t i = 0; i < r->notes && !r->over; i++) {
        const Noted *note = &r->noted[i];

        if (note->assert == note->item->asserts.n) {
            run_end(r, SCRIPT_PASSED);
            continue;
        }
        r->judged[note->number] = 1;
        if (ref_true(ref_eval(note->item->asserts.at[note->assert], r->cell, &r->windows))) {
            r->result.asserts_passed++;
        } else {
            report_failure(r, note->item->asserts.at[note->assert]);
            run_end(r, SCRIPT_FAILED);
        }
    }
}

// A run that ended badly has judged less than it could: it says nothing of the rest.
void judge_unjudged(const Run *r)
{
    size_t number = 0;

    if (r->result.outcome != SCRIPT_PASSED && r->result.outcome != SCRIPT_ENDLESS)
        return;
    for (size_t i = 0; i < r->s->section.n; i++)
        for (size_t j = 0; j < r->s->section.at[i].item.n; j++) {
            const ScriptItem *item = &r->s->section.at[i].item.at[j];
            for (size_t k = 0; k < item->asserts.n; k++, number++)
                if (!r->judged[number])
                    diag_report(r->diags, DIAG_assert_never_judged, item->asserts.at[k]->span);
        }
}
