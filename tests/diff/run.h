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
    VERDICT_TOO_LARGE         // the programs of a batch are together too large for the chip for which their C is compiled
} Verdict;

typedef struct Met {          // what occurred while a program ran, as flags to be counted
    bool transition, saturation, nan, infinity, full_window, refusal, store;
    bool impossible, finding; // run_sound: facts exclude a result of a guard; a finding reports dead code
    bool no_room;             // a target has too little memory for the program
    uint32_t refused;         // number of refused steps
} Met;

// The forms of a program that the optimiser produces.
typedef enum Form {
    FORM_O0, FORM_O1, FORM_O2,
    FORM_HIDDEN,              // -O2 of a machine with hidden locals: elements, states and statuses are compared
    FORM_COUNT
} Form;
extern const char *const form_name[FORM_COUNT];

typedef struct RunOptions {
    unsigned forms;           // 1u << Form of each form that is run; each is compared with the reference
    Form change_form;         // the form in which the changed program runs
    bool change;              // compare the program with a changed program, too
    bool cover;               // compare the coverage with its definition (cover_model.h)
    bool sound;               // compare the program with the results of the analyses (sound.h), instead of comparing engines
    bool inits;               // compute the initial values again at run time, and compare them
    GChange what;
    const struct Via *via;    // what runs the program instead of the engines in this process (batch.h); NULL: these engines
    const char *folder;       // with `via`: the folder for its files
} RunOptions;

typedef struct RunResult {
    Verdict verdict;
    const char *message;      // allocated in the arena of the caller
    uint32_t step;            // the step at which the results differ
    Met met;
} RunResult;

// Returns options with all forms, and the change that the seed selects.
RunOptions run_options_of(uint64_t seed);

// Returns the machine of a compiled program in a form; NULL if the form has no machine.
IrMachine *run_machine(Subject *s, const Program *p, Form form);
// Returns the program as an engine of a form sees it: locals that the form may have removed are constants.
const Program *run_known_program(Subject *s, Form form);
// Whether a local of a machine cannot be compared in this form.
bool run_is_unknown(const Var *v, Form form);

RunResult run_case(Gen *g, const RunOptions *o, Arena *arena);

// Writes the program and its inputs as files to a folder that exists.
void run_write_files(Gen *g, const RunOptions *o, const RunResult *r, const char *folder);

#endif
