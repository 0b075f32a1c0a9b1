// SPDX-License-Identifier: Apache-2.0
// The SmMachineType of a machine, through which the flight runtime calls it (runtime-c/machine_type.h).  Its functions call those of the machine.
//
// Their names begin with PREFIX_any_.  They cannot clash with the functions of a state named any, which end in _entry, _step or _exit.
#include <string.h>

#include "compiler/emit/c/unit.h"

// Writes `static TYPE PREFIX_any_NAME(`.
static void write_function_head(const CUnit *u, const char *type, const char *name, Buf *out)
{
    buf_printf(out, "static %s%s%s_any_%s(", type, type[0] != '\0' && type[strlen(type) - 1] == '*' ? "" : " ", u->names.prefix, name);
}

static void write_open_function(const CUnit *u, Buf *out)
{
    write_function_head(u, "SmResult", "open", out);
    buf_printf(out, "void *self, uint32_t layout, uint32_t size)\n{\n    (void)self;\n"
                    "    return layout == %s_LAYOUT && size == sizeof(%s) ? SM_OK : SM_E_LAYOUT;\n}\n\n", u->names.sv_macro, u->names.sv_type);
}

static void write_init_function(const CUnit *u, Buf *out)
{
    const CNames *n = &u->names;

    write_function_head(u, "SmResult", "init", out);
    buf_printf(out, "void *self, void *sv, uint32_t state)\n{\n"
                    "    const %sStatus s = %s_init((%s *)self, (%s *)sv, state);\n\n"
                    "    return s == %s_OK ? SM_OK : s == %s_UNFIT ? SM_E_UNSUPPORTED : SM_E_ARGUMENT;\n}\n\n",
               n->type, n->prefix, n->type, n->sv_type, n->macro, n->macro);
}

static void write_run_function(const CUnit *u, Buf *out)
{
    const CNames *n = &u->names;

    write_function_head(u, "SmResult", "run", out);
    buf_printf(out, "void *self, void *sv)\n{\n"
                    "    const %sStatus s = %s_step((%s *)self, (%s *)sv);\n\n"
                    "    return s == %s_OK ? SM_OK : s == %s_REFUSED ? SM_REFUSED : SM_E_ARGUMENT;\n}\n\n",
               n->type, n->prefix, n->type, n->sv_type, n->macro, n->macro);
}

// Writes the functions for SmMachineType.state, .moved, .T, .name and .states.
static void write_queries(const CUnit *u, Buf *out)
{
    const CNames *n = &u->names;

    write_function_head(u, "uint32_t", "state", out);
    buf_printf(out, "const void *self)\n{\n    return %s_state((const %s *)self);\n}\n\n", n->prefix, n->type);
    buf_str(out, "// The step after a transition is a first step.\n");
    write_function_head(u, "bool", "moved", out);
    buf_printf(out, "const void *self)\n{\n    return ((const %s *)self)->first_;\n}\n\n", n->type);
    write_function_head(u, "uint64_t", "T", out);
    buf_printf(out, "const void *self)\n{\n    return %s_T((const %s *)self);\n}\n\n", n->prefix, n->type);
    write_function_head(u, "const char *", "name", out);
    buf_printf(out, "const void *self, uint32_t state)\n{\n    (void)self;\n    return %s_state_name(state);\n}\n\n", n->prefix);
    write_function_head(u, "uint32_t", "states", out);
    buf_printf(out, "const void *self)\n{\n    (void)self;\n    return %s_STATES;\n}\n\n", n->macro);
}

// Writes a function that returns a range of bytes of the state vector.
static void write_range_function(const CUnit *u, const char *name, uint32_t from, uint32_t to, Buf *out)
{
    write_function_head(u, "SmRange", name, out);
    buf_printf(out, "const void *self)\n{\n    const SmRange range = { %u, %u };\n\n    (void)self;\n    return range;\n}\n\n", (unsigned)from,
               (unsigned)(to - from));
}

static uint32_t end_offset(const IrVar *v) { return v->offset + sm_type_info[v->type].bytes; }

// Writes `uses`, the range of all elements that the machine uses, and `number`, the range of the element S.
static void write_range_functions(const CUnit *u, Buf *out)
{
    const IrMachine *m = u->m;
    uint32_t from = m->var.at[m->s].offset, to = from;

    for (size_t v = 0; v < m->var.n; v++) {
        if (m->var.at[v].space != IR_ELEMENT)
            continue;
        from = m->var.at[v].offset < from ? m->var.at[v].offset : from;
        to = end_offset(&m->var.at[v]) > to ? end_offset(&m->var.at[v]) : to;
    }
    buf_str(out, "// The range from the first element that the machine uses to the last.\n");
    write_range_function(u, "uses", from, to, out);
    write_range_function(u, "number", m->var.at[m->s].offset, end_offset(&m->var.at[m->s]), out);
}

// Writes the function that copies, from one state vector to another, the elements that the last step stored.
static void write_publish_function(const CUnit *u, Buf *out)
{
    const CNames *n = &u->names;

    if (!u->track_stores)
        return;
    write_function_head(u, "void", "publish", out);
    buf_printf(out, "const void *self, const void *from, void *to)\n{\n    const %sStored *const stored = &((const %s *)self)->stored;\n"
                    "    const %s *const a = (const %s *)from;\n    %s *const b = (%s *)to;\n\n",
               n->type, n->type, n->sv_type, n->sv_type, n->sv_type, n->sv_type);
    for (size_t v = 0; v < u->m->var.n; v++)
        if (c_is_output(u->m, v))
            buf_printf(out, "    if (stored->%s) {\n        b->%s = a->%s;\n    }\n", n->var[v], n->var[v], n->var[v]);
    buf_str(out, "}\n\n");
}

void c_write_machine_type(const CUnit *u, Buf *out)
{
    static const char *const function[] = { "open", "init", "run", "state", "moved", "T", "name", "states", "uses", "number" };

    buf_str(out, "\n// ---- the machine for the flight runtime (runtime-c/machine_type.h) ----\n\n");
    write_open_function(u, out);
    write_init_function(u, out);
    write_run_function(u, out);
    write_queries(u, out);
    write_range_functions(u, out);
    write_publish_function(u, out);
    buf_printf(out, "const SmMachineType %s_machine = {\n", u->names.prefix);
    for (size_t i = 0; i < sizeof function / sizeof function[0]; i++)
        buf_printf(out, "    %s_any_%s,\n", u->names.prefix, function[i]);
    if (u->track_stores)
        buf_printf(out, "    %s_any_publish,\n};\n", u->names.prefix);
    else
        buf_str(out, "    NULL,\n};\n");
}

void c_write_machine_type_declaration(const CUnit *u, Buf *out)
{
    buf_printf(out, "\n// The machine for the flight runtime; the self of its SmMachine is a %s.\n"
                    "extern const SmMachineType %s_machine;\n", u->names.type, u->names.prefix);
}
