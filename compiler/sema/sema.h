// SPDX-License-Identifier: Apache-2.0
// Shared by the files of the checker.  Only files in sema/ include this header; other folders include check.h.
#ifndef SMC_SEMA_H
#define SMC_SEMA_H

#include "compiler/sema/check.h"

// Where an expression appears.  This decides what it may use.
typedef enum ExprContext {
    EXPR_IN_STEP,               // evaluated in a step: may use everything
    EXPR_IN_INITIAL,            // initial value of a local: may use earlier locals
    EXPR_IN_SIZE                // size of a window: may use locals
} ExprContext;

// A local that the size of a window depends on.
typedef struct SizeUse { Var *local; Span span; } SizeUse;

// A local whose initial value reads a parameter, which is reported.
typedef struct DependentLocal { const Var *local; Diag *report; } DependentLocal;

// What the parser's errors may have hidden in a file (lost.c).
typedef struct HiddenNames {
    bool any;                 // the parser reported errors in the file
    bool names;               // some errors may have hidden declarations
    bool sections;            // some errors may have hidden whole sections
    Map word;                 // set of the words that the hidden parts may have declared
} HiddenNames;

HiddenNames *find_hidden_names(const CheckContext *c, const AstFile *f);
void add_names_of_sections(const CheckContext *c, const AstFile *f, HiddenNames *to);     // adds the words of sections that a .rq cannot have
void add_hidden_names(const CheckContext *c, const AstFile *f, HiddenNames *to);

// One machine or script being checked.
typedef struct Sema {
    Arena *arena;
    Arena *nodes;             // memory for nodes of expressions: `arena`, or `scratch` for temporary ones
    Arena *scratch;           // may be freed after each item of a script
    StrPool *strings;
    Diags *diags;
    const Program *p;         // the machine being checked, or the machine that the script belongs to
    StateVec *sv;             // machine with a .sv: the elements that it can list; else NULL
    Windows *windows;         // the list to which the windows of roll calls are added: the machine's or the script's
    bool in_script;           // a script, or requirements
    bool in_requirements;
    Map script_local;         // in a script: the name of a variable in its [local] to Var
    Diag *unknown;            // in a script: the first report of a name that the machine does not have
    bool knows_a_name;        // in a script: at least one name in it, other than G, S and T, exists in the machine
    const HiddenNames *lost;  // names that syntax errors may have hidden: they are not reported as unknown
    Map functions;            // name to SmBuiltinInfo
    Map unknown_name, unknown_state, unknown_function;   // unknown names that are already reported: sets, name to itself
    bool functions_noted;     // a note with the list of all functions has been added to a report
    Map remarked;             // set of names about which a warning was given that appears once per name
    Map doubtful;             // set of names declared twice: they cause no further reports
    Map declared_at;          // name or alias to the Span of its declaration
    unsigned guesses;         // how many more unknown names may be compared with all known ones

    Map defines;              // name to Define: the definitions that can be used
    Define *inside;           // the definition whose use is being checked; NULL: none
    uint32_t expanded;        // operations and values into which the uses of definitions have been expanded so far
    uint32_t depth;           // the depth of the current expression below the root of its statement
    AllStates *all_states;    // the section whose statements are being checked; NULL: none
    uint32_t copied;          // number of copies of statements of all [all_states] sections so far
    const Source *copy;       // while statements are copied: the copy of the source in which they have positions (sema_span); NULL: the file
    uint64_t step;            // how much G advances in a step; 0: unknown
    ExprContext at;
    const Var *local;         // EXPR_IN_INITIAL: the local whose initial value is being checked
    Str size_of;              // EXPR_IN_SIZE: the roll function whose size argument is being checked
    const AstExpr *searched_left;     // an operand whose leftmost operand has already been checked for a `not`
    bool no_elements;         // the machine lists no elements; already reported
    bool *no_value;           // by Var.index: the local's initial value has an error
    VEC(DependentLocal) dependent;    // the locals whose initial values read a parameter; propose_definitions reads it
    VEC(SizeUse) size_use;    // the locals that window sizes depend on so far; check_size_uses reads it
    BlockKind block;          // the block that contains the current statement
    const State *state;       // the state of the current statement; NULL in [all_states]
    bool has_units;           // a variable or definition has an @unit
    uint32_t stmts;           // the number of statements so far
    uint32_t operators;       // 1u << SmOperator of each operator in the value that is being checked; becomes Stmt.operators
    bool varies;              // whether the value that is being checked varies; becomes Stmt.varies
    Program *building;        // the machine being built; NULL for a script
    ScriptRandoms *random;    // the list of the script's random calls; NULL for a machine
} Sema;

