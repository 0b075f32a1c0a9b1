// SPDX-License-Identifier: Apache-2.0
#include "compiler/cover/flat_app.h"

#include <string.h>

#include "compiler/ir/eval.h"
#include "stdlib/convert.h"
#include "stdlib/roll.h"

// Values of FlatOp.op besides those of IrOp; `to`, `a` and `b` are fields of FlatOp.
enum {
    OP_LOAD = IR_OP_COUNT,            // OP_LOAD + SmType: frame[to] = variable a
    OP_STORE = OP_LOAD + SM_TYPE_COUNT,       // OP_STORE + SmType: variable `to` = frame[a], converted to the type
    OP_JUMP = OP_STORE + SM_TYPE_COUNT,       // jumps to operation `to`
    OP_BRANCH,                        // jumps to operation `to` if frame[a] is true, else to operation b
    OP_GOTO,                          // ends the function with the transition to state `to`, whose Stmt.number is a
    OP_END,                           // ends the function
    OP_COUNT,                         // increments hits[to]
    OP_RESULT,                        // increments hits[to] if frame[a] is true, else hits[to + 1]
    OP_DECIDE,                        // counts decision number a
    OP_WATCH,                         // calls FlatMachine.watch for decision number a
    OP_FULL                           // increments hits[to] if window a is full
};

enum { SEEN_BITS = 64 };              // the most conditions and windows of a decision that FlatSeen can store

// The values of a decision's conditions, and which of its windows were full, when it was last counted.  As long as they are the same, only the
// result has to be counted.
struct FlatSeen {
    uint64_t bits;
    bool known;
};

// ---- building ----

// A flat machine that is being built.
typedef struct Maker {
    Arena *arena;
    FlatMachine *f;
    VEC(FlatOp) op;
    VEC(double) number;               // the constants, which follow the temporaries in FlatMachine.frame
    uint32_t temps;                   // number of temporaries of all functions
    uint32_t base, next_base;         // index in the frame of the first temporary of the current function; of the next function
    uint32_t *slot;                   // by IrRef of the current function: index in the frame
    uint32_t *begin;                  // by block of the current function: index of its first operation
    uint32_t **decision_at;           // by decision, then by condition: index in the frame
    uint32_t *value_at;               // by decision: index of its result in the frame
    uint32_t next_decision;           // index of the first decision whose probe is not added yet
} Maker;

static void add_op(Maker *k, uint32_t op, uint32_t to, uint32_t a, uint32_t b)
{
    const FlatOp o = {(uint16_t)op, 0, 0, to, a, b};

    vec_push(k->arena, &k->op, o);
}

// Adds an operation that counts an execution, unless `hit` is 0: nothing is counted there.
static void add_count(Maker *k, uint32_t hit)
{
    if (hit)
        add_op(k, OP_COUNT, hit, 0, 0);
}

// Whether `ref`, a conversion, only prepares the store after it, which converts as well.
static bool is_part_of_store(const IrFn *f, const IrBlk *b, uint32_t k, IrRef ref)
{
    const IrIns *next = k + 1 < b->ins.n ? &f->ins.at[b->ins.at[k + 1]] : NULL;

    return next && next->op == IR_store && next->a == ref && next->type == f->ins.at[ref].type;
}

// Whether a conversion needs no operation: all values are doubles already, so only a conversion of an F64 to F64 has an effect, on NaN.
static bool is_no_conversion(const IrFn *f, const IrIns *i)
{
    const SmType from = f->ins.at[i->a].type;

    return (i->type == SM_F64 && from != SM_F64) || (i->type == from && from == SM_BOOL);
}

