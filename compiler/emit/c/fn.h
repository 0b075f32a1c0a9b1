// SPDX-License-Identifier: Apache-2.0
// Translation of one IR function to C.  flow.c finds how the basic blocks nest.  lower.c decides which temporaries become subexpressions of
// the expressions that use them, and which become C variables.  expression.c writes expressions; code.c writes statements.
//
// Terms: a temporary is the result of an IR instruction, and IrRef is its index.  A float load is checked if the C code compares the value
// with NaN when it reads it, because the language reads a NaN as 0.
#ifndef SMC_EMIT_C_FN_H
#define SMC_EMIT_C_FN_H

#include "compiler/emit/c/unit.h"

// How an instruction appears in the emitted C.
typedef enum CForm {
    C_OMITTED,                // not as code of its own: a constant, which each use repeats, or an instruction whose result is not used
    C_SUBEXPRESSION,          // written inside each expression that uses it
    C_VARIABLE,               // a C variable that is initialised with its value
    C_STATEMENT               // a statement: a store or a window sample
} CForm;

// What lower.c and expression.c know about an instruction.
typedef struct CIns {
    CForm form;
    Fact fact;                // the possible values of its result
    uint32_t uses;            // number of operands and branch conditions that read its result, not counting those of omitted instructions
    uint32_t latest;          // position in its block of the last statement, variable or branch whose expression contains it
    uint32_t level;           // the greatest nesting depth of an expression that uses the value
    const char *variable;     // name of the C variable that holds its result; NULL: none, or not yet defined
    bool unchecked;           // the load of a float that needs no NaN check: it cannot be NaN, or no use distinguishes NaN from 0
    uint32_t nan_is_zero_uses;        // how many uses of its result have the same effect for NaN and 0
    uint32_t sign_free_uses;  // how many uses of its result have the same effect for 0 and -0
    bool is_named;            // for a condition: it becomes a C variable (name_conditions)
    bool is_masked;           // for a comparison: its result has no effect when an operand is NaN or 0
    IrRef decided_by;         // for a condition: a load that decides its value if it reads NaN or 0; IR_NONE: no such load
    bool decided_value;       // the value of the condition if `decided_by` reads NaN or 0
} CIns;

// How a function uses a variable of the machine.  Stale unless `stamp` equals the stamp of the current function, so that no function has to
// clear the entries of all variables.
typedef struct CVarUse {
    uint32_t stamp;
    uint32_t loads;           // number of uses of the results of its loads
    bool stored;              // the function stores the variable
    bool as_double;           // the variable is an F32, and some uses need it as a double
    // A store of the function sets the variable to a value that is not NaN.  So it is not NaN in the rest of the store's block and in all blocks
    // that this block dominates.  never_nan_from: the store's block.
    bool never_nan;
    uint32_t never_nan_from;
    const char *copy;         // name of the C variable into which the function copies the variable at its start; NULL: none
    SmType copy_type;         // F64, F32, or the type of T
    uint32_t block_stamp;     // stamp of the block for which next_store is valid
    uint32_t next_store;      // while lower.c walks the block backwards: position of the nearest store after the current instruction
    uint32_t flag_stamp;      // stamp of the last block whose stores have added the element to CFn.stored
} CVarUse;

// Dominator tree with skip pointers, so that the nearest common dominator of two blocks is found in logarithmic time.
typedef struct CDominators {
    uint32_t *parent, *shortcut, *depth;      // by block: immediate dominator; skip pointer to a dominator; depth in the tree
} CDominators;

// The control-flow graph as code.c writes it.  A branch on a constant counts as a jump.
typedef struct CFlow {
    uint32_t n;               // number of blocks, plus one: the last index is a virtual block, the end of the function
    uint32_t *then, *other;   // by block: the block's successors, where empty blocks are skipped; IR_NONE: none
    bool *reached;            // by block: the block is reachable
    uint32_t *preds;          // by block: number of incoming edges
    uint32_t *kid, *sibling;  // by block: the first join block that it immediately dominates; the next join block of the list that it is in
    bool *falls;              // by block: an edge leads from a block that this block dominates to a block that it does not dominate
    CDominators dominators;
} CFlow;

typedef struct CFn {
    CUnit *u;
    const IrFn *f;
    CFlow flow;
    CIns *ins;
    CVarUse *var;             // by variable: its use in the current function; the unit's functions share the array
    uint32_t *window_sample;  // by window: position in the block of the next instruction that samples it (CUnit.window_sample)
    uint32_t stamp;           // number that identifies this function in CVarUse.stamp
    uint32_t *block_stamps;   // the unit's counter of functions and blocks, from which stamps are taken
    uint32_t block;           // stamp of the current block
    VEC(uint32_t) copied;     // machine variables that have a CVarUse.copy
    VEC(uint32_t) stored;     // elements that the current block has stored
    Buf body;                 // the statements written so far
    Buf line;                 // the statement under construction
    unsigned indent;          // nesting level of the statement under construction
    unsigned values;          // number of C variables defined so far, not counting copies
    Buf declarations;         // if `hoist` is set: the declarations of C variables, except copies
    bool hoist;               // variables are declared at the top of the function, because gotos may not skip their initialisation
    bool labels_used;
    bool *label;              // by block: the block needs a label, because a goto leads to it
    bool uses_m, uses_sv, writes_m, writes_sv;
    bool returns_state;
} CFn;

static inline const IrIns *c_ins(const CFn *fn, IrRef r) { return &fn->f->ins.at[r]; }
static inline bool c_is_const(const CFn *fn, IrRef r) { return c_ins(fn, r)->op == IR_const; }

