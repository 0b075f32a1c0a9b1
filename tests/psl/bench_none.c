// SPDX-License-Identifier: Apache-2.0
// The bench of the platform without any device.
#include "tests/psl/suite.h"

Bench bench = {.name = "none"};

void bench_begin(void) {}
Tally bench_end(void) { return TALLY(); }
