// SPDX-License-Identifier: Apache-2.0
// The guarantees of console.h on every platform.  Each platform's own tests check that text arrives.
#include "runtime-c/pal/console.h"
#include "tests/psl/suite.h"

Tally contract_console(void)
{
    if (bench.console == HAS_NONE) {
        CHECK(pal_console_write("x", 1) == SM_E_UNSUPPORTED);
        CHECK(pal_console_write(NULL, 0) == SM_E_UNSUPPORTED);
        return TALLY();
    }
    CHECK(pal_console_write(NULL, 1) == SM_E_ARGUMENT);
    CHECK(pal_console_write("", 0) == SM_OK);
    CHECK(pal_console_write("console: a line\n", 16) == SM_OK);
    return TALLY();
}
