// SPDX-License-Identifier: Apache-2.0
#include "compiler/prove/prove_make.h"

#include "compiler/base/bitset.h"
#include "compiler/ir/build.h"
#include "compiler/ir/eval.h"

#define TIME_LIMIT 18446744073709551616.0     // 2^64: above every time

static Fact whole_between(double lo, double hi)
{
    const Fact f = {lo, hi, .whole = true};

    return f;
}

// ---- windows ----

// Returns the bool of which r is the number 0 or 1; IR_NONE if r is no such number.
static IrRef bool_of_number(const IrFn *f, IrRef r)
{
    const IrIns *i = &f->ins.at[r];

    if (i->op != IR_cvt || i->type != SM_F64 || f->ins.at[i->a].type != SM_BOOL)
        return IR_NONE;
    return ir_op_info[f->ins.at[i->a].op].types == IR_T_LOAD || f->ins.at[i->a].op == IR_not || f->ins.at[i->a].op == IR_and || f->ins.at[i->a].op == IR_or
            || ir_op_info[f->ins.at[i->a].op].types == IR_T_COMPARE || f->ins.at[i->a].op == IR_cvt ? i->a : IR_NONE;
}

// Returns the condition of a run.  Its event is 1 or 2 if the condition is true (build_windows.c).
static IrRef condition_of_run(const IrFn *f, const IrWindow *w, IrRef event)
{
    const IrIns *i = &f->ins.at[event];

    return bool_of_number(f, w->first && w->first->gap && i->op == IR_add ? i->a : event);
}

static bool is_run(uint32_t stats) { return (stats & SM_STATS_OF_RUNS) != 0; }

// Whether each sample of a run is known from its condition: with a gap, G must not advance by more than that.
static bool is_exact_run(const ProveMaker *k, const IrWindow *w) { return !w->first || w->first->gap == 0 || k->model->delta_t <= w->first->gap; }

// Whether the value of a statistic follows from variables that the samples change.
static bool is_exact(const MadeWindow *w, SmStat stat)
{
    switch (stat) {
    case SM_STAT_RUN_STEPS: case SM_STAT_RUN_TIME: return w->operand != IR_NONE;
    case SM_STAT_NEWEST: return prove_follows_samples(w);
    case SM_STAT_OLDEST: return prove_follows_samples(w) && w->size == 2;
    case SM_STAT_MIN: case SM_STAT_MAX: return w->is_boolean;
    default: return false;
    }
}

// Returns the fact of a statistic that the model leaves open: any value that the samples allow.
static Fact fact_of_choice(const ProveMaker *k, const MadeWindow *w, SmStat stat)
{
    if (stat == SM_STAT_ELAPSED) {
        const IrIns *event = &w->sample->ins.at[w->operand];
        const bool each_step = event->op == IR_const && event->bits == sm_bits(1.0);
        return whole_between(0, each_step ? (double)k->model->delta_t * (w->size - 1) : TIME_LIMIT);
    }
    return fact_of_stat(stat, w->samples);
}

// Adds variables that count successive true samples, for a minimum or a run, and successive false ones, for a maximum.  The count of a run begins
// at 0.  Others begin at the size of the window: before the first sample, all samples count as equal.
static void add_counts(ProveMaker *k, MadeWindow *w)
{
    const bool run = is_run(w->stats);

    w->trues = w->falses = IR_NONE;
    if (run || w->stats >> SM_STAT_MIN & 1)
        w->trues = prove_add_var(k, SM_F64, PROVE_KEPT, prove_fact_of_number(run ? 0 : w->size));
    if (w->stats >> SM_STAT_MAX & 1)
        w->falses = prove_add_var(k, SM_F64, PROVE_KEPT, prove_fact_of_number(w->size));
    if (w->trues != IR_NONE)
        k->model->var[w->trues].few = true;
    if (w->falses != IR_NONE)
        k->model->var[w->falses].few = true;
}

