// SPDX-License-Identifier: Apache-2.0
// The elementary functions on bits.  Compiled twice: with the computer's double as bits_native, and with -DSM_F64_SOFT=1 as bits_soft.
#include "stdlib/elementary.h"
#include "tests/elementary/arguments.h"

uint64_t SUBJECT(Function f, uint64_t a, uint64_t b);

uint64_t SUBJECT(Function f, uint64_t a, uint64_t b)
{
    const SmF64 x = sm_from_bits(a), y = sm_from_bits(b);

    (void)y;
    switch (f) {
#define FN(name, arguments, stdlib, reference) case FN_##name: return sm_bits(stdlib);
#include "tests/elementary/functions.def"
#undef FN
    case FUNCTIONS: break;
    }
    return 0;
}
