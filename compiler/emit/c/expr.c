// SPDX-License-Identifier: Apache-2.0
// Expressions.  Operators become C's own, with the parentheses that C needs and its compilers ask for.  The C expression of a temporary has
// the temporary's type, with three exceptions due to C: an integer shorter than int is an int, a boolean has the type of C's comparisons,
// and a constant has the type of its literal.
#include <string.h>

#include "compiler/emit/c/fn.h"
#include "stdlib/convert.h"

static const IrVar *var(const CFn *fn, uint32_t v) { return &fn->u->m->var.at[v]; }

bool c_is_integer(SmType t)
{
    return sm_type_info[t].kind == SM_KIND_SIGNED || sm_type_info[t].kind == SM_KIND_UNSIGNED;
}

static void put(CFn *fn, const char *text) { buf_str(&fn->line, text); }

bool open_parens(CFn *fn, int own, int wanted)
{
    if (own < wanted)
        put(fn, "(");
    return own < wanted;
}

void close_parens(CFn *fn, bool opened)
{
    if (opened)
        put(fn, ")");
}

static void put_call(CFn *fn, const char *helper, const IrIns *i)
{
    put(fn, helper_use(fn->u, helper));
    put(fn, "(");
    put_assigned(fn, i->a);
    if (i->b != IR_NONE) {
        put(fn, ", ");
        put_assigned(fn, i->b);
    }
    put(fn, ")");
}

static bool can_be_zero(Fact x) { return x.lo <= 0 && x.hi >= 0; }

// Whether one comparison, y < x or y > x, decides the result: y is never NaN, and if both are equal x is correct.
static bool is_simple_choice(IrOp op, Fact x, Fact y)
{
    return !y.nan && !(op == IR_max ? x.minus_zero && can_be_zero(y) : y.minus_zero && can_be_zero(x));
}

// Writes min and max of F64s for which NaN and the signs of zeros do not matter.
static bool put_simple_choice(CFn *fn, const IrIns *i)
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
    put_value(fn, x, PREC_ANY);
    put(fn, ", ");
    put_value(fn, y, PREC_ANY);
    put(fn, ")");
    return true;
}

// Writes a call of a builtin.  Its F64 function is called sm_NAME, a narrow one sm_NAME_TYPE.
static void put_builtin(CFn *fn, const IrIns *i)
{
    const char *name = ir_op_info[i->op].name;
    const char *of = i->type == SM_I32 ? "_i32" : i->type == SM_I64 ? "_i64" : i->type == SM_F32 ? "_f32" : "";

    if (!put_simple_choice(fn, i))
        put_call(fn, format_in(fn->u->arena, "sm_%s%s", name, of), i);
}

// ---- variables ----

void put_cell(CFn *fn, uint32_t v)
{
    const bool element = var(fn, v)->space == IR_ELEMENT;

    if (element)
        fn->uses_sv = true;
    else
        fn->uses_m = true;
    put(fn, element ? "sv->" : "m->");
    put(fn, fn->u->names.var[v]);
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
    if (name[0] == 'e' && name[1] >= '0' && name[1] <= '9')       // the form of names that copy_name makes
        return true;
    return strcmp(name, "m") == 0 || strcmp(name, "sv") == 0 || starts_with(name, n->type) || starts_with(name, n->sv_type) ||
           (starts_with(name, n->prefix) && name[prefix] == '_') || (starts_with(name, n->macro) && name[macro] == '_');
}

// A name for the function's own variable: the element's, if that is free.
const char *copy_name(CFn *fn, uint32_t v)
{
    const char *name = fn->u->names.var[v];

    return is_taken(&fn->u->names, name) ? format_in(fn->u->arena, "e%u_%s", (unsigned)v, name) : name;
}

void put_time(CFn *fn)
{
    put_cell(fn, fn->u->m->g);
    put(fn, " - m->start_");
    fn->uses_m = true;
}

static bool is_element(const CFn *fn, const IrIns *i) { return var(fn, i->var)->space == IR_ELEMENT; }

static bool has_copy(const CFn *fn, const IrIns *i)
{
    return fn->var[i->var].stamp == fn->stamp && fn->var[i->var].copy;
}

