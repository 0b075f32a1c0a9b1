// SPDX-License-Identifier: Apache-2.0
// Declarations that the files which build IR share.  build.c builds the machine and its statements, build_expr.c expressions,
// build_windows.c rolling windows.
#ifndef SMC_IR_BUILD_H
#define SMC_IR_BUILD_H

#include "compiler/ir/ir.h"
#include "compiler/sema/list.h"

typedef struct Builder {
    Arena *arena;
    const Program *p;
    IrMachine *m;
    uint32_t *var;        // by Var.index: index into m->var, or IR_NONE for a local that is a constant
    uint32_t *window;     // by index in Program.window: index into m->window
    uint32_t stmt;        // Stmt.number of the statement being built
    IrFn *f;              // the function being built: a buffer reused for all functions, which build_end_function copies
    IrBlkRef b;           // the current block: the last one of f, to which instructions are appended
    IrNotes *notes;       // the notes of ir_build_noting; or NULL
    size_t noted;         // number of entries of `notes` that are about earlier functions
    // The operations of the call of min, max, median or average being built, and the temporaries of its arguments and of these operations.
    // They are here and not on the stack, because expressions are built by recursion.
    ListStep list_step[LIST_STEPS_MAX];
    IrRef list_value[SM_LIST_MAX + LIST_STEPS_MAX];
} Builder;

// Appends the evaluation of an expression to the current block.  The value is an F64 (build_as_f64) or a bool (build_as_bool).
IrRef build_as_f64(Builder *b, const Expr *e);
IrRef build_as_bool(Builder *b, const Expr *e);
// Appends the evaluation of an expression, and the conversion to `type` that a store to a variable of this type requires.
IrRef build_for_store(Builder *b, const Expr *e, SmType type);
// Appends an instruction to the current block.
IrRef build_emit(Builder *b, const IrIns *ins);

// Determines which roll calls share a window, and builds the sample function.
void build_windows(Builder *b);
void build_begin_function(Builder *b);        // starts a function with one empty block, which becomes the current one
IrFn *build_end_function(Builder *b);         // returns a copy of the function; the buffer f is reused

#endif
