// SPDX-License-Identifier: Apache-2.0
// The message of a result.  A number used twice in result.def is a compile error: it would be a duplicate case of the switch.
#include "stdlib/result.h"

#include "stdlib/flash.h"

const char *sm_result_text(SmResult r)
{
    switch (r) {
#define SM_RESULT(name, number, text) case SM_##name: return SM_TEXT(text);
#include "stdlib/result.def"
#undef SM_RESULT
    case SM_RESULT_LOWEST: break;
    }
    return SM_TEXT("unknown result");
}
