// SPDX-License-Identifier: Apache-2.0
// The intermediate representation (IR) on which the passes and both backends work.
//
// A machine is a set of functions: one that samples the rolling windows, which store the last samples of an expression (language.md 7),
// and up to three for each state (entry, step, exit).  A function is a list of basic blocks.  Control only moves forward, from a block to
// one with a higher number.  A block is a list of three-address instructions and ends in one jump.  Every instruction produces at most
// one result, a temporary named by the instruction's own number (%7).  A temporary is assigned once and is only used in its block.
// Values that cross blocks are variables.  So there are no phi functions, no conversion out of SSA is needed, and emitted C preserves
// the author's names.
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
#define IR_OP(name, operands, types, narrow, effect, commutes, nan, meaning) IR_##name,
#include "compiler/ir/ops.def"
#undef IR_OP
    IR_OP_COUNT
} IrOp;

// How the types of the operands and of the result depend on each other (ops.def).
typedef enum IrTypes { IR_T_CONST, IR_T_CONVERT, IR_T_SAME, IR_T_COMPARE, IR_T_LOGIC, IR_T_LOAD, IR_T_STORE, IR_T_SAMPLE, IR_T_STAT } IrTypes;

// The types other than F64 on which an operation of types SAME can work.  A narrowed operation (one on such a type) produces the same
// number as on F64.  The pass that narrowed it has proved that every operand is exactly of that type, and
//   on I32, I64  that the result is a whole number that fits, is at most 2^53 in magnitude, and is never an observable -0;
//   on F32       that every user reads only the F32 conversion of the result.  (The widths of both types imply that rounding to F64
//                first changes nothing.)
// So a pass may change a narrowed operation only where the change is also correct on F64: 0 + x stays, because on F64 it turns -0
// into 0.  A comparison of operands that are not F64 must have the same result as a comparison of the operands converted to F64.  The pass
// that creates it must prove this for I64 and U64, because conversion rounds them beyond 2^53.
typedef enum IrNarrow { IR_N_NONE, IR_N_INT, IR_N_F32, IR_N_BOTH } IrNarrow;

typedef enum IrNanRule { IR_NAN_NEVER, IR_NAN_OPERAND, IR_NAN_ANY } IrNanRule;        // when a result can be NaN (ops.def)

typedef struct IrOpInfo {             // a row of ops.def
    const char *name;
    uint8_t operands;
    IrTypes types;
    IrNarrow narrow;
    bool effect, commutes;
    IrNanRule nan;
} IrOpInfo;

extern const IrOpInfo ir_op_info[IR_OP_COUNT];

bool ir_is_elementary(IrOp op);                   // whether it is a function of stdlib/elementary.def
bool ir_op_allows_type(IrOp op, SmType type);     // whether a SAME operation may work on this type
IrOp ir_op_of_operator(SmOperator op);            // the operation of an operator; IR_OP_COUNT for unary plus, which has none

static inline bool ir_is_rounding(IrOp op) { return op == IR_floor || op == IR_ceil || op == IR_trunc || op == IR_round; }
static inline bool ir_is_float(SmType t) { return sm_type_info[t].kind == SM_KIND_FLOAT; }
static inline bool ir_is_integer(SmType t) { return sm_type_info[t].kind == SM_KIND_SIGNED || sm_type_info[t].kind == SM_KIND_UNSIGNED; }

// Whether integer type `wide` represents every value of integer type `type`.
static inline bool ir_integer_contains(SmType wide, SmType type)
{
    const SmTypeInfo *w = &sm_type_info[wide], *t = &sm_type_info[type];

    return w->bytes > t->bytes ? w->kind == SM_KIND_SIGNED || t->kind == SM_KIND_UNSIGNED : w->bytes == t->bytes && w->kind == t->kind;
}

typedef uint32_t IrRef;               // a temporary: the number of the instruction that produces it
typedef uint32_t IrBlkRef;            // index into IrFn.blk
#define IR_NONE UINT32_MAX
#define IR_NAN UINT64_C(0x7ff8000000000000)   // the only bit pattern of NaN in a const

typedef struct IrIns {                // bit fields keep it small: every pass visits all instructions
    IrOp op : 8;
    SmType type : 8;                  // type of the result; store: the variable's type; sample: unused, F64
    SmStat stat : 8;                  // stat: which statistic of the window
    IrRef a, b;                       // operands, or IR_NONE
    uint32_t var;                     // load, store: index into IrMachine.var; stat, sample: into IrMachine.window
    uint64_t bits;                    // const: the value as a bit cell of `type` (stdlib/convert.h)
    Span span;                        // the expression or statement of the source from which it was built
    uint32_t stmt;                    // set by ir_build: Stmt.number of its statement; else 0
} IrIns;

typedef enum IrJumpKind {
    IR_RET,                           // ends the function without a transition
    IR_JMP,                           // jumps to block `then`
    IR_BR,                            // jumps to block `then` if temporary `cond` (bool) is true, else to block `otherwise`
    IR_GOTO                           // transition to the state with number `state`; ends the function
} IrJumpKind;

typedef struct IrJump {
    IrJumpKind kind;
    IrRef cond;
    IrBlkRef then, otherwise;
    uint32_t state;
    uint32_t stmt;                    // set by ir_build: Stmt.number of the guard or transition; else 0
    Span span;
} IrJump;

