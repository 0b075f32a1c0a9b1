// SPDX-License-Identifier: Apache-2.0
// The parameters of a machine (language.md 5.77): a struct of their values, and the functions that read and set them.  A machine without
// parameters has neither.
#include "compiler/emit/c/unit.h"
#include "stdlib/convert.h"

bool c_has_parameters(const CUnit *u)
{
    for (size_t v = 0; v < u->m->var.n; v++)
        if (u->m->var.at[v].parameter)
            return true;
    return false;
}

// ---- the header ----

static void write_member(CUnit *u, size_t v, Buf *out)
{
    const IrVar *var = &u->m->var.at[v];
    const size_t start = out->n;

    buf_printf(out, "    %-8s %s;", c_type_of(u, var->type), u->names.var[v]);
    if (var->type != SM_BOOL) {
        buf_spaces(out, out->n - start < 38 ? 38 - (out->n - start) : 2);
        buf_printf(out, "// %s to %s", const_text(u->arena, var->parameter->lo), const_text(u->arena, var->parameter->hi));
    }
    buf_char(out, '\n');
}

void c_write_parameter_types(CUnit *u, Buf *out)
{
    if (!c_has_parameters(u))
        return;
    buf_printf(out, "// Values of the machine's parameters.\ntypedef struct %sParameters {\n", u->names.type);
    for (size_t v = 0; v < u->m->var.n; v++)
        if (u->m->var.at[v].parameter)
            write_member(u, v, out);
    buf_printf(out, "} %sParameters;\n\n", u->names.type);
}

void c_write_parameter_prototypes(const CUnit *u, Buf *out)
{
    const CNames *n = &u->names;

    if (!c_has_parameters(u))
        return;
    buf_str(out, "// Reads the parameters of a machine that init has started: after init they have their defaults.\n");
    buf_printf(out, "void %s_get_parameters(const %s *m, %sParameters *values);\n\n", n->prefix, n->type, n->type);
    buf_str(out, "// Sets the parameters of a machine that init has started and that has not stepped.  Returns 0; or the number, from 1 on in the order of\n"
                 "// the struct, of the first value that is NaN or outside its range, and then nothing has changed.  Of a machine that has stepped, or has\n"
                 "// not been started, it refuses every value.\n");
    buf_printf(out, "uint32_t %s_set_parameters(%s *m, const %sParameters *values);\n\n", n->prefix, n->type, n->type);
}

// ---- the code ----

// Whether the variable's type has no value beyond `end`, an end of the parameter's range: a comparison with `end` would always be true.
static bool is_end_of_type(const IrVar *var, SmF64 end, SmF64 beyond)
{
    return ir_is_integer(var->type) && sm_cell_from_f64(var->type, end) == sm_cell_from_f64(var->type, beyond);
}

// Writes ` && lo <= x` or ` && x <= hi`, which NaN does not fulfil.
static void write_bound(CUnit *u, size_t v, bool is_lowest, Buf *out)
{
    const IrVar *var = &u->m->var.at[v];
    const SmF64 end = is_lowest ? var->parameter->lo : var->parameter->hi;
    const char *const call = u->soft && var->type == SM_F64 ? helper_require(u, "sm_le") : NULL;
    Buf bound;

    if (var->type == SM_BOOL || is_end_of_type(var, end, sm_from_bits(is_lowest ? 0xFFEFFFFFFFFFFFFFu : 0x7FEFFFFFFFFFFFFFu)))
        return;
    buf_init(&bound, u->arena);
    literal_write(u, &bound, var->type, sm_cell_from_f64(var->type, end));
    buf_str(out, " && ");
    if (call)
        buf_printf(out, "%s(%s%s, %s%s)", call, is_lowest ? "" : "values->", is_lowest ? buf_text(&bound) : u->names.var[v],
                   is_lowest ? "values->" : "",
                   is_lowest ? u->names.var[v] : buf_text(&bound));
    else
        buf_printf(out, "values->%s %s %s", u->names.var[v], is_lowest ? ">=" : "<=", buf_text(&bound));
}

static void write_getter(const CUnit *u, Buf *out)
{
    const CNames *n = &u->names;

    buf_printf(out, "void %s_get_parameters(const %s *m, %sParameters *values)\n{\n", n->prefix, n->type, n->type);
    for (size_t v = 0; v < u->m->var.n; v++)
        if (u->m->var.at[v].parameter)
            buf_printf(out, "    values->%s = m->%s;\n", n->var[v], n->var[v]);
    buf_str(out, "}\n\n");
}

static void write_setter(CUnit *u, Buf *out)
{
    const CNames *n = &u->names;
    unsigned number = 0;

    buf_printf(out, "uint32_t %s_set_parameters(%s *m, const %sParameters *values)\n{\n", n->prefix, n->type, n->type);
    buf_printf(out, "    const bool fresh = %s;\n\n",
               u->soft ? "m->state_ != 0 && m->first_ && m->gate_ == 0" : "m->state_ != 0 && m->first_ && m->gate_ == 0 && m->left_ == UINT64_MAX");
    for (size_t v = 0; v < u->m->var.n; v++) {
        if (!u->m->var.at[v].parameter)
            continue;
        buf_str(out, "    if (!(fresh");
        write_bound(u, v, true, out);
        write_bound(u, v, false, out);
        buf_printf(out, ")) {\n        return %u;\n    }\n", ++number);
    }
    for (size_t v = 0; v < u->m->var.n; v++)
        if (u->m->var.at[v].parameter)
            buf_printf(out, "    m->%s = values->%s;\n", n->var[v], n->var[v]);
    buf_str(out, "    return 0;\n}\n\n");
}

void c_write_parameters(CUnit *u, Buf *out)
{
    if (!c_has_parameters(u))
        return;
    write_getter(u, out);
    write_setter(u, out);
}
