// SPDX-License-Identifier: Apache-2.0
// What a search for mutants tries (mutant_search.h): inputs with values from the numbers with which the machine compares them, and durations.
#ifndef SMC_MUTANT_VALUES_H
#define SMC_MUTANT_VALUES_H

#include "compiler/base/vec.h"
#include "compiler/sema/program.h"

typedef VEC(double) MutantNumbers;

// An input of the machine, and the values of it that the search tries.
typedef struct MutantInput {
    uint32_t var;             // Var.index
    SmType type;
    bool is_stored;           // the machine stores the variable, too: only its value before the first step is tried
    MutantNumbers value;
} MutantInput;

typedef struct MutantValues {
    VEC(MutantInput) input;
    uint32_t readings;        // number of inputs without is_stored
    MutantNumbers number;     // all constants in the machine
    VEC(uint64_t) hold;       // durations, in steps, for which the search holds values
    VEC(uint32_t) output;     // variables that the machine stores (Var.index) and a script can read
} MutantValues;

enum { MUTANT_HOLD_MOST = 5000 };     // the longest duration, in steps

// Fills *out.  delta_t: by how much G advances in a step.
void mutant_values_list(Arena *arena, const Program *p, uint64_t delta_t, MutantValues *out);

#endif
