// SPDX-License-Identifier: Apache-2.0
// Writes expressions.  IR operations become C operators, with the parentheses that C needs and those whose absence its compilers warn about.
// The C expression of a temporary has the temporary's type, with three exceptions: an integer shorter than int is an int, a bool has the type
// of C's comparisons, and a constant has the type of its literal.
#include <string.h>

#include "compiler/emit/c/fn.h"
#include "compiler/ir/comparison.h"
#include "stdlib/convert.h"

static const IrVar *get_var(const CFn *fn, uint32_t v) { return &fn->u->m->var.at[v]; }

// Writes `(` if an expression of precedence `own` needs it where `wanted` is required.  The result is the argument of c_close_parens.
bool c_open_parens(CFn *fn, int own, int wanted)
{
    if (own < wanted)
        c_write(fn, "(");
    return own < wanted;
}

void c_close_parens(CFn *fn, bool opened)
{
    if (opened)
        c_write(fn, ")");
}

// Writes the call helper(a, b) or helper(a) with the operands of i.
static void write_helper_call(CFn *fn, const char *helper, const IrIns *i)
{
    c_write(fn, helper_require(fn->u, helper));
    c_write(fn, "(");
    c_write_assigned(fn, i->a);
    if (i->b != IR_NONE) {
        c_write(fn, ", ");
        c_write_assigned(fn, i->b);
    }
    c_write(fn, ")");
}

static bool can_be_zero(Fact x) { return x.lo <= 0 && x.hi >= 0; }

// Whether `y < x ? y : x` (min) or `y > x ? y : x` (max) is the result for all values: y is never NaN, and x is correct where both are equal.
static bool is_decided_by_one_comparison(IrOp op, Fact x, Fact y)
{
    return !y.nan && !(op == IR_max ? x.minus_zero && can_be_zero(y) : y.minus_zero && can_be_zero(x));
}

// If i is min or max of F64s and one comparison decides it, writes a call of sm_lower or sm_higher and returns true.
static bool try_write_simple_min_max(CFn *fn, const IrIns *i)
{
    IrRef x = i->a, y = i->b;

    if ((i->op != IR_min && i->op != IR_max) || i->type != SM_F64)
        return false;
    if (!is_decided_by_one_comparison(i->op, fn->ins[x].fact, fn->ins[y].fact)) {
        x = i->b;
        y = i->a;
    }
    if (!is_decided_by_one_comparison(i->op, fn->ins[x].fact, fn->ins[y].fact))
        return false;
    buf_printf(&fn->line, "%s(", helper_require(fn->u, i->op == IR_min ? "sm_lower" : "sm_higher"));
    c_write_value(fn, x, PREC_ANY);
    c_write(fn, ", ");
    c_write_value(fn, y, PREC_ANY);
    c_write(fn, ")");
    return true;
}

// Writes a builtin as a call: of sm_NAME for F64, of sm_NAME_i32, _i64 or _f32 for other types.
static void write_builtin(CFn *fn, const IrIns *i)
{
    const bool saturates = i->op == IR_abs && i->type == SM_I64 && fn->ins[i->a].fact.lo <= -9223372036854775808.0;     // -2^63
    const char *name = saturates ? "saturating_abs" : ir_op_info[i->op].name;
    const char *of = i->type == SM_I32 ? "_i32" : i->type == SM_I64 ? "_i64" : i->type == SM_F32 ? "_f32" : "";

    if (!try_write_simple_min_max(fn, i))
        write_helper_call(fn, format_in(fn->u->arena, "sm_%s%s", name, of), i);
}

// ---- variables ----

// Writes a variable of the machine: `m->x` for a local, `sv->x` for an element.
void c_write_member(CFn *fn, uint32_t v)
{
    const bool element = get_var(fn, v)->space == IR_ELEMENT;

    if (element)
        fn->uses_sv = true;
    else
        fn->uses_m = true;
    c_write(fn, element ? "sv->" : "m->");
    c_write(fn, fn->u->names.var[v]);
}

