// SPDX-License-Identifier: Apache-2.0
// The VM on an emulated ATmega328P in lock step with the VM of this computer: the same verdict, and after every step the same state
// vector, locals, outputs stored and next state.
//   run_vm ELF STEPS LO HI IMAGE.smb…     the first machine of each image; those that need more room than the chip has are skipped.  Inputs
//                                         are random numbers from LO to HI; if both are 0 they are anything, time may stand still,
//                                         and the machine begins anew at any of its states from time to time
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bytecode-vm/image.h"
#include "bytecode-vm/smvm.h"
#include "stdlib/convert.h"
#include "tests/avr/mailbox.h"
#include "tests/avr/sim.h"

enum { RESTART = 97 };        // steps from one initialising to the next

typedef struct Pair {
    Sim sim;
    VmBox *box;
    uint8_t *ram;             // of the chip
    SmvmMachine m;
    uint64_t sv[64], memory[1024];                    // here
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

static bool ask(Pair *p, uint8_t what)
{
    p->box->what = what;
    return sim_until_ready(&p->sim);
}

static bool same(const Pair *p)
{
    const SmVm *vm = (const SmVm *)p->memory;

    for (uint32_t i = 0; i < p->m.outputs && i < 64; i++)
        if (smvm_stored(vm, i) != (p->box->stored[i / 8] >> i % 8 & 1))
            return false;
    return memcmp(p->ram + p->box->sv, p->sv, p->m.sv_size) == 0
        && memcmp(p->ram + p->box->memory + p->box->local, smvm_locals((SmVm *)p->memory), p->m.locals) == 0 && p->box->state == smvm_state(vm);
}

static bool start(Pair *p, uint64_t state)
{
    const SmvmVector vector = {p->sv, p->m.sv_size, p->m.layout};

    p->box->begins = (uint8_t)state;
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
    return sm_cell_from_f64(type, sm_div(sm_from_i32(lo * 100 + (int32_t)(r >> 8 & 0xFFFFFF) % ((hi - lo) * 100)), sm_from_i32(100)));
}

static void write(Pair *p, SmvmOperand o, uint64_t cell)
{
    sm_cell_store(o.type, (uint8_t *)p->sv + o.offset, cell);
    sm_cell_store(o.type, p->ram + p->box->sv + o.offset, cell);
}

static bool step(Pair *p, uint64_t g)
{
    SmResult here;

    for (uint32_t i = p->m.outputs + 2; i < p->m.operands; i++) {
        const SmvmOperand o = smvm_operand(&p->m, i);
        if (o.kind < SMVM_K_LOCAL)
            write(p, o, value(p, o.type));
    }
    write(p, smvm_operand(&p->m, p->m.outputs), g);
    here = smvm_step((SmVm *)p->memory, p->sv);
    if (!ask(p, VM_STEP) || p->box->result != here || !same(p))
        return false;
    p->sum += p->sim.cycles;
    p->steps++;
    if (p->most < p->sim.cycles)
        p->most = p->sim.cycles;
    return true;
}

static bool run(Pair *p, unsigned long steps)
{
    for (unsigned long i = 0; i < steps; i++)
        if ((i % RESTART == 0 && p->hi == 0 && !start(p, 1 + next(&p->state) % p->m.states))
            || !step(p, i + 1 - (p->hi == 0 && next(&p->state) % 16 == 0)))
            return false;
    return true;
}

static void test(Pair *p, const char *path, unsigned long steps)
{
    static uint8_t image[0x10000];
    SmvmVerdict why;
    FILE *f = fopen(path, "rb");
    size_t n = f != NULL ? fread(image, 1, sizeof image, f) : 0;

    if (f != NULL)
        fclose(f);
    if (smvm_verify(image, (uint32_t)n, &why) != 0 || n > p->box->image_size || !smvm_machine(image, 0, &p->m) || p->m.sv_size > p->box->sv_size
        || smvm_ram_size(&p->m) > sizeof p->memory) {
        skipped++;
        return;
    }
    memset(sim_flash(&p->sim) + p->box->image, 0, p->box->image_size);
    memcpy(sim_flash(&p->sim) + p->box->image, image, n);
    p->sum = p->steps = p->most = 0;
    p->state = 88172645463325252u;
    if (ask(p, VM_VERIFY) && p->box->result == 0 && start(p, 1) && run(p, steps)) {
        passed++;
        printf("%s: %lu steps, %.0f cycles on average, %lu at most\n", path, (unsigned long)p->steps, (double)p->sum / (double)p->steps,
               (unsigned long)p->most);
    } else if (p->box->what == VM_INIT && p->box->result == SM_E_MEMORY)
        skipped++;
    else {
        failed++;
        printf("%s: differs after %lu steps (verdict or result %d)\n", path, (unsigned long)p->steps, p->box->result);
    }
}

int main(int argc, char **argv)
{
    static Pair p;

    if (argc < 5 || !sim_open(&p.sim, argv[1]) || !sim_until_ready(&p.sim))
        return 1;
    p.box = sim_mailbox(&p.sim);
    p.ram = sim_ram(&p.sim);
    sim_paint(&p.sim, p.box->free);
    p.lo = atoi(argv[3]);
    p.hi = atoi(argv[4]);
    for (int i = 5; i < argc; i++)
        test(&p, argv[i], strtoul(argv[2], NULL, 10));
    printf("%u bytes of stack\n", sim_deepest(&p.sim, p.box->free));
    printf("%lu passed, %lu failed, %lu skipped\n", passed, failed, skipped);
    return failed != 0;
}
