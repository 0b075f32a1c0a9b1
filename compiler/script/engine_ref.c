// SPDX-License-Identifier: Apache-2.0
// The reference interpreter: runs a Program by the rules of language.md 6, one by one.  Every differential test compares other
// engines with it.  It therefore prefers plain code to speed, and shares no code with another engine.
#include "compiler/script/engine_ref.h"

#include <string.h>

#include "compiler/base/buf.h"

// Stores to a variable, and sets r->stored if it is an element.
static void store_cell(RefEngine *r, const Var *v, uint64_t cell)
{
    r->cell[v->index] = cell;
    r->stored[v->index] = v->kind == VAR_ELEMENT;
}

static RefView view_of(const RefEngine *r) { return (RefView){r->cell, &r->windows, r->state, r->last_g, r->is_first}; }

static void notify_of_step(const RefEngine *r, bool is_first)
{
    RefView view = view_of(r);

    view.is_first = is_first;
    r->observer->before_step(r->observer, &view);
}

static void notify_of_statement(const RefEngine *r, const Stmt *s)
{
    const RefView view = view_of(r);

    r->observer->before_stmt(r->observer, &view, s);
}

// Executes statements in order.  Returns the target of the transition that ended them, or NULL.
static const State *execute_statements(RefEngine *r, const Stmts *list)
{
    for (size_t i = 0; i < list->n; i++) {
        const Stmt *s = list->at[i];
        const State *target = NULL;

        if (r->observer)
            notify_of_statement(r, s);
        switch (s->kind) {
        case ST_ASSIGN:
            store_cell(r, s->var, ref_convert(s->var->type, ref_eval(s->value, r->cell, &r->windows)));
            break;
        case ST_IF:
            target = execute_statements(r, ref_true(ref_eval(s->value, r->cell, &r->windows)) ? &s->then : &s->otherwise);
            break;
        case ST_TRANSITION:
            target = s->target;
            r->transition = s;
            break;
        }
        if (target)
            return target;                            // a transition ends its block immediately
    }
    return NULL;
}

// Runs the blocks of the current state, and takes the transition if one ends them.
static void run_blocks(RefEngine *r, bool first)
{
    const State *target = NULL;

    if (first)
        target = execute_statements(r, &r->state->block[BLOCK_ENTRY]);
    if (!target)
        target = execute_statements(r, &r->state->block[BLOCK_STEP]);
    if (!target)
        return;
    execute_statements(r, &r->state->block[BLOCK_EXIT]);
    r->state = target;
    r->is_first = true;
}

// Copies the state of the machine to *out; returns `status`.
static EngineStatus fill_result(const RefEngine *r, EngineStatus status, EngineStep *out)
{
    out->status = status;
    out->next_state = r->state->number;
    out->next_is_first = r->is_first;
    memcpy(out->cell, r->cell, r->p->var.n * sizeof *r->cell);
    memcpy(out->stored, r->stored, r->p->var.n);
    return status;
}

// Whether a step may run with this G: it must be above G of the last step, and not UINT64_MAX.
static bool time_advances(const RefEngine *r, uint64_t g)
{
    return g != UINT64_MAX && !(r->has_run && g <= r->last_g);
}

static EngineStatus ref_step(Engine *e, const EngineWrite *write, uint32_t n, EngineStep *out)
{
    RefEngine *r = e->self;
    bool first = r->is_first;
    uint64_t g;

    for (uint32_t i = 0; i < n; i++)
        r->cell[write[i].var] = write[i].cell;
    memset(r->stored, 0, r->p->var.n);
    r->transition = NULL;
    g = r->cell[r->p->g->index];
    if (!time_advances(r, g))                                                       // language.md 6.3
        return fill_result(r, ENGINE_REFUSED, out);
    r->has_run = true;
    r->last_g = g;
    r->is_first = false;
    if (first) {                                                               // language.md 6.4
        store_cell(r, r->p->s, r->state->number);
        r->start = g;
    }
    store_cell(r, r->p->t, g - r->start);                                           // language.md 6.5
    ref_windows_sample(&r->windows, r->cell);                                  // language.md 6.6
    if (r->observer)
        notify_of_step(r, first);
    run_blocks(r, first);                                                      // language.md 6.7 to 6.11
    return fill_result(r, ENGINE_OK, out);
}

static EngineStatus ref_init(Engine *e, uint32_t state, EngineStep *out)
{
    RefEngine *r = e->self;

    if (state < 1 || state > r->p->state.n) {
        e->error = format_in(r->arena, "the machine has no state number %lu", (unsigned long)state);
        return out->status = ENGINE_BROKEN;
    }
    for (size_t i = 0; i < r->p->var.n; i++)
        r->cell[i] = r->p->var.at[i]->kind == VAR_LOCAL ? r->p->var.at[i]->init : 0;
    memset(r->stored, 0, r->p->var.n);
    ref_windows_clear(&r->windows);
    r->state = r->p->state.at[state - 1];
    r->cell[r->p->s->index] = state;
    r->is_first = true;
    r->has_run = false;
    return fill_result(r, ENGINE_OK, out);
}

// Returns the transition that the last step of the reference interpreter took; NULL if none.
const Stmt *engine_ref_transition(const Engine *e) { return ((const RefEngine *)e->self)->transition; }

RefView engine_ref_view(const Engine *e) { return view_of(e->self); }

void engine_ref_observe(Engine *e, RefObserver *o) { ((RefEngine *)e->self)->observer = o; }

static void copy_windows(RefWindows *to, const RefWindows *from)
{
    for (size_t i = 0; i < from->n; i++) {
        const RefWindow *f = &from->at[i];
        RefWindow *t = &to->at[i];
        memcpy(t->time ? (void *)t->time : (void *)t->slot, f->time ? (const void *)f->time : (const void *)f->slot,
               ref_window_samples(f->what) * sizeof(uint64_t));
        t->last = f->last;
        t->ran = f->ran;
        t->next = f->next;
        t->filled = f->filled;
    }
}

void engine_ref_copy(Engine *to, const Engine *from)
{
    const RefEngine *f = from->self;
    RefEngine *t = to->self;

    memcpy(t->cell, f->cell, f->p->var.n * sizeof *f->cell);
    copy_windows(&t->windows, &f->windows);
    t->state = f->state;
    t->is_first = f->is_first;
    t->has_run = f->has_run;
    t->last_g = f->last_g;
    t->start = f->start;
}

static void ref_close(Engine *e) { (void)e; }         // all its memory belongs to the arena

static Engine *open_machine(Arena *arena, const Program *p)
{
    RefEngine *r = ARENA_NEW(arena, RefEngine);

    r->arena = arena;
    r->p = p;
    r->cell = ARENA_ARRAY(arena, uint64_t, p->var.n);
    r->stored = arena_alloc(arena, p->var.n);
    ref_windows_init(&r->windows, arena, &p->window);
    r->state = p->state.at[0];
    r->engine.name = "ref";
    r->engine.program = p;
    r->engine.self = r;
    r->engine.init = ref_init;
    r->engine.step = ref_step;
    r->engine.close = ref_close;
    return &r->engine;
}

static Engine *open_app(Arena *arena, const Program *p)
{
    Engine **machine = ARENA_ARRAY(arena, Engine *, engine_machines(p));

    for (size_t i = 0; i < engine_machines(p); i++)
        machine[i] = engine_ref_open(arena, p->joint->member.at[i].program);
    return engine_app_open(arena, p, machine);
}

Engine *engine_ref_open(Arena *arena, const Program *p) { return p->joint ? open_app(arena, p) : open_machine(arena, p); }