void put_float_load(CFn *fn, IrRef r, SmType as)
{
    const IrIns *i = c_ins(fn, r);
    const bool copy = !fn->ins[r].unchecked && has_copy(fn, i);
    const SmType held = fn->ins[r].unchecked ? i->type : copy ? fn->var[i->var].copy_type : as;

    if (fn->ins[r].unchecked || copy) {
        if (held != as)
            put(fn, fn->u->soft ? as == SM_F64 ? "sm_from_f32(" : "sm_round_f32(" : as == SM_F64 ? "(double)" : "(float)");
        if (fn->ins[r].unchecked)
            put_cell(fn, i->var);
        else
            put(fn, fn->var[i->var].copy);
        close_parens(fn, held != as && fn->u->soft);
        return;
    }
    put(fn, helper_use(fn->u, as == SM_F32 ? "sm_no_nan_f32" : i->type == SM_F32 ? "sm_read_f32" : "sm_read_f64"));
    put(fn, "(");
    put_cell(fn, i->var);
    put(fn, ")");
}

static void put_time_value(CFn *fn, const IrIns *i, int prec)
{
    const bool opened = open_parens(fn, has_copy(fn, i) ? PREC_PRIMARY : PREC_ADD, prec);

    if (has_copy(fn, i))
        put(fn, fn->var[i->var].copy);
    else
        put_time(fn);
    close_parens(fn, opened);
}

static void put_load_value(CFn *fn, IrRef r, int prec)
{
    const IrIns *i = c_ins(fn, r);
    const bool truth = is_element(fn, i) && i->type == SM_BOOL;
    const bool checked = is_element(fn, i) && sm_type_info[i->type].kind == SM_KIND_FLOAT;
    const bool opened = open_parens(fn, truth ? PREC_EQ : checked && has_copy(fn, i) ? PREC_UNARY : PREC_PRIMARY, prec);

    if (checked)
        put_float_load(fn, r, i->type);
    else
        put_cell(fn, i->var);
    put(fn, truth ? " != 0" : "");
    close_parens(fn, opened);
}

// ---- constants ----

// A local that is a constant has become a number; its name follows as a comment.
void put_constant(CFn *fn, IrRef r, SmType type, uint64_t bits)
{
    const char *name = remark_constant(fn->u, c_ins(fn, r)->span);

    literal_put(fn->u, &fn->line, type, bits);
    if (*name)
        buf_printf(&fn->line, " /* %s */", name);
}

// ---- the rest ----

// C computes a sum of two integers shorter than int in an int, which can have 16 bits, so one operand must be as wide as the result.  If
// one operand is, or is converted to be, the conversion of the other can be left to C.
static void put_integer_binary(CFn *fn, const IrIns *i, const char *text, int own, int prec)
{
    const bool a = is_widening(fn, i->a), b = is_widening(fn, i->b), opened = open_parens(fn, own, prec);
    const bool bare_a = a && !b && !c_is_const(fn, i->b), bare_b = b && !c_is_const(fn, i->a);

    put_value(fn, bare_a ? c_ins(fn, i->a)->a : i->a, own);
    put(fn, text);
    put_value(fn, bare_b ? c_ins(fn, i->b)->a : i->b, own + 1);
    close_parens(fn, opened);
}

static void put_binary(CFn *fn, const IrIns *i, const char *text, int own, int prec)
{
    bool opened;

    if (c_is_integer(i->type)) {
        put_integer_binary(fn, i, text, own, prec);
        return;
    }
    if (fn->u->soft) {
        soft_put_binary(fn, i);
        return;
    }
    // A float can be computed as a double if it is rounded back.
    opened = open_parens(fn, i->type == SM_F32 ? PREC_UNARY : own, prec);
    put(fn, i->type == SM_F32 ? "(float)(" : "");
    put_value(fn, i->a, own);
    put(fn, text);
    put_value(fn, i->b, own + 1);         // floating-point operators do not associate
    put(fn, i->type == SM_F32 ? ")" : "");
    close_parens(fn, opened);
}

