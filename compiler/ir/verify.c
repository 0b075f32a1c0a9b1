// SPDX-License-Identifier: Apache-2.0
// Checks the invariants that ir.h states, so that passes and emitters can rely on them.  Returns the first violation as a sentence.
// tests/ir/verify.c breaks each invariant once.  The check_ functions return false after a violation, which is then in IrChecker.error.
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "compiler/ir/ir.h"
#include "stdlib/roll.h"
#include "compiler/ir/text.h"

typedef struct IrChecker {
    Arena *arena;
    const IrMachine *m;
    const char *error;                // the first violation found; NULL: none
    const IrFn *f;                    // the function being checked, or NULL
    const char *state;                // the state of that function; NULL for the sample function
    const char *block;                // which function of the state it is: entry, step or exit
    bool *computed;                   // by instruction: its result is available in the current block
    bool *seen;                       // by instruction: it is in a block
    bool *sampled;                    // by window: it has been sampled
} IrChecker;

// Stores the sentence about a violation, which begins with its location.  Always returns false, so that a check can return the result.
#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
static bool report_violation(IrChecker *c, const char *format, ...)
{
    char text[200];
    va_list args;

    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    if (!c->f)
        c->error = format_in(c->arena, "%s", text);
    else if (!c->state)
        c->error = format_in(c->arena, "sample function: %s", text);
    else
        c->error = format_in(c->arena, "state %s, %s: %s", c->state, c->block, text);
    return false;
}

// ---- values and names ----

