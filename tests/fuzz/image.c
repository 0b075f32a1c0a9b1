// SPDX-License-Identifier: Apache-2.0
// Any bytes as an image, once as they are and once with their length and checksum put right.
#include "tests/fuzz/fuzz.h"
#include "tests/unit/vm_hammer.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    uint64_t seed = size + 1;
    uint8_t *copy;

    if (size > 0xffffff)
        return 0;
    hammer(data, (uint32_t)size, 100, seed);
    if (size < 12)
        return 0;
    copy = malloc(size);
    memcpy(copy, data, size);
    memcpy(copy, "smb\1", 4);
    copy[8] = (uint8_t)size;
    copy[9] = (uint8_t)(size >> 8);
    copy[10] = (uint8_t)(size >> 16);
    fix_crc(copy);
    hammer(copy, (uint32_t)size, 1000, seed);
    free(copy);
    return 0;
}
