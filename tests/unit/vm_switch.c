// SPDX-License-Identifier: Apache-2.0
// The decoded form as compilers have it that know no addresses of labels: the same test.
#define SMVM_COMPUTED_GOTO 0
#include "bytecode-vm/fast.c"

#define DECODE_TEST "vm_switch"
#include "tests/unit/vm_decode.c"
