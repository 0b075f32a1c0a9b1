// SPDX-License-Identifier: Apache-2.0
// From IR to an image.  plan.c says of each instruction of the IR whether it waits for its user; select.c and jumps.c turn functions
// into instructions whose operands are symbols and whose jumps lead to labels, and registers.c knows what X and Y hold meanwhile;
// assemble.c places locals and turns instructions into bytes; image.c and debug.c put the sections of all machines together.
#ifndef SMC_EMIT_BYTECODE_H
#define SMC_EMIT_BYTECODE_H

#include <stdbool.h>
#include <stdint.h>

#include "compiler/base/buf.h"
#include "compiler/base/vec.h"
#include "compiler/diag/diag.h"
#include "compiler/ir/ir.h"
#include "compiler/sema/iomap.h"

// Makes one image of n machines, and of pins (io may be NULL).  False if they exceed what the format can hold, which is then reported.
bool emit_image(Arena *arena, Diags *diags, IrMachine *const *m, size_t n, const IoMap *io, bool debug, Buf *out);

// ---- between the files ----

enum { BC_RAW = SM_TYPE_COUNT, BC_POOLS };            // as the type of a slot: an F64 as it is

typedef enum BcOperandKind {
    BC_VAR,                   // element, local or T: `var`
    BC_SLOT,                  // a local that no source names, of type `type`; the `index`-th of its type
    BC_STAT,                  // statistic `index` of window `var`
    BC_CONST                  // the F64 with these `bits`; where it is no whole number that stands in the code, the `index`-th of its table
} BcOperandKind;

typedef struct BcOperand {
    BcOperandKind kind;
    uint32_t type;            // SmType, or of a slot BC_RAW
    uint32_t var, index;
    uint64_t bits;
    uint32_t output;          // of an element: 1 + its number among the outputs; 0: nothing writes it
} BcOperand;

typedef uint32_t BcRef;       // index into BcMachine.operand
#define BC_NONE UINT32_MAX

// An instruction.  SMVM_ldx_local, ldy_local and st_local stand for all that load X, load Y and store: which it is, `what` says.
typedef struct BcIns {
    uint8_t op;
    BcRef what;
    uint32_t n;               // the number that follows the opcode, but a jump's
    uint32_t to;              // of a jump: its label
    Span span;
    bool of_many;             // it belongs to several lines
    uint32_t at;              // offset in its function (assemble.c)
} BcIns;

typedef struct BcLabel {
    uint32_t at;              // the instruction it stands before
    uint32_t jumped;          // 1 + the last instruction that jumps here; 0: none does
} BcLabel;

typedef struct BcFn {
    VEC(BcIns) ins;
    VEC(BcLabel) label;
    uint32_t size;            // in bytes (assemble.c)
} BcFn;

typedef struct BcMachine {
    const IrMachine *ir;
    VEC(BcOperand) operand;
    BcRef *of_var;            // by variable: its operand, or BC_NONE
    BcRef *of_stat;           // by window and statistic likewise
    BcRef *const_slot;        // hash table of the BC_CONST operands
    size_t const_cap, consts;
    VEC(uint32_t) f32s;
    VEC(uint64_t) f64s;
    VEC(uint32_t) output;     // variables by number
    uint32_t slots[BC_POOLS]; // how many of each type
    uint32_t *window_number;  // by IR window: its number in the image, the order in which they take samples
    BcFn *fn;                 // 1 + 3 * states, as in the image's table of functions
    size_t fns;
    // assemble.c fills in:
    uint32_t *local_at;       // by variable: offset among the locals
    uint32_t slot_at[BC_POOLS];
    uint32_t locals;          // bytes
} BcMachine;

// Fills in everything up to `fns` for m.
void bc_select(Arena *arena, BcMachine *out, const IrMachine *m);

// A place as three bytes of the image have it; offset in units of the type's size.
uint32_t bc_pack(uint32_t offset, uint32_t type);
// A variable's.  UINT32_MAX if it lies too far behind.
uint32_t bc_place(const BcMachine *m, uint32_t var);

// Places locals.  NULL, or what does not fit the format.
const char *bc_layout(Arena *arena, BcMachine *m);
// Appends the function's bytes; *ok becomes false when it is too long.
void bc_assemble(Arena *arena, const BcMachine *m, BcFn *f, Buf *out, bool *ok);

void bc_varint(Buf *out, uint32_t value);
void bc_u24(Buf *out, uint32_t value);

// Whether x is a whole number that stands in the code, from -0x1000c60 to 0x1000c5f; then *n is it.
bool bc_whole(SmF64 x, int32_t *n);
bool bc_is_f32(SmF64 x);

// The DEBUG section.
void bc_debug(Arena *arena, const BcMachine *m, Buf *out);

#endif
