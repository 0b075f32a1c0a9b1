// SPDX-License-Identifier: Apache-2.0
// What a requirement says about single samples of a window, as in held(x > c, t), and what the machine reads of all of them, as roll_min(x, n), are
// known together only if the samples are counted: roll_min(x, n) > c is true if and only if x > c is true of each sample, and roll_max(x, n) > c
// if and only if it is true of at least one.  So for each such comparison a window of booleans follows the samples, and the minimum and the maximum
// of the numbers have only values that agree with it.
//
// This requires samples that are never NaN, and a constant: of numbers and of locals that no code writes.
#include "compiler/ir/comparison.h"
#include "compiler/prove/prove_make.h"

// ---- values ----

// Whether a value is the same in every step: it depends only on constants and on locals that nothing stores to.
static bool is_constant(const ProveMaker *k, const IrFn *f, IrRef r)
{
    const IrIns *i = r == IR_NONE ? NULL : &f->ins.at[r];

    if (!i || i->op == IR_const)
        return true;
    if (i->op == IR_load)
        return k->model->var[i->var].kind == PROVE_KEPT && !k->model->var[i->var].stored;
    return i->op != IR_stat && i->op != IR_sample && i->op != IR_store && is_constant(k, f, i->a) && is_constant(k, f, i->b);
}

// Whether two values are computed in the same way.  Variables can change between the two computations: the comparison of
// a window is one of its own samples, so this only decides which comparisons are worth it.
static bool is_equal_value(const IrFn *f, IrRef r, const IrFn *g, IrRef s)
{
    const IrIns *i, *j;

    if (r == IR_NONE || s == IR_NONE)
        return r == s;
    i = &f->ins.at[r];
    j = &g->ins.at[s];
    if (i->op != j->op || i->type != j->type || i->op == IR_stat || i->op == IR_sample || i->op == IR_store)
        return false;
    return (i->op != IR_const || i->bits == j->bits) && (i->op != IR_load || i->var == j->var) && is_equal_value(f, i->a, g, j->a) && is_equal_value(f, i->b, g, j->b);
}

// Appends an instruction that is in no block: only its value is used (prove_copy_value).
static IrRef append_instruction(ProveMaker *k, IrFn *f, IrIns i)
{
    vec_push(k->arena, &f->ins, i);
    return f->ins.n - 1;
}

// Copies the computation of a value to the end of another function.
static IrRef append_value(ProveMaker *k, IrFn *to, const IrFn *from, IrRef r)
{
    IrIns i;

    if (r == IR_NONE)
        return r;
    i = from->ins.at[r];
    i.a = append_value(k, to, from, i.a);
    i.b = append_value(k, to, from, i.b);
    return append_instruction(k, to, i);
}

// ---- comparisons ----

// The comparison of a value with a constant: value > constant, or value >= constant.
typedef struct Threshold { const IrFn *f; IrRef value, constant; IrOp op; } Threshold;

// Finds the comparison that r is, or that r negates.  Returns false if r is neither.
static bool find_threshold(const ProveMaker *k, const IrFn *f, IrRef r, Threshold *t)
{
    const IrIns *i = &f->ins.at[r];
    bool swapped;
    IrOp op;

    while (i->op == IR_not)
        i = &f->ins.at[i->a];
    if (!ir_is_comparison(i->op) || ir_is_equality(i->op))
        return false;
    swapped = is_constant(k, f, i->a);
    op = swapped ? ir_swapped_comparison(i->op) : i->op;
    *t = (Threshold){f, swapped ? i->b : i->a, swapped ? i->a : i->b, op == IR_lt || op == IR_le ? ir_negated_comparison(op) : op};
    return is_constant(k, f, t->constant) && !is_constant(k, f, t->value);
}

// Adds a window that compares the samples of window `base`, as t compares its value.
static void add_comparison(ProveMaker *k, uint32_t base, const Threshold *t)
{
    MadeWindow made = k->window[base];
    IrFn *sample = arena_copy(k->arena, made.sample, sizeof *sample);
    IrIns compare = {.op = t->op, .type = SM_BOOL, .a = made.operand};

    for (uint32_t n = k->of_both; n < k->windows; n++) {
        const MadeWindow *w = &k->window[n];
        if (w->base == base && w->sample->ins.at[w->operand].op == t->op && is_equal_value(t->f, t->constant, w->sample, w->sample->ins.at[w->operand].b))
            return;
    }
    sample->ins.at = arena_copy(k->arena, sample->ins.at, sample->ins.n * sizeof *sample->ins.at);
    sample->ins.cap = sample->ins.n;
    compare.b = append_value(k, sample, t->f, t->constant);
    made.operand = append_instruction(k, sample, compare);
    made.sample = sample;
    made.stats &= 1u << SM_STAT_MIN | 1u << SM_STAT_MAX;
    made.is_boolean = true;
    made.base = base;
    made.is_sampled = false;
    k->window = arena_grow(k->arena, k->window, k->windows * sizeof *k->window, (k->windows + 1u) * sizeof *k->window);
    k->window[k->windows++] = made;
}

// Whether the smallest or largest sample of the window is read, so that a comparison with a threshold can replace it.
static bool has_bounds(const MadeWindow *w)
{
    return !w->is_boolean && w->operand != IR_NONE && !w->samples.nan && (w->stats & (1u << SM_STAT_MIN | 1u << SM_STAT_MAX));
}

