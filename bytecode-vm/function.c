// SPDX-License-Identifier: Apache-2.0
// The elementary functions of the VM: the only copy of their code in a program.
#include "stdlib/elementary.h"

#include "bytecode-vm/image.h"

#define CALL_1(name) sm_##name(x)
#define CALL_2(name) sm_##name(x, y)

// A function that this VM lacks (SMVM_FUNCTIONS) is never called: the verifier refuses the image.
SmF64 smvm_call(uint8_t n, SmF64 x, SmF64 y)
{
    (void)y;
    switch (n) {
#define SM_ELEMENTARY(name, arguments, number) \
    case number: if (((uint32_t)SMVM_FUNCTIONS >> number & 1) != 0) return CALL_##arguments(name); break;
#include "stdlib/elementary.def"
#undef SM_ELEMENTARY
    }
    return x;
}
