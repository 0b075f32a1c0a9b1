// SPDX-License-Identifier: Apache-2.0
// The VM on some target, at the command of its standard input: the exchange of emit_c_driver (compiler/emit/c/emit_c.h), in which machines
// come as images.  One command more:
//   2, load:   u32 n, n times (u32 where: 0 a constant, 1 T, 2 an element, 3 a local; u32 type; u32 offset; u32 1 + its number among
//              the outputs, 0: it is not an output, -1: it is S; u64 the constant), u32 size, the image
//              answer: u32 verdict, u32 the longest step; verdict 255: there is no room here, nothing else is answered
// Machine and image stay until the next load.  The machine runs in place; and decoded beside it, where there is room.  A difference between
// the two is status 3.
//
// What is to be chosen with -D: VM_IMAGE, VM_RAM, VM_VECTOR, VM_DECODED (0: none), in bytes, and VM_CELLS.
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bytecode-vm/image.h"
#include "bytecode-vm/smvm.h"
#include "stdlib/convert.h"

enum { CONSTANT, TIME, ELEMENT, LOCAL, NO_ROOM = 255, IS_S = 0xffffffff };

typedef struct Cell {
    uint64_t value;
    uint32_t offset, output;
    uint8_t in, type;
} Cell;

// One form of the machine: in place, or decoded.
typedef struct Form {
    uint64_t memory[VM_RAM / 8], sv[VM_VECTOR / 8];
} Form;

static uint8_t image[VM_IMAGE];
static Form in_place;
static Cell cell[VM_CELLS];
static uint32_t cells;
static SmvmMachine m;
static bool loaded;
#if VM_DECODED
static Form beside;
static uint64_t code[VM_DECODED / 8];
static SmvmDecoded *decoded;          // NULL: there is no memory for it
#endif

static SmVm *vm_of(Form *f) { return (SmVm *)f->memory; }

// ---- the exchange ----

static bool take(uint64_t *value, int n)
{
    *value = 0;
    for (int i = 0; i < n; i++) {
        const int c = getchar();
        if (c == EOF)
            return false;
        *value |= (uint64_t)(uint8_t)c << 8 * i;
    }
    return true;
}

static uint32_t take_u32(void)
{
    uint64_t value;

    if (!take(&value, 4))
        exit(6);                      // the input ended inside a request
    return (uint32_t)value;
}

static uint64_t take_u64(void)
{
    const uint64_t low = take_u32();

    return low | (uint64_t)take_u32() << 32;
}

static void give(uint64_t value, int n)
{
    for (; n > 0; n--, value >>= 8)
        putchar((int)(value & 0xff));
}

static uint64_t read_cell(const Cell *c)
{
    switch (c->in) {
    case TIME: return smvm_time(vm_of(&in_place));
    case ELEMENT: return sm_cell_load((SmType)c->type, (uint8_t *)in_place.sv + c->offset);
    case LOCAL: return sm_cell_load((SmType)c->type, (uint8_t *)smvm_locals(vm_of(&in_place)) + c->offset);
    default: return c->value;
    }
}

static void write_cell(Form *f, const Cell *c, uint64_t value)
{
    if (c->in == ELEMENT)
        sm_cell_store((SmType)c->type, (uint8_t *)f->sv + c->offset, value);
    if (c->in == LOCAL)
        sm_cell_store((SmType)c->type, (uint8_t *)smvm_locals(vm_of(f)) + c->offset, value);
}

static bool is_stored(const Cell *c)
{
    if (c->output == IS_S)
        return smvm_stored_state(vm_of(&in_place));
    return c->output != 0 && smvm_stored(vm_of(&in_place), c->output - 1);
}

static void answer(uint32_t status, bool stepped)
{
    give(status, 4);
    give(smvm_state(vm_of(&in_place)), 4);
    give(vm_of(&in_place)->first, 4);
    for (uint32_t i = 0; i < cells; i++)
        give(read_cell(&cell[i]), 8);
    for (uint32_t i = 0; i < cells; i++)
        give(stepped && is_stored(&cell[i]), 1);
    fflush(stdout);
}

// ---- the decoded form ----

