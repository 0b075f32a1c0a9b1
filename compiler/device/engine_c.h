// SPDX-License-Identifier: Apache-2.0
// Emitted C as an engine: machines are written as one C program, which the host's compiler builds in a folder of its own and
// which then runs as a partner process.  Nothing is left behind, and no crash of it is one of ours.
#ifndef SMC_ENGINE_C_H
#define SMC_ENGINE_C_H

#include "compiler/ir/ir.h"
#include "compiler/script/engine.h"

typedef struct EngineCOptions {
    const char *cc;           // the compiler and first options, as words of a shell: blanks separate, quotes and \ as there; NULL: $CC, or cc
    bool soft;                // with numbers in software
    const char *flags;        // more options; NULL: -O1, unless cc has one such
} EngineCOptions;

// Whether there is such a compiler.
bool engine_c_present(const EngineCOptions *o);

// One machine.  `o` may be NULL.  NULL and a sentence in *error when it cannot be built or started.
Engine *engine_c_open(Arena *arena, const Program *p, const IrMachine *m, const EngineCOptions *o, const char **error);

// Many machines in one program: one run of the compiler for all of them.  m[i] was built from p[i].
typedef struct EngineCBatch EngineCBatch;
EngineCBatch *engine_c_batch_open(Arena *arena, const Program *const *p, const IrMachine *const *m, size_t n,
                                  const EngineCOptions *o, const char **error);
// The engine of machine i.  Those of a batch may be used in any order; closing one does nothing.
Engine *engine_c_batch_engine(EngineCBatch *b, size_t i);
void engine_c_batch_close(EngineCBatch *b);

#endif
