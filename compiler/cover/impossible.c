// SPDX-License-Identifier: Apache-2.0
// Finds the places (cover.h) that no run can cover, by facts (facts.h).  A place of [all_states] has a copy of its code in each state; it is
// impossible only if no copy can be covered.

#include "compiler/analysis/transitions.h"
#include "compiler/cover/judge.h"

// The search for the places that facts exclude.
typedef struct Finder {
    const Cover *c;
    Arena *arena;
    FactMachine *facts;
    bool *possible;           // by place: facts do not exclude some copy of it
    const char **reason;      // by place: why facts exclude the copies visited so far
    uint32_t decision;        // index of the next decision, in the order of the code
    const IrFn *fn;           // the current function, and its facts
    FactFlow flow;
} Finder;

static void mark_possible(Finder *k, uint32_t place) { k->possible[place] = true; }

// ---- reasons ----

static bool is_infinite(double x) { return x - x != 0; }

// Appends the bounds that a fact gives for a value, in words: `always 3`, `at most 5`.
static void append_bounds(Buf *out, Arena *arena, Fact f)
{
    if (is_infinite(f.lo) && is_infinite(f.hi))
        buf_str(out, "a number");
    else if (f.lo == f.hi)
        buf_printf(out, "always %s", const_text(arena, f.lo));
    else if (is_infinite(f.hi))
        buf_printf(out, "at least %s", const_text(arena, f.lo));
    else if (is_infinite(f.lo))
        buf_printf(out, "at most %s", const_text(arena, f.hi));
    else
        buf_printf(out, "from %s to %s", const_text(arena, f.lo), const_text(arena, f.hi));
}

// Appends what is known about an operand, unless it is a number of the source.
static void append_operand(const Finder *k, Buf *out, IrRef ref)
{
    const IrIns *i = &k->fn->ins.at[ref];
    const Fact f = k->flow.of[ref];

    if (i->op == IR_const || (is_infinite(f.lo) && is_infinite(f.hi)))
        return;
    buf_printf(out, "%s`%s` is ", out->n ? " and " : "", source_text(k->arena, i->span));
    append_bounds(out, k->arena, f);
}

// Returns why a condition never has the value `value`.
static const char *reason_for(const Finder *k, IrRef ref, bool value)
{
    const IrIns *i = &k->fn->ins.at[ref];
    Buf out;

    buf_init(&out, k->arena);
    if (ir_op_info[i->op].types == IR_T_COMPARE) {
        append_operand(k, &out, i->a);
        append_operand(k, &out, i->b);
    }
    return out.n ? buf_text(&out) : value ? "it is never true" : "it is always true";
}

// ---- decisions ----

// Whether the facts allow a bool to have this value.
static bool can_be(const Finder *k, IrRef ref, bool value)
{
    const Fact f = k->flow.of[ref];

    return value ? f.hi > 0 : f.lo <= 0 || f.nan;
}

// What facts allow for a node of a decision: which values it can have, and whether it can decide the result.
typedef struct NodeFact { bool value[2], decides; } NodeFact;

// Finds for each part of a decision which values the facts allow, operands first.
static void judge_values(const Finder *k, const FlatDecision *d, NodeFact *fact)
{
    for (uint32_t n = 0; n < d->nodes; n++) {
        const FlatNode *node = &d->node[n];
        const bool is_and = node->kind == NODE_AND;
        for (int v = 0; v < 2; v++)
            switch (node->kind) {
            case NODE_CONDITION: fact[n].value[v] = can_be(k, d->condition[node->a], v); break;
            case NODE_NOT: fact[n].value[v] = fact[node->a].value[!v]; break;
            case NODE_AND:
            case NODE_OR:
                fact[n].value[v] = (bool)v == is_and ? fact[node->a].value[v] && fact[node->b].value[v] : fact[node->a].value[v] || fact[node->b].value[v];
                break;
            }
    }
}

// Finds which nodes facts allow to decide: an operand of `and` decides only while the other operand is true, an operand of `or` only while the
// other one is false.
static void judge_deciding(const FlatDecision *d, NodeFact *fact)
{
    fact[d->nodes - 1].decides = true;
    for (uint32_t n = d->nodes; n-- > 0; ) {
        const FlatNode *node = &d->node[n];
        const bool needed = node->kind == NODE_AND;
        if (node->kind == NODE_CONDITION)
            continue;
        fact[node->a].decides = fact[n].decides && (node->kind == NODE_NOT || fact[node->b].value[needed]);
        if (node->kind != NODE_NOT)
            fact[node->b].decides = fact[n].decides && fact[node->a].value[needed];
    }
}

// Marks a place as possible, or stores why it is not.
static void judge_place(Finder *k, uint32_t place, bool possible, const char *reason)
{
    if (possible)
        mark_possible(k, place);
    else
        k->reason[place] = reason;
}

