// SPDX-License-Identifier: Apache-2.0
// Emits instructions and tracks the contents of X and Y, so that a value already in a register is not loaded again.  A value in X that is
// still needed is saved to a slot only when X is needed for something else.
#include "compiler/emit/bytecode/bc_select.h"

// ---- register contents ----

static BcRegister empty_register(void) { return (BcRegister){IR_NONE, {BC_NONE, BC_NONE, BC_NONE}}; }

// Records that operand o has the same value as the register.
static void add_source(BcRegister *h, BcRef o)
{
    int i = 0;

    while (i < BC_REGISTER_SOURCES - 1 && h->from[i] != BC_NONE && h->from[i] != o)
        i++;
    h->from[i] = o;
}

// Removes o from the operands whose value the register holds.
static void remove_source(BcRegister *h, BcRef o)
{
    for (int i = 0; i < BC_REGISTER_SOURCES; i++)
        if (h->from[i] == o)
            h->from[i] = BC_NONE;
}

// Forgets the contents of X and Y.
void bc_forget_registers(BcSelect *s) { s->x = s->y = empty_register(); }

// ---- instructions ----

// Appends an instruction. The pointer is valid until the next one is appended.
BcIns *bc_emit(BcSelect *s, uint8_t op)
{
    const BcIns i = {.op = op, .operand_ref = BC_NONE, .span = s->span};

    vec_push(s->arena, &s->out->ins, i);
    return &s->out->ins.at[s->out->ins.n - 1];
}

static bool is_x_unsaved(const BcSelect *s)             // X holds the only copy of a value that is still needed
{
    const BcValue *v = s->x.value == IR_NONE ? NULL : &s->value[s->x.value];

    return v && v->is_computed && v->uses_left > 0 && v->slot == BC_NONE;
}

// Returns the pool of the slot that saves r: its own type, or BC_RAW for the result of an F64 operation, which is saved unchanged.
static uint32_t slot_pool_of(const BcSelect *s, IrRef r)
{
    const IrIns *i = bc_ins(s, r);

    return i->type != SM_F64 || i->op == IR_cvt ? (uint32_t)i->type : (uint32_t)BC_RAW;
}

// Removes a conversion of X to `type` before a store to this type, which converts too.
void bc_drop_cvt(BcSelect *s, uint32_t type)
{
    const size_t n = s->out->ins.n;

    if (n > s->straight_start && s->out->ins.at[n - 1].op == SMVM_cvt && s->out->ins.at[n - 1].n == type) {
        s->out->ins.n--;
        s->x = empty_register();
    }
}

static void save_to_slot(BcSelect *s, bool is_needed)                // is_needed: the value is also needed in X afterwards
{
    const IrRef r = s->x.value;
    BcValue *v = &s->value[r];

    v->slot = bc_slot_alloc(s, slot_pool_of(s, r));
    if (!is_needed)
        bc_drop_cvt(s, bc_type_of(s, v->slot));
    bc_store_x(s, v->slot, is_needed);
}

// Saves X to a slot if its value is needed later; call before X changes and before Y is loaded.
void bc_save_x(BcSelect *s)
{
    if (is_x_unsaved(s))
        save_to_slot(s, true);
}

// Loads operand o into X; emits nothing if X contains its value already.
void bc_load_x(BcSelect *s, BcRef o)
{
    if (bc_register_has(&s->x, o))
        return;
    if (is_x_unsaved(s))
        save_to_slot(s, false);
    bc_emit(s, SMVM_ldx_local)->operand_ref = o;
    bc_forget_registers(s);
    s->x.from[0] = o;
}

// Loads operand o into Y, unless Y holds it already.
void bc_load_y(BcSelect *s, BcRef o)
{
    if (bc_register_has(&s->y, o))
        return;
    bc_emit(s, SMVM_ldy_local)->operand_ref = o;
    s->y = empty_register();
    s->y.from[0] = o;
}

// Emits an instruction whose result replaces X.
void bc_emit_changing_x(BcSelect *s, uint8_t op, uint32_t n)
{
    bc_emit(s, op)->n = n;
    s->x = empty_register();
}

// Records that Y is undefined.
void bc_forget_y(BcSelect *s) { s->y = empty_register(); }

// Records that X contains r; saves the value recorded before if it is still needed.
void bc_record_x(BcSelect *s, IrRef r)
{
    if (s->x.value == r)
        return;
    bc_save_x(s);
    s->x.value = r;
}

// Gives a state-vector element without an output number the next one, counted from 1.
static void assign_output_number(BcSelect *s, BcOperand *o)
{
    if (o->kind != BC_VAR || o->output > 0 || s->m->ir->var.at[o->var].space != IR_ELEMENT)
        return;
    vec_push(s->arena, &s->m->output, o->var);
    o->output = (uint32_t)s->m->output.n;
}

// Stores X in d.  same: a load of d then returns exactly what X contains.
void bc_store_x(BcSelect *s, BcRef d, bool same)
{
    bc_emit(s, SMVM_st_local)->operand_ref = d;
    assign_output_number(s, &s->m->operand.at[d]);
    s->y = empty_register();
    remove_source(&s->x, d);
    if (same)
        add_source(&s->x, d);
}

void bc_sample_x(BcSelect *s, uint32_t window)
{
    bc_emit(s, SMVM_sample)->n = window;
    s->y = empty_register();
}

// ---- labels ----

uint32_t bc_label_new(BcSelect *s)
{
    const BcLabel none = {UINT32_MAX, 0};

    vec_push(s->arena, &s->out->label, none);
    return (uint32_t)(s->out->label.n - 1);
}

// Places the label at the next instruction.
void bc_label_place(BcSelect *s, uint32_t label)
{
    BcLabel *l = &s->out->label.at[label];

    l->at = (uint32_t)s->out->ins.n;
    if (l->last_jump == 0)
        return;
    s->straight_start = l->at;
    bc_forget_registers(s);
}
