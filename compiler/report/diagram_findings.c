// SPDX-License-Identifier: Apache-2.0
// Findings on a diagram.  A finding that points at a transition or its guard belongs to that transition.  Otherwise it belongs to the node
// whose section it points into.  A finding elsewhere is not shown.
#include <stdlib.h>

#include "compiler/report/diagram_model.h"

// A range of the source, and the list for findings in it.
typedef struct FindingRange { uint32_t at, end, order; DiagramFindings *finding; } FindingRange;
typedef VEC(FindingRange) FindingRanges;

// Adds the source range of a state or transition, with the list `finding` that gets the findings inside this range.
static void add_range(Arena *arena, FindingRanges *out, Span span, DiagramFindings *finding)
{
    FindingRange p = {span.at, span.at + span.len, (uint32_t)out->n, finding};

    if (span.src)
        vec_push(arena, out, p);
}

static int compare_ranges(const void *a, const void *b)
{
    const FindingRange *x = a, *y = b;

    return x->at != y->at ? (x->at < y->at ? -1 : 1) : (x->order > y->order) - (x->order < y->order);
}

static void sort_ranges(FindingRanges *p)
{
    if (p->n > 0)
        qsort(p->at, p->n, sizeof *p->at, compare_ranges);
}

// Returns the last range that begins at or before `at`, or NULL if that range ends before `at`.
static const FindingRange *find_range(const FindingRanges *p, uint32_t at)
{
    size_t low = 0, high = p->n;

    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (p->at[middle].at <= at)
            low = middle + 1;
        else
            high = middle;
    }
    return low > 0 && at < p->at[low - 1].end ? &p->at[low - 1] : NULL;
}

// ---- source ranges of nodes and transitions ----

// Returns the ranges of each transition and of its innermost guard.  A guard of several transitions belongs to the first of them.
static FindingRanges find_transition_ranges(Diagram *d)
{
    FindingRanges out = {NULL, 0, 0};
    const Stmt *last = NULL;

    for (size_t e = 0; e < d->edge.n; e++)
        for (size_t g = 0; g < d->edge.at[e].guard.n; g++) {
            DiagramGuard *guard = &d->edge.at[e].guard.at[g];
            const Transition *t = guard->transition->copy.at[0];
            const Condition *when = t->when;
            add_range(d->a->arena, &out, t->stmt->span, &guard->finding);
            if (when && when->stmt != last)
                add_range(d->a->arena, &out, when->stmt->span, &guard->finding);
            last = when ? when->stmt : NULL;
        }
    sort_ranges(&out);
    return out;
}

static FindingRanges find_node_ranges(Diagram *d)
{
    FindingRanges out = {NULL, 0, 0};

    for (size_t n = 0; n < d->nodes; n++)
        add_range(d->a->arena, &out, d->node[n].state ? written_state_range(d->node[n].state) : d->node[n].all->span, &d->node[n].finding);
    sort_ranges(&out);
    return out;
}

// Returns the width beside its label that the marks of its guards need; 0: none.
int32_t diagram_mark_width(const DiagramEdge *e)
{
    for (size_t g = 0; g < e->guard.n; g++)
        if (e->guard.at[g].finding.n > 0)
            return MARK_W + 4;
    return 0;
}

void diagram_attach_findings(Diagram *d, const Diags *findings)
{
    const FindingRanges transitions = find_transition_ranges(d), nodes = find_node_ranges(d);

    for (size_t i = 0; i < findings->list.n; i++) {
        const Diag *diag = findings->list.at[i];
        const FindingRange *at;
        if (diag->span.src != d->a->p->src)
            continue;
        at = find_range(&transitions, diag->span.at);
        if (!at)
            at = find_range(&nodes, diag->span.at);
        if (at)
            vec_push(d->a->arena, at->finding, diag);
    }
}
