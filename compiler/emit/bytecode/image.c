// SPDX-License-Identifier: Apache-2.0
// Joins the sections of an image (docs/bytecode.md) and runs the target's own verifier on the result.
#include <string.h>

#include "bytecode-vm/image.h"
#include "bytecode-vm/smvm.h"
#include "compiler/emit/bytecode/bytecode.h"
#include "stdlib/convert.h"
#include "stdlib/crc32.h"

enum { SECTIONS_MOST = 255 };

typedef struct ImageWriter {
    Arena *arena;
    Diags *diags;
    Buf table, body;          // the section table, one entry per section, whose offsets count from the start of `body`; the contents of the sections
    uint32_t sections;
} ImageWriter;

// Appends a section and its table entry, with the offset in `body`.  join_image converts it to an offset in the image, once the size of
// the table is known.
static void add_section(ImageWriter *w, uint8_t id, uint8_t version, const Buf *bytes)
{
    buf_char(&w->table, (char)id);
    buf_char(&w->table, (char)version);
    buf_u32(&w->table, (uint32_t)w->body.n);
    buf_u32(&w->table, (uint32_t)bytes->n);
    buf_put(&w->body, bytes->at, bytes->n);
    w->sections++;
}

// ---- IDENTITY: FNV-1a, 64 bits, over the source text of the machines ----

// Adds to the image a 64-bit FNV hash of the machines' source texts and of their state vectors' layouts, which identifies them.
static void add_identity(ImageWriter *w, IrMachine *const *m, size_t n)
{
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    Buf b;

    for (size_t i = 0; i < n; i++) {
        const Source *src = m[i]->program ? m[i]->program->src : NULL;
        for (uint32_t at = 0; src && at < src->len; at++)
            hash = (hash ^ (uint8_t)src->text[at]) * UINT64_C(0x100000001b3);
        hash = (hash ^ m[i]->sv_hash) * UINT64_C(0x100000001b3);
    }
    buf_init(&b, w->arena);
    buf_u64(&b, hash);
    add_section(w, SMVM_S_IDENTITY, SMVM_V_IDENTITY, &b);
}

// ---- IO ----

// Bits of the first byte of a pin: whether the row contains a scale, an offset, and the safe value (of an output) or the hold (of an input).
enum { PIN_SCALE = 0x20, PIN_OFFSET = 0x40, PIN_SAFE_OR_HOLD = 0x80 };

enum { NUMBER_F32 = 8, NUMBER_F64 = 9, NUMBER_WHOLE = 15 };      // how a pin's number is encoded: stored where a location has its type

// Whether x is a whole number that fits, signed, in the offset bits of a 24-bit location.
static bool fits_whole_number(SmF64 x)
{
    const int32_t most = (int32_t)(SMVM_LOCATION_OFFSETS / 2);

    return sm_le(sm_from_i32(-most), x) && sm_lt(x, sm_from_i32(most)) && sm_eq(sm_from_i32(sm_truncate_i32(x)), x);
}

// Writes x in the shortest encoding that is exact: a whole number of 20 bits, an f32 or an f64.
static void write_number(Buf *b, SmF64 x)
{
    if (fits_whole_number(x)) {
        bc_write_u24(b, bc_pack_offset((uint32_t)sm_truncate_i32(x), NUMBER_WHOLE));
    } else if (sm_eq(sm_from_f32(sm_to_f32(x)), x)) {
        bc_write_u24(b, bc_pack_offset(0, NUMBER_F32));
        buf_u32(b, sm_f32_bits(sm_to_f32(x)));
    } else {
        bc_write_u24(b, bc_pack_offset(0, NUMBER_F64));
        buf_u64(b, sm_bits(x));
    }
}

static bool is_zero(SmF64 x) { return sm_eq(x, sm_from_i32(0)); }

// Returns the first byte of a pin (docs/bytecode.md): its kind, its switches, and which optional fields follow.
static uint8_t pin_flags(const Pin *p)
{
    bool scale = !pin_is_digital(p) && !sm_eq(p->scale, sm_from_i32(1)), more = pin_is_output(p) ? !is_zero(p->safe) : p->hold > 0;

    return (uint8_t)((unsigned)p->kind | (p->inverted ? 4u : 0u) | (p->pull_up ? 8u : 0u) | (p->pull_down ? 16u : 0u) | (scale ? PIN_SCALE : 0u)
                     | (is_zero(p->offset) ? 0u : PIN_OFFSET) | (more ? PIN_SAFE_OR_HOLD : 0u));
}

