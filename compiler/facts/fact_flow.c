// SPDX-License-Identifier: Apache-2.0
// Facts within one function.  Control only moves forward, so one visit of the blocks in order is enough.  Each block begins with the
// facts that are true on every edge into it.
//
// Most functions use few of the machine's variables.  Inside such a function, environments have only these, as slots (slot_env.h): the
// variables that the function loads or stores, numbered from 0.  Only what the function has changed is transferred to the environments of the
// machine.
#include <string.h>

#include "compiler/facts/facts.h"
#include "compiler/ir/comparison.h"

enum { REFINEMENTS = 200 };           // conditions visited per branch: conditions that share operands form a DAG, not a tree

typedef struct FlowWalk {
    FactMachine *fm;
    const IrFn *f;
    FactFlow out;
    const FactEnds *ends;
    const Env *start;                 // the facts at the beginning of the function, of all variables of the machine
    bool has_slots;                   // environments contain only the function's slots; false: all variables, because it uses more than FACT_SLOTS
    SlotEnvs space;                   // allocates the environments of slots
    uint64_t private_slots;           // bit set of the slots of private variables (env_is_private)
    FactSlot *slot;                   // by slot: its variable, and the last block that loads it
    FactEffect *effect;               // by block: what the last visit of the block has stored; NULL: this function's visits are not stored
    FactPoint *begin;                 // by block: the facts at the block's beginning, until the block is visited
    FactPoint env;                    // the facts at the current instruction; env.slots is NULL once another block owns the environment
    SlotEnv *transferred;             // copy of the facts that env_of_machine transferred in its last call; NULL: not called yet
    const Env *transferred_to;        // the result of that transfer
    IrBlkRef block;                   // the current block
    uint32_t epoch;                   // number of the current block visit (FactMachine.epochs)
    FactHome *home;                   // by temporary: a variable that has the same value (FactHome)
    unsigned budget;                  // how many conditions may still be visited for this branch
    uint32_t edge;                    // number of the current edge (FactRefined.edge)
    uint32_t refined;                 // number of entries in FactMachine.refined_slot: the slots about which the current edge adds facts
    bool contradicts;                 // the conditions of the current edge contradict the facts, so that the edge is never taken
} FlowWalk;

static const IrIns *ins(const FlowWalk *w, IrRef r) { return &w->f->ins.at[r]; }

// ---- slots ----

static uint32_t slot_of(const FlowWalk *w, uint32_t var) { return w->has_slots ? w->fm->slot_of[var].slot : var; }

// Returns the slot of a variable that the function uses, a new one if the variable has no slot yet.
static uint32_t find_or_add_slot(FlowWalk *w, uint32_t var)
{
    FactMachine *fm = w->fm;
    FactSlotOf *of = &fm->slot_of[var];

    if (of->function != fm->functions) {
        *of = (FactSlotOf){w->space.slots, fm->functions};
        fm->slot[w->space.slots++] = (FactSlot){var, 0};
    }
    return of->slot;
}

// Assigns slots to the variables that the function uses, and finds the last block that loads each.  Returns false if there are more than FACT_SLOTS.
static bool number_slots(FlowWalk *w)
{
    w->fm->functions++;
    for (IrBlkRef b = 0; b < w->f->blk.n; b++)
        for (size_t k = 0; k < w->f->blk.at[b].ins.n; k++) {
            const IrIns *i = ins(w, w->f->blk.at[b].ins.at[k]);
            uint32_t slot;
            if (i->op != IR_load && i->op != IR_store)
                continue;
            if (w->space.slots == FACT_SLOTS)
                return false;
            slot = find_or_add_slot(w, i->var);
            if (i->op == IR_load)
                w->slot[slot].last_load = b;
        }
    return true;
}

// Whether a fact about the slot can matter in block b or later: it is loaded there, or required at the end of the function.
static bool is_needed_from(const FlowWalk *w, uint32_t slot, IrBlkRef b)
{
    const FactSlot *s = &w->slot[slot];

    return !w->has_slots || (w->ends && (w->ends->all || w->ends->exits)) || w->fm->shape.is_private[s->var] || s->last_load >= b;
}

