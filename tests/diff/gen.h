// SPDX-License-Identifier: Apache-2.0
// Random programs that are valid by construction, and the inputs with which they run.  The programs are trees, which can be printed, changed and
// reduced.  Everything about a case follows from its seed.
//
// The generator has its own trees and its own printer: it shares no code with the parser that it tests.
#ifndef SM_DIFF_GEN_H
#define SM_DIFF_GEN_H

#include <stdbool.h>
#include <stdint.h>

#include "compiler/base/arena.h"
#include "compiler/base/buf.h"
#include "compiler/base/vec.h"
#include "stdlib/types.h"

// ---- random numbers ----

typedef struct Rng { uint64_t state; } Rng;

uint64_t rng_mix(uint64_t a, uint64_t b);             // a number that depends on both and looks random
uint64_t rng_u64(Rng *r);
uint32_t rng_below(Rng *r, uint32_t n);               // 0 … n - 1
bool rng_percent(Rng *r, uint32_t percent);

// ---- the program ----

typedef struct GVar {
    uint32_t id;              // constant for a variable, also after others are removed: the inputs depend on it
    SmType type;
    const char *name;
    const char *alias;        // or NULL
    const char *old_name, *old_alias;         // as the variable is named in the unchanged program
    bool is_local;
    bool read_only;
    bool outside;             // the test writes the variable between steps
    uint32_t region;          // element: its region in the .sv
    bool listed;              // element: the machine lists it; all other elements only take up room in the .sv
    bool removed;             // the reducer has removed it
    uint32_t roll_size;       // local: its value, if that can be part of the size of a window; otherwise 0
    struct GExpr *init;       // local
    bool parameter;           // local: it is a parameter, with these values
    double lo, hi, standard, set;
    bool is_set;              // an input sets the parameter before the first step
} GVar;

typedef enum GExprKind {
    G_NUMBER, G_VAR, G_TIME, G_UNARY, G_BINARY, G_CHAIN, G_CALL, G_ROLL,
    // The kinds that only additions contain (gen_additions.c):
    G_DEFINED,                // the name of a definition
    G_STATE,                  // the name of a state, as an operand in a comparison with S
    G_SPAN,                   // a time, such as 1.5 s
    G_STEPS                   // n steps, as the size of a window
} GExprKind;

typedef struct GExpr GExpr;
struct GExpr {
    GExprKind kind;
    const char *text;         // NUMBER: its digits; SPAN: the time as a number of units of G
    const char *span;         // SPAN: the time with its unit, as printed
    GVar *var;                // VAR
    bool by_alias;            // VAR
    SmOperator op;            // UNARY, BINARY
    SmOperator ops[4];        // CHAIN
    SmBuiltin fn;             // CALL, ROLL: arg[1] is the size
    struct GDef *def;         // DEFINED
    struct GState *state;     // STATE
    uint32_t samples;         // SPAN that is the size of a window: the number of samples in that time
    uint32_t n;
    GExpr *arg[SM_LIST_MAX];
};

typedef struct GStmt GStmt;
typedef VEC(GStmt *) GStmts;
typedef enum GStmtKind { G_ASSIGN, G_IF, G_GOTO } GStmtKind;

struct GStmt {
    GStmtKind kind;
    GVar *var;                // ASSIGN
    bool by_alias;
    GExpr *value;             // ASSIGN, IF
    GStmts then, otherwise;   // IF
    bool has_else;
    struct GState *target;    // GOTO
};

typedef struct GState {
    const char *name, *old_name;
    GStmts block[3];          // entry, step, exit
    bool present[3];
    bool removed;
} GState;

// A line of [define].
typedef struct GDef {
    const char *name, *old_name;
    GExpr *value;
    uint32_t size;            // number of nodes of the expression with its definitions expanded
    bool constant;            // the expression contains only numbers
    bool is_size;             // it is used as the size of a window
    bool removed;
} GDef;

// A section [all_states].
typedef struct GRule {
    GStmts block;
    VEC(GState *) except;
    uint32_t before;          // index of the state that it precedes in the file
    bool removed;
} GRule;

typedef enum GUnit { UNIT_US, UNIT_MS, UNIT_S, UNIT_COUNT } GUnit;

enum { GEN_RECENT = 8, GEN_REGIONS_MAX = 4, GEN_STEPS_MAX = 1000, GEN_VARS_MAX = 64 };