// Adds the operation of one IR instruction, with its operands as slots of the frame.
static void add_instruction(Maker *k, const IrFn *f, const IrBlk *b, uint32_t at)
{
    const IrRef ref = b->ins.at[at];
    const IrIns *i = &f->ins.at[ref];
    FlatOp o = {(uint16_t)i->op, (uint8_t)i->type, (uint8_t)i->stat, k->base + ref, 0, 0};

    k->slot[ref] = k->base + ref;
    switch (i->op) {
    case IR_const:
        k->slot[ref] = k->temps + k->number.n;
        vec_push(k->arena, &k->number, ir_number(i->type, i->bits));
        return;
    case IR_cvt:
        if (is_no_conversion(f, i) || is_part_of_store(f, b, at, ref)) {
            k->slot[ref] = k->slot[i->a];
            return;
        }
        break;
    case IR_load:
        o.op = (uint16_t)(OP_LOAD + i->type);
        o.a = i->var;
        vec_push(k->arena, &k->op, o);
        return;
    case IR_store:
        o.op = (uint16_t)(OP_STORE + i->type);
        o.to = i->var;
        break;
    case IR_sample: o.to = i->var; break;
    case IR_stat:
        o.a = i->var;
        vec_push(k->arena, &k->op, o);
        return;
    default: break;
    }
    o.a = i->a == IR_NONE ? 0 : k->slot[i->a];
    o.b = i->b == IR_NONE ? 0 : k->slot[i->b];
    vec_push(k->arena, &k->op, o);
}

// ---- probes ----

// Adds the probes of statement `stmt`, which is executed from here on.
static void add_stmt_probes(Maker *k, uint32_t stmt)
{
    const FlatFull *full = k->f->probes->full[stmt];

    add_count(k, k->f->probes->stmt[stmt]);
    for (; full && full->hit; full++)
        add_op(k, OP_FULL, full->hit, full->window, 0);
}

// Adds the probe of a decision at the end of the block that computes it.
static void add_decision(Maker *k, uint32_t number)
{
    const FlatDecision *d = &k->f->probes->decision[number];
    uint32_t *at = ARENA_ARRAY(k->arena, uint32_t, d->conditions + 1);

    k->value_at[number] = k->slot[d->value];
    for (uint32_t c = 0; c < d->conditions; c++)
        at[c] = k->slot[d->condition[c]];
    k->decision_at[number] = at;
    if (d->nodes == 1 && d->fulls == 0)
        add_op(k, OP_RESULT, d->hit, k->slot[d->value], 0);
    else
        add_op(k, OP_DECIDE, 0, number, 0);
    if (k->f->probes->watched && k->f->probes->watched[number])
        add_op(k, OP_WATCH, 0, number, 0);
}

// Adds the probes of the decisions whose value instruction `ref` computes.
static void add_decisions_at(Maker *k, const IrFn *f, IrRef ref)
{
    const FlatProbes *p = k->f->probes;

    for (; p && k->next_decision < p->decisions && p->decision[k->next_decision].fn == f && p->decision[k->next_decision].value == ref;
         k->next_decision++)
        add_decision(k, k->next_decision);
}

// Adds the probes of statement `stmt` if it differs from *current: an instruction with another statement number begins the next statement.
static void begin_stmt(Maker *k, uint32_t stmt, uint32_t *current)
{
    if (!k->f->probes || stmt == 0 || stmt == *current)
        return;
    *current = stmt;
    add_stmt_probes(k, stmt);
}

// ---- functions ----

static void add_jump(Maker *k, const IrJump *j)
{
    switch (j->kind) {
    case IR_RET: add_op(k, OP_END, 0, 0, 0); break;
    case IR_JMP: add_op(k, OP_JUMP, j->then, 0, 0); break;
    case IR_BR: add_op(k, OP_BRANCH, j->then, k->slot[j->cond], j->otherwise); break;
    case IR_GOTO:
        if (k->f->probes)
            add_count(k, k->f->probes->transition[j->stmt]);
        add_op(k, OP_GOTO, j->state, j->stmt, 0);
        break;
    }
}

// In the jumps from operation `first` on, replaces the numbers of target blocks by the indices of their first operations.
static void resolve_jumps(Maker *k, uint32_t first)
{
    for (uint32_t i = first; i < k->op.n; i++) {
        FlatOp *o = &k->op.at[i];
        if (o->op == OP_JUMP || o->op == OP_BRANCH)
            o->to = k->begin[o->to];
        if (o->op == OP_BRANCH)
            o->b = k->begin[o->b];
    }
}

