// SPDX-License-Identifier: Apache-2.0
// Runs of scripts as starting points of searches for violations (prove.h).
#ifndef SMC_PROVE_GIVEN_H
#define SMC_PROVE_GIVEN_H

#include "compiler/prove/prove.h"
#include "compiler/script/script.h"

// Runs a script on the reference interpreter, and records it.  p: the machine as its scripts run it; flown: the machine of the requirements, which
// can be another program of the same source.  Reports the script's findings to `diags`.  Returns whether the script has passed.
bool prove_record_script(Arena *arena, Diags *diags, const Program *p, const Program *flown, const Script *s, ProveGiven *out);

// Whether a search can start from a given run: it must have the same first state and step.
bool prove_uses_given(const ProveGiven *g, const State *init_state, uint64_t delta_t);

// What a given run shows about a requirement.
typedef struct GivenResult {
    uint64_t violated;        // the first step that violates the requirement; 0: none
    bool premise_seen;        // a step had the requirement's premise, so that it could have violated it
} GivenResult;

// Judges all requirements in each step of a given run.  Returns the results by requirement.
const GivenResult *prove_judge_given(Arena *arena, const Requirements *all, const Scenario *s);

#endif
