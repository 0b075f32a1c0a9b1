// SPDX-License-Identifier: Apache-2.0
// The driver program: emitted machines and a main that runs them on commands from its standard input, which compiler/device/engine_c.c sends.
// emit_c.h describes the protocol.
#include <string.h>

#include "compiler/emit/c/fn.h"
#include "compiler/emit/c/emit_c.h"

// The part of every driver program that follows the code of the machines: a main that runs the machines on commands from standard input.
static const char common_code[] =
    "#ifndef SM_IN_FLASH\n"
    "#define SM_IN_FLASH          // tables of constants stay in flash where this is __flash, as on AVR\n"
    "#endif\n"
    "#include <stdio.h>\n"
    "#include <stdlib.h>\n"
    "#ifdef _WIN32                // standard streams pass bytes as they are\n"
    "#include <fcntl.h>\n"
    "#include <io.h>\n"
    "#endif\n"
    "\n"
    "typedef struct Cell {\n"
    "    void *at;                 // address of the variable; NULL: the variable is a constant\n"
    "    const bool *stored;       // whether the last step stored the variable; NULL: the machine never stores it, or does not track stores\n"
    "    uint64_t value;           // the value of the constant\n"
    "    char type;                // 1 2 4 8: the size of an integer or float in bytes; b: bool\n"
    "} Cell;\n"
    "\n"
    "typedef struct Machine {\n"
    "    uint32_t (*init)(uint32_t state);\n"
    "    uint32_t (*step)(void);\n"
    "    uint32_t (*state)(void);\n"
    "    const bool *first;\n"
    "    const SM_IN_FLASH Cell *cell;\n"
    "    uint32_t cells;\n"
    "    bool tracks;              // the machine tracks which variables it stores\n"
    "} Machine;\n"
    "\n"
    "static uint64_t cell_read(const SM_IN_FLASH Cell *c)\n"
    "{\n"
    "    switch (c->at ? c->type : 0) {\n"
    "    case 1: { uint8_t v; memcpy(&v, c->at, sizeof v); return v; }\n"
    "    case 2: { uint16_t v; memcpy(&v, c->at, sizeof v); return v; }\n"
    "    case 4: { uint32_t v; memcpy(&v, c->at, sizeof v); return v; }\n"
    "    case 8: { uint64_t v; memcpy(&v, c->at, sizeof v); return v; }\n"
    "    case 'b': { uint8_t v; memcpy(&v, c->at, sizeof v); return v != 0; }\n"
    "    default: return c->value;\n"
    "    }\n"
    "}\n"
    "\n"
    "static void cell_write(const SM_IN_FLASH Cell *c, uint64_t value)\n"
    "{\n"
    "    switch (c->at ? c->type : 0) {\n"
    "    case 1: { const uint8_t v = (uint8_t)value; memcpy(c->at, &v, sizeof v); break; }\n"
    "    case 2: { const uint16_t v = (uint16_t)value; memcpy(c->at, &v, sizeof v); break; }\n"
    "    case 4: { const uint32_t v = (uint32_t)value; memcpy(c->at, &v, sizeof v); break; }\n"
    "    case 8: memcpy(c->at, &value, sizeof value); break;\n"
    "    case 'b': { const uint8_t v = value != 0; memcpy(c->at, &v, sizeof v); break; }\n"
    "    default: break;\n"
    "    }\n"
    "}\n"
    "\n"
    "static bool read_number(uint64_t *value, int n)\n"
    "{\n"
    "    int i, c;\n"
    "\n"
    "    *value = 0;\n"
    "    for (i = 0; i < n; i++) {\n"
    "        if ((c = getchar()) == EOF)\n"
    "            return false;\n"
    "        *value |= (uint64_t)(unsigned char)c << 8 * i;\n"
    "    }\n"
    "    return true;\n"
    "}\n"
    "\n"
    "static void write_number(uint64_t value, int n)\n"
    "{\n"
    "    for (; n > 0; n--, value >>= 8)\n"
    "        if (putchar((int)(value & 0xff)) == EOF)\n"
    "            exit(1);\n"
    "}\n"
    "\n"
    "static void write_answer(const SM_IN_FLASH Machine *m, uint32_t status)\n"
    "{\n"
    "    uint32_t i;\n"
    "\n"
    "    write_number(status, 4);\n"
    "    write_number(m->state(), 4);\n"
    "    write_number(*m->first, 4);\n"
    "    for (i = 0; i < m->cells; i++)\n"
    "        write_number(cell_read(&m->cell[i]), 8);\n"
    "    for (i = 0; i < m->cells; i++)\n"
    "        write_number(!m->tracks ? 2 : status == 0 && m->cell[i].stored && *m->cell[i].stored, 1);\n"
    "    fflush(stdout);\n"
    "}\n"
    "\n"
    "static bool run_init(const SM_IN_FLASH Machine *m)\n"
    "{\n"
    "    uint64_t state;\n"
    "\n"
    "    if (!read_number(&state, 4))\n"
    "        return false;\n"
    "    write_answer(m, m->init((uint32_t)state));\n"
    "    return true;\n"
    "}\n"
    "\n"
    "static bool run_step(const SM_IN_FLASH Machine *m)\n"
    "{\n"
    "    uint64_t n, var, value;\n"
    "\n"
    "    if (!read_number(&n, 4))\n"
    "        return false;\n"
    "    for (; n > 0; n--) {\n"
    "        if (!read_number(&var, 4) || !read_number(&value, 8) || var >= m->cells)\n"
    "            return false;\n"
    "        cell_write(&m->cell[var], value);\n"
    "    }\n"
    "    write_answer(m, m->step());\n"
    "    return true;\n"
    "}\n"
    "\n";

