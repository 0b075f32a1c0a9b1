// SPDX-License-Identifier: Apache-2.0
#include "compiler/search/search_app.h"

#include <string.h>

#include "compiler/cover/flat_app.h"
#include "compiler/search/search_run.h"

struct SearchApp {
    Arena *arena;
    const Program *joint;
    const Member *member;
    const FlatView *view;
    Cover *cover;             // that of the machine, with the view's program and IR
    bool *writable;           // by Var.index of the view
    SearchPlace place;
    VEC(SearchHint) hint;
    VEC(SearchOther) other;   // by machine
};

// ---- inputs ----

// Whether the variable is the @mode of a machine.
static bool is_mode(const Program *joint, const Var *v)
{
    for (size_t i = 0; i < joint->joint->member.n; i++)
        if (joint->joint->member.at[i].mode == v)
            return true;
    return false;
}

void search_app_inputs(const Program *joint, bool *writable)
{
    for (uint32_t i = 0; i < joint->var.n; i++) {
        const Var *v = joint->var.at[i];
        const JointUses u = program_uses_of(joint, v);
        writable[i] = v->kind == VAR_ELEMENT && v != joint->g && !v->state_of && !u.written && (u.read || is_mode(joint, v));
    }
}

// ---- other machines ----

// Studies another machine as for a search: its inputs, decisions and stores.
static SearchRun *study(SearchApp *a, const Cover *c, FlatMachine *f)
{
    static const SearchOptions none = {0};
    SearchRun *k = ARENA_NEW(a->arena, SearchRun);

    arena_init_within(&k->work, a->arena);
    k->arena = a->arena;
    k->c = c;
    k->p = c->p;
    k->m = c->m;
    k->o = &none;
    k->plain = f;
    search_analyse_machine(k);
    search_begin_solving(k);
    return k;
}

// Adds another machine, and the numbers with which it compares inputs of the application, which the search tries.
static void add_other(SearchApp *a, const Cover *c, const Member *m, FlatMachine *f, const bool *writable)
{
    SearchRun *k = study(a, c, f);
    SearchOther other = {k, ARENA_ARRAY(a->arena, uint32_t, k->inputs + 1), ARENA_ARRAY(a->arena, uint32_t, a->view->m->var.n)};

    for (uint32_t i = 0; i < k->inputs; i++) {
        const uint32_t joint = m->var[k->input[i].var]->index;
        other.input[i] = writable[joint] ? a->view->own[joint] : SEARCH_NONE;
        for (uint32_t n = 0; n < k->input[i].constant.n && writable[joint]; n++)
            vec_push(a->arena, &a->hint, ((SearchHint){a->view->own[joint], k->input[i].constant.at[n]}));
    }
    memset(other.var, 0xff, a->view->m->var.n * sizeof *other.var);
    for (uint32_t v = 0; v < m->program->var.n; v++)
        if (m->program->var.at[v]->kind == VAR_ELEMENT && k->var[k->m->var_of[v]].store.n)
            other.var[a->view->m->var_of[a->view->own[m->var[v]->index]]] = k->m->var_of[v];
    vec_push(a->arena, &a->other, other);
}

// ---- an application ----

static Cover *cover_of_view(SearchApp *a, const Cover *c)
{
    Cover *out = arena_copy(a->arena, c, sizeof *c);

    out->p = a->view->p;
    out->m = a->view->m;
    return out;
}

// Finds the elements of the view that other machines write.
static const bool *find_foreign(const SearchApp *a)
{
    const Joint *j = a->joint->joint;
    bool *foreign = arena_alloc(a->arena, a->view->p->var.n + 1);

    for (size_t i = 0; i < j->member.n; i++) {
        const Member *m = &j->member.at[i];
        for (size_t v = 0; v < m->program->var.n && m != a->member; v++)
            if (m->program->var.at[v]->kind == VAR_ELEMENT && m->var[v] != a->joint->g && (m->program->var.at[v]->written || m->s == m->var[v]))
                foreign[a->view->own[m->var[v]->index]] = true;
    }
    return foreign;
}

// Whether facts about the machine alone are no facts about its runs in the application: its steps are not at equal distances.
static bool has_other_times(const SearchApp *a) { return a->member->mode != NULL; }

