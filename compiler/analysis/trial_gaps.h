// SPDX-License-Identifier: Apache-2.0
// What trial runs set out to try and did not: states that the search has not reached, sensors whose failures were not followed to their end
// in a state, numbers that were too many, checks that used their effort.  One warning for the whole machine names them (W0930).
#ifndef SMC_TRIAL_GAPS_H
#define SMC_TRIAL_GAPS_H

#include "compiler/analysis/analysis.h"

typedef enum TrialGapKind {
    GAP_STATE,                    // `state` was not reached from the machine's start
    GAP_SENSOR,                   // some failure of `sensor` in `state` was not tried, or its run was ended too early
    GAP_NUMBERS,                  // `sensor`, or the time if NULL, is compared with more numbers than trials can use
    GAP_CHECK,                    // the check with this `name` has reached its limit on instructions
    GAP_KINDS
} TrialGapKind;

typedef struct TrialGap {
    TrialGapKind kind;
    const State *state;
    const Var *sensor;
    const char *name;
} TrialGap;

struct TrialNear;

typedef struct TrialGaps {
    Arena *arena;
    VEC(TrialGap) list;
    const struct TrialNear *near;     // guards recorded with the first setting of parameters for which a state was not reached; NULL: none
} TrialGaps;

// Adds a gap, unless it is in the list.  `gaps` may be NULL.
void trial_add_gap(TrialGaps *gaps, TrialGap gap);
// Reports all gaps as one warning.  Reports nothing if trials have tried everything.
void trial_report_gaps(const Analysis *a, const TrialGaps *gaps);

#endif
