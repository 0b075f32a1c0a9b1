// SPDX-License-Identifier: Apache-2.0
// Shared by waiting.c, operands.c, registers.c, bc_select.c and jumps.c.  An IR instruction *waits* if it is computed where its result is
// used.  Any other is computed at its own position.
#ifndef SMC_EMIT_BYTECODE_SELECT_H
#define SMC_EMIT_BYTECODE_SELECT_H

#include "bytecode-vm/image.h"
#include "compiler/emit/bytecode/bytecode.h"
#include "compiler/ir/eval.h"

#define BC_LATER (BC_NONE - 1)        // as BcValue.slot: the operand is created at its first use, because the image numbers constants in that order

// Facts about one IR instruction, within its block.
typedef struct BcValue {
    uint32_t uses;            // number of uses by live instructions and the block's jump
    uint32_t uses_left;       // uses that have not been selected yet
    uint32_t last;            // 1 + position in the block at which the last instruction that uses the value is computed
    uint32_t next_store;      // for a store: 1 + position in the block of the next store to the same variable; UINT32_MAX: no later store
    uint32_t depth;           // length of the longest chain of waiting operations in the expression that computes the value
    bool is_computed;         // the value has been computed at the instruction's own position, so it is in X or in `slot`
    bool waits;               // the value is computed where its only user needs it; a conversion that does not change the number, at each user
    bool early;               // for a load: must execute at its own position, because a store to the variable precedes the last use of the value
    bool negative;            // an integer that can be below zero
    bool inverted;            // for a waiting boolean: computes its negation instead
    bool minus_zero;          // the VM, which computes this integer as an F64, can get -0
    BcRef slot;               // the operand that stores the value; BC_LATER for a constant or a load whose operand is created when first needed
} BcValue;

// The known contents of register X or Y: the temporary, and operands that have the same value now.
enum { BC_REGISTER_SOURCES = 3 };
typedef struct BcRegister {
    IrRef value;              // the temporary (result of an IR instruction) that the register contains; IR_NONE: unknown
    BcRef from[BC_REGISTER_SOURCES];  // operands that have the same value; BC_NONE: an empty entry
} BcRegister;

// An exit of the function that jumps can target: the instruction `end`, or `goto` with a state.  All jumps to one exit share its label.
typedef struct BcExit {
    uint32_t fn;              // BcSelect.fn of the function for which the other fields are valid
    uint32_t label;           // label for jumps to the exit; UINT32_MAX: none yet
    uint32_t at;              // 1 + index of the last instruction emitted for this exit; 0: none yet
    Span span;                // source of the first jump to the exit
    bool of_many_lines;       // the exit has jumps from several source lines
} BcExit;

typedef struct BcSelect {
    Arena *arena;
    BcMachine *m;
    const IrFn *f;
    BcFn *out;
    VEC(BcValue) values;      // the memory that `value` points to; its capacity suffices for the largest function so far
    BcValue *value;           // by IR instruction of the current function: facts about the instruction
    uint32_t *store_at;       // by variable: 1 + position in the block of the next store to the variable…
    uint32_t *store_in;       // …which is valid only if store_in of the variable equals `count`
    uint32_t count;           // number of the current call of count_block_uses, from 1; each block needs one or two calls
    VEC(BcRef) free[BC_POOLS];       // slots that are not in use
    BcRegister x, y;
    uint32_t straight_start;  // index of the first instruction after the last label that a jump targets
    Span span;                // source of the IR instruction being selected
    uint32_t *label;          // by block: the label at its start
    uint32_t first_inner_label;  // number of the first label that the conditional jump of the current block has created
    IrBlkRef *final_target;   // by block: the block itself; for a block that only jumps, the block where its chain of such jumps ends
    BcExit *exit;             // by state: the exit `goto` this state; [0]: the exit `end`
    VEC(uint32_t) exits;      // the indices in `exit` that the current function uses
    uint32_t fn;              // number of the current function, from 1
} BcSelect;

// ---- waiting.c: facts about instructions ----

static inline const IrIns *bc_ins(const BcSelect *s, IrRef r) { return &s->f->ins.at[r]; }
static inline bool bc_is_float(uint32_t type) { return type == SM_F32 || type == SM_F64; }