static bool has_prefix(const char *name, const char *start) { return strncmp(name, start, strlen(start)) == 0; }

// Whether a name could equal a name at file scope of the emitted file, or a parameter or variable of the function.
static bool may_clash(const CNames *n, const char *name)
{
    static const char *const starts[] = { "sm_", "value", "test", "mem" };
    const size_t prefix = strlen(n->prefix), macro = strlen(n->macro);

    for (size_t i = 0; i < sizeof starts / sizeof *starts; i++)
        if (has_prefix(name, starts[i]))
            return true;
    if (name[0] == 'e' && name[1] >= '0' && name[1] <= '9')       // c_copy_name generates names of this form
        return true;
    return strcmp(name, "m") == 0 || strcmp(name, "sv") == 0 || has_prefix(name, n->type) || has_prefix(name, n->sv_type) ||
           (has_prefix(name, n->prefix) && name[prefix] == '_') || (has_prefix(name, n->macro) && name[macro] == '_');
}

// Returns a name for the C variable that holds a copy of the machine's variable `var`: the variable's own name if that cannot clash.
const char *c_copy_name(CFn *fn, uint32_t v)
{
    const char *name = fn->u->names.var[v];

    return may_clash(&fn->u->names, name) ? format_in(fn->u->arena, "e%u_%s", (unsigned)v, name) : name;
}

// Writes T: `sv->g - m->start_`.
void c_write_time(CFn *fn)
{
    c_write_member(fn, fn->u->m->g);
    c_write(fn, " - m->start_");
    fn->uses_m = true;
}

static bool is_element_load(const CFn *fn, const IrIns *i) { return get_var(fn, i->var)->space == IR_ELEMENT; }

// Whether a C variable holds a copy of the variable that i loads.
static bool has_copy(const CFn *fn, const IrIns *i)
{
    return fn->var[i->var].stamp == fn->stamp && fn->var[i->var].copy;
}

// Writes the value of r, the load of a float element, as type `as`: SM_F32 or SM_F64.
void c_write_float_load(CFn *fn, IrRef r, SmType as)
{
    const IrIns *i = c_ins(fn, r);
    const bool copy = !fn->ins[r].unchecked && has_copy(fn, i);
    const SmType held = fn->ins[r].unchecked ? i->type : copy ? fn->var[i->var].copy_type : as;

    if (fn->ins[r].unchecked || copy) {
        if (held != as)
            c_write(fn, fn->u->soft ? as == SM_F64 ? "sm_from_f32(" : "sm_round_f32(" : as == SM_F64 ? "(double)" : "(float)");
        if (fn->ins[r].unchecked)
            c_write_member(fn, i->var);
        else
            c_write(fn, fn->var[i->var].copy);
        c_close_parens(fn, held != as && fn->u->soft);
        return;
    }
    c_write(fn, helper_require(fn->u, as == SM_F32 ? "sm_no_nan_f32" : i->type == SM_F32 ? "sm_read_f32" : "sm_read_f64"));
    c_write(fn, "(");
    c_write_member(fn, i->var);
    c_write(fn, ")");
}

static void write_time_load(CFn *fn, const IrIns *i, int prec)
{
    const bool opened = c_open_parens(fn, has_copy(fn, i) ? PREC_PRIMARY : PREC_ADD, prec);

    if (has_copy(fn, i))
        c_write(fn, fn->var[i->var].copy);
    else
        c_write_time(fn);
    c_close_parens(fn, opened);
}

static void write_load(CFn *fn, IrRef r, int prec)
{
    const IrIns *i = c_ins(fn, r);
    const bool truth = is_element_load(fn, i) && i->type == SM_BOOL;
    const bool checked = is_element_load(fn, i) && sm_type_info[i->type].kind == SM_KIND_FLOAT;
    const bool opened = c_open_parens(fn, truth ? PREC_EQ : checked && has_copy(fn, i) ? PREC_UNARY : PREC_PRIMARY, prec);

    if (checked)
        c_write_float_load(fn, r, i->type);
    else
        c_write_member(fn, i->var);
    c_write(fn, truth ? " != 0" : "");
    c_close_parens(fn, opened);
}