void sema_init(Sema *s, const CheckContext *c, const HiddenNames *lost, const Program *p, Windows *windows);
// The file's name without folders and extension.
Str sema_file_stem(StrPool *strings, const Source *src);

// ---- scope.c: names ----

Var *scope_find_variable(const Sema *s, Str name);
bool scope_is_doubtful(const Sema *s, Str name);        // whether the name was declared twice, so that its meaning is uncertain
// Reports a name that scope_find_variable does not find; once per name.
void scope_report_unknown(Sema *s, Str name, Span span);
// Returns the state; NULL if no state has this name, after reporting it: once per name, and not if an error may have hidden its declaration.
State *scope_find_state(Sema *s, const Program *machine, Str name, Span span);
const SmBuiltinInfo *scope_find_function(const Sema *s, Str name);
void scope_report_unknown_function(Sema *s, Str name, Span span);
// Adds a note that points at the declaration of a name of the machine.
void scope_note_declared(Sema *s, Diag *d, Str name);

// A search for the known word nearest to an unknown one.
typedef struct Guess {
    Str wanted, best;         // best: NULL until a near word is found
    size_t limit;             // only words whose edit distance is below limit count
} Guess;

Guess guess_init(Str wanted);
void guess_consider(Guess *g, Str candidate);
void guess_add_label(Diags *diags, Diag *d, const Guess *g);   // adds "did you mean …?", if a near word was found
// Each of these two functions finds the known name that is most similar to an unknown `name`, adds it as a label to d, and returns it; NULL
// if no known name is similar.  *guesses is how many more such searches are allowed.
Str suggest_element(Diags *diags, Diag *d, unsigned *guesses, const StateVec *sv, Str name);
Str suggest_state(Diags *diags, Diag *d, unsigned *guesses, const Program *p, Str name);

// ---- the parts of the checker ----

// Returns a new variable for a declaration, without index, element and initial value.
Var *sema_new_var(Sema *s, VarKind kind, const AstDecl *decl);
// Declares the variables of every [local] section of a script's files in script->local, and computes their initial values
// (check_script_local.c).
void check_script_locals(Sema *s, Script *script, const AstFile *const *file, size_t files);

// Checks the [state_vector] and [local] sections of a machine, and builds its variables.
void check_declarations(Sema *s, Program *p, const AstFile *sm, StateVec *sv, const Map *written_outside, const MachineInstance *instance);
// Returns NULL after an error, which is reported.
Expr *check_expr(Sema *s, const AstExpr *e);
// Check calls that sample their first argument (check_sampled.c); return NULL after an error, which is reported.
Expr *check_roll_call(Sema *s, const AstExpr *call, const SmBuiltinInfo *fn);
Expr *check_sampled_call(Sema *s, const AstExpr *call, SmBuiltin fn);
// Checks a call of min, max, median or average (check_list.c); returns NULL after an error, which is reported.
Expr *check_list_call(Sema *s, const AstExpr *call, const SmBuiltinInfo *fn);
void sema_record_operator(Sema *s, SmOperator op);     // records that the value being checked, and the machine, contain an operator
// Sets the variable and the value of an assignment; false after an error, which is reported.
bool check_assignment(Sema *s, const AstStmt *in, Stmt *out);
Var *check_target(Sema *s, Str name, Span span);       // returns the variable that a statement assigns; NULL after a report
void check_data(Sema *s, Script *script, const AstSection *in);       // checks [data] of a script (check_data.c)
void check_stmts(Sema *s, const AstStmts *in, Stmts *out);
// Warns of an unconditional transition to an @abort state that the layout makes look conditional (check_unguarded.c).
void warn_of_unguarded_abort(Sema *s, const State *state, const AstSection *section, AstLabel label);
const char *sema_quote_source(Sema *s, Span span);     // part of the source for a diagnostic: one line, shortened to a readable length
// Warns of windows whose size depends on a local that the machine assigns.
void check_size_uses(Sema *s);

bool has_annotation(const AstAnnotations *all, AstAnnotationKind kind);
// Returns the @range among the annotations of an element; NULL if no annotation is a @range, or if the range is invalid, which is reported.
const Range *check_range(const CheckContext *c, const AstAnnotations *all, Str name, SmType type);