// Adds a variable of the model for each statistic of a window that is read.
static void add_window_vars(ProveMaker *k, MadeWindow *w)
{
    const uint32_t first = k->model->ir->var.n;

    for (int s = 0; s < SM_STAT_COUNT; s++)
        if (w->stats >> s & 1)
            w->var[s] = is_exact(w, (SmStat)s) ? prove_add_var(k, SM_F64, PROVE_KEPT, prove_fact_of_number(0)) : prove_add_var(k, SM_F64, PROVE_CHOICE, fact_of_choice(k, w, (SmStat)s));
    w->last = !prove_follows_samples(w) ? IR_NONE : w->stats >> SM_STAT_NEWEST & 1 ? w->var[SM_STAT_NEWEST] : w->stats >> SM_STAT_OLDEST & 1 && w->size == 2 ? prove_add_var(k, SM_F64, PROVE_KEPT, prove_fact_of_number(0)) : IR_NONE;
    if (w->is_boolean) {
        add_counts(k, w);
        for (int stat = 0; stat < SM_STAT_COUNT; stat++)
            if (w->stats >> stat & 1)
                k->model->var[w->var[stat]].few = true;
        if (w->last != IR_NONE)
            k->model->var[w->last].few = true;
    }
    for (uint32_t v = first; v < k->model->ir->var.n; v++)
        k->model->var[v].window = w->of;
}

// Finds the operands of the samples of a sample function, whose windows begin at `first`.
static void find_samples(ProveMaker *k, const IrMachine *m, uint32_t first)
{
    for (uint32_t n = 0; m->sample && n < m->sample->blk.at[0].ins.n; n++) {
        const IrIns *i = &m->sample->ins.at[m->sample->blk.at[0].ins.at[n]];
        MadeWindow *w;
        if (i->op != IR_sample)
            continue;
        w = &k->window[first + i->var];
        w->sample = m->sample;
        w->operand = i->a;
        if (is_run(w->stats)) {
            w->operand = is_exact_run(k, &m->window.at[i->var]) ? condition_of_run(m->sample, &m->window.at[i->var], i->a) : IR_NONE;
            w->is_boolean = w->operand != IR_NONE;
        } else if (!(w->stats & SM_STATS_OF_TIMES) && bool_of_number(m->sample, i->a) != IR_NONE) {
            w->is_boolean = true;
            w->operand = bool_of_number(m->sample, i->a);
        }
    }
}

// Raises w->longest where a function compares the time of a run with a number.
static void find_longest(ProveMaker *k, const IrFn *f, uint32_t first)
{
    for (uint32_t r = 0; f && r < f->ins.n; r++) {
        const IrIns *i = &f->ins.at[r];
        for (int side = 0; side < 2; side++) {
            const IrRef operand = side ? i->b : i->a;
            const IrIns *from = operand == IR_NONE ? NULL : &f->ins.at[operand];
            MadeWindow *w;
            double limit = TIME_LIMIT;
            if (!from || from->op != IR_stat || from->stat != SM_STAT_RUN_TIME)
                continue;
            w = &k->window[k->same[first + from->var]];
            if (i->op == IR_ge && side == 0 && f->ins.at[i->b].op == IR_const)
                limit = ir_number(f->ins.at[i->b].type, f->ins.at[i->b].bits);
            if (limit > w->longest)
                w->longest = limit;
        }
    }
}

// Finds for each window the longest time with which a run is compared.
static void find_longest_runs(ProveMaker *k)
{
    for (uint32_t n = 0; n < k->windows; n++)
        k->window[n].longest = 0;
    for (size_t s = 0; s < k->m->state.n; s++)
        for (int block = 0; block < BLOCK_COUNT; block++)
            find_longest(k, k->m->state.at[s].block[block], 0);
    find_longest(k, k->m->sample, 0);
    find_longest(k, k->judge.sample, k->of_machine);
    for (int c = 0; c < 3; c++)
        find_longest(k, k->condition[c], 0);
}

