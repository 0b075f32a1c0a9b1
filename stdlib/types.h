// SPDX-License-Identifier: Apache-2.0
// Enumerations and info structs for the rows of types.def, operators.def and builtins.def.  Contains no code: every layer may include it.
#ifndef SM_TYPES_H
#define SM_TYPES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifndef SMVM_BINDINGS        // defined for tools that read smvm.h for another language
#include "stdlib/f64.h"
#endif

#ifdef __cplusplus
extern "C" {
#endif

typedef enum SmKind { SM_KIND_SIGNED, SM_KIND_UNSIGNED, SM_KIND_FLOAT, SM_KIND_BOOL } SmKind;

// The type of an element or local.  Its value is the number that images and links use.
typedef enum SmType {
#define SM_TYPE(name, wire, spelling, ctype, bytes, kind) SM_##name = wire,
#include "stdlib/types.def"
#undef SM_TYPE
    SM_TYPE_COUNT
} SmType;

typedef struct SmTypeInfo {
    const char *spelling;   // as written by the user
    const char *ctype;      // the C type that represents the type in emitted C
    uint8_t bytes;          // size and alignment in memory and on the wire
    SmKind kind;
} SmTypeInfo;

extern const SmTypeInfo sm_type_info[SM_TYPE_COUNT];   // indexed by SmType

typedef enum SmOpClass { SM_CLASS_LOGIC, SM_CLASS_EQUALITY, SM_CLASS_RELATION, SM_CLASS_ARITH } SmOpClass;

typedef enum SmOperator {
#define SM_OPERATOR(name, spelling, arity, precedence, class) SM_OP_##name,
#include "stdlib/operators.def"
#undef SM_OPERATOR
    SM_OP_COUNT
} SmOperator;

typedef struct SmOpInfo {
    const char *spelling;
    uint8_t arity, precedence;
    SmOpClass op_class;
} SmOpInfo;

extern const SmOpInfo sm_op_info[SM_OP_COUNT];         // indexed by SmOperator

// The statistics of a rolling window. No builtin returns those from SM_STAT_OLDEST on: prev, rising, falling, held and rate are computed from them.
typedef enum SmStat {
    SM_STAT_AVG, SM_STAT_MEDIAN, SM_STAT_MIN, SM_STAT_MAX, SM_STAT_RANGE,
    SM_STAT_OLDEST, SM_STAT_NEWEST,       // the oldest sample; the newest sample
    SM_STAT_CHANGE,                       // the newest minus the oldest sample; 0 if there is only one
    SM_STAT_ELAPSED,                      // of a window of times: the newest minus the oldest
    SM_STAT_RUN_STEPS, SM_STAT_RUN_TIME,  // of a run of true samples: how many, at most the size; the time from the first to the newest
    SM_STAT_COUNT
} SmStat;

// The statistics of windows that store times (stdlib/roll.h), as a set of 1 << SmStat.
#define SM_STATS_OF_TIMES (1u << SM_STAT_ELAPSED | 1u << SM_STAT_RUN_STEPS | 1u << SM_STAT_RUN_TIME)
#define SM_STATS_OF_RUNS (1u << SM_STAT_RUN_STEPS | 1u << SM_STAT_RUN_TIME)

typedef enum SmBuiltin {
#define SM_PURE(name, arguments, usage, units, sentence) SM_FN_##name,
#define SM_COMPOSED(name, arguments, usage, units, steps, sentence) SM_FN_##name,
#define SM_LIST(name, units, sentence) SM_FN_##name,
#define SM_ROLL(name, stat, sentence) SM_FN_##name,
#define SM_SAMPLED(name, arguments, usage, sentence) SM_FN_##name,
#include "stdlib/builtins.def"
    SM_FN_COUNT
} SmBuiltin;

// What the units of a function's arguments and of its result have to do with each other.
typedef enum SmUnits {
    SM_UNITS_SAME,          // all arguments have one unit, and so has the result
    SM_UNITS_NUMBER,        // the argument has any unit; the result is a plain number
    SM_UNITS_OF_ANGLE,      // the argument is in radians; the result is a plain number
    SM_UNITS_ANGLE,         // the argument is a plain number; the result is in radians
    SM_UNITS_DIRECTION,     // all arguments have one unit; the result is in radians
    SM_UNITS_ROOT,          // the unit of the result is the square root of the argument's
    SM_UNITS_POWER,         // the second argument is a plain number: the power to which the unit of the first is raised
    SM_UNITS_SAMPLES        // decided by the statistics of windows that the function becomes; no call has it
} SmUnits;

typedef struct SmBuiltinInfo {
    const char *name;
    const char *usage;      // how the arguments are written: "(x, n)"
    const char *sentence;   // describes the result, for messages and docs
    uint8_t arguments;      // the number of arguments, or the least number; a roll function has 2
    uint8_t most;           // the most arguments: SM_LIST_MAX for a function of a list of values, else `arguments`
    bool is_roll;
    bool is_sampled;        // prev and similar
    SmStat stat;            // for a roll function: the statistic that it returns
    SmUnits units;
} SmBuiltinInfo;

extern const SmBuiltinInfo sm_builtin_info[SM_FN_COUNT];   // indexed by SmBuiltin

// Limits that the language itself sets.
#define SM_LIST_MAX 16          // the most arguments of min, max, median and average
#define SM_WINDOW_MAX 100000u   // the largest n of roll_x(x, n)

#ifdef __cplusplus
}
#endif
#endif
