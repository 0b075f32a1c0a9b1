// SPDX-License-Identifier: Apache-2.0
// The bench of the platform that has nothing.
#include "tests/psl/suite.h"

Bench bench = {.name = "none"};

void bench_begin(void) {}
Tally bench_end(void) { return TALLY(); }
