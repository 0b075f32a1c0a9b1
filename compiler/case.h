// SPDX-License-Identifier: Apache-2.0
// One .smt case: its parts as the input of a compilation, and the comparison of what came out with what the case expects. Opens no file and no
// engine: the caller does (smc test).
#ifndef SMC_CASE_H
#define SMC_CASE_H

#include "compiler/compile.h"
#include "compiler/script/testfile.h"

// ---- the parts as sources ----

typedef struct CaseSources {
    Arena *arena;
    const TestFile *file;
    size_t parts;
    Source **src;             // by index of the part in file->part; NULL: the part is not a source
    size_t *input;            // by index of the part, for a source of the call: its index in in.at
    CompileInput in;
} CaseSources;

// Makes the parts the sources of a compilation. If one of them is an application, the others are the files that it names; otherwise a state
// vector beside a machine or pins is theirs.  The session finds the files that scripts include among the parts, so *out must last as long as s.
void case_list_sources(Session *s, const TestFile *f, CaseSources *out);
// Whether the case has a part whose name ends with `suffix`, such as ".app".
bool case_has_part_of_kind(const TestFile *f, const char *suffix);

// ---- the case ----

typedef struct SmtCase {
    Session *s;
    const TestFile *f;
    DiagSelection warn;       // the warnings that the header line `warn` of the case selects
    CaseSources sources;
    const Program *p;         // the machine as scripts run it; NULL: the case has no machine, or the machine has errors
    const Requirements *requirements;         // of all .rq parts together; NULL: there is no such part, or one has errors
    const Script **script;    // by index of the part; NULL: the part is not a script, or has errors
    bool has_runs;            // the case is expected to compile, has compiled, and has scripts: case_run_scripts applies
    Buf why;                  // every way in which the results differ from those expected, one or more lines each
} SmtCase;

// Whether the tests of the command (tests/golden) or of the IR (tests/ir) run the case, and smc test does not.
bool case_is_for_other_runner(const TestFile *f);
// Initialises c for f, whose text has been parsed, and reads its header `warn`. Returns what is wrong with the file, or NULL.
const char *case_init(SmtCase *c, Session *s, const TestFile *f);
void case_compile(SmtCase *c, int opt_level);
// Runs the scripts in lock step on the engines and compares outcomes, report and trace. A script that does not end is stopped after the number of
// steps in the header line `steps`, or without that line after max_steps. Returns false if an engine failed.
bool case_run_scripts(SmtCase *c, Engine **engine, size_t engines, uint64_t max_steps);
// Compares the diagnostics with those that the case announces. To be called last, because runs of scripts report diagnostics too.
void case_check_diagnostics(SmtCase *c);

// ---- case_compare.c ----

// Compare a report, and a trace, with the part that contains the expected one. Each difference becomes one or more lines of `why`.
void case_compare_report(const TestPart *expected, const Buf *report, Buf *why);
void case_compare_trace(const TestPart *expected, const Buf *trace, Buf *why);

#endif