#if VM_DECODED
static bool both_stored(void)
{
    for (uint32_t i = 0; i < m.outputs; i++)
        if (smvm_stored(vm_of(&in_place), i) != smvm_stored(vm_of(&beside), i))
            return false;
    return smvm_stored_state(vm_of(&in_place)) == smvm_stored_state(vm_of(&beside));
}

static bool agree(void)
{
    const SmVm *a = vm_of(&in_place), *b = vm_of(&beside);

    return memcmp(in_place.sv, beside.sv, m.sv_size) == 0 && memcmp(smvm_locals(vm_of(&in_place)), smvm_locals(vm_of(&beside)), m.locals) == 0
        && smvm_state(a) == smvm_state(b) && a->first == b->first && smvm_time(a) == smvm_time(b);
}
#endif

// ---- commands ----

static SmResult init(Form *f, uint32_t state)
{
    const SmvmVector vector = { f->sv, m.sv_size, m.layout };

    memset(f->sv, 0, m.sv_size);
    return smvm_init(f->memory, sizeof f->memory, &m, &vector, state);
}

static void run_init(void)
{
    const uint32_t state = take_u32();

    if (!loaded)
        return;
    SmResult result = init(&in_place, state);
#if VM_DECODED
    if (decoded != NULL && result == SM_OK && (init(&beside, state) != SM_OK || !agree()))
        result = SM_E_ARGUMENT;
#endif
    answer(result == SM_OK ? 0 : 2, false);
}

static void run_step(void)
{
    for (uint32_t n = take_u32(); n > 0; n--) {
        const uint32_t var = take_u32();
        const uint64_t value = take_u64();
        if (!loaded || var >= cells)
            continue;
        write_cell(&in_place, &cell[var], value);
#if VM_DECODED
        if (decoded != NULL)
            write_cell(&beside, &cell[var], value);
#endif
    }
    if (!loaded)
        return;
    const SmResult result = smvm_step(vm_of(&in_place), in_place.sv);
    uint32_t status = result == SM_OK ? 0 : result == SM_REFUSED ? 1 : 2;
#if VM_DECODED
    if (decoded != NULL && (smvm_step_decoded(decoded, beside.sv) != result || !agree()
                            || (result == SM_OK && !both_stored())))
        status = 3;
#endif
    answer(status, status == 0);
}

static void take_cells(uint32_t n)
{
    for (uint32_t i = 0; i < n; i++) {
        Cell c;
        c.in = (uint8_t)take_u32();
        c.type = (uint8_t)take_u32();
        c.offset = take_u32();
        c.output = take_u32();
        c.value = take_u64();
        if (i < VM_CELLS)
            cell[i] = c;
    }
    cells = n < VM_CELLS ? n : VM_CELLS;
}

// Loads the machines that fit.  `loaded`: all of them fit and can run.
static uint32_t load(SmvmVerdict *why)
{
    const uint32_t n = take_u32();
    take_cells(n);
    const uint32_t size = take_u32();
    for (uint32_t i = 0; i < size; i++) {
        const int c = getchar();
        if (i < VM_IMAGE)
            image[i] = (uint8_t)c;
    }
    loaded = false;
    if (size > VM_IMAGE || n > VM_CELLS)
        return NO_ROOM;
    if (smvm_verify(image, size, why) != 0)           // a limit of this target also counts as a lack of memory
        return why->rule == SMVM_R_RAM || why->rule == SMVM_R_LENGTH ? NO_ROOM : why->rule;
    if (!smvm_machine(image, 0, &m) || m.sv_size > sizeof in_place.sv || smvm_ram_size(&m) > sizeof in_place.memory)
        return NO_ROOM;
    loaded = true;
    return 0;
}

static void run_load(void)
{
    SmvmVerdict why = { 0, 0, 0, 0 };

    give(load(&why), 4);
    give(why.longest, 4);
#if VM_DECODED
    decoded = NULL;
    if (loaded && init(&beside, 1) == SM_OK && smvm_decode(&decoded, code, sizeof code, &m, vm_of(&beside), beside.sv) != SM_OK)
        decoded = NULL;
#endif
}

int main(void)
{
    uint64_t which;

    while (take(&which, 4))
        switch (take_u32()) {
        case 0: run_init(); break;
        case 1: run_step(); break;
        default: run_load(); break;
        }
    return 0;
}
