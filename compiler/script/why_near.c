// SPDX-License-Identifier: Apache-2.0
#include "compiler/script/why_near.h"

#include "compiler/script/why_words.h"

// ---- one condition ----

static bool is_true_for(SmOperator op, double x, double y)
{
    switch (op) {
    case SM_OP_LT: return x < y;
    case SM_OP_LE: return x <= y;
    case SM_OP_GT: return x > y;
    case SM_OP_GE: return x >= y;
    case SM_OP_EQ: return x == y;
    default: return x != y;
    }
}

// Whether the difference of two values of e measures how near they are; for states and bools it does not.
static bool is_measured(const Expr *e) { return e->kind != EX_VAR || (!e->var->state_of && e->var->type != SM_BOOL); }

bool why_gap(const WatchStmt *s, uint32_t leaf, double *gap)
{
    const Expr *e = s->node[leaf].e;
    bool truth = watch_truth(s, s->value, leaf), any = false;
    uint32_t parts;
    double x, y;

    for (; e->kind == EX_UNARY && e->op == SM_OP_NOT; e = e->arg[0])
        truth = !truth;
    parts = watch_is_relation(e) ? e->n - 1 : 0;
    *gap = 0;
    for (uint32_t i = 0; i < parts; i++) {
        const double part = is_measured(e->arg[i]) && why_operand(s, e->arg[i], &x) && why_operand(s, e->arg[i + 1], &y)
            ? (x > y ? x - y : y - x) : -1;
        if (!(part >= 0 && part - part == 0))
            return false;
        if (truth && any)
            *gap = part < *gap ? part : *gap;         // a true chain becomes false if one of its comparisons does: the smallest gap decides
        else if (truth || !is_true_for(e->kind == EX_CHAIN ? expr_ops(e)[i] : e->op, x, y))
            *gap += part;
        any = true;
    }
    return any;
}

// ---- conditions of a guard ----

// Returns the distance of condition i of a statement from the wanted truth: the number of conditions in it that must change, and their scaled gaps.
static WhyDistance node_distance(const WatchStmt *s, uint32_t i, bool wanted)
{
    const WatchNode *n = &s->node[i];
    WhyDistance d = {0, 0, 0};
    double gap;

    if (watch_truth(s, s->value, i) == wanted)
        return d;
    if (n->kind == WATCH_LEAF)
        return (WhyDistance){0, 1, why_gap(s, i, &gap) ? gap / (1 + gap) : 1};
    if (n->kind == WATCH_NOT)
        return node_distance(s, i + 1, !wanted);
    for (uint32_t k = i + 1; k < n->end; k = s->node[k].end) {
        const WhyDistance part = node_distance(s, k, wanted);
        if ((n->kind == WATCH_AND) == wanted)
            d = (WhyDistance){0, d.conditions + part.conditions, d.gap + part.gap};
        else if (k == i + 1 || why_is_nearer(&part, &d))
            d = part;
    }
    return d;
}

// ---- transitions ----

WhyDistance why_distance(const Watch *w, const WatchStmt *t)
{
    WhyDistance d = {t->step != w->step, 0, 0};

    for (const WatchStmt *s = t; s->parent; s = s->parent) {
        const WhyDistance part = s->parent->step == w->step ? node_distance(s->parent, 0, !s->in_else) : (WhyDistance){1, 0, 0};
        d = (WhyDistance){d.level + part.level, d.conditions + part.conditions, d.gap + part.gap};
    }
    return d;
}

bool why_is_nearer(const WhyDistance *a, const WhyDistance *b)
{
    if (a->level != b->level)
        return a->level < b->level;
    return a->conditions != b->conditions ? a->conditions < b->conditions : a->gap < b->gap;
}

bool why_could_take(const Watch *w, const WatchStmt *t)
{
    return t->stmt && t->stmt->kind == ST_TRANSITION && t->state == w->state && (t->block != BLOCK_ENTRY || w->is_first);
}

void why_note_near(const Watch *w, WhyNear *near)
{
    for (uint32_t i = 1; i <= w->p->stmts; i++) {
        const WatchStmt *t = &w->stmt[i];
        WhyNear *n = &near[i];
        WhyDistance d;
        if (!why_could_take(w, t))
            continue;
        d = why_distance(w, t);
        if (t->step == w->step) {
            n->taken = w->step;
            n->taken_g = w->g;
        }
        if (n->step == 0 || why_is_nearer(&d, &n->distance)) {
            n->step = w->step;
            n->g = w->g;
            n->distance = d;
        }
    }
}
