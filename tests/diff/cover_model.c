// SPDX-License-Identifier: Apache-2.0
#include "tests/diff/cover_model.h"

#include <string.h>

#include "compiler/script/ref.h"

typedef struct Model {
    Engine engine;
    Arena *arena;
    const Program *p;
    const Cover *c;
    uint64_t *hits;           // by place of the coverage
    uint64_t *cell;
    uint8_t *stored;
    RefWindows windows;
    const State *state;
    bool first, ran, is_sampling;
    uint64_t last_g, start;
} Model;

// ---- finding places by position ----

static uint32_t find_place(const Model *m, CoverKind kind, Span s, bool value, const State *from)
{
    for (uint32_t i = 1; i < m->c->place.n; i++) {
        const CoverPlace *p = &m->c->place.at[i];
        if (p->kind == kind && p->sampled == m->is_sampling && p->span.at == s.at && p->span.len == s.len && p->value == value && p->from == from)
            return i;
    }
    return 0;
}

static void hit(Model *m, uint32_t place) { m->hits[place]++; }

// ---- decisions ----

static double eval(const Model *m, const Expr *e) { return ref_eval(e, m->cell, &m->windows); }

static bool same_span(Span a, Span b) { return a.at == b.at && a.len == b.len; }
static bool is_call(const Expr *e) { return e->kind == EX_BINARY && same_span(e->arg[0]->span, e->arg[1]->span); }

// A walk over the conditions of a decision, from left to right.
typedef struct Walk {
    int32_t flip;             // the number of the condition that has the opposite value; -1: none
    int32_t n;                // how many conditions have been visited
    bool value;               // the value of the last one, not flipped
    int32_t wanted;           // the number of the condition that `at` and `link` describe
    const Expr *at;           // the expression of that condition, or the chain that contains it
    uint32_t link;            // the number of that condition in the chain, from 1
} Walk;

static bool condition(Walk *w, const Expr *e, uint32_t link, bool value)
{
    if (w->n == w->wanted) {
        w->at = e;
        w->link = link;
        w->value = value;
    }
    return (w->n++ == w->flip) != value;
}

static bool relation(SmOperator op, double a, double b)
{
    switch (op) {
    case SM_OP_LT: return a < b;
    case SM_OP_LE: return a <= b;
    case SM_OP_GT: return a > b;
    default: return a >= b;
    }
}

static bool walk(const Model *m, Walk *w, const Expr *e)
{
    bool a = true, b;

    if (e->kind == EX_CHAIN) {
        for (uint32_t i = 1; i < e->n; i++) {
            b = condition(w, e, i, relation(expr_ops(e)[i - 1], eval(m, e->arg[i - 1]), eval(m, e->arg[i])));
            a = a && b;
        }
        return a;
    }
    if (e->kind == EX_UNARY && e->op == SM_OP_NOT)
        return !walk(m, w, e->arg[0]);
    if (e->kind == EX_BINARY && (e->op == SM_OP_AND || e->op == SM_OP_OR) && !is_call(e)) {
        a = walk(m, w, e->arg[0]);
        b = walk(m, w, e->arg[1]);
        return e->op == SM_OP_AND ? a && b : a || b;
    }
    return condition(w, e, 0, ref_true(eval(m, e)));
}

static void scan(Model *m, const Expr *e, const Expr *root, bool decides);

// Records the windows that e reads, and the decisions in it.  e is an operand of a condition that decides.
static void scan_condition(Model *m, const Walk *w, const Expr *root, bool decides)
{
    const Expr *e = w->at;

    if (w->link) {
        scan(m, e->arg[w->link], root, decides);
        if (w->link == 1)
            scan(m, e->arg[0], root, decides);
    } else if (!is_call(e)) {
        if (e->kind == EX_BINARY && e->op >= SM_OP_EQ && e->op <= SM_OP_GE)
            for (uint32_t i = 0; i < e->n; i++)
                scan(m, e->arg[i], root, decides);
        else
            scan(m, e, root, decides);
    }
}

