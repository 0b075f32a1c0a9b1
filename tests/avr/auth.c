// SPDX-License-Identifier: Apache-2.0
// Firmware: the code of an image that the computer puts into its flash.
#include <avr/io.h>
#include <avr/pgmspace.h>

#include "bytecode-vm/auth.h"
#include "tests/avr/mailbox.h"

#define BARRIER __asm__ volatile("" ::: "memory")

static const uint8_t image[1100] PROGMEM = {1};
static AuthBox box __attribute__((aligned(2)));       // so that the computer may look at it as it is

int main(void)
{
    box.image = (uint16_t)image;
    box.image_size = sizeof image;
    GPIOR1 = (uint8_t)(uint16_t)&box;
    GPIOR2 = (uint8_t)((uint16_t)&box >> 8);
    for (;;) {
        GPIOR0 = AVR_READY;
        BARRIER;
        GPIOR0 = AVR_BEGIN;
        BARRIER;
        box.is_right = smvm_auth_check((SmvmBytes)(uint16_t)image, box.key, &box.number);
        BARRIER;
        GPIOR0 = AVR_END;
        BARRIER;
    }
}
