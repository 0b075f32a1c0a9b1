// SPDX-License-Identifier: Apache-2.0
// The DEBUG section: names of the machine, its states and variables, and lines of the source (docs/bytecode.md).
#include <string.h>

#include "bytecode-vm/image.h"
#include "compiler/base/path.h"
#include "compiler/emit/bytecode/bytecode.h"

// ---- lines ----

// Returns the source line of an instruction: 0 if several lines share it, `last` if it has no position.
static uint32_t line_of_ins(const BcIns *i, uint32_t last)
{
    if (i->of_many_lines)
        return 0;
    return i->span.src ? source_position(i->span.src, i->span.at).line : last;
}

// Writes the source lines, each as two deltas: of the code offset in bytes, and of the line number (zigzag: 0, -1, 1, -2 …).
static void write_lines(Arena *arena, Buf *out, const BcMachine *m)
{
    uint32_t start = 0, last_at = 0, last_line = 0, n = 0;
    Buf b;

    buf_init(&b, arena);
    for (size_t f = 0; f < m->fns; start += m->fn[f++].size)
        for (size_t i = 0; i < m->fn[f].ins.n; i++) {
            const BcIns *ins = &m->fn[f].ins.at[i];
            uint32_t line = line_of_ins(ins, last_line);
            if (line == last_line)
                continue;
            bc_write_varint(&b, start + ins->at - last_at);
            bc_write_varint(&b, line > last_line ? (line - last_line) * 2 : (last_line - line) * 2 - 1);
            last_at = start + ins->at;
            last_line = line;
            n++;
        }
    bc_write_varint(out, n);
    buf_put(out, b.at, b.n);
}

// ---- variables: sorted by kind, type and offset, for binary search ----

// Sorts n keys; `other` is scratch memory of the same size.  A merge sort, because the C library's qsort can allocate memory.
static void sort_keys(uint64_t *key, uint64_t *other, size_t n)
{
    for (size_t width = 1; width < n; width *= 2) {
        for (size_t lo = 0; lo < n; lo += 2 * width) {
            size_t mid = lo + width < n ? lo + width : n, hi = lo + 2 * width < n ? lo + 2 * width : n;
            size_t a = lo, b = mid;
            for (size_t i = lo; i < hi; i++)
                other[i] = a < mid && (b >= hi || key[a] <= key[b]) ? key[a++] : key[b++];
        }
        memcpy(key, other, n * sizeof *key);
    }
}

static SmvmVariable variable_kind(const IrVar *v)
{
    switch (v->space) {
    case IR_ELEMENT: return SMVM_IS_ELEMENT;
    case IR_LOCAL: return SMVM_IS_LOCAL;
    case IR_TIME: break;
    }
    return SMVM_IS_TIME;
}

static uint64_t *sorted_variables(Arena *arena, const BcMachine *m)   // returns sort keys; the low 32 bits of a key are the variable's index
{
    const size_t n = m->ir->var.n;
    uint64_t *key = ARENA_ARRAY(arena, uint64_t, n);

    for (uint32_t v = 0; v < n; v++) {
        const uint32_t place = bc_pack_location(m, v), offset = (place & 0xffff) | place >> 20 << 16;
        key[v] = (uint64_t)variable_kind(&m->ir->var.at[v]) << 60 | (uint64_t)m->ir->var.at[v].type << 56 | (uint64_t)offset << 32 | v;
    }
    sort_keys(key, ARENA_ARRAY(arena, uint64_t, n), n);
    return key;
}

// ---- names ----

// Writes the length and the name.  A 0 byte follows, not counted in the length, so that a name can be read in place as a C string.
static void write_name(Buf *b, const char *text, size_t len)
{
    if (len >= SMVM_VARINT_MID)
        len = SMVM_VARINT_MID - 1;
    bc_write_varint(b, (uint32_t)len);
    buf_put(b, text, len);
    buf_char(b, 0);
}

