// SPDX-License-Identifier: Apache-2.0
// The typed program: what the checker makes of an AST that has no errors.  Every name is bound, every number exact, every
// element placed; aliases, parentheses and operator spelling are gone.  Read by the reference interpreter, the IR builder,
// the script engine and reports; changed by nobody.
#ifndef SMC_PROGRAM_H
#define SMC_PROGRAM_H

#include <stdbool.h>
#include <stdint.h>

#include "compiler/base/source.h"
#include "compiler/base/str.h"
#include "compiler/base/vec.h"
#include "stdlib/types.h"

// ---- the state vector ----

typedef struct Region Region;

// @range: what a sensor delivers while it is healthy.  Nothing relies on it but reports.
typedef struct Range {
    SmF64 lo, hi;             // lo <= hi, both finite
    Span span;                // the annotation
} Range;

// @allow(flag, "reason"): findings of this name in this part of the source are known and wanted.
typedef struct Allow {
    const char *flag;         // the warning's name behind -W
    Str reason;
    Span span;                // the annotation
    Span covers;              // the declaration, the state's whole section, or the statement with all that is in it
} Allow;

typedef struct Element {
    Str name;
    SmType type;
    bool untyped;             // no type stands there; that was reported
    const Range *range;       // or NULL
    bool command;             // @command: a person operates it
    uint32_t first_allow, allows;     // StateVec.allow: those that stand behind it
    uint32_t index;           // its place in StateVec.element
    uint32_t offset;          // bytes from the start of the state vector in memory (layout.c)
    Region *region;
    Span span;                // its name where it is declared
} Element;

struct Region {
    Str name;
    uint32_t offset, size;    // in memory; size ends with the last element
    uint32_t packed_size;     // on the wire
    uint32_t first, count;    // its elements: StateVec.element.at[first …]
    Span span;
};

typedef struct StateVec {
    Str name;                 // the .sv file's stem, or the machine's when its own section is the whole vector
    bool lock;
    bool from_machine;        // no .sv was given: [state_vector] of the machine is the vector, one region of that name
    VEC(Element *) element;   // in declaration order
    VEC(Region *) region;
    VEC(Allow) allow;         // of a .sv: what stands behind its elements
    Map by_name;              // name to Element
    uint32_t size;            // bytes in memory, a multiple of 8
    uint32_t hash;            // of names, types and order: machines are bound to a layout by it
} StateVec;

// ---- variables ----

typedef enum VarKind {
    VAR_ELEMENT,              // of the state vector
    VAR_LOCAL,
    VAR_TIME                  // T
} VarKind;

typedef struct Expr Expr;

typedef struct Var {
    VarKind kind;
    Str name;                 // as listed
    Str alias;                // or NULL
    Str report_name;          // the name it has in reports: of name and alias the one that comes first in ASCII
    SmType type;
    uint32_t index;           // in Program.var
    Element *element;         // ELEMENT
    const Range *range;       // ELEMENT: given here, or with the element in the .sv; or NULL
    bool read_only;           // the machine may not write it; true for G, S and T
    bool command;             // ELEMENT: marked @command, here or in the .sv
    uint64_t init;            // LOCAL: its initial value, as a bit cell of its type (convert.h)
    Expr *init_value;         // LOCAL: what init was worked out from
    bool outside;             // LOCAL: somebody beside the machine writes it between steps (a state script)
    bool is_constant;         // LOCAL: read-only and not written from outside: `init` is its value for ever
    bool written;             // an assignment to it stands somewhere in the machine
    bool read;                // it is read somewhere in the machine
    bool sizes;               // LOCAL: the size of a window is made of it
    Span span;                // its name where it is listed
} Var;

// ---- expressions: every value is an F64 ----

typedef enum ExprKind {
    EX_NUMBER,                // number
    EX_VAR,                   // var, read as F64
    EX_UNARY,                 // op arg[0]          (NOT NEG; PLUS is gone)
    EX_BINARY,                // arg[0] op arg[1]   (no chain: its operands are evaluated once each)
    EX_CHAIN,                 // arg[0] ops[0] arg[1] ops[1] arg[2] …: relations only, all must hold
    EX_CALL,                  // fn(arg …), pure
    EX_ROLL                   // statistic `stat` of window `window`; arg[0] is the sampled expression
} ExprKind;