// Writes a row of the IO section.  Returns false if the element's offset is too large for a location.
static bool write_pin(Buf *b, const Pin *p)
{
    const uint32_t at = p->element->offset >> smvm_type_shift(p->element->type), front = pin_flags(p);

    buf_char(b, (char)front);
    bc_write_u24(b, bc_pack_offset(at, (uint32_t)p->element->type));
    bc_write_varint(b, p->number);
    if (front & PIN_SCALE)
        write_number(b, p->scale);
    if (front & PIN_OFFSET)
        write_number(b, p->offset);
    if (front & PIN_SAFE_OR_HOLD && pin_is_output(p))
        write_number(b, p->safe);
    else if (front & PIN_SAFE_OR_HOLD)
        buf_char(b, (char)p->hold);
    return at < SMVM_LOCATION_OFFSETS;
}

// Adds the section IO.  Returns false, and reports nothing, if the offset of an element is too large for the format.
static bool add_pins(ImageWriter *w, const IoMap *io)
{
    bool ok = true;
    Buf b;

    buf_init(&b, w->arena);
    buf_u32(&b, io->sv->hash);
    bc_write_varint(&b, io->sv->size / 8);
    bc_write_varint(&b, (uint32_t)io->pin.n);
    for (size_t i = 0; i < io->pin.n; i++)
        ok = write_pin(&b, &io->pin.at[i]) && ok;
    add_section(w, SMVM_S_IO, SMVM_V_IO, &b);
    return ok;
}

// ---- MACHINE, CODE, INIT ----

// Writes the table of functions: the offset at which each ends, in `width` bytes.
static void write_function_ends(Buf *b, const BcMachine *m, uint8_t width)
{
    uint32_t end = 0;

    for (size_t i = 0; i < m->fns; i++) {
        end += m->fn[i].size;
        for (uint8_t k = 0; k < width; k++)
            buf_char(b, (char)(end >> 8 * k & 0xff));
    }
}

// Writes the rolling windows by their numbers in the bytecode. of[n]: the IR's index of window number n.
static void write_windows(ImageWriter *w, Buf *b, const BcMachine *m)
{
    uint32_t *of = ARENA_ARRAY(w->arena, uint32_t, m->ir->window.n);

    for (uint32_t i = 0; i < m->ir->window.n; i++)
        of[m->window_number[i]] = i;
    for (size_t i = 0; i < m->ir->window.n; i++) {
        const IrWindow *window = &m->ir->window.at[of[i]];
        buf_u32(b, window->size | sm_roll_kind(window->type, window->stats) << SMVM_WINDOW_SIZE_BITS);
    }
}

// Finds the part of the state vector that the machine uses, in units of 8 bytes: from *from to *to - 1.
static void find_used_vector_range(const BcMachine *m, uint32_t *from, uint32_t *to)
{
    const IrMachine *ir = m->ir;

    *from = UINT32_MAX;
    *to = 0;
    for (uint32_t v = 0; v < ir->var.n; v++) {
        const uint32_t at = ir->var.at[v].offset / 8;
        if (ir->var.at[v].space != IR_ELEMENT || (m->of_var[v] == BC_NONE && v != ir->g && v != ir->s))
            continue;
        *from = at < *from ? at : *from;
        *to = at + 1 > *to ? at + 1 : *to;
    }
}

// Writes the machine's windows, output locations, ends of functions and constants. `width`: bytes of one function's end.
static void write_tables(ImageWriter *w, Buf *b, const BcMachine *m, uint8_t width)
{
    write_windows(w, b, m);
    for (size_t i = 0; i < m->output.n; i++)
        bc_write_u24(b, bc_pack_location(m, m->output.at[i]));
    write_function_ends(b, m, width);
    for (size_t i = 0; i < m->f32s.n; i++)
        buf_u32(b, m->f32s.at[i]);
    for (size_t i = 0; i < m->f64s.n; i++)
        buf_u64(b, m->f64s.at[i]);
}

static void add_machine(ImageWriter *w, const BcMachine *m, size_t code_size)
{
    const IrMachine *ir = m->ir;
    uint8_t width = code_size < 0x100 ? 1 : code_size < 0x10000 ? 2 : 3;
    uint32_t from, to;
    Buf b;

    find_used_vector_range(m, &from, &to);
    const uint32_t number[] = {ir->sv_size / 8, from, to, m->locals, (uint32_t)ir->window.n, (uint32_t)m->output.n, (uint32_t)ir->state.n, width,
                               (uint32_t)m->f32s.n, (uint32_t)m->f64s.n, ir->var.at[ir->g].offset / 8, ir->var.at[ir->s].offset / 4};
    buf_init(&b, w->arena);
    buf_u32(&b, ir->sv_hash);
    for (size_t i = 0; i < sizeof number / sizeof number[0]; i++)
        bc_write_varint(&b, number[i]);
    write_tables(w, &b, m, width);
    add_section(w, SMVM_S_MACHINE, SMVM_V_MACHINE, &b);
}