// ---- check_measure.c: units of measurement ----

// Returns the @unit among the annotations; NULL if there is no @unit, or if its word is no unit, which is reported. `is_bool`: a bool has the
// annotations.
const Measure *check_unit(const CheckContext *c, const AstAnnotations *all, Str name, bool is_bool);
// Sets the unit of v, which a machine lists, to that of the .sv if the machine gives none. Warns if they differ.
void set_listed_unit(Sema *s, Var *v, const AstDecl *decl, bool from_machine);

// Returns the position of a typed node: in the copy of the source for a state, while statements of [all_states] are checked.
static inline Span sema_span(const Sema *s, Span written)
{
    if (s->copy)
        written.src = s->copy;
    return written;
}

// ---- check_binding.c: elements of the state vector under the names of a machine ----

// Returns the binding of a listed element, by its name or its alias; NULL: it keeps its name.
const AstBinding *find_binding(const MachineInstance *instance, const AstDecl *decl);
// Returns the element to which the declaration is bound; NULL after a report.
Element *find_bound_element(Sema *s, const StateVec *sv, const AstDecl *decl, const AstBinding *b);
void check_bindings(Sema *s, Program *p, const MachineInstance *instance);       // call it when the machine's variables are complete

// ---- check_parameter.c: parameters ----

// Returns the parameter that the annotations of a local declare, without its default; NULL: the local is no parameter.  Reports a missing or
// invalid range.
const Parameter *check_parameter(Sema *s, const Var *v, const AstDecl *decl);
// Sets the default of parameter v, which is also its value until a script or caller sets another one.  Reports a default that v cannot have.
void check_default(Sema *s, Var *v, SmF64 x);
// Reports an assignment to parameter v, in a machine or a script.
void report_parameter_assigned(Sema *s, const Var *v, Str name, Span span);
// Whether parameter `name` of p can have `value`: a number or a time, with or without a sign, true or false; *cell is then the value.  If not,
// reports why.
bool check_parameter_value(Sema *s, const Program *p, Str name, Span name_span, const AstExpr *value, uint64_t *cell);
// Sets parameter `name` of the machine p, which is being checked, to `value`, or reports why not.  Call it after compute_initial_values.
bool set_parameter_of_machine(Sema *s, Program *p, Str name, Span name_span, const AstExpr *value);
// Reports a parameter in the initial value of local s->local, or in the size of a window.
void report_parameter_in_initial(Sema *s, const Var *v, const AstExpr *e);
void report_parameter_in_size(Sema *s, const Var *v, const AstExpr *e);
// Proposes a definition for each local whose initial value reads a parameter, if the machine never assigns the local.
void propose_definitions(Sema *s, const AstFile *sm);

// ---- check_all_states.c: [all_states] of a machine ----

void find_all_states(Sema *s, Program *p, const AstFile *sm);         // call it when all states are known
void add_all_states(Sema *s, Program *p, State *state);               // call it before the statements of the state's own .step are checked
// Reports a transition of [all_states] to a state in which the section runs.
void check_target_is_excepted(Sema *s, const AstStmt *in, const State *to);
// Warns of sections that do not run in the step in which .entry of a state makes a transition.
void warn_of_skipped_all_states(Sema *s, const Program *p);

// ---- define.c: definitions ----

// Adds the definitions of one section to s->defines, so that later code can use them, and to `into`.
void declare_definitions(Sema *s, const AstSection *section, Defines *into);
void add_definitions_of_machine(Sema *s);              // makes the definitions of the machine usable in a script
Expr *expand_definition(Sema *s, Define *d, const AstExpr *use);      // builds the expression of a definition that `use` names
void check_unused_definitions(Sema *s, const Defines *all);
// Warns of the definitions that nothing uses.
void report_unused_definitions(Diags *diags, const Defines *all);

// ---- check_time.c: the unit of time ----

