// SPDX-License-Identifier: Apache-2.0
#include "compiler/prove/prove_explore.h"

#include <string.h>

#include "compiler/base/bitset.h"
#include "compiler/facts/env_table.h"
#include "compiler/ir/eval.h"
#include "compiler/prove/prove_relate.h"
#include "stdlib/convert.h"

enum {
    ENVS_MOST = 96,                   // how many paths to a block have facts of their own; the facts of further paths are joined
    CHANGES_BEFORE_WIDENING = 4,      // after this many changes of a node's facts, growing bounds are widened to numbers of the program
    CHANGES_BEFORE_FEW_LIMITS = 14,   // after this many, growing bounds are widened to a few round numbers
    CHANGES_MOST = 40,                // after this many, only the types of variables remain
    PATIENCE = 4,                     // factor on the last two numbers, if the limits are bounds that an earlier exploration has found
    NARROWINGS = 3,
    LIMITS_MOST = 256,
    ROUNDS = 5,                       // the most explorations; each widens to the bounds that the previous one has found
    MANY_VALUES = 4,                  // a key with more values than this can be named as an obstacle to a proof
    BESIDE = 5                        // limits that one constant adds: itself, and its neighbours
};

#define KEY_OPEN UINT64_MAX   // the key is not known exactly.  As an F64 it would be a NaN, which no variable has

typedef VEC(const Env *) ProveEnvs;

typedef struct ProveNode {
    const Env *env;           // the facts when the step begins
    uint64_t *key;            // by key: its value as the bits of an F64, or KEY_OPEN
    uint64_t hash;
    uint32_t state;           // State.number - 1
    uint32_t changes;         // how often the facts have changed
    bool first, queued;       // first: the step is the first one in the state; queued: the steps from the node are to be explored (again)
} ProveNode;

typedef struct ProveTable {
    VEC(ProveNode) node;
    uint32_t *slot;           // hash table: 1 + the number of a node; 0: empty
    uint32_t slots;           // a power of 2
    VEC(uint32_t) queue;
    uint32_t next;            // index of the first entry of the queue that is not explored yet
} ProveTable;

typedef struct Explorer {
    ProveModel *p;
    Arena *arena;             // reset when the exploration begins again
    FactMachine *fm;
    unsigned assumed;
    const uint32_t *key;      // the `keys` variables that are keys
    uint32_t keys;
    const ProveLimits *limits;
    uint64_t *visits;
    FactLimits widening;      // the numbers to which growing bounds are widened
    double *limit;            // memory of `widening`
    double *found;            // `founds` bounds of the facts of the last exploration: the next one widens to them
    size_t founds;
    uint32_t patience;        // factor on the numbers of changes: 1 or PATIENCE
    ProveTable *table;        // the table to which nodes are added
    bool widens;              // whether facts that keep growing are widened; false while facts are narrowed
    ProveExplored *out;
    const ProveStep *step;    // the step that is being explored
    const ProveNode *from;    // the node from which it begins
    const ProveBranch *branch;        // the branch that is being followed
    bool is_taken;            // whether the facts allow the branch
    const Env *taken;         // the facts at the end of the branch, if `is_taken`
    uint32_t *holder;         // memory for prove_relate, if a function has fewer than `holders` temporaries
    uint32_t holders;
    ProveEnvs *at;            // by block of the step: for each path to the block, the facts with which it begins
    uint32_t blocks;          // allocated length of `at`
} Explorer;

static bool is_assumed(const Explorer *x, ProveAssumption a) { return x->assumed >> a & 1; }

// ---- facts between steps ----

// Returns a time that is delta_t larger.  From 2^53 on, an F64 does not represent every time; there the bounds are those of the type.
static Fact advance_time(Fact f, double delta)
{
    const Fact type = fact_of_type(SM_U64);

    f.hi = f.hi + delta < FACT_EXACT ? f.hi + delta : type.hi;
    f.lo = f.lo + delta < FACT_EXACT ? f.lo + delta : FACT_EXACT;
    return f;
}

