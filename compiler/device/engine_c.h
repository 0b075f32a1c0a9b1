// SPDX-License-Identifier: Apache-2.0
// The engine that runs emitted C.  Machines are emitted as one C program, which the host's compiler builds in a temporary folder.  The program
// then runs as a partner process.  No files remain, and a crash of the program does not crash this process.
#ifndef SMC_ENGINE_C_H
#define SMC_ENGINE_C_H

#include "compiler/ir/ir.h"
#include "compiler/script/engine.h"

// The environment variable CC names the compiler and its first options, split and quoted like words in a shell; without it, the compiler is cc.
// Unless CC contains an -O option, -O1 is added.

// Whether the compiler can be run; if not, *why is a sentence in arena.  Also true if CC has an unclosed quote; engine_c_open then reports
// that.
bool engine_c_present(Arena *arena, const char **why);

// Opens an engine for one machine.  `soft`: with numbers in software (EmitCOptions.soft).  Returns NULL and sets *error to a sentence if the
// engine cannot be built or started.
Engine *engine_c_open(Arena *arena, const Program *p, const IrMachine *m, bool soft, const char **error);

// Many machines in one program: one run of the compiler for all of them.  m[i] was built from p[i].  NULL and *error as for engine_c_open.
typedef struct EngineCBatch EngineCBatch;
EngineCBatch *engine_c_batch_open(Arena *arena, const Program *const *p, const IrMachine *const *m, size_t n, bool soft, const char **error);
// Returns the engine of machine i.  The engines of a batch may be used in any order.  Closing a single engine of a batch does nothing.
Engine *engine_c_batch_engine(EngineCBatch *b, size_t i);
void engine_c_batch_close(EngineCBatch *b);

#endif
