// SPDX-License-Identifier: Apache-2.0
#include "compiler/emit/c/emit_c.h"

#include <stdlib.h>
#include <string.h>

#include "compiler/emit/c/fn.h"

const char *emit_c_prefix_error(const char *prefix)
{
    for (const char *p = prefix; *p; p++)
        if (!strchr("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_", *p))
            return "a prefix is made of letters, digits and underscores";
    if (prefix[0] == '\0' || strchr("0123456789_", prefix[0]))
        return "a prefix begins with a letter";
    if (strstr(prefix, "__") || prefix[strlen(prefix) - 1] == '_')
        return "a prefix has no two underscores in a row and none at its end";
    if (c_is_ours(prefix))
        return "names that begin with sm_, smvm_ and pal_ are the runtime's own";
    return NULL;
}

// ---- the state vector ----

static CElement element_of(const Element *e)
{
    CElement c = { 0 };

    c.type = e->type;
    c.offset = e->offset;
    c.name = e->name;
    c.span = e->span;
    c.region = e->region ? e->region->name : NULL;
    return c;
}

static void vector_of(Arena *a, const StateVec *sv, CVector *out)
{
    out->at = ARENA_ARRAY(a, CElement, sv->element.n);
    out->n = sv->element.n;
    for (size_t i = 0; i < out->n; i++)
        out->at[i] = element_of(sv->element.at[i]);
    out->size = sv->size;
    out->hash = sv->hash;
    out->name = sv->name->text;
    out->shared = !sv->from_machine;
}

static int by_offset(const void *a, const void *b)
{
    const uint32_t x = ((const CElement *)a)->offset, y = ((const CElement *)b)->offset;

    return (x > y) - (x < y);
}

// For a machine that was read from IR text: only the elements that it lists are known.
static void vector_of_machine(Arena *a, const IrMachine *m, CVector *out)
{
    out->at = ARENA_ARRAY(a, CElement, m->var.n);
    for (size_t v = 0; v < m->var.n; v++) {
        if (m->var.at[v].space != IR_ELEMENT)
            continue;
        out->at[out->n].type = m->var.at[v].type;
        out->at[out->n].offset = m->var.at[v].offset;
        out->at[out->n++].name = m->var.at[v].name;
    }
    qsort(out->at, out->n, sizeof *out->at, by_offset);
    out->size = m->sv_size;
    out->hash = m->sv_hash;
    out->name = m->sv_name->text;
}

// ---- the unit ----

static const char *prefix_of(Arena *a, const char *wanted, const char *name)
{
    return wanted ? c_identifier(a, wanted, strlen(wanted)) : c_identifier(a, name, strlen(name));
}

void unit_init(CUnit *u, Arena *a, const IrMachine *m, const char *prefix, const char *sv_prefix)
{
    memset(u, 0, sizeof *u);
    u->arena = a;
    u->m = m;
    if (m->program)
        vector_of(a, m->program->sv, &u->sv);
    else
        vector_of_machine(a, m, &u->sv);
    if (!sv_prefix)
        sv_prefix = u->sv.shared ? prefix_of(a, NULL, u->sv.name) : prefix;
    u->names.sv_type = format_in(a, "%sSv", c_type_name(a, sv_prefix));
    u->names.sv_macro = format_in(a, "%s_SV", c_macro_name(a, sv_prefix));
    names_init(u, prefix);
    u->helper = ARENA_ARRAY(a, uint32_t, helper_count());
    u->var_use = ARENA_ARRAY(a, CVarUse, m->var.n);
    u->window_asked = ARENA_ARRAY(a, uint32_t, m->window.n);
    u->window_sample = ARENA_ARRAY(a, uint32_t, m->window.n);
    for (size_t w = 0; w < m->window.n; w++)
        u->window_sample[w] = UINT32_MAX;
    u->facts = m->values;
    u->fit = format_in(a, "%s_is_fit", prefix);
}