// Narrows the bounds of T to multiples of delta_t.  Returns false if no multiple is within them.
static bool round_time(Fact *f, uint64_t delta)
{
    uint64_t lo, hi;

    if (!(f->lo >= 0) || !(f->hi < FACT_EXACT) || delta == 1)
        return !(f->lo > f->hi);
    lo = (uint64_t)f->lo;
    hi = (uint64_t)f->hi;
    if ((double)lo < f->lo)
        lo++;
    lo = (lo + delta - 1) / delta * delta;
    hi = hi / delta * delta;
    f->lo = (double)lo;
    f->hi = (double)hi;
    return lo <= hi;
}

// Returns the fact of an input at the start of a step: its @range if that is assumed, else its type.
static Fact fact_of_input(const Explorer *x, uint32_t v)
{
    const IrVar *var = &x->p->ir->var.at[v];
    Fact f = fact_of_type(var->type);

    if (!is_assumed(x, PROVE_RANGES))
        return f;
    for (uint32_t k = 0; k < x->p->machine->program->var.n; k++) {
        const Var *of = x->p->machine->program->var.at[k];
        if (x->p->machine->var_of[k] == v && of->range) {
            f.lo = of->range->lo > f.lo ? of->range->lo : f.lo;
            f.hi = of->range->hi < f.hi ? of->range->hi : f.hi;
        }
    }
    return f;
}

// Returns the fact about a variable when a step begins.  `before`: after the step before, or NULL for the first step of a run.
static Fact fact_at_begin(const Explorer *x, uint32_t v, const Fact *before, uint32_t state, bool first)
{
    const ProveModel *p = x->p;
    const IrVar *var = &p->ir->var.at[v];
    const Fact type = fact_of_type(var->type);

    switch (p->var[v].kind) {
    case PROVE_INPUT: return fact_of_input(x, v);
    case PROVE_OUTPUT:
        if (!before)
            return is_assumed(x, PROVE_ZERO_START) ? fact_of_cell(var->type, 0) : type;
        return is_assumed(x, PROVE_OWN_OUTPUTS) ? *before : type;
    case PROVE_KEPT:
        if (before)
            return *before;
        return v < p->machine->var.n && is_assumed(x, PROVE_PARAMETERS) ? fact_of_cell(var->type, p->machine->var.at[v].init) : p->var[v].begin;
    case PROVE_CHOICE: return p->var[v].begin;
    case PROVE_IRRELEVANT: return type;
    case PROVE_DIFFERENCE: return type;       // begin_differences adds what is known
    case PROVE_TIME: break;
    }
    if (v == p->ir->s)
        return fact_of_cell(var->type, state + 1);
    if (v == p->ir->t && (first || !before))
        return fact_of_cell(var->type, 0);
    return before ? advance_time(*before, (double)p->delta_t) : is_assumed(x, PROVE_ZERO_START) ? fact_of_cell(var->type, 0) : type;
}

// Whether a variable has the value of the step before when a step begins.
static bool lasts(const Explorer *x, uint32_t v)
{
    const ProveVarKind kind = x->p->var[v].kind;

    return kind == PROVE_KEPT || (kind == PROVE_OUTPUT && is_assumed(x, PROVE_OWN_OUTPUTS));
}

// Adds the differences to the facts with which a step begins.
static const Env *begin_differences(const Explorer *x, const Env *before, bool is_start, const Env *env)
{
    const EnvShape *shape = &x->fm->shape;

    for (uint32_t n = 0; n < x->p->pairs; n++) {
        const ProvePair *pair = &x->p->pair[n];
        if (is_start || (lasts(x, pair->x) && lasts(x, pair->y)))
            env = env_set(shape, env, pair->var, is_start ? prove_difference(env_get(shape, env, pair->x), env_get(shape, env, pair->y)) : env_get(shape, before, pair->var));
    }
    return env;
}

