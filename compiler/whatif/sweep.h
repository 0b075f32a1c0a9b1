// SPDX-License-Identifier: Apache-2.0
// Parameters at many values: which asserts and requirements fail where, and how far the current setting is from there (docs/faults.md).
//
//     Sweep *s = sweep_new(arena, p, script, scripts, &options);
//     while (sweep_run_next(s)) ;
//     ... s->point, s->line, s->boundary ...
//     sweep_end(s);
#ifndef SMC_SWEEP_H
#define SMC_SWEEP_H

#include "compiler/script/script.h"

enum { SWEEP_AXES = 2, SWEEP_POINTS_MOST = 10000 };

typedef struct SweepAxis {
    const Var *parameter;
    double lo, hi;            // lo < hi, both are values of the parameter
    uint32_t n;               // number of points; at least 2
    double *value;            // of the points, as the parameter stores them, ascending and all different: `n` is reduced to their number
    double current;           // the value without the sweep
} SweepAxis;

// What can fail.
typedef struct SweepCheck {
    uint32_t script;                  // of an assert, or of a script that does not end
    const ScriptAssert *assert;       // NULL: not an assert
    uint32_t assert_number;
    const Requirement *requirement;   // NULL: not a requirement; with neither: the script does not end, or its @compare is not met
} SweepCheck;

// Values of the parameters, and what fails there.
typedef struct SweepPoint {
    double value[SWEEP_AXES];
    uint8_t *fails;           // by check
    uint32_t failing;         // number of checks that fail
} SweepPoint;

// Points along one axis, with the other parameter at its current value.  The current value is one of them if it is between the ends.
typedef struct SweepLine {
    VEC(SweepPoint) at;
    uint32_t current;         // index of the parameter's current value; UINT32_MAX: it is not among the points
} SweepLine;

// Two values of a parameter between which a check begins to fail.
typedef struct SweepBoundary {
    uint32_t axis, check;
    double passes, fails;
} SweepBoundary;

typedef struct SweepOptions {
    SweepAxis axis[SWEEP_AXES];       // without `value` and `current`
    uint32_t axes;
    uint64_t max_steps;
    const uint64_t *seed;             // NULL: that of each script
    const Requirements *requirements; // or NULL
    const ScriptSetting *setting;     // values of parameters that are not swept; `settings` of them
    size_t settings;
} SweepOptions;

typedef struct SweepRunner SweepRunner;

typedef struct Sweep {
    const Program *p;
    const Script *const *script;
    uint32_t scripts;
    SweepOptions options;
    SweepAxis axis[SWEEP_AXES];
    VEC(SweepCheck) check;
    VEC(SweepPoint) point;            // of two parameters: by index of the first, then of the second; of one: none
    SweepLine line[SWEEP_AXES];
    VEC(SweepBoundary) boundary;
    uint64_t runs;                    // of scripts
    SweepRunner *runner;
} Sweep;

Sweep *sweep_new(Arena *arena, const Program *p, const Script *const *script, uint32_t scripts, const SweepOptions *o);
// Runs all scripts at the next point, or one boundary.  Returns false if no point or boundary is left.
bool sweep_run_next(Sweep *s);
// Finds the value nearest to the current one at which something fails, below (`above` false) or above it.  Returns false if nothing fails there, or
// if the current value is outside or fails itself.
bool sweep_find_margin(const Sweep *s, uint32_t axis, bool above, double *fails);
bool sweep_fails_now(const Sweep *s, uint32_t axis);
void sweep_end(Sweep *s);

// Appends the name of a check: "R3", "tank.ss:12", "tank.ss does not end".
void sweep_write_check(const Sweep *s, uint32_t check, Buf *out);

// Appends the checks that fail at a point.
void sweep_write_failing(const Sweep *s, const SweepPoint *p, const char *separator, Buf *out);
// Appends what is below (`above` false) or above the current value: "fails at 20.1 (10.1 away)", "nothing fails up to 41".
void sweep_write_side(const Sweep *s, uint32_t axis, bool above, Buf *out);
// Returns the last point of the line in a row at which the same checks fail as at the point `first`.
uint32_t sweep_find_last_alike(const Sweep *s, uint32_t axis, uint32_t first);

// ---- sweep_svg.c ----

// Appends a plot as SVG: of one parameter the intervals in which each check fails, of two the map of their values.
void sweep_write_svg(Arena *arena, const Sweep *s, Buf *out);

#endif
