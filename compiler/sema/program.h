// SPDX-License-Identifier: Apache-2.0
// The typed program: the checker's output for an AST without errors.  Every name is bound, every number is exact and every
// element has its offset.  Aliases, parentheses and operator spelling are resolved.  The reference interpreter, the IR builder,
// the script engine and the reports read it.  No code changes it after the check.
#ifndef SMC_PROGRAM_H
#define SMC_PROGRAM_H

#include <stdbool.h>
#include <stdint.h>

#include "compiler/base/buf.h"
#include "compiler/base/source.h"
#include "compiler/base/str.h"
#include "compiler/base/vec.h"
#include "compiler/sema/measure.h"
#include "compiler/syntax/time_unit.h"
#include "stdlib/parameter.h"
#include "stdlib/types.h"

// ---- the state vector ----

typedef struct Region Region;

// @range: the values that a healthy sensor delivers.  Only reports rely on it.
typedef struct Range {
    SmF64 lo, hi;             // lo <= hi, both finite
    Span span;                // the annotation
} Range;

// @allow(flag, "reason"): findings with this name in this part of the source are known and accepted.
typedef struct Allow {
    const char *flag;         // the warning's name, as after -W
    Str reason;
    Span span;                // the annotation
    Span covers;              // the declaration, the whole section of the state, or the statement with its body
} Allow;

typedef struct Element {
    Str name;
    SmType type;
    bool untyped;             // the declaration has no valid type, which is already reported
    const Range *range;       // the element's @range, or NULL
    bool command;             // the element is marked @command: a person operates it
    const Measure *unit;         // the element's @unit, or NULL
    uint32_t first_allow, allows;     // its @allow annotations are StateVec.allow[first_allow] and the following, `allows` in all
    uint32_t index;           // index in StateVec.element
    uint32_t offset;          // bytes from the start of the state vector in memory (vector_layout.c)
    Region *region;
    Span span;                // position of its name in the declaration
} Element;

struct Region {
    Str name;
    uint32_t offset, size;    // in bytes: distance from the start of the state vector; size in memory, without padding after the last element
    uint32_t packed_size;     // bytes in a message, where elements have no padding
    uint32_t first, count;    // its elements are StateVec.element[first] and the following, `count` in all
    Span span;
};

typedef struct StateVec {
    Str name;                 // the .sv file's stem, or the machine's when its own section is the whole vector
    bool lock;
    bool from_machine;        // there is no .sv: the machine's [state_vector] section declares all elements, in one region
    VEC(Element *) element;   // in declaration order
    VEC(Region *) region;
    VEC(Allow) allow;         // the @allow annotations of the elements in a .sv
    Map by_name;              // name to Element
    uint32_t size;            // size in memory in bytes, a multiple of 8
    uint32_t hash;            // hash of names, types and order: machines run only with a vector that has this hash
} StateVec;

// ---- variables ----

typedef enum VarKind {
    VAR_ELEMENT,              // an element of the state vector
    VAR_LOCAL,
    VAR_TIME                  // T
} VarKind;

// A parameter (language.md 5.77): a local whose value is set before the machine starts.
typedef struct Parameter {
    SmF64 lo, hi;             // the range of its values: both ends are finite and exactly of its type; for a bool 0 and 1
    uint64_t standard;        // the default, as a bit cell of the parameter's type; Var.init has the value that is set now
    const Measure *unit;      // its @unit as written, or NULL
    Span span;                // the annotation
} Parameter;

typedef struct Expr Expr;
struct Program;

typedef struct Var {          // "ELEMENT:" or "LOCAL:" marks a field that only this kind has
    VarKind kind;
    Str name;                 // as written in [state_vector] or [local]
    Str alias;                // the name after @alias; or NULL
    Str report_name;          // the name in reports: of name and alias the one that sorts first in ASCII
    SmType type;
    uint32_t index;           // index in Program.var; for a variable of a script, Program.var.n plus the index in Script.local
    Element *element;         // ELEMENT: the element of the state vector that it names
    const Range *range;       // ELEMENT: from the machine, or else from the .sv; or NULL
    bool read_only;           // the machine cannot assign the variable; true for G, S and T
    bool command;             // ELEMENT: marked @command, here or in the .sv
    const Parameter *parameter;       // LOCAL: set if it is a parameter, which is also read-only and never constant; else NULL
    const Measure *unit;      // its @unit, of an ELEMENT from the machine or else from the .sv; or NULL
    uint64_t init;            // LOCAL: its initial value, as a bit cell of its type (convert.h)
    Expr *init_value;         // LOCAL: the expression that init was computed from
    bool outside;             // LOCAL: code outside the machine (a state script) writes it between steps
    bool is_constant;         // LOCAL: read-only and not written from outside, so `init` is always its value
    bool written;             // the machine contains an assignment to the variable
    bool read;                // the machine reads the variable
    bool sizes;               // LOCAL: the size of a window is computed from its value
    bool listed;              // LOCAL: a value of median or average is computed from locals only, this one among them (language.md 3.46)
    bool of_script;           // LOCAL: a script declares it, not the machine; no engine knows it
    const struct Program *state_of;   // ELEMENT: the machine whose S it is; NULL: none
    Span span;                // position of its name in [state_vector] or [local]
} Var;