// Fills in BcValue for each instruction of a block.
void bc_analyse_block(BcSelect *s, uint32_t block);
// Returns the length of the longest chain of waiting operations in r; 0 if r does not wait, or if the chain is too long to wait (waiting.c).
uint32_t bc_chain_depth(const BcSelect *s, IrRef r);
static inline SmF64 bc_const_value(const IrIns *i) { return ir_number(i->type, i->bits); }      // value of the constant i
static inline bool bc_is_waiting_cvt(const BcSelect *s, IrRef r) { return s->value[r].waits && bc_ins(s, r)->op == IR_cvt; }
IrRef bc_follow_exact_cvts(const BcSelect *s, IrRef r);  // the part of bc_skip_exact_cvts that is not inline
// Returns the operand of r before the waiting conversions that leave the number unchanged; r itself if r is no such conversion.
static inline IrRef bc_skip_exact_cvts(const BcSelect *s, IrRef r) { return bc_is_waiting_cvt(s, r) ? bc_follow_exact_cvts(s, r) : r; }
IrRef bc_skip_truth_cvts(const BcSelect *s, IrRef r);   // returns r without conversions that do not change whether it is true
IrRef bc_skip_store_cvts(const BcSelect *s, IrRef r, SmType type);  // r without conversions that a store to that type performs anyway
bool bc_is_within(SmType a, SmType b);       // whether type b can represent every number that a variable of type a can be read as
bool bc_is_exact(const BcSelect *s, IrRef r, SmType type);          // whether type `type` can represent every value of r

// ---- operands.c ----

// These return the operand for a variable, a statistic and a constant, which they create at the first use.
BcRef bc_var_operand(BcSelect *s, uint32_t var);
BcRef bc_stat_operand(BcSelect *s, uint32_t window, SmStat stat);
BcRef bc_const_operand(BcSelect *s, SmF64 x);
BcRef bc_operand_of(BcSelect *s, const IrIns *i);       // returns the operand for a constant or load
uint32_t bc_type_of(const BcSelect *s, BcRef r);        // returns the type of a variable or slot (BcOperand.type)

// A slot is a local that stores the result of an operation until it is used.  Each type, and BC_RAW, has a pool of slots.
BcRef bc_slot_alloc(BcSelect *s, uint32_t pool);
void bc_slot_free(BcSelect *s, BcRef r);                // returns a slot to its pool; other operands are ignored

// ---- registers.c ----

static inline bool bc_register_has(const BcRegister *h, BcRef o) { return o != BC_NONE && (h->from[0] == o || h->from[1] == o || h->from[2] == o); }
BcIns *bc_emit(BcSelect *s, uint8_t op);
void bc_forget_registers(BcSelect *s);                  // forgets the contents of X and Y
void bc_load_x(BcSelect *s, BcRef o);                   // loads operand o into X; emits nothing if X contains its value already
void bc_load_y(BcSelect *s, BcRef o);                   // loads operand o into Y; emits nothing if Y contains its value already
void bc_save_x(BcSelect *s);                            // saves X to a slot if its value is needed later; call before X changes and before Y is
                                                        // loaded
void bc_forget_y(BcSelect *s);                                 // records that Y is undefined
void bc_emit_changing_x(BcSelect *s, uint8_t op, uint32_t n);  // emits an instruction that changes X, with immediate operand n
void bc_record_x(BcSelect *s, IrRef r);                       // records that X contains r; saves the value recorded before if it is still needed
void bc_drop_cvt(BcSelect *s, uint32_t type);           // removes a conversion of X to `type` before a store to this type, which converts too
void bc_store_x(BcSelect *s, BcRef d, bool same);       // stores X in d.  same: a load of d then returns exactly what X contains
void bc_sample_x(BcSelect *s, uint32_t window);                 // emits the instruction that adds X as a sample to a window
uint32_t bc_label_new(BcSelect *s);
void bc_label_place(BcSelect *s, uint32_t label);               // places the label at the next instruction

// ---- bc_select.c ----

void bc_select_ins(BcSelect *s, IrRef r);
void bc_bring_to_x(BcSelect *s, IrRef r);                     // loads or computes r into X and counts one use
// Loads or computes a into X and b into Y.  If `may_swap` and fewer instructions result, puts b into X and a into Y and returns true.
// `keep`: the next instruction changes X, so X is first saved if it is needed again.
bool bc_load_operands(BcSelect *s, IrRef a, IrRef b, bool may_swap, bool keep);
uint32_t bc_relation_of(IrOp op);                     // the outcomes for which comparison `op` is true: bits SMVM_LESS, SMVM_EQUAL …
uint32_t bc_swapped_relation(uint32_t relation);           // returns the relation with X and Y exchanged
uint32_t bc_negated_relation(uint32_t relation);

// ---- jumps.c ----

void bc_select_function(BcSelect *s, const IrFn *f, BcFn *out);

#endif
