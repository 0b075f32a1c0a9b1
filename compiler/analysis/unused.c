// SPDX-License-Identifier: Apache-2.0
// Elements that a machine lists and never uses, and locals that it never reads.
#include "compiler/analysis/analysis.h"

// @read_only locals are named constants, and a list of them may be longer than what one machine needs.
static void look_at_local(Diags *diags, const Var *v)
{
    if (v->read || v->read_only)
        return;
    diag_report(diags, v->written ? DIAG_unread_local : DIAG_unused_local, v->span, v->name->text);
}

// G and S have their use without being named.
static void look_at_element(Diags *diags, const Program *p, const Var *v)
{
    if (!v->read && !v->written && v != p->g && v != p->s)
        diag_report(diags, DIAG_unused_element, v->span, v->name->text);
}

void analyse_unused(Analysis *a)
{
    const Program *p = a->p;

    for (size_t i = 0; i < p->var.n; i++)
        switch (p->var.at[i]->kind) {
        case VAR_ELEMENT: look_at_element(a->diags, p, p->var.at[i]); break;
        case VAR_LOCAL:   look_at_local(a->diags, p->var.at[i]); break;
        case VAR_TIME:    break;
        }
}
