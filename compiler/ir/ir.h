// SPDX-License-Identifier: Apache-2.0
// The intermediate representation, on which passes and both backends work.
//
// A machine is a set of functions: one that samples the windows, and up to three blocks a state.  A function is a list of
// basic blocks; control only moves forward, from a block to one with a higher number.  A block is a list of three-address
// instructions and ends in one jump.  Every instruction gives at most one result, a temporary named by the instruction's
// own number (%7).  A temporary is assigned once and lives in its block; what crosses blocks is a variable.  So there are
// no phis, no way out of SSA is needed, and emitted C keeps the author's names.
//
// Letters, here and in all of compiler/: m machine, f function, b block, i instruction, v variable.
#ifndef SMC_IR_H
#define SMC_IR_H

#include <stdbool.h>
#include <stdint.h>

#include "compiler/base/buf.h"
#include "compiler/base/str.h"
#include "compiler/base/vec.h"
#include "compiler/sema/program.h"
#include "stdlib/types.h"

typedef enum IrOp {
#define IR_OP(name, operands, types, narrow, effect, meaning) IR_##name,
#include "compiler/ir/ops.def"
#undef IR_OP
    IR_OP_COUNT
} IrOp;

typedef enum IrTypes { IR_T_CONST, IR_T_CONVERT, IR_T_SAME, IR_T_COMPARE, IR_T_LOGIC, IR_T_LOAD, IR_T_STORE, IR_T_SAMPLE, IR_T_STAT } IrTypes;

// What a SAME operation beside that on F64 may work on.  It then gives the same number as on F64: who narrowed has proved that
// every operand is exactly of that type and
//   on I32, I64  that the result is a whole number that fits and is at most 2^53 in magnitude, and no -0 that anyone could tell;
//   on F32       that all anyone asks of the result is its F32 (rounding to F64 first changes nothing, by the widths of both).
// So a pass may change narrowed operations only in ways that would be right on F64: 0 + x stays, for on F64 it makes 0 of -0.
// Likewise a comparison of operands that are not F64 gives what it gives of them converted to F64: of I64 and U64 beyond 2^53
// that is not so by itself.
typedef enum IrNarrow { IR_N_NONE, IR_N_INT, IR_N_F32, IR_N_BOTH } IrNarrow;

typedef struct IrOpInfo {
    const char *name;
    uint8_t operands;
    IrTypes types;
    IrNarrow narrow;
    bool effect;
} IrOpInfo;

extern const IrOpInfo ir_op_info[IR_OP_COUNT];

bool ir_may_be_of(IrOp op, SmType type);          // whether a SAME operation may work on this type

typedef uint32_t IrRef;               // a temporary: the number of the instruction that gives it
typedef uint32_t IrBlkRef;            // index into IrFn.blk
#define IR_NONE UINT32_MAX
#define IR_NAN UINT64_C(0x7ff8000000000000)   // the one spelling of NaN in a const

typedef struct IrIns {                // small: a machine is mostly these, and every pass goes through all of them
    IrOp op : 8;
    SmType type : 8;                  // of the result; of a store: the variable's; of a sample: unused, F64
    SmStat stat : 8;                  // stat
    IrRef a, b;                       // operands, or IR_NONE
    uint32_t var;                     // load, store: index into IrMachine.var; stat, sample: into IrMachine.window
    uint64_t bits;                    // const: the value as a bit cell of `type` (stdlib/convert.h)
    Span span;                        // what in the source it comes from
    uint32_t stmt;                    // as built: the statement it comes from (Stmt.number); else 0
} IrIns;

typedef enum IrJumpKind {
    IR_RET,                           // the block of the state is over
    IR_JMP,                           // to `then`
    IR_BR,                            // to `then` if temporary `cond` (bool), else to `otherwise`
    IR_GOTO                           // transition to state `state` (a number): the block is over
} IrJumpKind;

typedef struct IrJump {
    IrJumpKind kind;
    IrRef cond;
    IrBlkRef then, otherwise;
    uint32_t state;
    uint32_t stmt;                    // as IrIns.stmt
    Span span;
} IrJump;

typedef struct IrBlk {
    VEC(IrRef) ins;                   // which instructions, in order
    IrJump jump;
} IrBlk;

typedef struct IrFn {
    VEC(IrIns) ins;                   // the pool; an instruction in no block is dead
    VEC(IrBlk) blk;                   // at[0] is where it starts
} IrFn;

typedef enum IrSpace { IR_ELEMENT, IR_LOCAL, IR_TIME } IrSpace;

typedef struct IrVar {
    IrSpace space;
    Str name;                         // unique in the machine
    SmType type;
    uint32_t offset;                  // ELEMENT: in the state vector
    uint64_t init;                    // LOCAL: bit cell
    bool writable;                    // some function of the machine stores to it
    bool outside;                     // LOCAL: somebody beside the machine writes it between steps; else it starts at init
    bool hidden;                      // LOCAL: nobody beside the machine sees what it holds between steps
    Span span;
} IrVar;

typedef struct IrWindow {
    SmType type;                      // in which samples are kept: every sample is exactly of it
    uint32_t size;                    // n
    uint32_t stats;                   // 1u << SmStat for each statistic that is asked for
} IrWindow;

typedef struct IrState {
    Str name;
    bool is_safe;                     // @safe
    IrFn *block[BLOCK_COUNT];         // NULL: no code
    Span span;
} IrState;

typedef struct IrMachine {
    Str name;
    Str sv_name;
    uint32_t sv_size, sv_hash;
    VEC(IrVar) var;
    uint32_t g, s, t;                 // indices into var
    VEC(IrWindow) window;
    IrFn *sample;                     // gives every window its sample; NULL when there is none
    VEC(IrState) state;               // at[0] is number 1
    const Program *program;           // what it was built from, for names and spans; NULL when read from text
    const uint32_t *var_of;           // as built: by Program.var, which of `var` it is; IR_NONE: it is a constant
    const uint32_t *window_of;        // as built: by Program.window, which of `window` it is
} IrMachine;

// ---- building, text, checks ----

// The whole machine, unoptimised.  Constant locals become constants; equal windows are one.
IrMachine *ir_build(Arena *arena, const Program *p);
// A function that decides an expression of the machine that m was built from: block 1 where it holds, block 2 where it does not.
IrFn *ir_build_guard(Arena *arena, const IrMachine *m, const Expr *guard);

void ir_print(const IrMachine *m, Buf *out);                  // --emit=ir
// Reads what ir_print wrote.  NULL and a message in *error ("line 7: …") if it cannot.
IrMachine *ir_read(Arena *arena, StrPool *strings, const char *text, size_t len, const char **error);

// Checks everything this header promises.  NULL, or what is wrong, as a sentence.
const char *ir_verify(Arena *arena, const IrMachine *m);

// ---- working on functions ----

IrRef ir_emit(Arena *arena, IrFn *f, IrBlkRef b, IrIns ins);  // appends an instruction to a block
IrBlkRef ir_block(Arena *arena, IrFn *f);                     // a new, empty block, last in f
// For each instruction how many operands and jumps name it.
uint32_t *ir_count_uses(Arena *arena, const IrFn *f);
// Whether each block can be reached from the first.
bool *ir_reachable(Arena *arena, const IrFn *f);
// How many ways lead to each block from blocks that are reached; to the first one more, the function's start.
uint32_t *ir_count_ways(Arena *arena, const IrFn *f);
// For each block the nearest block through which every way from it to the function's end passes; IR_NONE for the end itself.
IrBlkRef *ir_postdominators(Arena *arena, const IrFn *f);

#endif
