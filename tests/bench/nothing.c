// SPDX-License-Identifier: Apache-2.0
// A step that does nothing.  It has its own file so that the compiler cannot inline it.
#include "tests/bench/bench.h"

void bench_nothing(void *machine, void *sv)
{
    (void)machine;
    (void)sv;
}
