// SPDX-License-Identifier: Apache-2.0
// Platform without a console.
#include "runtime-c/pal/console.h"

SmResult pal_console_write(const char *text, size_t n)
{
    (void)text, (void)n;
    return SM_E_UNSUPPORTED;
}