// Chooses soft numbers or not; soft ones need no self-test of the computer's arithmetic.
void unit_soften(CUnit *u, bool soft)
{
    u->soft = soft;
    u->fit = soft ? NULL : u->fit;
}

// `include`: an additional header, or NULL.
static void write_header_start(const char *macro, const char *include, bool soft, bool runtime, Buf *out)
{
    buf_printf(out, "#ifndef %s_H_INCLUDED\n#define %s_H_INCLUDED\n\n#include <stdbool.h>\n#include <stdint.h>\n\n", macro, macro);
    if (include)
        buf_printf(out, "#include \"%s\"\n%s", include, soft ? "" : "\n");
    if (soft)
        buf_printf(out, "#include \"%s\"\n\n", runtime ? "stdlib/soft_cells.h" : "sm_soft.h");
    buf_str(out, "#ifdef __cplusplus\nextern \"C\" {\n#endif\n\n");
}

static void write_header_end(Buf *out) { buf_str(out, "\n#ifdef __cplusplus\n}\n#endif\n\n#endif\n"); }

// The first line of a file.
static void write_title(const char *what, const char *name, const char *source, Buf *out)
{
    buf_printf(out, "// The state %s %s.  Made by smc from %s: change that, not this file.\n", what, name, source);
}

static const char *source_name(Arena *a, const EmitCOptions *o, const char *name, const char *ending)
{
    return o && o->source ? o->source : format_in(a, "%s.%s", name, ending);
}

static void write_header(CUnit *u, const char *source, Buf *out)
{
    write_title("machine", u->m->name->text, source, out);
    write_header_start(u->names.macro, u->runtime ? "runtime-c/machine_type.h" : NULL, u->soft, u->runtime, out);
    c_write_vector_struct(u, out);
    buf_char(out, '\n');
    c_write_machine_types(u, out);
    buf_char(out, '\n');
    c_write_prototypes(u, out);
    if (u->runtime)
        c_write_machine_type_prototype(u, out);
    write_header_end(out);
}

static const char *header_name(Arena *a, const EmitCOptions *o, const char *name)
{
    return o && o->header ? o->header : format_in(a, "%s.h", name);
}

static void write_helpers(CUnit *u, Buf *out)
{
    Buf texts;

    buf_init(&texts, u->arena);
    helpers_write(u, &texts);
    if (texts.n == 0)
        return;
    buf_str(out, "// ---- where the language differs from C ----\n"
                 "// sm_read_X returns what reading a stored X yields: a NaN reads as 0.  sm_to_X returns what storing a number in X leaves there:\n"
                 "// 0 for a NaN; integers lose the fraction and saturate.\n\n");
    buf_str(out, buf_text(&texts));
}

static void write_code(CUnit *u, const char *source, const char *header, Buf *out)
{
    Buf body;

    buf_init(&body, u->arena);
    c_write_machine(u, &body);
    write_title("machine", u->m->name->text, source, out);
    buf_printf(out, "#include \"%s\"\n\n", header);
    c_write_guards(out, u->names.prefix, u->soft);
    buf_char(out, '\n');
    if (u->fit)
        buf_printf(out, "static bool %s(void);\n\n", u->fit);
    write_helpers(u, out);
    buf_str(out, buf_text(&body));
    if (u->runtime)
        c_write_machine_type(u, out);
    if (!u->fit)
        return;
    buf_str(out, "\n// ---- self-test: whether this program's arithmetic is that of the language ----\n\n");
    c_write_self_test(u->fit, out);
}

void emit_c_machine(Arena *arena, const IrMachine *m, const EmitCOptions *o, Buf *header, Buf *code)
{
    const char *source = source_name(arena, o, m->name->text, "sm");
    CUnit u;

    unit_init(&u, arena, m, prefix_of(arena, o ? o->prefix : NULL, m->name->text), NULL);
    u.runtime = o && o->runtime;
    unit_soften(&u, o && o->soft);
    u.track_stores = (o && o->track_stores) || (u.runtime && m->program && m->program->sv->lock);
    write_header(&u, source, header);
    write_code(&u, source, header_name(arena, o, m->name->text), code);
}

