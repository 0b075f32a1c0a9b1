// SPDX-License-Identifier: Apache-2.0
// The operations with the soft type: compiled with -DSM_F64_SOFT=1, on a host and on a chip.
#include "stdlib/convert.h"
#include "stdlib/math.h"
#include "tests/soft/cells.h"

#if !SM_F64_SOFT
#error "this is about the soft type: -DSM_F64_SOFT=1"
#endif

uint64_t soft_result(SoftOp op, uint64_t a, uint64_t b)
{
    const SmF64 x = sm_from_bits(a), y = sm_from_bits(b);

    switch (op) {
#define OP(name, operands, soft, hardware) case SOFT_##name: return soft;
#include "tests/soft/ops.def"
#undef OP
    case SOFT_OPS: break;
    }
    return 0;
}