// Returns the facts at the start of a step that follows a step which ended with the facts `before`.
static const Env *begin_step(const Explorer *x, const Env *before, bool is_start, uint32_t state, bool first)
{
    const EnvShape *shape = &x->fm->shape;
    const Env *env = NULL;

    for (uint32_t v = 0; v < x->p->ir->var.n; v++) {
        const Fact known = env_get(shape, before, v);
        Fact f = fact_at_begin(x, v, is_start ? NULL : &known, state, first);
        if (v == x->p->ir->t)
            round_time(&f, x->p->delta_t);
        if (!fact_equal(f, fact_of_type(x->p->ir->var.at[v].type)))
            env = env_set(shape, env, v, f);
    }
    return begin_differences(x, before, is_start, env);
}

// ---- nodes ----

static uint64_t key_of(Fact f) { return f.lo == f.hi && !f.nan ? sm_bits(f.lo == 0 ? 0.0 : f.lo) : KEY_OPEN; }

static uint64_t mix_hash(uint64_t h, uint64_t x)
{
    h = (h ^ x) * UINT64_C(0x9e3779b97f4a7c15);
    return h ^ h >> 31;
}

// Returns the slot of the hash table for a node: that of an equal node, or else a free one.
static uint32_t *find_slot(const Explorer *x, const ProveTable *t, const ProveNode *n)
{
    uint64_t at = n->hash & (t->slots - 1);

    for (;; at = (at + 1) & (t->slots - 1)) {
        const ProveNode *of = t->slot[at] ? &t->node.at[t->slot[at] - 1] : NULL;
        if (!of || (of->hash == n->hash && of->state == n->state && of->first == n->first
                    && (x->keys == 0 || memcmp(of->key, n->key, x->keys * sizeof *n->key) == 0)))
            return &t->slot[at];
    }
}

static void grow_table(Explorer *x, ProveTable *t)
{
    t->slots *= 2;
    t->slot = ARENA_ARRAY(x->arena, uint32_t, t->slots);
    for (uint32_t n = 0; n < t->node.n; n++)
        *find_slot(x, t, &t->node.at[n]) = n + 1;
}

static ProveTable *new_table(Explorer *x)
{
    ProveTable *t = ARENA_NEW(x->arena, ProveTable);

    t->slots = 256;
    t->slot = ARENA_ARRAY(x->arena, uint32_t, t->slots);
    return t;
}

// Queues a node, so that the steps from it are explored again.
static void queue_node(Explorer *x, ProveTable *t, uint32_t n)
{
    if (t->node.at[n].queued)
        return;
    t->node.at[n].queued = true;
    vec_push(x->arena, &t->queue, n);
}

// Joins facts of one more path into those of a node.
static void join_at_node(Explorer *x, uint32_t number, const Env *env)
{
    static const double round[] = {-FACT_EXACT, -1e6, -1, 0, 1, 255, 65535, 1e6, FACT_EXACT};
    static const FactLimits few = {round, sizeof round / sizeof *round};
    ProveNode *n = &x->table->node.at[number];
    const FactLimits *widen = !x->widens || n->changes < CHANGES_BEFORE_WIDENING ? NULL : n->changes < CHANGES_BEFORE_FEW_LIMITS * x->patience ? &x->widening : &few;
    const Env *now = env_join(&x->fm->shape, n->env, env, widen);

    if (now == n->env)
        return;
    if (x->widens && n->changes > CHANGES_MOST * x->patience)
        now = begin_step(x, NULL, false, n->state, n->first);
    n->env = now;
    n->changes++;
    queue_node(x, x->table, number);
}

