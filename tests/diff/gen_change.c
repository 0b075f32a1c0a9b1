// SPDX-License-Identifier: Apache-2.0
// Changes to a program that must not change its behaviour.
#include "tests/diff/gen.h"

const char *const gen_change_name[CHANGE_COUNT] = { "other names", "another layout", "a state that is never entered", "itself written out by hand" };

static void rename_all(Gen *g)
{
    g->rng.state = rng_mix(g->seed, 6);
    for (size_t i = 0; i < g->var.n; i++) {
        GVar *v = g->var.at[i];
        const bool role_by_name = v->id < 2 && v->alias == NULL;      // G or S under its own name
        if (!role_by_name)
            v->name = gen_new_name(g);
        if (v->alias != NULL && v->id >= 2)
            v->alias = gen_new_name(g);
    }
    for (size_t i = 0; i < g->def.n; i++)
        g->def.at[i]->name = gen_new_name(g);
    for (size_t i = 0; i < g->state.n; i++)
        g->state.at[i]->name = format_in(g->arena, "Renamed%u", (unsigned)(g->state.n - i));
}

static void add_dead_state(Gen *g)
{
    GState *s = ARENA_NEW(g->arena, GState);
    g->rng.state = rng_mix(g->seed, 7);
    gen_random_state(g, s);           // the new state may have transitions to any state, but no transition leads to it
    s->name = "NobodyEnters";
    vec_push(g->arena, &g->state, s);
}

static void remember(Gen *g)
{
    g->old_layout = g->layout;
    g->old_machine_name = g->machine_name;
    g->machine_name = "changed";
    for (size_t i = 0; i < g->var.n; i++) {
        g->var.at[i]->old_name = g->var.at[i]->name;
        g->var.at[i]->old_alias = g->var.at[i]->alias;
    }
    for (size_t i = 0; i < g->def.n; i++)
        g->def.at[i]->old_name = g->def.at[i]->name;
    for (size_t i = 0; i < g->state.n; i++)
        g->state.at[i]->old_name = g->state.at[i]->name;
}

void gen_change_back(Gen *g)
{
    g->by_hand = false;
    g->layout = g->old_layout;
    g->machine_name = g->old_machine_name;
    g->state.n = g->states;
    for (size_t i = 0; i < g->var.n; i++) {
        g->var.at[i]->name = g->var.at[i]->old_name;
        g->var.at[i]->alias = g->var.at[i]->old_alias;
    }
    for (size_t i = 0; i < g->def.n; i++)
        g->def.at[i]->name = g->def.at[i]->old_name;
    for (size_t i = 0; i < g->state.n; i++)
        g->state.at[i]->name = g->state.at[i]->old_name;
}

void gen_change(Gen *g, GChange what)
{
    remember(g);
    switch (what) {
    case CHANGE_NAMES: rename_all(g); break;
    case CHANGE_LAYOUT: g->layout = rng_mix(g->layout, 8); break;
    case CHANGE_DEAD_STATE: add_dead_state(g); break;
    case CHANGE_BY_HAND: g->by_hand = true; g->machine_name = g->old_machine_name; break;  // the layout contains the name
    case CHANGE_COUNT: break;
    }
}
