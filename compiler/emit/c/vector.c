// SPDX-License-Identifier: Apache-2.0
// A state vector for the flight runtime (runtime-c/statevec.h): its storage, the tables that describe it, and two functions for each
// element.  If the vector has a lock, they acquire it; otherwise they are plain accesses to the member.
#include "compiler/emit/c/unit.h"

// Returns the C type of the parameter or result of an access function.
static const char *accessor_type(const CUnit *u, SmType type) { return type == SM_F64 ? "SmF64" : c_type_of(u, type); }

// ---- the header ----

// Writes an enum of n names, followed by `count`, an enumerator whose value is n.
static void write_enum(Buf *out, const char *const *name, size_t n, const char *count)
{
    buf_str(out, "enum {\n");
    for (size_t i = 0; i < n; i++)
        buf_printf(out, "    %s,\n", name[i]);
    buf_printf(out, "    %s        // their number\n};\n\n", count);
}

// Writes the functions that read and write an element without a lock.
static void write_plain_accessors(const CUnit *u, const CElement *e, const char *getter, const char *setter, Buf *out)
{
    const char *p = u->names.prefix, *type = accessor_type(u, e->type), *truth = e->type == SM_BOOL ? " != 0" : "";

    buf_printf(out, "static inline %s %s(void) { return %s_sv.%s%s; }\n", type, getter, p, e->member, truth);
    buf_printf(out, "static inline void %s(%s value) { %s_sv.%s = value; }\n\n", setter, type, p, e->member);
}

// Writes the functions that acquire the lock and read or write an element.
static void write_locking_accessors(const CUnit *u, const CElement *e, const char *getter, const char *setter, Buf *out)
{
    const char *p = u->names.prefix, *type = accessor_type(u, e->type), *truth = e->type == SM_BOOL ? " != 0" : "";
    const char *zero = e->type == SM_BOOL ? "false" : e->type == SM_F64 ? "sm_from_i32(0)" : "0";

    buf_printf(out, "static inline %s %s(void)\n{\n    %s value = %s;\n\n", type, getter, type, zero);
    buf_printf(out, "    if (sm_enter(&%s_vector) == SM_OK) {\n", p);
    buf_printf(out, "        value = %s_sv.%s%s;\n        sm_leave(&%s_vector);\n    }\n    return value;\n}\n", p, e->member, truth, p);
    buf_printf(out, "static inline void %s(%s value)\n{\n    if (sm_enter(&%s_vector) == SM_OK) {\n", setter, type, p);
    buf_printf(out, "        %s_sv.%s = value;\n        sm_leave(&%s_vector);\n    }\n}\n\n", p, e->member, p);
}

static void write_declarations(const CUnit *u, const StateVec *sv, const CVectorNames *n, Buf *out)
{
    const char *p = u->names.prefix;

    buf_printf(out, "\n// ---- for the flight runtime: runtime-c/statevec.h documents these ----\n\n");
    buf_printf(out, "extern %s %s_sv;        // %s\n", u->names.sv_type, p,
               sv->lock ? "its elements; only for code that holds its lock" : "its elements; for one thread");
    buf_printf(out, "extern SmStateVec %s_vector;\nextern const SmLayout %s_layout;\n", p, p);
    buf_printf(out, "extern const SmElement %s_element[];        // by the numbers below\n", p);
    buf_printf(out, "extern const SmNames %s_names;\n\n", p);
    write_enum(out, n->element, sv->element.n, format_in(u->arena, "%s_ELEMENTS", u->names.macro));
    write_enum(out, n->region, sv->region.n, format_in(u->arena, "%s_REGIONS", u->names.macro));
}

// Writes the functions that copy a region to and from its members in a copy of the state vector.  Their parameter is a whole vector, so the
// user can pass no buffer that is too small and needs no cast.
static void write_region_functions(const CUnit *u, const char *region, const char *reader, const char *writer, uint32_t offset, Buf *out)
{
    const char *p = u->names.prefix, *type = u->names.sv_type;

    buf_printf(out, "static inline SmResult %s(%s *copy)\n{\n", reader, type);
    buf_printf(out, "    return sm_read_region(&%s_vector, &%s_layout.region[%s], (uint8_t *)copy + %u);\n}\n", p, p, region, offset);
    buf_printf(out, "static inline SmResult %s(const %s *copy)\n{\n", writer, type);
    buf_printf(out, "    return sm_write_region(&%s_vector, &%s_layout.region[%s], (const uint8_t *)copy + %u);\n}\n\n", p, p, region, offset);
}