// Adds the initial values, other than 0, of the locals that are not parameters.
static void add_init(ImageWriter *w, const BcMachine *m)
{
    Buf b;

    buf_init(&b, w->arena);
    for (uint32_t v = 0; v < m->ir->var.n; v++) {
        const IrVar *var = &m->ir->var.at[v];
        if (var->space != IR_LOCAL || var->parameter || var->init == 0)
            continue;
        bc_write_u24(&b, bc_pack_location(m, v));
        for (uint32_t i = 0; i < sm_type_info[var->type].bytes; i++)
            buf_char(&b, (char)(var->init >> 8 * i & 0xff));
    }
    if (b.n > 0)
        add_section(w, SMVM_S_INIT, SMVM_V_INIT, &b);
}

// ---- PARAMETERS ----

// Writes a variable's value, given as bits, in the size of its type, low byte first.
static void write_cell(Buf *b, SmType type, uint64_t cell)
{
    for (uint32_t i = 0; i < sm_type_info[type].bytes; i++)
        buf_char(b, (char)(cell >> 8 * i & 0xff));
}

// Writes the length as a varint, then the text with its final 0.
static void write_text(Buf *b, const char *text)
{
    bc_write_varint(b, (uint32_t)strlen(text));
    buf_put(b, text, strlen(text) + 1);
}

// Returns the bits of an end of a parameter's range.  A zero has the sign of `beyond`: both zeros are in the range (docs/bytecode.md, rule 37).
static uint64_t cell_of_end(SmType type, SmF64 end, SmF64 beyond)
{
    return sm_cell_from_f64(type, is_zero(end) ? sm_mul(sm_from_i32(0), beyond) : end);
}

// Adds the parameters in the order of their locals: by size, then as declared.
static void add_parameters(ImageWriter *w, const BcMachine *m)
{
    Buf b;

    buf_init(&b, w->arena);
    for (uint32_t bytes = 8; bytes > 0; bytes /= 2)
        for (uint32_t v = 0; v < m->ir->var.n; v++) {
            const IrVar *var = &m->ir->var.at[v];
            const Parameter *p = var->parameter;
            if (!p || sm_type_info[var->type].bytes != bytes)
                continue;
            bc_write_u24(&b, bc_pack_location(m, v));
            write_cell(&b, var->type, cell_of_end(var->type, p->lo, sm_from_i32(-1)));
            write_cell(&b, var->type, cell_of_end(var->type, p->hi, sm_from_i32(1)));
            write_cell(&b, var->type, p->standard);
            write_cell(&b, var->type, var->init);
            write_text(&b, var->name->text);
            write_text(&b, p->unit ? p->unit->text : "");
        }
    if (b.n > 0)
        add_section(w, SMVM_S_PARAMETERS, SMVM_V_PARAMETERS, &b);
}

// ---- SAFE, SWAP, ABORT ----

static bool is_safe(const IrState *s) { return s->is_safe; }
static bool allows_swap(const IrState *s) { return s->allows_swap; }
static bool is_abort(const IrState *s) { return s->is_abort; }

// Adds section `id` with a bit for each state: whether has_mark is true of it.  Adds no section if it is true of none.
static void add_marks(ImageWriter *w, const IrMachine *m, uint8_t id, uint8_t version, bool (*has_mark)(const IrState *s))
{
    uint8_t *bits = ARENA_ARRAY(w->arena, uint8_t, (m->state.n + 7) / 8);
    bool any = false;
    Buf b;

    for (size_t s = 0; s < m->state.n; s++) {
        const bool marked = has_mark(&m->state.at[s]);
        bits[s / 8] = (uint8_t)(bits[s / 8] | (unsigned)marked << s % 8);
        any = any || marked;
    }
    if (!any)
        return;
    buf_init(&b, w->arena);
    buf_put(&b, (const char *)bits, (m->state.n + 7) / 8);
    add_section(w, id, version, &b);
}

// ---- the whole image ----

// Reports that a machine exceeds the limits of the format; returns false.
static bool report_limit(ImageWriter *w, const IrMachine *m, const char *what)
{
    Span none;

    memset(&none, 0, sizeof none);
    diag_report(w->diags, DIAG_image_limit, none, m->name->text, what);
    return false;
}

