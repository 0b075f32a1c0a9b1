// SPDX-License-Identifier: Apache-2.0
// IR to self-contained C: one header and one source file, C99 and C++11, that need only the compiler's own headers and memcpy.
// docs/embedding-c.md documents what users of that C can rely on.
#ifndef SMC_EMIT_C_H
#define SMC_EMIT_C_H

#include "compiler/base/buf.h"
#include "compiler/ir/ir.h"
#include "compiler/sema/iomap.h"
#include "compiler/sema/network.h"
#include "compiler/sema/program.h"

typedef struct EmitCOptions {
    const char *prefix;           // prefix of every emitted name; NULL: derived from the name of the machine or state vector
    const char *header;           // the file name with which the source file includes its header; NULL: the machine's name and ".h"
    const char *source;           // name of the .sm, .sv, .io or .net file without folders, for comments; NULL: the machine's name and its extension
    bool track_stores;            // each step sets in m->stored which elements it stored
    bool soft;                    // for chips whose double is not a binary64: numbers are SmF64, whose operations are calls (sm_soft.h, stdlib/f64.h)
    bool runtime;                 // for the flight runtime.  Adds to a state vector what runtime-c/statevec.h describes, and to a machine
                                  // PREFIX_machine (runtime-c/machine_type.h); the machine tracks stores if the vector has `lock`
} EmitCOptions;

// Returns what is wrong with a prefix, as a sentence for the user, or NULL if it is valid.  A valid prefix is a C identifier that does not
// start with an underscore and has no two in a row.
const char *emit_c_prefix_error(const char *prefix);

// Emits one machine, the result of passes_for_c (passes/pass.h).  `o` may be NULL.  The output depends on the arguments alone.
void emit_c_machine(Arena *arena, const IrMachine *m, const EmitCOptions *o, Buf *header, Buf *code);

// Emits a state vector alone: the struct that the headers of its machines also declare.  With `runtime` also its storage, its tables, and
// one function to read and one to write each element.
void emit_c_state_vector(Arena *arena, const StateVec *sv, const EmitCOptions *o, Buf *header, Buf *code);

// Emits the pins of a .io as tables for runtime-c/io.h.
void emit_c_io(Arena *arena, const IoMap *io, const EmitCOptions *o, Buf *header, Buf *code);

// Emits the messages of a .net as tables for runtime-c/net.h.
void emit_c_net(Arena *arena, const Network *net, const EmitCOptions *o, Buf *header, Buf *code);

// Emits an image as an array NAME_image in a header; on AVR it stays in flash.  emit_c_bytes writes only its bytes, as an initialiser.
void emit_c_image(Arena *arena, const char *name, const Buf *image, const EmitCOptions *o, Buf *out);
void emit_c_bytes(const Buf *image, Buf *out);

// Emits the library of soft numbers (EmitCOptions.soft): sm_soft.h, sm_soft.c, sm_soft_avr.S. It is the same for all machines.  Not needed with
// runtime-c, which includes the library.
void emit_c_soft_library(Buf *header, Buf *code, Buf *assembly);

// Emits several machines, each the result of passes_for_c, and a main as one translation unit: a driver program that runs them on commands
// from its standard input.  compiler/device/engine_c.c compiles and drives it.  track_stores has one flag for each machine.  `soft`: as
// EmitCOptions.soft; the soft library is part of the unit.  Protocol, lowest byte first and without padding:
//   request:  u32 machine, u32 command, then
//             command 0, init:   u32 state     sets elements to zero and locals to their initial values, then calls init
//             command 1, step:   u32 n, n times (u32 variable, u64 cell)     writes the cells, then runs a step
//   answer:   u32 status (0 ok, 1 refused, 2 init failed), u32 next state, u32 whether the next step is a first step,
//             u64 cell of every variable, u8 whether the step stored it: 0 no, 1 yes, 2 not tracked
// A cell is the bit pattern of a value, zero-extended (compiler/script/engine.h).  Variables are indices into Program.var, or into
// IrMachine.var if there is no program.  The driver ends at the end of its input.
void emit_c_driver(Arena *arena, const IrMachine *const *m, const bool *track_stores, size_t n, bool soft, Buf *code);

#endif
