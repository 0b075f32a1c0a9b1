// SPDX-License-Identifier: Apache-2.0
// Translation of one IR function to C.  lower.c decides which temporaries become part of the expressions that use them and which become
// variables.  expression.c writes expressions; flow.c finds the nesting of the blocks; code.c writes statements.
#ifndef SMC_EMIT_C_FN_H
#define SMC_EMIT_C_FN_H

#include "compiler/emit/c/unit.h"

typedef enum CForm {
    C_DEAD,                   // not needed
    C_INLINE,                 // part of the expression that uses it
    C_VARIABLE,               // has its own variable
    C_EFFECT                  // a statement
} CForm;

// What lower.c and expression.c know about an instruction.
typedef struct CIns {
    CForm form;
    Fact fact;                // its possible values
    uint32_t uses;            // number of uses by instructions that are neither dead nor constant
    uint32_t latest;          // position in its block of the last statement whose expression contains it
    uint32_t level;           // its depth in that statement's expression
    const char *variable;
    bool unchecked;           // the load of a float that needs no NaN check: it cannot be NaN, or no use distinguishes NaN from 0
    uint32_t nan_is_zero_uses;        // number of uses whose result is the same for NaN and 0
    bool is_masked;           // a comparison whose result does not matter when an operand is NaN or 0
    IrRef decided_by;         // the load that can decide this condition: if it reads NaN or 0, the condition is decided_value; or IR_NONE
    bool decided_value;
} CIns;

// How a function uses a variable of the machine.  Valid only if `stamp` is the function's.
typedef struct CVarUse {
    uint32_t stamp;
    uint32_t loads;           // number of uses of its value
    bool stored;
    bool as_double;           // some of them need an F32 as a double
    bool never_nan;           // the function stores it: after that, where block never_nan_from dominates, it is not NaN
    uint32_t never_nan_from;
    const char *copy;         // the function's own variable that holds a copy
    SmType copy_type;         // F64, F32, or the type of T
    uint32_t block_stamp;     // the block for which next_store is valid
    uint32_t next_store;      // position of the next store, seen from the current position of the walk through the block
    uint32_t flag_stamp;      // the block that has already recorded that it stores this
} CVarUse;

// Dominator tree with skip pointers, so that the nearest common dominator of two blocks is found in logarithmic time.
typedef struct CDominators {
    uint32_t *parent, *shortcut, *depth;
} CDominators;

// The structure of the control flow, as code.c writes it.  A branch on a constant is not one.
typedef struct CFlow {
    uint32_t n;               // number of blocks, plus one: the last represents the function's end
    uint32_t *then, *other;   // successors, with empty blocks skipped; IR_NONE: none
    bool *reached;
    uint32_t *preds;          // number of incoming edges
    uint32_t *kid, *sibling;  // by block: list, in order, of the join blocks of which it is the immediate dominator
    bool *falls;              // by block: an edge leads from a block that it dominates to one that it does not
    CDominators dominators;
} CFlow;

typedef struct CFn {
    CUnit *u;
    const IrFn *f;
    CFlow flow;
    CIns *ins;
    CVarUse *var;             // shared by the unit's functions, by variable
    uint32_t *window_sample;  // shared by the unit's functions, by window: as next_store
    uint32_t stamp;           // of this function
    uint32_t *block_stamps;   // the unit's counter of blocks
    uint32_t block;           // stamp of the current block
    VEC(uint32_t) copied;     // variables that have a copy
    VEC(uint32_t) stored;     // elements that the current block has stored
    Buf body;
    Buf line;                 // the statement under construction
    unsigned indent;
    unsigned values;          // number of variables so far
    Buf declarations;         // of those variables, if they must be at the top of the function
    bool hoist;               // declarations must be at the top, because labels are in use
    bool labels_used;
    bool *label;              // by block
    bool uses_m, uses_sv, writes_m, writes_sv;
    bool returns_state;
} CFn;

static inline const IrIns *c_ins(const CFn *fn, IrRef r) { return &fn->f->ins.at[r]; }
static inline bool c_is_const(const CFn *fn, IrRef r) { return c_ins(fn, r)->op == IR_const; }

