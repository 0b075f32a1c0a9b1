// SPDX-License-Identifier: Apache-2.0
// Finds changes of inputs that lead from a snapshot towards a goal.
//
// One step is run on a copy of the snapshot.  Then the conditions of the goal are solved for the inputs that they read (search_wish.h): each
// input collects bounds, and its new value is chosen within.  Where there are several solutions, chance decides, so that attempts differ.
// What cannot be solved is changed at random.
#include "compiler/search/search_wish.h"
#include "stdlib/convert.h"

enum {
    // If an input alternates between two values, as a sensor with noise does, so many of a hundred new values of it alternate by as much.
    TREMBLE_PERCENT = 75,
    OTHERS_PERCENT = 20       // in an application: of a hundred transitions of a walk, so many also change an input for the other machines
};

// ---- changes ----

// Adds a change of the input to the solution, unless the solution changes this input already.
static void add_turn(SearchRun *k, uint32_t input, SearchSetting s)
{
    const SearchTurn t = {input, s};

    s.set = true;
    for (uint32_t i = 0; i < k->turn.n; i++)
        if (k->turn.at[i].input == input)
            return;
    vec_push(&k->work, &k->turn, t);
    k->turn.at[k->turn.n - 1].setting.set = true;
}

void search_add_change(SearchRun *k, const ScenarioChange *c)
{
    const uint32_t input = k->m->var_of[c->var] == IR_NONE ? SEARCH_NONE : k->var[k->m->var_of[c->var]].input;

    if (input != SEARCH_NONE)
        add_turn(k, input, (SearchSetting){.kind = c->kind, .a = c->a, .b = c->b, .source = c->source});
}

static void add_wished_setting(SearchRun *k, uint32_t input)
{
    const SearchWish *w = &k->wish[input];
    const double now = sm_cell_to_f64(k->input[input].type, flat_cells(k->plain, k->scratch)[k->input[input].at]);
    SearchSetting s = {.kind = SCENARIO_HOLD, .a = now};

    if (w->copies != SEARCH_NONE) {
        s.kind = SCENARIO_COPY;
        s.source = w->copies;
    } else if (w->vary != 0) {
        s.kind = SCENARIO_ALTERNATE;
        s.a = search_is_within(w, now) ? now : search_choose_value(k, input);
        s.b = s.a + (search_chance(k, 50) ? w->vary : -w->vary);
        if (k->input[input].range && (s.b > k->input[input].range->hi || s.b < k->input[input].range->lo))
            s.b = 2 * s.a - s.b;
    } else if (w->slope != 0) {
        const double steps = ((now < w->lo ? w->lo : now > w->hi ? w->hi : now) - now) / w->slope;
        s.kind = SCENARIO_RAMP;
        s.a = steps >= 0 ? now : search_choose_value(k, input);
        s.b = w->slope;
        search_wait_for(k, steps + 2);
    } else {
        const SearchSetting *was = &search_settings(k, k->scratch)[input];
        s.a = search_choose_value(k, input);
        if (was->set && was->kind == SCENARIO_ALTERNATE && !k->o->plain && search_chance(k, TREMBLE_PERCENT)) {
            s.kind = SCENARIO_ALTERNATE;
            s.b = s.a + (was->b - was->a);
            s.b = search_is_within(w, s.b) ? s.b : s.a - (was->b - was->a);
        }
    }
    add_turn(k, input, s);
}

void search_replace_turn(SearchRun *k, uint32_t input)
{
    for (uint32_t i = 0; i < k->turn.n; i++)
        if (k->turn.at[i].input == input)
            k->turn.at[i--] = k->turn.at[--k->turn.n];
    add_wished_setting(k, input);
}

// Returns an input on which a decision of the path depends; sometimes any input.
static uint32_t choose_input(SearchRun *k, const SearchPath *path)
{
    for (int i = 0; path && path->n && i < 8; i++) {
        const SearchDecision *d = &k->decision[path->elem[search_pick(k, path->n)].decision];
        const uint32_t input = search_pick(k, k->inputs);
        if (d->inputs[input / 64] >> input % 64 & 1)
            return input;
    }
    return search_pick(k, k->inputs);
}

static void add_random(SearchRun *k, const SearchPath *path)
{
    const uint32_t input = choose_input(k, path);
    const SearchInput *in = &k->input[input];
    const double now = sm_cell_to_f64(in->type, flat_cells(k->plain, k->scratch)[in->at]);
    SearchSetting s = {.kind = SCENARIO_HOLD};
    const uint32_t kind = search_pick(k, 100);

    if (in->type == SM_BOOL)
        s.a = now == 0;
    else
        s.a = search_choose_value(k, input);
    if (kind < 8 && in->type != SM_BOOL) {
        s.kind = SCENARIO_ALTERNATE;
        s.b = s.a + search_unit_of(in, s.a) * (search_chance(k, 50) ? 1 : 10);
    } else if (kind < 14 && in->type != SM_BOOL) {
        s.kind = SCENARIO_RAMP;
        s.a = now;
        s.b = search_unit_of(in, now) * (search_chance(k, 50) ? 1 : -1) * (search_chance(k, 50) ? 1 : 5);
    } else if (kind < 22 && k->output.n) {
        const uint32_t source = k->output.at[search_pick(k, k->output.n)];
        if ((k->p->var.at[source]->type == SM_BOOL) == (in->type == SM_BOOL) && k->p->var.at[source] != k->p->s) {
            s.kind = SCENARIO_COPY;
            s.source = source;
        }
    }
    add_turn(k, input, s);
}

