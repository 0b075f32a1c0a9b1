// SPDX-License-Identifier: Apache-2.0
// Declarations: the struct of the state vector, that of the machine, its states and statuses, and the prototypes.
#include <string.h>

#include "compiler/emit/c/unit.h"

// Returns the C type of a value of `type`.
const char *c_type_of(const CUnit *u, SmType type)
{
    switch (type) {
    case SM_I8: return "int8_t";
    case SM_I16: return "int16_t";
    case SM_I32: return "int32_t";
    case SM_I64: return "int64_t";
    case SM_U8: return "uint8_t";
    case SM_U16: return "uint16_t";
    case SM_U32: return "uint32_t";
    case SM_U64: return "uint64_t";
    case SM_F32: return "float";
    case SM_F64: return u->soft ? "SmF64" : "double";
    case SM_BOOL: return "bool";
    case SM_TYPE_COUNT: break;
    }
    return "";
}

// ---- the state vector ----

// Writes a member for the bytes from `from` to `to`, which no element occupies.
static void write_padding(Arena *a, Buf *out, uint32_t from, uint32_t to)
{
    if (from < to)
        buf_printf(out, "    uint8_t  %s[%u];\n", c_padding_name(a, from), (unsigned)(to - from));
}

// Writes `type name;` and its comment, in columns.
static void write_member(Buf *out, const char *type, const char *name, const char *comment)
{
    const size_t start = out->n;

    buf_printf(out, "    %-8s %s;", type, name);
    if (*comment) {
        buf_spaces(out, out->n - start < 38 ? 38 - (out->n - start) : 2);
        buf_printf(out, "// %s", comment);
    }
    buf_char(out, '\n');
}

// Returns the source name of a member that has another name in C, otherwise "".
static const char *source_name_if_renamed(const char *member, Str name) { return strcmp(member, name->text) != 0 ? name->text : ""; }

// Returns `first: second`, the comment of a member.  Either can be "".
static const char *join_comments(Arena *a, const char *first, const char *second)
{
    return *first && *second ? format_in(a, "%s: %s", first, second) : *first ? first : second;
}

// Whether the header includes stdlib/f64.h.  The header of a state vector for the flight runtime does; the header of a machine is self-contained.
static bool can_use_sm_f64(const CUnit *u) { return u->runtime && !u->m; }

static void write_element_member(const CUnit *u, const CElement *e, Buf *out)
{
    Arena *a = u->arena;
    const char *name = source_name_if_renamed(e->member, e->name), *remark = remark_of_line(a, e->span);

    // A uint8_t, because C's bool can have any size, and reading a byte other than 0 or 1 as a bool is undefined.
    if (e->type == SM_BOOL)
        write_member(out, "uint8_t", e->member, join_comments(a, *name ? format_in(a, "bool %s", name) : "bool", remark));
    else
        write_member(out, can_use_sm_f64(u) && e->type == SM_F64 ? "SmF64" : c_type_of(u, e->type), e->member, join_comments(a, name, remark));
}

static void write_vector_members(const CUnit *u, const CVector *sv, Buf *out)
{
    Arena *a = u->arena;
    uint32_t at = 0;
    Str region = NULL;

    for (size_t i = 0; i < sv->n; i++) {
        const CElement *e = &sv->at[i];
        write_padding(a, out, at, e->offset);
        if (sv->shared && e->region != region)
            buf_printf(out, "%s    // [%s]\n", i ? "\n" : "", e->region->text);
        region = e->region;
        write_element_member(u, e, out);
        at = e->offset + sm_type_info[e->type].bytes;
    }
    write_padding(a, out, at, sv->size);
}

static void write_vector_comment(const CVector *sv, Buf *out)
{
    if (sv->shared)
        buf_printf(out, "// The state vector of %s.sv.  Every machine built with it declares this struct, and they can be used together.\n"
                        "// ", sv->name);
    else
        buf_printf(out, "// The state vector: what the machine reads and writes.\n// ");
    buf_str(out, "The layout is the same on every target, without hidden padding.  A bool is a byte: 0 is false,\n"
                 "// anything else true.\n");
}

