// SPDX-License-Identifier: Apache-2.0
// A machine on the VM, with its image in flash.
#include <stdlib.h>

#include "bytecode-vm/smvm.h"
#include IMAGE_HEADER
#include SV_HEADER

typedef struct Memory { uint64_t word[160]; } Memory;

static void start(void *memory, uint32_t size, void *sv, uint32_t sv_size)
{
    SmvmVector vector = {sv, 0, 0};
    SmvmMachine m;

    smvm_machine(SMVM_IMAGE(IMAGE), 0, &m);
    vector.size = sv_size;
    vector.layout = m.layout;
    if (smvm_init(memory, size, &m, &vector, 1) != SM_OK)
        abort();
}
