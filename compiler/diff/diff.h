// SPDX-License-Identifier: Apache-2.0
// Compares two machines by what they do, not by their text (docs/diff.md).
//
//     ProgramDiff *d = diff_programs(arena, &old, &new);
//     for each script: diff_run_script(d, name, script for the old one, script for the new one, max_steps);
//     diff_write_text(d, &out);
//
// States and locals are matched by name, then by what they do.  Two states have the same behaviour if their statements are equal under this
// match, or if the optimiser makes the same code of them.  If every state has, so do the machines: the initial state, every transition, every
// stored value and every sample are equal in every run.
#ifndef SMC_DIFF_H
#define SMC_DIFF_H

#include "compiler/diag/diag.h"
#include "compiler/ir/ir.h"
#include "compiler/script/script.h"

// One of the two machines.
typedef struct DiffSide {
    const Program *p;
    const IrMachine *ir;          // optimised as for the image that flies
    const Diags *findings;        // the findings of smc check about the machine; or NULL
    const uint8_t *measured;      // an image for cost_of_machine; or NULL: costs are not compared
    size_t image_size;            // bytes of the image that smc build writes
    uint64_t identity;            // smvm_logic_identity of the image
} DiffSide;

typedef enum DiffWeight {
    DIFF_BEHAVIOUR,               // what the machine does differs, or may differ
    DIFF_INTERFACE,               // the behaviour is equal, but other programs see a difference: layout, numbers of states, declared step
    DIFF_NOTE                     // the behaviour is equal: only names, marks or the text of the source differ
} DiffWeight;

typedef enum DiffPart { DIFF_STATE, DIFF_TRANSITION, DIFF_STATEMENT, DIFF_VARIABLE, DIFF_OPTION, DIFF_MARK, DIFF_LAYOUT, DIFF_PARTS } DiffPart;
typedef enum DiffHow { DIFF_ADDED, DIFF_REMOVED, DIFF_CHANGED, DIFF_RENAMED, DIFF_REWRITTEN, DIFF_HOWS } DiffHow;

extern const char *const diff_part_name[DIFF_PARTS];       // "state", "transition", "statement", "variable", "option", "mark", "layout"
extern const char *const diff_how_name[DIFF_HOWS];         // "added", "removed", "changed", "renamed", "rewritten"
extern const char *const diff_weight_name[];               // "behaviour", "interface", "note"

typedef struct DiffChange {
    DiffPart part;
    DiffHow how;
    DiffWeight weight;
    const char *where;            // name of the state or section, in the new machine if it is there, else in the old one; ""
    const char *what;             // "-> Vent", "valve in .step", "local count"
    const char *old, *new;        // the text in the old and in the new source; NULL: it does not exist there
    const char *meaning;          // a proved consequence of the change; NULL: none is known
    const Stmt *old_stmt, *new_stmt;          // TRANSITION, STATEMENT: the statements
} DiffChange;

typedef struct DiffCost { const char *name; uint64_t old, new; } DiffCost;

typedef struct DiffFinding { bool appeared; const Diag *diag; const char *where; } DiffFinding;      // appeared: only the new machine has it

enum { DIFF_VALUES_MAX = 8 };

typedef struct DiffValue { const char *name, *old, *new; } DiffValue;

// Both machines in one script.
typedef struct DiffRun {
    const char *script;
    const char *problem;          // why the script could not be compared; NULL: it was compared
    bool same;                    // states and elements were equal after every step, and so were the results
    uint64_t steps;               // number of steps that were compared
    uint64_t step, g;             // the first step that differs; step 0: only the results differ
    const char *old_state, *new_state;        // the states that the two machines ran in this step
    DiffValue value[DIFF_VALUES_MAX];         // the first elements whose values differ after the step
    uint32_t values;
    const char *old_result, *new_result;      // the results of the script, such as "passed after 101 steps"
} DiffRun;

typedef struct ProgramDiff {
    Arena *arena;
    DiffSide old, new;
    VEC(DiffChange) change;
    VEC(DiffCost) cost;
    VEC(DiffFinding) finding;
    VEC(DiffRun) run;
    uint32_t *state_of;           // by State.number of the old machine: the number of the matching state of the new one; 0: none
    uint32_t *old_state_of;       // by State.number of the new machine: that of the old one; 0: none
    const Var **var_of;           // by Var.index of the old machine: the matching variable of the new one; NULL: none
    const Var **old_var_of;       // by Var.index of the new machine: that of the old one; NULL: none
    bool *same_state;             // by State.number of the new machine: the state has the same behaviour as the matching one of the old machine
    bool same_layout;             // the state vectors have the same elements at the same offsets
    bool same_image;              // the images have the same identity
    const char *swap;             // whether the new machine can continue where the old one is, as a sentence
} ProgramDiff;

ProgramDiff *diff_programs(Arena *arena, const DiffSide *old, const DiffSide *new);
// Runs a script on both machines.  Either script is NULL if it has errors for that machine.
void diff_run_script(ProgramDiff *d, const char *name, const Script *old, const Script *new, uint64_t max_steps);
// Whether no difference in behaviour is listed, and no script has shown one.
bool diff_is_same(const ProgramDiff *d);

void diff_write_text(const ProgramDiff *d, Buf *out);
void diff_write_markdown(const ProgramDiff *d, Buf *out);
void diff_write_json(const ProgramDiff *d, Buf *out);
void diff_write_svg(const ProgramDiff *d, Buf *out);       // both state diagrams in one

#endif
