// SPDX-License-Identifier: Apache-2.0
// The reference semantics of numbers, expressions and windows: a second implementation with the host's doubles, as plain as
// possible.  It shares no arithmetic, conversion or window code with the rest, so that a differential test against it is
// meaningful.  The script engine also evaluates guards, inputs and asserts with it (language.md 8).
#ifndef SMC_REF_H
#define SMC_REF_H

#include <stdbool.h>
#include <stdint.h>

#include "compiler/sema/program.h"

// ---- ref_number.c: language.md 2 and the pure builtins of 3 ----

double ref_read(SmType type, uint64_t cell);          // the value of a cell as an F64; a stored NaN reads as 0
uint64_t ref_convert(SmType type, double x);          // returns the cell of a variable of `type` in which x has been stored
bool ref_true(double x);                              // whether a condition with this value is true: not zero and not NaN
bool ref_negative(double x);                          // whether x is below zero or -0; false for NaN
double ref_pure(SmBuiltin fn, const double *arg);     // the result of a builtin that depends on its arguments alone, except those of ref_list:
double ref_list(SmBuiltin fn, double *x, uint32_t n); // returns min, max, median or average of n numbers; overwrites x

// The elementary functions (ref_elementary.c).
double ref_exp(double x);
double ref_log(double x);
double ref_log10(double x);
double ref_pow(double x, double y);
double ref_sin(double x);
double ref_cos(double x);
double ref_tan(double x);
double ref_asin(double x);
double ref_acos(double x);
double ref_atan(double x);
double ref_atan2(double y, double x);
double ref_hypot(double x, double y);

// ---- ref_window.c: language.md 7 ----

// A rolling window: the samples of an expression in the last steps.
typedef struct RefWindow {
    const Window *what;       // the definition of the window in the program
    double *slot;             // the last samples, `what->size` of them, as a ring buffer; NULL: the window stores times
    uint64_t *time;           // for a window of times: a ring buffer of what->size times; for a window of `held`: when the run of true samples began
    uint64_t last;            // for a window of `held`: G of the last sample
    bool ran;                 // for a window of `held`: a sample has been taken
    bool is_unused;           // nothing reads the window, so no samples are stored
    uint32_t next;            // index in `slot` or `time` at which the next sample is stored
    uint32_t filled;          // slots 0 … filled - 1 contain samples
} RefWindow;

// ---- ref_random.c: language.md 8.48 to 8.53 ----

enum { REF_DRAWS = 12 };      // random numbers of 32 bits that a call draws in each step

// The stream of random numbers of one call of random or noise.
typedef struct RefStream {
    uint64_t state;           // the generator's state after the draws of `step`
    uint64_t step;            // the last step that drew, from 1; 0: none
    double value;             // the value of the call in `step`
} RefStream;

typedef struct RefRandom {
    const ScriptRandom *call;
    RefStream *stream;        // by number of the call: its stream
    uint64_t seed;            // seed of all streams
    uint64_t step;            // number of the current step, from 1
    uint32_t first;           // added to the number of each call: the noise of faulty sensors has other streams than the script
} RefRandom;

void ref_random_init(RefRandom *r, Arena *arena, const ScriptRandoms *calls, uint64_t seed);
// Returns the value of a call in the current step, whenever it is evaluated.  Draws at the first evaluation, so a call that a step does not
// evaluate costs nothing there.
double ref_random_value(RefRandom *r, uint32_t call);

typedef struct RefWindows {
    RefWindow *at;
    size_t n;
    RefRandom *random;        // the random numbers of a script; NULL for a machine or requirements, which have none
    double *scratch;          // buffer with room for the samples of the longest window
} RefWindows;

void ref_windows_init(RefWindows *w, Arena *arena, const Windows *list);
// Like ref_windows_init, but allocates no memory for samples, and does not empty the windows.  The caller provides the memory of each window with
// ref_window_place: 8 bytes times ref_window_samples.
void ref_windows_init_unplaced(RefWindows *w, Arena *arena, const Windows *list);
uint32_t ref_window_samples(const Window *what);
void ref_window_place(RefWindow *w, void *samples);
void ref_windows_clear(RefWindows *w);                            // empties all windows, as init does
// The average, added in pairs, and the median of n numbers without NaN, also outside windows.  Both overwrite x.
double ref_average(double *x, uint32_t n);
double ref_median(double *x, uint32_t n);
void ref_windows_sample(RefWindows *w, const uint64_t *cell);     // stores a sample in every window, in index order
double ref_statistic(const RefWindows *w, uint32_t window, SmStat stat);

// ---- ref_eval.c: language.md 3 ----

// Evaluates e with cell[i] as the cell of variable i.  w: the rolling windows of the machine or script that e belongs to.
double ref_eval(const Expr *e, const uint64_t *cell, const RefWindows *w);

#endif
