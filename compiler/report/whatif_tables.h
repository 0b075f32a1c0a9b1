// SPDX-License-Identifier: Apache-2.0
// What faulty sensors and other values of parameters do, as tables for the page.  `smc report` (compiler/cli) makes the runs and fills the tables;
// this folder only writes them.  Texts are plain (doc.h).
#ifndef SMC_REPORT_WHATIF_TABLES_H
#define SMC_REPORT_WHATIF_TABLES_H

#include <stdbool.h>
#include <stdint.h>

#include "compiler/base/vec.h"

// ---- faults ----

typedef enum ReportDanger { REPORT_HARMLESS, REPORT_OPEN, REPORT_VIOLATION } ReportDanger;

typedef struct ReportOutcome {
    const char *name;         // one word: "violated"
    const char *words;        // "a requirement is violated"
    ReportDanger danger;
} ReportOutcome;

typedef struct ReportFaultKind { const char *name, *sentence; } ReportFaultKind;

// The most dangerous outcome of one input and one kind of fault.
typedef struct ReportFaultCell {
    bool applies;             // the input can have the fault
    uint32_t outcome;         // index in ReportFaults.outcome
    uint32_t line;            // number, from 1, of the line in the list that explains it; 0: the fault has no effect
    const char *effect;       // the outcome in a few words, as fault_write_worst writes it: "R3 +1"; "": no effect
} ReportFaultCell;

// A line of the list: all faults of the same inputs and kinds with the same outcome.
typedef struct ReportFaultLine {
    bool is_pair;             // two faults at once
    uint32_t outcome;
    const char *fault;        // "altitude dead"
    const char *trigger;      // when the fault begins, as in "at Boost -> Coast (G = 1200, chute.ss)": the first such time with this outcome
    const char *effect;
    uint32_t others;          // how many other times at which the fault begins have the same outcome
    const char *script;       // name of the file that reproduces the fault; NULL: none
} ReportFaultLine;

// The faults with which this requirement is the first one that is violated.
typedef struct ReportFaultsOf {
    unsigned long faults;
    uint32_t line;            // number of the first line with such a fault; 0: none
} ReportFaultsOf;

typedef struct ReportFaults {
    const char *not_run;      // why no fault was tried, as a phrase; the other fields are then empty.  NULL: faults were tried
    const char *summary;      // a sentence that says how many runs, faults and effects there were
    const ReportOutcome *outcome;     // all outcomes, the least dangerous first; outcome[0] is "no effect"
    uint32_t outcomes;
    VEC(ReportFaultKind) kind;
    VEC(const char *) input;
    VEC(ReportFaultCell) cell;        // by input, then by kind
    VEC(ReportFaultLine) line;        // in the order of the list
    VEC(ReportFaultsOf) of;   // by requirement
    VEC(const char *) note;   // sentences
    bool has_scripts;         // scripts were written
    bool is_cut;              // not all faults were tried
} ReportFaults;

// ---- sweeps ----

// Neighbouring values of a parameter with the same result.
typedef struct ReportSweepSpan {
    const char *from, *to;
    const char *fails;        // the checks that fail, between commas; "": none
} ReportSweepSpan;

typedef struct ReportSweepBoundary { const char *check, *meaning, *passes, *fails; } ReportSweepBoundary;

typedef struct ReportSweepOf {
    const char *parameter, *now, *from, *to;
    const char *below, *above;        // "fails at 20.1 (10.1 away, requirement R1)", "nothing fails up to 100"
    const char *left_out;     // the scripts that set the parameter themselves and so keep their value, between commas; "": none
    bool has_scripts;         // other scripts were run; if not, the following fields are empty
    bool fails_now, has_margin;       // has_margin: something fails below or above the current value
    bool is_requirement;      // with has_margin: a requirement is violated at the nearest such value below or above
    VEC(ReportSweepSpan) span;
    VEC(ReportSweepBoundary) boundary;
    const char *svg;
} ReportSweepOf;

typedef struct ReportSweep {
    const char *not_run;      // why the sweep did not run, as ReportFaults.not_run
    VEC(ReportSweepOf) of;    // by parameter
    VEC(const char *) not_swept;      // the parameters that were not swept to the end, because the part was stopped before
} ReportSweep;

#endif
