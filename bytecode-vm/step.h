// SPDX-License-Identifier: Apache-2.0
// The parts of a step that all interpreters share: how it begins (language.md 6), and the value of a RAW local.  Internal to the VM.
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

// Returns the value that a RAW local stores for x.  Every NaN becomes one fixed NaN: which NaN an operation on two NaNs returns depends on the
// C compiler, and code that reads the local as another type could see the difference.
static inline SmF64 smvm_raw(SmF64 x) { return sm_is_nan(x) ? sm_from_bits(UINT64_C(0x7ff8000000000000)) : x; }

#endif
