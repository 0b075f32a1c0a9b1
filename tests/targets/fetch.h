// SPDX-License-Identifier: Apache-2.0
// Configures a target that reads the bytes of an image through a function, and its names as text.  The compiler includes it first (-include).
#ifndef TESTS_TARGETS_FETCH_H
#define TESTS_TARGETS_FETCH_H

#include <stdint.h>

#define SMVM_CONFIG "tests/targets/fetch.h"
#define SMVM_BYTES const uint8_t *
#define SMVM_FETCH(image, at) test_fetch((image) + (at))
#define SMVM_TEXT(image, at) ((const char *)(image) + (at))
#define SMVM_IMAGE_IN

static inline uint8_t test_fetch(const uint8_t *at) { return *at; }

#endif
