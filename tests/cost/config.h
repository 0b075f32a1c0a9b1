// SPDX-License-Identifier: Apache-2.0
// A build of the VM that counts the instructions it runs: opcodes are the bytes from 0x80 in its code, and nothing else is.
#ifndef TESTS_COST_CONFIG_H
#define TESTS_COST_CONFIG_H

#include <stdint.h>

uint8_t cost_fetch(const uint8_t *at);

#define SMVM_BYTES const uint8_t *
#define SMVM_FETCH(image, at) cost_fetch((image) + (at))

#endif