// Stores the slots of the function, for later visits.
static void store_slots(FlowWalk *w, FactFn *fn)
{
    FactMachine *fm = w->fm;

    fn->slot = arena_copy(fm->shape.arena, fm->slot, (w->space.slots + 1u) * sizeof *fn->slot);
    fn->slots = w->space.slots;
    fn->begin = arena_alloc_unzeroed(fm->shape.arena, w->space.slots * sizeof *fn->begin);
    fn->flow.of = arena_alloc_unzeroed(fm->shape.arena, w->f->ins.n * sizeof *fn->flow.of);
    fn->flow.reached = arena_alloc_unzeroed(fm->shape.arena, w->f->blk.n * sizeof *fn->flow.reached);
    fn->flow.exit = arena_alloc_unzeroed(fm->shape.arena, w->f->blk.n * sizeof *fn->flow.exit);
    if (fm->has_variable_locals)
        fn->effect = ARENA_ARRAY(fm->shape.arena, FactEffect, w->f->blk.n);
}

// Finds the slots of the function: the stored slots of an earlier visit, or new ones.
static void find_slots(FlowWalk *w)
{
    FactMachine *fm = w->fm;
    FactFn *fn = w->ends ? w->ends->fn : NULL;

    w->slot = fm->slot;
    w->has_slots = (fn && fn->slot) || number_slots(w);
    if (!w->has_slots || !fn)
        return;
    if (!fn->slot)
        store_slots(w, fn);
    w->slot = fn->slot;
    w->space.slots = fn->slots;
    w->effect = fn->effect;
    w->out = fn->flow;
    memset(w->out.reached, 0, w->f->blk.n * sizeof *w->out.reached);
    fm->functions++;
    for (uint32_t slot = 0; slot < fn->slots; slot++)
        fm->slot_of[w->slot[slot].var] = (FactSlotOf){slot, fm->functions};
}

// Returns the facts at the beginning of the function: w->start, and `time` about T, if it is not NULL.
static FactPoint begin_function(FlowWalk *w, const Fact *time)
{
    FactMachine *fm = w->fm;
    const uint32_t t = fm->m->t;
    const FactEnds *ends = w->ends;
    Fact *begin;

    find_slots(w);
    if (!w->has_slots)
        return (FactPoint){.all = time ? env_set(&fm->shape, w->start, t, *time) : w->start};
    begin = ends && ends->fn ? ends->fn->begin : fm->slot_begin;
    for (uint32_t slot = 0; slot < w->space.slots; slot++) {
        const uint32_t var = w->slot[slot].var;
        begin[slot] = time && var == t ? *time : env_get(&fm->shape, w->start, var);
        w->private_slots |= (uint64_t)fm->shape.is_private[var] << slot;
    }
    w->space.arena = &fm->local;
    w->space.begin = begin;
    return (FactPoint){slot_env_new(&w->space)};
}

// ---- facts at a point ----

// Returns what is known now about the variable of a slot.
static Fact get_fact(FlowWalk *w, uint32_t slot)
{
    return w->has_slots ? *slot_env_find(&w->space, w->env.slots, slot) : env_get(&w->fm->shape, w->env.all, slot);
}

static void set_fact(FlowWalk *w, FactPoint *at, uint32_t slot, Fact fact)
{
    if (w->has_slots)
        slot_env_set(at->slots, slot, fact);
    else
        at->all = env_set(&w->fm->shape, at->all, slot, fact);
}

// Returns the current facts for an edge, which can change them.  `is_last`: the block has no other edge that is still to be followed.
static FactPoint facts_for_edge(FlowWalk *w, bool is_last)
{
    const FactPoint now = w->env;

    if (!w->has_slots)
        return now;
    if (!is_last)
        return (FactPoint){slot_env_copy(&w->space, now.slots)};
    w->env.slots = NULL;
    return now;
}

// Returns the current facts as an environment of all variables: all facts (`all`), or facts about private variables and assumed facts.
static const Env *env_of_machine(FlowWalk *w, bool all)
{
    const FactMachine *fm = w->fm;
    const SlotEnv *now = w->env.slots;
    const Env *env = w->start;
    uint64_t rest;

    if (!w->has_slots)
        return all ? w->env.all : env_replace_shared(&fm->shape, w->env.all, fm->assumed);
    if (all && w->ends->time)
        env = env_set(&fm->shape, env, fm->m->t, *w->ends->time);
    rest = now->changed & (all ? UINT64_MAX : w->private_slots);
    for (uint32_t slot = 0; rest; slot++, rest >>= 1)
        if (rest & 1)
            env = env_set(&fm->shape, env, w->slot[slot].var, now->fact[slot]);
    return env;
}

