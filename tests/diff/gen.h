// SPDX-License-Identifier: Apache-2.0
// Random programs that are valid by construction, as trees that can be printed, changed and made smaller, and the inputs
// they are run with.  Everything about a case follows from its seed.
//
// The trees are this generator's own, as is the printing: nothing here shares code with the parser it feeds.
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
    uint32_t id;              // does not change when others are removed: inputs depend on it
    SmType type;
    const char *name;
    const char *alias;        // or NULL
    const char *old_name, *old_alias;         // before a change
    bool is_local;
    bool read_only;
    bool outside;             // the test writes it between steps
    uint32_t region;          // element: its region in the .sv
    bool listed;              // element: the machine lists it; others only fill the .sv
    bool removed;             // by the reducer
    uint32_t roll_size;       // local: its value, if it can be part of the size of a window; else 0
    struct GExpr *init;       // local
    bool parameter;           // local: with these values
    double lo, hi, standard, set;
    bool is_set;              // an input sets it before the first step
} GVar;

typedef enum GExprKind {
    G_NUMBER, G_VAR, G_TIME, G_UNARY, G_BINARY, G_CHAIN, G_CALL, G_ROLL,
    // of the additions (gen_additions.c):
    G_DEFINED,                // the name of a definition
    G_STATE,                  // the name of a state, beside S
    G_SPAN,                   // a time, such as 1.5 s
    G_STEPS                   // n steps, as the size of a window
} GExprKind;

typedef struct GExpr GExpr;
struct GExpr {
    GExprKind kind;
    const char *text;         // NUMBER; SPAN: as a number of units of G
    const char *span;         // SPAN: with its unit
    GVar *var;                // VAR
    bool by_alias;            // VAR
    SmOperator op;            // UNARY, BINARY
    SmOperator ops[4];        // CHAIN
    SmBuiltin fn;             // CALL, ROLL: arg[1] is the size
    struct GDef *def;         // DEFINED
    struct GState *state;     // STATE
    uint32_t samples;         // SPAN that is the size of a window: how many those are
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
    uint32_t size;            // of the expression, with its definitions expanded
    bool constant;            // consists of numbers alone
    bool is_size;             // of a window
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
    Rng rng;                          // while generating
    uint32_t mood;                    // what numbers it likes: 0 small ones, 1 all
    bool with_sv;                     // the elements are in a .sv of their own
    uint32_t regions;
    const char *region_name[GEN_REGIONS_MAX];
    const char *machine_name, *old_machine_name;      // the file's stem
    VEC(GVar *) var;                  // in order of declaration; var.at[0] is G, var.at[1] is S, wherever they stand
    VEC(GVar *) order;                // the elements as the machine lists them, then the locals
    VEC(GVar *) sv_order;             // the elements as the .sv declares them
    VEC(GState *) state;
    VEC(const char *) used_name;
    bool additions;                   // the fields to `by_hand` are used
    VEC(GDef *) def;                  // in the order of the file
    VEC(GRule *) rule;
    GUnit unit;                       // of G
    bool writes_unit;                 // also where it is the default
    uint32_t step;                    // in units of G; 0: none
    bool units;                       // printed with an @unit at many declarations
    uint64_t units_printed;           // how many so far
    bool by_hand;                     // printed without additions, with the same meaning
    GExpr *last_roll;                 // for others that are nearly the same
    GExpr *last_guard;                // a variable, a relation and a number, likewise
    GExpr *recent[GEN_RECENT];        // to be repeated
    size_t recents;                   // how many there were
    uint64_t layout, old_layout;      // blanks, comments, braces: another one is the same program
    uint32_t steps;
    bool skip[GEN_STEPS_MAX];         // steps that the reducer left out
    uint64_t now[GEN_STEPS_MAX];      // G before each step
    uint32_t first_state;             // index
    uint32_t states;                  // as generated
    bool plain;                       // printed without whims
} Gen;

Gen *gen_program(Arena *arena, uint64_t seed, uint32_t steps);
GVar *gen_new_local(Gen *g, SmType type);     // the last one, without an initial value
void gen_add_parameters(Gen *g);
void gen_random_range(Gen *g, GVar *v);       // of a parameter, around its default
bool gen_sets_parameter(const Gen *g);        // whether an input sets one to another value than its default
uint64_t gen_parameter_cell(const GVar *v);   // the value to which an input sets it
const char *gen_new_name(Gen *g);     // not used yet
void gen_random_state(Gen *g, GState *s);     // fills its blocks
void gen_random_stmts(Gen *g, GStmts *list, uint32_t n, uint32_t depth, bool may_leave);
bool gen_seed_has_additions(uint64_t seed);
// Sets the flag of each kind of expression that a program contains, and whether a window's size is a time.
void gen_additions_used(const Gen *g, bool *used, bool *window_in_time);
bool gen_additions_sample(const Gen *g);              // a definition or a rule contains a window
uint32_t gen_samples_in_time(const GExpr *size);      // of a window; 0 if its size is no time
void gen_add(Gen *g);                 // makes a program use what can also be written out by hand: gen_additions.c

uint32_t gen_state_number(const Gen *g, uint32_t index);      // as the compiler will number it
void gen_plan_time(Gen *g);           // fills `now`

void gen_print_sv(Gen *g, Buf *out);
void gen_print_sm(Gen *g, Buf *out);
// A machine that works the initial values out in its first step, by assignments.
void gen_print_inits(Gen *g, Buf *out);

// ---- shapes that the optimiser searches (gen_shapes.c) ----

bool gen_can_vary(const GExpr *e);                     // whether its value can change: it is then no constant for median and average
GExpr *gen_expr_new(Gen *g, GExprKind kind, uint32_t n);
GExpr *gen_shape(Gen *g);             // an expression that may stand anywhere in a machine's code
GExpr *gen_plain_guard(Gen *g);
void gen_remember(Gen *g, GExpr *e);  // it may come again

// ---- inputs ----

typedef struct GInput { GVar *var; uint64_t cell; } GInput;

// What the test writes before step k; G is among it.  Gives how many; `out` has room for every variable.
uint32_t gen_inputs(const Gen *g, uint32_t k, GInput *out);
// Whether the machine is initialized again before step k, and in which state (an index into `state`).
bool gen_restarts(const Gen *g, uint32_t k, uint32_t *state);

// A cell that a type likes: ends of ranges, zeros, NaN, infinities, small and random ones.
uint64_t gen_cell(Rng *r, SmType type, uint32_t mood);
const char *gen_number(Arena *arena, Rng *r, uint32_t mood);

// ---- changes that must not change a trace ----

typedef enum GChange { CHANGE_NAMES, CHANGE_LAYOUT, CHANGE_DEAD_STATE, CHANGE_BY_HAND, CHANGE_COUNT } GChange;
extern const char *const gen_change_name[CHANGE_COUNT];
void gen_change(Gen *g, GChange what);
void gen_change_back(Gen *g);         // undoes the last change

#endif
