// SPDX-License-Identifier: Apache-2.0
// smvm_decoder.  A file of its own, because a program that refers to it links the decoded form.
#include "bytecode-vm/target/machine.h"

const SmvmDecoder smvm_decoder = {smvm_decoded_size, smvm_decode, smvm_step_decoded};