static void decide(Model *m, const Expr *root)
{
    Walk all = {-1, 0, false, -1, NULL, 0};
    const bool result = walk(m, &all, root);
    const uint32_t place = find_place(m, COVER_GUARD, root->span, true, NULL);

    hit(m, place + !result);
    for (int32_t c = 0; c < all.n; c++) {
        Walk other = {c, 0, false, c, NULL, 0};
        const bool decides = walk(m, &other, root) != result;
        if (decides)
            hit(m, place + 2 + 2 * (uint32_t)c + !other.value);
        scan_condition(m, &other, root, decides);
    }
}

static void note_window(Model *m, const Expr *e, const Expr *root)
{
    const RefWindow *w = &m->windows.at[e->window];
    const uint32_t never = SM_STATS_OF_TIMES | 1u << SM_STAT_OLDEST | 1u << SM_STAT_NEWEST;
    const bool inside = !root || (e->span.at >= root->span.at && e->span.at + e->span.len <= root->span.at + root->span.len);

    if (w->what->size < 2 || 1u << e->stat & never || w->filled < w->what->size)
        return;
    for (uint32_t i = 1; i < m->c->place.n; i++) {
        const CoverPlace *p = &m->c->place.at[i];
        if (p->kind == COVER_WINDOW && same_span(p->span, e->span) && p->where.at == (inside ? e->span.at : root->span.at)) {
            hit(m, i);
            return;
        }
    }
}

static void scan(Model *m, const Expr *e, const Expr *root, bool decides)
{
    const bool logic = e->kind == EX_CHAIN || (e->kind == EX_UNARY && e->op == SM_OP_NOT)
                    || (e->kind == EX_BINARY && (e->op == SM_OP_AND || e->op == SM_OP_OR || (e->op >= SM_OP_EQ && e->op <= SM_OP_GE)));

    if (logic)
        decide(m, e);
    else if (e->kind == EX_ROLL && decides)
        note_window(m, e, root);
    else if (e->kind != EX_ROLL)
        for (uint32_t i = 0; i < e->n; i++)
            scan(m, e->arg[i], root, decides);
}

// ---- a step ----

static void store(Model *m, const Var *v, uint64_t cell)
{
    m->cell[v->index] = cell;
    m->stored[v->index] = v->kind == VAR_ELEMENT;
}

static const State *execute(Model *m, const Stmts *list)
{
    for (size_t i = 0; i < list->n; i++) {
        const Stmt *s = list->at[i];
        const State *target = NULL;
        hit(m, find_place(m, COVER_STATEMENT, s->span, false, NULL));
        switch (s->kind) {
        case ST_ASSIGN:
            scan(m, s->value, NULL, true);
            store(m, s->var, ref_convert(s->var->type, eval(m, s->value)));
            break;
        case ST_IF:
            decide(m, s->value);
            target = execute(m, ref_true(eval(m, s->value)) ? &s->then : &s->otherwise);
            break;
        case ST_TRANSITION:
            hit(m, find_place(m, COVER_TRANSITION, s->span, false, m->state));
            target = s->target;
            break;
        }
        if (target)
            return target;
    }
    return NULL;
}

static void note_samples(Model *m)
{
    m->is_sampling = true;
    for (size_t i = 0; i < m->p->window.n; i++) {
        const Window *w = &m->p->window.at[i];
        const Expr *e = w->sample;
        while (e->kind == EX_UNARY && e->op == SM_OP_NOT && same_span(e->span, w->span))
            e = e->arg[0];
        if (e != w->sample)
            decide(m, e);
        else
            scan(m, e, NULL, false);
    }
    m->is_sampling = false;
}

static EngineStatus answer(const Model *m, EngineStatus status, EngineStep *out)
{
    out->status = status;
    out->next_state = m->state->number;
    out->next_is_first = m->first;
    memcpy(out->cell, m->cell, m->p->var.n * sizeof *m->cell);
    memcpy(out->stored, m->stored, m->p->var.n);
    return status;
}

// A parameter has its default, the lowest or the highest value of its range in the first step of a run.
static void note_parameters(Model *m)
{
    for (uint32_t i = 1; i < m->c->place.n; i++) {
        const CoverPlace *p = &m->c->place.at[i];
        if (p->kind == COVER_PARAMETER && m->cell[p->parameter->index] == p->cell)
            m->hits[i]++;
    }
}