const char *search_app_refusal(const Program *joint)
{
    if (joint->step == 0)
        return "its ticks are no whole units of G";
    for (size_t i = 0; i < joint->joint->start.n; i++)
        if (joint->joint->start.at[i].var == joint->g)
            return "[start] sets its time";
    return NULL;
}

SearchApp *search_app_new(Arena *arena, const Program *joint, size_t machine, Cover *const *cover)
{
    const Joint *j = joint->joint;
    SearchApp *a = ARENA_NEW(arena, SearchApp);
    bool *inputs = arena_alloc(arena, joint->var.n + 1);
    const IrMachine **ir = ARENA_ARRAY(arena, const IrMachine *, j->member.n);

    a->arena = arena;
    a->joint = joint;
    a->member = &j->member.at[machine];
    for (size_t i = 0; i < j->member.n; i++)
        ir[i] = cover[i]->m;
    a->view = flat_view_new(arena, joint, machine, ir);
    a->writable = arena_alloc(arena, a->view->p->var.n + 1);
    search_app_inputs(joint, inputs);
    for (uint32_t i = 0; i < joint->var.n; i++)
        if (inputs[i])
            a->writable[a->view->own[i]] = true;
    for (size_t i = 0; i < j->member.n; i++) {
        const Member *m = &j->member.at[i];
        if (i == machine)
            vec_push(arena, &a->other, ((SearchOther){NULL, NULL, NULL}));
        else
            add_other(a, cover[i], m, a->view->app->member[i].f, inputs);
        if (m->mode && inputs[m->mode->index])
            vec_push(arena, &a->hint, ((SearchHint){a->view->own[m->mode->index], MODE_ENABLED}));
    }
    a->cover = cover_of_view(a, cover[machine]);
    a->place = (SearchPlace){a->view->app, a->member->every, find_foreign(a), a->other.at, a->other.n, has_other_times(a)};
    return a;
}

// ---- scenarios ----

// Returns a copy of the changes with other numbers of the variables: `index` has the new one by the old one.
static const ScenarioChange *renumber_changes(Arena *arena, const Scenario *s, const uint32_t *index)
{
    ScenarioChange *out = arena_array(arena, s->changes + 1, sizeof *out);

    for (size_t i = 0; i < s->changes; i++) {
        out[i] = s->change[i];
        out[i].var = index[out[i].var];
        out[i].source = index[out[i].source];
    }
    return out;
}

// Returns the scenarios of the joined Program as those of the view.
static const Scenario *given_to_view(const SearchApp *a, const SearchOptions *o)
{
    Scenario *out = arena_array(a->arena, o->givens + 1, sizeof *out);

    for (uint32_t i = 0; i < o->givens; i++) {
        out[i] = o->given[i];
        out[i].init_state = a->member->initial;
        out[i].change = renumber_changes(a->arena, &o->given[i], a->view->own);
    }
    return out;
}

static void result_to_joint(const SearchApp *a, SearchResult *r)
{
    SearchScenario *chosen = arena_array(a->arena, r->chosens + 1, sizeof *chosen);

    for (uint32_t i = 0; i < r->chosens; i++) {
        chosen[i] = r->chosen[i];
        chosen[i].scenario.init_state = a->joint->state.at[0];
        chosen[i].scenario.change = renumber_changes(a->arena, &r->chosen[i].scenario, a->view->joint);
    }
    r->chosen = chosen;
}

SearchResult *search_app_run(SearchApp *a, const SearchOptions *options)
{
    SearchOptions o = *options;
    SearchResult *r;

    o.delta_t = a->joint->step;
    o.init_state = a->member->initial;
    o.writable = a->writable;
    o.place = &a->place;
    o.any_elements = true;
    o.hint = a->hint.at;
    o.hints = a->hint.n;
    o.given = given_to_view(a, options);
    r = search_run(a->arena, a->cover, &o);
    for (uint32_t i = 0; i < a->other.n; i++)
        if (a->other.at[i].of)
            arena_free(&a->other.at[i].of->work);
    result_to_joint(a, r);
    return r;
}
