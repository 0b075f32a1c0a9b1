// SPDX-License-Identifier: Apache-2.0
// Traceability between requirements, the machine and its scripts, in both directions: where a requirement is implemented and what tests it, and
// which requirements a part of the machine, a script or an assert belongs to.
//
//     Traceability *t = traceability_new(arena, program, requirements);
//     for each run: traceability_add_run(t, name, script, &result);
//     traceability_finish(t);
//
// A part of the machine belongs to the requirements that are named by its own marks, by those of the conditionals around it, and by those of its
// state or section.  A state without a mark belongs to the requirements of the marks inside it.  An id that only marks and asserts name is a
// requirement, too, without text: its asserts alone test it.
#ifndef SMC_TRACEABILITY_H
#define SMC_TRACEABILITY_H

#include "compiler/analysis/transitions.h"
#include "compiler/script/script.h"

typedef enum TracedKind { TRACED_STATE, TRACED_ALL_STATES, TRACED_TRANSITION, TRACED_OUTPUT, TRACED_KINDS } TracedKind;

extern const char *const traced_kind_name[TRACED_KINDS];       // "state", "all_states", "transition", "output"

// Where the nearest mark for a part of the machine is: on the part itself, on a conditional around it, on its state or section, or, for a state or
// section without a mark, on something inside it.
typedef enum TracedBy { TRACED_BY_NONE, TRACED_BY_ITSELF, TRACED_BY_CONDITIONAL, TRACED_BY_STATE, TRACED_BY_CONTENTS } TracedBy;

extern const char *const traced_by_name[];                      // "", "itself", "conditional", "state", "contents"

typedef VEC(uint32_t) TraceIndices;

typedef struct TracedPart {
    TracedKind kind;
    const State *state;           // the state that contains it; NULL: it is in a section [all_states]
    const Stmt *stmt;             // TRANSITION, OUTPUT: the statement
    const char *where;            // the name of the state; "all states except Abort"
    const char *name;             // "Pad", "Pad -> Coast", "Pad: drogue"
    const char *text;             // the condition of a transition, the source of an assignment; ""
    Span span;
    TraceIndices requirement;     // indices in Traceability.requirement, each once
    TracedBy by;
} TracedPart;

// A mark: a place that implements a requirement.
typedef struct TracedMark { const char *name; Span span; } TracedMark;        // "state Pad", "Pad -> Coast", "Pad: drogue = true"

typedef struct TracedScript {
    const char *name;
    ScriptOutcome outcome;
    TraceIndices requirement;     // the requirements that its steps or its asserts have tested
} TracedScript;

typedef struct TracedAssert {
    uint32_t script;              // index in Traceability.script
    ScriptAssertKind kind;        // never PRINT
    Span span;
    const char *text;             // the text after the assert, or its condition if it has none
    uint64_t evaluated;           // how often the runs evaluated the assert
    const char *result;           // "passed", "failed" or "never evaluated"
    uint32_t requirement;         // 1 + the index of its requirement; 0: none
} TracedAssert;

typedef struct TracedRun { uint32_t script; uint64_t judged; } TracedRun;     // the requirement was judged in this number of steps of the script

typedef struct TracedRequirement {
    Str id;
    const Requirement *what;      // the requirement of a .rq file; NULL: only marks or asserts name it
    VEC(TracedMark) mark;
    VEC(TracedRun) run;           // the scripts that have judged the requirement
    TraceIndices assert;          // indices in Traceability.assert
    RequirementTotal total;       // how often it was judged and violated, in all scripts
    const char *unvisited;        // the states that it names and no script came to; ""
    const char *result;           // "tested", "violated", "undecided" or "untested"
    const char *proof;            // what a proof has found; "not tried" until traceability_set_proof
} TracedRequirement;

typedef struct TraceCounts {
    uint32_t tested, violated, undecided, untested;       // requirements, by result
    uint32_t unmarked[TRACED_KINDS];                      // parts of the machine without a requirement
} TraceCounts;

typedef struct Traceability {
    Arena *arena;
    const Program *program;
    const Requirements *what;     // the requirements of the .rq files; or NULL
    VEC(TracedRequirement) requirement;       // those of the files in their order, then those that only marks or asserts name
    VEC(TracedPart) part;         // states and sections with their transitions and outputs, in file order
    VEC(TracedScript) script;
    bool *visited;                // by State.number - 1: a script came to the state
    VEC(TracedAssert) assert;     // in the order of the scripts
    TraceCounts counts;           // set by traceability_finish
    Map by_id;                    // from the id to a uint32_t: 1 + the index of the requirement
    VEC(uint32_t *) number;       // the values of by_id
} Traceability;

// `what` can be NULL: then only marks and asserts name requirements.
Traceability *traceability_new(Arena *arena, const Program *p, const Requirements *what);
// Adds the run of a script.  `name` is its file.
void traceability_add_run(Traceability *t, const char *name, const Script *s, const ScriptResult *r);
// Stores what a proof has found about a requirement of the files: "proved", "violated", "no violation found" or "vacuous".
void traceability_set_proof(Traceability *t, Str id, const char *proof);
// Computes results and counts.
void traceability_finish(Traceability *t);

// Returns "FILE:LINE".
const char *traceability_place(Arena *arena, Span span);
// Returns the ids of requirements, as in "R1; R7".
const char *traceability_ids(const Traceability *t, const TraceIndices *list);

// Append the whole as CSV and as JSON (docs/requirements.md), and the counts as a line.  In CSV a text that a spreadsheet would take for a
// formula begins with an apostrophe.
void traceability_write_csv(const Traceability *t, Buf *out);
void traceability_write_json(const Traceability *t, Buf *out);
void traceability_write_summary(const Traceability *t, Buf *out);

#endif
