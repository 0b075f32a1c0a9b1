// SPDX-License-Identifier: Apache-2.0
// Expressions.  Operators come out as C's own, with the parentheses that C needs and that its compilers ask for; a number is
// a double, a truth is whatever C's comparisons give, and conversions stand only where they can change something.
#include <string.h>

#include "compiler/emit/c/fn.h"
#include "stdlib/convert.h"

static const IrIns *ins(const CFn *fn, IrRef r) { return &fn->f->ins.at[r]; }
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

static void put_call(CFn *fn, const char *helper, IrRef a, IrRef b)
{
    put(fn, helper_use(fn->u, helper));
    put(fn, "(");
    put_value(fn, a, PREC_ANY);
    if (b != IR_NONE) {
        put(fn, ", ");
        put_value(fn, b, PREC_ANY);
    }
    put(fn, ")");
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

// Whether a name at the top of the emitted file, or another in the function, is or may be the same.
static bool is_taken(const CNames *n, const char *name)
{
    static const char *const starts[] = { "sm_", "value", "test", "mem" };
    const size_t prefix = strlen(n->prefix), macro = strlen(n->macro);

    for (size_t i = 0; i < sizeof starts / sizeof *starts; i++)
        if (starts_with(name, starts[i]))
            return true;
    if (name[0] == 'e' && name[1] >= '0' && name[1] <= '9')       // what copy_name makes
        return true;
    return strcmp(name, "m") == 0 || strcmp(name, "sv") == 0 || starts_with(name, n->type) || starts_with(name, n->sv_type) ||
           (starts_with(name, n->prefix) && name[prefix] == '_') || (starts_with(name, n->macro) && name[macro] == '_');
}

// A name for the function's own variable: the element's, where that is free.
const char *copy_name(CFn *fn, uint32_t v)
{
    const char *name = fn->u->names.var[v];

    return is_taken(&fn->u->names, name) ? format_in(fn->u->arena, "e%u_%s", (unsigned)v, name) : name;
}

static void put_load(CFn *fn, const IrIns *i)
{
    if (fn->var[i->var].stamp == fn->stamp && fn->var[i->var].copy)
        put(fn, fn->var[i->var].copy);
    else
        put_cell(fn, i->var);
}

static bool is_element(const CFn *fn, const IrIns *i) { return var(fn, i->var)->space == IR_ELEMENT; }

// An F32 element where it is used: its checked reading gives a double.
static bool is_widened(const CFn *fn, IrRef r)
{
    const IrIns *i = ins(fn, r);

    return i->op == IR_load && i->type == SM_F32 && is_element(fn, i) && fn->ins[r].how == C_INLINE;
}

static bool has_copy(const CFn *fn, const IrIns *i)
{
    return fn->var[i->var].stamp == fn->stamp && fn->var[i->var].copy;
}

static void put_checked_load(CFn *fn, const IrIns *i)
{
    if (has_copy(fn, i)) {
        put_load(fn, i);
        return;
    }
    put(fn, helper_use(fn->u, i->type == SM_F32 ? "sm_read_f32" : "sm_read_f64"));
    put(fn, "(");
    put_cell(fn, i->var);
    put(fn, ")");
}

static void put_load_value(CFn *fn, const IrIns *i, int prec)
{
    bool opened;

    if (!is_element(fn, i) || c_is_integer(i->type)) {
        put_load(fn, i);
        return;
    }
    opened = open_parens(fn, i->type == SM_BOOL ? PREC_EQ : i->type == SM_F32 ? PREC_UNARY : PREC_PRIMARY, prec);
    if (i->type == SM_BOOL)
        put_load(fn, i);
    put(fn, i->type == SM_BOOL ? " != 0" : i->type == SM_F32 ? "(float)" : "");
    if (i->type != SM_BOOL)
        put_checked_load(fn, i);
    close_parens(fn, opened);
}

// ---- constants ----

// A local that is a constant has become a number: its name stands behind it as a comment.
void put_constant(CFn *fn, IrRef r, SmType type, uint64_t bits)
{
    const char *name = remark_constant(fn->u, ins(fn, r)->span);

    literal_put(fn->u, &fn->line, type, bits);
    if (*name)
        buf_printf(&fn->line, " /* %s */", name);
}

// ---- conversions ----

static const char *const to_helper[SM_TYPE_COUNT] = {
    [SM_I8] = "sm_to_i8", [SM_I16] = "sm_to_i16", [SM_I32] = "sm_to_i32", [SM_I64] = "sm_to_i64", [SM_U8] = "sm_to_u8",
    [SM_U16] = "sm_to_u16", [SM_U32] = "sm_to_u32", [SM_U64] = "sm_to_u64", [SM_F32] = "sm_to_f32", [SM_F64] = "sm_to_f64",
    [SM_BOOL] = "sm_to_bool",
};

// A truth as a number, spelled as the type of that number wants it.
static void put_choice(CFn *fn, IrRef r, const char *one_or_zero, int prec)
{
    const bool opened = open_parens(fn, PREC_ANY, prec);

    put_condition(fn, r, false, PREC_OR);
    put(fn, one_or_zero);
    close_parens(fn, opened);
}

// The text of r, whatever its type, as a double.
static void put_double(CFn *fn, IrRef r, int prec)
{
    const IrIns *i = ins(fn, r);
    bool opened;

    if (fn->ins[r].is_const && i->type != SM_F64) {
        put_constant(fn, r, SM_F64, sm_bits(sm_cell_to_f64(i->type, fn->ins[r].bits)));
    } else if (is_widened(fn, r)) {
        put_checked_load(fn, i);
    } else if (i->type == SM_F64) {
        put_value(fn, r, prec);
    } else if (i->type == SM_BOOL) {
        put_choice(fn, r, " ? 1.0 : 0.0", prec);
    } else {
        opened = open_parens(fn, PREC_UNARY, prec);
        put(fn, "(double)");
        put_value(fn, r, PREC_PRIMARY);
        close_parens(fn, opened);
    }
}

static void put_call_on_double(CFn *fn, const char *helper, IrRef r)
{
    put(fn, helper_use(fn->u, helper));
    put(fn, "(");
    put_double(fn, r, PREC_ANY);
    put(fn, ")");
}

static void put_cast(CFn *fn, SmType to, IrRef r, int prec)
{
    const bool opened = open_parens(fn, PREC_UNARY, prec);

    put(fn, "(");
    put(fn, c_type_of(to));
    put(fn, ")");
    put_value(fn, r, PREC_PRIMARY);
    close_parens(fn, opened);
}

// A truth of a number that is never NaN.
static void put_not_zero(CFn *fn, IrRef r, bool negated, int prec)
{
    const bool opened = open_parens(fn, PREC_EQ, prec);

    put_value(fn, r, PREC_REL);
    put(fn, negated ? " == " : " != ");
    put(fn, sm_type_info[ins(fn, r)->type].kind == SM_KIND_FLOAT ? "0.0" : "0");
    close_parens(fn, opened);
}

static void put_cvt(CFn *fn, const IrIns *i, int prec)
{
    const SmType from = ins(fn, i->a)->type, to = i->type;
    const CRange r = fn->ins[i->a].range;

    if (from == SM_F64 && integer_put_cvt(fn, i->a, to, prec))
        return;
    if (to == SM_F64 && (from != SM_F64 || !r.nan))
        put_double(fn, i->a, prec);
    else if (from == to && !r.nan)
        put_value(fn, i->a, prec);
    else if (from == SM_BOOL)
        put_choice(fn, i->a, to == SM_F32 ? " ? 1.0f : 0.0f" : " ? 1 : 0", prec);
    else if (to == SM_BOOL && !r.nan)
        put_not_zero(fn, i->a, false, prec);
    else if ((to == SM_F32 && !r.nan) || (to != SM_F32 && to != SM_BOOL && to != SM_F64 && range_fits(r, to)))
        put_cast(fn, to, i->a, prec);
    else
        put_call_on_double(fn, to_helper[to], i->a);
}

// ---- the rest ----

static void put_binary(CFn *fn, const IrIns *i, const char *text, int own, int prec)
{
    const bool opened = open_parens(fn, own, prec);

    put_value(fn, i->a, own);
    put(fn, text);
    put_value(fn, i->b, own + 1);         // floating-point operators do not associate
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
    const bool opened = open_parens(fn, PREC_UNARY, prec);

    put(fn, "-");
    put_value(fn, i->a, PREC_PRIMARY);
    close_parens(fn, opened);
}

static const char *const stat_helper[SM_STAT_COUNT] = {
    "sm_roll_avg", "sm_roll_median", "sm_roll_min", "sm_roll_max", "sm_roll_range"
};

static void put_stat(CFn *fn, const IrIns *i)
{
    fn->uses_m = true;
    buf_printf(&fn->line, "%s(&m->%s)", helper_use(fn->u, stat_helper[i->stat]), fn->u->window[i->var]);
}

static void put_literal(CFn *fn, IrRef r, uint64_t bits, int prec)
{
    const IrIns *i = ins(fn, r);
    const SmKind kind = sm_type_info[i->type].kind;
    const bool sign_bit = (bits >> (sm_type_info[i->type].bytes * 8 - 1) & 1) != 0;
    const bool negative = sign_bit && (kind == SM_KIND_FLOAT || kind == SM_KIND_SIGNED);
    const bool opened = open_parens(fn, negative ? PREC_UNARY : PREC_PRIMARY, prec);

    put_constant(fn, r, i->type, bits);
    close_parens(fn, opened);
}

void put_value(CFn *fn, IrRef r, int prec)
{
    const IrIns *i = ins(fn, r);
    const CIns *c = &fn->ins[r];

    if (c->is_const) {
        put_literal(fn, r, c->bits, prec);
        return;
    }
    if (c->variable) {
        put(fn, c->variable);
        return;
    }
    switch (i->op) {
    case IR_load: put_load_value(fn, i, prec); break;
    case IR_cvt: put_cvt(fn, i, prec); break;
    case IR_add: put_binary(fn, i, " + ", PREC_ADD, prec); break;
    case IR_sub: put_binary(fn, i, " - ", PREC_ADD, prec); break;
    case IR_mul: put_binary(fn, i, " * ", PREC_MUL, prec); break;
    case IR_div: put_binary(fn, i, " / ", PREC_MUL, prec); break;
    case IR_neg: put_negative(fn, i, prec); break;
    case IR_abs: put_call(fn, "sm_abs", i->a, IR_NONE); break;
    case IR_floor: put_call(fn, "sm_floor", i->a, IR_NONE); break;
    case IR_ceil: put_call(fn, "sm_ceil", i->a, IR_NONE); break;
    case IR_trunc: put_call(fn, "sm_trunc", i->a, IR_NONE); break;
    case IR_round: put_call(fn, "sm_round", i->a, IR_NONE); break;
    case IR_sqrt: put_call(fn, "sm_sqrt", i->a, IR_NONE); break;
    case IR_sign: put_call(fn, "sm_sign", i->a, IR_NONE); break;
    case IR_min: put_call(fn, "sm_min", i->a, i->b); break;
    case IR_max: put_call(fn, "sm_max", i->a, i->b); break;
    case IR_eq: case IR_ne: case IR_lt: case IR_le: case IR_gt: case IR_ge: put_compare(fn, i, false, prec); break;
    case IR_and: case IR_or: put_logic(fn, i, prec); break;
    case IR_not: put_condition(fn, i->a, true, prec); break;
    case IR_stat: put_stat(fn, i); break;
    case IR_const: case IR_store: case IR_sample: case IR_OP_COUNT: break;
    }
}

// A bool where C wants a truth: an element's byte needs no comparison there.
void put_condition(CFn *fn, IrRef r, bool negated, int prec)
{
    const IrIns *i = ins(fn, r);
    const bool inside = !fn->ins[r].is_const && !fn->ins[r].variable;
    const SmType from = inside && i->op == IR_cvt ? ins(fn, i->a)->type : SM_TYPE_COUNT;

    if (inside && i->op == IR_not) {
        put_condition(fn, i->a, !negated, prec);
    } else if (inside && i->op >= IR_eq && i->op <= IR_ge) {
        put_compare(fn, i, negated, prec);
    } else if (inside && i->op == IR_cvt && from == SM_BOOL) {
        put_condition(fn, i->a, negated, prec);
    } else if (inside && i->op == IR_cvt && !fn->ins[i->a].range.nan) {
        put_not_zero(fn, i->a, negated, prec);
    } else if (inside && i->op == IR_load) {
        put(fn, negated ? "!" : "");
        put_load(fn, i);
    } else if (negated) {
        put(fn, "!");
        put_value(fn, r, PREC_PRIMARY);
    } else {
        put_value(fn, r, prec);
    }
}
