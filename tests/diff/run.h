// SPDX-License-Identifier: Apache-2.0
// Runs one generated program on several engines in lock step and compares every cell, every stored flag, the status and
// the next state after every step.
#ifndef SM_DIFF_RUN_H
#define SM_DIFF_RUN_H

#include "tests/diff/gen.h"

typedef enum Verdict {
    VERDICT_SAME,
    VERDICT_REJECTED,         // the compiler refused a valid program
    VERDICT_DIFFERENT
} Verdict;

typedef struct Met {          // what a program met, as flags to be counted
    bool transition, saturation, nan, infinity, full_window, refusal, store;
    uint32_t refused;         // steps
} Met;

typedef struct RunOptions {
    int opt_level;            // of the image
    bool vm;                  // run the VM
    bool change;              // compare with a changed program, too
    bool inits;               // work the initial values out a second time, when running
    GChange what;
    const char *cc;           // NULL, or a C compiler's command: the emitted C is run instead of the VM …
    const char *folder;       // … and this is where its files go
} RunOptions;

typedef struct RunResult {
    Verdict verdict;
    const char *message;      // in the arena given
    uint32_t step;            // where they differ
    Met met;
} RunResult;

// What seed decides: level and change.
RunOptions run_options_of(uint64_t seed);

RunResult run_case(Gen *g, const RunOptions *o, Arena *arena);

// The program and its inputs as files in a folder that exists.
void run_write_files(Gen *g, const RunOptions *o, const RunResult *r, const char *folder);

#endif
