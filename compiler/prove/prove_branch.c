// SPDX-License-Identifier: Apache-2.0
#include "compiler/prove/prove_make.h"

#include <string.h>


enum {
    TERMS_MOST = 12,          // the most combinations of operands that give a condition its value; if there are more, the condition is not split
    BRANCHES_MOST = 2 * TERMS_MOST,
    LITERALS_MOST = 12,       // the most conditions of one branch
    STORES_MOST = 3,          // booleans that a block stores and that are split
    DEPTH_MOST = 40
};

typedef struct ProveLiteral { IrRef ref; bool value; } ProveLiteral;

// A conjunction: conditions with their values.
typedef struct ProveTerm {
    ProveLiteral at[LITERALS_MOST];
    uint32_t n;
    ProveLiteral stored[STORES_MOST];         // `stores` booleans that the block stores: the index of the variable in `ref`, and its value
    uint32_t stores;
} ProveTerm;

typedef struct ProveTerms { ProveTerm at[BRANCHES_MOST]; uint32_t n; } ProveTerms;

// Appends the terms of `more`.  Returns false if they are too many.
static bool append_terms(ProveTerms *to, const ProveTerms *more)
{
    if (to->n + more->n > TERMS_MOST)
        return false;
    memcpy(to->at + to->n, more->at, more->n * sizeof *more->at);
    to->n += more->n;
    return true;
}

// Replaces each term by those of `term and r == value`, which exclude each other.  Returns false if they are too many.
static bool split_condition(const IrFn *f, ProveTerms *in, IrRef r, bool value, unsigned depth)
{
    const IrIns *i = &f->ins.at[r];
    ProveTerms other;

    if (depth == 0)
        return false;
    if (i->op == IR_not)
        return split_condition(f, in, i->a, !value, depth - 1);
    if (i->op != IR_and && i->op != IR_or) {
        for (uint32_t n = 0; n < in->n; n++) {
            ProveTerm *t = &in->at[n];
            if (t->n == LITERALS_MOST)
                return false;
            t->at[t->n++] = (ProveLiteral){r, value};
        }
        return true;
    }
    if ((i->op == IR_and) == value)
        return split_condition(f, in, i->a, value, depth - 1) && split_condition(f, in, i->b, value, depth - 1);
    other = *in;
    return split_condition(f, in, i->a, value, depth - 1) && split_condition(f, &other, i->a, !value, depth - 1)
        && split_condition(f, &other, i->b, value, depth - 1) && append_terms(in, &other);
}

// Whether the block stores again to the variable that instruction `at` stores to.
static bool is_stored_later(const IrFn *f, const IrBlk *b, uint32_t at)
{
    for (uint32_t n = at + 1; n < b->ins.n; n++)
        if (f->ins.at[b->ins.at[n]].op == IR_store && f->ins.at[b->ins.at[n]].var == f->ins.at[b->ins.at[at]].var)
            return true;
    return false;
}

// Splits the terms by the values of the booleans that the block stores last, unless they are constants.
static void split_stores(const IrFn *f, const IrBlk *b, ProveTerms *terms)
{
    uint32_t stores = 0;

    for (uint32_t n = 0; n < b->ins.n && stores < STORES_MOST; n++) {
        const IrIns *i = &f->ins.at[b->ins.at[n]];
        ProveTerms with[2];
        bool split = i->op == IR_store && i->type == SM_BOOL && f->ins.at[i->a].op != IR_const && !is_stored_later(f, b, n);
        for (int value = 0; split && value < 2; value++) {
            with[value] = *terms;
            split = split_condition(f, &with[value], i->a, value, DEPTH_MOST);
            for (uint32_t t = 0; split && t < with[value].n; t++)
                with[value].at[t].stored[with[value].at[t].stores++] = (ProveLiteral){i->var, value};
        }
        if (!split || !append_terms(&with[0], &with[1]))
            continue;
        *terms = with[0];
        stores++;
    }
}

// Appends an instruction to the block of a branch.
static IrRef emit_in(ProveMaker *k, IrFn *f, IrOp op, IrRef a, IrRef b, uint32_t var)
{
    const IrIns i = {.op = op, .type = SM_BOOL, .a = a, .b = b, .var = var};

    return ir_emit(k->arena, f, 0, i);
}

// Adds `r`, or `not r`, to the conjunction *all.
static void emit_literal(ProveMaker *k, IrFn *f, IrRef *all, IrRef r, bool value)
{
    const IrRef literal = value ? r : emit_in(k, f, IR_not, r, IR_NONE, 0);

    *all = *all == IR_NONE ? literal : emit_in(k, f, IR_and, *all, literal, 0);
}

// Adds a branch: the block with the condition that is the conjunction of the term.
static void add_branch(ProveMaker *k, ProveBlock *to, const IrFn *f, const IrBlk *b, const ProveTerm *t, IrBlkRef then)
{
    ProveBranch branch = {.fn = ARENA_NEW(k->arena, IrFn), .then = then};
    IrFn *fn = branch.fn;
    IrRef all = IR_NONE;

    fn->ins.n = fn->ins.cap = f->ins.n;
    fn->ins.at = arena_copy(k->arena, f->ins.at, f->ins.n * sizeof *f->ins.at);
    for (int n = 0; n < 3; n++)
        ir_add_block(k->arena, fn);
    for (uint32_t n = 0; n < b->ins.n; n++)
        vec_push(k->arena, &fn->blk.at[0].ins, b->ins.at[n]);
    for (uint32_t n = 0; n < t->n; n++)
        emit_literal(k, fn, &all, t->at[n].ref, t->at[n].value);
    for (uint32_t n = 0; n < t->stores; n++)
        emit_literal(k, fn, &all, emit_in(k, fn, IR_load, IR_NONE, IR_NONE, t->stored[n].ref), t->stored[n].value);
    if (all != IR_NONE)
        fn->blk.at[0].jump = (IrJump){.kind = IR_BR, .cond = all, .then = 1, .otherwise = 2};
    else
        fn->blk.at[0].jump = (IrJump){.kind = IR_JMP, .cond = IR_NONE, .then = 1};
    vec_push(k->arena, &to->branch, branch);
}

// Adds the branches of a block that ends in a branch on a condition: those with the condition true, then those with it false.
static void add_both_edges(ProveMaker *k, ProveBlock *to, const IrFn *f, const IrBlk *b, const ProveTerms *terms)
{
    ProveTerms with[2] = {*terms, *terms};
    const bool split = split_condition(f, &with[0], b->jump.cond, false, DEPTH_MOST) && split_condition(f, &with[1], b->jump.cond, true, DEPTH_MOST);

    for (int value = 1; value >= 0; value--) {
        if (!split) {
            const ProveTerm whole = {.at = {{b->jump.cond, value}}, .n = 1};
            with[value] = (ProveTerms){.at = {whole}, .n = 1};
        }
        for (uint32_t t = 0; t < with[value].n; t++)
            add_branch(k, to, f, b, &with[value].at[t], value ? b->jump.then : b->jump.otherwise);
    }
}

void prove_split_block(ProveMaker *k, ProveBlock *to, const IrFn *f, const IrBlk *b)
{
    ProveTerms terms = {.n = 1};

    split_stores(f, b, &terms);
    if (b->jump.kind == IR_BR) {
        add_both_edges(k, to, f, b, &terms);
        return;
    }
    for (uint32_t t = 0; t < terms.n; t++)
        add_branch(k, to, f, b, &terms.at[t], b->jump.kind == IR_JMP ? b->jump.then : IR_NONE);
}
