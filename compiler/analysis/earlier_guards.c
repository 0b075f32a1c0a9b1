// SPDX-License-Identifier: Apache-2.0
// Guards that were evaluated before another one: enclosing guards that were false, and guards whose branch left the state.
// Finds the one that leaves no case for the current guard, or leaves exactly its cases.
#include "compiler/analysis/earlier_guards.h"

#include "compiler/analysis/assume.h"
#include "compiler/analysis/guards_imply.h"

bool is_unchanged(const Structure *k, const Stmt *s, const Expr *e)
{
    if (e->kind == EX_VAR && k->written[e->var->index] > k->order[s->number])
        return false;
    for (uint32_t i = 0; e->kind != EX_ROLL && i < e->n; i++)
        if (!is_unchanged(k, s, e->arg[i]))
            return false;
    return true;
}

// Whether the statements inside `way` come after the whole branch: `way` is in the same list as the branch's conditional, or
// deeper.
static bool is_beside(const Way *arm, const Way *way)
{
    for (unsigned n = 0; way && way->depth >= arm->depth && n < LOOK_BACK; n++)
        way = way->outer;
    return way == arm->outer;
}

static void add_before(const Structure *k, Befores *b, const Stmt *s, bool holds, bool left)
{
    const Before add = {s, holds, left};

    if (is_unchanged(k, s, s->value))
        b->at[b->n++] = add;
}

Befores befores_of(const Structure *k, const Way *way)
{
    Befores b = {.n = 0};
    unsigned n = 0;
    const Way *w;

    for (w = way; w && n < LOOK_BACK; w = w->outer, n++)
        if (!w->holds)
            add_before(k, &b, w->stmt, true, false);
    for (size_t i = k->left.n; i > 0 && k->left.n - i < LOOK_BACK; i--) {
        w = k->left.at[i - 1];
        if (is_beside(w, way))
            add_before(k, &b, w->stmt, w->holds, true);
    }
    return b;
}

bool is_same(const Structure *k, const Expr *guard, const Before *b)
{
    return b->holds && expr_equal(guard, b->stmt->value, k->a->m->window_of);
}

static bool excluded(const Structure *k, const Expr *guard, const Before *b)
{
    return b->holds ? guard_implies(k->a, guard, b->stmt->value) : guard_excludes(k->a, guard, b->stmt->value);
}

// Whether, according to the facts, the guard can be true only where b has its excluded outcome.
static bool covered(const Structure *k, const Expr *guard, const Before *b)
{
    const Env *env = k->a->stmt[b->stmt->number].env;

    return is_unchanged(k, b->stmt, guard) && suppose_guard(k->a, &env, guard, true) &&
           !suppose_guard(k->a, &env, b->stmt->value, !b->holds);
}

static const Before *find_before(const Structure *k, const Expr *guard, const Befores *b,
                                 bool (*f)(const Structure *k, const Expr *guard, const Before *b))
{
    for (size_t i = 0; i < b->n; i++)
        if (f(k, guard, &b->at[i]))
            return &b->at[i];
    return NULL;
}

const Before *written_before(const Structure *k, const Expr *guard, const Befores *b)
{
    return find_before(k, guard, b, excluded);
}

const Before *the_one_before(const Structure *k, const Expr *guard, const Befores *b)
{
    const Before *found = find_before(k, guard, b, is_same);

    if (!found)
        found = find_before(k, guard, b, excluded);
    return found ? found : find_before(k, guard, b, covered);
}

// ---- the cases that earlier guards leave ----

static void stamp_vars(Structure *k, const Expr *e)
{
    if (e->kind == EX_VAR)
        k->stamp[e->var->index] = k->stamps;
    for (uint32_t i = 0; i < e->n; i++)
        stamp_vars(k, e->arg[i]);
}

static bool is_stamped(const Structure *k, const Expr *e)
{
    if (e->kind == EX_VAR && k->stamp[e->var->index] == k->stamps)
        return true;
    for (uint32_t i = 0; i < e->n; i++)
        if (is_stamped(k, e->arg[i]))
            return true;
    return false;
}

static bool is_apart(const Structure *k, const Expr *guard, const Before *b)
{
    const Env *env = k->a->stmt[b->stmt->number].env;

    return !suppose_guard(k->a, &env, b->stmt->value, b->holds) || !suppose_guard(k->a, &env, guard, true);
}

bool is_the_rest(Structure *k, const Expr *guard, const Befores *b)
{
    bool any = false;

    k->stamps++;
    stamp_vars(k, guard);
    for (size_t i = 0; i < b->n; i++) {
        if (!is_stamped(k, b->at[i].stmt->value))
            continue;
        if (!is_apart(k, guard, &b->at[i]))
            return false;
        any = true;
    }
    return any;
}
