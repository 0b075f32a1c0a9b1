// SPDX-License-Identifier: Apache-2.0
// The bench of the Linux platform: this computer.  What leaves files works in a folder of its own.
#define _GNU_SOURCE
#include <stdlib.h>
#include <unistd.h>

#include "tests/psl/suite.h"

const Bench bench = {"linux", true, true, true, true, "nvm", 1000, "no-such-folder/nvm", own_linux};

static char folder[256];

void bench_begin(void)
{
    const char *base = getenv("TMPDIR");

    snprintf(folder, sizeof folder, "%s/smc-psl.XXXXXX", base ? base : P_tmpdir);
    CHECK(mkdtemp(folder) != NULL && chdir(folder) == 0);
}

Tally bench_end(void)
{
    unlink("nvm");
    CHECK(chdir("/") == 0 && rmdir(folder) == 0);         // fails if a test left a file
    if (test_failed)
        printf("%s: not as expected\n", folder);
    return TALLY();
}