static EngineStatus model_step(Engine *e, const EngineWrite *write, uint32_t n, EngineStep *out)
{
    Model *m = e->self;
    const State *target = NULL;
    const bool first = m->first;
    uint64_t g;

    for (uint32_t i = 0; i < n; i++)
        m->cell[write[i].var] = write[i].cell;
    memset(m->stored, 0, m->p->var.n);
    g = m->cell[m->p->g->index];
    if (g == UINT64_MAX || (m->ran && g <= m->last_g))
        return answer(m, ENGINE_REFUSED, out);
    if (!m->ran)
        note_parameters(m);
    m->ran = true;
    m->last_g = g;
    m->first = false;
    if (first) {
        store(m, m->p->s, m->state->number);
        m->start = g;
        hit(m, find_place(m, COVER_STATE, m->state->span, true, m->state));
    }
    store(m, m->p->t, g - m->start);
    ref_windows_sample(&m->windows, m->cell);
    note_samples(m);
    if (first)
        target = execute(m, &m->state->block[BLOCK_ENTRY]);
    if (!target)
        target = execute(m, &m->state->block[BLOCK_STEP]);
    if (target) {
        execute(m, &m->state->block[BLOCK_EXIT]);
        hit(m, find_place(m, COVER_STATE, m->state->span, false, m->state));
        m->state = target;
        m->first = true;
    }
    return answer(m, ENGINE_OK, out);
}

static EngineStatus model_init(Engine *e, uint32_t state, EngineStep *out)
{
    Model *m = e->self;

    for (size_t i = 0; i < m->p->var.n; i++)
        m->cell[i] = m->p->var.at[i]->kind == VAR_LOCAL ? m->p->var.at[i]->init : 0;
    memset(m->stored, 0, m->p->var.n);
    ref_windows_clear(&m->windows);
    m->state = m->p->state.at[state - 1];
    m->cell[m->p->s->index] = state;
    m->first = true;
    m->ran = false;
    return answer(m, ENGINE_OK, out);
}

static void model_close(Engine *e) { (void)e; }

Engine *cover_model_open(Arena *arena, const Program *p, const Cover *c)
{
    Model *m = ARENA_NEW(arena, Model);

    m->arena = arena;
    m->p = p;
    m->c = c;
    m->hits = ARENA_ARRAY(arena, uint64_t, c->place.n);
    m->cell = ARENA_ARRAY(arena, uint64_t, p->var.n);
    m->stored = arena_alloc(arena, p->var.n);
    ref_windows_init(&m->windows, arena, &p->window);
    m->engine = (Engine){.name = "cover model", .program = p, .self = m, .init = model_init, .step = model_step, .close = model_close};
    return &m->engine;
}

// ---- comparing ----

// Whether a place shares its counts with the place of an equal window.  Then only whether it is covered is compared.
static bool is_shared(const Cover *c, uint32_t place)
{
    for (uint32_t i = 0; i < c->shared.n; i++)
        if (place - c->shared.at[i].to < c->shared.at[i].n || place - c->shared.at[i].from < c->shared.at[i].n)
            return true;
    return false;
}

const char *cover_model_compare(const Engine *model, const Cover *c, Arena *arena)
{
    const Model *m = model->self;

    for (uint32_t i = 1; i < c->place.n; i++) {
        const CoverPlace *p = &c->place.at[i];
        const bool counts = p->kind != COVER_CONDITION && p->kind != COVER_WINDOW && !is_shared(c, i);
        if (counts ? m->hits[i] != c->hits[i] : !m->hits[i] != !c->hits[i])
            return format_in(arena, "coverage of %s at byte %lu+%lu, value %d: counted %llu, by definition %llu", cover_kind_name[p->kind],
                             (unsigned long)p->span.at, (unsigned long)p->span.len, p->value, (unsigned long long)c->hits[i], (unsigned long long)m->hits[i]);
        if (p->impossible && m->hits[i])
            return format_in(arena, "coverage of %s at byte %lu: impossible (%s), but it happened", cover_kind_name[p->kind], (unsigned long)p->span.at, p->impossible);
    }
    return NULL;
}
