// SPDX-License-Identifier: Apache-2.0
// Limits of a board.  A machine that exceeds one is an error, reported when it is built.
#ifndef SMC_LIMITS_H
#define SMC_LIMITS_H

#include <stdbool.h>
#include <stdint.h>

#include "compiler/budget/board.h"
#include "compiler/diag/diag.h"
#include "compiler/ir/ir.h"
#include "compiler/sema/iomap.h"
#include "compiler/sema/program.h"

// 0: no limit.
typedef struct CompileLimits {
    uint32_t ram;             // bytes of RAM, windows included
    uint32_t step;            // the most bytecode instructions that a step may execute
    uint32_t cycles;          // the most processor cycles that a step may take on an ATmega
    const Board *board;       // the board whose firmware runs the machine; NULL: no particular board
} CompileLimits;

static inline bool limits_exist(const CompileLimits *l) { return l->ram || l->step || l->cycles || l->board; }

// A machine that is judged, compiled as it will fly.
typedef struct LimitSubject {
    const Program *p;
    IrMachine *ir;
    const uint8_t *image;     // contains only this machine, with line numbers
    uint32_t length;          // bytes of the image without its line numbers, and with the pins of --io
    const IoMap *pins;        // the pins of --io; NULL: none
} LimitSubject;

// Reports by how much a machine exceeds the limits.
void limits_check(Arena *arena, Diags *d, const LimitSubject *m, const CompileLimits *l);
// Reports that the limits cannot be judged for a machine, because an application compiles it to C.
void limits_report_c(Diags *d, const Program *p);

#endif
