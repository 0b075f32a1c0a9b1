// SPDX-License-Identifier: Apache-2.0
// Runs one generated program on several engines in lock step and compares every cell, every stored flag, the status and
// the next state after every step.
#ifndef SM_DIFF_RUN_H
#define SM_DIFF_RUN_H

#include "tests/diff/gen.h"
#include "tests/diff/subject.h"

typedef enum Verdict {
    VERDICT_SAME,
    VERDICT_REJECTED,         // the compiler refused a valid program
    VERDICT_DIFFERENT,
    VERDICT_TOO_LARGE         // all of a batch together, for the chip that its C is for
} Verdict;

typedef struct Met {          // what a program met, as flags to be counted
    bool transition, saturation, nan, infinity, full_window, refusal, store;
    bool impossible, finding; // run_sound: facts exclude a result of a guard; a finding reports dead code
    bool no_room;             // a target has too little for it
    uint32_t refused;         // steps
} Met;

// The forms in which the optimiser hands a program on.
typedef enum Form {
    FORM_O0, FORM_O1, FORM_O2,
    FORM_HIDDEN,              // -O2 of a machine with hidden locals: elements, states and statuses are compared
    FORM_COUNT
} Form;
extern const char *const form_name[FORM_COUNT];

typedef struct RunOptions {
    unsigned forms;           // 1u << Form of each that is run; every one is compared with the reference
    Form change_form;         // in which the changed program is run
    bool change;              // compare with a changed program, too
    bool cover;               // compare the coverage with its definition (cover_model.h)
    bool sound;               // compare it with the results of the analyses, instead of comparing engines (sound.h)
    bool inits;               // work the initial values out a second time, when running
    GChange what;
    const struct Via *via;    // NULL, or what runs it instead of the engines here (batch.h) …
    const char *folder;       // … and this is where its files go
} RunOptions;

typedef struct RunResult {
    Verdict verdict;
    const char *message;      // in the arena given
    uint32_t step;            // where they differ
    Met met;
} RunResult;

// All forms; and what the seed decides: change.
RunOptions run_options_of(uint64_t seed);

// The machine of a compiled program in some form; NULL if there is none.
IrMachine *run_machine(Subject *s, const Program *p, Form form);
// The program as who runs a form of it knows it: locals that it may not have are constants to him.
const Program *run_known_program(Subject *s, Form form);
// Whether a local of a machine cannot be compared in this form.
bool run_is_unknown(const Var *v, Form form);

RunResult run_case(Gen *g, const RunOptions *o, Arena *arena);

// The program and its inputs as files in a folder that exists.
void run_write_files(Gen *g, const RunOptions *o, const RunResult *r, const char *folder);

#endif
