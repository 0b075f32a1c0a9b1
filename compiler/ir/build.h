// SPDX-License-Identifier: Apache-2.0
// What the files that build IR share.  build.c makes the machine and its statements, build_expr.c expressions,
// build_windows.c rolling windows.
#ifndef SMC_IR_BUILD_H
#define SMC_IR_BUILD_H

#include "compiler/ir/ir.h"

typedef struct Builder {
    Arena *arena;
    const Program *p;
    IrMachine *m;
    uint32_t *var;        // by Program.var: index into m->var, or IR_NONE for a local that is a constant
    uint32_t *window;     // by Program.window: index into m->window
    uint32_t stmt;        // Stmt.number of the statement being built
    IrFn *f;              // the function being built: room that all use, and build_end_function copies
    IrBlkRef b;           // its last block, which is being filled
} Builder;

// The value of an expression at the end of the block being filled, as an F64 or as a bool.
IrRef build_number(Builder *b, const Expr *e);
IrRef build_truth(Builder *b, const Expr *e);
// Converted as storing does.
IrRef build_stored(Builder *b, const Expr *e, SmType type);
// An instruction at the end of the block being filled.
IrRef build_emit(Builder *b, const IrIns *ins);

// Finds out which roll calls share a window, and builds the sample function.
void build_windows(Builder *b);
void build_begin_function(Builder *b);        // sets b, and f once
IrFn *build_end_function(Builder *b);

#endif