// ---- ends ----

// Stores, for later visits of the function, the facts of an end that differ from those at its beginning.  Called if the end's facts are not those of
// the previous end.
static void store_updates(FlowWalk *w, FactEnd *end)
{
    const SlotEnv *now = w->env.slots;
    uint64_t rest = now->changed & w->private_slots;

    for (uint32_t slot = 0; rest; slot++, rest >>= 1)
        if (rest & 1) {
            const FactUpdate update = {slot, now->fact[slot]};
            vec_push(w->fm->shape.arena, &w->ends->fn->update, update);
            end->updates++;
        }
}

// Calls the caller's function for an end of this function.  Stores the end, for later visits.  Several ends often have the same facts, so that
// the caller receives the same environment.
static void visit_function_end(FlowWalk *w, const IrJump *j)
{
    const uint64_t set = w->ends->all ? UINT64_MAX : w->private_slots;
    FactEnd end = {j, false, 0};

    end.is_as_before = w->has_slots && w->transferred && slot_env_is_same(w->transferred, w->env.slots, set);
    if (!end.is_as_before) {
        w->transferred_to = env_of_machine(w, w->ends->all);
        if (w->has_slots)
            w->transferred = slot_env_copy(&w->space, w->env.slots);
    }
    if (w->effect && !end.is_as_before)
        store_updates(w, &end);
    if (w->effect)
        vec_push(w->fm->shape.arena, &w->ends->fn->end, end);
    w->ends->visit(w->ends->context, j, w->transferred_to);
}

// Whether the function begins with the same facts as in its last visit, apart from facts that the visit has not read.  Facts that are assumed
// never change.
static bool has_same_begin(const FactMachine *fm, const FactFn *fn, const Env *begin)
{
    for (uint32_t slot = 0; slot < fn->slots; slot++) {
        const uint32_t var = fn->slot[slot].var;
        if (fn->read >> slot & 1 && fm->shape.is_private[var] && !fact_equal(env_get(&fm->shape, begin, var), fn->begin[slot]))
            return false;
    }
    return true;
}

// Calls ends->visit for the ends that the last visit of the function reached, with the facts recorded then.
static void repeat_ends(const FactMachine *fm, const FactEnds *ends, const Env *begin)
{
    const FactFn *fn = ends->fn;
    const Env *env = begin;
    size_t at = 0;

    for (size_t k = 0; k < fn->end.n; k++) {
        const FactEnd *end = &fn->end.at[k];
        if (!end->is_as_before)
            env = begin;
        for (uint32_t n = end->updates; n > 0; n--, at++)
            env = env_set(&fm->shape, env, fn->slot[fn->update.at[at].slot].var, fn->update.at[at].fact);
        ends->visit(ends->context, end->jump, env);
    }
}

// ---- effects of blocks ----

// Sets the fact about a slot in *env, if it can matter in block b or later.
static void set_if_needed(FlowWalk *w, FactPoint *env, uint32_t slot, Fact fact, IrBlkRef b)
{
    if (!is_needed_from(w, slot, b))
        return;
    set_fact(w, env, slot, fact);
    if (w->effect)
        vec_push(w->fm->shape.arena, &w->fm->update, ((FactUpdate){slot, fact}));
}

// Returns what is known about a variable that the current block loads.  With w->effect, also records the load and the known values, unless
// the block has stored to the variable before.
static Fact load_fact(FlowWalk *w, uint32_t var)
{
    const uint32_t slot = slot_of(w, var);
    const Fact fact = get_fact(w, slot);

    if (w->effect && w->fm->epoch[var] != w->epoch)       // not stored by this block before
        vec_push(w->fm->shape.arena, &w->fm->load, ((FactUpdate){slot, fact}));
    return fact;
}

// ---- instructions ----

