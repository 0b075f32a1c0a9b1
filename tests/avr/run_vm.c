// SPDX-License-Identifier: Apache-2.0
// The VM on an emulated ATmega328P in lock step with the VM of this computer: the same verdict, and after every step the same state vector,
// locals, stored outputs and next state.
//   run_vm ELF STEPS LO HI IMAGE.smb…     WIDE=1: the ends of functions are encoded in three bytes.  ESTIMATE=1: no step takes more cycles than the bound of cost.h.  The first machine of each image; those that need more room than the chip has are skipped.  Inputs
//                                         are random numbers from LO to HI; if both are 0 they are anything, time may stand still,
//                                         and the machine is initialized again in any of its states from time to time
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bytecode-vm/image.h"
#include "bytecode-vm/smvm.h"
#include "compiler/budget/cost.h"
#include "stdlib/convert.h"
#include "stdlib/crc32.h"
#include "tests/avr/mailbox.h"
#include "tests/avr/sim.h"
#include "tests/unit/host.h"

enum { RESTART = 97 };        // number of steps between two initialisations

typedef struct Pair {
    Sim sim;
    VmBox *box;
    uint8_t *ram;             // RAM of the chip
    SmvmMachine m;
    SmvmLocation input[64];   // elements that the machine reads and does not write
    uint32_t inputs;
    uint64_t sv[64], memory[1024];                    // state vector and memory on this computer
    uint64_t state, sum, steps, most;
    int32_t lo, hi;
} Pair;

static unsigned long passed, failed, skipped;

static uint64_t next(uint64_t *state)
{
    *state ^= *state >> 12;
    *state ^= *state << 25;
    *state ^= *state >> 27;
    return *state * 0x2545F4914F6CDD1Du;
}

static void add_input(Pair *p, SmType type, uint32_t offset)
{
    bool known = offset == p->m.g || offset == p->m.s || p->inputs == sizeof p->input / sizeof p->input[0];

    for (uint32_t i = 0; i < p->m.outputs; i++)
        known = known || smvm_output(&p->m, i).offset == offset;
    for (uint32_t i = 0; i < p->inputs; i++)
        known = known || p->input[i].offset == offset;
    if (known)
        return;
    p->input[p->inputs].type = type;
    p->input[p->inputs++].offset = offset;
}

static void find_places(Pair *p)                      // in the code
{
    const SmvmAt end = p->m.code_at + p->m.code_size;
    SmvmAt at = p->m.code_at;
    uint32_t n = 0;

    p->inputs = 0;
    while (at < end) {
        const uint8_t op = p->m.image[at++];
        const bool reads = (smvm_shape(op) & SMVM_SHAPE_E) != 0;
        while (at < end && p->m.image[at] < SMVM_OP_FIRST)
            if (smvm_read_varint(p->m.image, &at, end, &n) && reads)
                add_input(p, (SmType)(op & 0xf), n << smvm_type_shift(op & 0xf));
    }
}

static bool ask(Pair *p, uint8_t what)
{
    p->box->what = what;
    return sim_until_ready(&p->sim);
}

static bool same_locals(const Pair *p)                // and intermediate results
{
    return memcmp(p->ram + p->box->memory + p->box->local, smvm_locals((SmVm *)p->memory), p->m.locals) == 0;
}

static bool same(const Pair *p)
{
    const SmVm *vm = (const SmVm *)p->memory;

    const uint8_t *more = p->ram + p->box->memory + p->box->local + p->m.locals;         // bits of the outputs from 64 on

    for (uint32_t i = 0; i < p->m.outputs; i++)
        if (smvm_stored(vm, i) != ((i < 64 ? p->box->stored[i / 8] : more[i / 8 - 8]) >> i % 8 & 1))
            return false;
    return memcmp(p->ram + p->box->sv, p->sv, p->m.sv_size) == 0
        && same_locals(p) && p->box->state == smvm_state(vm);
}

static bool start(Pair *p, uint64_t state)
{
    const SmvmVector vector = {p->sv, p->m.sv_size, p->m.layout};

    p->box->begins = (uint16_t)state;
    memset(p->sv, 0, sizeof p->sv);
    memset(p->ram + p->box->sv, 0, p->box->sv_size);
    if (smvm_init((SmVm *)p->memory, sizeof p->memory, &p->m, &vector, p->box->begins) != SM_OK)
        return false;
    return ask(p, VM_INIT) && p->box->result == SM_OK && same(p);
}