// ---- constants ----

// Writes the literal, and the name of the constant as a comment.
void c_write_constant(CFn *fn, IrRef r, SmType type, uint64_t bits)
{
    const char *name = remark_constant_name(fn->u, c_ins(fn, r)->span);

    literal_write(fn->u, &fn->line, type, bits);
    if (*name)
        buf_printf(&fn->line, " /* %s */", name);
}

// ---- operators ----

// Writes the operation `text` on two integers.  C would compute a sum of two integers shorter than int in an int, which can have 16 bits, so one
// operand must have the type of the result.  The widening conversion of the other operand is then left to C.
static void write_integer_binary(CFn *fn, const IrIns *i, const char *text, int own, int prec)
{
    const bool a = c_is_widening(fn, i->a), b = c_is_widening(fn, i->b), opened = c_open_parens(fn, own, prec);
    const bool bare_a = a && !b && !c_is_const(fn, i->b), bare_b = b && !c_is_const(fn, i->a);

    c_write_value(fn, bare_a ? c_ins(fn, i->a)->a : i->a, own);
    c_write(fn, text);
    c_write_value(fn, bare_b ? c_ins(fn, i->b)->a : i->b, own + 1);
    c_close_parens(fn, opened);
}

// Writes an arithmetic operation with operator `text` of precedence `own`.
static void write_binary(CFn *fn, const IrIns *i, const char *text, int own, int prec)
{
    bool opened;

    if (ir_is_integer(i->type)) {
        write_integer_binary(fn, i, text, own, prec);
        return;
    }
    if (fn->u->soft) {
        soft_write_binary(fn, i);
        return;
    }
    // A C compiler may compute a float operation as a double, so the result is rounded back.
    opened = c_open_parens(fn, i->type == SM_F32 ? PREC_UNARY : own, prec);
    c_write(fn, i->type == SM_F32 ? "(float)(" : "");
    c_write_value(fn, i->a, own);
    c_write(fn, text);
    c_write_value(fn, i->b, own + 1);         // in parentheses even if its precedence is the same: a + (b + c) is not (a + b) + c
    c_write(fn, i->type == SM_F32 ? ")" : "");
    c_close_parens(fn, opened);
}

// Writes `&&` or `||`. `prec`: precedence of the surrounding expression, which decides about parentheses.
static void write_logic(CFn *fn, const IrIns *i, int prec)
{
    const int own = i->op == IR_and ? PREC_AND : PREC_OR;
    const bool opened = c_open_parens(fn, own, own == prec ? PREC_ANY : prec > PREC_ANY ? PREC_PRIMARY : PREC_ANY);

    c_write_condition(fn, i->a, false, own);
    c_write(fn, i->op == IR_and ? " && " : " || ");
    c_write_condition(fn, i->b, false, own);
    c_close_parens(fn, opened);
}

static void write_negation(CFn *fn, const IrIns *i, int prec)
{
    const bool soft = i->type == SM_F64 && fn->u->soft, opened = c_open_parens(fn, PREC_UNARY, soft ? PREC_ANY : prec);

    c_write(fn, soft ? "sm_neg(" : "-");
    c_write_value(fn, i->a, soft ? PREC_ANY : PREC_PRIMARY);
    c_close_parens(fn, soft);
    c_close_parens(fn, opened);
}

// Writes constant r, in parentheses if it is negative and `prec` requires them.
static void write_literal(CFn *fn, IrRef r, uint64_t bits, int prec)
{
    const IrIns *i = c_ins(fn, r);
    const SmKind kind = sm_type_info[i->type].kind;
    const bool sign_bit = (bits >> (sm_type_info[i->type].bytes * 8 - 1) & 1) != 0;
    const bool negative = sign_bit && !(fn->u->soft && i->type == SM_F64) && (kind == SM_KIND_FLOAT || kind == SM_KIND_SIGNED);
    const bool opened = c_open_parens(fn, negative ? PREC_UNARY : PREC_PRIMARY, prec);

    c_write_constant(fn, r, i->type, bits);
    c_close_parens(fn, opened);
}

