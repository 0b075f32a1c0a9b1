// SPDX-License-Identifier: Apache-2.0
// A pin file as C: two tables of constants for runtime-c/io.h, one for inputs and one for outputs.
#include <string.h>

#include "compiler/emit/c/emit_c.h"
#include "compiler/emit/c/unit.h"

typedef struct IoUnit {
    Arena *arena;
    const IoMap *io;
    const char *prefix, *vector;      // for its own names, and for those of the state vector
    const char *source;               // the .io, for comments
} IoUnit;

static const char *prefix_of(Arena *a, const char *wanted, Str name)
{
    return c_identifier(a, wanted ? wanted : name->text, wanted ? strlen(wanted) : name->len);
}

static void write_title(const IoUnit *u, Buf *out)
{
    buf_printf(out, "// The pins of %s.  Made by smc from %s: change that, not this file.\n", u->io->name->text, u->source);
}

static void write_header(const IoUnit *u, Buf *out)
{
    const char *macro = c_macro_name(u->arena, u->prefix);

    write_title(u, out);
    buf_printf(out, "#ifndef %s_IO_H_INCLUDED\n#define %s_IO_H_INCLUDED\n\n#include \"runtime-c/io.h\"\n\n", macro, macro);
    buf_str(out, "#ifdef __cplusplus\nextern \"C\" {\n#endif\n\n");
    buf_printf(out, "extern SmIo %s_inputs, %s_outputs;\n", u->prefix, u->prefix);
    buf_str(out, "\n#ifdef __cplusplus\n}\n#endif\n\n#endif\n");
}

// ---- the tables ----

static const char *const kind_names[] = {"SM_ANALOG_IN", "SM_ANALOG_OUT", "SM_DIGITAL_IN", "SM_DIGITAL_OUT"};   // by PinKind

static const char *type_name(SmType t)
{
    static const char *const names[] = {
#define SM_TYPE(name, wire, spelling, ctype, bytes, kind) "SM_" #name,
#include "stdlib/types.def"
#undef SM_TYPE
    };

    return names[t];
}

static const char *flags(Arena *a, const Pin *p)
{
    const char *pull = p->pull_up ? "SM_IO_PULL_UP" : p->pull_down ? "SM_IO_PULL_DOWN" : NULL;

    if (!p->inverted)
        return pull ? pull : "0";
    return pull ? format_in(a, "SM_IO_INVERTED | %s", pull) : "SM_IO_INVERTED";
}

// Written as bits, so that the number is the same whatever this compiler's double is.
static void write_number(SmF64 x, Buf *out)
{
    if (sm_bits(x) == 0)
        buf_str(out, ", 0");
    else
        buf_printf(out, ", 0x%08lx%08lxu", (unsigned long)(sm_bits(x) >> 32), (unsigned long)(sm_bits(x) & 0xffffffffu));
}

// The element and its parameters, as a comment for readers of the table.
static const char *as_written(Arena *a, const Pin *p)
{
    const char *text = p->element->name->text;

    if (!pin_is_digital(p) && !sm_eq(p->scale, sm_from_i32(1)))
        text = format_in(a, "%s, scale %s", text, const_text(a, p->scale));
    if (!sm_eq(p->offset, sm_from_i32(0)))
        text = format_in(a, "%s, offset %s", text, const_text(a, p->offset));
    if (!sm_eq(p->safe, sm_from_i32(0)))
        text = format_in(a, "%s, safe %s", text, const_text(a, p->safe));
    return text;
}

static void write_pin(const IoUnit *u, const Pin *p, Buf *out)
{
    buf_printf(out, "    {%s, %s, %s, %u, %u, %lu", kind_names[p->kind], type_name(p->element->type), flags(u->arena, p),
               (unsigned)p->hold, (unsigned)p->number, (unsigned long)p->element->offset);
    write_number(pin_is_digital(p) ? sm_from_i32(0) : p->scale, out);
    write_number(p->offset, out);
    write_number(p->safe, out);
    buf_printf(out, "},   // %s\n", as_written(u->arena, p));
}

static size_t count_pins(const IoMap *io, bool output)
{
    size_t n = 0;

    for (size_t i = 0; i < io->pin.n; i++)
        n += pin_is_output(&io->pin.at[i]) == output;
    return n;
}

static void write_table(const IoUnit *u, bool output, Buf *out)
{
    const char *p = u->prefix, *what = output ? "output" : "input";
    const unsigned long n = (unsigned long)count_pins(u->io, output);

    if (n == 0) {
        buf_printf(out, "\nSmIo %s_%ss = {0, 0, &%s_vector, 0, 0, 0, 0};\n", p, what, u->vector);
        return;
    }
    buf_printf(out, "\nstatic const SmIoPin %s[%lu] = {\n", what, n);
    for (size_t i = 0; i < u->io->pin.n; i++)
        if (pin_is_output(&u->io->pin.at[i]) == output)
            write_pin(u, &u->io->pin.at[i], out);
    buf_printf(out, "};\nstatic uint8_t %s_handle[%lu];\nstatic uint16_t %s_missed[%lu];\nstatic uint64_t %s_value[%lu];\n\n", what, n, what, n, what, n);
    buf_printf(out, "SmIo %s_%ss = {%s, %lu, &%s_vector, %s_handle, %s_missed, %s_value, 0};\n", p, what, what, n, u->vector, what,
               what, what);
}

static void write_code(const IoUnit *u, const char *header, Buf *out)
{
    write_title(u, out);
    buf_printf(out, "#include \"%s\"\n\n#include \"%s.h\"\n\n", header, u->io->sv->name->text);
    // Offsets are those of one layout: with another vector the code does not compile.
    buf_printf(out, "#if %s_SV_LAYOUT != 0x%08xu\n#error \"%s_io was generated from another state vector: build it again\"\n#endif\n\n",
               c_macro_name(u->arena, u->vector), u->io->sv->hash, u->prefix);
    buf_str(out, "// kind, type, flags, hold, pin, offset in the state vector; scale, offset and safe value as bits of a binary64.\n");
    write_table(u, false, out);
    write_table(u, true, out);
}

void emit_c_io(Arena *arena, const IoMap *io, const EmitCOptions *o, Buf *header, Buf *code)
{
    IoUnit u = {arena, io, prefix_of(arena, o ? o->prefix : NULL, io->name), prefix_of(arena, NULL, io->sv->name), NULL};

    u.source = o && o->source ? o->source : format_in(arena, "%s.io", io->name->text);
    write_header(&u, header);
    write_code(&u, o && o->header ? o->header : format_in(arena, "%s_io.h", io->name->text), code);
}