// Finds which outcomes of a decision, and which values of its conditions, are impossible; stores the reasons.
static void judge_decision(Finder *k, const FlatDecision *d)
{
    NodeFact *fact = arena_array(k->arena, d->nodes, sizeof *fact);
    const bool single = d->nodes == 1;

    judge_values(k, d, fact);
    judge_deciding(d, fact);
    for (int v = 0; v < 2; v++)
        judge_place(k, d->hit + !v, fact[d->nodes - 1].value[v] && can_be(k, d->value, v),
                    single ? reason_for(k, d->condition[0], v) : v ? "it is never true" : "it is always true");
    for (uint32_t n = 0; n < d->nodes; n++)
        for (int v = 0; d->node[n].kind == NODE_CONDITION && v < 2; v++) {
            const uint32_t c = d->node[n].a;
            judge_place(k, d->hit + 2 + 2 * c + !v, fact[n].value[v] && fact[n].decides,
                        fact[n].value[v] ? "the other conditions always decide" : reason_for(k, d->condition[c], v));
        }
}

// ---- functions ----

// Marks as possible the statements and decisions of a block that the facts allow to run.
static void judge_block(Finder *k, const IrBlk *b)
{
    const FlatProbes *p = &k->c->probes;

    for (uint32_t i = 0; i < b->ins.n; i++) {
        const IrRef ref = b->ins.at[i];
        mark_possible(k, p->stmt[k->fn->ins.at[ref].stmt]);
        for (; k->decision < p->decisions && p->decision[k->decision].fn == k->fn && p->decision[k->decision].value == ref; k->decision++)
            judge_decision(k, &p->decision[k->decision]);
    }
    if (b->jump.kind == IR_GOTO) {
        mark_possible(k, p->stmt[b->jump.stmt]);
        mark_possible(k, p->transition[b->jump.stmt]);
    }
}

// Skips the decisions of a block that no run reaches, so that their places remain impossible.
static void skip_block(Finder *k, const IrBlk *b)
{
    const FlatProbes *p = &k->c->probes;

    for (uint32_t i = 0; i < b->ins.n; i++)
        while (k->decision < p->decisions && p->decision[k->decision].fn == k->fn && p->decision[k->decision].value == b->ins.at[i])
            k->decision++;
}

// Judges the places of function f by the facts about `form`, a form of f with the same instructions and blocks (judge.h).
static void judge_function(Finder *k, const IrFn *f, const IrFn *form, const Env *begin)
{
    k->fn = f;
    k->flow = facts_of_function(k->facts, form, begin);
    for (uint32_t b = 0; b < f->blk.n; b++)
        if (k->flow.reached[b])
            judge_block(k, &f->blk.at[b]);
        else
            skip_block(k, &f->blk.at[b]);
}

static void skip_function(Finder *k, const IrFn *f)
{
    k->fn = f;
    for (uint32_t b = 0; b < f->blk.n; b++)
        skip_block(k, &f->blk.at[b]);
}

// Copies the verdict on the samples of each shared window to every other place that counts the same samples.
static void copy_verdicts_to_shared(Finder *k)
{
    for (uint32_t i = 0; i < k->c->shared.n; i++)
        for (uint32_t n = 0; n < k->c->shared.at[i].n; n++) {
            const CoverShared s = k->c->shared.at[i];
            k->possible[s.to + n] = k->possible[s.to + n] || k->possible[s.from + n];
            k->reason[s.to + n] = k->reason[s.from + n];
        }
}

static bool is_judged(CoverKind kind) { return kind == COVER_TRANSITION || kind == COVER_STATEMENT || kind == COVER_GUARD || kind == COVER_CONDITION; }

void cover_judge_by_facts(const Cover *c, Arena *arena, FactMachine *facts, bool any_start, const char **reason)
{
    Finder k = {.c = c, .arena = arena, .facts = facts, .possible = arena_alloc(arena, c->place.n), .reason = reason};

    if (c->m->sample)
        judge_function(&k, c->m->sample, facts->m->sample, facts_at_begin_of_sample(facts));
    for (size_t s = 0; s < c->m->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++) {
            const IrFn *f = c->m->state.at[s].block[b];
            if (f && (any_start || facts_may_reach(facts, s, b)))
                judge_function(&k, f, facts->m->state.at[s].block[b], facts_at_begin(facts, s, b));
            else if (f)
                skip_function(&k, f);
        }
    copy_verdicts_to_shared(&k);
    for (uint32_t i = 1; i < c->place.n; i++)
        if (!is_judged(c->place.at[i].kind) || k.possible[i] || c->hits[i] > 0)
            reason[i] = NULL;
        else if (!reason[i])
            reason[i] = "no run reaches it";
}

void cover_find_impossible(Cover *c)
{
    const char **reason = arena_array(c->arena, c->place.n, sizeof *reason);

    cover_judge_by_facts(c, c->arena, facts_of_machine(c->arena, c->m), true, reason);
    for (uint32_t i = 1; i < c->place.n; i++)
        c->place.at[i].impossible = reason[i];
}
