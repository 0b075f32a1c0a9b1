// SPDX-License-Identifier: Apache-2.0
// A step that does nothing, out of the compiler's sight.
#include "tests/bench/bench.h"

void bench_nothing(void *machine, void *sv)
{
    (void)machine;
    (void)sv;
}
