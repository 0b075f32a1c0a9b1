// SPDX-License-Identifier: Apache-2.0
#include "compiler/prove/prove_app.h"

#include <string.h>

// ---- which machine ----

// What a requirement reads.
typedef struct Reads {
    Arena *arena;
    const Joint *joint;
    const Var *g;
    size_t machine;           // the machine that stores what was read so far; SIZE_MAX: none yet
    const char *why;          // why no machine decides it; NULL: nothing speaks against `machine`
} Reads;

// Whether a machine stores the variable: an element that it assigns, its S, its T, or a local.
static bool stores(const Member *m, const Var *v)
{
    for (size_t i = 0; i < m->program->var.n; i++)
        if (m->var[i] == v)
            return v->kind != VAR_ELEMENT || m->program->var.at[i]->written || m->s == v;
    return false;
}

static void read_from(Reads *r, size_t machine)
{
    if (r->machine == SIZE_MAX)
        r->machine = machine;
    else if (r->machine != machine && !r->why)
        r->why = format_in(r->arena, "it is about two machines, %s and %s", r->joint->member.at[r->machine].name->text,
                           r->joint->member.at[machine].name->text);
}

static void note_read(Expr *e, void *context)
{
    Reads *r = context;
    size_t writers = 0, writer = 0;

    if (e->kind != EX_VAR || e->var == r->g || e->var->is_constant)
        return;
    for (size_t i = 0; i < r->joint->member.n; i++)
        if (stores(&r->joint->member.at[i], e->var)) {
            writer = i;
            writers++;
        }
    if (writers == 1)
        read_from(r, writer);
    else if (!r->why)
        r->why = format_in(r->arena, writers ? "several machines write '%s'" : "no machine writes '%s'", e->var->name->text);
}

// Returns why a step of the machine is not a tick of the application, or why its first step is not that of a proof; NULL: both are.
static const char *steps_differ(Arena *arena, const Program *p, const Member *m)
{
    if (p->step == 0)
        return "the ticks of the application are no whole units of G";
    if (m->every > 1)
        return format_in(arena, "%s does not step in every tick", m->name->text);
    if (m->mode)
        return format_in(arena, "%s steps only while '%s' enables it", m->name->text, m->mode->name->text);
    for (size_t i = 0; i < p->joint->start.n; i++)
        if (p->joint->start.at[i].var == p->g || stores(m, p->joint->start.at[i].var))
            return format_in(arena, "[start] sets '%s'", p->joint->start.at[i].var->name->text);
    return NULL;
}

size_t prove_find_machine(Arena *arena, const Requirements *all, size_t i, const char **why)
{
    const Requirement *what = &all->at.at[i];
    Expr *const condition[] = {what->a, what->b, what->c};
    Reads r = {arena, all->program->joint, all->program->g, SIZE_MAX, NULL};

    for (int k = 0; k < 3; k++) {
        if (condition[k])
            expr_walk(condition[k], note_read, &r);
        if (what->machine[k])
            read_from(&r, what->machine[k] - 1);
    }
    if (!r.why && r.machine == SIZE_MAX)
        r.why = "it reads nothing that a machine stores";
    if (!r.why)
        r.why = steps_differ(arena, all->program, &r.joint->member.at[r.machine]);
    *why = r.why;
    return r.why ? SIZE_MAX : r.machine;
}

// ---- its requirements ----

// The copy of requirements for one machine.
typedef struct Copy {
    Arena *arena;
    const Requirements *from;
    const Member *m;
    Requirements *to;
    uint32_t *window;         // by window of `from`: 1 + its index in `to`; 0: it was not copied yet
} Copy;

static Var *copy_var(const Copy *k, const Var *v)
{
    for (size_t i = 0; v && i < k->m->program->var.n; i++)
        if (k->m->var[i] == v)
            return k->m->program->var.at[i];
    return NULL;
}

static uint32_t copy_window(Copy *k, uint32_t n);

// Recursion is bounded by the depth of expressions, AST_DEPTH_MAX.
static Expr *copy_expr(Copy *k, const Expr *e)
{
    const size_t operators = e->kind == EX_CHAIN ? (e->n - 1) * sizeof(SmOperator) : 0;
    Expr *out = arena_copy(k->arena, e, sizeof *e + e->n * sizeof *e->arg + operators);

    out->define = 0;
    out->var = copy_var(k, e->var);
    for (uint32_t i = 0; i < e->n; i++)
        out->arg[i] = copy_expr(k, e->arg[i]);
    if (e->kind == EX_ROLL)
        out->window = copy_window(k, e->window);
    return out;
}

// Copies a window after those inside it.  Returns its new index.
static uint32_t copy_window(Copy *k, uint32_t n)
{
    Window w = k->from->window.at[n];

    if (k->window[n])
        return k->window[n] - 1;
    w.sample = copy_expr(k, w.sample);
    w.time = copy_var(k, w.time);
    if (w.gap)
        w.clock = copy_window(k, w.clock);
    vec_push(k->arena, &k->to->window, w);
    k->window[n] = k->to->window.n;
    return k->to->window.n - 1;
}

const Requirements *prove_of_machine(Arena *arena, const Requirements *all, const size_t *decider, size_t machine)
{
    const Member *m = &all->program->joint->member.at[machine];
    Copy k = {arena, all, m, ARENA_NEW(arena, Requirements), ARENA_ARRAY(arena, uint32_t, all->window.n + 1)};

    k.to->program = m->program;
    k.to->by_id = all->by_id;
    for (size_t i = 0; i < all->at.n; i++) {
        Requirement what = all->at.at[i];
        if (decider[i] != machine)
            continue;
        what.a = what.a ? copy_expr(&k, what.a) : NULL;
        what.b = what.b ? copy_expr(&k, what.b) : NULL;
        what.c = what.c ? copy_expr(&k, what.c) : NULL;
        memset(what.machine, 0, sizeof what.machine);
        vec_push(arena, &k.to->at, what);
    }
    return k.to;
}
