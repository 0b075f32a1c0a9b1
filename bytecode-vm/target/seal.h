// SPDX-License-Identifier: Apache-2.0
// Seals messages of the network with a key (docs/config.md 11.18), with the code that also seals images (bytecode-vm/auth.h).
#ifndef SMVM_SEAL_H
#define SMVM_SEAL_H

#include "runtime-c/net.h"

#ifdef __cplusplus
extern "C" {
#endif

SmNetSeal smvm_seal;          // for SmNetMessage.seal

#ifdef __cplusplus
}
#endif
#endif
