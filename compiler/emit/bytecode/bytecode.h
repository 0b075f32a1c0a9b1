// SPDX-License-Identifier: Apache-2.0
// From IR to an image.  select.c turns functions into instructions whose operands are symbols and whose jumps lead to
// labels; assemble.c numbers the operands, the most used first, and turns instructions into bytes; image.c puts the
// sections of all machines together.
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

// ---- between the three files ----

typedef enum BcOperandKind {
    BC_VAR,                   // element, local or T: `var`
    BC_SCRATCH,               // a local that no source names, of type `type`; the `index`-th of its type
    BC_TEMP,                  // the `index`-th temp
    BC_ACC,                   // what the instruction before wrote, kept as `index`, a type or SMVM_RAW
    BC_CONST                  // the F64 with these `bits`
} BcOperandKind;

typedef struct BcOperand {
    BcOperandKind kind;
    SmType type;
    uint32_t var, index;
    uint64_t bits;
    bool stored;              // some instruction writes it
    uint32_t uses;            // how often instructions name it
    uint32_t number;          // its place in the operand table (assemble.c)
} BcOperand;

typedef uint32_t BcRef;       // index into BcMachine.operand; for windows, states and labels their own numbers
#define BC_NONE UINT32_MAX

// An instruction.  `d`, `x`, `y` and `w` as in opcodes.def; `to` is a state's number or a label.
typedef struct BcIns {
    uint8_t op;
    BcRef d, x, y;
    uint32_t w, to;
    uint32_t reads;           // how often what it writes in a slot is read; 0 where it is no slot
    Span span;
    uint32_t at;              // offset in its function (assemble.c)
} BcIns;

typedef struct BcFn {
    VEC(BcIns) ins;
    VEC(uint32_t) label;      // which instruction it stands before
    uint32_t size;            // in bytes (assemble.c)
} BcFn;

typedef struct BcMachine {
    const IrMachine *ir;
    VEC(BcOperand) operand;
    BcRef *of_var;            // by variable: its operand, or BC_NONE
    BcRef *const_slot;        // hash table of the BC_CONST operands
    size_t const_cap, consts;
    uint32_t scratches[SM_TYPE_COUNT];        // how many of each type
    uint32_t temps;
    uint32_t *window_number;  // by IR window: its number in the image, the order in which they take samples
    BcFn *fn;                 // 1 + 3 * states, as in the image's table of functions
    size_t fns;
    // assemble.c fills in:
    uint32_t *local_at;       // by variable: offset among the locals
    uint32_t scratch_at[SM_TYPE_COUNT];
    uint32_t locals;          // bytes
    BcRef *order;             // operands by number
    uint32_t outputs;
    VEC(uint32_t) f32s;
    VEC(uint64_t) f64s;
} BcMachine;

// Fills in everything up to `fns` for m.
void bc_select(Arena *arena, BcMachine *out, const IrMachine *m);

// An operand's entry in the image: kind and payload.  UINT32_MAX when the payload does not fit.
uint32_t bc_operand_entry(const BcMachine *m, const BcOperand *o);
uint32_t bc_var_entry(const BcMachine *m, uint32_t var);

// What does not fit the format, or NULL: "elements" …; places locals and numbers operands.
const char *bc_number(Arena *arena, BcMachine *m);
// Appends the function's bytes; *ok becomes false when a jump is too far.
void bc_assemble(Arena *arena, const BcMachine *m, BcFn *f, Buf *out, bool *ok);

void bc_varint(Buf *out, uint32_t value);

#endif