// Adds a state of the machine with these facts: joins them with those of an equal node, and queues it if they have changed.
static void add_node(Explorer *x, const Env *env, uint32_t state, bool first)
{
    ProveTable *t = x->table;
    ProveNode n = {.env = env, .state = state, .first = first};
    uint32_t *slot;

    n.key = ARENA_ARRAY(x->arena, uint64_t, x->keys + 1);
    n.hash = mix_hash(state, first);
    for (uint32_t k = 0; k < x->keys; k++) {
        n.key[k] = key_of(env_get(&x->fm->shape, env, x->key[k]));
        n.hash = mix_hash(n.hash, n.key[k]);
    }
    slot = find_slot(x, t, &n);
    if (*slot) {
        join_at_node(x, *slot - 1, env);
        return;
    }
    vec_push(x->arena, &t->node, n);
    *slot = t->node.n;
    queue_node(x, t, t->node.n - 1);
    if (t->node.n * 2 > t->slots)
        grow_table(x, t);
}

// ---- a step ----

// Removes from env what no later block reads, and what the next step does not begin with: paths that differ in nothing else become equal.
static const Env *forget_dead_variables(const Explorer *x, const Env *env, const uint64_t *live)
{
    const EnvShape *shape = &x->fm->shape;

    for (uint32_t v = 0; v < x->p->ir->var.n; v++) {
        const ProveVarKind kind = x->p->var[v].kind;
        const bool lost = kind == PROVE_INPUT || (kind == PROVE_CHOICE && v != x->p->next && v != x->p->premise) || (kind == PROVE_OUTPUT && !is_assumed(x, PROVE_OWN_OUTPUTS));
        if (lost && !bitset_has(live, v) && env_find(shape, env, v) && !(kind == PROVE_OUTPUT && x->p->var[v].stored))
            env = env_set(shape, env, v, fact_of_type(x->p->ir->var.at[v].type));
    }
    return env;
}

// Adds facts with which a path comes to a block.
static void enter_block(Explorer *x, IrBlkRef block, const Env *env)
{
    ProveEnvs *at = &x->at[block];
    const uint32_t t = x->p->ir->t;
    Fact time = env_get(&x->fm->shape, env, t);
    const Fact was = time;

    if (!round_time(&time, x->p->delta_t))
        return;
    if (!fact_equal(time, was))
        env = env_set(&x->fm->shape, env, t, time);
    env = forget_dead_variables(x, env, x->step->block[block].live);
    for (uint32_t n = 0; n < at->n; n++)
        if (at->at[n] == env)
            return;
    if (at->n < ENVS_MOST)
        vec_push(x->arena, at, env);
    else
        at->at[at->n - 1] = env_join(&x->fm->shape, at->at[at->n - 1], env, NULL);
}

// Extends what is true after each step of the state by `env`.
static void join_facts_after_step(Explorer *x, const Env *env)
{
    const uint32_t vars = x->p->ir->var.n, state = x->from->state;
    Fact *after = x->out->after + (size_t)state * vars;

    for (uint32_t v = 0; v < vars; v++) {
        const Fact f = env_get(&x->fm->shape, env, v);
        after[v] = x->out->reached[state] ? fact_join(after[v], f) : f;
    }
    x->out->reached[state] = true;
}

// Ends a step that meets the requirement: adds what can follow.
static void end_step(Explorer *x, const Env *env)
{
    const Fact next = env_get(&x->fm->shape, env, x->p->next);
    const double states = (double)x->p->machine->state.n;
    const double hi = next.hi > states ? states : next.hi;

    join_facts_after_step(x, env);
    for (double n = next.lo < 0 ? 0 : next.lo; n <= hi; n++) {
        const bool first = n > 0;
        const uint32_t state = first ? (uint32_t)n - 1 : x->from->state;
        add_node(x, begin_step(x, env, false, state, first), state, first);
    }
}

// Called for each end of the block of a branch.
static void visit_edge(void *context, const IrJump *end, const Env *env)
{
    Explorer *x = context;

    if (end != &x->branch->fn->blk.at[1].jump)
        return;
    x->is_taken = true;
    x->taken = env;
}