static bool is_identifier(Str s)
{
    if (!s || s->len == 0 || (s->text[0] >= '0' && s->text[0] <= '9'))
        return false;
    for (uint32_t i = 0; i < s->len; i++) {
        char c = s->text[i];
        if (!((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_'))
            return false;
    }
    return true;
}

static bool is_valid_type(SmType t)
{
    return (int)t >= 0 && t < SM_TYPE_COUNT;
}

static bool is_nan_cell(SmType type, uint64_t cell)
{
    if (type == SM_F32)
        return (cell & 0x7fffffffu) > 0x7f800000u;
    return type == SM_F64 && (cell & 0x7fffffffffffffffu) > 0x7ff0000000000000u;
}

// Whether a cell is valid for the type: no bit beyond the type's size is set, and a bool is 0 or 1.
static bool cell_fits(SmType type, uint64_t cell)
{
    if (type == SM_BOOL)
        return cell <= 1;
    return sm_type_info[type].bytes == 8 || cell >> (8 * sm_type_info[type].bytes) == 0;
}

// ---- declarations ----

static bool check_element(IrChecker *c, const IrVar *v)
{
    uint32_t bytes = sm_type_info[v->type].bytes;

    if (v->offset % bytes != 0)
        return report_violation(c, "element %.80s is not at a multiple of its size", v->name->text);
    if (c->m->sv_size < bytes || v->offset > c->m->sv_size - bytes)
        return report_violation(c, "element %.80s is outside the state vector", v->name->text);
    return true;
}

// Elements are at multiples of their size, so each element is within one group of eight bytes.  A hash table records which bytes of each
// group belong to an element that has been checked.
typedef struct UsedBytes { uint32_t group, bytes; } UsedBytes;        // bit i of `bytes`: byte i of the group is used; 0: an empty slot

static bool check_no_overlap(IrChecker *c)
{
    size_t cap = 16;
    UsedBytes *table;

    while (cap < c->m->var.n * 2)
        cap *= 2;
    table = ARENA_ARRAY(c->arena, UsedBytes, cap);
    for (size_t k = 0; k < c->m->var.n; k++) {
        const IrVar *v = &c->m->var.at[k];
        uint32_t group = v->offset / 8, bytes = ((1u << sm_type_info[v->type].bytes) - 1) << v->offset % 8;
        size_t at = group * UINT32_C(2654435761) & (cap - 1);
        if (v->space != IR_ELEMENT)
            continue;
        while (table[at].bytes && table[at].group != group)
            at = (at + 1) & (cap - 1);
        if (table[at].bytes & bytes)
            return report_violation(c, "element %.80s overlaps another", v->name->text);
        table[at].group = group;
        table[at].bytes |= bytes;
    }
    return true;
}

// Checks that a parameter is never stored to, and that its value is in its range.
static bool check_parameter_var(IrChecker *c, const IrVar *v)
{
    const SmParameterRange range = {v->type, v->parameter->lo, v->parameter->hi};

    if (v->writable || v->outside || v->hidden)
        return report_violation(c, "%.80s is a parameter, but a variable of other code", v->name->text);
    if (sm_parameter_judge(&range, sm_cell_to_f64(v->type, v->init)) || sm_parameter_judge(&range, sm_cell_to_f64(v->type, v->parameter->standard)))
        return report_violation(c, "the value of parameter %.80s is outside its range", v->name->text);
    return true;
}

static bool check_local(IrChecker *c, const IrVar *v)
{
    if (v->parameter && !check_parameter_var(c, v))
        return false;
    if (v->outside && v->hidden)
        return report_violation(c, "%.80s is hidden, but written from outside", v->name->text);
    if (!cell_fits(v->type, v->init))
        return report_violation(c, "the initial value of %.80s does not fit its type", v->name->text);
    return !is_nan_cell(v->type, v->init) || report_violation(c, "the initial value of %.80s is not a number", v->name->text);
}

// Checks the variable that is G, S or T (`role`): its space, its type, and that the machine does not write it.
static bool check_role(IrChecker *c, uint32_t index, const char *role, IrSpace space, SmType type)
{
    const IrVar *v = index < c->m->var.n ? &c->m->var.at[index] : NULL;

    if (!v || v->space != space || v->type != type)
        return report_violation(c, "%s is not what it must be", role);
    return !v->writable || report_violation(c, "%s is writable", role);
}

static bool check_vars(IrChecker *c)
{
    const IrMachine *m = c->m;
    Map names = {c->arena, NULL, NULL, 0, 0};

    if (m->sv_size % 8 != 0)
        return report_violation(c, "the state vector's size is no multiple of 8");
    for (uint32_t k = 0; k < m->var.n; k++) {
        const IrVar *v = &m->var.at[k];
        if (!is_identifier(v->name))
            return report_violation(c, "a variable's name is no identifier");
        if (map_find(&names, v->name))
            return report_violation(c, "there are two variables %.80s", v->name->text);
        map_put(&names, v->name, (void *)(uintptr_t)(k + 1));
        if (!is_valid_type(v->type))
            return report_violation(c, "%.80s has no type", v->name->text);
        if (v->space != IR_ELEMENT && v->space != IR_LOCAL && v->space != IR_TIME)
            return report_violation(c, "%.80s is no element, local or time", v->name->text);
        if (v->space == IR_TIME && k != m->t)
            return report_violation(c, "%.80s is a second time variable", v->name->text);
        if ((v->space == IR_ELEMENT && !check_element(c, v)) || (v->space == IR_LOCAL && !check_local(c, v)))
            return false;
    }
    return check_no_overlap(c) && check_role(c, m->g, "G", IR_ELEMENT, SM_U64) && check_role(c, m->s, "S", IR_ELEMENT, SM_U32)
        && check_role(c, m->t, "T", IR_TIME, SM_U64);
}

static bool check_windows(IrChecker *c)
{
    for (size_t w = 0; w < c->m->window.n; w++) {
        const IrWindow *window = &c->m->window.at[w];
        if (!is_valid_type(window->type))
            return report_violation(c, "window w%lu has no type", (unsigned long)w);
        if (window->size < 1 || window->size > SM_WINDOW_MAX)
            return report_violation(c, "the size of window w%lu is not 1 to %lu", (unsigned long)w, (unsigned long)SM_WINDOW_MAX);
        if (window->stats >> SM_STAT_COUNT != 0)
            return report_violation(c, "window w%lu has an unknown statistic", (unsigned long)w);
        if (ir_stores_times(window) && (window->type != SM_U64 || !sm_roll_is_kind(sm_roll_kind(SM_U64, window->stats))))
            return report_violation(c, "window w%lu stores times and has another type or statistic", (unsigned long)w);
    }
    return (c->m->window.n == 0) == (c->m->sample == NULL)
        || report_violation(c, "a sample function requires windows, and windows require one");
}

// ---- instructions ----

static bool check_operand(IrChecker *c, IrRef ref, IrRef user)
{
    if (ref >= c->f->ins.n || !c->computed[ref])
        return report_violation(c, "instruction %lu uses a temporary that its block has not computed before", (unsigned long)user);
    return true;
}

static bool check_operand_type(IrChecker *c, IrRef ref, SmType type, IrRef user)
{
    return c->f->ins.at[ref].type == type || report_violation(c, "an operand of instruction %lu is not of the right type", (unsigned long)user);
}

static bool check_const(IrChecker *c, const IrIns *i, IrRef ref)
{
    bool nan = is_nan_cell(i->type, i->bits);

    if (!cell_fits(i->type, i->bits))
        return report_violation(c, "the number of instruction %lu does not fit its type", (unsigned long)ref);
    if (nan && (i->type != SM_F64 || i->bits != IR_NAN))
        return report_violation(c, "instruction %lu has a NaN other than IR_NAN", (unsigned long)ref);
    return true;
}

// Checks a load or store.
static bool check_variable_access(IrChecker *c, const IrIns *i, IrRef ref)
{
    if (i->var >= c->m->var.n || c->m->var.at[i->var].type != i->type)
        return report_violation(c, "instruction %lu is not of its variable's type", (unsigned long)ref);
    if (i->op == IR_store && !c->m->var.at[i->var].writable)
        return report_violation(c, "instruction %lu writes %.80s, which is not writable", (unsigned long)ref,
                    c->m->var.at[i->var].name->text);
    return i->op != IR_store || !!c->state || report_violation(c, "instruction %lu writes a variable", (unsigned long)ref);
}

static bool check_sample(IrChecker *c, const IrIns *i, IrRef ref)
{
    if (c->state)
        return report_violation(c, "instruction %lu samples a window outside the sample function", (unsigned long)ref);
    if (i->var >= c->m->window.n || c->sampled[i->var])
        return report_violation(c, "instruction %lu samples a window twice or one that does not exist", (unsigned long)ref);
    c->sampled[i->var] = true;
    return true;
}

static bool check_stat(IrChecker *c, const IrIns *i, IrRef ref)
{
    if (i->type != SM_F64)
        return report_violation(c, "instruction %lu is a statistic and no F64", (unsigned long)ref);
    if (i->var >= c->m->window.n || (unsigned)i->stat >= SM_STAT_COUNT)
        return report_violation(c, "instruction %lu is a statistic of nothing", (unsigned long)ref);
    if (!(c->m->window.at[i->var].stats >> i->stat & 1))
        return report_violation(c, "instruction %lu reads a statistic that window w%lu does not list", (unsigned long)ref,
                    (unsigned long)i->var);
    return c->state || c->sampled[i->var]
        || report_violation(c, "instruction %lu reads window w%lu before its sample", (unsigned long)ref, (unsigned long)i->var);
}

// Checks that the operands are of type `from` and the result is of type `to`.
static bool check_operand_types(IrChecker *c, const IrIns *i, IrRef ref, SmType from, SmType to)
{
    if (i->type != to)
        return report_violation(c, "instruction %lu has a result of the wrong type", (unsigned long)ref);
    return check_operand_type(c, i->a, from, ref) && (ir_op_info[i->op].operands < 2 || check_operand_type(c, i->b, from, ref));
}

static bool check_ins(IrChecker *c, IrRef ref)
{
    const IrIns *i = &c->f->ins.at[ref];
    const IrOpInfo *op;
    bool ok = false;

    if (c->seen[ref])
        return report_violation(c, "instruction %lu occurs twice", (unsigned long)ref);
    c->seen[ref] = true;
    if ((unsigned)i->op >= IR_OP_COUNT)
        return report_violation(c, "instruction %lu has no operation", (unsigned long)ref);
    op = &ir_op_info[i->op];
    if ((op->operands > 0 && !check_operand(c, i->a, ref)) || (op->operands > 1 && !check_operand(c, i->b, ref)))
        return false;
    if (!is_valid_type(i->type))
        return report_violation(c, "instruction %lu has no type", (unsigned long)ref);
    switch (op->types) {
    case IR_T_CONST: ok = check_const(c, i, ref); break;
    case IR_T_CONVERT: ok = true; break;
    case IR_T_LOGIC: ok = check_operand_types(c, i, ref, SM_BOOL, SM_BOOL); break;
    case IR_T_SAME:
        ok = check_operand_types(c, i, ref, i->type, i->type)
            && (ir_op_allows_type(i->op, i->type) || report_violation(c, "instruction %lu cannot work on its type", (unsigned long)ref));
        break;
    case IR_T_COMPARE: ok = check_operand_types(c, i, ref, c->f->ins.at[i->a].type, SM_BOOL); break;
    case IR_T_LOAD: ok = check_variable_access(c, i, ref); break;
    case IR_T_STORE: ok = check_variable_access(c, i, ref) && check_operand_type(c, i->a, i->type, ref); break;
    case IR_T_SAMPLE: ok = check_sample(c, i, ref); break;
    case IR_T_STAT: ok = check_stat(c, i, ref); break;
    }
    c->computed[ref] = ok && !op->effect;
    return ok;
}

// ---- jumps, blocks, functions ----

static bool check_target(IrChecker *c, IrBlkRef from, IrBlkRef to)
{
    return (to > from && to < c->f->blk.n) || report_violation(c, "block b%lu does not jump forward to a block", (unsigned long)from);
}

static bool check_jump(IrChecker *c, IrBlkRef b, const IrJump *j)
{
    switch (j->kind) {
    case IR_RET: return true;
    case IR_JMP: return check_target(c, b, j->then);
    case IR_BR:
        if (j->cond >= c->f->ins.n || !c->computed[j->cond] || c->f->ins.at[j->cond].type != SM_BOOL)
            return report_violation(c, "the condition at the end of block b%lu is no bool of this block", (unsigned long)b);
        return check_target(c, b, j->then) && check_target(c, b, j->otherwise);
    case IR_GOTO:
        if (!c->state || strcmp(c->block, ir_block_name[BLOCK_EXIT]) == 0)
            return report_violation(c, "a transition is not allowed here");
        return (j->state >= 1 && j->state <= c->m->state.n) ||
               report_violation(c, "block b%lu goes to a state that does not exist", (unsigned long)b);
    }
    return report_violation(c, "block b%lu ends in no jump", (unsigned long)b);
}

static bool check_function(IrChecker *c, const IrFn *f, const char *state, const char *block)
{
    bool ok = true;

    c->f = f;
    c->state = state;
    c->block = block;
    c->computed = ARENA_ARRAY(c->arena, bool, f->ins.n);
    c->seen = ARENA_ARRAY(c->arena, bool, f->ins.n);
    if (f->blk.n == 0)
        return report_violation(c, "there is no block");
    for (IrBlkRef b = 0; ok && b < f->blk.n; b++) {
        const IrBlk *blk = &f->blk.at[b];
        for (size_t k = 0; ok && k < blk->ins.n; k++) {
            const IrRef ref = blk->ins.at[k];
            ok = ref < f->ins.n ? check_ins(c, ref)
                                : report_violation(c, "block b%lu contains an instruction that does not exist", (unsigned long)b);
        }
        ok = ok && check_jump(c, b, &blk->jump);
        for (size_t k = 0; ok && k < blk->ins.n; k++)
            c->computed[blk->ins.at[k]] = false;                // a temporary is only valid in its block
    }
    return ok;
}

static bool check_sample_function(IrChecker *c)
{
    const IrFn *f = c->m->sample;

    if (!f)
        return true;
    if (!check_function(c, f, NULL, NULL))
        return false;
    if (f->blk.n != 1)
        return report_violation(c, "it is not one block");
    for (size_t w = 0; w < c->m->window.n; w++)
        if (!c->sampled[w])
            return report_violation(c, "window w%lu gets no sample", (unsigned long)w);
    return true;
}

static bool check_states(IrChecker *c)
{
    Map names = {c->arena, NULL, NULL, 0, 0};
    bool ok = c->m->state.n > 0 || report_violation(c, "there is no state");

    for (size_t s = 0; ok && s < c->m->state.n; s++) {
        const IrState *state = &c->m->state.at[s];
        c->f = NULL;
        if (!is_identifier(state->name) || map_find(&names, state->name))
            return report_violation(c, "a state's name is no identifier, or two have the same");
        map_put(&names, state->name, &names);
        for (int k = 0; ok && k < BLOCK_COUNT; k++)
            if (state->block[k])
                ok = check_function(c, state->block[k], state->name->text, ir_block_name[k]);
    }
    return ok;
}

// Checks every invariant of the IR.  Returns NULL, or the first violation as a sentence.
const char *ir_verify(Arena *arena, const IrMachine *m)
{
    IrChecker c;

    memset(&c, 0, sizeof c);
    c.arena = arena;
    c.m = m;
    c.sampled = ARENA_ARRAY(arena, bool, m->window.n);
    if (check_vars(&c) && check_windows(&c) && check_sample_function(&c))
        check_states(&c);
    return c.error;
}
