// SPDX-License-Identifier: Apache-2.0
// Firmware: checks the authentication code of an image that the emulating computer writes to its flash.
#include <avr/pgmspace.h>

#include "bytecode-vm/auth.h"
#include "tests/avr/mailbox.h"

static const uint8_t image[1100] PROGMEM = {1};
static AuthBox box __attribute__((aligned(2)));       // so that the host can read it directly

static void act(void) { box.is_right = smvm_auth_check((SmvmBytes)(uint16_t)image, box.key, &box.number); }

int main(void)
{
    box.image = (uint16_t)image;
    box.image_size = sizeof image;
    mailbox_serve(&box, act, 0);
}
