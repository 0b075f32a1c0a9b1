// SPDX-License-Identifier: Apache-2.0
// The optimiser: the passes of passes.def, run in order on a machine.  It changes the machine in place, preserves its meaning, and
// never reports anything to the user.  passes.def has two pipelines: RUN for every machine, and then RUN_FOR_C, on a copy of the machine,
// for emitted C only.
#ifndef SMC_PASS_H
#define SMC_PASS_H

#include "compiler/facts/facts.h"
#include "compiler/ir/ir.h"

// Facts that pass.c computes for the passes that need them.
enum {
    FACT_NONE = 0,
    FACT_USES = 1,        // use counts: how many operands and jumps use the result of each instruction
    FACT_VALUES = 2       // values: the possible values (compiler/facts) in the machine.  Renumbering variables or windows invalidates them
};

// A pass's notes about each variable while it walks a block.  One table serves all functions, because a machine may have as many
// states as variables.  notes_begin_block empties all notes at once.
typedef struct VarNote {
    uint32_t block;       // VarNotes.block when the note was made; in another block the note counts as empty
    IrRef ref, load;      // cse: the value number of the variable's value; the load that replaces later loads of the variable
    bool stored;          // the pass has visited a store in this block (dse: and no load since)
} VarNote;

typedef struct VarNotes {
    VarNote *at;          // at[variable]: the pass's note about it
    uint32_t block;       // number of the current block, counted over all functions
} VarNotes;

void notes_begin_block(VarNotes *n);
VarNote *find_variable_note(VarNotes *n, uint32_t var);  // an empty note (IR_NONE, false) if the block has stored no note

typedef struct Facts {
    unsigned valid;       // set of the facts that are valid: FACT_USES or nothing
    uint32_t *uses;       // by instruction: how many operands and jumps use its result
    const IrMachine *m;   // the machine that contains the function
    VarNotes *notes;      // working memory that any pass may use
    bool soft;            // as PassOptions.soft
    Arena *work;          // for tables that a pass needs while it runs
} Facts;

// A pass over one function.  What stays in the function is allocated in `arena`.  If the pass updates use counts itself, it changes `facts`
// along with the function.
typedef void PassFn(Arena *arena, IrFn *f, Facts *facts);
typedef void PassMachineFn(Arena *arena, IrMachine *m, FactMachine *values);     // values: NULL if the pass does not need them

typedef struct PassInfo {
    const char *name;
    unsigned needs, invalidates;      // facts that the pass needs, and that it makes invalid: sets of FACT_…
    const char *sentence;             // what the pass does, for docs
    PassFn *on_function;              // runs a pass that works on functions; else NULL
    PassMachineFn *on_machine;        // runs a pass that works on machines; else NULL
} PassInfo;

typedef enum PassId {
#define PASS(name, needs, invalidates, sentence) PASS_##name,
#define PASS_MACHINE(name, needs, invalidates, sentence) PASS_##name,
#include "compiler/passes/passes.def"
    PASS_COUNT
} PassId;

extern const PassInfo pass_info[PASS_COUNT];

const PassInfo *pass_find(const char *name);          // NULL if no pass has that name

typedef struct PassOptions {
    int level;                                        // -O: passes of a higher level do not run; 0 runs none
    const char *only;                                 // a comma-separated list: run just these, in this order; or NULL
    bool verify;                                      // verify the machine before the first pass and after each pass
    bool soft;                                        // for emitted C whose numbers are computed in software
    void (*after)(void *context, const PassInfo *pass, const IrMachine *m);    // called after each pass; or NULL
    void *context;
} PassOptions;

// Runs the optimiser.  Returns NULL, or an error as a sentence: `only` contains an unknown name, or `verify` found that a pass broke
// the machine.
const char *passes_run(Arena *arena, IrMachine *m, const PassOptions *o);

// Prepares a machine for the C emitter, after passes_run: returns a copy on which the passes marked RUN_FOR_C have run, with `values` set.
// m is unchanged and can become an image.  `o` may be NULL; `level` and `only` are ignored.  Returns NULL if a pass has broken the machine;
// *wrong is then a sentence that begins with the name of the pass.
IrMachine *passes_for_c(Arena *arena, const IrMachine *m, const PassOptions *o, const char **wrong);

// Calls `pass` for each function of m, with its flow.  `work`: for tables that the pass needs while it works on the function.
typedef void PassValuesFn(Arena *arena, Arena *work, IrFn *f, FactFlow flow);
void pass_on_each_function(Arena *arena, IrMachine *m, FactMachine *values, PassValuesFn *pass);

// ---- the passes, each in its own file ----

#define PASS(name, needs, invalidates, sentence) void pass_##name(Arena *arena, IrFn *f, Facts *facts);
#define PASS_MACHINE(name, needs, invalidates, sentence) void pass_##name(Arena *arena, IrMachine *m, FactMachine *values);
#include "compiler/passes/passes.def"

#endif