// Whether an expression of the machine and one of the requirements always have the same value: they apply the same operations to variables that no
// step changes, and to windows that have the same samples.
static bool is_same_sample(const ProveMaker *k, const Expr *of_machine, const Expr *e)
{
    if (of_machine->kind == EX_ROLL && e->kind == EX_ROLL)
        return of_machine->stat == e->stat && k->window_of[e->window] == k->m->window_of[of_machine->window];
    if (!expr_is_same_operation(of_machine, e) || (e->kind == EX_VAR && e->var->written))
        return false;
    for (uint32_t i = 0; i < e->n; i++)
        if (!is_same_sample(k, of_machine->arg[i], e->arg[i]))
            return false;
    return true;
}

// Returns a window of the machine that always has the same samples as window number `number` of the requirements; IR_NONE: none.
static uint32_t same_window(const ProveMaker *k, const Requirements *all, uint32_t number)
{
    const Window *w = &all->window.at[number];

    for (uint32_t n = 0; n < k->m->window.n; n++) {
        const Window *of = k->m->window.at[n].first;
        const uint32_t stat = 1u << w->stat, stats = k->m->window.at[n].stats;
        if (of && of->size == w->size && of->gap == w->gap && is_run(stat) == is_run(stats) && ir_stores_times(&k->m->window.at[n]) == ((stat & SM_STATS_OF_TIMES) != 0)
            && is_same_sample(k, of->sample, w->sample))
            return n;
    }
    return k->equal ? k->equal[number] : IR_NONE;
}

void prove_merge_windows(ProveMaker *k, const Requirements *all)
{
    Program program = *k->m->program;
    Builder b = {.arena = k->arena, .p = &program, .m = &k->judge, .var = (uint32_t *)k->m->var_of};

    program.window = all->window;
    build_windows(&b);
    k->of_machine = k->m->window.n;
    k->windows = k->of_both = k->m->window.n + k->judge.window.n;
    k->window = ARENA_ARRAY(k->arena, MadeWindow, k->windows + 1u);
    for (uint32_t n = 0; n < k->windows; n++) {
        const IrWindow *from = n < k->of_machine ? &k->m->window.at[n] : &k->judge.window.at[n - k->of_machine];
        k->window[n] = (MadeWindow){.size = from->size, .stats = from->stats, .operand = IR_NONE, .first = n < k->of_machine ? 0 : k->of_machine, .of = from->first, .base = IR_NONE};
    }
    k->same = ARENA_ARRAY(k->arena, uint32_t, k->windows + 1u);
    for (uint32_t n = 0; n < k->windows; n++)
        k->same[n] = n;
    k->window_of = ARENA_ARRAY(k->arena, uint32_t, all->window.n + 1u);
    for (uint32_t n = 0; n < all->window.n; n++) {
        const uint32_t same = same_window(k, all, n);
        k->window_of[n] = same == IR_NONE ? k->of_machine + b.window[n] : same;
        k->same[k->of_machine + b.window[n]] = k->window_of[n];
        k->window[k->window_of[n]].stats |= 1u << all->window.at[n].stat;
    }
}

// Marks the windows that a condition of the requirement reads.
static void find_read_windows(const ProveMaker *k, bool *read)
{
    for (int c = 0; c < 3; c++)
        for (uint32_t r = 0; k->condition[c] && r < k->condition[c]->ins.n; r++)
            if (k->condition[c]->ins.at[r].op == IR_stat)
                read[k->condition[c]->ins.at[r].var] = true;
}

// What a value is computed from.
typedef struct Sources {
    uint64_t *vars;           // set of variables that are loaded
    bool *windows;            // by window: a statistic of it is read
} Sources;

// Adds the variables and windows that value r of function f is computed from, also those of the samples of its windows.
static void add_sources(const ProveMaker *k, const IrFn *f, IrRef r, uint32_t first, bool *visited, Sources *to)
{
    const IrIns *i = r == IR_NONE ? NULL : &f->ins.at[r];

    if (!i || visited[r])
        return;
    visited[r] = true;
    add_sources(k, f, i->a, first, visited, to);
    add_sources(k, f, i->b, first, visited, to);
    if (i->op == IR_load)
        bitset_add(to->vars, i->var);
    if (i->op == IR_stat && !to->windows[k->same[first + i->var]]) {
        const MadeWindow *w = &k->window[k->same[first + i->var]];
        to->windows[k->same[first + i->var]] = true;
        if (w->operand != IR_NONE)
            add_sources(k, w->sample, w->operand, w->first, ARENA_ARRAY(k->arena, bool, w->sample->ins.n + 1), to);
    }
}