// Computes the fact of temporary r, or applies the effect of a store or sample.  `at`: the instruction's position in its block.
static void visit_ins(FlowWalk *w, IrRef r, uint32_t at)
{
    static const Fact none;
    const IrIns *i = ins(w, r);

    w->home[r] = (FactHome){i->op == IR_load ? i->var : IR_NONE, at};
    if (i->op == IR_store) {
        Fact stored = w->out.of[i->a];
        stored.nan = false;
        set_if_needed(w, &w->env, slot_of(w, i->var), stored, w->block);
        w->fm->epoch[i->var] = w->epoch;
        w->fm->stored[i->var] = at;
        w->home[i->a] = (FactHome){i->var, at};
    } else if (i->op == IR_sample) {
        w->fm->window[i->var] = fact_convert(w->out.of[i->a], SM_F64);
    } else if (i->op == IR_load) {
        w->out.of[r] = load_fact(w, i->var);
    } else if (i->op == IR_stat) {
        w->out.of[r] = fact_of_stat(i->stat, w->fm->window[i->var]);
    } else {
        const Fact *a = i->a == IR_NONE ? &none : &w->out.of[i->a], *b = i->b == IR_NONE ? &none : &w->out.of[i->b];
        w->out.of[r] = fact_of_result(i, a, b, i->a == IR_NONE ? i->type : ins(w, i->a)->type);
    }
}

// ---- facts from a branch ----

// Whether temporary r has a home (FactHome) that still contains r's value: no later store in this block has changed it.  If
// neither this block nor later ones need the variable, its fact may be out of date, because set_if_needed left out a store; then r has no home.
static bool has_home(const FlowWalk *w, IrRef r)
{
    const FactHome h = w->home[r];

    return h.var != IR_NONE && is_needed_from(w, slot_of(w, h.var), w->block)
        && (w->fm->epoch[h.var] != w->epoch || w->fm->stored[h.var] <= h.at);
}

// Converts bounds of an F64 that was converted from a value of this type to bounds of that value.  For a 64-bit integer, a bound is kept
// only where the conversion is exact.
static Fact bounds_before_conversion(Fact bounds, SmType type)
{
    if (sm_type_info[type].bytes == 8 && type != SM_F64) {
        const Fact t = fact_of_type(type);
        if (!(bounds.lo > -FACT_EXACT && bounds.lo < FACT_EXACT))
            bounds.lo = t.lo;
        if (!(bounds.hi > -FACT_EXACT && bounds.hi < FACT_EXACT))
            bounds.hi = t.hi;
        bounds.round_trips = false;
    }
    return bounds;
}

// Returns what is known on the current edge about the slot, which the caller may replace by a better fact.
static Fact *refined_fact(FlowWalk *w, uint32_t slot)
{
    FactRefined *r = &w->fm->refined[slot];

    if (r->edge != w->edge) {
        r->edge = w->edge;
        r->fact = get_fact(w, slot);
        w->fm->refined_slot[w->refined++] = slot;
    }
    return &r->fact;
}

static void refine_value(FlowWalk *w, IrRef r, Fact bounds);

// Adds what follows for the operands of i from its result being within bounds and not NaN: max(a, b) < 5 bounds a and b.
static void refine_operands(FlowWalk *w, const IrIns *i, Fact bounds)
{
    const bool is_float = i->type == SM_F64 || i->type == SM_F32;         // an integer's abs and neg saturate
    const double none = fact_of_type(SM_F64).hi;
    Fact side[2] = {{.lo = -none, .hi = none, .minus_zero = true}, {.lo = -none, .hi = none, .minus_zero = true}};

    if (w->budget == 0 || !(i->op == IR_max || i->op == IR_min || (is_float && (i->op == IR_abs || i->op == IR_neg))))
        return;
    w->budget--;
    if (i->op == IR_abs || i->op == IR_neg) {
        side[0].lo = -bounds.hi;
        side[0].hi = i->op == IR_abs ? bounds.hi : -bounds.lo;
        refine_value(w, i->a, side[0]);
        return;
    }
    for (int k = 0; k < 2; k++) {
        const Fact other = w->out.of[k ? i->a : i->b];
        const bool is_max = i->op == IR_max;
        if (is_max || other.lo > bounds.hi)
            side[k].hi = bounds.hi;
        if (!is_max || other.hi < bounds.lo)
            side[k].lo = bounds.lo;
    }
    refine_value(w, i->a, side[0]);
    refine_value(w, i->b, side[1]);
}

