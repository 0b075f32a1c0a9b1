// SPDX-License-Identifier: Apache-2.0
// From IR to an image.  waiting.c decides which IR instructions wait for their user.  bc_select.c and jumps.c turn functions into bytecode
// instructions with symbolic operands and labels; registers.c tracks the contents of X and Y meanwhile.  assemble.c assigns offsets to
// locals and encodes instructions.  image.c and debug.c join the sections of all machines.
#ifndef SMC_EMIT_BYTECODE_H
#define SMC_EMIT_BYTECODE_H

#include <stdbool.h>
#include <stdint.h>

#include "compiler/base/buf.h"
#include "compiler/base/vec.h"
#include "compiler/diag/diag.h"
#include "compiler/ir/ir.h"
#include "compiler/sema/iomap.h"

// Builds one image of n machines and of pins (io may be NULL).  Returns false, and reports it, if they exceed the limits of the format.
bool emit_image(Arena *arena, Diags *diags, IrMachine *const *m, size_t n, const IoMap *io, bool debug, Buf *out);

// ---- shared between the files ----

// The types of slots: those of SmType, and BC_RAW, an F64 that is stored unchanged.  BC_POOLS is their number.
enum { BC_RAW = SM_TYPE_COUNT, BC_POOLS };

typedef enum BcOperandKind {
    BC_VAR,                   // a state-vector element, a local or T: IR variable `var`
    BC_SLOT,                  // a temporary local of type `type`, without a source name; the `index`-th slot of its type
    BC_STAT,                  // statistic `index` of window `var`
    BC_CONST                  // the F64 with these `bits`; if no instruction can contain it (bc_try_whole), it is entry `index` of f32s or f64s
} BcOperandKind;

typedef struct BcOperand {
    BcOperandKind kind;
    uint32_t type;            // SmType; for a slot also BC_RAW
    uint32_t var, index;
    uint64_t bits;
    uint32_t output;          // for an element: 1 + the element's number among the outputs; 0: no instruction has stored the element yet
} BcOperand;

typedef uint32_t BcRef;       // index into BcMachine.operand
#define BC_NONE UINT32_MAX

// An instruction.  SMVM_ldx_local, ldy_local and st_local represent all loads of X, loads of Y and stores; `operand_ref` is what they load
// or store.
typedef struct BcIns {
    uint8_t op;
    BcRef operand_ref;
    uint32_t n;               // the immediate operand: a number after the opcode that is not a jump distance
    uint32_t to;              // for a jump: number of the label that it leads to
    Span span;
    bool of_many_lines;       // several source lines share the instruction
    uint32_t at;              // byte offset in its function (assemble.c; while the function is encoded: the distance to its end)
} BcIns;

typedef struct BcLabel {
    uint32_t at;              // index of the instruction that the label precedes
    uint32_t last_jump;       // 1 + index of the last instruction that jumps to the label; 0: no jump
} BcLabel;

typedef struct BcFn {
    VEC(BcIns) ins;
    VEC(BcLabel) label;
    uint32_t size;            // bytes of the encoded function (assemble.c)
} BcFn;

typedef struct BcMachine {
    const IrMachine *ir;
    VEC(BcOperand) operand;
    BcRef *of_var;            // by variable: index in `operand` of the variable's operand; BC_NONE: not created yet
    BcRef *of_stat;           // by window and statistic: index of the operand in `operand`; BC_NONE: not created yet
    BcRef *const_slot;        // hash table of the BC_CONST operands, with `const_cap` entries of which `consts` are used
    size_t const_cap, consts;
    VEC(uint32_t) f32s;
    VEC(uint64_t) f64s;
    VEC(uint32_t) output;     // by output number, from 0: the variable that is stored
    uint32_t slots[BC_POOLS]; // number of slots of each type
    uint32_t *window_number;  // by index of an IR window: the window's number in the image, which numbers windows in the order of sampling
    BcFn *fn;                 // the function that samples the windows, then entry, step and exit of each state, as in the image's table of functions
    size_t fns;
    // filled in by assemble.c:
    uint32_t *local_at;       // by variable: byte offset among the locals
    uint32_t slot_at[BC_POOLS];
    uint32_t locals;          // size of all locals and slots, in bytes
} BcMachine;

// Fills in everything up to `fns` for m.
void bc_select_machine(Arena *arena, BcMachine *out, const IrMachine *m);

// Packs an offset and a type into a location, three bytes of an image.  The offset is in units of the type's size.
uint32_t bc_pack_offset(uint32_t offset, uint32_t type);
// Returns the location of a variable; UINT32_MAX if its offset is too large for the format.
uint32_t bc_pack_location(const BcMachine *m, uint32_t var);

// Assigns offsets to locals and slots.  Returns NULL, or the name of the quantity that exceeds a limit of the image format.
const char *bc_lay_out_locals(Arena *arena, BcMachine *m);
// Appends the function's bytes; sets *ok to false when it is too long.
void bc_assemble(Arena *arena, const BcMachine *m, BcFn *f, Buf *out, bool *ok);

// Appends a number as a varint, one to four bytes (docs/bytecode.md).
void bc_write_varint(Buf *out, uint32_t value);
// Appends the low three bytes of a number, low byte first.
void bc_write_u24(Buf *out, uint32_t value);

// Sets *n to x if x is a whole number that an instruction can encode, from -0x1000c60 to 0x1000c5f (SMVM_VARINT_END).  Returns false if not.
bool bc_try_whole(SmF64 x, int32_t *n);
bool bc_is_f32(SmF64 x);          // whether an F32 constant represents x exactly; true for NaN

// Appends the DEBUG section.
void bc_write_debug(Arena *arena, const BcMachine *m, Buf *out);

#endif
