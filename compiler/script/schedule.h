// SPDX-License-Identifier: Apache-2.0
// Which conditionals of a script can be true in a step.  A guard such as `at 5 s`, `G == 500` or `T >= 100 and x > 3` is false outside an
// interval of G or of T.  A step therefore evaluates only the guards whose interval contains its time, and a script with a million
// steps costs a million short searches instead of a million times a million guards.  A guard such as `every 20 ms` waits in a heap for its
// next time.
#ifndef SMC_SCHEDULE_H
#define SMC_SCHEDULE_H

#include "compiler/script/ref.h"

typedef struct Schedule Schedule;

typedef VEC(const ScriptItem *) DueItems;

// cell: the initial values; only those of constant locals are used.
Schedule *schedule_new(Arena *arena, const Script *s, const uint64_t *cell);
// Replaces `due` by the items of [all_states] and of the sections of n states whose guards can be true, in source order.  Every other guard
// of these sections is false.  cell: the values before the step, with its G and T; G never decreases from call to call.
void schedule_find_due(Schedule *h, const State *const *state, size_t n, const uint64_t *cell, DueItems *due);
// Allows the next call to have a smaller G than the last one.
void schedule_rewind(Schedule *h);

#endif