// Adds the fact that r is within bounds and not NaN on the current edge, for the home variable (FactHome) of r and of the values from which
// r was converted.  Sets w->contradicts if no value remains: so `p > 20 and p < 10` is found to be always false, although neither half is.
static void refine_value(FlowWalk *w, IrRef r, Fact bounds)
{
    w->contradicts |= bounds.lo > bounds.hi;
    for (;; r = ins(w, r)->a) {
        if (has_home(w, r)) {
            Fact *known = refined_fact(w, slot_of(w, w->home[r].var));
            w->contradicts |= known->lo > bounds.hi || bounds.lo > known->hi;
            *known = fact_meet(*known, bounds);
        }
        refine_operands(w, ins(w, r), bounds);
        if (ins(w, r)->op != IR_cvt || ins(w, r)->type != SM_F64 || w->out.of[ins(w, r)->a].nan)
            return;
        bounds = bounds_before_conversion(bounds, ins(w, ins(w, r)->a)->type);
    }
}

// Whether a comparison compares the exact value of r.  It converts 64-bit integers to F64, which rounds from 2^53 on.  If an operand is
// rounded, a bound of one operand does not follow from a bound of the other.
static bool is_compared_exactly(const FlowWalk *w, IrRef r)
{
    const SmType type = ins(w, r)->type;

    return sm_type_info[type].bytes < 8 || type == SM_F64 || fact_within(w->out.of[r], -FACT_EXACT + 1, FACT_EXACT - 1);
}

// If r is a load, adds the fact that r is NaN or within bounds on the current edge. Not for other values: where r is NaN, a variable to which r was
// stored contains 0, because stores and conversions turn NaN into 0.
static void refine_unless_nan(FlowWalk *w, IrRef r, Fact bounds)
{
    Fact *known;

    if (ins(w, r)->op != IR_load || !has_home(w, r))
        return;
    known = refined_fact(w, slot_of(w, w->home[r].var));
    bounds.nan = true;
    *known = fact_meet(*known, bounds);
}

// Adds what follows from comparison i being true (`holds`) or false.
static void refine_comparison(FlowWalk *w, const IrIns *i, bool holds)
{
    Fact a = w->out.of[i->a], b = w->out.of[i->b];
    const bool a_nan = a.nan, b_nan = b.nan, may_be_nan = (a_nan || b_nan) && holds != (i->op != IR_ne);
    const bool a_exact = is_compared_exactly(w, i->a), b_exact = is_compared_exactly(w, i->b);

    if (a.lo > a.hi || b.lo > b.hi || (may_be_nan && a_nan && b_nan))
        return;
    if (!a_exact && !(b_exact && b.lo == b.hi))
        return;
    if (!b_exact && !(a_exact && a.lo == a.hi))
        return;
    fact_bound_by_comparison(&a, holds ? i->op : ir_negated_comparison(i->op), &b);
    if (may_be_nan) {                             // the comparison says nothing about the other operand if this one is NaN
        refine_unless_nan(w, a_nan ? i->a : i->b, a_nan ? a : b);
        return;
    }
    a.nan = b.nan = false;
    refine_value(w, i->a, a);
    refine_value(w, i->b, b);
}

// Adds what follows from condition r being true (`holds`) or false.
static void refine_by_condition(FlowWalk *w, IrRef r, bool holds)
{
    const IrIns *i = ins(w, r);

    if (w->budget == 0)
        return;
    w->budget--;
    if (i->op == IR_not) {
        refine_by_condition(w, i->a, !holds);
    } else if ((i->op == IR_and && holds) || (i->op == IR_or && !holds)) {
        refine_by_condition(w, i->a, holds);
        refine_by_condition(w, i->b, holds);
    } else if (ir_op_info[i->op].types == IR_T_COMPARE) {
        refine_comparison(w, i, holds);
    } else {
        refine_value(w, r, fact_of_bool(!holds, holds));
    }
}

// ---- blocks ----

// Merges the facts `env` of an edge to block `to` into the facts at the beginning of that block.
static void join_at_block(FlowWalk *w, IrBlkRef to, FactPoint env)
{
    if (!w->out.reached[to]) {
        w->begin[to] = env;
    } else if (!w->has_slots) {
        w->begin[to].all = env_join(&w->fm->shape, w->begin[to].all, env.all, NULL);
    } else {
        slot_env_join(&w->space, w->begin[to].slots, env.slots);
        slot_env_free(&w->space, env.slots);
    }
    w->out.reached[to] = true;
}