// Whether the known differences of variables (x->p->pair) allow the branch.  If so, adds the differences after it to the facts at its end.
static bool update_differences(Explorer *x, const Fact *of, const Env *begin)
{
    const IrFn *f = x->branch->fn;

    if (x->p->pairs == 0)
        return true;
    if (f->ins.n >= x->holders) {
        x->holders = f->ins.n * 2 + 1;
        x->holder = ARENA_ARRAY(x->arena, uint32_t, x->holders);
    }
    return prove_relate(&(ProveFlow){x->p, &x->fm->shape, f, of, x->holder, begin}, &x->taken);
}

// Follows one branch of a block from the facts `env`; the facts decide which of its edges are taken.
static void follow_branch(Explorer *x, const ProveBranch *branch, const Env *env)
{
    const FactEnds ends = {.visit = visit_edge, .context = x, .all = true};
    const Fact *of;

    x->branch = branch;
    x->is_taken = false;
    ++*x->visits;
    of = facts_flow(x->fm, branch->fn, env, &ends).of;
    if (!x->is_taken || !update_differences(x, of, env))
        return;
    if (branch->then == IR_NONE)
        end_step(x, x->taken);
    else
        enter_block(x, branch->then, x->taken);
}

// Follows the branches of a block from each of the facts with which runs come to it.
static void visit_block(Explorer *x, IrBlkRef b)
{
    const ProveBlock *block = &x->step->block[b];

    if (block->end == PROVE_END_IMPOSSIBLE)
        return;
    for (uint32_t n = 0; n < x->at[b].n; n++) {
        const Env *env = x->at[b].at[n];
        if (block->end != PROVE_END_NONE)
            x->out->premise |= env_get(&x->fm->shape, env, x->p->premise).hi > 0;
        if (block->end == PROVE_END_VIOLATED)
            x->out->violated = true;
        for (uint32_t k = 0; k < block->branch.n && block->end != PROVE_END_VIOLATED; k++)
            follow_branch(x, &block->branch.at[k], env);
    }
}

// Explores the step that begins with the facts of a node.
static void explore_step(Explorer *x, const ProveNode *from)
{
    x->from = from;
    x->out->entered[from->state] = true;
    x->step = prove_model_step(x->p, from->state, from->first);
    if (x->step->fn->blk.n > x->blocks) {
        x->blocks = x->step->fn->blk.n * 2;
        x->at = arena_array(x->arena, x->blocks, sizeof *x->at);
    }
    for (uint32_t b = 0; b < x->step->fn->blk.n; b++)
        x->at[b].n = 0;
    enter_block(x, 0, from->env);
    for (uint32_t n = 0; n < x->step->blocks; n++)
        visit_block(x, x->step->order[n]);
}

// ---- the exploration ----

static void add_limit(double *limit, size_t *n, double x)
{
    size_t at = 0;

    while (at < *n && limit[at] < x)
        at++;
    if (*n == LIMITS_MOST || (at < *n && limit[at] == x) || !(x > -FACT_EXACT && x < FACT_EXACT))
        return;
    memmove(limit + at + 1, limit + at, (*n - at) * sizeof *limit);
    limit[at] = x;
    ++*n;
}

// Adds a constant with its neighbours, and a negated one: `-5` is the negation of 5.
static void add_limits_of(double *limit, size_t *n, const IrFn *f, const IrIns *i, const double *beside)
{
    const IrIns *negated = i->op == IR_neg ? &f->ins.at[i->a] : NULL;

    for (int k = 0; i->op == IR_const && k < BESIDE; k++)
        add_limit(limit, n, ir_number(i->type, i->bits) + beside[k]);
    if (negated && negated->op == IR_const)
        add_limit(limit, n, -ir_number(negated->type, negated->bits));
}

