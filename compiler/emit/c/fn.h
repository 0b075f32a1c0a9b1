// SPDX-License-Identifier: Apache-2.0
// One function of the IR on its way to C.  plan.c decides which temporaries stand inside the expressions that use them and
// which become variables; expr.c writes expressions; flow.c finds the nesting of its blocks; code.c writes statements.
#ifndef SMC_EMIT_C_FN_H
#define SMC_EMIT_C_FN_H

#include "compiler/emit/c/unit.h"

typedef enum CHow {
    C_DEAD,                   // nobody needs it
    C_INLINE,                 // stands where it is used
    C_VARIABLE,               // has a variable of its own
    C_EFFECT                  // a statement
} CHow;

// What plan.c and expr.c know of an instruction.
typedef struct CIns {
    CHow how;
    bool is_const;            // its value is known: `bits`
    uint64_t bits;
    Fact fact;                // what it can be
    uint32_t uses;            // by what is not dead and not a constant itself
    uint32_t latest;          // position in its block of the last statement in which it stands
    uint32_t level;           // how deep it stands in that statement's expression
    const char *variable;
    bool unchecked;           // the load of a float: it cannot be NaN, or nobody sees whether it is that or 0
    uint32_t careless;        // of its uses, those that do not see it
    bool excused;             // a comparison of which nobody sees what it gives where an operand is NaN or 0
    IrRef settled_by;         // the load with which, be it NaN or 0, this condition comes out as settled_value; or IR_NONE
    bool settled_value;
} CIns;

// What a function does with a variable of the machine.  Valid while `stamp` is the function's.
typedef struct CVarUse {
    uint32_t stamp;
    uint32_t loads;           // how often its value is needed
    bool stored;
    bool as_double;           // some of them want an F32 as a double
    bool settled;             // stored by the function: after block settled_at it is no NaN
    uint32_t settled_at;
    const char *copy;         // the function's own variable that holds it
    SmType copy_type;         // F64, F32, or of T
    uint32_t block_stamp;     // the block for which next_store holds
    uint32_t next_store;      // position of the next store, seen from where the walk through the block is
    uint32_t flag_stamp;      // the block that has already said that it stores this
} CVarUse;

// Dominators as a tree with shortcuts, so that the meeting point of two blocks is found in logarithmic time.
typedef struct CDominators {
    uint32_t *parent, *shortcut, *depth;
} CDominators;

// The shape of the control flow, as code.c writes it.
typedef struct CFlow {
    uint32_t n;               // blocks, and behind them one that stands for the function's end
    uint32_t *then, *other;   // where each goes, empty blocks jumped over; IR_NONE: nowhere
    bool *reached;
    uint32_t *preds;          // how many ways lead there
    uint32_t *kid, *sibling;  // the blocks where ways meet that this one dominates, in order
    bool *falls;              // something it dominates goes on to something it does not
    CDominators dominators;
} CFlow;

typedef struct CFn {
    CUnit *u;
    const IrFn *f;
    CFlow flow;
    CIns *ins;
    CVarUse *var;             // the unit's, by variable
    uint32_t *window_sample;  // the unit's, by window: as next_store
    uint32_t stamp;           // of this function
    uint32_t *block_stamps;   // the unit's counter of blocks
    uint32_t block;           // stamp of the block in hand
    VEC(uint32_t) copied;     // variables that have a copy
    VEC(uint32_t) stored;     // elements that the block in hand has stored
    Buf body;
    Buf line;                 // the statement under construction
    unsigned indent;
    unsigned values;          // variables made so far
    Buf declarations;         // of those, where they must stand at the top
    bool hoist;               // they must: labels are in use
    bool labels_used;
    bool *label;              // by block
    bool uses_m, uses_sv, writes_m, writes_sv;
    bool returns_state;
} CFn;

// ---- flow.c ----
void flow_init(CFn *fn);
bool flow_dominates(const CFlow *w, uint32_t a, uint32_t b);      // both are reached

// ---- straight.c ----

// f, or a copy of it in which conditionals that only say which have become what is stored.
const IrFn *fn_straight(CUnit *u, const IrFn *f);

