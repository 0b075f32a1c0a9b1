// SPDX-License-Identifier: Apache-2.0
// The same test as vm_decode, with the decoded form for compilers that have no addresses of labels.
#define SMVM_COMPUTED_GOTO 0
#include "bytecode-vm/fast.c"

#define DECODE_TEST "vm_switch"
#include "tests/unit/vm_decode.c"
