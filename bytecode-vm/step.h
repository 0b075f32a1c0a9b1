// SPDX-License-Identifier: Apache-2.0
// The parts of a step that all interpreters share: how it begins (language.md 6), and what reading a number or storing a RAW local means.
// Internal to the VM.
#ifndef SMVM_STEP_H
#define SMVM_STEP_H

#include "bytecode-vm/smvm.h"
#include "stdlib/convert.h"

// Begins a step; g points to element G.  Returns false, and changes nothing, if G did not advance.  If it returns true, the caller must
// still clear vm->stored, the bits of the outputs that the previous step stored.
static inline bool smvm_advance(SmVm *vm, const void *g)
{
    uint64_t next = sm_cell_load(SM_U64, g) + 1;      // wraps to 0 for the largest G

    if (next <= vm->next)
        return false;
    vm->next = next;
    return true;
}

// Sets vm->entered to whether this step is the first of its state.  If it is, T starts at 0, and element S, at s, gets the state's number.  Call
// it after smvm_advance has returned true.
static inline void smvm_enter(SmVm *vm, void *s)
{
    vm->entered = vm->first;
    if (vm->first) {
        vm->start = vm->next;
        sm_cell_store(SM_U32, s, vm->state);
    }
}

// Stores the bits of the first 64 outputs.  Compilers turn this into one store on little-endian machines.
static inline void smvm_store_bits(uint8_t *stored, uint64_t bits)
{
    stored[0] = (uint8_t)bits;
    stored[1] = (uint8_t)(bits >> 8);
    stored[2] = (uint8_t)(bits >> 16);
    stored[3] = (uint8_t)(bits >> 24);
    stored[4] = (uint8_t)(bits >> 32);
    stored[5] = (uint8_t)(bits >> 40);
    stored[6] = (uint8_t)(bits >> 48);
    stored[7] = (uint8_t)(bits >> 56);
}

// Keeps compilers from replacing a rarely taken branch by a conditional move, which makes a chain of dependent instructions.
#if defined(__GNUC__) && !defined(__OPTIMIZE_SIZE__)
#define SMVM_KEEP_BRANCH __asm__ volatile("")
#else
#define SMVM_KEEP_BRANCH
#endif

// As sm_read_f64: the value that reading a stored x returns.
static inline SmF64 smvm_read_f64(SmF64 x)
{
    if (sm_is_nan(x)) {
        SMVM_KEEP_BRANCH;
        return sm_from_i32(0);
    }
    return x;
}

// Returns the value that a RAW local stores for x.  Every NaN becomes one fixed NaN: which NaN an operation on two NaNs returns depends on the
// C compiler, and code that reads the local as another type could see the difference.
static inline SmF64 smvm_raw(SmF64 x)
{
    if (sm_is_nan(x)) {
        SMVM_KEEP_BRANCH;
        return sm_from_bits(UINT64_C(0x7ff8000000000000));
    }
    return x;
}

#endif