struct Expr {                 // without gaps: a program is mostly these
    ExprKind kind : 8;
    SmOperator op : 8;        // UNARY, BINARY
    SmBuiltin fn : 8;         // CALL
    SmStat stat : 8;          // ROLL
    uint32_t n;               // arguments
    Span span;
    SmF64 number;
    Var *var;
    Expr **arg;               // they stand behind this, and in a CHAIN n - 1 operators behind them
    uint32_t window;          // ROLL: index into the owner's window list
};

static inline SmOperator *expr_ops(const Expr *e) { return (SmOperator *)(void *)(e->arg + e->n); }      // CHAIN

// One roll call of the source.  Every call has its own; sharing is the IR builder's business.
typedef struct Window {
    Expr *sample;             // what it samples
    uint32_t size;            // n: 1 … SM_WINDOW_MAX
    SmStat stat;
    Span span;
} Window;

typedef VEC(Window) Windows;  // in an order in which inner calls come before outer ones: sample them in index order

// ---- the machine ----

typedef struct State State;
typedef struct Stmt Stmt;
typedef VEC(Stmt *) Stmts;

typedef enum StmtKind { ST_ASSIGN, ST_IF, ST_TRANSITION } StmtKind;

struct Stmt {
    StmtKind kind;
    uint32_t number;          // 1, 2, 3 … in file order, in all of the machine, or of the script
    Span span;                // of an IF up to the end of its guard
    uint32_t operators;       // 1u << SmOperator of each that stands in `value`: who looks for one need not look at the others
    bool varies;              // `value` reads an element, T or a statistic, so it is no constant
    Var *var;                 // ASSIGN: what is written
    Expr *value;              // ASSIGN: converted to var's type; IF: converted to bool
    Stmts then, otherwise;    // IF
    State *target;            // TRANSITION
};

typedef enum BlockKind { BLOCK_ENTRY, BLOCK_STEP, BLOCK_EXIT, BLOCK_COUNT } BlockKind;

struct State {
    Str name;
    uint32_t number;          // 1, 2, 3 … in file order
    Stmts block[BLOCK_COUNT];
    Span block_span[BLOCK_COUNT];     // the label; at no source where the block is missing
    Span span;                // the name in its header
    bool is_abort;            // @abort: where the machine goes when something is wrong
    bool is_safe;             // @safe: it may stay here for good
};

typedef struct Program {
    Str name;                 // the file's stem: "tank" of dir/tank.sm
    const Source *src;
    StateVec *sv;
    VEC(Var *) var;           // listed elements in order, then locals in order, then T
    Var *g, *s, *t;
    VEC(State *) state;       // at[0] is number 1, the initial state
    uint32_t operators;       // 1u << SmOperator of each that stands in it: analyses without any work look no further
    bool large_numbers;       // a literal of 2^53 or more does
    uint32_t stmts;           // statements in all its blocks: the largest Stmt.number
    Windows window;
    VEC(Allow) allow;         // those of the .sv are there once more, covering the element where it is listed
    Map by_name;              // name or alias to Var
    Map state_by_name;
} Program;

// ---- the script ----

typedef struct ScriptItem {   // one conditional
    Expr *guard;
    Span span;
    Stmts inputs;             // ST_ASSIGN, executed at once when the guard is true
    VEC(Expr *) asserts;      // judged after the step, in order
    bool stop;                // @stop stands last
    Span stop_span;
} ScriptItem;

typedef struct ScriptSection {
    State *state;             // NULL for [all_states]
    VEC(ScriptItem) item;
} ScriptSection;

typedef struct Script {
    const Source *src;
    const Program *program;
    uint64_t delta_t;
    Span delta_t_span;        // its value in [options]
    State *init_state;
    VEC(ScriptSection) section;       // in file order
    Windows window;           // the script's own, of all sections
} Script;

// Whether two expressions are the same operators on the same numbers, variables and statistics: they have one value wherever
// nothing is assigned between them.  window_of: by Window number, something that is equal for windows that hold the same
// (IrMachine.window_of).
bool expr_equal(const Expr *a, const Expr *b, const uint32_t *window_of);

// Calls f(x, context) for e and every expression in it, operands before their owner.
void expr_walk(Expr *e, void (*f)(Expr *e, void *context), void *context);

// Whether e has one value for ever: it is made of numbers, constant locals, operators and pure functions.
bool expr_is_constant(const Expr *e);
// That value; of other locals than constant ones their initial value counts.
SmF64 const_eval(const Expr *e);
// The value of any expression where variables have these values (by Var.index) and every window holds its current sample alone.
SmF64 expr_eval(const Expr *e, const SmF64 *value);
// A value for messages: the fewest digits that give it back.
const char *const_text(Arena *arena, SmF64 x);

#endif
