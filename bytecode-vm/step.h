// SPDX-License-Identifier: Apache-2.0
// How a step begins (language.md 6), whatever runs it.  Internal to the VM.
#ifndef SMVM_STEP_H
#define SMVM_STEP_H

#include "bytecode-vm/smvm.h"
#include "stdlib/convert.h"

// `g` and `s` are where elements G and S are.  False if G did not advance.  Else what the step before stored is yet to be cleared.
static inline bool smvm_begin(SmVm *vm, const void *g, void *s)
{
    uint64_t next = sm_cell_load(SM_U64, g) + 1;      // 0 for the last one there is

    if (next <= vm->next)
        return false;
    vm->entered = vm->first;
    if (vm->first) {
        vm->start = next;
        sm_cell_store(SM_U32, s, vm->state);
    }
    vm->next = next;
    return true;
}

#endif