// Returns the constants of the machine and of the requirement with their neighbours: guards stop counters and times there.
static FactLimits find_limits(double *limit, const ProveModel *p)
{
    const double delta = (double)p->delta_t, beside[BESIDE] = {0, -1, 1, -delta, delta};
    size_t n = 0;

    add_limit(limit, &n, 0);
    for (int k = 0; k < BESIDE; k++)
        add_limit(limit, &n, (double)p->what->within + beside[k]);
    for (size_t s = 0; s < p->machine->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++) {
            const IrFn *f = p->machine->state.at[s].block[b];
            for (uint32_t i = 0; f && i < f->ins.n; i++)
                add_limits_of(limit, &n, f, &f->ins.at[i], beside);
        }
    return (FactLimits){limit, n};
}

// Whether the variable is already in the list of those with too many values.
static bool is_noted(const ProveExplored *out, uint32_t var)
{
    for (uint32_t n = 0; n < out->wides; n++)
        if (out->wide[n] == var)
            return true;
    return false;
}

static void record_wide_variable(ProveExplored *out, uint32_t var)
{
    if (out->wides < PROVE_WIDES && !is_noted(out, var))
        out->wide[out->wides++] = var;
}

// Returns the key with the most different values among the nodes.  Keys that are noted, or have at most `least` values, do not count.  Returns
// `keys` if no key is left.
static uint32_t find_widest_key(const Explorer *x, uint32_t least)
{
    enum { SAMPLE = 4096 };
    uint64_t *seen = ARENA_ARRAY(x->arena, uint64_t, 2 * SAMPLE);
    uint32_t widest = x->keys, most = least;

    for (uint32_t k = 0; k < x->keys; k++) {
        uint32_t values = 0;
        if (is_noted(x->out, x->key[k]))
            continue;
        memset(seen, 0, 2 * SAMPLE * sizeof *seen);
        for (uint32_t n = 0; n < x->table->node.n && values < SAMPLE; n++) {
            const uint64_t value = x->table->node.at[n].key[k] + 2;       // never 0, which marks an empty entry of `seen`
            uint64_t at = mix_hash(value, 7) & (2 * SAMPLE - 1);
            while (seen[at] && seen[at] != value)
                at = (at + 1) & (2 * SAMPLE - 1);
            values += seen[at] == 0;
            seen[at] = value;
        }
        if (values > most) {
            most = values;
            widest = k;
        }
    }
    return widest;
}

typedef enum ExploreEnd { EXPLORE_CLOSED, EXPLORE_MANY_NODES, EXPLORE_MANY_VISITS, EXPLORE_STOPPED } ExploreEnd;

static bool goes_on(const Explorer *x) { return !x->limits->go_on || x->limits->go_on(x->limits->context); }

// Explores steps from the first state on until no fact changes, or a limit of nodes, visits or memory is met.
static ExploreEnd explore_until_closed(Explorer *x, const State *init)
{
    ProveTable *t = x->table = new_table(x);

    x->widens = true;
    add_node(x, begin_step(x, NULL, true, init->number - 1, true), init->number - 1, true);
    while (t->next < t->queue.n) {
        const uint32_t n = t->queue.at[t->next++];
        const ProveNode from = t->node.at[n];
        t->node.at[n].queued = false;
        explore_step(x, &from);
        if (t->node.n > x->limits->nodes)
            return EXPLORE_MANY_NODES;
        if (*x->visits > x->limits->visits || (x->limits->memory && arena_size(x->arena) > x->limits->memory))
            return EXPLORE_MANY_VISITS;
        if (!goes_on(x))
            return EXPLORE_STOPPED;
    }
    return EXPLORE_CLOSED;
}

