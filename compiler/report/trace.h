// SPDX-License-Identifier: Apache-2.0
// A recording of a script's run for plots, in memory that does not grow with the run.  Steps are collected in buckets, at first one step
// each.  When all buckets are full, neighbours are merged.
#ifndef SMC_REPORT_TRACE_H
#define SMC_REPORT_TRACE_H

#include "compiler/analysis/transitions.h"
#include "compiler/base/vec.h"
#include "compiler/script/engine.h"

enum { TRACE_BUCKETS = 1024, TRACE_VISITS_MAX = 4000 };

// The first, smallest, largest and last value of a variable in the steps of a bucket.
typedef struct TraceBucket { double first, lo, hi, last; } TraceBucket;

typedef struct TraceSeries {
    const Var *v;
    bool changes;                 // the variable had more than one value
    bool infinite;                // the variable was infinite at least once
    bool nan;                     // only in plots of flight logs: the value was NaN at least once.  A bucket of only NaN has NaN in its fields
    TraceBucket at[TRACE_BUCKETS];
} TraceSeries;

typedef struct TraceVisit {       // a visit of a state, from its first step on
    const State *state;
    uint64_t step, g;             // number of its first step, counted from 0; G in that step
    double plot_step;             // position on the time axis, in steps and fractions, where a plot draws its start
} TraceVisit;

typedef struct Trace {
    Arena *arena;
    const Program *p;
    uint64_t steps;               // steps that have been recorded
    uint64_t per;                 // steps per bucket
    uint64_t first_g, last_g;     // G in the first and in the last step
    double unit;                  // how many units of the time axis one unit of G is; 0 stands for 1
    const char *axis;             // label of the axis; NULL: G and its comment
    uint32_t last;                // State.number of the last step's state
    VEC(TraceSeries *) recorded;  // by @compare of the script: values of the data column with which the variable is compared; NaN: none
    VEC(TraceSeries *) series;    // elements except G and S, then locals that are not constants
    VEC(TraceVisit) visit;
    uint64_t visits;              // number of visits, including those no longer added to the list
    uint64_t *entered;            // by State.number - 1: number of visits
    uint64_t *spent;              // by State.number - 1: number of steps
    const Transitions *transition;
    size_t *first;                // by State.number - 1: index in `transition` of its first transition
    uint64_t *taken;              // by index in `transition`: moves from its state to its target, counted at the first such transition
} Trace;

// `transition`: the transitions of the machine, from its analysis, whose states have the same numbers as those of p.
void trace_init(Trace *t, Arena *arena, const Program *p, const Transitions *transition);
// Returns an engine that passes every call to `inner` and records every step in t.
Engine *trace_wrap_engine(Trace *t, Engine *inner);

// Adds a series for each @compare of a script.  To be called before the run; trace_add_recorded then after each step, with ScriptStep.recorded.
void trace_begin_recorded(Trace *t, const ScriptData *d);
void trace_add_recorded(Trace *t, const double *value);

size_t trace_buckets(const Trace *t);                 // number of buckets in use
double trace_cell_value(SmType type, uint64_t cell);

#endif
