// SPDX-License-Identifier: Apache-2.0
// A generated program as compiled.
#ifndef SM_DIFF_SUBJECT_H
#define SM_DIFF_SUBJECT_H

#include "compiler/compile.h"
#include "compiler/script/engine.h"
#include "tests/diff/gen.h"

typedef struct Subject {
    Session session;
    const Program *program;
    uint32_t index[GEN_VARS_MAX];     // by GVar.id: where in Program.var
} Subject;

// NULL, or the compiler's error (in `arena`).  subject_free in both cases.
const char *subject_compile(Subject *s, Gen *g, Arena *arena);
// The machine of gen_print_inits.
const char *subject_compile_inits(Subject *s, Gen *g, Arena *arena);
void subject_free(Subject *s);

// The inputs written before step k; returns how many.
uint32_t subject_writes(const Subject *s, const Gen *g, uint32_t k, EngineWrite *out);

// Memory for an arena: the heap, and an end to the program where there is none.
void diff_arena_init(Arena *a);

#endif