// ---- flow.c ----
// Whether block b ends in a branch on a condition that is not constant.
static inline bool c_is_branch(const CFn *fn, uint32_t b) { return fn->flow.other[b] != IR_NONE; }
// Computes fn->flow.
void flow_build(CFn *fn);
// Whether block a dominates block b.  Both must be reachable.
bool flow_dominates(const CFlow *w, uint32_t a, uint32_t b);

// ---- lower.c ----
// Computes CIns.fact of every instruction from the facts at the start of the function.  Must run before flow_build.
void lower_find_facts(CFn *fn, const Env *begin);
// Chooses CIns.form of every instruction, the float loads that need no check, and the copies.  Must run after flow_build.
void lower_choose_forms(CFn *fn);

// ---- expression.c ----

static inline void c_write(CFn *fn, const char *text) { buf_str(&fn->line, text); }

enum {                                    // precedence of C's operators
    PREC_ANY = 0, PREC_OR = 4, PREC_AND = 5, PREC_EQ = 9, PREC_REL = 10, PREC_ADD = 12, PREC_MUL = 13, PREC_UNARY = 14, PREC_PRIMARY = 15
};

// Writes the value of temporary r to fn->line, in parentheses if the precedence of the expression is below `prec`.
void c_write_value(CFn *fn, IrRef r, int prec);
// Writes the value of r, the load of a float element, as type `as`: SM_F32 or SM_F64.  A NaN is read as 0 wherever the difference is visible.
void c_write_float_load(CFn *fn, IrRef r, SmType as);
// Writes the bool r, or its negation, as a condition of C: any expression that is nonzero if it is true.
void c_write_condition(CFn *fn, IrRef r, bool negated, int prec);
void c_write_compare(CFn *fn, const IrIns *i, bool negated, int prec);
void c_write_member(CFn *fn, uint32_t var);                               // writes `m->x` for a local, `sv->x` for an element
void c_write_time(CFn *fn);                                               // writes T: `sv->g - m->start_`
void c_write_constant(CFn *fn, IrRef r, SmType type, uint64_t bits);      // writes a literal, and the name of the constant as a comment
// Returns a name for the C variable that holds a copy of the machine's variable `var`: the variable's own name if that cannot clash.
const char *c_copy_name(CFn *fn, uint32_t var);
// Writes `(` and returns true if an expression of precedence `own` needs parentheses where precedence `wanted` is required.  The result is
// the argument of c_close_parens.
bool c_open_parens(CFn *fn, int own, int wanted);
void c_close_parens(CFn *fn, bool opened);

// ---- convert.c ----

// Writes the conversion i of the language: a NaN becomes 0, and integers saturate.
void c_write_conversion(CFn *fn, const IrIns *i, int prec);
// Writes the value, whatever its type, as a double.
void c_write_double(CFn *fn, IrRef r, int prec);
// Writes r as the value of an assignment or an argument, where C converts it implicitly to the type of r.
void c_write_assigned(CFn *fn, IrRef r);
// Whether r is a conversion of an integer to an integer type that can represent all its values, and is written as a subexpression.
bool c_is_widening(const CFn *fn, IrRef r);
// Writes `r != 0`, or `r == 0` if negated, for a number r that is never NaN.
void c_write_nonzero_test(CFn *fn, IrRef r, bool negated, int prec);

// ---- count.c ----

// If r is a counter plus or minus a whole number, as an F64 that is about to be converted to the 64-bit integer type `to`, writes the
// converted sum as a call of a count helper and returns true.  Otherwise writes nothing and returns false.
bool c_try_write_count(CFn *fn, IrRef r, SmType to);
// If the store increments its own variable by one and numbers are soft, writes a call of sm_soft_increment and returns true.  Otherwise writes
// nothing and returns false.
bool soft_try_write_count(CFn *fn, const IrIns *store);

// ---- code.c ----

// Appends the statement in fn->line to fn->body, on several lines if it is long, and empties fn->line.
void c_end_line(CFn *fn);

// ---- soft.c: replaces C's operators and casts on floats ----

bool c_is_soft(const CFn *fn, SmType t);               // whether t is a float type and numbers are SmF64
void soft_write_to_f64(CFn *fn, IrRef r);              // writes an integer or F32 that is not a constant as an SmF64
void soft_write_cast(CFn *fn, SmType to, IrRef r);     // writes a float that is in range as an integer, or any number as an F32
void soft_write_binary(CFn *fn, const IrIns *i);       // writes an add, sub, mul or div of floats
void soft_write_compare(CFn *fn, const IrIns *i, bool negated);
// If i compares a variable with a constant and some bytes of the variable decide the result, writes a call that reads only those and returns
// true.  Otherwise writes nothing and returns false.
bool soft_try_write_byte_compare(CFn *fn, const IrIns *i, bool negated);
// Whether soft_try_write_byte_compare can write comparison i, whose operand x is the load of a float.  The call that it writes treats a NaN as 0.
bool soft_compares_bytes(const CFn *fn, const IrIns *i, IrRef x);
// Writes `r != 0`, or `r == 0` if negated, for a float r that is never NaN.
void soft_write_nonzero_test(CFn *fn, IrRef r, bool negated);

// ---- window.c ----

void c_write_ring_steps(CUnit *u, Buf *out);               // writes the beginning of the function that samples the windows: it advances the rings
void c_write_sample(CFn *fn, const IrIns *i);              // writes the statement that adds a sample to a rolling window
// Whether the function that adds sample i to its rolling window reads a NaN as 0, so that the caller need not check for it.
bool c_window_reads_nan_as_zero(const CFn *fn, const IrIns *i);
void c_write_statistic_call(CFn *fn, IrRef r);            // writes the call that reads a statistic of a rolling window
bool c_try_write_whole_median(CFn *fn, SmType to, IrRef r); // writes the median as an integer, if r is a median of integers

#endif
