// SPDX-License-Identifier: Apache-2.0
// What select.c, which chooses instructions, and slots.c, which knows operands, have in common.
#ifndef SMC_EMIT_BYTECODE_SELECT_H
#define SMC_EMIT_BYTECODE_SELECT_H

#include "compiler/emit/bytecode/bytecode.h"

// What is known of one instruction of the IR, in its block.
typedef struct Value {
    uint32_t uses;            // by live instructions and the jump
    uint32_t left;            // of these, not yet selected
    uint32_t last;            // position + 1 at which the last user is computed
    uint32_t depth;           // how many operations wait for each other in it
    bool placed;              // it has been computed where it stands: `slot` holds it
    bool waits;               // it is computed by its user, or by each if it is a conversion that changes nothing
    bool early;               // of a load: it must be read where it stands, for a store to its variable follows
    BcRef slot;
} Value;

typedef struct Select {
    Arena *arena;
    BcMachine *m;
    const IrFn *f;
    BcFn *out;
    Value *value;             // by instruction
    uint32_t *store_at;       // by variable: position + 1 of the next store to it…
    uint32_t *store_in;       // …in block store_in - 1
    VEC(BcRef) free[SM_TYPE_COUNT + 1];       // slots nobody uses: scratch of each type, BC_TEMPS
    BcRef acc[SM_TYPE_COUNT + 1];             // accumulators by pool; 0: none yet, for operand 0 is G
    Span span;                // of what is being selected
    uint32_t *label;          // by block: its label
    IrBlkRef *through;        // by block: itself, or where it leads if it only jumps
} Select;

// ---- operands ----

BcRef bc_var_operand(Select *s, uint32_t var);
BcRef bc_const_operand(Select *s, uint64_t bits);     // the F64 of these bits

// Slots hold what an operation gives until it is used: scratch locals of a type, and temps, for an F64 as it is (TEMPS).
enum { BC_TEMPS = SM_TYPE_COUNT };
BcRef bc_slot_take(Select *s, size_t pool);
void bc_slot_give(Select *s, BcRef r);                // back, if it is one

// ---- output ----

BcIns *bc_put(Select *s, uint8_t op);
BcRef bc_count(Select *s, BcRef r);                   // r, used once more
BcIns *bc_put_dxy(Select *s, uint8_t op, BcRef d, BcRef x, BcRef y);
void bc_use_acc(Select *s);                           // keeps in an accumulator what only the next instruction reads
void bc_drop_unused(Select *s);                       // operands, when all functions are there
uint32_t bc_label_new(Select *s);
void bc_label_here(Select *s, uint32_t label);

#endif
