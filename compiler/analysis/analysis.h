// SPDX-License-Identifier: Apache-2.0
// Analyses: what looks wrong in a machine that is no error.  They read a machine as it was written, with what can be known of its
// values, and report warnings.  They change nothing, and nothing that is compiled depends on them.
//
// A machine is analysed as it flies: compiled without the names that scripts write, so no local is `outside`.
//
// What is known (`facts`, `stmt`) comes from compiler/facts on the IR before any pass, of a machine that starts in its first
// state; elements can be anything their type holds at the start of every step.  So what is called impossible here is
// impossible, whatever the inputs.  What @range declares is used only where an analysis says so (whatif.h).
#ifndef SMC_ANALYSIS_H
#define SMC_ANALYSIS_H

#include "compiler/analysis/transitions.h"
#include "compiler/diag/diag.h"
#include "compiler/facts/facts.h"
#include "compiler/sema/iomap.h"
#include "compiler/sema/program.h"

// What is known of a statement.
typedef struct StmtFact {
    bool reached;                 // some run may execute it
    bool then, otherwise;         // IF: its guard may hold; it may not hold
    Fact value;                   // ASSIGN: what is stored, before it is converted to the variable's type; IF: its guard, as a bool
    const Env *env;               // IF: what is known where its guard decides; TRANSITION: where it is made
} StmtFact;

typedef struct Analysis {
    unsigned groups;              // 1u << DiagGroup of each whose warnings are wanted
    uint64_t step;                // how much G advances from one step to the next; 0: not known
    Arena *arena;                 // for the work of one analysis: given back after it.  What a diagnostic keeps (the text of an
                                  // edit) lives in diags->arena
    Diags *diags;
    const Program *p;
    const IrMachine *m;           // as built
    FactMachine *facts;
    StmtFact *stmt;               // by Stmt.number
    bool large_sums;              // somewhere a sum has an operand that is surely 2^53 or beyond
    Transitions transition;       // all that stand in the machine, in file order
    const IrFn **asked;           // by Stmt.number: what whatif.h has built of its guard or value; NULL: not yet.  [0]: any
} Analysis;

// Everything but the findings: what the reports use too.  `arena` holds it.
void analysis_begin(Analysis *a, Arena *arena, Diags *diags, const Program *p);

// All analyses of a machine, as built, whose warnings are of these groups (1u << DiagGroup of each); `step` as above.  Nothing in
// `arena` is needed afterwards; `scratch` is empty before and after.
void analyse_machine(Arena *arena, Arena *scratch, Diags *diags, const IrMachine *m, unsigned groups, uint64_t step);

// What can be said of several machines over one state vector only: who writes what.  Their names come from one pool.
void analyse_together(Arena *arena, Diags *diags, const Program *const *p, size_t n);

// The same of a machine and the pins of its elements (config.md 9.13): G and S are nobody's inputs, which are errors.
void analyse_pins(Arena *arena, Diags *diags, const IoMap *io, const Program *p);

// ---- for analyses ----

#define ANALYSIS(name, group, sentence) void analyse_##name(Analysis *a);
#include "compiler/analysis/analyses.def"
#undef ANALYSIS

// Sets of operators, as Stmt.operators is one.
enum {
    EQUALITIES = 1 << SM_OP_EQ | 1 << SM_OP_NE,
    COMPARISONS = EQUALITIES | 1 << SM_OP_LT | 1 << SM_OP_LE | 1 << SM_OP_GT | 1 << SM_OP_GE
};

static inline bool is_comparison(SmOperator op) { return (COMPARISONS >> op & 1) != 0; }

// The comparison that holds where this one does not (of numbers: NaN apart), and the one with its operands exchanged.
SmOperator relation_opposite(SmOperator op);
SmOperator relation_mirrored(SmOperator op);

// Whether every way through these statements ends in a transition, as written, whatever guards say (dead.c).
bool always_leaves(const Stmts *stmts);

// Calls f for every statement of a machine, those inside conditionals after the conditional itself.
void each_stmt(const Program *p, void (*f)(const Stmt *stmt, void *context), void *context);

// Calls f for every function of a state that can be reached, with the facts of its temporaries, which hold until f returns.
typedef struct FlowPlace { const State *state; BlockKind block; const IrFn *f; FactFlow flow; } FlowPlace;
void each_flow(Analysis *a, void (*f)(Analysis *a, const FlowPlace *at, void *context), void *context);

#endif
