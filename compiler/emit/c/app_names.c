// SPDX-License-Identifier: Apache-2.0
// Checks that each C name of an application denotes only one thing.  Covered: names that the application's files declare for each other,
// names that the user writes, and the names in the application's own file.  Names without an underscore cannot clash.
#include "compiler/emit/c/app.h"

#include <string.h>

#include "compiler/emit/c/unit.h"

typedef struct CNameOwner { const char *what; Span span; } CNameOwner;

typedef struct Claims {
    Arena *arena;
    Diags *diags;
    const App *app;
    StrPool pool;
    Map owner;                // of a name
    bool clash;
} Claims;

static void claim(Claims *k, const char *name, const CNameOwner *o)
{
    Str key = str_c(&k->pool, name);
    const CNameOwner *first = map_find(&k->owner, key);
    Diag *d;

    if (!first)
        map_put(&k->owner, key, (void *)(size_t)o);
    if (!first || first == o)
        return;
    d = diag_report(k->diags, DIAG_app_symbol_twice, o->span, name, first->what, o->what);
    if (first->span.src)
        diag_note(k->diags, d, first->span, DIAG_note_declared_here, first->what);
    k->clash = true;
}

static const CNameOwner *owner(Claims *k, Span span, const char *what)
{
    CNameOwner *o = ARENA_NEW(k->arena, CNameOwner);

    o->what = what;
    o->span = span;
    return o;
}

static void claim_all(Claims *k, const char *before, const char *const *ends, size_t n, const CNameOwner *o)
{
    for (size_t i = 0; i < n; i++)
        claim(k, format_in(k->arena, "%s%s", before, ends[i]), o);
}

#define CLAIM_ALL(k, before, ends, o) claim_all(k, before, ends, sizeof (ends) / sizeof *(ends), o)

static void claim_vector(Claims *k)
{
    static const char *const ends[] = {"_sv", "_vector", "_layout", "_element", "_names"};
    static const char *const counts[] = {"_ELEMENTS", "_REGIONS"};
    const StateVec *sv = k->app->sv;
    const CNameOwner *o = owner(k, (Span){0}, format_in(k->arena, "the state vector '%s'", sv->name->text));
    CUnit u;
    CVectorNames n;

    c_vector_names(k->arena, sv, &u);
    names_runtime(k->arena, &u.names, sv, &n);
    CLAIM_ALL(k, u.names.prefix, ends, o);
    CLAIM_ALL(k, u.names.macro, counts, o);
    claim(k, u.names.sv_type, o);
    for (size_t i = 0; i < sv->element.n; i++) {
        const CNameOwner *e = owner(k, sv->element.at[i]->span, format_in(k->arena, "element '%s'", sv->element.at[i]->name->text));
        claim(k, n.getter[i], e);
        claim(k, n.setter[i], e);
        claim(k, n.element[i], e);
    }
    for (size_t i = 0; i < sv->region.n; i++) {
        const CNameOwner *r = owner(k, sv->region.at[i]->span, format_in(k->arena, "region '%s'", sv->region.at[i]->name->text));
        claim(k, n.region[i], r);
        claim(k, n.reader[i], r);
        claim(k, n.writer[i], r);
    }
}

static void claim_machine(Claims *k, const Program *p)
{
    static const char *const functions[] = {"_init", "_step", "_state", "_T", "_state_name", "_machine"};
    static const char *const types[] = {"", "Status", "Stored"};
    static const char *const numbers[] = {"_OK", "_REFUSED", "_NO_STATE", "_UNFIT", "_INITIAL_STATE", "_STATES"};
    const char *prefix = c_identifier(k->arena, p->name->text, p->name->len);
    const CNameOwner *o = owner(k, p->state.n ? p->state.at[0]->span : (Span){0}, format_in(k->arena, "machine '%s'", p->name->text));
    CUnit u;

    c_vector_names(k->arena, p->sv, &u);
    CLAIM_ALL(k, prefix, functions, o);
    CLAIM_ALL(k, c_machine_type(k->arena, prefix, u.names.sv_type), types, o);
    CLAIM_ALL(k, c_macro_name(k->arena, prefix), numbers, o);
}

static void claim_task(Claims *k, const AppTask *t)
{
    static const char *const machines[] = {"Self", "Copy", "Image", "Memory"};
    const char *n = t->name->text;
    const CNameOwner *o = owner(k, t->span, format_in(k->arena, "task '%s'", n));

    if (t->kind == AST_TASK_machine)
        CLAIM_ALL(k, n, machines, o);
    if (t->kind != AST_TASK_task)
        return;
    claim(k, format_in(k->arena, "%s_step", n), o);
    claim(k, format_in(k->arena, "%sStep", n), o);
    if (t->has_init) {
        claim(k, format_in(k->arena, "%s_init", n), o);
        claim(k, format_in(k->arena, "%sInit", n), o);
    }
    if (t->has_safe) {
        claim(k, format_in(k->arena, "%s_safe", n), o);
        claim(k, format_in(k->arena, "%sSafe", n), o);
    }
}

// Claims the names of machines emitted as C, once for each file.
static void claim_machines(Claims *k)
{
    Map seen = {k->arena, NULL, NULL, 0, 0};

    for (size_t i = 0; i < k->app->machine.n; i++) {
        const AppMachine *m = k->app->machine.at[i];
        if (!m->bytecode && !map_find(&seen, m->program->name)) {
            map_put(&seen, m->program->name, k);
            claim_machine(k, m->program);
        }
    }
}

bool emit_c_app_names(Arena *arena, Diags *diags, const App *app)
{
    static const char *const pins[] = {"_inputs", "_outputs"};
    Claims k;
    const char *name = app->name->text;

    memset(&k, 0, sizeof k);
    k.arena = k.owner.arena = arena;
    k.diags = diags;
    k.app = app;
    str_pool_init(&k.pool, arena);
    claim_vector(&k);
    claim_machines(&k);
    if (app->pins)
        CLAIM_ALL(&k, c_identifier(arena, app->io_name->text, app->io_name->len), pins,
                  owner(&k, (Span){app->pins->src, 0, 0}, "the pins"));
    claim(&k, format_in(arena, "%s_app", c_identifier(arena, name, strlen(name))),
          owner(&k, (Span){app->src, 0, 0}, "the application"));
    for (size_t i = 0; i < app->task.n; i++)
        claim_task(&k, app->task.at[i]);
    return !k.clash;
}
