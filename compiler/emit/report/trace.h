// SPDX-License-Identifier: Apache-2.0
// What a run of a script left behind, in memory that does not grow with the run: for plots.  Steps are gathered in buckets, at
// first of one step each; when there are too many, neighbours are joined.
#ifndef SMC_REPORT_TRACE_H
#define SMC_REPORT_TRACE_H

#include "compiler/analysis/transitions.h"
#include "compiler/base/vec.h"
#include "compiler/script/engine.h"

enum { TRACE_BUCKETS = 1024, TRACE_VISITS_MAX = 4000 };

typedef struct TraceBucket { double first, lo, hi, last; } TraceBucket;

typedef struct TraceSeries {
    const Var *v;
    bool changes;                 // it had more than one value
    bool infinite;                // it was beyond all numbers at least once
    bool nan;                     // it was none, of a log: where a bucket is
    TraceBucket at[TRACE_BUCKETS];
} TraceSeries;

typedef struct TraceVisit {       // of a state, from its first step on
    const State *state;
    uint64_t step, g;             // steps counted from 0
    double place;                 // on the time axis, in steps: where a plot draws its beginning
} TraceVisit;

typedef struct Trace {
    Arena *arena;
    const Program *p;
    uint64_t steps;
    uint64_t per;                 // steps in a bucket
    uint64_t first_g, last_g;
    double unit;                  // of the time axis that 1 in G is; 0: 1
    const char *axis;             // what the axis is called; NULL: G and its comment
    uint32_t last;                // number of the state of the last step
    VEC(TraceSeries *) series;    // elements but G and S, then locals that are no constants
    VEC(TraceVisit) visit;
    uint64_t visits;              // those that are not in the list any more included
    uint64_t *entered;            // by state, from 0: how often it began
    uint64_t *spent;              // by state: steps
    const Transitions *transition;
    size_t *first;                // by state, from 0: its first transition
    uint64_t *taken;              // by transition: how often one from its state to its target was made, at the first that does it
} Trace;

// t: of the machine, from its analysis; its states have the numbers of p's.
void trace_init(Trace *t, Arena *arena, const Program *p, const Transitions *transition);
// An engine that does what `inner` does and notes every step in t.
Engine *trace_engine(Trace *t, Engine *inner);

size_t trace_buckets(const Trace *t);                 // that are in use
double trace_number(SmType type, uint64_t cell);

#endif
