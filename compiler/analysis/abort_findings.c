// SPDX-License-Identifier: Apache-2.0
// States from which a broken sensor leaves no way to an @abort state: what the abort matrix says, one finding a state and kind.
#include "compiler/analysis/abort.h"

enum { WAYS_SHOWN = 3 };

// The transitions that fail, each with what it leads through.
static void show_ways(Analysis *a, Diag *d, const AbortRow *r, const Var *sensor)
{
    size_t shown = 0;

    for (size_t w = 0; w < r->way.n && shown < WAYS_SHOWN; w++)
        if (abort_is_sure(&r->way.at[w])) {
            const Transition *t = r->way.at[w].first;
            diag_note(a->diags, d, t->when ? t->when->stmt->span : t->stmt->span, DIAG_note_abort_way, t->to->name->text,
                      sensor->name->text);
            shown++;
        }
}

static void report_blind(Analysis *a, const AbortRow *r)
{
    Diag *d = diag_report(a->diags, DIAG_abort_blind, r->state->span, r->state->name->text, r->blind->name->text, r->blind_at);

    show_ways(a, d, r, r->blind);
    diag_note(a->diags, d, (Span){0}, DIAG_note_abort_blind_advice, r->blind->name->text);
}

static void report_single(Analysis *a, const AbortRow *r)
{
    Diag *d = diag_report(a->diags, DIAG_abort_single_sensor, r->state->span, r->state->name->text, r->single->name->text,
                          const_text(a->arena, r->stuck));

    show_ways(a, d, r, r->single);
    diag_note(a->diags, d, (Span){0}, DIAG_note_abort_single_advice);
}

void analyse_abort(Analysis *a)
{
    const AbortMatrix x = abort_matrix(a);

    for (size_t s = 0; s < x.n; s++) {
        if (x.row[s].verdict == ABORT_ONE_SENSOR && x.row[s].blind)
            report_blind(a, &x.row[s]);
        if (x.row[s].verdict == ABORT_ONE_SENSOR && x.row[s].single)
            report_single(a, &x.row[s]);
    }
}
