// SPDX-License-Identifier: Apache-2.0
// The bench of the platform that has nothing.
#include "tests/psl/suite.h"

const Bench bench = {"none", false, false, false, false, NULL, 0, NULL, NULL};

void bench_begin(void) {}
Tally bench_end(void) { return TALLY(); }