// ---- definitions ----

struct AstExpr;

typedef struct Define Define;

// A use of a definition in its own file.
typedef struct DefineUse {
    Span span;
    const Define *inside;     // the definition whose expression contains the use; NULL: none
} DefineUse;

// A line of [define]: a name for an expression. A use is an Expr of its own, so only the checker and reports read this.
struct Define {
    Str name;
    struct AstExpr *value;
    Span value_span;          // the expression
    uint32_t number;          // index among the definitions of the file, from 0; the numbers of a script's definitions follow those of its machine
    uint32_t size;            // number of operations and values of the expression, after the definitions in it are expanded
    const Measure *unit;         // its @unit, or NULL
    uint32_t names;           // if the expression is only the name of another definition with a unit: 1 + `number` of that definition; else 0
    bool used;                // a statement, a declaration, a used definition or a requirement uses it
    bool expanded;            // its expression has been checked, so the uses in it are listed in `use`
    VEC(DefineUse) use;       // in the order in which the checker found them; a use in [all_states] once for each copy
    Span span;                // position of its name in [define]
};

typedef VEC(Define *) Defines;

// ---- expressions: every value is an F64 ----

typedef enum ExprKind {
    EX_NUMBER,                // the number `number`
    EX_VAR,                   // the value of `var`, read as F64
    EX_UNARY,                 // op arg[0]          (op is NOT or NEG: a unary plus has no node)
    EX_BINARY,                // arg[0] op arg[1]   (also a single relation, a < b; a < b < c is a CHAIN)
    EX_CHAIN,                 // arg[0] ops[0] arg[1] ops[1] arg[2] …: relations only; true if all of them are
    EX_CALL,                  // fn(arg …), a function without side effects
    EX_ROLL,                  // statistic `stat` of window `window`; arg[0] is the sampled expression
    // Only scripts have the following kinds, and no engine evaluates them.
    EX_EVERY,                 // whether `var`, which is G, is a multiple of `number`
    EX_AT,                    // whether `var`, which is G, equals `number`: one node, because a script can have a million of such guards
    EX_RANDOM                 // the value of random call number `window` + 1 in this step
} ExprKind;

struct Expr {                 // "CALL:" marks a field that only EX_CALL has.  Bit fields save memory, because a program is mostly Exprs
    ExprKind kind : 8;
    SmOperator op : 8;        // UNARY, BINARY: the operator
    SmBuiltin fn : 8;         // CALL: the function
    SmStat stat : 8;          // ROLL: the statistic
    uint32_t n : 24;          // number of arguments
    TimeUnit unit : 8;        // NUMBER: the unit that it is written with
    Span span;
    SmF64 number;
    Var *var;
    uint32_t window;          // ROLL: index into the owner's window list; AT: the length of the name of G at the start of `span`, 0: it is not
                              // written; NUMBER: 1 if it is the number of a state, written as the state's name
    uint32_t define;          // if this is the use of a definition with a unit: 1 + the number of that definition; else 0
    Expr *arg[];              // n operands; in a CHAIN, n - 1 operators follow them (expr_ops)
};

static inline SmOperator *expr_ops(const Expr *e) { return (SmOperator *)(void *)(e->arg + e->n); }      // CHAIN

// The window of one roll call in the source.  Every call has its own Window; the IR builder merges equal windows.
typedef struct Window {
    Expr *sample;             // the sampled expression; in a window of times, an event: 0 or not 0
    uint32_t size;            // the argument n, number of samples: 1 … SM_WINDOW_MAX
    SmStat stat;
    const Var *time;          // only in a window of times (SM_STATS_OF_TIMES): G
    uint64_t gap;             // only for the run of `held`: the run restarts if G has advanced by more than this since the last step; 0: never
    uint32_t clock;           // only with a gap: index of the window (SM_STAT_ELAPSED) with the times of the last two steps
    Span span;
    bool in_time;             // the call was written with a time instead of n: (size - 1) * Program.step
} Window;