// Writes the value of temporary r to fn->line, in parentheses if the precedence of the expression is below `prec`.
void c_write_value(CFn *fn, IrRef r, int prec)
{
    const IrIns *i = c_ins(fn, r);
    const CIns *c = &fn->ins[r];

    if (i->op == IR_const) {
        write_literal(fn, r, i->bits, prec);
        return;
    }
    if (c->variable) {
        c_write(fn, c->variable);
        return;
    }
    switch (i->op) {
    case IR_load:
        if (get_var(fn, i->var)->space == IR_TIME)
            write_time_load(fn, i, prec);
        else
            write_load(fn, r, prec);
        break;
    case IR_cvt: c_write_conversion(fn, i, prec); break;
    case IR_add: write_binary(fn, i, " + ", PREC_ADD, prec); break;
    case IR_sub: write_binary(fn, i, " - ", PREC_ADD, prec); break;
    case IR_mul: write_binary(fn, i, " * ", PREC_MUL, prec); break;
    case IR_div: write_binary(fn, i, " / ", PREC_MUL, prec); break;
    case IR_neg: write_negation(fn, i, prec); break;
    case IR_eq: case IR_ne: case IR_lt: case IR_le: case IR_gt: case IR_ge: c_write_compare(fn, i, false, prec); break;
    case IR_and: case IR_or: write_logic(fn, i, prec); break;
    case IR_not: c_write_condition(fn, i->a, true, prec); break;
    case IR_stat: c_write_statistic_call(fn, r); break;
    case IR_const: case IR_store: case IR_sample: case IR_OP_COUNT: break;
    default: write_builtin(fn, i); break;
    }
}

// Writes the bool r, or its negation, as a condition of C: any expression that is nonzero if it is true.
void c_write_condition(CFn *fn, IrRef r, bool negated, int prec)
{
    const IrIns *i = c_ins(fn, r);
    const bool inside = !c_is_const(fn, r) && !fn->ins[r].variable;
    const SmType from = inside && i->op == IR_cvt ? c_ins(fn, i->a)->type : SM_TYPE_COUNT;

    if (inside && i->op == IR_not) {
        c_write_condition(fn, i->a, !negated, prec);
    } else if (inside && ir_is_comparison(i->op)) {
        c_write_compare(fn, i, negated, prec);
    } else if (inside && i->op == IR_cvt && from == SM_BOOL) {
        c_write_condition(fn, i->a, negated, prec);
    } else if (inside && i->op == IR_cvt && !fn->ins[i->a].fact.nan) {
        c_write_nonzero_test(fn, i->a, negated, prec);
    } else if (inside && i->op == IR_load) {
        c_write(fn, negated ? "!" : "");
        c_write_member(fn, i->var);
    } else if (negated) {
        c_write(fn, "!");
        c_write_value(fn, r, PREC_PRIMARY);
    } else {
        c_write_value(fn, r, prec);
    }
}

// ---- comparisons ----
// Both operands have the same type and are written in that type.  If compilers would warn that a comparison is always true or always false,
// both operands are written as doubles instead, because compilers do not give this warning for doubles.

static const char *const comparison_operator[] = {
    [IR_eq - IR_eq] = " == ", [IR_ne - IR_eq] = " != ", [IR_lt - IR_eq] = " < ",
    [IR_le - IR_eq] = " <= ", [IR_gt - IR_eq] = " > ", [IR_ge - IR_eq] = " >= ",
};