// ---- flow.c ----
static inline bool c_is_branch(const CFn *fn, uint32_t b) { return fn->flow.other[b] != IR_NONE; }
void flow_init(CFn *fn);
bool flow_dominates(const CFlow *w, uint32_t a, uint32_t b);      // a and b must be reachable

// ---- lower.c ----
void lower_find_facts(CFn *fn, const Env *begin);       // must run first
void lower_function(CFn *fn);              // after flow_init

// ---- expression.c ----

static inline void c_write(CFn *fn, const char *text) { buf_str(&fn->line, text); }

enum {                                    // precedence of C's operators
    PREC_ANY = 0, PREC_OR = 4, PREC_AND = 5, PREC_EQ = 9, PREC_REL = 10, PREC_ADD = 12, PREC_MUL = 13, PREC_UNARY = 14, PREC_PRIMARY = 15
};

// Writes the temporary's value to fn->line, in parentheses if its precedence is below `prec`.
void c_write_value(CFn *fn, IrRef r, int prec);
// Writes the value of a float element as a float or a double.  A NaN is read as 0 wherever the difference is visible.
void c_write_float_load(CFn *fn, IrRef r, SmType as);
// Writes a bool as a condition of C.
void c_write_condition(CFn *fn, IrRef r, bool negated, int prec);
void c_write_compare(CFn *fn, const IrIns *i, bool negated, int prec);
void c_write_cell(CFn *fn, uint32_t var);                                 // m->x, sv->x
void c_write_time(CFn *fn);                                               // T: time minus the start of the state
void c_write_constant(CFn *fn, IrRef r, SmType type, uint64_t bits);      // with its name in the source, if it has one
const char *c_copy_name(CFn *fn, uint32_t var);
// Opens a parenthesis if an expression of precedence `own` appears where `wanted` is required; pass the result to c_close_parens.
bool c_open_parens(CFn *fn, int own, int wanted);
void c_close_parens(CFn *fn, bool opened);

// ---- convert.c ----

void c_write_cvt(CFn *fn, const IrIns *i, int prec);
// Writes the value, whatever its type, as a double.
void c_write_double(CFn *fn, IrRef r, int prec);
// Writes the value where C converts it implicitly to the temporary's type: in an assignment or an argument.
void c_write_assigned(CFn *fn, IrRef r);
// Whether r is an inlined conversion of an integer to an integer type that can represent all its values.
bool c_is_widening(const CFn *fn, IrRef r);
// Writes the truth of a number that is never NaN.
void c_write_not_zero(CFn *fn, IrRef r, bool negated, int prec);

// ---- count.c ----

// If r, an F64 about to be converted to `to`, is the next value of a counter, writes that and returns true.
bool c_write_count(CFn *fn, IrRef r, SmType to);
// If the store increments its own variable by one and numbers are soft, writes that and returns true.
bool soft_write_count(CFn *fn, const IrIns *store);

// ---- code.c ----

// Ends the statement in fn->line.
void c_end_line(CFn *fn);

// ---- soft.c: replaces C's operators and casts on floats ----

bool c_is_soft(const CFn *fn, SmType t);               // t is a float type and numbers are SmF64
void soft_write_number(CFn *fn, IrRef r);              // an integer or F32, not a constant, as an SmF64
void soft_write_cast(CFn *fn, SmType to, IrRef r);     // a float that fits to an integer; any type to F32
void soft_write_binary(CFn *fn, const IrIns *i);
void soft_write_compare(CFn *fn, const IrIns *i, bool negated);
// Writes a comparison of a variable with a constant that needs only some bytes of the variable, and returns true; false if i is not one.
bool soft_write_byte_compare(CFn *fn, const IrIns *i, bool negated);
// Whether soft_write_byte_compare will handle comparison i, whose operand x is the load of a float: a NaN then counts as 0.
bool soft_compares_bytes(const CFn *fn, const IrIns *i, IrRef x);
void soft_write_not_zero(CFn *fn, IrRef r, bool negated);

// ---- window.c ----

void c_write_sample(CFn *fn, const IrIns *i);
// Whether the window itself treats a NaN sample as 0.
bool c_window_reads_nan(const CFn *fn, const IrIns *i);
void c_write_stat(CFn *fn, const IrIns *i);

#endif
