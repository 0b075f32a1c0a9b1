// SPDX-License-Identifier: Apache-2.0
// Compares a guard with the guards that were evaluated before it: enclosing guards that were false, and guards whose branch left the
// state.  Finds an earlier guard because of which the current guard is never true, or earlier guards that leave exactly its cases.
#include "compiler/analysis/earlier_guards.h"

#include "compiler/analysis/assume.h"
#include "compiler/analysis/guards_imply.h"

// Whether no variable of e has been assigned since s was evaluated.
bool is_unchanged(const ReachWalk *k, const Stmt *s, const Expr *e)
{
    if (e->kind == EX_VAR && k->written[e->var->index] > k->order[s->number])
        return false;
    for (uint32_t i = 0; e->kind != EX_ROLL && i < e->n; i++)
        if (!is_unchanged(k, s, e->arg[i]))
            return false;
    return true;
}

// Whether the current branch `branch` contains or is in a statement after the conditional of `arm`, in the same list of statements.
static bool is_after_branch(const Branch *arm, const Branch *branch)
{
    for (unsigned n = 0; branch && branch->depth >= arm->depth && n < EARLIER_MAX; n++)
        branch = branch->outer;
    return branch == arm->outer;
}

// Adds the guard of s to *b, unless a variable that the guard reads was assigned after its evaluation.
static void add_guard(const ReachWalk *k, EarlierGuards *b, const Stmt *s, bool holds, bool leaves)
{
    const EarlierGuard add = {s, holds, leaves};

    if (is_unchanged(k, s, s->value))
        b->at[b->n++] = add;
}

// Returns the earlier guards of a guard that is evaluated inside `branch`, at the current position of the walk.
EarlierGuards earlier_guards_of(const ReachWalk *k, const Branch *branch)
{
    EarlierGuards b = {.n = 0};
    unsigned n = 0;
    const Branch *w;

    for (w = branch; w && n < EARLIER_MAX; w = w->outer, n++)
        if (!w->holds)
            add_guard(k, &b, w->stmt, true, false);
    for (size_t i = k->leaving.n; i > 0 && k->leaving.n - i < EARLIER_MAX; i--) {
        w = k->leaving.at[i - 1];
        if (is_after_branch(w, branch))
            add_guard(k, &b, w->stmt, w->holds, true);
    }
    return b;
}

// Whether the guard of b is the same expression as `guard`, and is false on every path to the current position.
bool is_same_guard(const ReachWalk *k, const Expr *guard, const EarlierGuard *b)
{
    return b->holds && expr_equal(guard, b->stmt->value, k->a->m->window_of);
}

// "Excluded outcome" of an earlier guard b: the outcome that b has on no path to the current position (EarlierGuard).

// Whether the expressions alone show that `guard` can be true only if b has its excluded outcome.
static bool is_excluded_syntactically(const ReachWalk *k, const Expr *guard, const EarlierGuard *b)
{
    return b->holds ? guard_implies(k->a, guard, b->stmt->value) : guard_excludes(k->a, guard, b->stmt->value);
}

// Whether the facts show that `guard` can be true only if b has its excluded outcome.
static bool is_excluded_by_facts(const ReachWalk *k, const Expr *guard, const EarlierGuard *b)
{
    const Env *env = env_of_stmt(k->a, b->stmt);

    return is_unchanged(k, b->stmt, guard) && assume_guard(k->a, &env, guard, true) &&
           !assume_guard(k->a, &env, b->stmt->value, !b->holds);
}

// Returns the first earlier guard for which f is true; NULL if f is false for all of them.
static const EarlierGuard *find_guard(const ReachWalk *k, const Expr *guard, const EarlierGuards *b,
                                      bool (*f)(const ReachWalk *k, const Expr *guard, const EarlierGuard *b))
{
    for (size_t i = 0; i < b->n; i++)
        if (f(k, guard, &b->at[i]))
            return &b->at[i];
    return NULL;
}

// Returns an earlier guard whose outcome on every path to here contradicts `guard`, so that `guard` is never true; NULL if no outcome does.
// Only compares the two expressions.
const EarlierGuard *find_excluding_guard(const ReachWalk *k, const Expr *guard, const EarlierGuards *b)
{
    return find_guard(k, guard, b, is_excluded_syntactically);
}

// Returns an earlier guard that explains why `guard` is never true: the same guard, or one that excludes it by expression or facts; or NULL.
const EarlierGuard *find_explaining_guard(const ReachWalk *k, const Expr *guard, const EarlierGuards *b)
{
    const EarlierGuard *found = find_guard(k, guard, b, is_same_guard);

    if (!found)
        found = find_guard(k, guard, b, is_excluded_syntactically);
    return found ? found : find_guard(k, guard, b, is_excluded_by_facts);
}

// ---- the cases that earlier guards leave ----

// Sets `marked` of each variable in e to the current mark.
static void mark_vars_of_expr(ReachWalk *k, const Expr *e)
{
    if (e->kind == EX_VAR)
        k->marked[e->var->index] = k->mark;
    for (uint32_t i = 0; i < e->n; i++)
        mark_vars_of_expr(k, e->arg[i]);
}

// Whether e reads a variable with the current mark.
static bool reads_marked_var(const ReachWalk *k, const Expr *e)
{
    if (e->kind == EX_VAR && k->marked[e->var->index] == k->mark)
        return true;
    for (uint32_t i = 0; i < e->n; i++)
        if (reads_marked_var(k, e->arg[i]))
            return true;
    return false;
}

// For a guard that is always true at its position: whether it describes exactly the cases that earlier guards leave, as `p <= 10: -> B`
// after `p > 10: -> A`.
bool covers_remaining_cases(ReachWalk *k, const Expr *guard, const EarlierGuards *b)
{
    bool any = false;

    k->mark++;
    mark_vars_of_expr(k, guard);
    for (size_t i = 0; i < b->n; i++) {
        const EarlierGuard *earlier = &b->at[i];
        const Env *env = env_of_stmt(k->a, earlier->stmt);
        if (!reads_marked_var(k, earlier->stmt->value))
            continue;
        if (assume_guard(k->a, &env, earlier->stmt->value, earlier->holds) && assume_guard(k->a, &env, guard, true))
            return false;                             // the guard can be true even if the earlier guard has its excluded outcome
        any = true;
    }
    return any;
}
