// SPDX-License-Identifier: Apache-2.0
// The bench of the platform that has nothing.
#include "tests/psl/suite.h"

const Bench bench = {"none", false, false, false, false};