void c_write_vector_interface(const CUnit *u, const StateVec *sv, const CVectorNames *n, Buf *out)
{
    const char *p = u->names.prefix;

    write_declarations(u, sv, n, out);
    if (sv->lock)
        buf_printf(out, "// Each of these acquires and releases the lock.  If it cannot, it reads 0, writes nothing, and counts a fault in %s_vector.faults.\n\n", p);
    for (size_t i = 0; i < u->sv.n; i++)
        (sv->lock ? write_locking_accessors : write_plain_accessors)(u, &u->sv.at[i], n->getter[i], n->setter[i], out);
    buf_str(out, "// Copy a whole region at once, from or to its members in a copy of the vector; other members stay unchanged.\n\n");
    for (size_t r = 0; r < sv->region.n; r++)
        write_region_functions(u, n->region[r], n->reader[r], n->writer[r], sv->region.at[r]->offset, out);
    out->n--;                        // removes the empty line after the last function
    out->at[out->n] = '\0';
}

// ---- the code ----

// Writes the definitions of the state vector and of its SmStateVec.
static void write_storage(const CUnit *u, const StateVec *sv, Buf *out)
{
    const char *p = u->names.prefix;
    bool wide = false;

    for (size_t i = 0; i < u->sv.n; i++)
        wide = wide || sm_type_info[u->sv.at[i].type].bytes == 8;
    if (!wide)
        buf_str(out, "// No member requires the alignment of a uint64_t, but images do.  (On other targets sm_statevec_init checks it.)\n"
                     "#ifdef __GNUC__\n__attribute__((aligned(8)))\n#endif\n");
    buf_printf(out, "%s %s_sv;\n\n", u->names.sv_type, p);
    buf_printf(out, "SmStateVec %s_vector = {&%s_layout, &%s_sv, %s, {0}, 0};\n\n", p, p, p, sv->lock ? "true" : "false");
}

static void write_element_table(const CUnit *u, const StateVec *sv, const CVectorNames *n, Buf *out)
{
    buf_printf(out, "const SmElement %s_element[] = {        // offset, type, region\n", u->names.prefix);
    for (size_t r = 0; r < sv->region.n; r++)
        for (uint32_t i = 0; i < sv->region.at[r]->count; i++) {
            const Element *e = sv->element.at[sv->region.at[r]->first + i];
            buf_printf(out, "    {%u, SM_%s, %s},        // %s\n", e->offset, e->type == SM_BOOL ? "BOOL" : sm_type_info[e->type].spelling,
                       n->region[r], e->name->text);
        }
    buf_str(out, "};\n\n");
}

static void write_layout_tables(const CUnit *u, const StateVec *sv, Buf *out)
{
    const char *p = u->names.prefix, *m = u->names.macro;
    uint32_t packed = 0;

    buf_printf(out, "static const SmRegion %s_regions[] = {        // offset, size, size on the wire, first element, number of elements\n", p);
    for (size_t r = 0; r < sv->region.n; r++) {
        const Region *at = sv->region.at[r];
        buf_printf(out, "    {%u, %u, %u, %u, %u},        // %s\n", at->offset, at->size, at->packed_size, at->first, at->count, at->name->text);
        packed += at->packed_size;
    }
    buf_printf(out, "};\n\nconst SmLayout %s_layout = {\n    0x%08xu, %s_ELEMENTS, %s_REGIONS, %s_element, %s_regions,\n", p, sv->hash, m, m, p, p);
    buf_printf(out, "    {0, %u, %u, 0, %s_ELEMENTS}\n};\n\n", sv->size, packed, m);
}

// Writes the first line of a table of names; the caller writes the rest.
static void begin_name_table(const CUnit *u, const char *what, Buf *out)
{
    buf_printf(out, "static const char *const %s_%s_names[] = {\n", u->names.prefix, what);
}

static void write_name_tables(const CUnit *u, const StateVec *sv, Buf *out)
{
    const char *p = u->names.prefix;

    begin_name_table(u, "element", out);
    for (size_t i = 0; i < sv->element.n; i++)
        buf_printf(out, "    \"%s\",\n", sv->element.at[i]->name->text);
    buf_str(out, "};\n\n");
    begin_name_table(u, "region", out);
    for (size_t r = 0; r < sv->region.n; r++)
        buf_printf(out, "    \"%s\",\n", sv->region.at[r]->name->text);
    buf_printf(out, "};\n\nconst SmNames %s_names = {&%s_layout, \"%s\", %s_element_names, %s_region_names};\n", p, p, sv->name->text, p, p);
}

void c_write_vector_tables(const CUnit *u, const StateVec *sv, const CVectorNames *n, Buf *out)
{
    buf_char(out, '\n');
    if (sv->element.n > UINT16_MAX)
        buf_str(out, "#error \"smc: the flight runtime numbers elements with 16 bits: 65,535 of them at most\"\n");
    write_storage(u, sv, out);
    write_element_table(u, sv, n, out);
    write_layout_tables(u, sv, out);
    write_name_tables(u, sv, out);
}