static Sources find_sources(const ProveMaker *k, const IrFn *f, IrRef r, uint32_t first)
{
    Sources s = {ARENA_ARRAY(k->arena, uint64_t, bitset_words(k->m->var.n)), ARENA_ARRAY(k->arena, bool, k->windows + 1u)};

    if (r != IR_NONE)
        add_sources(k, f, r, first, ARENA_ARRAY(k->arena, bool, f->ins.n + 1), &s);
    return s;
}

static bool share_variable(const ProveMaker *k, const Sources *a, const Sources *b)
{
    for (size_t n = 0; n < bitset_words(k->m->var.n); n++)
        if (a->vars[n] & b->vars[n])
            return true;
    return false;
}

// Finds the windows of the machine that have as many samples as one of the requirement, or whose runs are compared with the same time, and that read a variable that it reads, with the windows
// that their samples are computed from.
static bool *find_like_windows(ProveMaker *k)
{
    bool *like = ARENA_ARRAY(k->arena, bool, k->windows + 1u);
    Sources of_requirement[3];

    find_longest_runs(k);
    for (int c = 0; c < 3; c++)
        of_requirement[c] = find_sources(k, k->condition[c], k->condition[c] ? k->condition[c]->blk.at[0].jump.cond : IR_NONE, 0);
    for (uint32_t r = k->of_machine; r < k->windows; r++) {
        const MadeWindow *w = &k->window[r];
        Sources of_window;
        if (w->operand == IR_NONE || !(of_requirement[0].windows[r] || of_requirement[1].windows[r] || of_requirement[2].windows[r]))
            continue;
        of_window = find_sources(k, w->sample, w->operand, w->first);
        for (uint32_t n = 0; n < k->of_machine; n++) {
            const MadeWindow *of = &k->window[n];
            Sources s;
            if (of->operand == IR_NONE || of->size != w->size || of->longest != w->longest || is_run(of->stats) != is_run(w->stats))
                continue;
            s = find_sources(k, of->sample, of->operand, of->first);
            if (!share_variable(k, &s, &of_window))
                continue;
            like[n] = true;
            for (uint32_t inner = 0; inner < k->of_machine; inner++)
                like[inner] |= s.windows[inner];
        }
    }
    return like;
}

// Whether a model lets window n of the machine, which the requirement does not read, have any value.
static bool is_loosened(const MadeWindow *w, ProveLoosening loose, bool is_like)
{
    if (!prove_follows_samples(w))
        return false;
    switch (loose) {
    case PROVE_LOOSE_ALL: case PROVE_RELATED: return true;
    case PROVE_LOOSE_LONG: return w->size > 2 || is_run(w->stats);
    case PROVE_LOOSE_UNLIKE: return !is_like;
    case PROVE_EXACT: case PROVE_COMPARED: case PROVE_LOOSENINGS: break;
    }
    return false;
}

// Computes what is known about the samples of all windows.
static void find_facts(ProveMaker *k)
{
    IrMachine judge = *k->m;
    FactMachine *of_machine = facts_of_machine(k->arena, k->m), *of_judge;

    judge.window = k->judge.window;
    judge.sample = k->judge.sample;
    judge.state.n = 0;
    of_judge = facts_of_machine(k->arena, &judge);
    for (uint32_t n = 0; n < k->windows; n++)
        k->window[n].samples = n < k->of_machine ? facts_of_window(of_machine, n) : facts_of_window(of_judge, n - k->of_machine);
}