void c_write_vector_struct(const CUnit *u, Buf *out)
{
    const CNames *n = &u->names;

    write_vector_comment(&u->sv, out);
    buf_printf(out, "#if !defined(%s_LAYOUT)\n#define %s_LAYOUT 0x%08xu\n", n->sv_macro, n->sv_macro, u->sv.hash);
    buf_printf(out, "typedef struct %s {\n", n->sv_type);
    write_vector_members(u, &u->sv, out);
    buf_printf(out, "} %s;\n#define %s_SIZE %u      // bytes\n", n->sv_type, n->sv_macro, u->sv.size);
    buf_printf(out, "#elif %s_LAYOUT != 0x%08xu\n", n->sv_macro, u->sv.hash);
    buf_printf(out, "#error \"%s: this header and one included before it were generated from different state vectors\"\n#endif\n",
               n->sv_type);
}

// Writes the check of the struct's size, for the source file: foreign function interfaces read the header, and most cannot evaluate it.
void c_write_vector_check(const CUnit *u, Buf *out)
{
    buf_printf(out, "// Does not compile if the compiler inserts padding into the state vector or has types of other sizes.\n"
                    "typedef char %s_layout_check[sizeof(%s) == %s_SIZE ? 1 : -1];\n", u->names.sv_type, u->names.sv_type, u->names.sv_macro);
}

// ---- the machine ----

static void write_status_enum(const CNames *n, Buf *out)
{
    buf_printf(out, "typedef enum %sStatus {\n", n->type);
    buf_printf(out, "    %s_OK,\n", n->macro);
    buf_printf(out, "    %s_REFUSED,     // step: time did not advance; nothing changed\n", n->macro);
    buf_printf(out, "    %s_NO_STATE,    // init: no state has that number; step: init has not succeeded\n", n->macro);
    buf_printf(out, "    %s_UNFIT        // init: built or run in a way that changes the results of arithmetic\n", n->macro);
    buf_printf(out, "} %sStatus;\n", n->type);
}

static void write_state_enum(const CUnit *u, Buf *out)
{
    const CNames *n = &u->names;
    const size_t states = u->m->state.n;

    buf_printf(out, "// States by number.  The first is the initial state, unless init is called with another.\n"
                    "enum {\n");
    for (size_t i = 0; i < states; i++) {
        const char *name = source_name_if_renamed(n->state[i], u->m->state.at[i].name);
        buf_printf(out, "    %s_STATE_%s = %u,%s%s\n", n->macro, n->state[i], (unsigned)i + 1, *name ? "     // " : "", name);
    }
    buf_printf(out, "    %s_INITIAL_STATE = 1,\n    %s_STATES = %u      // their number\n};\n", n->macro, n->macro,
               (unsigned)states);
}

// Whether variable v is S or an element that the machine may assign.
bool c_is_output(const IrMachine *m, size_t v)
{
    return m->var.at[v].space == IR_ELEMENT && (m->var.at[v].writable || v == m->s);
}

static void write_stored_struct(const CUnit *u, Buf *out)
{
    buf_printf(out, "// The elements that were stored by the last step that was not refused.\n"
                    "typedef struct %sStored {\n", u->names.type);
    for (size_t v = 0; v < u->m->var.n; v++)
        if (c_is_output(u->m, v))
            buf_printf(out, "    bool %s;\n", u->names.var[v]);
    buf_printf(out, "} %sStored;\n", u->names.type);
}

static void write_local_member(const CUnit *u, size_t v, Buf *out)
{
    const IrVar *var = &u->m->var.at[v];

    write_member(out, c_type_of(u, var->type), u->names.var[v],
               join_comments(u->arena, source_name_if_renamed(u->names.var[v], var->name), remark_of_line(u->arena, var->span)));
}

static void write_window_member(const CUnit *u, size_t w, const char *call, Buf *out)
{
    const IrWindow *win = &u->m->window.at[w];

    if (ir_stores_times(win))
        write_member(out, "uint64_t", u->ring[w], "number of times, and the next slot");
    else if (c_begins_ring(u, w))
        write_member(out, "uint64_t", u->ring[w],
                     format_in(u->arena, "number of samples in the windows of %u, and the next slot", (unsigned)win->size));
    write_member(out, "uint64_t", c_window_declaration(u, w),
               call ? call : ir_stores_times(win) ? "times" : format_in(u->arena, "samples of the last %u steps", (unsigned)win->size));
}