typedef VEC(Window) Windows;  // a roll call inside another one comes first, so sample windows in index order

// ---- the machine ----

typedef struct State State;
typedef struct Stmt Stmt;
typedef VEC(Stmt *) Stmts;

typedef enum StmtKind { ST_ASSIGN, ST_IF, ST_TRANSITION } StmtKind;

struct Stmt {
    StmtKind kind;
    uint32_t number;          // 1, 2, 3 … in file order, over the whole machine or script
    Span span;                // the statement; for an IF only up to the end of its guard
    uint32_t operators;       // 1u << SmOperator for each operator in `value`; lets analyses skip the other statements
    bool varies;              // `value` reads an element, T or a statistic, so it is not constant
    Var *var;                 // ASSIGN: the variable that is written
    Expr *value;              // ASSIGN: converted to var's type; IF: converted to bool
    Stmts then, otherwise;    // IF: the branches
    State *target;            // TRANSITION: the next state
};

typedef enum BlockKind { BLOCK_ENTRY, BLOCK_STEP, BLOCK_EXIT, BLOCK_COUNT } BlockKind;

struct State {
    Str name;
    uint32_t number;          // 1, 2, 3 … in file order
    Stmts block[BLOCK_COUNT];
    Span block_span[BLOCK_COUNT];     // position of the label; src is NULL if the state lacks the block
    Span span;                // position of the name in its header
    bool is_abort;            // @abort: the machine goes here after a fault
    bool is_safe;             // @safe: the machine may stay here forever
    bool allows_swap;         // @swap: the machine may be replaced here while it runs
};

struct AstSection;

// A section [all_states]: its statements are the first of .step of each state that it does not except.
typedef struct AllStates {
    const struct AstSection *section;     // the syntax tree of the section, valid only during the check
    Span span;                // the whole section
    bool *excepted;           // by State.number: the section does not run in this state
    bool *proposed;           // by State.number: an edit that adds the state to the section's @except has been proposed
    uint32_t copies;          // number of states for which its statements have been checked so far
} AllStates;

enum { MODE_ENABLED = 2 };    // a machine steps while the element of its @mode has this value (config.md 10.16): SM_ENABLED of runtime-c/task.h

// A machine of an application, in the Program that joins all of them for a script.
typedef struct Member {
    Str name;
    const struct Program *program;
    const Var **var;          // by Var.index of `program`: the variable in the joined Program
    Var *s, *t;               // the elements that are S and T of this machine
    uint32_t first;           // its states are Program.state[first] and the following
    const State *initial;     // a state of `program`
    const Var *mode;          // the element of its @mode in the joined Program; or NULL
    uint64_t every;           // the machine steps once in this many ticks (Joint.tick)
} Member;

typedef struct MemberStart { const Var *var; uint64_t cell; } MemberStart;

// How the machines of an application run in one script (language.md 8.71 to 8.83).
typedef struct Joint {
    VEC(Member) member;       // in the order in which they step in a tick
    VEC(MemberStart) start;   // the values of [start]
    uint64_t tick, unit;      // in nanoseconds: the time between two ticks; the duration of one unit of G
    const struct App *app;
} Joint;

// @req on a state or a statement: it implements a requirement (requirements.md 13.19).  Only reports read it.
typedef struct RequirementMark {
    Str requirement;          // the id of the requirement
    const State *state;       // the state that has the mark, or its statement; NULL: a section [all_states]
    bool is_statement;        // the mark follows a statement, or a transition
    const Stmt *stmt;         // the marked statement, in [all_states] its first copy; NULL: the mark is on a state or a section
    Span span;                // the annotation
} RequirementMark;

typedef struct Program {
    Str stem;                 // the file's name without folder and extension: "tank" for dir/tank.sm
    Str name;                 // the stem; for a machine with bindings, its name in the application
    const Source *src;
    StateVec *sv;
    VEC(Var *) var;           // listed elements in order, then locals in order, then T
    Var *g, *s, *t;
    VEC(State *) state;       // at[0] is number 1, the initial state
    TimeUnit time_unit;       // the unit in which G counts: us, ms or s
    bool uses_time_unit;      // the behaviour depends on time_unit: the machine contains a time literal, or declares a step
    uint64_t step;            // how much G advances in a step; 0: not declared
    Span step_span;           // position of the value of step in [options]
    uint32_t operators;       // 1u << SmOperator for each operator in the program; analyses that find nothing without an operator return early
    bool has_units;           // a variable or definition has an @unit
    bool large_numbers;       // the program contains a literal of 2^53 or more
    uint32_t stmts;           // statements in all blocks: the largest Stmt.number
    Windows window;
    Defines define;
    VEC(AllStates *) all_states;      // in file order
    VEC(RequirementMark) mark;        // in the order in which the checker found them
    VEC(Allow) allow;         // the machine's own @allow annotations, and those of the .sv, which cover the line where the machine lists the element
    Map by_name;              // name or alias to Var
    Map state_by_name;
    const Joint *joint;       // set if this is the joined Program of an application; NULL: a machine.  In a joined Program s and t are NULL, and
                              // variables and states of a machine have names such as `deploy.T`
} Program;

