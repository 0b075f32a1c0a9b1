// SPDX-License-Identifier: Apache-2.0
// The elementary functions of the VM: the only copy of their code in a program.
#include "stdlib/elementary.h"

#include "bytecode-vm/image.h"

#define CALL_1(name) sm_##name(x)
#define CALL_2(name) sm_##name(x, y)

// Returns elementary function n of x, or of x and y. A function that this VM lacks (SMVM_FUNCTIONS) is never called: the verifier refuses the image.
// Compares n instead of using a switch, because avr-gcc compiles a switch to a jump through a pointer, and then the deepest stack of a program cannot
// be computed.
SmF64 smvm_call(uint8_t n, SmF64 x, SmF64 y)
{
    (void)n;
    (void)y;
#define SM_ELEMENTARY(name, arguments, number) \
    if (n == number && ((uint32_t)SMVM_FUNCTIONS >> number & 1) != 0) return CALL_##arguments(name);
#include "stdlib/elementary.def"
#undef SM_ELEMENTARY
    return x;
}