// ---- entrances ----

// Runs one step of the machine on a copy of a node, so that the frame has its values.
static void run_trial(SearchRun *k, uint32_t node)
{
    search_load(k, node, k->scratch);
    for (uint64_t n = 1; n <= k->every; n++) {
        search_set_inputs(k, k->scratch, k->node.at[node].at + n);
        flat_step(k->plain, k->scratch);
        k->r->steps++;
        if (k->plain->ran)
            break;
    }
    k->turn.n = 0;
    k->wait = 0;
    k->rounds = 0;
    k->foreign = SEARCH_NONE;
    k->site_state = k->node.at[node].state;
    for (uint32_t i = 0; i < k->inputs; i++)
        k->wish[i] = (SearchWish){.lo = -SEARCH_BIG, .hi = SEARCH_BIG, .copies = SEARCH_NONE};
}

static void add_all_wished(SearchRun *k)
{
    for (uint32_t i = 0; i < k->inputs; i++) {
        const SearchWish *w = &k->wish[i];
        const bool bounded = w->lo > -SEARCH_BIG || w->hi < SEARCH_BIG || w->differs;
        if (w->needed || w->copies != SEARCH_NONE || (bounded && search_chance(k, 10)))
            add_wished_setting(k, i);
    }
}

static uint64_t choose_steps(SearchRun *k)
{
    const uint32_t r = search_pick(k, 100);

    if (k->wait && r < 85)
        return k->wait + (r < 60 ? 1 : search_pick(k, (uint32_t)(k->wait / 4 + 4)));
    if (r < 40)
        return 1 + search_pick(k, 4);
    if (r < 55 && k->longest > 1)
        return k->longest + 2;
    if (r < 97)
        return UINT64_C(1) << search_pick(k, 12);
    return UINT64_C(1) << search_pick(k, 17);
}

static bool path_is_of(const SearchRun *k, SearchPath path, uint32_t state)
{
    return path.n == 0 || k->decision[path.elem[0].decision].state == state || k->decision[path.elem[0].decision].state == 0;
}

uint64_t search_solve_goal(SearchRun *k, uint32_t node, uint32_t goal)
{
    const SearchGoal *g = &k->goal[goal];
    const SearchSite *site = NULL;
    const uint32_t state = k->node.at[node].state;
    uint32_t fits = 0;

    run_trial(k, node);
    if (k->inputs == 0)
        return choose_steps(k);
    for (uint32_t s = 0; s < g->site.n; s++)
        if (path_is_of(k, g->site.at[s].path, state) && search_pick(k, ++fits) == 0)
            site = &g->site.at[s];
    if (site && search_chance(k, 75)) {
        for (uint32_t e = site->path.n; e-- > 0; ) {
            const SearchDecision *d = &k->decision[site->path.elem[e].decision];
            if (e == 0 && site->condition != SEARCH_NONE)
                search_wish_condition(k, d, site->condition, site->value);
            else
                search_wish_node(k, d, d->d->nodes - 1, site->path.elem[e].value);
        }
        add_all_wished(k);
    }
    if (g->fill && k->node.at[node].at < g->fill)
        search_wait_for(k, (double)(g->fill - k->node.at[node].at));
    if (k->turn.n == 0 && (k->wait == 0 || search_chance(k, 30)))
        for (uint32_t n = 1 + search_pick(k, 3); n > 0; n--)
            add_random(k, site ? &site->path : NULL);
    else if (search_chance(k, 15))
        add_random(k, site ? &site->path : NULL);
    return choose_steps(k);
}

uint64_t search_solve_exit(SearchRun *k, uint32_t node, const SearchExit *x)
{
    run_trial(k, node);
    if (k->inputs == 0)
        return choose_steps(k);
    for (uint32_t e = x->path.n; e-- > 0; ) {
        const SearchDecision *d = &k->decision[x->path.elem[e].decision];
        search_wish_node(k, d, d->d->nodes - 1, x->path.elem[e].value);
    }
    add_all_wished(k);
    if ((k->turn.n == 0 && k->wait == 0) || (k->o->place && search_chance(k, OTHERS_PERCENT)))
        add_random(k, &x->path);
    return choose_steps(k);
}

void search_begin_solving(SearchRun *k) { k->wish = arena_array(&k->work, k->inputs + 1, sizeof *k->wish); }
