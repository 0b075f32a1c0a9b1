// SPDX-License-Identifier: Apache-2.0
// The bench of the Linux platform: this computer.
#include "tests/psl/suite.h"

const Bench bench = {"linux", true, true, true, true};
