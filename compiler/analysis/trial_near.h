// SPDX-License-Identifier: Apache-2.0
// Why the search for situations has not reached a state: the guard that was never true, which of its comparisons never was, and how close
// its two sides came.
#ifndef SMC_TRIAL_NEAR_H
#define SMC_TRIAL_NEAR_H

#include "compiler/analysis/trial.h"

typedef struct TrialNear TrialNear;

// Prepares to record the guards of the machine's transitions.
TrialNear *trial_near_new(const Trials *t);
// Records the guards that the last step evaluated.  Comparisons are computed from the variables after the step, so a variable that the step
// has assigned after a guard counts with its new value.
void trial_near_record(TrialNear *near, const void *situation, const IrTrace *trace);
// Adds notes to finding d: for each state that no run reached although a transition from a reached state leads to it, a note about the guard of
// that transition.
void trial_near_note(const TrialNear *near, Diag *d);

#endif
