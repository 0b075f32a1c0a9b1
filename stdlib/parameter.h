// SPDX-License-Identifier: Apache-2.0
// Values of parameters (language.md 5.77 to 5.84): which ones a parameter can have, and how they are stored.
#ifndef SM_PARAMETER_H
#define SM_PARAMETER_H

#include "stdlib/convert.h"
#include "stdlib/math.h"

// Why a parameter cannot have a value: the rows of parameters.def.  0: it can.
typedef enum SmRefusal {
    SM_REFUSAL_NONE,
#define REFUSAL(name, text) SM_REFUSAL_##name,
#include "stdlib/parameters.def"
#undef REFUSAL
    SM_REFUSAL_COUNT
} SmRefusal;

// The values of a parameter: from lo to hi, both finite and exactly of its type.  Of a bool: 0 and 1.
typedef struct SmParameterRange { SmType type; SmF64 lo, hi; } SmParameterRange;

// Returns x as a parameter of this type stores it, but without saturating: an F32 rounds.
static inline SmF64 sm_parameter_rounded(SmType type, SmF64 x) { return type == SM_F32 ? sm_from_f32(sm_to_f32(x)) : x; }

// Returns why a parameter cannot have the value x.  The value is judged as stored (language.md 5.81).
static inline SmRefusal sm_parameter_judge(const SmParameterRange *r, SmF64 x)
{
    const SmF64 stored = sm_parameter_rounded(r->type, x);

    if (sm_is_nan(x))
        return SM_REFUSAL_NAN;
    if (r->type == SM_BOOL && !sm_eq(x, sm_from_i32(0)) && !sm_eq(x, sm_from_i32(1)))
        return SM_REFUSAL_TRUTH;
    if (sm_lt(stored, r->lo))
        return SM_REFUSAL_LOW;
    if (sm_lt(r->hi, stored))
        return SM_REFUSAL_HIGH;
    return r->type != SM_F32 && r->type != SM_F64 && !sm_eq(sm_trunc(x), x) ? SM_REFUSAL_FRACTION : SM_REFUSAL_NONE;
}

#endif
