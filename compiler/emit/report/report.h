// SPDX-License-Identifier: Apache-2.0
// The report of a machine for a design review: what it is, what it does in words, its diagram, tables and findings, what it costs,
// and how its scripts went.  Same inputs, same bytes; no time, path or host is in it.
#ifndef SMC_REPORT_H
#define SMC_REPORT_H

#include "compiler/analysis/analysis.h"
#include "compiler/analysis/cost.h"
#include "compiler/emit/report/doc.h"
#include "compiler/emit/report/graph.h"
#include "compiler/emit/report/trace.h"
#include "compiler/script/script.h"

// One script's run.
typedef struct ReportRun {
    const char *name;             // its file, without folders
    const Script *script;         // NULL: it does not compile
    ScriptResult result;          // of a script that ran
    Trace trace;
    Diags diags;                  // what is to be said of it
} ReportRun;

typedef struct Report {
    Arena *arena;
    Analysis analysis;            // its diags hold all findings, and what an @allow covers; its step is what they rely on
    bool step_given;              // that step was given to the command, else it is the delta_t of the scripts
    Cost cost, flash, eeprom; // in instructions; estimated in cycles of an ATmega328P, by where the image is
    const uint8_t *image;         // as `smc build` writes it
    size_t image_size;
    ReportRun *run;
    size_t runs;
    const char *maker;            // "smc 0.1"
} Report;

Doc *report_build(Report *r);

// ---- the sections, a file each ----

void report_overview(Report *r, Doc *d);
void report_states(Report *r, Doc *d);
void report_transitions(Report *r, Doc *d);
void report_variables(Report *r, Doc *d);
void report_findings(Report *r, Doc *d);
void report_abort(Report *r, Doc *d);
void report_cost(Report *r, Doc *d);
void report_scripts(Report *r, Doc *d);

// How many findings count, and how many an @allow covers.
typedef struct FindingCount { size_t open, allowed; } FindingCount;
FindingCount report_count_findings(const Report *r);

// What the scripts have seen of the machine.  A way leads from one state to another, by one transition or several.
typedef struct Coverage {
    size_t states_seen, states, ways_seen, ways;
    size_t ways_shared;           // seen, and by which of several transitions is not known
} Coverage;
Coverage report_coverage(const Report *r);
GraphCounts report_counts(const Report *r);   // how often the scripts were where, all together

// ---- plots (plot.c) ----

// The states of a run over time, and below each other the series that change.  Uses the patterns of plot_patterns.
const char *plot_run(Arena *arena, const Trace *t);
const char *plot_patterns(Arena *arena);      // an invisible drawing that plots refer to; once in a page

// ---- things that several need ----

bool report_is_low(GraphSize s);              // a diagram of this size can be read in a part of a page of paper
uint32_t report_line(Span span);              // of the source; 0: nowhere
bool report_fits_uno(const Report *r);                            // as far as its windows tell
const char *report_cycles(const Report *r, uint32_t cycles);      // with the time that they take on an Uno
const char *report_number(Arena *arena, double x);
const char *report_cell(Arena *arena, SmType type, uint64_t cell);
const char *report_file_name(const char *path);

#endif
