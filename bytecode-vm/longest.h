// SPDX-License-Identifier: Apache-2.0
// The longest path through a function, computed during the verifier's pass.  A path costs 1 for each instruction.  LongestPath stores the
// cost of the longest path to the next instruction and to each pending jump target.  Jumps only lead forward, so all jumps to a target
// have been seen when the pass arrives there.  Internal to verify.c; compiles to nothing if SMVM_LONGEST is 0.
#ifndef SMVM_LONGEST_H
#define SMVM_LONGEST_H

#include <string.h>

#include "bytecode-vm/image.h"

typedef enum SmvmFunctionKind { SMVM_SAMPLE_FUNCTION, SMVM_ENTRY_FUNCTION, SMVM_STEP_FUNCTION, SMVM_EXIT_FUNCTION } SmvmFunctionKind;

#if SMVM_LONGEST
static inline uint32_t longest_max(uint32_t a, uint32_t b) { return a > b ? a : b; }

typedef struct LongestPath {
    struct { uint32_t at, cost; } pending[SMVM_JOINS];  // targets of jumps so far: offset, cost of the longest path there; the nearest is last
    uint8_t pending_count;
    bool is_reachable;        // the next instruction is reachable
    bool is_summing;          // true: `pending` was too small for all targets, so `cost` is the sum over every instruction, an upper bound
    uint32_t cost;            // cost of the longest path to the next instruction
    uint32_t end_cost, goto_cost;  // cost of the function's longest path that ends with `end`, and with `goto`; 0: no such path
    uint32_t sample_cost;     // cost of the sample function
    uint32_t state_goto_cost, state_end_cost;         // cost of the longest paths through the state's functions so far: with a goto; without
    uint32_t max_state_cost;  // cost of the longest step of all states so far
} LongestPath;

static inline void longest_begin(LongestPath *w)      // called at the start of each function
{
    w->pending_count = 0;
    w->is_reachable = true;
    w->is_summing = false;
    w->cost = w->end_cost = w->goto_cost = 0;
}

static inline void longest_at_instruction(LongestPath *w, uint32_t at)          // called before each instruction; `at`: the instruction's offset
{
    while (w->pending_count > 0 && w->pending[w->pending_count - 1].at == at) {
        w->pending_count--;
        w->cost = longest_max(w->is_reachable ? w->cost : 0, w->pending[w->pending_count].cost);
        w->is_reachable = true;
    }
    if (w->is_reachable)
        w->cost++;
}

// From here on, adds up every instruction instead of following paths: an upper bound of the longest path.
static inline void longest_begin_summing(LongestPath *w)
{
    for (uint8_t i = 0; i < w->pending_count; i++)
        w->cost = longest_max(w->cost, w->pending[i].cost);
    w->pending_count = 0;
    w->is_reachable = w->is_summing = true;
}

// Adds a jump from the current path to offset `at`.  If the jump is unconditional, the caller then ends the current path.
static inline void longest_jump(LongestPath *w, uint32_t at)
{
    uint8_t i = w->pending_count;

    if (!w->is_reachable || w->is_summing)
        return;
    while (i > 0 && w->pending[i - 1].at < at)
        i--;
    if (i > 0 && w->pending[i - 1].at == at) {
        w->pending[i - 1].cost = longest_max(w->pending[i - 1].cost, w->cost);
    } else if (w->pending_count == SMVM_JOINS) {
        longest_begin_summing(w);
    } else {
        memmove(&w->pending[i + 1], &w->pending[i], (size_t)(w->pending_count - i) * sizeof w->pending[0]);
        w->pending[i].at = at;
        w->pending[i].cost = w->cost;
        w->pending_count++;
    }
}

// Called after an instruction, with opcode op, that never continues with the next one.
static inline void longest_after_terminator(LongestPath *w, uint8_t op)
{
    if (w->is_reachable && op == SMVM_end)
        w->end_cost = longest_max(w->end_cost, w->cost);
    if (w->is_reachable && op == SMVM_goto)
        w->goto_cost = longest_max(w->goto_cost, w->cost);
    w->is_reachable = w->is_summing;
}

// Called at the end of each function.  A step runs the sample function; then entry in the first step of a state; then step, unless entry
// had a transition; then exit, if there was a transition.
static inline void longest_end(LongestPath *w, SmvmFunctionKind in)
{
    switch (in) {
    case SMVM_SAMPLE_FUNCTION: w->sample_cost = w->end_cost; break;
    case SMVM_ENTRY_FUNCTION:
        w->state_goto_cost = w->goto_cost;
        w->state_end_cost = w->end_cost;
        break;
    case SMVM_STEP_FUNCTION:
        if (w->goto_cost != 0)
            w->state_goto_cost = longest_max(w->state_goto_cost, w->state_end_cost + w->goto_cost);
        w->state_end_cost += w->end_cost;
        break;
    case SMVM_EXIT_FUNCTION:
        if (w->state_goto_cost != 0)
            w->max_state_cost = longest_max(w->max_state_cost, w->state_goto_cost + w->end_cost);
        w->max_state_cost = longest_max(w->max_state_cost, w->state_end_cost);
        break;
    }
}

static inline uint32_t longest_step(const LongestPath *w) { return w->sample_cost + w->max_state_cost; }
#else
typedef struct LongestPath { char nothing; } LongestPath;
static inline void longest_begin(LongestPath *w) { (void)w; }
static inline void longest_at_instruction(LongestPath *w, uint32_t at) { (void)w; (void)at; }
static inline void longest_jump(LongestPath *w, uint32_t at) { (void)w; (void)at; }
static inline void longest_after_terminator(LongestPath *w, uint8_t op) { (void)w; (void)op; }
static inline void longest_end(LongestPath *w, SmvmFunctionKind in) { (void)w; (void)in; }
static inline uint32_t longest_step(const LongestPath *w) { (void)w; return 0; }
#endif

#endif