// ---- the state vector alone ----

static void write_runtime_header(CUnit *u, const StateVec *sv, CVectorNames *names, Buf *header)
{
    names_runtime(u->arena, &u->names, sv, names);
    c_write_vector_struct(u, header);
    c_write_vector_interface(u, sv, names, header);
}

static void vector_unit_init(CUnit *u, Arena *arena, const StateVec *sv, const char *prefix)
{
    memset(u, 0, sizeof *u);
    u->arena = arena;
    vector_of(arena, sv, &u->sv);
    u->names.prefix = prefix;
    u->names.macro = c_macro_name(arena, prefix);
    u->names.sv_type = format_in(arena, "%sSv", c_type_name(arena, prefix));
    u->names.sv_macro = format_in(arena, "%s_SV", u->names.macro);
    names_elements(arena, &u->names, &u->sv);
}

void c_vector_names(Arena *arena, const StateVec *sv, CUnit *u)
{
    vector_unit_init(u, arena, sv, prefix_of(arena, NULL, sv->name->text));
}

void emit_c_state_vector(Arena *arena, const StateVec *sv, const EmitCOptions *o, Buf *header, Buf *code)
{
    const char *source = source_name(arena, o, sv->name->text, "sv");
    CVectorNames names;
    CUnit u;

    vector_unit_init(&u, arena, sv, prefix_of(arena, o ? o->prefix : NULL, sv->name->text));
    u.runtime = o && o->runtime;
    unit_soften(&u, o && o->soft);
    write_title("vector", sv->name->text, source, header);
    write_header_start(u.names.sv_macro, u.runtime ? "runtime-c/statevec.h" : NULL, u.soft, u.runtime, header);
    if (u.runtime)
        write_runtime_header(&u, sv, &names, header);
    else
        c_write_vector_struct(&u, header);
    write_header_end(header);
    write_title("vector", sv->name->text, source, code);
    buf_printf(code, "#include \"%s\"\n", header_name(arena, o, sv->name->text));
    if (u.runtime)
        c_write_vector_tables(&u, sv, &names, code);
}

// ---- an image as a constant, for programs without files, such as Arduino sketches ----

void emit_c_bytes(const Buf *image, Buf *out)
{
    const unsigned char *at = (const unsigned char *)image->at;

    for (size_t i = 0; i < image->n; i++)
        buf_printf(out, "%s0x%02x,", i % 16 == 0 ? "\n    " : " ", at[i]);
}

void emit_c_image(Arena *arena, const char *name, const Buf *image, const EmitCOptions *o, Buf *out)
{
    const char *wanted = o->prefix ? o->prefix : name, *prefix = c_identifier(arena, wanted, strlen(wanted));
    const char *macro = c_macro_name(arena, prefix);

    buf_printf(out, "// The bytecode of %s as an array.  Made by smc from %s: change that, not this file.\n", name, o->source);
    buf_printf(out, "#ifndef %s_IMAGE_H_INCLUDED\n#define %s_IMAGE_H_INCLUDED\n\n#include <stdint.h>\n\n", macro, macro);
    buf_printf(out,
               "#ifdef __AVR__      // constants are copied into RAM unless they are placed in flash\n#include <avr/pgmspace.h>\n"
               "#define %s_IMAGE_IN PROGMEM\n#else\n#define %s_IMAGE_IN\n#endif\n\n",
               macro, macro);
    buf_printf(out, "static const uint8_t %s_image[%u] %s_IMAGE_IN = {", prefix, (unsigned)image->n, macro);
    emit_c_bytes(image, out);
    buf_str(out, "\n};\n\n#endif\n");
}
