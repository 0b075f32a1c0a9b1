// SPDX-License-Identifier: Apache-2.0
// SmResult: how a call went.  SM_OK is zero; everything else is negative.
#ifndef SM_RESULT_H
#define SM_RESULT_H

#ifdef __cplusplus
extern "C" {
#endif

typedef enum SmResult {
#define SM_RESULT(name, number, text) SM_##name = number,
#include "stdlib/result.def"
#undef SM_RESULT
    SM_RESULT_LOWEST = -128   // none is below: a result is a byte wherever types are as small as they may be, and in answers of a board (link.md)
} SmResult;

// The row's text; "unknown result" for a number that has none.  On AVR it is in flash (flash.h): in an Arduino's sketch,
// Serial.print((const __FlashStringHelper *)sm_result_text(r)).
const char *sm_result_text(SmResult r);

#ifdef __cplusplus
}
#endif
#endif
