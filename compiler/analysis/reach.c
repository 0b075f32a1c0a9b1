// SPDX-License-Identifier: Apache-2.0
// States that no transition can reach.  Only the first on each path is reported: the states reachable only from it follow from
// it.
#include "compiler/analysis/reach.h"
#include "stdlib/convert.h"

enum { NAMED = 3 };                   // followers, or transitions, named in notes

typedef struct Reach {
    Structure *k;
    const Transitions *t;             // the transitions of a state are adjacent
    size_t *first;                    // by state (from 0), plus one: index of its first transition
    uint32_t *waiting;                // a stack of states
    size_t n;
    bool *reached, *known;            // by state: it is reachable; nothing more is to be reported about it
} Reach;

typedef bool (*Follow)(const Reach *r, const Transition *t);

static bool is_made(const Reach *r, const Transition *t) { return r->k->why[t->stmt->number] == 0; }
static bool any(const Reach *r, const Transition *t) { return r != NULL && t != NULL; }

static void push(Reach *r, bool *seen, uint32_t s)
{
    if (seen[s])
        return;
    seen[s] = true;
    r->waiting[r->n++] = s;
}

static void spread(Reach *r, bool *seen, Follow follow)
{
    while (r->n > 0) {
        const uint32_t s = r->waiting[--r->n];
        for (size_t i = r->first[s]; i < r->first[s + 1]; i++)
            if (follow(r, &r->t->at[i]))
                push(r, seen, r->t->at[i].to->number - 1);
    }
}

static void find_reached(Reach *r)
{
    push(r, r->reached, 0);
    spread(r, r->reached, is_made);
    for (size_t s = 0; s < r->k->a->p->state.n; s++)
        r->known[s] = r->reached[s];
}

// ---- explained by other findings ----

static const Dead *dead_at(const Reach *r, const Transition *t)
{
    const uint32_t why = r->k->why[t->stmt->number];

    return why != 0 && r->reached[t->from->number - 1] ? &r->k->dead.at[why - 1] : NULL;
}

// Marks states after transitions that another finding, or a switch, explains.
static void spread_explained(Reach *r)
{
    for (size_t i = 0; i < r->t->n; i++) {
        const Transition *t = &r->t->at[i];
        const Dead *d = dead_at(r, t);
        if (!d || d->cause == CAUSE_NEVER || r->known[t->to->number - 1])
            continue;
        if (d->told)
            diag_note(r->k->a->diags, d->told, t->to->span, DIAG_note_so_unreachable, t->to->name->text);
        push(r, r->known, t->to->number - 1);
    }
    spread(r, r->known, any);
}

// ---- reported ----

static void note_followers(Reach *r, Diag *d, uint32_t state)
{
    const Program *p = r->k->a->p;
    unsigned named = 0;

    for (size_t i = r->first[state]; i < r->first[state + 1] && named < NAMED; i++) {
        const State *to = r->t->at[i].to;
        if (r->known[to->number - 1] || to == p->state.at[state])
            continue;
        diag_note(r->k->a->diags, d, to->span, DIAG_note_so_unreachable, to->name->text);
        named++;
    }
}

static void tell_state(Reach *r, uint32_t state, DiagCode code, Diag **out)
{
    const State *s = r->k->a->p->state.at[state];

    *out = diag_report(r->k->a->diags, code, s->span, s->name->text);
    note_followers(r, *out, state);
    push(r, r->known, state);
    spread(r, r->known, any);
}

// States whose every incoming guard is always false.  Reporting the state suppresses the finding on the guard.
static void tell_impossible(Reach *r)
{
    Diag **told = ARENA_ARRAY(r->k->a->arena, Diag *, r->k->a->p->state.n);

    for (size_t i = 0; i < r->t->n; i++) {
        const Transition *t = &r->t->at[i];
        const uint32_t to = t->to->number - 1;
        Dead *d = (Dead *)dead_at(r, t);
        if (!d || d->cause != CAUSE_NEVER)
            continue;
        if (!r->known[to])
            tell_state(r, to, DIAG_impossible_state, &told[to]);
        if (!told[to])
            continue;
        note_never(r->k, told[to], d);
        d->folded = true;
    }
}