static uint64_t value(Pair *p, SmType type)
{
    const uint64_t r = next(&p->state);
    const int32_t lo = p->hi != 0 ? p->lo : 0, hi = p->hi != 0 ? p->hi : 1000;

    if (p->hi == 0 && r % 8 == 0)
        return next(&p->state);
    if (p->hi == 0 && r % 8 == 1) {                   // limits of types, infinities, NaN, -0
        const uint64_t ones = UINT64_MAX << (r >> 8 & 63);
        return r & 16 ? ones : ~ones;
    }
    return sm_cell_from_f64(type, sm_div(sm_from_i32(lo * 100 + (int32_t)(r >> 8 & 0xFFFFFF) % ((hi - lo) * 100)), sm_from_i32(100)));
}

static void write(Pair *p, SmType type, uint32_t offset, uint64_t cell)
{
    sm_cell_store(type, (uint8_t *)p->sv + offset, cell);
    sm_cell_store(type, p->ram + p->box->sv + offset, cell);
}

static bool step(Pair *p, uint64_t g)
{
    SmResult here;

    for (uint32_t i = 0; i < p->inputs; i++)
        write(p, p->input[i].type, p->input[i].offset, value(p, p->input[i].type));
    write(p, SM_U64, p->m.g, g);
    here = smvm_step((SmVm *)p->memory, p->sv);
    if (!ask(p, VM_STEP) || p->box->result != here || !same(p))
        return false;
    p->sum += p->sim.cycles;
    p->steps++;
    if (p->most < p->sim.cycles)
        p->most = p->sim.cycles;
    return true;
}

// Returns G of step i.  If inputs can be any value, G exceeds 32 bits, and in the end T does, too.
static uint64_t time_of(Pair *p, unsigned long i)
{
    if (p->hi != 0)
        return i + 1;
    return i + 1 - (next(&p->state) % 16 == 0) + (i / RESTART % 2 != 0 ? 0xFFFFFFE0u : 0) + ((uint64_t)(i % RESTART > 60) << 33);
}

static bool run(Pair *p, unsigned long steps)
{
    for (unsigned long i = 0; i < steps; i++)
        if ((i % RESTART == 0 && p->hi == 0 && !start(p, 1 + next(&p->state) % p->m.states))
            || !step(p, time_of(p, i)))
            return false;
    return step(p, UINT64_MAX) && step(p, UINT64_MAX - 1);
}

static uint32_t estimate(const Pair *p, const uint8_t *image)
{
    Arena arena;
    Cost cost;

    HOST_ARENA(&arena);
    cost_of_machine(&arena, image, 0, p->box->image < 0x8000 ? COST_CYCLES_FLASH : COST_CYCLES_EEPROM, &cost);
    arena_free(&arena);
    return cost.worst;
}

static void tell(const Pair *p, const char *path, const uint8_t *image)
{
    printf("%s: %lu steps, %.0f cycles on average, %lu at most", path, (unsigned long)p->steps, (double)p->sum / (double)p->steps,
           (unsigned long)p->most);
    passed++;
    if (getenv("ESTIMATE")) {
        printf(", %lu estimated", (unsigned long)estimate(p, image));
        failed += p->most > estimate(p, image);
        printf("%s", p->most > estimate(p, image) ? ": too little" : "");
    }
    puts("");
}

static void put(uint8_t *at, uint32_t v, unsigned bytes)
{
    for (unsigned i = 0; i < bytes; i++)
        at[i] = (uint8_t)(v >> 8 * i);
}