// Follows the edge to block `to` that is taken if cond is true (`holds`) or false.  The edge for true must be followed first.  Returns whether the
// facts allow that edge.
static bool follow_edge(FlowWalk *w, IrRef cond, bool holds, IrBlkRef to)
{
    const Fact f = w->out.of[cond];
    FactPoint env;

    if (holds ? f.hi < 1 : f.lo > 0)
        return false;
    w->budget = REFINEMENTS;
    w->contradicts = false;
    w->refined = 0;
    w->edge = ++w->fm->edges;
    refine_by_condition(w, cond, holds);
    if (w->contradicts)
        return false;
    env = facts_for_edge(w, !holds);
    for (uint32_t k = 0; k < w->refined; k++)
        set_if_needed(w, &env, w->fm->refined_slot[k], w->fm->refined[w->fm->refined_slot[k]].fact, to);
    join_at_block(w, to, env);
    return true;
}

// Computes the facts in the current block, and follows its edges.
static void visit_instructions(FlowWalk *w, FactEffect *effect)
{
    const IrBlk *block = &w->f->blk.at[w->block];
    const IrJump *j = &block->jump;
    FactExit *exit = &w->out.exit[w->block];

    w->epoch = ++w->fm->epochs;
    for (uint32_t k = 0; k < block->ins.n; k++)
        visit_ins(w, block->ins.at[k], k);
    effect->stores = (uint32_t)w->fm->update.n;
    exit->env = w->ends && w->ends->exits && (j->kind == IR_BR || j->kind == IR_GOTO) ? env_of_machine(w, true) : NULL;
    if (j->kind == IR_JMP) {
        join_at_block(w, j->then, facts_for_edge(w, true));
    } else if (j->kind == IR_BR) {
        effect->then = exit->then = follow_edge(w, j->cond, true, j->then);
        effect->on_then = (uint32_t)w->fm->update.n - effect->stores;
        effect->otherwise = exit->otherwise = follow_edge(w, j->cond, false, j->otherwise);
        effect->on_otherwise = (uint32_t)w->fm->update.n - effect->stores - effect->on_then;
    } else if (w->ends && w->ends->visit) {
        visit_function_end(w, j);
    }
}

// Whether the block loads the same facts as when its effect was stored.
static bool has_same_loads(FlowWalk *w, const FactEffect *effect)
{
    if (!effect->known)
        return false;
    for (uint32_t k = 0; k < effect->loads; k++)
        if (!fact_equal(get_fact(w, effect->load[k].slot), effect->load[k].fact))
            return false;
    return true;
}

// Follows an edge on which the n facts of `update` are added.
static void repeat_edge(FlowWalk *w, IrBlkRef to, const FactUpdate *update, uint32_t n, bool is_last)
{
    const FactPoint env = facts_for_edge(w, is_last);

    for (uint32_t k = 0; k < n; k++)
        slot_env_set(env.slots, update[k].slot, update[k].fact);
    join_at_block(w, to, env);
}

// Does what visit_instructions does, from the stored effect.
static void repeat_effect(FlowWalk *w, const FactEffect *e)
{
    const IrJump *j = &w->f->blk.at[w->block].jump;

    w->out.exit[w->block] = (FactExit){NULL, e->then, e->otherwise};
    for (uint32_t k = 0; k < e->stores; k++)
        slot_env_set(w->env.slots, e->update[k].slot, e->update[k].fact);
    if (j->kind == IR_JMP)
        repeat_edge(w, j->then, NULL, 0, true);
    else if (j->kind != IR_BR)
        visit_function_end(w, j);
    if (e->then)
        repeat_edge(w, j->then, e->update + e->stores, e->on_then, false);
    if (e->otherwise)
        repeat_edge(w, j->otherwise, e->update + e->stores + e->on_then, e->on_otherwise, true);
}

// Returns a copy of n updates: in `old`, the memory of `room` others that are no longer needed, if they fit there.
static FactUpdate *copy_updates(Arena *arena, const FactUpdate *from, size_t n, FactUpdate *old, size_t room)
{
    if (n > room)
        return arena_copy(arena, from, n * sizeof *from);
    if (n > 0)
        memcpy(old, from, n * sizeof *from);
    return old;
}

