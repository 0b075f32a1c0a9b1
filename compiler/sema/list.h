// SPDX-License-Identifier: Apache-2.0
// The functions of a list of values, min, max, median and average (language.md 3.42 to 3.46), as lists of simple operations, here called steps.
// Every engine has these operations, so images, boards and emitted C need nothing new.
#ifndef SMC_LIST_H
#define SMC_LIST_H

#include <stdint.h>

#include "stdlib/f64.h"
#include "stdlib/types.h"

typedef enum ListOp { LIST_NUMBER, LIST_MIN, LIST_MAX, LIST_ADD, LIST_SUB, LIST_DIV, LIST_NEG, LIST_LT } ListOp;

// One operation on values.  Values are numbered from 0: first the values of the list, then the results of the steps in their order.
typedef struct ListStep {
    ListOp op;
    uint8_t a, b;             // numbers of its operands; NEG has only a, NUMBER has none
    SmF64 number;             // NUMBER: the constant that the step produces
} ListStep;

// The longest function is the median of 16 values: 110 steps find the two in the middle, and 20 the value between them.
#define LIST_STEPS_MAX 160

// Writes the steps of a function of n values, 2 to SM_LIST_MAX, to `step`, and returns their number.  The result of the last one is the
// value of the function.
uint32_t list_steps(SmBuiltin fn, uint32_t n, ListStep *step);

// Returns the value of the function for n values.
SmF64 list_value(SmBuiltin fn, uint32_t n, const SmF64 *value);

#endif