typedef struct BcNames {
    Buf *tables, names;          // the tables of offsets of names; the names themselves
    uint32_t first;           // offset of the first name from the start of the section
} BcNames;

// Appends the text to `names`, and its position to `tables`.
static void add_name(BcNames *n, const char *text, size_t len)
{
    bc_write_u24(n->tables, n->first + (uint32_t)n->names.n);
    write_name(&n->names, text, len);
}

// Writes the debug table's rows of the variables, in the order of sorted_variables.
static void write_variables(Arena *arena, BcNames *n, const BcMachine *m)
{
    const uint64_t *order = sorted_variables(arena, m);

    for (size_t i = 0; i < m->ir->var.n; i++) {
        const uint32_t v = (uint32_t)order[i];
        buf_char(n->tables, (char)variable_kind(&m->ir->var.at[v]));
        bc_write_u24(n->tables, bc_pack_location(m, v));
        add_name(n, m->ir->var.at[v].name->text, m->ir->var.at[v].name->len);
    }
}

// Sets *name to the name of what window `window` samples. Returns false if that has no name.
static bool name_samples(Arena *arena, const BcMachine *m, uint32_t window, Buf *name)
{
    const IrWindow *w = &m->ir->window.at[window];

    buf_init(name, arena);
    if (w->first && m->ir->program && m->window_number[window] < SMVM_LOCATION_OFFSETS)
        expr_name_window(arena, &m->ir->program->window, w->first, SMVM_SAMPLE_NAME_MAX, name);
    return name->n > 0 && name->n <= SMVM_SAMPLE_NAME_MAX;
}

// Returns the names of samples by window number in the image; empty: none.  *count: how many there are.
static Buf *find_sample_names(Arena *arena, const BcMachine *m, uint32_t *count)
{
    Buf *name = ARENA_ARRAY(arena, Buf, m->ir->window.n);

    *count = 0;
    for (uint32_t w = 0; w < m->ir->window.n; w++) {
        Buf *of = &name[m->window_number[w]];
        if (name_samples(arena, m, w, of))
            ++*count;
        else
            of->n = 0;
    }
    return name;
}

// Writes the debug table's rows of the rolling windows. name[w] is empty for a window without a name.
static void write_samples(BcNames *n, const BcMachine *m, const Buf *name)
{
    for (uint32_t w = 0; w < m->ir->window.n; w++) {
        if (name[w].n == 0)
            continue;
        buf_char(n->tables, SMVM_IS_SAMPLE);
        bc_write_u24(n->tables, bc_pack_offset(w, 0));
        add_name(n, name[w].at, name[w].n);
    }
}

// Writes the section: a few counts and offsets, then tables of name offsets, then the names, then the source lines.
void bc_write_debug(Arena *arena, const BcMachine *m, Buf *out)
{
    const Program *p = m->ir->program;
    const char *source = p && p->src ? path_portable_name(p->src->name) : "";
    const IrMachine *ir = m->ir;
    uint32_t samples;
    const Buf *sample = find_sample_names(arena, m, &samples);
    BcNames n;

    buf_init(&n.names, arena);
    n.tables = out;
    n.first = (uint32_t)(3 * (SMVM_DEBUG_NUMBERS + ir->state.n) + SMVM_DEBUG_VARIABLE * (ir->var.n + samples));
    bc_write_u24(out, (uint32_t)ir->var.n + samples);
    bc_write_u24(out, 0);                                        // offset of the lines, filled in below
    add_name(&n, ir->name->text, ir->name->len);
    add_name(&n, source, strlen(source));
    for (size_t s = 0; s < ir->state.n; s++)
        add_name(&n, ir->state.at[s].name->text, ir->state.at[s].name->len);
    write_variables(arena, &n, m);
    write_samples(&n, m, sample);
    for (int i = 0; i < 3; i++)
        out->at[3 + i] = (char)((n.first + n.names.n) >> 8 * i & 0xff);
    buf_put(out, n.names.at, n.names.n);
    write_lines(arena, out, m);
}
