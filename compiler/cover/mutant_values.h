// SPDX-License-Identifier: Apache-2.0
// What a search for mutants tries (mutant_search.h): inputs with values from the numbers with which the machine compares them, and durations.
#ifndef SMC_MUTANT_VALUES_H
#define SMC_MUTANT_VALUES_H

#include "compiler/base/vec.h"
#include "compiler/sema/program.h"

typedef VEC(double) MutantNumbers;

// An input, and the values that are tried.
typedef struct MutantInput {
    uint32_t var;
    SmType type;
    bool is_stored;           // the machine stores the variable, too: only its value before the first step is tried
    MutantNumbers value;
} MutantInput;

typedef struct MutantValues {
    VEC(MutantInput) input;
    uint32_t readings;        // number of inputs that the machine does not store
    MutantNumbers number;     // all numbers of the machine
    VEC(uint64_t) hold;       // durations, in steps
    VEC(uint32_t) output;     // variables that the machine stores (Var.index) and a script can read
} MutantValues;

enum { MUTANT_HOLD_MOST = 5000 };     // steps of a duration

// delta_t: by how much G grows in a step.
void mutant_values_list(Arena *arena, const Program *p, uint64_t delta_t, MutantValues *out);

#endif