// Writes the members of the parameters, of the locals that blocks store, or of the others, below a comment.
static void write_local_members(const CUnit *u, bool parameters, bool stored, const char *comment, Buf *out)
{
    for (size_t v = 0; v < u->m->var.n; v++) {
        const IrVar *var = &u->m->var.at[v];
        if (var->space != IR_LOCAL || (var->parameter != NULL) != parameters || var->writable != stored)
            continue;
        buf_str(out, comment);
        comment = "";
        write_local_member(u, v, out);
    }
}

static void write_machine_struct(CUnit *u, Buf *out)
{
    const IrMachine *m = u->m;
    const char **call = remark_window_calls(u);

    buf_printf(out, "// The machine.  A copy of the struct is a copy of the machine.  Members are for reading only; those that end in an underscore are\n"
                    "// private.\ntypedef struct %s {\n", u->names.type);
    write_member(out, c_state_type(u), "state_", "the state that the next step runs; 0 before init");
    write_member(out, "bool", "first_", "the next step is the state's first");
    write_member(out, "uint64_t", "gate_", u->soft ? "time of the last step plus 1; 0 before the first"
                 : "how far time could advance after the last step");
    if (!u->soft)
        write_member(out, "uint64_t", "left_", "that value while gate_ is 0, before a state's first step");
    write_member(out, "uint64_t", "start_", "time of the state's first step");
    if (u->track_stores)
        write_member(out, format_in(u->arena, "%sStored", u->names.type), "stored", "what the last step that ran stored");
    write_local_members(u, true, false, format_in(u->arena, "\n    // parameters: set them with %s_set_parameters\n", u->names.prefix), out);
    write_local_members(u, false, true, "\n    // [local]\n", out);
    write_local_members(u, false, false, "\n    // [local], never stored: the code contains their values, and a change here has no defined effect\n",
                        out);
    if (m->window.n)
        buf_str(out, "\n    // rolling windows\n");
    for (size_t w = 0; w < m->window.n; w++)
        write_window_member(u, w, call[w], out);
    buf_printf(out, "} %s;\n", u->names.type);
}

void c_write_machine_types(CUnit *u, Buf *out)
{
    write_status_enum(&u->names, out);
    buf_char(out, '\n');
    write_state_enum(u, out);
    buf_char(out, '\n');
    if (u->track_stores) {
        write_stored_struct(u, out);
        buf_char(out, '\n');
    }
    if (u->m->window.n) {
        helper_write_type(u, "SmRoll", out);
        buf_char(out, '\n');
        c_write_window_sizes(u, out);
    }
    write_machine_struct(u, out);
    if (c_has_parameters(u))
        buf_char(out, '\n');
    c_write_parameter_types(u, out);
}

void c_write_prototypes(const CUnit *u, Buf *out)
{
    const CNames *n = &u->names;

    buf_printf(out, "// Starts the machine in a state: writes its number to the state vector, and the locals' initial values.  After any other\n"
                    "// status than %s_OK the machine refuses to step.\n", n->macro);
    buf_printf(out, "%sStatus %s_init(%s *m, %s *sv, uint32_t state);\n\n", n->type, n->prefix, n->type, n->sv_type);
    c_write_parameter_prototypes(u, out);
    buf_printf(out, "// Runs one step.  Time, sv->%s, must have advanced since the last step that ran.\n", n->var[u->m->g]);
    buf_printf(out, "%sStatus %s_step(%s *m, %s *sv);\n\n", n->type, n->prefix, n->type, n->sv_type);
    buf_printf(out, "// The number of the state that the next step runs.\n");
    buf_printf(out, "uint32_t %s_state(const %s *m);\n\n", n->prefix, n->type);
    buf_printf(out, "// T, the time in the current state, at the last step that ran.\n");
    buf_printf(out, "uint64_t %s_T(const %s *m);\n\n", n->prefix, n->type);
    buf_printf(out, "// A state's name as in the source; \"\" if no state has that number.\n");
    buf_printf(out, "const char *%s_state_name(uint32_t state);\n", n->prefix);
    if (u->soft)
        return;
    buf_printf(out, "\n// sizeof(%s) and sizeof(%s), for callers in other languages.\n", n->type, n->sv_type);
    buf_printf(out, "uint32_t %s_size(void);\nuint32_t %s_sv_size(void);\n", n->prefix, n->prefix);
}
