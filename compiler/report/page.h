// SPDX-License-Identifier: Apache-2.0
// The report of a machine for a design review: an overview, what the machine does in words, its diagram, tables, findings, costs, and the
// results of its scripts.  The same inputs produce the same bytes; it contains no time, path or host name.
#ifndef SMC_REPORT_PAGE_H
#define SMC_REPORT_PAGE_H

#include "compiler/analysis/analysis.h"
#include "compiler/budget/cost.h"
#include "compiler/cover/cover.h"
#include "compiler/cover/mutate.h"
#include "compiler/prove/prove.h"
#include "compiler/report/diagram.h"
#include "compiler/report/doc.h"
#include "compiler/report/trace.h"
#include "compiler/report/whatif_tables.h"
#include "compiler/script/script.h"
#include "compiler/sema/network.h"

// One script's run.
typedef struct ReportRun {
    const char *name;             // file name of the script, without folders
    const Script *script;         // NULL: the script does not compile
    ScriptResult result;          // the result, if the script ran
    Trace trace;
    Diags diags;                  // diagnostics of the script
} ReportRun;

typedef struct Report Report;
struct Report {
    Arena *arena;
    Analysis analysis;            // analysis.diags contains all findings, including those that an @allow covers.  Of an application, only p, diags and
                                  // step are set
    Report *member;               // by Member, the machines of the application, `members` of them; NULL: the report is about one machine
    size_t members;
    const Member *of;             // the machine of an application that the report is about; NULL: a machine alone, or an application
    bool step_given;              // analysis.step is the user's --step; otherwise it is the step that the machine declares, or else the delta_t of
                                  // the scripts
    Cost cost;                    // cost of steps, in VM instructions
    Cost flash, eeprom;           // cost of steps, in estimated cycles of an ATmega328P that runs the image from flash or from EEPROM
    const uint8_t *image;         // the image that `smc build` writes
    size_t image_size;
    ReportRun *run;
    size_t runs;
    const Cover *cover;           // coverage of the scripts; NULL: not measured
    const Mutation *mutation;     // changes of the machine, tried on the scripts; NULL: none were tried
    const char *not_mutated;      // why no mutants were tried although they were requested, as a phrase; or NULL
    const ReportFaults *faults;   // effects of faulty sensors; NULL: none were tried
    const ReportSweep *sweep;     // runs with parameters at other values; NULL: none were tried
    const char *maker;            // program and version: "smc 0.1"
    const Network *net;           // the messages of the application; or NULL
    const Requirements *requirements;     // the requirements that the runs have judged; or NULL
    const ProveResult *proofs;    // verdicts on these requirements; NULL: not tried
    const struct ProveApp *proofs_of_app;         // of an application: what they are from
    VEC(const char *) left_out;   // sentences that name scripts and requirements that these three parts leave out, because they fail anyway
    VEC(const char *) unfinished; // phrases that name what was stopped before it was complete
};

Doc *report_build(Report *r);
// Builds the page of an application: its machines one after the other, what they share, and the runs of all of them.
Doc *report_build_app(Report *r);
void report_add_behaviour(Report *r, Doc *d);           // what a machine does: diagram, outputs, states, transitions, variables
void report_add_left_out(const Report *r, Doc *d);     // names what the section does not contain because it fails anyway

// ---- the sections, one file each ----

void report_add_overview(Report *r, Doc *d);
void report_add_verdicts(Report *r, Doc *d);           // part of the overview
void report_add_diagram_section(Report *r, Doc *d);
void report_add_source(Report *r, Doc *d);
void report_add_outputs(Report *r, Doc *d);            // nothing if the machine writes no element
void report_add_all_states(Report *r, Doc *d);
void report_add_states(Report *r, Doc *d);
void report_add_transitions(Report *r, Doc *d);
void report_add_variables(Report *r, Doc *d);
void report_add_messages(Report *r, Doc *d);           // nothing if r->net is NULL
void report_add_findings(Report *r, Doc *d);
void report_add_abort_matrix(Report *r, Doc *d);
void report_add_costs(Report *r, Doc *d);
void report_add_requirements(Report *r, Doc *d);       // nothing if r->requirements is NULL
void report_add_proofs(Report *r, Doc *d);             // nothing if r->proofs is NULL
void report_add_traceability(Report *r, Doc *d);       // nothing if neither a file nor a mark names a requirement
void report_add_mutation(Report *r, Doc *d);
void report_add_scripts(Report *r, Doc *d);
void report_add_faults(Report *r, Doc *d);             // nothing if r->faults is NULL
void report_add_sweep(Report *r, Doc *d);              // nothing if r->sweep is NULL

// Returns the id of a section of a report about one machine of an application.
const char *report_section_of(const Report *r, const char *id);

// Number of findings that no @allow covers, and of those that one covers.
typedef struct FindingCount { size_t open, allowed; } FindingCount;
FindingCount report_count_findings(const Report *r);

// The part of the machine that the scripts have executed, by edges of its diagram (diagram_model.h).
typedef struct Coverage {
    size_t states_covered, states;
    size_t edges_unused;          // edges that no script has taken
    bool shared;                  // without Report.cover: for some edge it is unknown which of its transitions were taken, or whether any was
    size_t transitions_least, transitions_most, transitions;      // bounds of how many transitions were taken; number of all
} Coverage;
Coverage report_measure_coverage(const Report *r);
DiagramCounts report_sum_counts(const Report *r);  // how often the scripts visited states and took transitions, summed over all scripts

// ---- plots (plot.c) ----

// Plots the states of a run over time, and below them each series that changes.  Uses the patterns of plot_patterns.
const char *plot_draw_run(Arena *arena, const Trace *t);
const char *plot_patterns(Arena *arena);      // patterns that plots refer to, as an invisible drawing; include it once in a page

// ---- shared helpers ----

const char *report_proof_tone(ProveVerdict v);         // the colour of a badge: DocPart.tone

// Adds the state diagram.  On paper it is cut into as many slices as are needed to keep its text legible.
void report_add_diagram(Report *r, Doc *d, const Diags *findings, const DiagramCounts *counts, const char *caption);
uint32_t report_line_of(Span span);           // line in the source; 0: none
const char *report_board_name(const Report *r);       // "On an Arduino Uno": the smallest board whose firmware has room for the machine
const char *report_board_time(const Report *r);       // time of the longest step on that board: "about 300 cycles, 0.02 ms, in Fill"
const char *report_format_number(Arena *arena, double x);
const char *report_format_cell(Arena *arena, SmType type, uint64_t cell);

#endif
