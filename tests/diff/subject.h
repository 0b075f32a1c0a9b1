// SPDX-License-Identifier: Apache-2.0
// A generated program after compilation.
#ifndef SM_DIFF_SUBJECT_H
#define SM_DIFF_SUBJECT_H

#include "compiler/compile.h"
#include "compiler/script/engine.h"
#include "tests/diff/gen.h"

typedef struct Subject {
    Session session;
    const Program *program;
    uint32_t index[GEN_VARS_MAX];     // by GVar.id: the index in Program.var
} Subject;

// Returns NULL, or the error of the compiler, which is allocated in `arena`.  The caller calls subject_free in both cases.
const char *subject_compile(Subject *s, Gen *g, Arena *arena);
// Compiles the machine of gen_print_inits, with the same result as subject_compile.
const char *subject_compile_inits(Subject *s, Gen *g, Arena *arena);
// Compiles a machine that is text: it has no index.
const char *subject_compile_text(Subject *s, const char *text, Arena *arena);
void subject_free(Subject *s);

// Fills *out with the inputs that are written before step k.  Returns their number.
uint32_t subject_writes(const Subject *s, const Gen *g, uint32_t k, EngineWrite *out);

// Initialises an arena on the heap that ends the program when memory runs out.
void diff_arena_init(Arena *a);

#endif
