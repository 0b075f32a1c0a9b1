// SPDX-License-Identifier: Apache-2.0
// Seals messages with a key (seal.h).
#include "bytecode-vm/target/seal.h"

#include "bytecode-vm/auth.h"

void smvm_seal(const uint8_t *bytes, size_t n, const uint8_t *key, uint8_t *code)
{
    SmvmMac m;

    smvm_mac_begin(&m, key);
    for (size_t i = 0; i < n; i++)
        smvm_mac_byte(&m, bytes[i]);
    smvm_mac_end(&m, key, code);
}
