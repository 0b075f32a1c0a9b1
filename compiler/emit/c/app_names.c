// SPDX-License-Identifier: Apache-2.0
// Checks that each C name of an application denotes only one thing.  The check covers the names that the application's files declare for each
// other, names that the user writes, and those static names of the application's own file that begin with the name of a task.  The other
// static names of that file, such as `executors`, are fixed.  They need no claim: they have no underscore and no capital at the start, and do
// not end like a name that claim_task claims.
#include "compiler/emit/c/emit_app.h"

#include <string.h>

#include "compiler/emit/c/unit.h"

// What a C name denotes, for the diagnostic: "task 'radio'".
typedef struct CNameOwner { const char *what; Span span; } CNameOwner;

typedef struct CNameClaims {
    Arena *arena;
    Diags *diags;
    const App *app;
    StrPool pool;
    Map owner;                // from a C name to its first CNameOwner
    bool clash;               // two owners claimed the same name
} CNameClaims;

// Records that `o` has a name.  Reports a clash if another owner has it.
static void claim_name(CNameClaims *k, const char *name, const CNameOwner *o)
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

static const CNameOwner *new_owner(CNameClaims *k, Span span, const char *what)
{
    CNameOwner *o = ARENA_NEW(k->arena, CNameOwner);

    o->what = what;
    o->span = span;
    return o;
}

// Claims `before` followed by each of n ends.
static void claim_names(CNameClaims *k, const char *before, const char *const *ends, size_t n, const CNameOwner *o)
{
    for (size_t i = 0; i < n; i++)
        claim_name(k, format_in(k->arena, "%s%s", before, ends[i]), o);
}

#define CLAIM_NAMES(k, before, ends, o) claim_names(k, before, ends, sizeof (ends) / sizeof *(ends), o)

// Claims the names that the files of the state vector declare.
static void claim_vector(CNameClaims *k)
{
    static const char *const ends[] = {"_sv", "_vector", "_layout", "_element", "_names"};
    static const char *const counts[] = {"_ELEMENTS", "_REGIONS"};
    const StateVec *sv = k->app->sv;
    const CNameOwner *o = new_owner(k, (Span){0}, format_in(k->arena, "the state vector '%s'", sv->name->text));
    CUnit u;
    CVectorNames n;

    c_init_vector_names(k->arena, sv, &u);
    names_assign_runtime(k->arena, &u.names, sv, &n);
    CLAIM_NAMES(k, u.names.prefix, ends, o);
    CLAIM_NAMES(k, u.names.macro, counts, o);
    claim_name(k, u.names.sv_type, o);
    for (size_t i = 0; i < sv->element.n; i++) {
        const CNameOwner *e = new_owner(k, sv->element.at[i]->span, format_in(k->arena, "element '%s'", sv->element.at[i]->name->text));
        claim_name(k, n.getter[i], e);
        claim_name(k, n.setter[i], e);
        claim_name(k, n.element[i], e);
    }
    for (size_t i = 0; i < sv->region.n; i++) {
        const CNameOwner *r = new_owner(k, sv->region.at[i]->span, format_in(k->arena, "region '%s'", sv->region.at[i]->name->text));
        claim_name(k, n.region[i], r);
        claim_name(k, n.reader[i], r);
        claim_name(k, n.writer[i], r);
    }
}

// Claims the names that the files of a machine declare.
static void claim_machine(CNameClaims *k, const Program *p)
{
    static const char *const functions[] = {"_init", "_step", "_state", "_T", "_state_name", "_size", "_sv_size", "_machine"};
    static const char *const parameter_functions[] = {"_get_parameters", "_set_parameters"}, *const parameter_types[] = {"Parameters"};
    static const char *const types[] = {"", "Status", "Stored"};
    static const char *const numbers[] = {"_OK", "_REFUSED", "_NO_STATE", "_UNFIT", "_INITIAL_STATE", "_STATES"};
    const char *prefix = c_identifier(k->arena, p->name->text, p->name->len);
    const CNameOwner *o = new_owner(k, p->state.n ? p->state.at[0]->span : (Span){0}, format_in(k->arena, "machine '%s'", p->name->text));
    CUnit u;

    c_init_vector_names(k->arena, p->sv, &u);
    CLAIM_NAMES(k, prefix, functions, o);
    CLAIM_NAMES(k, c_machine_type(k->arena, prefix, u.names.sv_type), types, o);
    CLAIM_NAMES(k, c_macro_name(k->arena, prefix), numbers, o);
    if (!program_has_parameters(p))
        return;
    CLAIM_NAMES(k, prefix, parameter_functions, o);
    CLAIM_NAMES(k, c_machine_type(k->arena, prefix, u.names.sv_type), parameter_types, o);
}

// Claims the names of the functions that the user writes for a task, and the static names that the application's file derives from its name.
static void claim_task(CNameClaims *k, const AppTask *t)
{
    static const char *const machines[] = {"Self", "Copy", "Image", "Memory", "First", "Second"};
    const char *n = t->name->text;
    const CNameOwner *o = new_owner(k, t->span, format_in(k->arena, "task '%s'", n));

    if (t->kind == AST_TASK_machine)
        CLAIM_NAMES(k, n, machines, o);
    if (t->kind != AST_TASK_task)
        return;
    claim_name(k, format_in(k->arena, "%s_step", n), o);
    claim_name(k, format_in(k->arena, "%sStep", n), o);
    if (t->has_init) {
        claim_name(k, format_in(k->arena, "%s_init", n), o);
        claim_name(k, format_in(k->arena, "%sInit", n), o);
    }
    if (t->has_safe) {
        claim_name(k, format_in(k->arena, "%s_safe", n), o);
        claim_name(k, format_in(k->arena, "%sSafe", n), o);
    }
}

// Claims the names of machines emitted as C, once for each file.
static void claim_machines(CNameClaims *k)
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

// Checks that no two things in the emitted C of an application have the same name.  Reports each clash; returns false if there is one.
bool emit_c_check_app_names(Arena *arena, Diags *diags, const App *app)
{
    static const char *const pins[] = {"_inputs", "_outputs"}, *const messages[] = {"_receive", "_send"};
    CNameClaims k;
    const CNameOwner *application;
    const char *name = app->name->text;

    memset(&k, 0, sizeof k);
    k.arena = k.owner.arena = arena;
    k.diags = diags;
    k.app = app;
    str_pool_init(&k.pool, arena);
    claim_vector(&k);
    claim_machines(&k);
    if (app->pins)
        CLAIM_NAMES(&k, c_identifier(arena, app->io_name->text, app->io_name->len), pins,
                  new_owner(&k, (Span){app->pins->src, 0, 0}, "the pins"));
    if (app->net)
        CLAIM_NAMES(&k, c_identifier(arena, app->net_name->text, app->net_name->len), messages,
                  new_owner(&k, (Span){app->net->src, 0, 0}, "the messages"));
    application = new_owner(&k, (Span){app->src, 0, 0}, "the application");
    claim_name(&k, format_in(arena, "%s_app", c_identifier(arena, name, strlen(name))), application);
    for (size_t i = 0; i < app->machine.n; i++)
        if (app->machine.at[i]->swap)
            claim_name(&k, format_in(arena, "%s_swaps", c_identifier(arena, name, strlen(name))), application);
    for (size_t i = 0; i < app->task.n; i++)
        claim_task(&k, app->task.at[i]);
    return !k.clash;
}
