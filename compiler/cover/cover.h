// SPDX-License-Identifier: Apache-2.0
// Coverage: which parts of a machine its scripts have tested (docs/testing.md).  A part is a *place*: something of the source that a run
// either does or does not do, such as "this guard was false".
//
//     Cover *c = cover_new(arena, p);                   // the places of a machine
//     Engine *e = cover_open_engine(c);                 // counts while scripts run
//     cover_settle(c);                                  // after the runs: derived counts, and what is impossible
//     cover_write_text(c, &out);
//
// Places speak of the source as written.  A statement of [all_states] is one statement, whatever the number of its copies; only its
// transitions count once for each state, because leaving one state is not leaving another.
#ifndef SMC_COVER_H
#define SMC_COVER_H

#include "compiler/base/buf.h"
#include "compiler/cover/flat.h"
#include "compiler/script/engine.h"
#include "compiler/sema/program.h"

// The kinds of places.
typedef enum CoverKind {
#define KIND(constant, name, sentence) COVER_##constant,
#include "compiler/cover/cover_kinds.def"
#undef KIND
    COVER_KIND_COUNT
} CoverKind;

extern const char *const cover_kind_name[COVER_KIND_COUNT];

typedef struct CoverPlace {
    CoverKind kind;
    bool value;               // GUARD, CONDITION: the outcome; STATE: entered, not left
    Span span;                // the statement, guard or other text that the place is about, in the machine's own source
    Span where;               // the position to report: `span`, or the use of the definition that contains `span`
    const State *from, *to;   // TRANSITION: both; STATE: `from` is the state
    bool of_all_states;       // TRANSITION: the transition is in [all_states], and this place is its copy in state `from`
    uint32_t part_of;         // the place that every run covering this one covers too; while it is missing, reports name only it; 0: none
    uint32_t result;          // CONDITION: the place of the outcome that the decision has when this condition decides with `value`
    bool assigned;            // GUARD: the decision is a stored or computed value, not the guard of a conditional
    bool sampled;             // GUARD: a window samples the decision at every step; the same text in a statement is another place
    const Var *parameter;     // PARAMETER: which one
    uint64_t cell;            // PARAMETER: covered if the parameter has this value when a run begins
    const char *impossible;   // why no run can cover the place; NULL: this is not proved
} CoverPlace;

typedef VEC(CoverPlace) CoverPlaces;

typedef struct CoverTotal { uint32_t covered, possible, impossible; } CoverTotal;        // numbers of places; `possible` includes the covered ones

typedef struct CoverShared { uint32_t from, to, n; } CoverShared;        // the counts of places from … from + n - 1 are also those of to … to + n - 1

typedef struct Cover {
    Arena *arena;
    const Program *p;
    uint64_t identity;        // a hash of the sources of the machine and its state vector
    CoverPlaces place;        // at[0] is no place, so that the number 0 means none
    uint64_t *hits;           // by place: how often it was covered; for conditions and windows only whether it is 0 is exact
    const IrMachine *m;       // the IR of the machine before any pass
    IrNotes notes;            // the temporaries of `m` that have the values of conditions
    const uint32_t *entry;    // by State.number - 1: the place of the state's entry
    VEC(CoverShared) shared;  // places whose counts cover_settle copies from others
    VEC(uint32_t) single;     // for each decision of one condition, its first place: the condition's counts are copied from the result
    FlatProbes probes;        // which statements and decisions count which places
    FlatMachine *flat;        // the machine that counts
} Cover;

// Lists the places of a machine, as its scripts run it.
Cover *cover_new(Arena *arena, const Program *p);
// Counts the places of parameters, when a run begins.  cell: by Var.index, the values of all variables.
void cover_count_parameters(Cover *c, const uint64_t *cell);
// Opens the engine that counts.  It can run any number of scripts, one after another.
Engine *cover_open_engine(Cover *c);
// Opens an engine that counts in the Covers of p's machines: one, or those of an application.
Engine *cover_open_engines(Arena *arena, const Program *p, Cover *const *machine);
// Completes the counts after the runs, and finds the places that are impossible.
void cover_settle(Cover *c);
CoverTotal cover_total(const Cover *c, CoverKind kind);

// Opens an engine on a flat machine, for runs in lock step.
Engine *engine_flat_open(Arena *arena, const Program *p, FlatMachine *f);
// Returns the flat machines of p, in the order of its machines: one, or those of an application.
FlatMachine **flat_new_machines(Arena *arena, const Program *p);
// Opens an engine on these machines of p; for an application, they run as one.  one: the engine that runs machine number `member` instead; NULL:
// none.
Engine *engine_flat_open_machines(Arena *arena, const Program *p, FlatMachine *const *flat, Engine *one, size_t member);
// Makes the engine continue with another machine of the same program, in the state `run`, which the caller owns.
void engine_flat_set(Engine *e, FlatMachine *f, void *run);
// Returns the state of the engine's run, a block of flat->size bytes.
void *engine_flat_run(const Engine *e);

// ---- impossible.c ----

// Sets CoverPlace.impossible where facts prove that no run covers the place, from whatever state the machine starts.
void cover_find_impossible(Cover *c);

// ---- cover_list.c: what is missing, in words ----

typedef struct CoverGap {
    Span span;
    uint32_t place;
    const char *text;         // "`pressure > 400` was never false while it decided"
    bool is_impossible;       // no run can cover the place; `text` then gives the reason
} CoverGap;
typedef VEC(CoverGap) CoverGaps;

// Lists the places of the kinds in `kinds` (1u << CoverKind) that are not covered, in the order of the source.  Leaves out places whose cause is
// listed, such as the statements after a guard that was never true.
CoverGaps cover_list_gaps(const Cover *c, unsigned kinds);
// Appends the totals and the gaps.
void cover_write_text(const Cover *c, Buf *out);

// ---- cover_file.c ----

void cover_write_data(const Cover *c, Buf *out);      // appends the counts as a file that cover_add_data reads
void cover_write_json(const Cover *c, Buf *out);      // appends a JSON object on one line
void cover_write_lcov(const Cover *c, Buf *out);      // appends a tracefile of lcov
// Adds the counts of a file that cover_write_data has written for one or more of these machines.  Returns NULL, or why the file is refused, as a
// phrase after its name; then nothing is added.
const char *cover_add_data(Cover *const *machine, size_t machines, const char *text, size_t n);

#endif
