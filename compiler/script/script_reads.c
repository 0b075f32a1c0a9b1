// SPDX-License-Identifier: Apache-2.0
// Which variables a script and requirements read: a run in which these have the same values runs the script in the same way.
#include "compiler/script/script.h"

static void mark_read(Expr *e, void *context)
{
    bool *reads = context;

    if (e->kind == EX_VAR || e->kind == EX_AT)
        reads[e->var->index] = true;
}

static void mark_windows(const Windows *list, bool *reads)
{
    for (size_t i = 0; i < list->n; i++)
        expr_walk(list->at[i].sample, mark_read, reads);
}

static void mark_item(const ScriptItem *item, bool *reads)
{
    expr_walk(item->guard, mark_read, reads);
    for (size_t i = 0; i < item->inputs.n; i++)
        expr_walk(item->inputs.at[i].value, mark_read, reads);
    for (size_t i = 0; i < item->asserts.n; i++)
        if (item->asserts.at[i].condition)
            expr_walk(item->asserts.at[i].condition, mark_read, reads);
}

void script_mark_reads(const Script *s, bool *reads)
{
    mark_windows(&s->window, reads);
    for (size_t i = 0; i < s->section.n; i++)
        for (size_t k = 0; k < s->section.at[i].item.n; k++)
            mark_item(s->section.at[i].item.at[k], reads);
}

void requirements_mark_reads(const Requirements *rq, bool *reads)
{
    mark_windows(&rq->window, reads);
    for (size_t i = 0; i < rq->at.n; i++) {
        Expr *const condition[] = {rq->at.at[i].a, rq->at.at[i].b, rq->at.at[i].c};
        for (int k = 0; k < 3; k++)
            if (condition[k])
                expr_walk(condition[k], mark_read, reads);
    }
}