static const char main_code[] =
    "int main(void)\n"
    "{\n"
    "    uint64_t which, command;\n"
    "\n"
    "#ifdef _WIN32\n"
    "    _setmode(0, _O_BINARY);\n"
    "    _setmode(1, _O_BINARY);\n"
    "#endif\n"
    "    while (read_number(&which, 4) && read_number(&command, 4) && which < sizeof machine / sizeof *machine)\n"
    "        if (!(command == 0 ? run_init(&machine[which]) : run_step(&machine[which])))\n"
    "            break;\n"
    "    return 0;\n"
    "}\n";

// ---- the table of one machine's variables ----

// Returns the Cell.type of a variable of type t.
static char cell_type(SmType t) { return t == SM_BOOL ? 'b' : (char)('0' + sm_type_info[t].bytes); }

// Writes the Cell of IR variable v.
static void write_variable_row(const CUnit *u, size_t v, Buf *out)
{
    const IrVar *var = &u->m->var.at[v];
    const char *p = u->names.prefix, *member = u->names.var[v];
    const bool element = var->space == IR_ELEMENT;
    const char type = cell_type(var->type);

    if (var->space == IR_TIME)
        buf_printf(out, "    { &%s_time, ", p);
    else
        buf_printf(out, "    { &%s%s.%s, ", p, element ? "_sv" : "_m", member);
    if (u->track_stores && element && (var->writable || v == u->m->s))
        buf_printf(out, "&%s_m.stored.%s, ", p, member);
    else
        buf_str(out, "NULL, ");
    buf_printf(out, type == 'b' ? "0, '%c' },\n" : "0, %c },\n", type);
}

// Writes a Cell for each variable of the program.  A variable that the IR does not have is a constant.  Without a program, writes a Cell for
// each variable of the IR.
static void write_cell_table(const CUnit *u, Buf *out)
{
    const Program *p = u->m->program;
    Map by_name = { 0 };

    by_name.arena = u->arena;
    for (size_t v = 0; v < u->m->var.n; v++)
        map_put(&by_name, u->m->var.at[v].name, &u->m->var.at[v]);
    buf_printf(out, "static const SM_IN_FLASH Cell %s_cell[] = {\n", u->names.prefix);
    for (size_t i = 0; p && i < p->var.n; i++) {
        const IrVar *v = map_find(&by_name, p->var.at[i]->name);
        if (v)
            write_variable_row(u, (size_t)(v - u->m->var.at), out);
        else
            buf_printf(out, "    { NULL, NULL, UINT64_C(%llu), 0 },\n", (unsigned long long)p->var.at[i]->init);
    }
    for (size_t v = 0; !p && v < u->m->var.n; v++)
        write_variable_row(u, v, out);
    buf_str(out, "};\n");
}

