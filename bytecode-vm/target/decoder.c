// SPDX-License-Identifier: Apache-2.0
#include "bytecode-vm/target/machine.h"

const SmvmDecoder smvm_decoder = {smvm_decoded_size, smvm_decode, smvm_step_decoded};
