// SPDX-License-Identifier: Apache-2.0
// Expressions.  Operators become C's own, with the parentheses that C needs and its compilers require.  The C expression of a temporary has
// the temporary's type, with three exceptions due to C: an integer shorter than int is an int, a boolean has the type of C's comparisons,
// and a constant has the type of its literal.
#include <string.h>

#include "compiler/emit/c/fn.h"
#include "compiler/ir/comparison.h"
#include "stdlib/convert.h"

static const IrVar *var(const CFn *fn, uint32_t v) { return &fn->u->m->var.at[v]; }


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

static void write_call(CFn *fn, const char *helper, const IrIns *i)
{
    c_write(fn, helper_use(fn->u, helper));
    c_write(fn, "(");
    c_write_assigned(fn, i->a);
    if (i->b != IR_NONE) {
        c_write(fn, ", ");
        c_write_assigned(fn, i->b);
    }
    c_write(fn, ")");
}

static bool can_be_zero(Fact x) { return x.lo <= 0 && x.hi >= 0; }

// Whether one comparison, y < x or y > x, decides the result: y is never NaN, and if both are equal x is correct.
static bool is_simple_choice(IrOp op, Fact x, Fact y)
{
    return !y.nan && !(op == IR_max ? x.minus_zero && can_be_zero(y) : y.minus_zero && can_be_zero(x));
}

// Writes min and max of F64s for which NaN and the signs of zeros do not matter.
static bool write_simple_choice(CFn *fn, const IrIns *i)
{
    IrRef x = i->a, y = i->b;

    if ((i->op != IR_min && i->op != IR_max) || i->type != SM_F64)
        return false;
    if (!is_simple_choice(i->op, fn->ins[x].fact, fn->ins[y].fact)) {
        x = i->b;
        y = i->a;
    }
    if (!is_simple_choice(i->op, fn->ins[x].fact, fn->ins[y].fact))
        return false;
    buf_printf(&fn->line, "%s(", helper_use(fn->u, i->op == IR_min ? "sm_lower" : "sm_higher"));
    c_write_value(fn, x, PREC_ANY);
    c_write(fn, ", ");
    c_write_value(fn, y, PREC_ANY);
    c_write(fn, ")");
    return true;
}

// Writes a call of a builtin.  Its F64 function is called sm_NAME, a narrow one sm_NAME_TYPE.
static void write_builtin(CFn *fn, const IrIns *i)
{
    const char *name = ir_op_info[i->op].name;
    const char *of = i->type == SM_I32 ? "_i32" : i->type == SM_I64 ? "_i64" : i->type == SM_F32 ? "_f32" : "";

    if (!write_simple_choice(fn, i))
        write_call(fn, format_in(fn->u->arena, "sm_%s%s", name, of), i);
}

// ---- variables ----

void c_write_cell(CFn *fn, uint32_t v)
{
    const bool element = var(fn, v)->space == IR_ELEMENT;

    if (element)
        fn->uses_sv = true;
    else
        fn->uses_m = true;
    c_write(fn, element ? "sv->" : "m->");
    c_write(fn, fn->u->names.var[v]);
}

static bool starts_with(const char *name, const char *start) { return strncmp(name, start, strlen(start)) == 0; }

// Whether a name equals, or could equal, one at the top of the emitted file or another in the function.
static bool is_taken(const CNames *n, const char *name)
{
    static const char *const starts[] = { "sm_", "value", "test", "mem" };
    const size_t prefix = strlen(n->prefix), macro = strlen(n->macro);

    for (size_t i = 0; i < sizeof starts / sizeof *starts; i++)
        if (starts_with(name, starts[i]))
            return true;
    if (name[0] == 'e' && name[1] >= '0' && name[1] <= '9')       // the form of names that c_copy_name makes
        return true;
    return strcmp(name, "m") == 0 || strcmp(name, "sv") == 0 || starts_with(name, n->type) || starts_with(name, n->sv_type) ||
           (starts_with(name, n->prefix) && name[prefix] == '_') || (starts_with(name, n->macro) && name[macro] == '_');
}

// A name for the function's own variable: the element's, if that is free.
const char *c_copy_name(CFn *fn, uint32_t v)
{
    const char *name = fn->u->names.var[v];

    return is_taken(&fn->u->names, name) ? format_in(fn->u->arena, "e%u_%s", (unsigned)v, name) : name;
}

void c_write_time(CFn *fn)
{
    c_write_cell(fn, fn->u->m->g);
    c_write(fn, " - m->start_");
    fn->uses_m = true;
}

static bool is_element(const CFn *fn, const IrIns *i) { return var(fn, i->var)->space == IR_ELEMENT; }

static bool has_copy(const CFn *fn, const IrIns *i)
{
    return fn->var[i->var].stamp == fn->stamp && fn->var[i->var].copy;
}