// Whether the C expressions of two temporaries may be equal, character by character.
static bool can_have_same_source(const CFn *fn, IrRef a, IrRef b)
{
    const IrIns *x = c_ins(fn, a), *y = c_ins(fn, b);

    if (a == b)
        return true;
    if (c_is_const(fn, a) || c_is_const(fn, b))
        return c_is_const(fn, a) && c_is_const(fn, b) && c_ins(fn, a)->bits == c_ins(fn, b)->bits;
    if (x->op != y->op || x->type != y->type)
        return false;
    if (x->op == IR_load || x->op == IR_stat)
        return x->var == y->var && (x->op == IR_load || x->stat == y->stat);
    return can_have_same_source(fn, x->a, y->a) && (x->b == IR_NONE || can_have_same_source(fn, x->b, y->b));
}

// Whether `x op limit` is true for some values x of integer type t and false for others.
static bool can_have_both_results(const CFn *fn, IrOp op, IrRef limit, SmType t)
{
    const Fact r = fact_of_type(t);
    const double x = sm_cell_to_f64(c_ins(fn, limit)->type, c_ins(fn, limit)->bits);

    return x >= r.lo && x <= r.hi && !(x == r.lo && (op == IR_lt || op == IR_ge)) && !(x == r.hi && (op == IR_gt || op == IR_le));
}

// Returns the type of integer r before its widening conversion, if it is one.
static SmType unconverted_type(const CFn *fn, IrRef r) { return c_ins(fn, c_is_widening(fn, r) ? c_ins(fn, r)->a : r)->type; }

// Whether i compares integers, and compilers do not warn if both operands are written as integers.
static bool can_compare_integers(const CFn *fn, const IrIns *i)
{
    if (!ir_is_integer(c_ins(fn, i->a)->type) || can_have_same_source(fn, i->a, i->b))
        return false;
    if (c_is_const(fn, i->a))
        return !c_is_const(fn, i->b) && can_have_both_results(fn, ir_swapped_comparison(i->op), i->a, unconverted_type(fn, i->b));
    return !c_is_const(fn, i->b) || can_have_both_results(fn, i->op, i->b, unconverted_type(fn, i->a));
}

// Whether i tests equality of bools, and compilers do not warn if both operands are written as bools.
static bool can_compare_bools(const CFn *fn, const IrIns *i)
{
    return ir_is_equality(i->op) && c_ins(fn, i->a)->type == SM_BOOL && !can_have_same_source(fn, i->a, i->b);
}

// Writes both operands of comparison i, with the operator `text` between them.
static void write_compared_operands(CFn *fn, const IrIns *i, const char *text)
{
    const SmType type = c_ins(fn, i->a)->type;
    const bool integers = can_compare_integers(fn, i), bools = can_compare_bools(fn, i);
    // One widening conversion can be left to C, which converts the shorter operand to the type of the other.
    const bool bare = integers && !(c_is_widening(fn, i->a) && c_is_widening(fn, i->b));

    for (int side = 0; side < 2; side++) {
        const IrRef r = side ? i->b : i->a;
        c_write(fn, side ? text : "");
        if (integers)
            c_write_value(fn, bare && c_is_widening(fn, r) ? c_ins(fn, r)->a : r, PREC_ADD);
        else if (bools || type == SM_F32)
            c_write_value(fn, r, bools ? PREC_PRIMARY : PREC_ADD);
        else
            c_write_double(fn, r, PREC_ADD);
    }
}

void c_write_compare(CFn *fn, const IrIns *i, bool negated, int prec)
{
    const bool equality = ir_is_equality(i->op), inverted = negated && !equality;
    const IrOp op = negated && equality ? ir_negated_comparison(i->op) : i->op;
    bool opened;

    if (fn->u->soft && soft_try_write_byte_compare(fn, i, negated))
        return;
    if (fn->u->soft && !can_compare_integers(fn, i) && !can_compare_bools(fn, i)) {
        soft_write_compare(fn, i, negated);
        return;
    }
    if (inverted)
        c_write(fn, "!");
    opened = c_open_parens(fn, equality ? PREC_EQ : PREC_REL, inverted ? PREC_PRIMARY : prec);
    write_compared_operands(fn, i, comparison_operator[op - IR_eq]);
    c_close_parens(fn, opened);
}
