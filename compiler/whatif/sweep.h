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
    double *value;            // the n values that are tried, as the parameter stores them, ascending; equal ones are dropped, which reduces n
    double current;           // the parameter's value outside the sweep, where no script sets it
} SweepAxis;

// Something that can fail at a point: an assert, a requirement, or a whole script.
typedef struct SweepCheck {
    uint32_t script;                  // index of the script with the assert, or that does not end; unused for a requirement
    const ScriptAssert *assert;       // the assert; NULL: the check is no assert
    uint32_t assert_number;           // number of the assert in the order of the script
    const Requirement *requirement;   // NULL: the check is no requirement.  Both NULL: the script does not end, or an @compare is not met
} SweepCheck;

// Values of the parameters, and what fails there.
typedef struct SweepPoint {
    double value[SWEEP_AXES];
    uint8_t *fails;           // by index in Sweep.check: 1 if it fails
    uint32_t failing;         // number of checks that fail
} SweepPoint;

// Points along one axis, for the scripts that do not set its parameter themselves, with the other parameter at its current value.
// The current value of the axis's own parameter is among them if it is from lo to hi.
typedef struct SweepLine {
    VEC(SweepPoint) at;
    uint32_t current;         // index of the parameter's current value; UINT32_MAX: it is not among the points
} SweepLine;

// Two values of a parameter between which a check begins to fail.
typedef struct SweepBoundary {
    uint32_t axis, check;     // indices in Sweep.axis and Sweep.check
    double passes, fails;     // the value at which the check passes, and the one at which it fails
} SweepBoundary;

typedef struct SweepOptions {
    SweepAxis axis[SWEEP_AXES];       // the axes; `value` and `current` are not set
    uint32_t axes;
    uint64_t max_steps;
    const uint64_t *seed;             // seed of the random numbers; NULL: each script's own seed
    const Requirements *requirements; // judged in each run; or NULL
    const uint8_t *const *ignored;    // by script: ScriptOptions.ignored; or NULL
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
    VEC(SweepPoint) point;            // with two axes: the map, at index (index on axis 0) * axis[1].n + (index on axis 1); with one: empty
    SweepLine line[SWEEP_AXES];       // by axis: the points on the axis
    VEC(SweepBoundary) boundary;
    uint64_t runs;                    // number of runs of scripts so far
    SweepRunner *runner;
} Sweep;

Sweep *sweep_new(Arena *arena, const Program *p, const Script *const *script, uint32_t scripts, const SweepOptions *o);
// Runs all scripts at the next point, or one boundary.  Returns false if no point or boundary is left.
bool sweep_run_next(Sweep *s);
// Finds the value nearest to the current one at which something fails, below (`above` false) or above it.  Returns false if nothing fails there, or
// if the current value is outside the axis or fails itself.
bool sweep_find_margin(const Sweep *s, uint32_t axis, bool above, double *fails);
bool sweep_takes_part(const Sweep *s, uint32_t axis, uint32_t script);       // false: the script sets the parameter itself, so its runs do not change
bool sweep_is_alone(const Sweep *s, uint32_t axis);        // no script takes part
bool sweep_fails_now(const Sweep *s, uint32_t axis);       // whether something fails at the current value
bool sweep_is_noticed(const Sweep *s, uint32_t axis);      // whether something fails at any value along the axis
// Returns what fails at a value that sweep_find_margin has found: a requirement if one does.
uint32_t sweep_find_limit(const Sweep *s, uint32_t axis, double fails);
void sweep_end(Sweep *s);

// Appends the name of a check: "R3", "tank.ss:12", "tank.ss does not end".
void sweep_write_check(const Sweep *s, uint32_t check, Buf *out);

// Appends a value of the parameter, with the fewest digits that are this value of its type.
void sweep_write_value(const SweepAxis *a, double x, Buf *out);
// Appends the checks that fail at a point.
void sweep_write_failing(const Sweep *s, const SweepPoint *p, const char *separator, Buf *out);
// Appends what is below (`above` false) or above the current value: "fails at 20.1 (10.1 away, requirement R1)", "nothing fails up to 41".  Of a bool
// only its other value has such a text.
void sweep_write_side(const Sweep *s, uint32_t axis, bool above, Buf *out);
// Returns the last point of the line in a row at which the same checks fail as at the point `first`.
uint32_t sweep_find_last_alike(const Sweep *s, uint32_t axis, uint32_t first);

// ---- sweep_svg.c ----

// Appends a plot as SVG: of one parameter the intervals in which each check fails, of two the map of their values.
void sweep_write_svg(Arena *arena, const Sweep *s, Buf *out);

#endif