// Postorder of the remaining states.  The last of it leads to others and can be reached only from its own cycle.
static size_t order_left(const Reach *r, uint32_t *order)
{
    const size_t states = r->k->a->p->state.n;
    uint32_t *stack = ARENA_ARRAY(r->k->a->arena, uint32_t, states);
    size_t *next = ARENA_ARRAY(r->k->a->arena, size_t, states);
    size_t n = 0, depth = 0;

    for (uint32_t s = 0; s < states; s++) {
        if (r->known[s] || next[s])
            continue;
        for (stack[depth++] = s, next[s] = r->first[s] + 1; depth > 0;) {
            const uint32_t top = stack[depth - 1];
            uint32_t to;
            if (next[top] > r->first[top + 1]) {
                order[n++] = top;
                depth--;
                continue;
            }
            to = r->t->at[next[top]++ - 1].to->number - 1;
            if (!r->known[to] && !next[to]) {
                next[to] = r->first[to] + 1;
                stack[depth++] = to;
            }
        }
    }
    return n;
}

static void tell_left(Reach *r)
{
    uint32_t *order = ARENA_ARRAY(r->k->a->arena, uint32_t, r->k->a->p->state.n);
    Diag *d;

    for (size_t n = order_left(r, order); n > 0; n--)
        if (!r->known[order[n - 1]])
            tell_state(r, order[n - 1], DIAG_unreachable_state, &d);
}

static void tell_states(Structure *k)
{
    const Program *p = k->a->p;
    Arena *arena = k->a->arena;
    Reach r = {.k = k, .t = &k->a->transition};
    size_t i = 0;

    r.first = ARENA_ARRAY(arena, size_t, p->state.n + 1);
    r.waiting = ARENA_ARRAY(arena, uint32_t, p->state.n);
    r.reached = ARENA_ARRAY(arena, bool, p->state.n);
    r.known = ARENA_ARRAY(arena, bool, p->state.n);
    for (uint32_t s = 0; s < p->state.n; r.first[++s] = i)
        while (i < r.t->n && r.t->at[i].from->number == s + 1)
            i++;
    find_reached(&r);
    spread_explained(&r);
    tell_impossible(&r);
    tell_left(&r);
}

// ---- labels ----

static void look_for_empty(Diags *diags, const State *s)
{
    static const char *const label[BLOCK_COUNT] = {".entry", ".step", ".exit"};

    for (int b = 0; b < BLOCK_COUNT; b++)
        if (s->block_span[b].src && s->block[b].n == 0)
            diag_report(diags, DIAG_empty_block, s->block_span[b], label[b], s->name->text);
}

// ---- entry points ----

static void note_change(const Stmt *s, void *context)
{
    Structure *k = context;
    const StmtFact *f = &k->a->stmt[s->number];
    const Var *v = s->var;
    double x;

    if (s->kind != ST_ASSIGN || v->kind != VAR_LOCAL || !f->reached)
        return;
    if (fact_is_number(fact_convert(f->value, v->type), &x) && x == sm_cell_to_f64(v->type, v->init))
        k->stored[v->index] |= STORED_INITIAL;
    else
        k->stored[v->index] |= STORED_OTHER;
}

static void prepare(Structure *k)
{
    const Program *p = k->a->p;
    Arena *arena = k->a->arena;

    k->why = ARENA_ARRAY(arena, uint32_t, p->stmts + 1u);
    k->order = ARENA_ARRAY(arena, uint32_t, p->stmts + 1u);
    k->written = ARENA_ARRAY(arena, uint32_t, p->var.n);
    k->stored = ARENA_ARRAY(arena, uint8_t, p->var.n);
    k->stamp = ARENA_ARRAY(arena, uint32_t, p->var.n);
    each_stmt(p, note_change, k);
}

void analyse_reach(Analysis *a)
{
    Structure k = {.a = a};

    prepare(&k);
    find_dead(&k);
    tell_states(&k);
    for (size_t i = 0; i < k.dead.n; i++)
        if (k.dead.at[i].cause == CAUSE_NEVER && !k.dead.at[i].folded)
            report_never(&k, &k.dead.at[i]);
    for (size_t s = 0; s < a->p->state.n; s++)
        look_for_empty(a->diags, a->p->state.at[s]);
}
