// SPDX-License-Identifier: Apache-2.0
// Limits of a board.  A machine that exceeds one is an error, reported when it is built.
#ifndef SMC_LIMITS_H
#define SMC_LIMITS_H

#include <stdbool.h>
#include <stdint.h>

#include "compiler/diag/diag.h"
#include "compiler/sema/program.h"

// 0: no limit.
typedef struct CompileLimits {
    uint32_t ram;             // bytes of RAM, windows included
    uint32_t step;            // bytecode instructions of the longest step
    uint32_t cycles;          // processor cycles of the longest step on an ATmega
} CompileLimits;

static inline bool limits_exist(const CompileLimits *l) { return l->ram || l->step || l->cycles; }

// Reports by how much a machine exceeds the limits.  `image` contains only this machine, compiled from p as it will fly, and line numbers.
void limits_check(Arena *arena, Diags *d, const Program *p, const uint8_t *image, const CompileLimits *l);
// Reports that the limits cannot be judged for a machine, because an application compiles it to C.
void limits_report_c(Diags *d, const Program *p);

#endif
