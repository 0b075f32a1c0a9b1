// SPDX-License-Identifier: Apache-2.0
// IR to C that stands alone: one header and one source file, C99 and C++11, with no library behind them but the compiler's
// own headers and memcpy.  docs/embedding-c.md tells what the user of that C may rely on.
#ifndef SMC_EMIT_C_H
#define SMC_EMIT_C_H

#include "compiler/base/buf.h"
#include "compiler/ir/ir.h"
#include "compiler/sema/iomap.h"
#include "compiler/sema/program.h"

typedef struct EmitCOptions {
    const char *prefix;           // what every name starts with; NULL: the machine's (state vector's) name
    const char *header;           // how the .c includes its .h; NULL: the name and ".h"
    const char *source;           // the source's name without folders, for comments; NULL: the name and its ending
    bool track_stores;            // each step tells in m->stored which elements it stored
    bool soft;                    // for chips whose double is no binary64: numbers are SmF64s, of sm_soft.h or stdlib/f64.h
    bool runtime;                 // for runtime-c.  A vector: what statevec.h says.  A machine: also PREFIX_machine (machine_type.h); tracks
                                  // stores where the vector has `lock`
} EmitCOptions;

// What is wrong with a prefix, as a sentence for the user; NULL when it is fine: a C identifier that does not start with
// an underscore and has no two in a row.
const char *emit_c_prefix_error(const char *prefix);

// One machine.  `o` may be NULL.  The text depends on the arguments alone.
void emit_c_machine(Arena *arena, const IrMachine *m, const EmitCOptions *o, Buf *header, Buf *code);

// A state vector alone: the struct that the headers of its machines declare as well; with `runtime` its storage, its tables and a
// function to read and one to write for each element.
void emit_c_state_vector(Arena *arena, const StateVec *sv, const EmitCOptions *o, Buf *header, Buf *code);

// The pins of a .io: tables for runtime-c/io.h.
void emit_c_io(Arena *arena, const IoMap *io, const EmitCOptions *o, Buf *header, Buf *code);

// An image as an array in a header of its own, NAME_image; on AVR it stays in flash.  And its bytes alone, as an initialiser has them.
void emit_c_image(Arena *arena, const char *name, const Buf *image, const EmitCOptions *o, Buf *out);
void emit_c_bytes(const Buf *image, Buf *out);

// What goes with `soft`, but where there is runtime-c, which has it: sm_soft.h, sm_soft.c, sm_soft_avr.S.  The same for all machines.
void emit_c_soft_library(Buf *header, Buf *code, Buf *assembly);

// Several machines and a main as one translation unit: a program that runs them at the command of its standard input.
// compiler/device/engine_c.c compiles and drives it.  track_stores is by machine; `soft` is as above, all of it inside.  The exchange,
// lowest byte first and without padding:
//   to it:    u32 machine, u32 command, then
//             command 0, init:   u32 state                        elements zero, locals at their initial values, then init
//             command 1, step:   u32 n, n times (u32 variable, u64 cell)
//   from it:  u32 status (0 ok, 1 refused, 2 does not run here), u32 next state, u32 whether it will be a first step,
//             u64 cell of every variable, u8 stored of every variable: 0 no, 1 yes, 2 not tracked
// Variables are numbered as in Program.var, or as in IrMachine.var where there is no program.
// It ends at the end of its input.
void emit_c_driver(Arena *arena, const IrMachine *const *m, const bool *track_stores, size_t n, bool soft, Buf *code);

#endif