// Adds the operations of a function.  Returns the index of the first one.
static uint32_t add_function(Maker *k, const IrFn *f)
{
    const uint32_t first = k->op.n;
    uint32_t stmt = 0;

    if (!f)
        return FLAT_NOTHING;
    k->base = k->next_base;
    k->next_base += f->ins.n;
    k->slot = ARENA_ARRAY(k->arena, uint32_t, f->ins.n + 1);
    k->begin = ARENA_ARRAY(k->arena, uint32_t, f->blk.n);
    for (uint32_t b = 0; b < f->blk.n; b++) {
        const IrBlk *blk = &f->blk.at[b];
        k->begin[b] = k->op.n;
        for (uint32_t i = 0; i < blk->ins.n; i++) {
            begin_stmt(k, f->ins.at[blk->ins.at[i]].stmt, &stmt);
            add_instruction(k, f, blk, i);
            add_decisions_at(k, f, blk->ins.at[i]);
        }
        if (blk->jump.kind == IR_GOTO)
            begin_stmt(k, blk->jump.stmt, &stmt);
        add_jump(k, &blk->jump);
    }
    resolve_jumps(k, first);
    k->f->fn[k->f->fns++] = (FlatFn){f, k->slot};
    return first;
}

// Returns the number of temporaries of all functions.  Functions do not share slots of the frame, so after a step the frame has the values of every
// function that ran.
static uint32_t count_temps(const IrMachine *m)
{
    uint32_t n = m->sample ? m->sample->ins.n : 0;

    for (size_t s = 0; s < m->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            n += m->state.at[s].block[b] ? m->state.at[s].block[b]->ins.n : 0;
    return n;
}

// Computes the size of a state and the offsets of its parts.  A window stores F64, because every sample is exactly an F64.
static void lay_out_state(Arena *arena, FlatMachine *f)
{
    const IrMachine *m = f->m;

    f->cells = (sizeof(FlatState) + 7) / 8 * 8;
    f->windows = f->cells + m->var.n * sizeof(uint64_t);
    f->size = f->windows;
    f->window_at = ARENA_ARRAY(arena, uint32_t, m->window.n + 1);
    f->window_kind = ARENA_ARRAY(arena, uint32_t, m->window.n + 1);
    f->window_size = ARENA_ARRAY(arena, uint32_t, m->window.n + 1);
    for (size_t w = 0; w < m->window.n; w++) {
        f->window_kind[w] = sm_roll_kind(SM_F64, m->window.at[w].stats);
        f->window_size[w] = m->window.at[w].size;
        f->window_at[w] = (uint32_t)f->size;
        f->size += sm_roll_words(m->window.at[w].size, f->window_kind[w]) * sizeof(uint64_t);
    }
}

// Allocates the counters, and for each decision the values of its last evaluation (FlatSeen).
static void begin_probes(Maker *k, const FlatProbes *probes)
{
    size_t most = 1;

    k->f->probes = probes;
    if (!probes)
        return;
    k->f->hits = ARENA_ARRAY(k->arena, uint64_t, probes->counters + 1);
    k->f->seen = arena_array(k->arena, probes->decisions + 1, sizeof *k->f->seen);
    k->decision_at = ARENA_ARRAY(k->arena, uint32_t *, probes->decisions + 1);
    k->value_at = ARENA_ARRAY(k->arena, uint32_t, probes->decisions + 1);
    for (uint32_t n = 0; n < probes->decisions; n++) {
        const size_t room = probes->decision[n].conditions + (size_t)2 * probes->decision[n].nodes;
        most = room > most ? room : most;
    }
    k->f->scratch = arena_alloc(k->arena, most);
}

FlatMachine *flat_new(Arena *arena, const IrMachine *m, const FlatProbes *probes)
{
    FlatMachine *f = ARENA_NEW(arena, FlatMachine);
    Maker k = {.arena = arena, .f = f, .temps = count_temps(m)};

    f->m = m;
    lay_out_state(arena, f);
    begin_probes(&k, probes);
    f->stored = arena_alloc(arena, m->var.n);
    f->fn = arena_array(arena, 1 + BLOCK_COUNT * m->state.n, sizeof *f->fn);
    f->sample = add_function(&k, m->sample);
    f->block = arena_array(arena, m->state.n, sizeof *f->block);
    for (size_t s = 0; s < m->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            f->block[s][b] = add_function(&k, m->state.at[s].block[b]);
    f->op = k.op.at;
    f->ops = k.op.n;
    f->frame = ARENA_ARRAY(arena, double, k.temps + k.number.n + 1);
    if (k.number.n)
        memcpy(f->frame + k.temps, k.number.at, k.number.n * sizeof *f->frame);
    f->decision_at = k.decision_at;
    f->value_at = k.value_at;
    return f;
}

// ---- counting a decision ----

static void count_hit(FlatMachine *f, uint32_t counter) { f->fresh += f->hits[counter]++ == 0; }

// Whether a window has all its samples.
static bool is_full(const FlatMachine *f, const void *run, uint32_t window)
{
    const uint64_t *ring = (const uint64_t *)(const void *)((const char *)run + f->window_at[window]);

    return sm_roll_count(ring) >= f->window_size[window];
}

// Computes the value of every node, and whether the node decides: whether the decision would have the other result if only this node had the
// other value.  The language evaluates both sides of `and` and `or` (language.md 3.14), so every condition always has a value.
static void judge_nodes(const FlatDecision *d, const bool *condition, bool *value, bool *decides)
{
    for (uint32_t n = 0; n < d->nodes; n++) {
        const FlatNode *node = &d->node[n];
        switch (node->kind) {
        case NODE_CONDITION: value[n] = condition[node->a]; break;
        case NODE_AND: value[n] = value[node->a] && value[node->b]; break;
        case NODE_OR: value[n] = value[node->a] || value[node->b]; break;
        case NODE_NOT: value[n] = !value[node->a]; break;
        }
    }
    decides[d->nodes - 1] = true;
    for (uint32_t n = d->nodes; n-- > 0; ) {
        const FlatNode *node = &d->node[n];
        if (node->kind == NODE_CONDITION)
            continue;
        decides[node->a] = decides[n] && (node->kind == NODE_NOT || value[node->b] == (node->kind == NODE_AND));
        if (node->kind != NODE_NOT)
            decides[node->b] = decides[n] && value[node->a] == (node->kind == NODE_AND);
    }
}

// Counts the conditions that decide, and the windows that they read.
static void count_conditions(FlatMachine *f, const void *run, const FlatDecision *d, const uint32_t *at)
{
    bool *condition = f->scratch, *value = condition + d->conditions, *decides = value + d->nodes;

    for (uint32_t c = 0; c < d->conditions; c++)
        condition[c] = f->frame[at[c]] != 0;
    judge_nodes(d, condition, value, decides);
    for (uint32_t n = 0; n < d->nodes; n++)
        if (d->node[n].kind == NODE_CONDITION && decides[n]) {
            const uint32_t c = d->node[n].a;
            count_hit(f, d->hit + 2 + 2 * c + !condition[c]);
            for (uint32_t w = 0; w < d->fulls; w++)
                if (d->full[w].condition == c && is_full(f, run, d->full[w].window))
                    count_hit(f, d->full[w].hit);
        }
}

// Counts a decision.  Its conditions are only examined when they or the fullness of their windows have changed since the last time.
static void count_decision(FlatMachine *f, const void *run, uint32_t number)
{
    const FlatDecision *d = &f->probes->decision[number];
    const uint32_t *at = f->decision_at[number];
    FlatSeen *seen = &f->seen[number];
    uint64_t bits = 0;

    count_hit(f, d->hit + !(f->frame[f->value_at[number]] != 0));
    if (d->conditions + d->fulls <= SEEN_BITS) {
        for (uint32_t c = 0; c < d->conditions; c++)
            bits = bits << 1 | (f->frame[at[c]] != 0);
        for (uint32_t w = 0; w < d->fulls; w++)
            bits = bits << 1 | is_full(f, run, d->full[w].window);
        if (seen->known && seen->bits == bits)
            return;
        seen->known = true;
        seen->bits = bits;
    }
    count_conditions(f, run, d, at);
}

// ---- running ----

uint64_t *flat_cells(const FlatMachine *f, void *run) { return (uint64_t *)(void *)((char *)run + f->cells); }

static uint64_t *window_of(const FlatMachine *f, void *run, uint32_t w) { return (uint64_t *)(void *)((char *)run + f->window_at[w]); }

static void sample_window(const FlatMachine *f, void *run, uint32_t w, double x)
{
    if (ir_stores_times(&f->m->window.at[w]))
        sm_roll_sample_event(window_of(f, run, w), f->window_size[w], f->window_kind[w], sm_to_u64(x), flat_cells(f, run)[f->m->g]);
    else
        sm_roll_sample(window_of(f, run, w), f->window_size[w], f->window_kind[w], x);
}

#define LOAD(t) case OP_LOAD + t: frame[o->to] = sm_cell_to_f64(t, cell[o->a]); break;
#define STORE(t) case OP_STORE + t: cell[o->to] = sm_cell_from_f64(t, frame[o->a]); f->stored[o->to] = 1; break;
#define EACH_TYPE(x) x(SM_I8) x(SM_I16) x(SM_I32) x(SM_I64) x(SM_U8) x(SM_U16) x(SM_U32) x(SM_U64) x(SM_F32) x(SM_F64) x(SM_BOOL)
#define BINARY(name, operator) case IR_##name: frame[o->to] = frame[o->a] operator frame[o->b]; break;
#define LOGIC(name, operator) case IR_##name: frame[o->to] = frame[o->a] != 0 operator frame[o->b] != 0; break;

// Runs a function to its end.  Returns the number of the next state, or 0 without a transition.
static uint32_t run_function(FlatMachine *f, void *run, uint32_t begin)
{
    double *const frame = f->frame;
    uint64_t *const cell = flat_cells(f, run);

    for (const FlatOp *o = f->op + begin; ; o++)
        switch (o->op) {
        EACH_TYPE(LOAD)
        EACH_TYPE(STORE)
        BINARY(add, +)
        BINARY(sub, -)
        BINARY(mul, *)
        BINARY(div, /)
        BINARY(eq, ==)
        BINARY(ne, !=)
        BINARY(lt, <)
        BINARY(le, <=)
        BINARY(gt, >)
        BINARY(ge, >=)
        LOGIC(and, &&)
        LOGIC(or, ||)
        case IR_not: frame[o->to] = frame[o->a] == 0; break;
        case IR_stat: frame[o->to] = sm_roll_stat(window_of(f, run, o->a), f->window_size[o->a], f->window_kind[o->a], (SmStat)o->stat); break;
        case IR_sample: sample_window(f, run, o->to, frame[o->a]); break;
        case OP_JUMP: o = f->op + o->to - 1; break;
        case OP_BRANCH: o = f->op + (frame[o->a] != 0 ? o->to : o->b) - 1; break;
        case OP_GOTO: f->taken = o->a; return o->to;
        case OP_END: return 0;
        case OP_COUNT: count_hit(f, o->to); break;
        case OP_RESULT: count_hit(f, o->to + !(frame[o->a] != 0)); break;
        case OP_DECIDE: count_decision(f, run, o->a); break;
        case OP_WATCH: f->watch(f->watcher, o->a); break;
        case OP_FULL:
            if (is_full(f, run, o->a))
                count_hit(f, o->to);
            break;
        default: frame[o->to] = ir_eval((IrOp)o->op, (SmType)o->type, frame[o->a], frame[o->b]);
        }
}

static void store_cell(FlatMachine *f, void *run, uint32_t var, uint64_t cell)
{
    flat_cells(f, run)[var] = cell;
    f->stored[var] = 1;
}

// Counts an entry or exit of a state.
static void count_state(FlatMachine *f, const uint32_t *counter, uint32_t state)
{
    if (f->probes && counter[state - 1])
        count_hit(f, counter[state - 1]);
}

// Runs the blocks of a state.  Returns the number of the next state, or 0 without a transition.
static uint32_t run_blocks(FlatMachine *f, void *run, const uint32_t *block, bool first)
{
    uint32_t to = 0;

    if (first && block[BLOCK_ENTRY] != FLAT_NOTHING)
        to = run_function(f, run, block[BLOCK_ENTRY]);
    if (to == 0 && block[BLOCK_STEP] != FLAT_NOTHING)
        to = run_function(f, run, block[BLOCK_STEP]);
    if (to != 0 && block[BLOCK_EXIT] != FLAT_NOTHING)
        run_function(f, run, block[BLOCK_EXIT]);
    return to;
}

// Runs one step of the machine in `run`.  Returns false and changes nothing if no step may run with this G.
bool flat_step_alone(FlatMachine *f, void *run)
{
    FlatState *s = run;
    const uint64_t g = flat_cells(f, run)[f->m->g];
    const uint32_t state = s->state;
    uint32_t to;

    memset(f->stored, 0, f->m->var.n);
    f->taken = 0;
    if (g == UINT64_MAX || (s->ran && g <= s->last_g))
        return false;
    s->last_g = g;
    s->ran = true;
    if (s->first) {
        store_cell(f, run, f->m->s, state);
        s->start = g;
        count_state(f, f->probes ? f->probes->entry : NULL, state);
    }
    flat_cells(f, run)[f->m->t] = g - s->start;
    if (f->sample != FLAT_NOTHING)
        run_function(f, run, f->sample);
    to = run_blocks(f, run, f->block[state - 1], s->first);
    s->first = f->moved = to != 0;
    if (to == 0)
        return true;
    s->state = to;
    count_state(f, f->probes ? f->probes->exit : NULL, state);
    return true;
}

bool flat_step(FlatMachine *f, void *run)
{
    if (!f->app)
        return flat_step_alone(f, run);
    flat_app_step(f, run);
    return true;
}

void flat_start(const FlatMachine *f, void *run, uint32_t state)
{
    FlatState *s = run;
    uint64_t *cell = flat_cells(f, run);

    memset(run, 0, f->size);
    s->state = state;
    s->first = true;
    for (size_t v = 0; v < f->m->var.n; v++)
        if (f->m->var.at[v].space == IR_LOCAL)
            cell[v] = f->m->var.at[v].init;
    cell[f->m->s] = state;
    if (f->app)
        flat_app_start(f, run);
}

void flat_clear_counts(FlatMachine *f)
{
    memset(f->hits, 0, (f->probes->counters + 1) * sizeof *f->hits);
    memset(f->seen, 0, (f->probes->decisions + 1) * sizeof *f->seen);
    f->fresh = 0;
}

static bool equal_bytes(const void *a, const void *b, size_t n) { return n == 0 || memcmp(a, b, n) == 0; }

bool flat_have_same_layout(const Program *p, const FlatMachine *a, const FlatMachine *b)
{
    return a->size == b->size && a->m->var.n == b->m->var.n && a->m->window.n == b->m->window.n
        && equal_bytes(a->m->var_of, b->m->var_of, p->var.n * sizeof *a->m->var_of)
        && equal_bytes(a->m->window_of, b->m->window_of, p->window.n * sizeof *a->m->window_of)
        && equal_bytes(a->window_at, b->window_at, a->m->window.n * sizeof *a->window_at)
        && equal_bytes(a->window_kind, b->window_kind, a->m->window.n * sizeof *a->window_kind);
}
