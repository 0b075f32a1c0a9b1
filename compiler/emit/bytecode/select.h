// SPDX-License-Identifier: Apache-2.0
// What plan.c, operands.c, registers.c, select.c and jumps.c have in common.
#ifndef SMC_EMIT_BYTECODE_SELECT_H
#define SMC_EMIT_BYTECODE_SELECT_H

#include "bytecode-vm/image.h"
#include "compiler/emit/bytecode/bytecode.h"

#define BC_UNASKED (BC_NONE - 1)      // there is an operand, made when it is needed: constants are numbered in that order

// What is known of one instruction of the IR, in its block.
typedef struct Value {
    uint32_t uses;            // by live instructions and the jump
    uint32_t left;            // of these, not yet selected
    uint32_t last;            // position + 1 at which the last user is computed
    uint32_t again;           // of a store: position + 1 of the next one to its variable; UINT32_MAX: there is none in this block
    uint32_t depth;           // how many operations wait for each other in it
    bool placed;              // it has been computed where it stands: X holds it, or `slot`
    bool waits;               // it is computed by its user, or by each if it is a conversion that changes nothing
    bool early;               // of a load: it must be read where it stands, for a store to its variable follows
    bool negative;            // an integer that may be below zero
    bool inverted;            // of a truth that waits: its contrary is wanted
    bool minus_zero;          // an integer that the VM, which computes it as F64, may find to be -0
    BcRef slot;               // of a constant or load that is not placed its operand; or BC_UNASKED, BC_NONE
} Value;

// What a register is known to hold: all of these are the same number.
enum { HELD = 3 };
typedef struct Held {
    IrRef value;              // or IR_NONE
    BcRef from[HELD];         // operands that read so; or BC_NONE
} Held;

// An end of the function that jumps lead to: `end`, or `goto` a state.
typedef struct Exit {
    uint32_t fn;              // in which function the rest was noted, from 1
    uint32_t label;           // UINT32_MAX: none yet
    uint32_t at;              // 1 + the last instruction that is this end; 0: none yet
    Span span;                // of who jumps there
    bool of_many;             // from several lines
} Exit;

typedef struct Select {
    Arena *arena;
    BcMachine *m;
    const IrFn *f;
    BcFn *out;
    VEC(Value) values;        // room for those of a function
    Value *value;             // by instruction
    uint32_t *store_at;       // by variable: position + 1 of the next store to it…
    uint32_t *store_in;       // …in the counting of this number,
    uint32_t count;           // from 1: each block is counted twice
    VEC(BcRef) free[BC_POOLS];       // slots nobody uses
    Held x, y;
    uint32_t straight;        // the first instruction behind the last label that is jumped to
    Span span;                // of what is being selected
    uint32_t *label;          // by block: its label
    uint32_t inside;          // the first label of those inside the block's jump
    IrBlkRef *through;        // by block: itself, or where it leads if it only jumps
    Exit *exit;               // by state; [0] is `end`
    VEC(uint32_t) exits;      // those of this function
    uint32_t fn;              // its number, from 1
} Select;

// ---- plan.c: what is known of instructions ----

static inline const IrIns *bc_ins(const Select *s, IrRef r) { return &s->f->ins.at[r]; }
static inline bool bc_is_float(uint32_t type) { return type == SM_F32 || type == SM_F64; }

void bc_plan_block(Select *s, uint32_t block);
uint32_t bc_depth(const Select *s, IrRef r);          // how many operations wait for each other in r; 0 where nothing does
SmF64 bc_const_value(const IrIns *i);                 // the F64 that a constant stands for
static inline bool bc_is_waiting_cvt(const Select *s, IrRef r) { return s->value[r].waits && bc_ins(s, r)->op == IR_cvt; }
IrRef bc_converted(const Select *s, IrRef r);         // what waiting conversion r is a mere conversion of, or r
static inline IrRef bc_source(const Select *s, IrRef r) { return bc_is_waiting_cvt(s, r) ? bc_converted(s, r) : r; }
IrRef bc_without_truth(const Select *s, IrRef r);     // r without conversions that do not matter to who asks only whether it is true
IrRef bc_stored(const Select *s, IrRef r, SmType type);           // r without conversions that storing in that type does
bool bc_is_within(SmType a, SmType b);                // whether every number of type a is one of type b
bool bc_is_exact(const Select *s, IrRef r, SmType type);          // whether r's number is one of that type

// ---- operands.c ----

BcRef bc_var_operand(Select *s, uint32_t var);
BcRef bc_stat_operand(Select *s, uint32_t window, SmStat stat);
BcRef bc_const_operand(Select *s, SmF64 x);
BcRef bc_operand_of(Select *s, const IrIns *i);       // of a constant or load
uint32_t bc_type_of(const Select *s, BcRef r);        // of a variable or slot

// Slots hold what an operation gives until it is used: locals of a type, BC_RAW among them.
BcRef bc_slot_take(Select *s, uint32_t pool);
void bc_slot_give(Select *s, BcRef r);                // back, if it is one

// ---- registers.c ----

static inline bool bc_holds(const Held *h, BcRef o) { return o != BC_NONE && (h->from[0] == o || h->from[1] == o || h->from[2] == o); }
BcIns *bc_put(Select *s, uint8_t op);
void bc_forget(Select *s);                            // what X and Y hold
void bc_load_x(Select *s, BcRef o);                   // unless X holds it
void bc_load_y(Select *s, BcRef o);
void bc_keep_x(Select *s);                            // before X changes (and before Y is loaded): what is still needed of it goes to a slot
void bc_change_x(Select *s, uint8_t op, uint32_t n);  // an instruction that changes X
void bc_x_is(Select *s, IrRef r);                     // X now holds r
void bc_drop_cvt(Select *s, uint32_t type);           // the conversion to that type which X has just gone through, for a store does it
void bc_store_x(Select *s, BcRef d, bool same);       // same: d then reads as X
void bc_sample_x(Select *s, uint32_t window);
uint32_t bc_label_new(Select *s);
void bc_label_here(Select *s, uint32_t label);

// ---- select.c ----

void bc_select_ins(Select *s, IrRef r);
void bc_to_x(Select *s, IrRef r);                     // X holds r; one use less
// X and Y hold a and b; or, if that is better and `turns` allows it, b and a: then true.  `keep`: X is changed next.
bool bc_operands(Select *s, IrRef a, IrRef b, bool turns, bool keep);
uint32_t bc_relation(IrOp op);                        // of a comparison: a sum of SMVM_LESS …
uint32_t bc_mirrored(uint32_t relation);              // of Y to X
uint32_t bc_contrary(uint32_t relation);

// ---- jumps.c ----

void bc_select_function(Select *s, const IrFn *f, BcFn *out);

#endif