// Stores the facts that the visit of the current block has recorded.  They replace the facts of an earlier visit.
static void store_effect(FlowWalk *w, FactEffect *effect)
{
    FactMachine *fm = w->fm;
    const FactEffect *old = &w->effect[w->block];

    effect->known = true;
    effect->loads = (uint32_t)fm->load.n;
    effect->load = copy_updates(fm->shape.arena, fm->load.at, fm->load.n, old->load, old->loads);
    effect->update = copy_updates(fm->shape.arena, fm->update.at, fm->update.n, old->update, old->stores + old->on_then + old->on_otherwise);
    w->effect[w->block] = *effect;
}

// Computes the facts of block b: visits its instructions, or repeats the effect of the last visit if the facts about the variables that b loads
// have not changed.
static void visit_block(FlowWalk *w, IrBlkRef b)
{
    FactEffect effect = {0};

    w->block = b;
    w->env = w->begin[b];
    if (w->effect && has_same_loads(w, &w->effect[b])) {
        repeat_effect(w, &w->effect[b]);
    } else {
        w->fm->load.n = w->fm->update.n = 0;
        visit_instructions(w, &effect);
        if (w->effect)
            store_effect(w, &effect);
    }
    if (w->has_slots && w->env.slots)
        slot_env_free(&w->space, w->env.slots);
}

// Lets w use the tables of the machine (FactMachine), after growing them if the function needs larger ones.  The tables are used again
// for each function, because thousands of functions are analysed several times each.
static void reuse_tables(FlowWalk *w)
{
    FactMachine *fm = w->fm;
    Arena *arena = fm->shape.arena;

    if (w->f->ins.n > fm->temps) {
        fm->temps = w->f->ins.n * 2;
        fm->of = arena_alloc_unzeroed(arena, fm->temps * sizeof *fm->of);
        fm->home = arena_alloc_unzeroed(arena, fm->temps * sizeof *fm->home);
    }
    if (w->f->blk.n > fm->blocks) {
        fm->blocks = w->f->blk.n * 2;
        fm->reached = arena_alloc_unzeroed(arena, fm->blocks * sizeof *fm->reached);
        fm->exit = arena_alloc_unzeroed(arena, fm->blocks * sizeof *fm->exit);
        fm->block_begin = arena_alloc_unzeroed(arena, fm->blocks * sizeof *fm->block_begin);
    }
    memset(fm->reached, 0, w->f->blk.n * sizeof *fm->reached);
    w->out.of = fm->of;
    w->out.reached = fm->reached;
    w->out.exit = fm->exit;
    w->home = fm->home;
    w->begin = fm->block_begin;
}

// Computes the facts of all temporaries and blocks of f, which begins with the facts `begin`.  `ends` may be NULL.
FactFlow facts_flow(FactMachine *fm, const IrFn *f, const Env *begin, const FactEnds *ends)
{
    FlowWalk w = {.fm = fm, .f = f, .ends = ends, .start = begin};

    if (ends && ends->fn && ends->fn->effect && has_same_begin(fm, ends->fn, begin)) {
        repeat_ends(fm, ends, begin);
        return w.out;
    }
    if (ends && ends->fn)
        ends->fn->end.n = ends->fn->update.n = 0;
    arena_reset(&fm->local);
    reuse_tables(&w);
    join_at_block(&w, 0, begin_function(&w, ends ? ends->time : NULL));
    for (IrBlkRef b = 0; b < f->blk.n; b++)
        if (w.out.reached[b])
            visit_block(&w, b);
    if (w.has_slots && ends && ends->fn)
        ends->fn->read = w.space.read;
    return w.out;
}

FactFlow facts_of_function(FactMachine *fm, const IrFn *f, const Env *begin)
{
    return facts_flow(fm, f, begin, NULL);
}

FactFlow facts_of_block(FactMachine *fm, size_t state, int block)
{
    const FactFn *fn = fm->fn ? &fm->fn[state][block] : NULL;
    const Env *begin = facts_at_begin(fm, state, block);

    if (fn && fn->slot && has_same_begin(fm, fn, begin))
        return fn->flow;
    return facts_of_function(fm, fm->m->state.at[state].block[block], begin);
}
