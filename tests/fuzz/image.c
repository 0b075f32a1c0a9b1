// SPDX-License-Identifier: Apache-2.0
// Fuzz target: any bytes as an image, first unchanged, then with corrected length and checksum.  An image that is accepted can be signed, and is
// then accepted again.
#include "compiler/device/sign.h"
#include "tests/fuzz/fuzz.h"
#include "tests/unit/vm_hammer.h"

static void sign(const uint8_t *image, uint32_t size)
{
    static const uint8_t key[SMVM_KEY] = "fuzz";
    uint8_t *out;
    uint32_t length, number;
    SmvmVerdict why;

    if (smvm_verify(image, size, &why) != 0)
        return;
    size = smvm_u24(image, SMVM_LENGTH_AT);
    out = malloc(size + SIGN_ROOM);
    length = image_sign(image, size, key, 7, out);
    if (length != 0 && (smvm_verify(out, length, &why) != 0 || !smvm_auth_check(out, key, &number) || number != 7))
        abort();
    free(out);
}

unsigned long fuzz_reached;           // images that were accepted and ran
const unsigned fuzz_floor = 15;

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
    memcpy(copy, "smb", 3);
    copy[3] = SMVM_FORMAT;
    copy[8] = (uint8_t)size;
    copy[9] = (uint8_t)(size >> 8);
    copy[10] = (uint8_t)(size >> 16);
    fix_crc(copy);
    fuzz_reached += hammer(copy, (uint32_t)size, 1000, seed) == 0;
    sign(copy, (uint32_t)size);
    free(copy);
    return 0;
}