typedef struct IrBlk {
    VEC(IrRef) ins;                   // numbers of its instructions in IrFn.ins, in order of execution
    IrJump jump;
} IrBlk;

typedef struct IrFn {
    VEC(IrIns) ins;                   // all instructions, by IrRef; one that is in no block's list is dead
    VEC(IrBlk) blk;                   // at[0] is the entry block
} IrFn;

typedef enum IrSpace { IR_ELEMENT, IR_LOCAL, IR_TIME } IrSpace;

typedef struct IrVar {
    IrSpace space;
    Str name;                         // name of the variable, unique in the machine
    Str element;                      // ELEMENT: the name in the state vector, if it differs from `name`; else NULL
    SmType type;
    uint32_t offset;                  // ELEMENT: bytes from the start of the state vector
    uint64_t init;                    // LOCAL: its initial value, as a bit cell
    const Parameter *parameter;       // LOCAL: a parameter, which no function stores to; its value is init or any other in its range; or NULL
    bool writable;                    // some function of the machine stores to the variable
    bool outside;                     // LOCAL: code outside the machine, such as a script, writes it between steps
    bool hidden;                      // LOCAL: no code outside the machine reads it between steps
    Span span;
} IrVar;

typedef struct IrWindow {
    SmType type;                      // type of the stored samples; it represents every sample exactly
    uint32_t size;                    // number of samples
    uint32_t stats;                   // the statistics that are read: 1u << SmStat for each
    const Window *first;              // set by ir_build: the first call of the program that has this window; else NULL
} IrWindow;

// Whether a window stores times: its samples are events (stdlib/roll.h), and its type is U64.
static inline bool ir_stores_times(const IrWindow *w) { return (w->stats & SM_STATS_OF_TIMES) != 0; }

typedef struct IrState {
    Str name;
    bool is_safe;                     // the state is marked @safe
    bool allows_swap;                 // the state is marked @swap
    bool is_abort;                    // the state is marked @abort
    IrFn *block[BLOCK_COUNT];         // the functions of .entry, .step and .exit; NULL: no code
    Span span;
} IrState;

typedef struct IrMachine {
    Str name;
    Str sv_name;
    uint32_t sv_size, sv_hash;
    VEC(IrVar) var;
    uint32_t g, s, t;                 // indices into var: G (the time), S (the state), T (the time in the state)
    VEC(IrWindow) window;
    IrFn *sample;                     // samples every window; NULL if there are no windows
    VEC(IrState) state;               // at[0] is the state with number 1
    const Program *program;           // the program it was built from, for names and spans; NULL if read from text
    const uint32_t *var_of;           // var_of[Var.index]: index into `var`; IR_NONE: a constant.  Set by ir_build
    const uint32_t *window_of;        // window_of[index in Program.window]: index into `window`.  Set by ir_build
    struct FactMachine *values;       // set by passes_for_c: the possible values of variables when functions begin (facts/facts.h)
} IrMachine;

// ---- building, printing, parsing, checking ----

// Builds the unoptimised IR of a machine.  Constant locals become constants; equal windows are merged.
IrMachine *ir_build(Arena *arena, const Program *p);

// Which temporary has the value of a condition of the source: of a value that is used as a bool, or of one comparison of a chain.
typedef struct IrNote {
    const Expr *e;
    uint32_t link;                    // for a chain a < b < c: number of the comparison, from 1; 0: the whole expression
    const IrFn *fn;
    IrRef ref;                        // the temporary, of type bool
} IrNote;
typedef VEC(IrNote) IrNotes;
// Like ir_build, and adds notes.  If several notes are about the same value, the last one is valid.
IrMachine *ir_build_noting(Arena *arena, const Program *p, IrNotes *notes);
// Builds a function that evaluates a condition of the program that m was built from.  Control reaches block 1 if the condition is true,
// else block 2.
IrFn *ir_build_guard(Arena *arena, const IrMachine *m, const Expr *guard);

void ir_print(const IrMachine *m, Buf *out);                  // prints the IR as text: the output of --emit=ir
// Parses the output of ir_print.  On a syntax error returns NULL and sets *error to a message ("line 7: …").
IrMachine *ir_read(Arena *arena, StrPool *strings, const char *text, size_t len, const char **error);

// Checks every invariant that this header states.  Returns NULL, or the first violation as a sentence.
const char *ir_verify(Arena *arena, const IrMachine *m);

// ---- working on functions ----

IrRef ir_emit(Arena *arena, IrFn *f, IrBlkRef b, IrIns ins);  // appends an instruction to a block
IrBlkRef ir_add_block(Arena *arena, IrFn *f);                 // appends an empty block to f, and returns its number
// Returns a copy of m whose functions can be changed.  Everything else is shared with m.
IrMachine *ir_copy(Arena *arena, const IrMachine *m);
// Returns for each instruction the number of operands and jumps that use its result.
uint32_t *ir_count_uses(Arena *arena, const IrFn *f);
// Returns for each block whether it is reachable from the first block.
bool *ir_find_reachable(Arena *arena, const IrFn *f);
// Returns for each block the number of edges into it from reachable blocks.  The start of the function counts as an edge into block 0.
uint32_t *ir_count_edges(Arena *arena, const IrFn *f);
// Returns for each block its immediate postdominator: the nearest block on every path from it to the function's end; IR_NONE is the end.
IrBlkRef *ir_find_postdominators(Arena *arena, const IrFn *f);

#endif
