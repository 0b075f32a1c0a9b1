// SPDX-License-Identifier: Apache-2.0
// Waits in a state that other transitions would end.
//
// A goal that asks for time, as the guard `T >= 3 s` does, is reached only by a run that stays so long.  What else the machine checks meanwhile
// is not on the path to the goal: sensors that must agree, a feedback that must follow its valve, a counter that must go on.  A trial run shows
// the transition that ends the wait too early.  The inputs are changed until the statement that made it is not executed, and the trial is
// repeated.
#include "compiler/search/search_wish.h"

enum {
    MOST_REPAIRS = 16,        // of one attempt
    MOST_TRIES = 8,           // solutions of one repair, until one changes an input
    MOST_STORES = 4           // stores that are followed from a guard to the conditions of the statement that stored its variable
};

// Runs the current changes from a node on the copy k->scratch.  Returns the step, counted from 1, in which the machine leaves the state; 0: in
// none of these steps.
static uint64_t find_exit_step(SearchRun *k, uint32_t node, uint64_t steps)
{
    const uint64_t at = k->node.at[node].at;

    search_load(k, node, k->scratch);
    search_apply(k, k->scratch, at, k->turn.at, k->turn.n);
    for (uint64_t n = 1; n <= steps && k->r->steps < k->stop_at; n++) {
        search_set_inputs(k, k->scratch, at + n);
        flat_step(k->plain, k->scratch);
        k->r->steps++;
        if (k->plain->taken)
            return n;
    }
    return 0;
}

bool search_was_taken(const SearchRun *k, SearchPath path)
{
    for (uint32_t e = path.n; e-- > 0; ) {
        const SearchDecision *d = &k->decision[path.elem[e].decision];
        if (search_node_value(k, d, d->d->nodes - 1) != path.elem[e].value)
            return false;
    }
    return true;
}

// Returns the transition of the last step; NULL: it is not known.
static const SearchExit *find_taken_exit(const SearchRun *k, uint32_t from, uint32_t to)
{
    for (uint32_t i = 0; i < k->exit.n; i++)
        if (k->exit.at[i].from == from && k->exit.at[i].to == to && search_was_taken(k, k->exit.at[i].path))
            return &k->exit.at[i];
    return NULL;
}

uint32_t search_find_store(const SearchRun *k, uint32_t fn, IrRef ref)
{
    const IrIns *i = &k->fn[fn].fn->ins.at[ref];
    uint32_t found = 0;

    if (i->op == IR_load) {
        const SearchVar *v = &k->var[i->var];
        for (uint32_t s = 0; s < v->store.n && v->input == SEARCH_NONE; s++)
            if (v->store.at[s].state == k->site_state && k->fn[v->store.at[s].fn].is_step && k->path[v->store.at[s].stmt].n > 0 &&
                search_was_taken(k, k->path[v->store.at[s].stmt]))
                found = v->store.at[s].stmt;
        return found;
    }
    if (i->op == IR_const || i->op == IR_stat)
        return 0;
    if (i->a != IR_NONE)
        found = search_find_store(k, fn, i->a);
    return found || i->b == IR_NONE ? found : search_find_store(k, fn, i->b);
}

// The innermost decision on its path has the
// other outcome.  If the decision reads a variable that the same step has stored, as an error code, avoids that store.
void search_avoid_statement(SearchRun *k, uint32_t stmt)
{
    for (int n = 0; n < MOST_STORES && k->path[stmt].n > 0; n++) {
        const SearchElem *e = &k->path[stmt].elem[0];
        const SearchDecision *d = &k->decision[e->decision];
        const uint32_t store = search_find_store(k, d->fn, d->d->value);
        if (store == 0 || store == stmt) {
            search_wish_node(k, d, d->d->nodes - 1, !e->value);
            return;
        }
        stmt = store;
    }
}

// Changes the inputs so that the last step does not make the transition.  Returns false if no other input has resulted: chance has chosen an operand
// that no input changes, such as the time.
static bool repair_wait(SearchRun *k, const SearchExit *x)
{
    bool any = false;

    for (uint32_t i = 0; i < k->inputs; i++) {
        k->wish[i].needed = false;
        k->wish[i].copies = SEARCH_NONE;
        k->wish[i].vary = k->wish[i].slope = 0;
    }
    k->is_lasting = true;
    search_avoid_statement(k, x->stmt);
    k->is_lasting = false;
    for (uint32_t i = 0; i < k->inputs; i++)
        if (k->wish[i].needed || k->wish[i].copies != SEARCH_NONE) {
            search_replace_turn(k, i);
            any = true;
        }
    return any;
}

static bool repair_in_tries(SearchRun *k, const SearchExit *x)
{
    for (int n = 0; n < MOST_TRIES; n++)
        if (repair_wait(k, x))
            return true;
    return false;
}

void search_run_staying(SearchRun *k, uint32_t node, uint32_t goal)
{
    const FlatState *s = (const FlatState *)(const void *)k->scratch;
    const uint64_t wait = k->wait;

    for (int n = 0; n < MOST_REPAIRS; n++) {
        const SearchExit *x;
        if (find_exit_step(k, node, wait) == 0)
            break;
        x = k->visited[s->state - 1] ? find_taken_exit(k, k->site_state, s->state) : NULL;
        if (!x || !repair_in_tries(k, x))
            break;
    }
    search_run_segment(k, node, k->turn.at, k->turn.n, wait + 1, goal);
}
