// SPDX-License-Identifier: Apache-2.0
// The longest path through a function, in instructions, computed during the verifier's pass.  It tracks the cost of reaching the next
// instruction and of reaching each pending jump target.  Jumps only lead forward, so all jumps to a target have been seen when the pass
// arrives there.  Internal to verify.c; compiles to nothing if SMVM_LONGEST is 0.
#ifndef SMVM_LONGEST_H
#define SMVM_LONGEST_H

#include <string.h>

#include "bytecode-vm/image.h"

typedef enum SmvmIn { SMVM_IN_SAMPLE, SMVM_IN_ENTRY, SMVM_IN_STEP, SMVM_IN_EXIT } SmvmIn;      // the kind of a function

#if SMVM_LONGEST
static inline uint32_t longest_of(uint32_t a, uint32_t b) { return a > b ? a : b; }

typedef struct Longest {
    struct { uint32_t at, cost; } join[SMVM_JOINS];   // pending targets; the nearest is last
    uint8_t joins;
    bool live;                // the next instruction is reachable
    bool sum;                 // too many targets: adds up every instruction
    uint32_t cost;            // of the longest path to the next instruction
    uint32_t ends, leaves;    // the longest path that ends with `end`, with `goto`; 0: none does
    uint32_t sample, left, ended, most;   // the sample function; the state's paths so far, with and without goto; the largest of all states
} Longest;

static inline void longest_begin(Longest *w)          // at the start of a function
{
    w->joins = 0;
    w->live = true;
    w->sum = false;
    w->cost = w->ends = w->leaves = 0;
}

static inline void longest_arrive(Longest *w, uint32_t at)                      // at the start of an instruction
{
    while (w->joins > 0 && w->join[w->joins - 1].at == at) {
        w->joins--;
        w->cost = longest_of(w->live ? w->cost : 0, w->join[w->joins].cost);
        w->live = true;
    }
    if (w->live)
        w->cost++;
}

static inline void longest_add_up(Longest *w)                               // from here on
{
    for (uint8_t i = 0; i < w->joins; i++)
        w->cost = longest_of(w->cost, w->join[i].cost);
    w->joins = 0;
    w->live = w->sum = true;
}

static inline void longest_jump(Longest *w, uint32_t at)
{
    uint8_t i = w->joins;

    if (!w->live || w->sum)
        return;
    while (i > 0 && w->join[i - 1].at < at)
        i--;
    if (i > 0 && w->join[i - 1].at == at) {
        w->join[i - 1].cost = longest_of(w->join[i - 1].cost, w->cost);
    } else if (w->joins == SMVM_JOINS) {
        longest_add_up(w);
    } else {
        memmove(&w->join[i + 1], &w->join[i], (size_t)(w->joins - i) * sizeof w->join[0]);
        w->join[i].at = at;
        w->join[i].cost = w->cost;
        w->joins++;
    }
}

static inline void longest_leave(Longest *w, uint8_t op)                        // control does not continue with the next instruction
{
    if (w->live && op == SMVM_end)
        w->ends = longest_of(w->ends, w->cost);
    if (w->live && op == SMVM_goto)
        w->leaves = longest_of(w->leaves, w->cost);
    w->live = w->sum;
}

// At the end of a function.  A step is: sample; entry if it is the state's first; step unless entry had a transition; exit after a
// transition.
static inline void longest_end(Longest *w, SmvmIn in)
{
    switch (in) {
    case SMVM_IN_SAMPLE: w->sample = w->ends; break;
    case SMVM_IN_ENTRY:
        w->left = w->leaves;
        w->ended = w->ends;
        break;
    case SMVM_IN_STEP:
        if (w->leaves != 0)
            w->left = longest_of(w->left, w->ended + w->leaves);
        w->ended += w->ends;
        break;
    case SMVM_IN_EXIT: w->most = longest_of(w->most, longest_of(w->ended, w->left == 0 ? 0 : w->left + w->ends)); break;
    }
}

static inline uint32_t longest_step(const Longest *w) { return w->sample + w->most; }
#else
typedef struct Longest { char nothing; } Longest;
static inline void longest_begin(Longest *w) { (void)w; }
static inline void longest_arrive(Longest *w, uint32_t at) { (void)w; (void)at; }
static inline void longest_jump(Longest *w, uint32_t at) { (void)w; (void)at; }
static inline void longest_leave(Longest *w, uint8_t op) { (void)w; (void)op; }
static inline void longest_end(Longest *w, SmvmIn in) { (void)w; (void)in; }
static inline uint32_t longest_step(const Longest *w) { (void)w; return 0; }
#endif

#endif