// ---- plan.c ----
void plan_constants(CFn *fn, const Env *begin);   // first: what is constant, and facts
bool plan_branch(const CFn *fn, const IrJump *j, bool *taken);   // whether the way is known already
void plan_function(CFn *fn);              // after flow_init

// ---- reading.c ----
void plan_readings(CFn *fn, uint32_t b);  // after uses are counted: which loads need no check for NaN

// ---- expr.c ----

enum {                                    // how tightly C's operators bind
    PREC_ANY = 0, PREC_OR = 4, PREC_AND = 5, PREC_EQ = 9, PREC_REL = 10, PREC_ADD = 12, PREC_MUL = 13, PREC_UNARY = 14, PREC_PRIMARY = 15
};

// Writes the temporary's value to fn->line, in parentheses if it binds less tightly than `prec`.
void put_value(CFn *fn, IrRef r, int prec);
// The value of a float element, a NaN read as 0 where somebody could see it, as a float or a double.
void put_float_load(CFn *fn, IrRef r, SmType as);
// The same of a bool where C wants a truth.
void put_condition(CFn *fn, IrRef r, bool negated, int prec);
void put_cell(CFn *fn, uint32_t var);                                 // m->x, sv->x
void put_time(CFn *fn);                                               // T: time less the state's start
void put_constant(CFn *fn, IrRef r, SmType type, uint64_t bits);      // with its name in the source, where it has one
const char *copy_name(CFn *fn, uint32_t var);
bool c_is_integer(SmType t);
// Opens a parenthesis if what binds like `own` stands where `wanted` is asked for, and tells close_parens.
bool open_parens(CFn *fn, int own, int wanted);
void close_parens(CFn *fn, bool opened);

// ---- convert.c ----

void put_cvt(CFn *fn, const IrIns *i, int prec);
// The value, whatever its type, as a double.
void put_double(CFn *fn, IrRef r, int prec);
// The value where C converts it to the temporary's type by itself: an assignment, an argument.
void put_assigned(CFn *fn, IrRef r);
// Whether an integer type holds every value of another.
bool c_holds_all(SmType to, SmType from);
// Whether r is a conversion to an integer type that holds every value of the integer it converts, written in place.
bool is_widening(const CFn *fn, IrRef r);
// A truth of a number that is never NaN.
void put_not_zero(CFn *fn, IrRef r, bool negated, int prec);

// ---- count.c ----

// r, an F64, on its way to a type: if it is a counter's next number, writes that and gives true.
bool put_count(CFn *fn, IrRef r, SmType to);
// A store that counts its own variable up by one, where numbers are soft: writes that and gives true.
bool soft_put_count(CFn *fn, const IrIns *store);

// ---- code.c ----

// Ends the statement in fn->line.
void end_line(CFn *fn);

// ---- soft.c: what stands there instead of C's operators and casts on floats ----

bool c_is_soft(const CFn *fn, SmType t);               // a float, and numbers are SmF64
void soft_put_number(CFn *fn, IrRef r);                // an integer or F32, not a constant, as an SmF64
void soft_put_cast(CFn *fn, SmType to, IrRef r);       // a float that fits to an integer; anything to F32
void soft_put_binary(CFn *fn, const IrIns *i);
void soft_put_compare(CFn *fn, const IrIns *i, bool negated);
// A comparison of a variable with a constant, where looking at some of its bytes is enough: writes that and gives true.
bool soft_put_look(CFn *fn, const IrIns *i, bool negated);
// Whether that is how x, an operand of comparison i, is looked at if it is a float's load: then a NaN counts as 0.
bool soft_looks(const CFn *fn, const IrIns *i, IrRef x);
void soft_put_not_zero(CFn *fn, IrRef r, bool negated);

// ---- window.c ----

void put_sample(CFn *fn, const IrIns *i);
// Whether it takes a NaN as 0 by itself.
bool window_reads_nan(const CFn *fn, const IrIns *i);
void put_stat(CFn *fn, const IrIns *i);

// ---- compare.c ----

void put_compare(CFn *fn, const IrIns *i, bool negated, int prec);

#endif