// Sets the machine's unit and step of time from its [options].
void check_time_options(Sema *s, Program *p, const AstFile *sm);
// Returns the value of an option such as `delta_t 20 ms`, a whole number from 1 to 2^63, in the unit `unit`; 0 for anything else.
uint64_t option_step(const AstOption *o, TimeUnit unit);
// Computes the value of a literal that is a whole number of units from 0 to 2^63. Returns false for anything else.
bool literal_units(const AstExpr *e, TimeUnit unit, uint64_t *units);
// Returns the value of a literal that has a unit, in the unit of the machine.
SmF64 check_time_literal(Sema *s, const AstExpr *e);
// Computes how many samples a window of the last `time` units of G has: time / step + 1. `size`: the argument of the function `name`. Returns
// false after a report: the step is unknown, or the time is not a multiple of it.
bool check_window_time(Sema *s, const AstExpr *size, const char *name, SmF64 time, SmF64 *samples);
// Whether e contains a time literal, also in the initial values of its locals.
bool expr_contains_time(const Expr *e);
// Warns if `time` is T or G and `literal`, with which it is compared, is no whole number of units.
void warn_of_time_fraction(Sema *s, const AstExpr *time, const AstExpr *literal);
// Warns of a guard that is only a time, as in `5 s: -> Next`.
void warn_of_time_as_guard(Sema *s, const AstExpr *guard);
// Warns of the operands of * or / that are times.
void warn_of_time_factors(Sema *s, const AstExpr *a, const AstExpr *b);
// Reports a machine that needs another unit or step of time than the application has. `unit`, `period`: in nanoseconds; 0: unknown.
void check_app_machine_time(const CheckContext *c, Program *p, Span named, uint64_t unit, uint64_t period);

// ---- check_state_names.c: S compared with the name of a state ----

// Checks a binary operator with the name of a state.  Returns false if it is another one, whose operands have values; else *out is the
// comparison, or NULL after an error.
bool check_state_names(Sema *s, const AstExpr *e, Expr **out);
void warn_of_state_number(Sema *s, const AstExpr *e);      // warns of `S == 3`, and proposes the name of the state

// ---- check_script_when.c: guards by time of a script ----

Expr *check_guard(Sema *s, const AstExpr *e);              // the guard of a conditional of a script: `G == 5000` becomes one node, like `at 5 s`
Expr *check_when(Sema *s, const AstExpr *e);               // a guard by time: at 5 s, from 1 s to 2 s, after 5 s, every 10 ms
Expr *check_state_value(Sema *s, const AstExpr *e);        // a value such as `state Burn`
// Reports `S == state Burn`, which compares twice. Returns false, and reports nothing, if e is another comparison.
bool report_compared_state_value(Sema *s, const AstExpr *e);
// Proposes a guard by time for a comparison with G, as in `G == 5000:`.
void propose_when(Sema *s, const AstExpr *guard, uint64_t delta_t);
// Reports a guard by time that is true at no multiple of delta_t, so in no step.  delta_t is above 0.
void check_when_times(Sema *s, const Expr *guard, uint64_t delta_t);
bool is_reached_time(SmF64 x, uint64_t delta_t);          // whether a clock that starts at 0 and advances by delta_t is ever equal to x

// ---- check_random.c: random numbers of a script ----

bool is_random_function(Str name);                         // whether the name is `random` or `noise`
// Numbers the calls in the definitions of a file. Call it before its other expressions are checked.
void number_random_definitions(Sema *s, const AstFile *ss);
Expr *check_random_call(Sema *s, const AstExpr *e);
void report_random_in_machine(Sema *s, const AstExpr *e);

// ---- check_allow.c: these functions register @allow annotations with the part of the source that they cover ----

// Register the annotations of a declaration, in a .sv and in a machine.
void add_sv_allows(const CheckContext *c, StateVec *sv, const AstDecl *decl);
void add_decl_allows(Sema *s, const AstDecl *decl);
void add_definition_allows(Sema *s, const AstDefinition *in);
// Registers the annotations after the header of a state.  `end` is the end of its section.
void add_state_allows(Sema *s, const AstSection *section, uint32_t end);
void add_stmt_allow(Sema *s, const AstAnnotation *a, const AstStmt *stmt);
// Registers the annotations of an element in the .sv for the position where a machine lists the element.
void add_listed_allows(Sema *s, const Element *e, const AstDecl *listed);

// ---- check_rq.c: marks @req of a machine ----

void add_section_marks(Sema *s, const AstSection *section, const State *state);      // adds the marks on a section; state: NULL for [all_states]
void add_stmt_marks(Sema *s, const AstStmt *in, const Stmt *stmt);

Expr *expr_new(Sema *s, ExprKind kind, Span span, uint32_t args);

#endif
