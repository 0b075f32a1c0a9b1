// SPDX-License-Identifier: Apache-2.0
// An engine whose sensors can be faulty (docs/faults.md).  It is between a run of a script and the engine that runs the machine: what
// the script writes to an input is the *true value*, and before each step the machine receives the *reading* of the sensor instead.  Between
// the steps the script sees the true values, so a fault changes no plant.
#ifndef SMC_FAULT_ENGINE_H
#define SMC_FAULT_ENGINE_H

#include "compiler/script/engine.h"

// The kinds of faults.
typedef enum FaultKind {
#define KIND(constant, name, sentence) FAULT_##constant,
#include "compiler/whatif/fault_kinds.def"
#undef KIND
    FAULT_KIND_COUNT
} FaultKind;

extern const char *const fault_kind_name[FAULT_KIND_COUNT], *const fault_kind_sentence[FAULT_KIND_COUNT];

typedef struct FaultInput {
    const Var *var;
    bool has_range;           // the two ends of its range differ
    bool range_is_seen;       // the range consists of the values that the input had in runs without a fault, because its element has no @range
    double lo, hi;
} FaultInput;

// How large faults are.
typedef struct FaultSizes {
    double offset, noise;     // parts of the range
    uint32_t late, dropped;   // steps; at least 1
    uint64_t seed;            // of the noise
} FaultSizes;

// A fault of a run.
typedef struct Fault {
    uint32_t input;           // index in the list of inputs
    FaultKind kind;
} Fault;

enum { FAULTS_MOST = 2 };     // the most faults that a run can have at once

typedef struct FaultEngine FaultEngine;

// Opens a faulty engine without a fault.  Its state is in `arena`, so that a copy of the arena is a copy of it, if the same holds for `inner`.
// calls: how many calls of random numbers the script has; the noise of fault i is that of call number calls + 1 + i (language.md 8.51).
FaultEngine *fault_engine_open(Arena *arena, Engine *inner, const FaultInput *input, uint32_t inputs, const FaultSizes *sizes, uint32_t calls);
Engine *fault_engine(FaultEngine *e);
// Begins n faults in the next step.
void fault_engine_begin(FaultEngine *e, const Fault *fault, uint32_t n);
// Whether some reading of a faulty input has differed from its true value.
bool fault_engine_differs(const FaultEngine *e);
// Returns the true value of an input, as a cell.
uint64_t fault_engine_true_cell(const FaultEngine *e, uint32_t input);
// Returns the cells of all variables after the last step, with the true values of inputs.
const uint64_t *fault_engine_outside(const FaultEngine *e);

#endif