void c_write_float_load(CFn *fn, IrRef r, SmType as)
{
    const IrIns *i = c_ins(fn, r);
    const bool copy = !fn->ins[r].unchecked && has_copy(fn, i);
    const SmType held = fn->ins[r].unchecked ? i->type : copy ? fn->var[i->var].copy_type : as;

    if (fn->ins[r].unchecked || copy) {
        if (held != as)
            c_write(fn, fn->u->soft ? as == SM_F64 ? "sm_from_f32(" : "sm_round_f32(" : as == SM_F64 ? "(double)" : "(float)");
        if (fn->ins[r].unchecked)
            c_write_cell(fn, i->var);
        else
            c_write(fn, fn->var[i->var].copy);
        c_close_parens(fn, held != as && fn->u->soft);
        return;
    }
    c_write(fn, helper_use(fn->u, as == SM_F32 ? "sm_no_nan_f32" : i->type == SM_F32 ? "sm_read_f32" : "sm_read_f64"));
    c_write(fn, "(");
    c_write_cell(fn, i->var);
    c_write(fn, ")");
}

static void write_time_value(CFn *fn, const IrIns *i, int prec)
{
    const bool opened = c_open_parens(fn, has_copy(fn, i) ? PREC_PRIMARY : PREC_ADD, prec);

    if (has_copy(fn, i))
        c_write(fn, fn->var[i->var].copy);
    else
        c_write_time(fn);
    c_close_parens(fn, opened);
}

static void write_load_value(CFn *fn, IrRef r, int prec)
{
    const IrIns *i = c_ins(fn, r);
    const bool truth = is_element(fn, i) && i->type == SM_BOOL;
    const bool checked = is_element(fn, i) && sm_type_info[i->type].kind == SM_KIND_FLOAT;
    const bool opened = c_open_parens(fn, truth ? PREC_EQ : checked && has_copy(fn, i) ? PREC_UNARY : PREC_PRIMARY, prec);

    if (checked)
        c_write_float_load(fn, r, i->type);
    else
        c_write_cell(fn, i->var);
    c_write(fn, truth ? " != 0" : "");
    c_close_parens(fn, opened);
}

// ---- constants ----

// A local that is a constant has become a number; its name follows as a comment.
void c_write_constant(CFn *fn, IrRef r, SmType type, uint64_t bits)
{
    const char *name = remark_constant(fn->u, c_ins(fn, r)->span);

    literal_write(fn->u, &fn->line, type, bits);
    if (*name)
        buf_printf(&fn->line, " /* %s */", name);
}

// ---- the rest ----

// C computes a sum of two integers shorter than int in an int, which can have 16 bits, so one operand must be as wide as the result.  If
// one operand is, or is converted to be, the conversion of the other can be left to C.
static void write_integer_binary(CFn *fn, const IrIns *i, const char *text, int own, int prec)
{
    const bool a = c_is_widening(fn, i->a), b = c_is_widening(fn, i->b), opened = c_open_parens(fn, own, prec);
    const bool bare_a = a && !b && !c_is_const(fn, i->b), bare_b = b && !c_is_const(fn, i->a);

    c_write_value(fn, bare_a ? c_ins(fn, i->a)->a : i->a, own);
    c_write(fn, text);
    c_write_value(fn, bare_b ? c_ins(fn, i->b)->a : i->b, own + 1);
    c_close_parens(fn, opened);
}

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
    // A float can be computed as a double if it is rounded back.
    opened = c_open_parens(fn, i->type == SM_F32 ? PREC_UNARY : own, prec);
    c_write(fn, i->type == SM_F32 ? "(float)(" : "");
    c_write_value(fn, i->a, own);
    c_write(fn, text);
    c_write_value(fn, i->b, own + 1);         // floating-point operators do not associate
    c_write(fn, i->type == SM_F32 ? ")" : "");
    c_close_parens(fn, opened);
}

static void write_logic(CFn *fn, const IrIns *i, int prec)
{
    const int own = i->op == IR_and ? PREC_AND : PREC_OR;
    const bool opened = c_open_parens(fn, own, own == prec ? PREC_ANY : prec > PREC_ANY ? PREC_PRIMARY : PREC_ANY);

    c_write_condition(fn, i->a, false, own);
    c_write(fn, i->op == IR_and ? " && " : " || ");
    c_write_condition(fn, i->b, false, own);
    c_close_parens(fn, opened);
}

static void write_negative(CFn *fn, const IrIns *i, int prec)
{
    const bool soft = i->type == SM_F64 && fn->u->soft, opened = c_open_parens(fn, PREC_UNARY, soft ? PREC_ANY : prec);

    c_write(fn, soft ? "sm_neg(" : "-");
    c_write_value(fn, i->a, soft ? PREC_ANY : PREC_PRIMARY);
    c_close_parens(fn, soft);
    c_close_parens(fn, opened);
}

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
        if (var(fn, i->var)->space == IR_TIME)
            write_time_value(fn, i, prec);
        else
            write_load_value(fn, r, prec);
        break;
    case IR_cvt: c_write_cvt(fn, i, prec); break;
    case IR_add: write_binary(fn, i, " + ", PREC_ADD, prec); break;
    case IR_sub: write_binary(fn, i, " - ", PREC_ADD, prec); break;
    case IR_mul: write_binary(fn, i, " * ", PREC_MUL, prec); break;
    case IR_div: write_binary(fn, i, " / ", PREC_MUL, prec); break;
    case IR_neg: write_negative(fn, i, prec); break;
    case IR_eq: case IR_ne: case IR_lt: case IR_le: case IR_gt: case IR_ge: c_write_compare(fn, i, false, prec); break;
    case IR_and: case IR_or: write_logic(fn, i, prec); break;
    case IR_not: c_write_condition(fn, i->a, true, prec); break;
    case IR_stat: c_write_stat(fn, i); break;
    case IR_const: case IR_store: case IR_sample: case IR_OP_COUNT: break;
    default: write_builtin(fn, i); break;
    }
}