// ---- the script ----

typedef enum ScriptAssertKind {
    SCRIPT_ASSERT,            // @assert: the condition is true after the step
    SCRIPT_FAIL,              // @fail: the guard is never true
    SCRIPT_EXPECT,            // @expect: the condition becomes true in time
    SCRIPT_PRINT              // @print: shows values, and tests nothing
} ScriptAssertKind;

// What an @assert, @fail, @expect or @print contains besides its condition.
typedef struct ScriptRemark {
    Span span;                // the whole item
    Str text, requirement;    // NULL: none
    uint64_t within;          // EXPECT: in how many units of G the condition must become true
    VEC(Expr *) printed;      // PRINT: the values that it shows
} ScriptRemark;

typedef struct ScriptAssert {
    ScriptAssertKind kind;
    Expr *condition;          // FAIL and PRINT: NULL
    const ScriptRemark *remark;       // ASSERT: NULL if it has neither text nor requirement
} ScriptAssert;

typedef struct ScriptItem ScriptItem;

// An assignment of a script.
typedef struct ScriptInput {
    Var *var;
    Expr *value;              // converted to var's type
    uint32_t at, len;         // offset and length of the assignment, in the source that contains ScriptItem.guard
} ScriptInput;

// The items of one body, up to the first conditional in it.  Such a conditional is an item of its own; so is what follows it in the body, with
// a guard that is always true.
struct ScriptItem {
    Expr *guard;
    const ScriptItem *parent; // the conditional around it; NULL: none
    uint32_t number;          // 0, 1, 2 … in file order, over the whole script
    uint32_t first_assert;    // number of asserts in the earlier items of the section
    uint32_t machine : 24;    // in the script of an application: 1 + the index of the machine in whose ticks the asserts are evaluated; 0: all
    bool otherwise : 1;       // the item is in the `else` of the parent
    bool by_time : 1;         // the guard is a guard by time, built by check_when
    bool stop : 1;            // the item's body ends with @stop
    uint32_t stop_at;         // offset of the @stop, in the source that contains `guard`
    VEC(ScriptInput) inputs;  // executed at once when the guard is true
    VEC(ScriptAssert) asserts;        // evaluated after the step, in order
};

static inline Span script_input_span(const ScriptItem *item, const ScriptInput *in) { return (Span){item->guard->span.src, in->at, in->len}; }
static inline Span script_stop_span(const ScriptItem *item) { return (Span){item->guard->span.src, item->stop_at, sizeof "@stop" - 1}; }

typedef struct ScriptSection {
    State *state;             // the state of the section; NULL for [all_states]
    uint32_t machine;         // ScriptItem.machine of all its items
    VEC(ScriptItem *) item;
} ScriptSection;

#define SCRIPT_SEED_MAX (UINT64_C(1) << 53)       // the largest seed: every number up to it is an F64

// A call of random(a, b) or noise(a) in the text of a script.
typedef struct ScriptRandom {
    bool is_noise;
    double a, b;              // the arguments; noise: only a
    Span span;                // position of its name
} ScriptRandom;

typedef VEC(ScriptRandom) ScriptRandoms;

// A new value for a parameter, set by a script, or by the caller that runs the script.
typedef struct ScriptSetting { const Var *parameter; uint64_t cell; Span span; } ScriptSetting;

// A column of recorded data: its value is cell * scale + offset.
typedef struct ScriptColumn {
    Var *var;                 // receives the value, or is compared with it
    Str name;                 // name of the column in the file
    Span span;                // position of that name in the script
    bool is_scaled;           // otherwise the value is the cell itself
    SmF64 scale, offset;
} ScriptColumn;

// A @compare: after the step at G, |var - column at G - delay| is at most `tolerance`.
typedef struct ScriptCompare {
    ScriptColumn column;
    SmF64 tolerance;
    uint64_t delay;           // in units of G
} ScriptCompare;

