// SPDX-License-Identifier: Apache-2.0
// Judges the requirements of a machine after each of its steps (requirements.md 13), whatever runs the machine.
//
// A situation is the complete state of all requirements in one block of memory: what their conditions have sampled, and what each of them
// has seen.  It contains no pointers, so a search can copy it with memcpy, beside the situation of the machine, and return to it.  A step
// allocates nothing.
//
//     Monitor *m = monitor_new(arena, requirements, delta_t);
//     void *s = arena_alloc(arena, m->size);
//     monitor_start(m, s);
//     monitor_step(m, s, cell);                 // after each step of the machine; m->result has the results
#ifndef SMC_MONITOR_H
#define SMC_MONITOR_H

#include "compiler/script/ref.h"
#include "compiler/sema/requirements.h"

// What one step has decided about a requirement.
typedef enum MonitorResult {
    MONITOR_IDLE,             // the step could not violate the requirement, or whether it does is still undecided
    MONITOR_JUDGED,           // the step could have violated the requirement, and did not
    MONITOR_VIOLATED
} MonitorResult;

typedef struct Monitor {
    const Requirements *what; // the requirements that are judged
    size_t first, end;        // the requirements with the indices from `first` to end - 1 are judged
    uint64_t step;            // by how much G advances, at least, to the next step; a caller that knows it exactly sets it before each step
    size_t size;              // size of a situation in bytes
    size_t *samples_at;       // by window: offset of its samples in a situation
    RefWindows windows;       // the windows that the conditions sample, with the values of the situation of the last step
    uint8_t *result;          // by requirement: the MonitorResult of the last step
    bool *ran;                // for an application, by machine: it stepped in this tick; set by the caller.  NULL: one machine
} Monitor;

// delta_t: by how much G advances in a step; 0: unknown, and in an application the next tick can have the same G.  With it, a `leads to` is decided
// at the last step that could have met it.
Monitor *monitor_new(Arena *arena, const Requirements *what, uint64_t delta_t);
// Makes the monitor judge one requirement only.  Its situations are then smaller; those from before the call become invalid.
void monitor_judge_only(Monitor *m, size_t requirement);
// Initialises a situation: no step has run.
void monitor_start(const Monitor *m, void *situation);
// Judges the step after which the variables of the machine have these cells.  Returns whether it violates a requirement.
bool monitor_step(Monitor *m, void *situation, const uint64_t *cell);
// Whether a requirement of the kind `leads to` is undecided.  Sets *since to G of the step with A from which its time counts; for the kind `after`,
// to G of the last step with B.
bool monitor_is_open(const Monitor *m, const void *situation, size_t requirement, uint64_t *since);

#endif
