// SPDX-License-Identifier: Apache-2.0
// What a sketch includes: the VM that runs images (bytecode-vm/smvm.h says how), the numbers of the language (stdlib/std.h), and the generic
// firmware as a function (smvm_firmware, on Uno and Mega).
#ifndef SMC_H
#define SMC_H

#include <float.h>

#if defined(SM_F64_SOFT) && SM_F64_SOFT && DBL_MANT_DIG == 53
#error "include <smc.h> before the header of a machine: the numbers of the library are this board's own"
#endif

#include "bytecode-vm/firmware/firmware.h"
#include "bytecode-vm/smvm.h"
#include "stdlib/std.h"

#endif