// Adds the windows of comparisons for a condition of single samples.
static void compare_equal_samples(ProveMaker *k, const IrFn *f, IrRef condition)
{
    Threshold t;

    if (!find_threshold(k, f, condition, &t))
        return;
    for (uint32_t n = 0; n < k->of_both; n++) {
        const MadeWindow *w = &k->window[n];
        IrRef sample = w->operand;
        if (!has_bounds(w) || (n >= k->of_machine && k->same[n] != n))
            continue;
        if (w->sample->ins.at[sample].op == IR_cvt && f->ins.at[t.value].op != IR_cvt)
            sample = w->sample->ins.at[sample].a;             // skip the conversion to F64, in which windows store samples
        if (is_equal_value(f, t.value, w->sample, sample))
            add_comparison(k, n, &t);
    }
}

// Adds the windows of comparisons for a condition of a statistic of window n: also of other windows with the same samples and this statistic, such as the last
// two samples of which the requirement reads the last three.
static void compare_same_samples(ProveMaker *k, uint32_t n, const Threshold *t)
{
    const MadeWindow of = k->window[n];
    const SmStat stat = t->f->ins.at[t->value].stat;

    for (uint32_t other = 0; other < k->of_both; other++) {
        const MadeWindow w = k->window[other];
        if (has_bounds(&w) && w.stats >> stat & 1 && k->same[other] == other && is_equal_value(of.sample, of.operand, w.sample, w.operand))
            add_comparison(k, other, t);
    }
}

// For each comparison of a window's statistic with a threshold in value r of function f, adds a window of `sample > threshold` to the model; also
// for the samples of the windows that r reads.  `first`: index of f's first window.  read: by window, whether its samples have been visited.
static void add_threshold_windows(ProveMaker *k, const IrFn *f, IrRef r, uint32_t first, bool *read)
{
    const IrIns *i = r == IR_NONE ? NULL : &f->ins.at[r];
    Threshold t;

    if (!i)
        return;
    if (find_threshold(k, f, r, &t) && f->ins.at[t.value].op == IR_stat) {
        const uint32_t n = k->same[first + f->ins.at[t.value].var];
        if (has_bounds(&k->window[n]))
            compare_same_samples(k, n, &t);
    }
    if (i->op == IR_stat) {
        const MadeWindow w = k->window[k->same[first + i->var]];
        if (read[k->same[first + i->var]] || w.operand == IR_NONE)
            return;
        read[k->same[first + i->var]] = true;
        if (w.is_boolean)
            compare_equal_samples(k, w.sample, w.operand);
        add_threshold_windows(k, w.sample, w.operand, w.first, read);
        return;
    }
    add_threshold_windows(k, f, i->a, first, read);
    add_threshold_windows(k, f, i->b, first, read);
}

void prove_compare_samples(ProveMaker *k)
{
    bool *read = ARENA_ARRAY(k->arena, bool, k->windows + 1u);

    k->of_both = k->windows;
    for (int c = 0; c < 3; c++)
        if (k->condition[c])
            add_threshold_windows(k, k->condition[c], k->condition[c]->blk.at[0].jump.cond, 0, read);
    k->model->compared = k->windows - k->of_both;
}

// ---- outcomes ----

// Whether a value is the same everywhere in a step.
static bool is_constant_in_step(const ProveMaker *k, const IrFn *f, IrRef r)
{
    const IrIns *i = r == IR_NONE ? NULL : &f->ins.at[r];

    if (!i || i->op == IR_const)
        return true;
    if (i->op == IR_load)
        return k->model->var[i->var].kind == PROVE_INPUT || (k->model->var[i->var].kind == PROVE_KEPT && !k->model->var[i->var].stored);
    return i->op != IR_stat && i->op != IR_sample && i->op != IR_store && is_constant_in_step(k, f, i->a) && is_constant_in_step(k, f, i->b);
}

// The facts about a condition are not the condition: that the second largest of three inputs is above 28 is known of a path, but not of the inputs.  So windows of
// different sizes have the same samples only if these are computed once.
const MadeWindow *prove_find_outcome(const ProveMaker *k, const MadeWindow *w)
{
    for (uint32_t n = k->of_both; n < k->windows; n++) {
        const MadeWindow *other = &k->window[n];
        if (other->is_sampled && is_equal_value(other->sample, other->operand, w->sample, w->operand) && is_constant_in_step(k, w->sample, w->operand))
            return other;
    }
    return NULL;
}

// ---- agreement ----

// `w` samples a comparison of the samples of `base` with a constant.  Emits the condition that the minimum (or maximum) of `base` compares with the
// constant as the minimum (or maximum) of `w` says.  No run has other values, so a path with them ends as impossible.
static void emit_agreement(ProveMaker *k, const MadeWindow *base, const MadeWindow *w, SmStat stat)
{
    const IrIns *compare = &w->sample->ins.at[w->operand];
    const IrBlkRef next = prove_new_block(k), impossible = prove_new_block(k), side[2] = {prove_new_block(k), prove_new_block(k)};

    k->end.at[impossible] = PROVE_END_IMPOSSIBLE;
    prove_branch_if_above(k, w->var[stat], 0, side[1], side[0]);
    for (int value = 0; value < 2; value++) {
        IrRef constant, is_above;
        k->b = side[value];
        constant = prove_copy_value(k, w->sample, compare->b, prove_new_copies(k, w->sample), w->first);
        is_above = prove_emit(k, compare->op, prove_emit_load(k, base->var[stat]), constant);
        k->f->ins.at[is_above].type = SM_BOOL;
        prove_branch_from(k, k->b, is_above, value ? next : impossible, value ? impossible : next);
    }
    k->b = next;
}

void prove_agree_with_comparison(ProveMaker *k, const MadeWindow *w)
{
    const MadeWindow *base = &k->window[w->base];

    for (int stat = SM_STAT_MIN; stat <= SM_STAT_MAX; stat++)
        if (w->stats >> stat & 1)
            emit_agreement(k, base, w, (SmStat)stat);
}
