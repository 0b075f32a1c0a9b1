// SPDX-License-Identifier: Apache-2.0
// The rows of types.def, operators.def and builtins.def as arrays.
#include "stdlib/types.h"

const SmTypeInfo sm_type_info[SM_TYPE_COUNT] = {
#define SM_TYPE(name, wire, spelling, ctype, bytes, kind) [SM_##name] = { spelling, #ctype, bytes, kind },
#include "stdlib/types.def"
#undef SM_TYPE
};

const SmOpInfo sm_op_info[SM_OP_COUNT] = {
#define SM_OPERATOR(name, spelling, arity, precedence, class) [SM_OP_##name] = { spelling, arity, precedence, class },
#include "stdlib/operators.def"
#undef SM_OPERATOR
};

const SmBuiltinInfo sm_builtin_info[SM_FN_COUNT] = {
#define SM_PURE(name, arguments, usage, units, sentence) [SM_FN_##name] = { #name, usage, sentence, arguments, arguments, false, false, SM_STAT_COUNT, SM_UNITS_##units },
#define SM_COMPOSED(name, arguments, usage, units, steps, sentence) [SM_FN_##name] = { #name, usage, sentence, arguments, arguments, false, false, SM_STAT_COUNT, SM_UNITS_##units },
#define SM_LIST(name, units, sentence) [SM_FN_##name] = { #name, "(a, b, ...)", sentence, 2, SM_LIST_MAX, false, false, SM_STAT_COUNT, SM_UNITS_##units },
#define SM_ROLL(name, stat, sentence) [SM_FN_##name] = { #name, "(x, n)", sentence, 2, 2, true, false, SM_STAT_##stat, SM_UNITS_SAMPLES },
#define SM_SAMPLED(name, arguments, usage, sentence) [SM_FN_##name] = { #name, usage, sentence, arguments, arguments, false, true, SM_STAT_COUNT, SM_UNITS_SAMPLES },
#include "stdlib/builtins.def"
};