// Writes the functions that Machine.init, .step and .state point to.  The first two return a status of the driver's
// protocol (emit_c.h), which has one code for both PREFIX_NO_STATE and PREFIX_UNFIT; the third returns the number of the state.
static void write_adapters(const CUnit *u, Buf *out)
{
    const char *p = u->names.prefix;

    buf_printf(out, "static uint32_t %s_run_init(uint32_t state)\n{\n", p);
    buf_printf(out, "    memset(&%s_m, 0, sizeof %s_m);\n    memset(&%s_sv, 0, sizeof %s_sv);\n", p, p, p, p);
    buf_printf(out, "    %s_time = 0;\n", p);
    buf_printf(out, "    return %s_init(&%s_m, &%s_sv, state) == %s_OK ? 0 : 2;\n}\n", p, p, p, u->names.macro);
    buf_printf(out, "static uint32_t %s_run_step(void)\n{\n", p);
    buf_printf(out, "    const %sStatus s = %s_step(&%s_m, &%s_sv);\n", u->names.type, p, p, p);
    buf_printf(out, "    %s_time = %s_T(&%s_m);\n", p, p, p);
    buf_printf(out, "    return s == %s_OK ? 0 : s == %s_REFUSED ? 1 : 2;\n}\n", u->names.macro, u->names.macro);
    buf_printf(out, "static uint32_t %s_run_state(void) { return %s_state(&%s_m); }\n", p, p, p);
}

// Writes the variables, the cell table and the functions of one machine.
static void write_machine_globals(const CUnit *u, Buf *out)
{
    const CNames *n = &u->names;

    buf_printf(out, "static %s %s_m;\nstatic %s %s_sv;\nstatic uint64_t %s_time;\n", n->type, n->prefix, n->sv_type, n->prefix, n->prefix);
    write_cell_table(u, out);
    write_adapters(u, out);
    buf_char(out, '\n');
}

// ---- the whole driver ----

// Appends types and code of machine number i.  Counts the stdlib snippets that it uses in `helper`.  Returns its unit.
static CUnit *write_machine_code(Arena *arena, const IrMachine *m, size_t i, bool track_stores, bool soft, uint32_t *helper, Buf *out)
{
    CUnit *u = ARENA_NEW(arena, CUnit);
    const char *prefix = format_in(arena, "m%u", (unsigned)i);

    unit_init(u, arena, m, prefix, prefix);
    u->helper = helper;
    unit_set_soft(u, soft);
    u->track_stores = track_stores;
    c_write_vector_struct(u, out);
    c_write_vector_check(u, out);
    buf_char(out, '\n');
    c_write_machine_types(u, out);
    c_write_prototypes(u, out);
    buf_char(out, '\n');
    c_write_machine(u, out);
    buf_char(out, '\n');
    return u;
}

// Emits several machines, each the result of passes_for_c, and a main as one translation unit: a driver program that runs them on commands
// from its standard input.  compiler/device/engine_c.c compiles and drives it.  track_stores has one flag for each machine.  `soft`:
// as EmitCOptions.soft; the soft library is part of the unit.
void emit_c_driver(Arena *arena, const IrMachine *const *m, const bool *track_stores, size_t n, bool soft, Buf *code)
{
    uint32_t *helper = ARENA_ARRAY(arena, uint32_t, helper_count());
    CUnit **u = ARENA_ARRAY(arena, CUnit *, n);
    Buf machines;

    buf_init(&machines, arena);
    for (size_t i = 0; i < n; i++)
        u[i] = write_machine_code(arena, m[i], i, track_stores[i], soft, helper, &machines);
    if (soft)
        c_write_soft_library(code);
    c_write_compiler_checks(code, "machines", soft);
    if (!soft) {
        c_write_self_test_declaration(code);
        c_write_self_test(code);
    }
    if (n == 0)
        return;
    helper_write_type(u[0], "SmRoll", code);
    for (size_t i = 0; i < n; i++) {
        u[0]->uses_noinline |= u[i]->uses_noinline;
        u[0]->key_bits = u[0]->key_bits < u[i]->key_bits ? u[i]->key_bits : u[0]->key_bits;
    }
    helpers_write_required(u[0], code);
    buf_str(code, buf_text(&machines));
    buf_str(code, common_code);
    for (size_t i = 0; i < n; i++)
        write_machine_globals(u[i], code);
    buf_str(code, "static const SM_IN_FLASH Machine machine[] = {\n");
    for (size_t i = 0; i < n; i++) {
        const char *p = u[i]->names.prefix;
        buf_printf(code, "    { %s_run_init, %s_run_step, %s_run_state, &%s_m.first_, %s_cell, sizeof %s_cell / sizeof *%s_cell, %s },\n", p, p,
                   p, p, p, p, p, u[i]->track_stores ? "true" : "false");
    }
    buf_str(code, "};\n\n");
    buf_str(code, main_code);
}