static void put_logic(CFn *fn, const IrIns *i, int prec)
{
    const int own = i->op == IR_and ? PREC_AND : PREC_OR;
    const bool opened = open_parens(fn, own, own == prec ? PREC_ANY : prec > PREC_ANY ? PREC_PRIMARY : PREC_ANY);

    put_condition(fn, i->a, false, own);
    put(fn, i->op == IR_and ? " && " : " || ");
    put_condition(fn, i->b, false, own);
    close_parens(fn, opened);
}

static void put_negative(CFn *fn, const IrIns *i, int prec)
{
    const bool soft = i->type == SM_F64 && fn->u->soft, opened = open_parens(fn, PREC_UNARY, soft ? PREC_ANY : prec);

    put(fn, soft ? "sm_neg(" : "-");
    put_value(fn, i->a, soft ? PREC_ANY : PREC_PRIMARY);
    close_parens(fn, soft);
    close_parens(fn, opened);
}

static void put_literal(CFn *fn, IrRef r, uint64_t bits, int prec)
{
    const IrIns *i = c_ins(fn, r);
    const SmKind kind = sm_type_info[i->type].kind;
    const bool sign_bit = (bits >> (sm_type_info[i->type].bytes * 8 - 1) & 1) != 0;
    const bool negative = sign_bit && !(fn->u->soft && i->type == SM_F64) && (kind == SM_KIND_FLOAT || kind == SM_KIND_SIGNED);
    const bool opened = open_parens(fn, negative ? PREC_UNARY : PREC_PRIMARY, prec);

    put_constant(fn, r, i->type, bits);
    close_parens(fn, opened);
}

void put_value(CFn *fn, IrRef r, int prec)
{
    const IrIns *i = c_ins(fn, r);
    const CIns *c = &fn->ins[r];

    if (i->op == IR_const) {
        put_literal(fn, r, i->bits, prec);
        return;
    }
    if (c->variable) {
        put(fn, c->variable);
        return;
    }
    switch (i->op) {
    case IR_load:
        if (var(fn, i->var)->space == IR_TIME)
            put_time_value(fn, i, prec);
        else
            put_load_value(fn, r, prec);
        break;
    case IR_cvt: put_cvt(fn, i, prec); break;
    case IR_add: put_binary(fn, i, " + ", PREC_ADD, prec); break;
    case IR_sub: put_binary(fn, i, " - ", PREC_ADD, prec); break;
    case IR_mul: put_binary(fn, i, " * ", PREC_MUL, prec); break;
    case IR_div: put_binary(fn, i, " / ", PREC_MUL, prec); break;
    case IR_neg: put_negative(fn, i, prec); break;
    case IR_eq: case IR_ne: case IR_lt: case IR_le: case IR_gt: case IR_ge: put_compare(fn, i, false, prec); break;
    case IR_and: case IR_or: put_logic(fn, i, prec); break;
    case IR_not: put_condition(fn, i->a, true, prec); break;
    case IR_stat: put_stat(fn, i); break;
    case IR_const: case IR_store: case IR_sample: case IR_OP_COUNT: break;
    default: put_builtin(fn, i); break;
    }
}

// Writes a bool as a condition of C: an element's byte needs no comparison there.
void put_condition(CFn *fn, IrRef r, bool negated, int prec)
{
    const IrIns *i = c_ins(fn, r);
    const bool inside = !c_is_const(fn, r) && !fn->ins[r].variable;
    const SmType from = inside && i->op == IR_cvt ? c_ins(fn, i->a)->type : SM_TYPE_COUNT;

    if (inside && i->op == IR_not) {
        put_condition(fn, i->a, !negated, prec);
    } else if (inside && i->op >= IR_eq && i->op <= IR_ge) {
        put_compare(fn, i, negated, prec);
    } else if (inside && i->op == IR_cvt && from == SM_BOOL) {
        put_condition(fn, i->a, negated, prec);
    } else if (inside && i->op == IR_cvt && !fn->ins[i->a].fact.nan) {
        put_not_zero(fn, i->a, negated, prec);
    } else if (inside && i->op == IR_load) {
        put(fn, negated ? "!" : "");
        put_cell(fn, i->var);
    } else if (negated) {
        put(fn, "!");
        put_value(fn, r, PREC_PRIMARY);
    } else {
        put_value(fn, r, prec);
    }
}