// Writes a bool as a condition of C: an element's byte needs no comparison there.
void c_write_condition(CFn *fn, IrRef r, bool negated, int prec)
{
    const IrIns *i = c_ins(fn, r);
    const bool inside = !c_is_const(fn, r) && !fn->ins[r].variable;
    const SmType from = inside && i->op == IR_cvt ? c_ins(fn, i->a)->type : SM_TYPE_COUNT;

    if (inside && i->op == IR_not) {
        c_write_condition(fn, i->a, !negated, prec);
    } else if (inside && i->op >= IR_eq && i->op <= IR_ge) {
        c_write_compare(fn, i, negated, prec);
    } else if (inside && i->op == IR_cvt && from == SM_BOOL) {
        c_write_condition(fn, i->a, negated, prec);
    } else if (inside && i->op == IR_cvt && !fn->ins[i->a].fact.nan) {
        c_write_not_zero(fn, i->a, negated, prec);
    } else if (inside && i->op == IR_load) {
        c_write(fn, negated ? "!" : "");
        c_write_cell(fn, i->var);
    } else if (negated) {
        c_write(fn, "!");
        c_write_value(fn, r, PREC_PRIMARY);
    } else {
        c_write_value(fn, r, prec);
    }
}

// ---- comparisons ----
// Both sides have the same type and are written in it.  If compilers would warn that a comparison is always true or always false, both sides
// are written as doubles, for which compilers cannot know that.

static const char *const compare_text[] = {
    [IR_eq - IR_eq] = " == ", [IR_ne - IR_eq] = " != ", [IR_lt - IR_eq] = " < ",
    [IR_le - IR_eq] = " <= ", [IR_gt - IR_eq] = " > ", [IR_ge - IR_eq] = " >= ",
};

// Whether two temporaries can produce the same C expression.
static bool is_same_text(const CFn *fn, IrRef a, IrRef b)
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
    return is_same_text(fn, x->a, y->a) && (x->b == IR_NONE || is_same_text(fn, x->b, y->b));
}

// Whether an integer type has values on both sides of the limit.
static bool is_undecided(const CFn *fn, IrOp op, IrRef limit, SmType t)
{
    const Fact r = fact_of_type(t);
    const double x = sm_cell_to_f64(c_ins(fn, limit)->type, c_ins(fn, limit)->bits);

    return x >= r.lo && x <= r.hi && !(x == r.lo && (op == IR_lt || op == IR_ge)) && !(x == r.hi && (op == IR_gt || op == IR_le));
}

// The type of the operand before C converts it.
static SmType source_type(const CFn *fn, IrRef r) { return c_ins(fn, c_is_widening(fn, r) ? c_ins(fn, r)->a : r)->type; }

static bool compares_integers(const CFn *fn, const IrIns *i)
{
    if (!ir_is_integer(c_ins(fn, i->a)->type) || is_same_text(fn, i->a, i->b))
        return false;
    if (c_is_const(fn, i->a))
        return !c_is_const(fn, i->b) && is_undecided(fn, ir_swapped_comparison(i->op), i->a, source_type(fn, i->b));
    return !c_is_const(fn, i->b) || is_undecided(fn, i->op, i->b, source_type(fn, i->a));
}

static bool compares_bools(const CFn *fn, const IrIns *i)
{
    return ir_is_equality(i->op) && c_ins(fn, i->a)->type == SM_BOOL && !is_same_text(fn, i->a, i->b);
}

static void write_sides(CFn *fn, const IrIns *i, const char *text)
{
    const SmType type = c_ins(fn, i->a)->type;
    const bool integers = compares_integers(fn, i), bools = compares_bools(fn, i);
    // C converts the shorter integer implicitly if the other side has the common type.
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

    if (fn->u->soft && soft_write_byte_compare(fn, i, negated))
        return;
    if (fn->u->soft && !compares_integers(fn, i) && !compares_bools(fn, i)) {
        soft_write_compare(fn, i, negated);
        return;
    }
    if (inverted)
        c_write(fn, "!");
    opened = c_open_parens(fn, equality ? PREC_EQ : PREC_REL, inverted ? PREC_PRIMARY : prec);
    write_sides(fn, i, compare_text[op - IR_eq]);
    c_close_parens(fn, opened);
}