// The section [data] of a script.
typedef struct ScriptData {
    Span span;                // position of the header [data]
    Str file, time;           // the names of the file, and of the column with the times
    Span file_span, time_span;
    TimeUnit unit;            // unit of the times in the file
    bool is_linear;           // between two rows, values are interpolated; else the values of the earlier row are used
    bool stops_at_bad_time, skips_bad_times;      // the section has `on_bad_time error`; it has `on_bad_time skip`
    bool missing_is_nan;
    VEC(ScriptColumn) column; // columns that are written to variables
    VEC(ScriptCompare) compare;
    const struct DataFile *source;    // the file; set after checking
} ScriptData;

// A file that a script includes; include: the line of the script itself that includes the file, directly or through others.
typedef struct ScriptPart { const Source *src; Span include; } ScriptPart;

typedef struct Script {
    const Source *src;
    VEC(ScriptPart) part;     // the files that the script includes, in the order in which their sections run
    const Program *program;
    uint64_t delta_t;         // 0 if by_rows
    bool by_rows;             // `delta_t file`: one step for each row of the data
    ScriptData *data;         // NULL: the script has no [data]
    Span delta_t_span;        // position of the value of delta_t in [options]
    State *init_state;
    VEC(ScriptSetting) setting;       // the parameters that the script sets
    VEC(Var *) local;         // the variables of [local], in file order
    Defines define;           // in file order; their numbers follow those of the machine
    bool has_units;           // a variable or definition of the script has an @unit
    VEC(ScriptSection) section;       // in file order
    Windows window;           // the windows of the roll calls in all sections of the script
    ScriptRandoms random;     // the calls of random and noise, by their number from 0
    uint64_t seed;            // seed of the random numbers
} Script;

// Returns the index of the machine to which the state with this number in the joined Program belongs.
uint32_t joint_machine_of(const Joint *j, uint32_t number);
// What a machine does with one of its variables; of an application, what its machines do with it.
typedef struct JointUses { bool read, written, read_only; } JointUses;
JointUses program_uses_of(const Program *p, const Var *v);
// For a machine that steps once in `every` ticks: returns how many of its periods have ended when G is g.
uint64_t joint_periods_until(const Joint *j, uint64_t every, uint64_t g);

// ---- parameters ----

const char *parameter_refusal_text(SmRefusal refusal);       // returns why a value was refused, in the words of stdlib/parameters.def
bool program_has_parameters(const Program *p);
const Var *program_parameter(const Program *p, Str name);    // returns the parameter of this name; NULL: none
// Returns why a parameter cannot have the value x.  If it can, sets *cell to the value as a bit cell of its type.
SmRefusal parameter_judge(const Var *parameter, SmF64 x, uint64_t *cell);

// Whether two expressions apply the same operators to the same numbers, variables and statistics.  Equal expressions have the
// same value if no assignment is executed between their evaluations. window_of maps a Window number to an id that is equal for
// windows with equal contents (IrMachine.window_of); NULL: every window differs from the others.
bool expr_equal(const Expr *a, const Expr *b, const uint32_t *window_of);
// Whether two expressions apply the same operator or function to their operands, or are the same number or variable.  Of windows, only the
// statistic counts.
bool expr_is_same_operation(const Expr *a, const Expr *b);

// Calls f(x, context) for e and all its subexpressions, operands before the expression that owns them.
void expr_walk(Expr *e, void (*f)(Expr *e, void *context), void *context);

// Whether the value of e never changes: it contains only numbers, constant locals, operators and pure functions.
bool expr_is_constant(const Expr *e);
// Whether e is written as a negative number, as -100: its text is its value.
bool expr_is_negative_number(const Expr *e);
// Returns the value of a constant expression.  If e reads a local that is not constant, uses its initial value.
SmF64 expr_constant_value(const Expr *e);
// Returns the value of any expression for the given values of variables (by Var.index).  Assumes that every window is filled with
// its current sample.  NULL: uses the initial values.
SmF64 expr_eval(const Expr *e, const SmF64 *value);
// Appends the canonical name of what a window samples, as in `roll(tankPressure + 1, 10)` (swapping.md 12.11).  If the name has more than
// `most` characters, parts of it are left out, but more than `most` are still appended.
void expr_name_window(Arena *arena, const Windows *all, const Window *w, size_t most, Buf *out);
// Formats a value for messages, with the fewest digits from which the same number can be read back, but at least 6.
const char *const_text(Arena *arena, SmF64 x);

#endif