typedef struct Gen {
    Arena *arena;
    uint64_t seed;
    Rng rng;                          // random numbers of the generation
    uint32_t mood;                    // which numbers are preferred: 0 small ones, 1 all
    bool with_sv;                     // the elements are declared in a separate .sv
    uint32_t regions;
    const char *region_name[GEN_REGIONS_MAX];
    const char *machine_name, *old_machine_name;      // the name of the .sm without its folder and suffix
    VEC(GVar *) var;                  // in order of declaration; var.at[0] is G and var.at[1] is S, wherever the program declares them
    VEC(GVar *) order;                // the elements as the machine lists them, then the locals
    VEC(GVar *) sv_order;             // the elements as the .sv declares them
    VEC(GState *) state;
    VEC(const char *) used_name;
    bool additions;                   // the fields up to `by_hand` are used
    VEC(GDef *) def;                  // in the order of the file
    VEC(GRule *) rule;
    GUnit unit;                       // of G
    bool writes_unit;                 // the unit of G is printed even if it is the default
    uint32_t step;                    // the step, in units of G; 0: none
    bool units;                       // many declarations are printed with an @unit
    uint64_t units_printed;           // number of units printed so far
    bool by_hand;                     // printed with every addition written out by hand, which has the same meaning
    GExpr *last_roll;                 // the last window, from which similar ones are generated
    GExpr *last_guard;                // the last guard that compares a variable with a number, from which similar ones are generated
    GExpr *recent[GEN_RECENT];        // recent expressions, which may be repeated
    size_t recents;                   // number of expressions remembered, also of those that `recent` no longer has
    uint64_t layout, old_layout;      // seed of blanks, comments and braces: another seed prints the same program in another form
    uint32_t steps;
    bool skip[GEN_STEPS_MAX];         // steps that the reducer has removed
    uint64_t now[GEN_STEPS_MAX];      // G before each step
    uint32_t first_state;             // index
    uint32_t states;                  // number of states when the program was generated
    bool plain;                       // printed in the plainest form, without random choices
} Gen;

Gen *gen_program(Arena *arena, uint64_t seed, uint32_t steps);
GVar *gen_new_local(Gen *g, SmType type);     // appended last, without an initial value
void gen_add_parameters(Gen *g);
void gen_random_range(Gen *g, GVar *v);       // of a parameter, around its default
bool gen_sets_parameter(const Gen *g);        // whether an input sets a parameter to a value that is not its default
uint64_t gen_parameter_cell(const GVar *v);   // the value to which an input sets it
const char *gen_new_name(Gen *g);     // a name that the program does not use
void gen_random_state(Gen *g, GState *s);     // fills its blocks
void gen_random_stmts(Gen *g, GStmts *list, uint32_t n, uint32_t depth, bool may_leave);
bool gen_seed_has_additions(uint64_t seed);
// Sets the flag of each kind of expression that a program contains, and whether a window's size is a time.
void gen_additions_used(const Gen *g, bool *used, bool *window_in_time);
bool gen_additions_sample(const Gen *g);              // a definition or a rule contains a window
uint32_t gen_samples_in_time(const GExpr *size);      // of a window; 0 if its size is no time
void gen_add(Gen *g);                 // replaces parts of a program by equal notations that can be written out by hand: gen_additions.c

uint32_t gen_state_number(const Gen *g, uint32_t index);      // the number that the compiler assigns to the state
void gen_plan_time(Gen *g);           // fills `now`

void gen_print_sv(Gen *g, Buf *out);
void gen_print_sm(Gen *g, Buf *out);
// Prints a machine that computes the initial values in its first step, by assignments.
void gen_print_inits(Gen *g, Buf *out);

// ---- shapes that the optimiser searches (gen_shapes.c) ----

bool gen_can_vary(const GExpr *e);                     // whether its value can change; if not, median and average treat it as a constant
GExpr *gen_expr_new(Gen *g, GExprKind kind, uint32_t n);
GExpr *gen_shape(Gen *g);             // an expression that is valid anywhere in a machine's code
GExpr *gen_plain_guard(Gen *g);
void gen_remember(Gen *g, GExpr *e);  // the expression may be repeated later

// ---- inputs ----

typedef struct GInput { GVar *var; uint64_t cell; } GInput;

// Fills *out with the values that the test writes before step k, that of G included.  Returns their number.  `out` has room for every variable.
uint32_t gen_inputs(const Gen *g, uint32_t k, GInput *out);
// Whether the machine is initialized again before step k, and in which state (an index into `state`).
bool gen_restarts(const Gen *g, uint32_t k, uint32_t *state);

// Returns a value that is likely to show errors in a type: limits, zeros, NaN, infinities, small and random values.
uint64_t gen_cell(Rng *r, SmType type, uint32_t mood);
const char *gen_number(Arena *arena, Rng *r, uint32_t mood);

// ---- changes that must not change a trace ----

typedef enum GChange { CHANGE_NAMES, CHANGE_LAYOUT, CHANGE_DEAD_STATE, CHANGE_BY_HAND, CHANGE_COUNT } GChange;
extern const char *const gen_change_name[CHANGE_COUNT];
void gen_change(Gen *g, GChange what);
void gen_change_back(Gen *g);         // undoes the last change

#endif
