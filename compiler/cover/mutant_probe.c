// SPDX-License-Identifier: Apache-2.0
// Inserts the cases of a mutant as statements of its machine, and removes them.
#include "compiler/cover/mutant_cases.h"

#include <string.h>

// A local of the probes that has the value of a call of a window function.
typedef struct Held { const Expr *roll; Var *v; } Held;

typedef struct ProbeBuilder {
    Arena *arena;
    Program *p;
    uint32_t spans;           // empty spans that are in use
    bool holds;               // statistics are first stored in locals, because facts are about variables
    VEC(Held) held;           // by the current probe
} ProbeBuilder;

// Coverage recognises statements and expressions by their spans, so each has one of its own.
static Span next_span(ProbeBuilder *k, const Source *src) { return (Span){src, k->spans++, 0}; }

// Returns the local that has the value of this call in the current probe.
static Var *hold_roll(ProbeBuilder *k, const Expr *e)
{
    Held h = {e, NULL};

    for (uint32_t i = 0; i < k->held.n; i++)
        if (k->held.at[i].roll->window == e->window && k->held.at[i].roll->stat == e->stat)
            return k->held.at[i].v;
    h.v = ARENA_NEW(k->arena, Var);
    *h.v = (Var){.kind = VAR_LOCAL, .name = k->p->var.at[0]->name, .report_name = k->p->var.at[0]->report_name, .type = SM_F64, .index = k->p->var.n,
                 .written = true, .read = true};
    vec_push(k->arena, &k->p->var, h.v);
    vec_push(k->arena, &k->held, h);
    return h.v;
}

static Expr *copy_expr(ProbeBuilder *k, const Expr *e)
{
    const Expr held = {.kind = EX_VAR, .op = SM_OP_COUNT, .var = k->holds && e->kind == EX_ROLL ? hold_roll(k, e) : NULL};

    if (held.var)
        e = &held;
    const size_t size = sizeof *e + e->n * (sizeof(Expr *) + sizeof(SmOperator));
    Expr *copy = arena_alloc(k->arena, size);

    *copy = *e;
    copy->span = next_span(k, k->p->src);
    for (uint32_t i = 0; i < e->n; i++)
        copy->arg[i] = e->kind == EX_ROLL ? e->arg[i] : copy_expr(k, e->arg[i]);
    if (e->kind == EX_CHAIN)
        memcpy(expr_ops(copy), expr_ops(e), (e->n - 1) * sizeof(SmOperator));
    return copy;
}

static Stmt *new_stmt(ProbeBuilder *k, StmtKind kind, const Stmt *beside)
{
    Stmt *s = ARENA_NEW(k->arena, Stmt);

    s->kind = kind;
    s->number = ++k->p->stmts;
    s->span = next_span(k, beside->span.src);
    s->operators = UINT32_MAX;
    s->varies = true;
    return s;
}

// Returns a variable that a probe can store in itself; NULL if the program stores none.  That changes no value, except of a large 64-bit integer
// or a NaN, in a run that has already reached the probe.
static Var *find_stored(const Program *p)
{
    for (size_t i = 0; i < p->var.n; i++)
        if (p->var.at[i]->written && !p->var.at[i]->read_only)
            return p->var.at[i];
    return NULL;
}

static Stmt *new_assignment(ProbeBuilder *k, Var *v, Expr *value, const Stmt *beside)
{
    Stmt *s = new_stmt(k, ST_ASSIGN, beside);

    s->var = v;
    s->value = value;
    return s;
}

// Returns the statements of a probe.
static Stmts build_probe(ProbeBuilder *k, MutantCase *c, Var *v, uint32_t conditions)
{
    const Expr value = {.kind = EX_VAR, .op = SM_OP_COUNT, .var = v};
    Stmt *outer = new_assignment(k, v, copy_expr(k, &value), c->stmt);
    Stmts all = {NULL, 0, 0};

    k->held.n = 0;
    c->probe = outer->number;
    for (uint32_t i = conditions; i-- > 0; ) {
        Stmt *inside = outer;
        outer = new_stmt(k, ST_IF, c->stmt);
        outer->value = copy_expr(k, c->when[i]);
        vec_push(k->arena, &outer->then, inside);
    }
    for (uint32_t i = 0; i < k->held.n; i++)
        vec_push(k->arena, &all, new_assignment(k, k->held.at[i].v, (Expr *)k->held.at[i].roll, c->stmt));
    vec_push(k->arena, &all, outer);
    return all;
}

// Returns the list that contains a statement; NULL: not this one nor one inside it.
static Stmts *find_list(Stmts *list, const Stmt *s)
{
    Stmts *found = NULL;

    for (size_t i = 0; i < list->n && !found; i++)
        if (list->at[i] == s)
            found = list;
        else if ((found = find_list(&list->at[i]->then, s)) == NULL)
            found = find_list(&list->at[i]->otherwise, s);
    return found;
}

static Stmts *find_list_of_program(const Program *p, const Stmt *s)
{
    Stmts *found = NULL;

    for (size_t i = 0; i < p->state.n; i++)
        for (int b = 0; b < BLOCK_COUNT && !found; b++)
            found = find_list(&p->state.at[i]->block[b], s);
    return found;
}

static void insert_before(ProbeBuilder *k, MutantProbes *b, const Stmt *s, Stmts probe)
{
    Stmts *list = find_list_of_program(k->p, s), now = {NULL, 0, 0};
    const SavedStmts saved = {list, *list};

    for (size_t i = 0; i < list->n; i++) {
        for (uint32_t n = 0; list->at[i] == s && n < probe.n; n++)
            vec_push(k->arena, &now, probe.at[n]);
        vec_push(k->arena, &now, list->at[i]);
    }
    vec_push(k->arena, &b->saved, saved);
    *list = now;
}

MutantProbes *mutant_probes_insert(Arena *arena, const Program *p, MutantCases *cases, bool for_facts)
{
    MutantProbes *b = ARENA_NEW(arena, MutantProbes);
    ProbeBuilder k = {.arena = arena, .p = &b->program, .holds = for_facts};
    Var *v = find_stored(p);

    b->program = *p;
    b->program.var.at = arena_copy(arena, p->var.at, p->var.n * sizeof *p->var.at);
    b->program.var.cap = p->var.n;
    if (!v)
        return NULL;
    for (uint32_t i = 0; i < cases->at.n; i++) {
        MutantCase *c = &cases->at.at[i];
        insert_before(&k, b, c->stmt, build_probe(&k, c, v, for_facts ? c->certain : c->n));
    }
    return b;
}

void mutant_probes_remove(MutantProbes *b)
{
    for (uint32_t i = b->saved.n; i-- > 0; )
        *b->saved.at[i].list = b->saved.at[i].was;
}
