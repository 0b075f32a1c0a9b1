// SPDX-License-Identifier: Apache-2.0
#include "compiler/prove/prove_app.h"

#include <string.h>

#include "compiler/prove/prove_text.h"

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

// Returns why a proof about the machine alone proves nothing about the application: another machine writes what this one assigns.  NULL: no machine
// does.
static const char *find_other_writer(Arena *arena, const Program *p, const Member *m)
{
    for (size_t i = 0; i < p->joint->member.n; i++)
        for (size_t v = 0; v < p->var.n && &p->joint->member.at[i] != m; v++)
            if (p->var.at[v]->kind == VAR_ELEMENT && stores(&p->joint->member.at[i], p->var.at[v]) && stores(m, p->var.at[v]))
                return format_in(arena, "%s writes '%s', too, which %s assigns", p->joint->member.at[i].name->text, p->var.at[v]->name->text,
                                 m->name->text);
    return NULL;
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

// Returns the index of the machine that decides requirement i of an application; SIZE_MAX: none, and *why is the reason.
static size_t find_machine(Arena *arena, const Requirements *all, size_t i, const char **why)
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
    if (!r.why)
        r.why = find_other_writer(arena, all->program, &r.joint->member.at[r.machine]);
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

// Returns the requirements that a machine decides as requirements of that machine; NULL: it decides none of them.
static const Requirements *requirements_of(Arena *arena, const Requirements *all, const size_t *decider, size_t machine)
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
    return k.to->at.n ? k.to : NULL;
}

// ---- verdicts ----

ProveApp *prove_app_new(Arena *arena, const Requirements *what)
{
    const size_t machines = what->program->joint->member.n, n = what->at.n + 1;
    ProveApp *a = ARENA_NEW(arena, ProveApp);

    a->arena = arena;
    a->what = what;
    a->own = ARENA_ARRAY(arena, const Requirements *, machines);
    a->decider = ARENA_ARRAY(arena, size_t, n);
    a->why = ARENA_ARRAY(arena, const char *, n);
    a->of = ARENA_ARRAY(arena, const ProveResult *, machines);
    for (size_t i = 0; i < what->at.n; i++)
        a->decider[i] = find_machine(arena, what, i, &a->why[i]);
    for (size_t m = 0; m < machines; m++)
        a->own[m] = requirements_of(arena, what, a->decider, m);
    return a;
}

const ProveResult *prove_app_run(ProveApp *a, size_t machine, const ProveOptions *options)
{
    ProveOptions o = *options;

    o.delta_t = a->what->program->step;
    o.init_state = a->what->program->joint->member.at[machine].initial;
    return a->of[machine] = prove_run(a->arena, a->own[machine], &o);
}

const ProveOf *prove_app_verdict(const ProveApp *a, size_t i)
{
    size_t before = 0;

    if (a->decider[i] == SIZE_MAX || !a->of[a->decider[i]])
        return NULL;
    for (size_t n = 0; n < i; n++)
        before += a->decider[n] == a->decider[i];
    return &a->of[a->decider[i]]->of[before];
}

const ProveResult *prove_app_verdicts(const ProveApp *a)
{
    ProveResult *r = ARENA_NEW(a->arena, ProveResult);

    r->n = (uint32_t)a->what->at.n;
    r->of = ARENA_ARRAY(a->arena, ProveOf, r->n + 1);
    r->delta_t = a->what->program->step;
    for (uint32_t i = 0; i < r->n; i++) {
        const ProveOf *of = prove_app_verdict(a, i);
        r->of[i].verdict = PROVE_INTERRUPTED;
        if (of)
            r->of[i] = *of;
        if (r->of[i].verdict == PROVE_VIOLATED)
            r->of[i].verdict = PROVE_ALONE;
        r->of[i].what = &a->what->at.at[i];
    }
    for (size_t m = 0; m < a->what->program->joint->member.n; m++)
        r->bug = a->of[m] && a->of[m]->bug ? a->of[m]->bug : r->bug;
    return r;
}

void prove_app_write_reason(const ProveApp *a, size_t i, size_t indent, Buf *out)
{
    const ProveOf *of = prove_app_verdict(a, i);
    const Member *m = of ? &a->what->program->joint->member.at[a->decider[i]] : NULL;

    if (a->why[i])
        buf_printf(out, "%*sbecause %s\n", (int)indent, "", a->why[i]);
    if (!of)
        return;
    prove_write_reason(a->arena, m->program, of, indent, out);
    if (of->verdict == PROVE_VIOLATED)
        buf_printf(out, "%*sthis run is of %s alone: in the application, its inputs may never have these values\n", (int)indent, "", m->name->text);
}