// Computes tighter facts.  The nodes of explore_all have too wide bounds, but they contain every value that a run can have when a step begins.
// So the initial values, together with all results of one step from these nodes, contain every such value, too.  This step does not widen.
static ExploreEnd narrow_facts(Explorer *x, const State *init)
{
    ProveTable *from = x->table;

    x->table = new_table(x);
    x->widens = false;
    x->out->violated = x->out->premise = false;
    memset(x->out->reached, 0, x->p->machine->state.n * sizeof *x->out->reached);
    memset(x->out->entered, 0, x->p->machine->state.n * sizeof *x->out->entered);
    add_node(x, begin_step(x, NULL, true, init->number - 1, true), init->number - 1, true);
    for (uint32_t n = 0; n < from->node.n; n++) {
        if (!goes_on(x))
            return EXPLORE_STOPPED;
        explore_step(x, &from->node.at[n]);
    }
    return EXPLORE_CLOSED;
}

// Starts with fresh tables of facts.
static void new_facts(Explorer *x)
{
    x->fm = facts_of_machine(x->arena, x->p->ir);
    if (!x->fm->shape.unique)
        x->fm->shape.unique = env_table_new(x->arena);        // equal facts become the same pointer
    x->at = NULL;
    x->blocks = x->holders = 0;
}

// Collects the bounds of the facts of all nodes.
static void find_bounds(Explorer *x)
{
    x->founds = 0;
    add_limit(x->found, &x->founds, 0);
    for (uint32_t n = 0; n < x->table->node.n; n++)
        for (uint32_t v = 0; v < x->p->ir->var.n; v++) {
            const Fact *f = env_find(&x->fm->shape, x->table->node.at[n].env, v);
            if (!f || f->lo > f->hi || x->p->var[v].kind == PROVE_INPUT || x->p->var[v].kind == PROVE_CHOICE)
                continue;
            add_limit(x->found, &x->founds, f->lo);
            add_limit(x->found, &x->founds, f->hi);
        }
}

// Explores until nothing changes, then narrows the facts as long as that can still prove the requirement.
static ExploreEnd explore_once(Explorer *x, const State *init)
{
    ExploreEnd end;

    new_facts(x);
    end = explore_until_closed(x, init);
    for (int k = 0; end == EXPLORE_CLOSED && k < NARROWINGS && (k == 0 || x->out->violated || x->out->premise); k++)
        end = narrow_facts(x, init);
    x->out->nodes = x->table->node.n;
    if (end == EXPLORE_CLOSED && x->out->violated)
        find_bounds(x);
    return end;
}

// Whether all values that functions store in the variable are constants, booleans, or limited counts of samples.
static bool has_few_values(const ProveModel *p, uint32_t v)
{
    if (v == p->ir->t || v == p->ir->g)
        return false;
    if (p->ir->var.at[v].type == SM_BOOL || p->var[v].few)
        return true;
    if (v >= p->machine->var.n)
        return false;
    for (size_t s = 0; s < p->machine->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++) {
            const IrFn *f = p->machine->state.at[s].block[b];
            for (uint32_t i = 0; f && i < f->ins.n; i++) {
                const IrIns *at = &f->ins.at[i];
                if (at->op != IR_store || at->var != v)
                    continue;
                at = &f->ins.at[at->a];
                while (at->op == IR_cvt)
                    at = &f->ins.at[at->a];
                if (at->op != IR_const && at->op != IR_neg)
                    return false;
            }
        }
    return true;
}

// Chooses the variables by whose values nodes are distinguished; `fine`: those with many values, too.
static uint32_t choose_keys(const Explorer *x, bool fine, uint32_t *key)
{
    uint32_t n = 0;

    for (uint32_t v = 0; v < x->p->ir->var.n; v++) {
        const bool changes = lasts(x, v) || (v == x->p->ir->t && x->p->var[v].relevant);
        if (changes && (x->p->var[v].stored || v == x->p->ir->t || v >= x->p->machine->var.n) && (fine || has_few_values(x->p, v)))
            key[n++] = v;
    }
    return n;
}

