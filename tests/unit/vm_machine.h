// SPDX-License-Identifier: Apache-2.0
// A machine of one or two states, made by hand, for the tests of the interpreter.
#ifndef VM_MACHINE_H
#define VM_MACHINE_H

#include <string.h>

#include "bytecode-vm/smvm.h"
#include "tests/test.h"
#include "tests/unit/vm_build.h"

// One machine whose state 1 has a step function under test.  Outputs: F64 at 16, bool at 24; inputs: F64 at 32 and 40; locals: U8 at 0,
// F32 at 4, RAW at 8.
enum { OUT, OUT_FLAG };
enum { IN_X = 32, IN_Y = 40, LOCAL_U8 = 0, LOCAL_F32 = 4, LOCAL_RAW = 8 };

typedef struct Machine {
    uint64_t sv[8];
    uint64_t memory[200];
    uint8_t image[4096];
    SmvmMachine m;
} Machine;

static inline void begin(Build *b)
{
    memset(b, 0, sizeof *b);
    b->sv_words = 8;
    b->locals = 16;
    b->states = 1;
    b->width = 1;
    b->s = 2;
    b->outputs = 2;
    b->output[OUT] = PLACE(F64, 16);
    b->output[OUT_FLAG] = PLACE(BOOL, 24);
    b->f32s = 2;
    b->f32[0] = 0x3e800000u;                          // 0.25
    b->f32[1] = 0x7fc00000u;
    b->f64s = 1;
    b->f64[0] = 0x3fb999999999999au;                  // 0.1
}

static inline void load_x(Build *b) { typed(b, SMVM_ldx_elem, SM_F64, IN_X); }
static inline void load_y(Build *b) { typed(b, SMVM_ldy_elem, SM_F64, IN_Y); }
static inline void put_out(Build *b) { code(b, SMVM_out, 1, OUT); }

static inline SmResult init(Machine *t, void *memory, uint32_t size, void *sv, uint32_t state)
{
    const SmvmVector v = {sv, sizeof t->sv, 0};

    return smvm_init(memory, size, &t->m, &v, state);
}

static inline bool open_machine(Machine *t, const Build *b, uint32_t state)
{
    SmvmVerdict v;
    uint32_t n = build_image(b, t->image);

    if (smvm_verify(t->image, n, &v) != 0) {
        printf("refused by rule %u at %u\n", v.rule, (unsigned)v.at);
        return false;
    }
    memset(t->sv, 0, sizeof t->sv);
    memset(t->memory, 0xa5, sizeof t->memory);
    return smvm_machine(t->image, 0, &t->m) && smvm_ram_size(&t->m) <= sizeof t->memory
        && init(t, t->memory, sizeof t->memory, t->sv, state) == SM_OK;
}

static inline double f64_at(const Machine *t, unsigned offset)
{
    double x;

    memcpy(&x, t->sv + offset / 8, sizeof x);
    return x;
}

static inline void set_f64(Machine *t, unsigned offset, double x) { memcpy(t->sv + offset / 8, &x, sizeof x); }

// Returns the number at an offset of the vector.  The images below have S at 8 unless stated otherwise.
static inline uint32_t state_at(const Machine *t, unsigned offset)
{
    uint32_t s;

    memcpy(&s, (const uint8_t *)t->sv + offset, sizeof s);
    return s;
}

static inline uint32_t s_of(const Machine *t) { return state_at(t, 8); }
static inline void set_s(Machine *t, uint32_t s) { memcpy((uint8_t *)t->sv + 8, &s, sizeof s); }

// Runs a step function of the given instructions and `end`, with x and y as inputs.
static inline bool run(Machine *t, Build *b, double x, double y)
{
    end_function(b);                                  // sample
    end_function(b);                                  // the code so far is the entry function; the step function follows
    b->end[0] = b->end[1] = 0;
    code(b, SMVM_end, 0);
    end_function(b);
    end_function(b);
    if (!open_machine(t, b, 1))
        return false;
    set_f64(t, 32, x);
    set_f64(t, 40, y);
    t->sv[0] = 5;
    return smvm_step((SmVm *)t->memory, t->sv) == SM_OK;
}

static inline double given(Build *b, double x, double y)     // OUT = X after the instructions
{
    Machine t;

    put_out(b);
    CHECK(run(&t, b, x, y));
    CHECK(smvm_stored((SmVm *)t.memory, 0) && !smvm_stored((SmVm *)t.memory, 1));
    return f64_at(&t, 16);
}

static inline bool same(double a, double b) { return memcmp(&a, &b, sizeof a) == 0; }

#endif
