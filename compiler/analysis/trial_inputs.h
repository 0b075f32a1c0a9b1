// SPDX-License-Identifier: Apache-2.0
// What trials start from: the inputs of a machine and the readings that its conditions distinguish, the outputs that drive
// something, the times that it waits for.
#ifndef SMC_TRIAL_INPUTS_H
#define SMC_TRIAL_INPUTS_H

#include "compiler/analysis/trial.h"

// Fills in input, state[].relevant, actuator, wait and count of trials whose run, state and var exist.
void trial_find_inputs(Trials *t);

#endif
