// SPDX-License-Identifier: Apache-2.0
// Analyses: warnings about parts of a machine that look wrong but are not errors.  They read a machine as it was written, with
// the facts about its values, and report warnings.  They change nothing, and the compiled output does not depend on them.
//
// A machine is analysed as it runs on the target, where no script writes its locals: IrVar.outside is false for all of them.
//
// The facts (`facts`, `stmt`) come from compiler/facts, run on the IR before any pass.  They assume that the machine starts in
// its first state and that elements can have any value of their type at the start of every step.  So what the facts exclude is
// impossible for all inputs.  Only analyses whose comment says so also use @range (assume.h).
#ifndef SMC_ANALYSIS_H
#define SMC_ANALYSIS_H

#include "compiler/analysis/transitions.h"
#include "compiler/diag/diag.h"
#include "compiler/facts/facts.h"
#include "compiler/script/scenario.h"
#include "compiler/sema/iomap.h"
#include "compiler/sema/program.h"
#include "compiler/sema/requirements.h"

// The facts about a statement.
typedef struct StmtFact {
    bool reached;                 // a run may execute the statement
    bool then, otherwise;         // for a conditional: the guard can be true; the guard can be false
    Fact value;                   // for an assignment: the value before conversion to the variable's type; for a conditional: the guard
    bool has_env;                 // `env` is known (env_of_stmt)
    uint32_t state;               // index of the state that contains the statement
    BlockKind block;
    const Env *env;               // private to env_of_stmt: the facts where the guard (IF) is evaluated, or the transition is executed
} StmtFact;

// Runs from the machine's start, as a search finds them.
typedef struct AnalysisRuns { const Scenario *at; uint32_t n; } AnalysisRuns;
// Finds runs that reach states of the machine, in which G grows by delta_t in a step.  parameter: by Var.index, the cells of the parameters.  Uses
// 1 / share of the effort.  The result is the arena's.
typedef AnalysisRuns AnalysisSearch(Arena *arena, const Program *p, uint64_t delta_t, const uint64_t *parameter, uint32_t share);

typedef struct Analysis {
    unsigned groups;              // the groups whose warnings are enabled: a set of 1u << DiagGroup
    uint64_t step;                // how much the global time G advances per step; 0: unknown
    bool pauses;                  // it can also advance more: while its @mode is another one, the machine does not step
    Arena *kept;                  // memory that is freed after all analyses
    Arena *arena;                 // working memory of one analysis, freed after it.  Data that a diagnostic stores (such as the
                                  // text of an edit) is in diags->arena
    Diags *diags;
    const Program *p;
    const IrMachine *m;           // the IR of p before any pass
    FactMachine *facts;
    StmtFact *stmt;               // stmt[Stmt.number]: the facts about a statement
    bool large_sums;              // some sum has an operand whose magnitude is always 2^53 or more
    Transitions transition;       // all transitions of the machine, in file order
    AnalysisSearch *search;       // asked for states that trial runs do not reach; NULL: there is no search
    AnalysisRuns *runs[3];        // by TrialSetting: what it has found; NULL: it was not asked
} Analysis;

// Fills in *a for a machine: builds its IR, computes its facts and lists its transitions.  Reports no findings.  `arena` owns the result.
void analysis_begin(Analysis *a, Arena *arena, Diags *diags, const Program *p);

// Returns the facts about each statement, by Stmt.number, if S is the number of the state while the state's statements run.  Only `reached`, `then`,
// `otherwise` and `value` are set.  The facts in Analysis.stmt do not assume this, because other code could write S.
StmtFact *analysis_facts_in_states(const Analysis *a);

// Runs all analyses of a machine, in its IR before any pass, whose warnings belong to these groups (1u << DiagGroup for each).
// `step`, `pauses`, `search`: see Analysis.  Nothing in `arena` is needed afterwards.  `scratch` must be empty and is empty again on return.
void analyse_machine(Arena *arena, Arena *scratch, Diags *diags, const IrMachine *m, unsigned groups, uint64_t step, bool pauses,
                     AnalysisSearch *search);

// Reports conflicts between n machines that share a state vector, such as two machines that write one element.  The names of all
// machines must be interned in one pool.
void analyse_shared_vector(Arena *arena, Diags *diags, const Program *const *p, size_t n);

// Reports conflicts between a machine and the input pins of its elements (config.md 9.13).  An input pin for G or S is an error.
void analyse_shared_pins(Arena *arena, Diags *diags, const IoMap *io, const Program *p);

// Reports values of a script whose units do not fit each other.  Nothing in `arena` is needed afterwards.
void analyse_units_of_script(Arena *arena, Diags *diags, const Script *script);

// Reports inputs of a script that alternate between two values, because they are set to their own prev.
void analyse_inputs_of_script(Diags *diags, const Script *script);

// Reports asserts of a script that no behaviour of the machine can make false.  Nothing in `arena` is needed afterwards.
void analyse_asserts_of_script(Arena *arena, Diags *diags, const Script *script);
// Reports operands of a condition of a script that change nothing (absorbed_operand.c).
void analyse_absorbed_condition(Arena *arena, Diags *diags, const Expr *condition);

// Reports requirements that no behaviour of the machine can violate, or meet.
void analyse_requirements(Diags *diags, const Requirements *all);

// ---- for analyses ----

#define ANALYSIS(name, group, sentence) void analyse_##name(Analysis *a);
#include "compiler/analysis/analyses.def"
#undef ANALYSIS

// Sets of operators, in the format of Stmt.operators.
enum {
    EQUALITIES = 1 << SM_OP_EQ | 1 << SM_OP_NE,
    COMPARISONS = EQUALITIES | 1 << SM_OP_LT | 1 << SM_OP_LE | 1 << SM_OP_GT | 1 << SM_OP_GE
};

// A comparison in the outermost node of an expression.  A chain such as `0 < x < 9` has several, `a < b` has one, other expressions have
// none.
typedef struct Comparison {
    const Expr *a, *b;
    SmOperator op;
} Comparison;
uint32_t comparison_count(const Expr *e);
Comparison comparison_at(const Expr *e, uint32_t i);

// comparison_negated returns the operator that is true exactly if op is false (when no operand is NaN).  comparison_swapped returns the
// operator for exchanged operands (< for >).
SmOperator comparison_negated(SmOperator op);
SmOperator comparison_swapped(SmOperator op);
// Returns the possible results of `a op b`, as the fact of a bool.
Fact fact_of_comparison(SmOperator op, Fact a, Fact b);

// Whether e reads the variable, also in the sample of a window.
bool expr_reads(const Expr *e, const Var *v);

// Returns StmtFact.env of a reached guard or transition.
const Env *env_of_stmt(const Analysis *a, const Stmt *stmt);

// Whether every path through these statements ends in a transition, whatever the guards evaluate to (dead_code.c).
bool always_leaves(const Stmts *stmts);

// Completes the findings from diags->list.at[first] on that are about statements of [all_states] (all_states.c).
void complete_all_states_findings(Analysis *a, size_t first);
// Calls f for every statement of a machine.  A conditional comes before the statements inside it.
void each_stmt(const Program *p, void (*f)(const Stmt *stmt, void *context), void *context);

// Calls f for every reachable function of a state, with the facts of its temporaries, which are valid until f returns.
typedef struct ReachableFn { const State *state; BlockKind block; const IrFn *fn; FactFlow flow; } ReachableFn;
void each_reachable_fn(Analysis *a, void (*f)(Analysis *a, const ReachableFn *r, void *context), void *context);

#endif
