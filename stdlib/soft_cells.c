// SPDX-License-Identifier: Apache-2.0
// Operations on 64-bit values in memory (soft_cells.h), in portable C.
#define SM_F64_SOFT 1
#include "stdlib/soft_cells.h"
#include "stdlib/soft_pack.h"

#ifndef SM_SOFT_ASSEMBLY
// Returns the bits of |*x| if *x has the sign of n; 0 if it has the other sign or is NaN.
static uint64_t magnitude_if_same_sign(const SmF64 *x, uint32_t n)
{
    const uint64_t u = x->bits ^ ((uint64_t)(n & 0x80000000u) << 32);
    return u > SM_SOFT_INFINITY ? 0 : u;
}

bool sm_soft_beyond(const SmF64 *x, uint32_t n) { return magnitude_if_same_sign(x, n) > (uint64_t)(n & 0x7FFFFFFFu) << 32; }
bool sm_soft_reaches(const SmF64 *x, uint32_t n) { return magnitude_if_same_sign(x, n) >= (uint64_t)(n & 0x7FFFFFFFu) << 32; }
bool sm_soft_exceeds(const uint64_t *v, uint32_t n) { return *v > n; }
bool sm_soft_elapsed_exceeds(const uint64_t *start, const uint64_t *time, uint32_t n) { return *time - *start > n; }
void sm_soft_increment(uint64_t *v) { *v += *v < UINT64_C(0x20000000000000); }

// Begins a step at *time: if *time is later than the last step and not the largest time, updates *gate and returns true.  *gate is the time
// of the last step plus 1; 0 before the first step.
bool sm_soft_advance(uint64_t *gate, const uint64_t *time)
{
    const uint64_t next = *time + 1;

    if (next <= *gate)
        return false;
    *gate = next;
    return true;
}
#else
extern int sm_soft_cells_is_assembly;         // a file must not be empty in C
#endif