// Adds the sections of a machine.  Returns false after reporting that the machine exceeds a limit of the format.
static bool add_machine_sections(ImageWriter *w, const IrMachine *ir, bool debug)
{
    const char *what;
    bool ok = true;
    BcMachine m;
    Buf code, names;

    bc_select_machine(w->arena, &m, ir);
    what = bc_lay_out_locals(w->arena, &m);
    if (what)
        return report_limit(w, ir, what);
    buf_init(&code, w->arena);
    buf_init(&names, w->arena);
    for (size_t i = 0; ok && i < m.fns; i++) {
        bc_assemble(w->arena, &m, &m.fn[i], &code, &ok);
        ok = ok && code.n <= SMVM_IMAGE_MAX;
    }
    if (!ok)
        return report_limit(w, ir, "statements");
    add_machine(w, &m, code.n);
    add_section(w, SMVM_S_CODE, SMVM_V_CODE, &code);
    add_init(w, &m);
    add_parameters(w, &m);
    add_marks(w, ir, SMVM_S_SAFE, SMVM_V_SAFE, is_safe);
    add_marks(w, ir, SMVM_S_SWAP, SMVM_V_SWAP, allows_swap);
    if (debug) {
        add_marks(w, ir, SMVM_S_ABORT, SMVM_V_ABORT, is_abort);
        bc_write_debug(w->arena, &m, &names);
        add_section(w, SMVM_S_DEBUG, SMVM_V_DEBUG, &names);
    }
    return true;
}

// Returns the CRC of the whole image, whose CRC field is left out.
static uint32_t crc_of(const Buf *image)
{
    uint32_t crc = SM_CRC32_START;

    for (size_t i = 0; i < image->n; i++) {
        if (i == SMVM_CRC_AT)
            i += 4;
        crc = sm_crc32_byte(crc, (uint8_t)image->at[i]);
    }
    return sm_crc32_end(crc);
}

static uint32_t read_u32(const Buf *b, size_t at)
{
    const uint8_t *p = (const uint8_t *)b->at + at;

    return (uint32_t)p[0] | (uint32_t)p[1] << 8 | (uint32_t)p[2] << 16 | (uint32_t)p[3] << 24;
}

// Joins header, table with absolute offsets, sections and checksum.  Returns false, and reports nothing, if the image is too long or has too
// many sections.
static bool join_image(ImageWriter *w, Buf *out)
{
    size_t first = SMVM_HEADER + (size_t)SMVM_SECTION_ENTRY * w->sections, start = out->n;
    uint32_t crc;
    Buf image;

    if (w->sections > SECTIONS_MOST || first + w->body.n > SMVM_IMAGE_MAX)
        return false;
    buf_init(&image, w->arena);
    buf_put(&image, "smb", 3);
    buf_char(&image, SMVM_FORMAT);
    buf_u32(&image, 0);                                          // the checksum, filled in below
    bc_write_u24(&image, (uint32_t)(first + w->body.n));
    buf_char(&image, (char)w->sections);
    for (size_t i = 0; i < w->sections; i++) {
        buf_put(&image, w->table.at + 10 * i, 2);
        bc_write_u24(&image, (uint32_t)first + read_u32(&w->table, 10 * i + 2));
        bc_write_u24(&image, read_u32(&w->table, 10 * i + 6));
    }
    buf_put(&image, w->body.at, w->body.n);
    crc = crc_of(&image);
    for (int i = 0; i < 4; i++)
        image.at[SMVM_CRC_AT + i] = (char)(crc >> 8 * i & 0xff);
    buf_put(out, image.at, image.n);
    return out->n - start == image.n;
}

// Whether the verifier of the target accepts the image; reports its finding if not.
static bool verify_image(ImageWriter *w, IrMachine *const *m, const Buf *out)
{
    SmvmVerdict v;
    Span none;

    if (smvm_verify((const uint8_t *)out->at, (uint32_t)out->n, &v) == 0)
        return true;
    memset(&none, 0, sizeof none);
    if (v.rule == SMVM_R_RAM) {
        diag_report(w->diags, DIAG_image_memory, none, m[v.machine]->name->text);
        return false;
    }
    diag_report(w->diags, DIAG_image_refused, none, m[v.machine]->name->text, format_in(w->arena, "%u at byte %lu", v.rule, (unsigned long)v.at),
                smvm_rule_text(v.rule));
    return false;
}

// Builds one image of n machines and of pins (io may be NULL).  Returns false, and reports it, if they exceed the limits of the format.
bool emit_image(Arena *arena, Diags *diags, IrMachine *const *m, size_t n, const IoMap *io, bool debug, Buf *out)
{
    ImageWriter w;
    Span none;

    memset(&w, 0, sizeof w);
    memset(&none, 0, sizeof none);
    w.arena = arena;
    w.diags = diags;
    buf_init(&w.table, arena);
    buf_init(&w.body, arena);
    add_identity(&w, m, n);
    if (io && !add_pins(&w, io))
        return report_limit(&w, m[0], "elements");
    for (size_t i = 0; i < n; i++) {
        if (!add_machine_sections(&w, m[i], debug))
            return false;
        if (w.body.n > SMVM_IMAGE_MAX || w.sections > SECTIONS_MOST)
            break;
    }
    if (!join_image(&w, out)) {
        diag_report(diags, DIAG_image_size, none, w.sections > SECTIONS_MOST ? "too many machines" : "more than 16 MB");
        return false;
    }
    return verify_image(&w, m, out);
}
