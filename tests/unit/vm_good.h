// SPDX-License-Identifier: Apache-2.0
// A valid machine with each kind of item, which the tests of the verifier change so that it violates one rule.
#ifndef VM_GOOD_H
#define VM_GOOD_H

#include <string.h>

#include "bytecode-vm/smvm.h"
#include "tests/test.h"
#include "tests/unit/vm_build.h"

enum { FLAG, VALUE };         // outputs: bool at 24, F64 at 16
enum { IN = 32, COUNT = 2 };  // an element, F64; a local, U16

static inline void put_load_input(Build *b) { typed(b, SMVM_ldx_elem, SM_F64, IN); }

// Builds a valid machine with each kind of item: two windows, of which the second follows the first, and two states.
static inline void put_good_machine(Build *b)
{
    memset(b, 0, sizeof *b);
    b->sv_words = 5;
    b->locals = 16;
    b->s = 2;
    b->states = 2;
    b->width = 1;
    b->windows = 2;
    b->window[0] = WINDOW(5, 1u << SM_STAT_AVG | 1u << SM_STAT_MIN);
    b->window[1] = WINDOW(3, 1u << SM_STAT_MEDIAN);
    b->outputs = 2;
    b->output[FLAG] = PLACE(BOOL, 24);
    b->output[VALUE] = PLACE(F64, 16);
    b->f32s = b->f64s = 1;
    memcpy(b->init, (const uint8_t[]){1, 0, SM_U16, 7, 0}, 5);       // U16 at 2 = 7
    b->init_size = 5;
    put_load_input(b);
    code(b, SMVM_sample, 1, 0);
    code(b, SMVM_stat, 2, SM_STAT_AVG, 0);
    code(b, SMVM_sample, 1, 1);
    code(b, SMVM_end, 0);
    end_function(b);
}

static inline void put_state(Build *b, unsigned target)
{
    code(b, SMVM_ldx_plus, 1, 7);
    typed(b, SMVM_st_local, SM_U16, COUNT);
    code(b, SMVM_end, 0);
    end_function(b);
    code(b, SMVM_stat, 2, SM_STAT_MEDIAN, 1);
    typed(b, SMVM_ldy_elem, SM_F64, IN);
    code(b, SMVM_jxy - 1 + SMVM_LESS, 1, 2);
    code(b, SMVM_goto, 1, target);
    code(b, SMVM_ldx_f64, 1, 0);
    code(b, SMVM_ldy_f32, 1, 0);
    code(b, SMVM_add, 0);
    code(b, SMVM_out, 1, VALUE);
    code(b, SMVM_end, 0);
    end_function(b);
    typed(b, SMVM_ldx_elem, SM_BOOL, 24);
    code(b, SMVM_ldy_plus, 1, 0);
    code(b, SMVM_set, 1, SMVM_EQUAL);
    code(b, SMVM_out, 1, FLAG);
    code(b, SMVM_end, 0);
    end_function(b);
}

static inline void good_states(Build *b)
{
    put_state(b, 2);
    put_state(b, 1);
}

static uint8_t image[8192];

static inline uint8_t verify(const Build *b, SmvmVerdict *v)
{
    return smvm_verify(image, build_image(b, image), v);
}

#define REFUSED(b, r)                                                                       \
    do {                                                                                    \
        SmvmVerdict v_;                                                                     \
        uint8_t got_ = verify(b, &v_);                                                      \
        if (got_ != SMVM_R_##r)                                                             \
            fprintf(stderr, "line %d: rule %u at %u\n", __LINE__, got_, (unsigned)v_.at);   \
        CHECK(got_ == SMVM_R_##r);                                                          \
    } while (0)

static inline Build build_good_machine(void)
{
    Build b;

    put_good_machine(&b);
    good_states(&b);
    return b;
}

// Begins a state.  The instructions that the caller adds until close_step become its step function.
static inline void open_step(Build *b)
{
    put_good_machine(b);
    end_function(b);
}

static inline void close_step(Build *b)
{
    end_function(b);
    end_function(b);
    put_state(b, 1);
}

#endif
