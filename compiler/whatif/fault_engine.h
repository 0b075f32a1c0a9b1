// SPDX-License-Identifier: Apache-2.0
// An engine whose sensors can be faulty (docs/faults.md).  It is between a run of a script and the engine that runs the machine: what
// the script writes to an input is the *true value*, and before each step the machine receives the *reading* of the sensor instead.  Between
// the steps the script reads the true values, so the simulation of the plant in the script is the same with and without a fault.
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
    bool has_range;           // lo < hi
    bool range_is_seen;       // the range consists of the values that the input had in runs without a fault, because its element has no @range
    double lo, hi;            // the range of the input
} FaultInput;

// How large faults are.  Comments begin with the FaultKind that uses a size.
typedef struct FaultSizes {
    double offset, noise;     // BELOW, ABOVE: the error, as a fraction of the range; NOISY: the standard deviation, as a fraction of the range
    uint32_t late, dropped;   // LATE: by how many steps; DROPPED: for how many steps; both at least 1
    uint64_t seed;            // NOISY: seed of the random numbers
} FaultSizes;

// A fault of one sensor.
typedef struct Fault {
    uint32_t input;           // index in the list of inputs (Faults.input)
    FaultKind kind;
} Fault;

enum { FAULTS_MOST = 2 };     // the most faults that a run can have at once

typedef struct FaultEngine FaultEngine;

// Opens an engine whose sensors have no fault yet.  All of its state is in `arena`, so a copy of the arena copies the engine, if the state of `inner`
// is there, too.  calls: number of calls of random and noise in the script; the noise of fault i has the stream of call number calls + 1 + i
// (language.md 8.51).
FaultEngine *fault_engine_open(Arena *arena, Engine *inner, const FaultInput *input, uint32_t inputs, const FaultSizes *sizes, uint32_t calls);
Engine *fault_engine(FaultEngine *e);
// Begins n faults in the next step.
void fault_engine_begin(FaultEngine *e, const Fault *fault, uint32_t n);
// Whether some reading of a faulty input has differed from the true value so far.
bool fault_engine_differs(const FaultEngine *e);
// Returns the true value of an input, as a cell.
uint64_t fault_engine_true_cell(const FaultEngine *e, uint32_t input);
// Returns, by Var.index, the cells of all variables after the last step, with the true values of inputs.
const uint64_t *fault_engine_outside(const FaultEngine *e);

#endif