void prove_find_samples(ProveMaker *k, ProveLoosening loose)
{
    bool *read = ARENA_ARRAY(k->arena, bool, k->windows + 1u), *like;

    find_facts(k);
    find_samples(k, k->m, 0);
    find_samples(k, &k->judge, k->of_machine);
    find_read_windows(k, read);
    like = find_like_windows(k);
    for (uint32_t n = 0; n < k->of_machine; n++) {
        MadeWindow *w = &k->window[n];
        if (read[n] || !is_loosened(w, loose, like[n]))
            continue;
        w->is_boolean = false;
        w->operand = IR_NONE;
        k->model->loosened++;
    }
}

bool prove_follows_samples(const MadeWindow *w)
{
    const bool ends = w->stats >> SM_STAT_NEWEST & 1 || (w->stats >> SM_STAT_OLDEST & 1 && w->size == 2);

    return w->operand != IR_NONE && (w->is_boolean || (ends && !(w->stats & SM_STATS_OF_TIMES)));
}

void prove_add_windows(ProveMaker *k)
{
    find_longest_runs(k);
    for (uint32_t n = 0; n < k->windows; n++) {
        if (!k->window[n].used)
            continue;
        add_window_vars(k, &k->window[n]);
        if (k->window[n].base != IR_NONE)
            k->window[n].outcome = prove_add_var(k, SM_F64, PROVE_CHOICE, whole_between(0, 1));
    }
}

// ---- samples ----

// Emits what a sample that is true, or false, changes in the variables of a window of booleans, and continues in block `next`.
static void sample_boolean(ProveMaker *k, const MadeWindow *w, bool value, IrBlkRef next)
{
    const uint32_t counts = value ? w->trues : w->falses, ends = value ? w->falses : w->trues;

    if (counts != IR_NONE)
        prove_emit_store(k, counts, prove_emit(k, IR_min, prove_emit(k, IR_add, prove_emit_load(k, counts), prove_emit_number(k, 1)), prove_emit_number(k, w->size)));
    if (ends != IR_NONE)
        prove_emit_set(k, ends, 0);
    for (int s = SM_STAT_MIN; s <= SM_STAT_MAX; s++)
        if (w->stats >> s & 1) {
            const bool all = s == SM_STAT_MIN ? value : !value;       // it has this value only if all samples of the window have
            if (!all) {
                prove_emit_set(k, w->var[s], value);
                continue;
            }
            const IrRef full = prove_emit(k, IR_ge, prove_emit_load(k, counts), prove_emit_number(k, w->size));
            const IrBlkRef equal = prove_new_block(k), other = prove_new_block(k), join = prove_new_block(k);
            prove_branch_from(k, k->b, full, equal, other);
            k->b = equal;
            prove_emit_set(k, w->var[s], value);
            prove_jump_from(k, k->b, join);
            k->b = other;
            prove_emit_set(k, w->var[s], !value);
            prove_jump_from(k, k->b, join);
            k->b = join;
        }
    prove_jump_from(k, k->b, next);
}

// Emits the same for a window that stores a run of true samples.
static void sample_run(ProveMaker *k, const MadeWindow *w, bool value, IrBlkRef next)
{
    const uint32_t time = w->stats >> SM_STAT_RUN_TIME & 1 ? w->var[SM_STAT_RUN_TIME] : IR_NONE;
    const uint32_t steps = w->stats >> SM_STAT_RUN_STEPS & 1 ? w->var[SM_STAT_RUN_STEPS] : IR_NONE;

    if (value && time != IR_NONE) {
        const IrBlkRef more = prove_new_block(k), first = prove_new_block(k), join = prove_new_block(k);
        prove_branch_if_above(k, w->trues, 0, more, first);
        k->b = more;
        prove_emit_store(k, time, prove_emit(k, IR_min, prove_emit(k, IR_add, prove_emit_load(k, time), prove_emit_number(k, (double)k->model->delta_t)), prove_emit_number(k, w->longest)));
        prove_jump_from(k, k->b, join);
        k->b = first;
        prove_emit_set(k, time, 0);
        prove_jump_from(k, k->b, join);
        k->b = join;
    } else if (time != IR_NONE) {
        prove_emit_set(k, time, 0);
    }
    if (value)
        prove_emit_store(k, w->trues, prove_emit(k, IR_min, prove_emit(k, IR_add, prove_emit_load(k, w->trues), prove_emit_number(k, 1)), prove_emit_number(k, w->size)));
    else
        prove_emit_set(k, w->trues, 0);
    if (steps != IR_NONE)
        prove_emit_store(k, steps, prove_emit_load(k, w->trues));
    prove_jump_from(k, k->b, next);
}