// Explores with the limits of widening in x.  `visits`: number of visits of earlier explorations.
static ProveExplored explore_within(Explorer *x, Arena *arena, Arena *work, const State *init_state, bool fine, uint64_t visits)
{
    const ProveModel *p = x->p;
    ProveExplored out = {.after = ARENA_ARRAY(arena, Fact, (size_t)p->machine->state.n * p->ir->var.n), .visits = visits};
    uint32_t *key = ARENA_ARRAY(arena, uint32_t, p->ir->var.n);
    ExploreEnd end;

    out.reached = ARENA_ARRAY(arena, bool, p->machine->state.n);
    out.entered = ARENA_ARRAY(arena, bool, p->machine->state.n);
    x->out = &out;
    x->visits = &out.visits;
    x->keys = choose_keys(x, fine, key);
    x->key = key;
    do {
        uint32_t widest = x->keys;
        arena_reset(work);
        x->arena = work;
        out.violated = out.premise = false;
        memset(out.reached, 0, p->machine->state.n * sizeof *out.reached);
        memset(out.entered, 0, p->machine->state.n * sizeof *out.entered);
        end = explore_once(x, init_state);
        if (end == EXPLORE_MANY_NODES)
            widest = find_widest_key(x, 1);
        if (end == EXPLORE_MANY_NODES && widest == x->keys)
            end = EXPLORE_MANY_VISITS;
        else if (end == EXPLORE_MANY_NODES) {
            record_wide_variable(&out, key[widest]);
            key[widest] = key[--x->keys];
        }
    } while (end == EXPLORE_MANY_NODES);
    for (uint32_t n = 0, widest; end == EXPLORE_MANY_VISITS && n < PROVE_WIDES && (widest = find_widest_key(x, MANY_VALUES)) != x->keys; n++)
        record_wide_variable(&out, key[widest]);
    out.closed = end == EXPLORE_CLOSED;
    return out;
}

// Whether the bounds of the last exploration are other limits than its own.  If so, they are the next ones.
static bool take_bounds(Explorer *x)
{
    double *const was = x->limit;
    const bool differ = x->founds != x->widening.n || memcmp(x->found, was, x->founds * sizeof *was) != 0;

    x->limit = x->found;
    x->found = was;
    x->widening = (FactLimits){x->limit, x->founds};
    x->patience = PATIENCE;
    return differ;
}

// A bound that has been widened too far stays so where a state is repeated, because narrowing explores only one step.  But the bounds of the states that
// follow are those of a run, such as the sum of two times.  So they are the limits of another exploration.
ProveExplored prove_explore(Arena *arena, Arena *work, ProveModel *p, const State *init_state, unsigned assumed, bool fine, const ProveLimits *limits)
{
    Explorer x = {.p = p, .assumed = assumed, .limits = limits, .patience = 1, .limit = ARENA_ARRAY(arena, double, LIMITS_MOST), .found = ARENA_ARRAY(arena, double, LIMITS_MOST)};
    ProveExplored out;

    x.widening = find_limits(x.limit, p);
    out = explore_within(&x, arena, work, init_state, fine, 0);
    for (int round = 1; round < ROUNDS && out.closed && out.violated && take_bounds(&x); round++) {
        const ProveExplored other = explore_within(&x, arena, work, init_state, fine, out.visits);
        out.visits = other.visits;
        if (other.closed)
            out = other;
    }
    return out;
}

bool prove_can_violate(Arena *arena, ProveModel *p)
{
    const uint32_t states = p->machine->state.n;
    ProveExplored out = {.after = ARENA_ARRAY(arena, Fact, (size_t)(states + 1) * p->ir->var.n), .reached = ARENA_ARRAY(arena, bool, states + 1), .entered = ARENA_ARRAY(arena, bool, states + 1)};
    Explorer x = {.p = p, .arena = arena, .visits = &out.visits, .out = &out};
    const ProveNode anything = {.state = states};

    new_facts(&x);
    x.table = new_table(&x);
    explore_step(&x, &anything);
    return out.violated;
}