// Makes the entries of the function table three bytes wide, as the compiler does for more than 64 KB of code, in an image of one machine.
static size_t widen_function_table(uint8_t *image, size_t n)
{
    enum { WIDE = 3, NUMBERS_BEFORE = 7 };
    SmvmMachine m;
    SmvmAt at;
    uint32_t entries, number, grows, crc = SM_CRC32_START;

    if (!smvm_machine(image, 0, &m))
        return n;
    entries = 3 * m.states + 1;
    grows = entries * (WIDE - m.width);
    memmove(image + m.functions_at + WIDE * entries, image + m.functions_at + m.width * entries, n - m.functions_at - m.width * entries);
    for (uint32_t i = entries; i-- > 0;)
        put(image + m.functions_at + WIDE * i, smvm_uint(image, m.functions_at + i * m.width, (uint8_t)m.width), WIDE);
    at = m.machine_at + 4;
    for (int i = 0; i < NUMBERS_BEFORE; i++)
        smvm_read_varint(image, &at, (SmvmAt)n, &number);
    image[at] = WIDE;
    for (uint8_t i = 0; i < smvm_section_count(image); i++) {
        SmvmSection s;
        smvm_read_section(image, i, &s);
        uint8_t *entry = image + SMVM_HEADER + SMVM_SECTION_ENTRY * i;
        if (s.at > m.machine_at)
            put(entry + 2, s.at + grows, 3);
        else if (s.at == m.machine_at)
            put(entry + 5, s.size + grows, 3);
    }
    put(image + SMVM_LENGTH_AT, (uint32_t)n + grows, 3);
    for (uint32_t i = 0; i < n + grows; i++)
        if (i < SMVM_CRC_AT || i >= SMVM_CRC_AT + 4)
            crc = sm_crc32_byte(crc, image[i]);
    put(image + SMVM_CRC_AT, sm_crc32_end(crc), 4);
    return n + grows;
}

static void test(Pair *p, const char *path, unsigned long steps)
{
    static uint8_t image[0x10000];
    SmvmVerdict why;
    FILE *f = fopen(path, "rb");
    size_t n = f != NULL ? fread(image, 1, sizeof image / 2, f) : 0;

    if (f != NULL)
        fclose(f);
    if (getenv("WIDE"))
        n = widen_function_table(image, n);
    if (smvm_verify(image, (uint32_t)n, &why) != 0 || n > p->box->image_size || !smvm_machine(image, 0, &p->m) || p->m.sv_size > p->box->sv_size
        || smvm_ram_size(&p->m) > sizeof p->memory) {
        skipped++;
        return;
    }
    memset(image + n, 0, sizeof image - n);
    if (p->box->image < 0x8000)
        memcpy(sim_flash(&p->sim) + p->box->image, image, p->box->image_size);
    else
        sim_eeprom(&p->sim, image, p->box->image_size);
    find_places(p);
    p->sum = p->steps = p->most = 0;
    p->state = 88172645463325252u;
    if (ask(p, VM_VERIFY) && p->box->result == 0 && start(p, 1) && run(p, steps)) {
        tell(p, path, image);
    } else if (p->box->what == VM_INIT && p->box->result == SM_E_MEMORY)
        skipped++;
    else {
        failed++;
        printf("%s: differs after %lu steps (verdict or result %d)\n", path, (unsigned long)p->steps, p->box->result);
    }
}

// Reads and writes elements of all types, as the code of pins does.
static void test_cells(Pair *p)
{
    p->state = 88172645463325252u;
    p->hi = p->lo = 0;
    for (unsigned i = 0; i < 2000; i++) {
        const SmType type = (SmType)(i % SM_TYPE_COUNT);
        const uint64_t x = value(p, SM_F64), cell = value(p, type);
        uint64_t here = cell;
        bool same;
        p->box->type = (uint8_t)type;
        p->box->cell = cell;
        same = ask(p, VM_LOAD) && p->box->x == sm_bits(sm_load(type, &cell));
        p->box->x = x;
        sm_store(type, &here, sm_from_bits(x));
        if (!same || !ask(p, VM_STORE) || p->box->cell != here) {
            printf("an element of type %d differs, %016llx or %016llx\n", type, (unsigned long long)x, (unsigned long long)cell);
            failed++;
            return;
        }
    }
    passed++;
}

int main(int argc, char **argv)
{
    static Pair p;

    if (argc < 5 || !sim_open(&p.sim, argv[1]) || !sim_until_ready(&p.sim))
        return 1;
    p.box = sim_mailbox(&p.sim);
    p.ram = sim_ram(&p.sim);
    if (p.box->cells)
        test_cells(&p);
    sim_paint(&p.sim, p.box->free);
    p.lo = atoi(argv[3]);
    p.hi = atoi(argv[4]);
    for (int i = 5; i < argc; i++)
        test(&p, argv[i], strtoul(argv[2], NULL, 10));
    printf("%u bytes of stack\n", sim_deepest(&p.sim, p.box->free));
    printf("%lu passed, %lu failed, %lu skipped\n", passed, failed, skipped);
    return failed != 0 || passed <= skipped;              // most of the images must have fitted into the chip
}
