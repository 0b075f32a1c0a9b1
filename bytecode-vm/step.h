// SPDX-License-Identifier: Apache-2.0
// What all that runs code has in common: how a step begins (language.md 6), and what a RAW local keeps.  Internal to the VM.
#ifndef SMVM_STEP_H
#define SMVM_STEP_H

#include "bytecode-vm/smvm.h"
#include "stdlib/convert.h"

// `g` and `s` are where elements G and S are.  False if G did not advance.  Else what the step before stored is yet to be cleared.
static inline bool smvm_advance(SmVm *vm, const void *g)
{
    uint64_t next = sm_cell_load(SM_U64, g) + 1;      // 0 for the last one there is

    if (next <= vm->next)
        return false;
    vm->next = next;
    return true;
}

static inline void smvm_enter(SmVm *vm, void *s)      // once it has advanced
{
    vm->entered = vm->first;
    if (vm->first) {
        vm->start = vm->next;
        sm_cell_store(SM_U32, s, vm->state);
    }
}

// What a RAW local keeps of x: of all NaNs one, for which of two comes out of an operation is the C compiler's choice, and whoever
// reads the local as another type would see it.
static inline SmF64 smvm_raw(SmF64 x) { return sm_is_nan(x) ? sm_from_bits(UINT64_C(0x7ff8000000000000)) : x; }

#endif
