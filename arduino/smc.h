// SPDX-License-Identifier: Apache-2.0
// What a sketch includes: the VM that runs images (bytecode-vm/smvm.h says how) and the numbers of the language (stdlib/std.h).
#ifndef SMC_H
#define SMC_H

#include "bytecode-vm/smvm.h"
#include "stdlib/std.h"

#endif
