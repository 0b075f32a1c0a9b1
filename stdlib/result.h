// SPDX-License-Identifier: Apache-2.0
// SmResult: the status of a call.  SM_OK is zero; everything else is negative.
#ifndef SM_RESULT_H
#define SM_RESULT_H

#ifdef __cplusplus
extern "C" {
#endif

typedef enum SmResult {
#define SM_RESULT(name, number, text) SM_##name = number,
#include "stdlib/result.def"
#undef SM_RESULT
    SM_RESULT_LOWEST = -128   // the lower limit: a result fits a byte, as the smallest possible enum and in answers of a board (link.md)
} SmResult;

// The message of a result; "unknown result" for an unknown number.  On AVR it is in flash (flash.h).  An Arduino sketch prints it with
// Serial.print((const __FlashStringHelper *)sm_result_text(r)).
#ifdef SMVM_LIBRARY
#pragma GCC visibility push(default)
#endif
const char *sm_result_text(SmResult r);
#ifdef SMVM_LIBRARY
#pragma GCC visibility pop
#endif

#ifdef __cplusplus
}
#endif
#endif