// Emits what a sample changes in the newest and in the oldest sample, and continues in block `next`.  In the first step they are the same.
static void sample_newest_and_oldest(ProveMaker *k, const MadeWindow *w, IrRef value, IrBlkRef next)
{
    const uint32_t oldest = w->stats >> SM_STAT_OLDEST & 1 && w->size == 2 ? w->var[SM_STAT_OLDEST] : IR_NONE;
    IrBlkRef first;

    if (oldest != IR_NONE)
        prove_emit_store(k, oldest, prove_emit_load(k, w->last));
    if (w->last != IR_NONE)
        prove_emit_store(k, w->last, value);
    if (oldest == IR_NONE) {
        prove_jump_from(k, k->b, next);
        return;
    }
    first = prove_new_block(k);
    prove_branch_if_above(k, k->sampled, 0, next, first);
    k->b = first;
    prove_emit_store(k, oldest, prove_emit_load(k, w->last));
    prove_jump_from(k, k->b, next);
}

// Emits the sample of a window of booleans whose value is known, and continues in block `next`.
static void sample_known_boolean(ProveMaker *k, const MadeWindow *w, bool value, IrBlkRef next)
{
    IrBlkRef ends;

    if (is_run(w->stats)) {
        sample_run(k, w, value, next);
        return;
    }
    ends = prove_new_block(k);
    sample_boolean(k, w, value, ends);
    k->b = ends;
    sample_newest_and_oldest(k, w, prove_emit_number(k, value), next);
}

// Ends the current block: continues in `yes` or in `no`, by the sample of a window of booleans.
static void branch_on_sample(ProveMaker *k, const MadeWindow *w, IrBlkRef yes, IrBlkRef no)
{
    const MadeWindow *same = w->base == IR_NONE ? NULL : prove_find_outcome(k, w);

    if (same)
        prove_branch_if_above(k, same->outcome, 0, yes, no);
    else
        prove_branch_from(k, k->b, prove_copy_value(k, w->sample, w->operand, prove_new_copies(k, w->sample), w->first), yes, no);
}

// Adds the code that takes a sample in this step, if the model follows the window's samples.
static void sample_window(ProveMaker *k, MadeWindow *w)
{
    IrBlkRef next, side[2];

    if (!prove_follows_samples(w))
        return;                                   // its statistics are variables of kind CHOICE
    next = prove_new_block(k);
    if (w->is_boolean) {
        side[0] = prove_new_block(k);
        side[1] = prove_new_block(k);
        branch_on_sample(k, w, side[1], side[0]);
        for (int value = 1; value >= 0; value--) {
            k->b = side[value];
            if (w->base != IR_NONE)
                prove_emit_set(k, w->outcome, value);
            sample_known_boolean(k, w, value, next);
        }
        w->is_sampled = w->base != IR_NONE;
    } else {
        const IrRef value = prove_copy_value(k, w->sample, w->operand, prove_new_copies(k, w->sample), w->first);
        sample_newest_and_oldest(k, w, prove_emit(k, IR_cvt, value, IR_NONE), next);
    }
    k->b = next;
}

void prove_sample_windows(ProveMaker *k, uint32_t from, uint32_t to)
{
    for (uint32_t n = from; n < to; n++) {
        if (!k->window[n].used)
            continue;
        sample_window(k, &k->window[n]);
        for (uint32_t c = k->of_both; c < k->windows; c++)
            if (k->window[c].base == n) {
                sample_window(k, &k->window[c]);
                prove_agree_with_comparison(k, &k->window[c]);
            }
    }
}
