// SPDX-License-Identifier: Apache-2.0
// Images for tests of the store, and how they are sent to a store in a memory of psl/sim.
#ifndef TESTS_STORE_IMAGE_H
#define TESTS_STORE_IMAGE_H

#include <stdio.h>

#include "bytecode-vm/image.h"
#include "bytecode-vm/target/store.h"
#include "runtime-c/psl/sim/sim.h"

enum { IMAGE_ROOM = 1024, IMAGE_BLOCK = 32, IMAGE_SESSION = 7 };

typedef struct Image { uint8_t bytes[IMAGE_ROOM]; uint32_t length, checksum; } Image;

static inline bool image_load(const char *path, Image *image)
{
    FILE *f = fopen(path, "rb");

    if (!f)
        return false;
    image->length = (uint32_t)fread(image->bytes, 1, IMAGE_ROOM, f);
    fclose(f);
    image->checksum = smvm_uint(image->bytes, SMVM_CRC_AT, 4);
    return image->length > SMVM_HEADER && image->length < IMAGE_ROOM;
}

// A store in a memory: two records, then the slots.
static inline bool image_store(Store *s, const char *memory, uint8_t slots)
{
    StorePlan plan = {SIM_NVM_SIZE, slots, {NULL, NULL}};
    PalNvm nvm;
    PalNvmInfo info;
    uint32_t unit, record;

    if (pal_nvm_open(&nvm, memory, SIM_NVM_SIZE) != SM_OK || pal_nvm_info(nvm, &info) != SM_OK)
        return false;
    unit = info.erase ? info.erase : info.write;
    record = (STORE_RECORD + unit - 1) / unit * unit;
    plan.image[0] = sim_nvm(memory) + 2 * record;
    plan.image[1] = plan.image[0] + (SIM_NVM_SIZE - 2 * record) / slots / unit * unit;
    return smvm_store_open(s, nvm, &plan) == SM_OK;
}

// Sends an image in session IMAGE_SESSION, up to the verdict.
static inline SmResult image_send(Store *s, const Image *image)
{
    SmvmVerdict why;

    if (s->plan.slots == 1)
        smvm_store_run_built_in(s);
    if (smvm_store_begin(s, IMAGE_SESSION, image->length, image->checksum) != SM_OK)
        return SM_E_BUSY;
    for (uint32_t at = 0; at < image->length; at += IMAGE_BLOCK) {
        const uint32_t n = image->length - at < IMAGE_BLOCK ? image->length - at : IMAGE_BLOCK;
        if (smvm_store_write(s, IMAGE_SESSION, at, image->bytes + at, (uint8_t)n) != SM_OK)
            return SM_E_DEVICE;
    }
    return smvm_store_end(s, IMAGE_SESSION, &why);
}

#endif
