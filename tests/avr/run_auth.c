// SPDX-License-Identifier: Apache-2.0
// The authentication code of images on an emulated ATmega328P.  An image that the host has signed is accepted, a changed one is not.  The
// duration of the check must not depend on the position of the change.
//   run_auth ELF
#include <stdio.h>
#include <string.h>

#include "bytecode-vm/image.h"
#include "compiler/device/sign.h"
#include "tests/avr/mailbox.h"
#include "tests/avr/sim.h"

enum { KILO = 1024 };

static unsigned long passed, failed;
static Sim sim;
static AuthBox *box;
static uint8_t *flash;

static void check(bool ok, const char *what, unsigned n)
{
    passed += ok;
    failed += !ok;
    if (!ok)
        printf("%s (%u)\n", what, n);
}

// Makes an image: a header, one section that fills it to `length` bytes, and AUTH.
static void make(uint32_t length, uint8_t *out)
{
    uint8_t plain[KILO + 64] = {'s', 'm', 'b', SMVM_FORMAT};
    const uint32_t n = length - SIGN_ROOM, at = SMVM_HEADER + SMVM_SECTION_ENTRY;

    plain[SMVM_SECTIONS_AT] = 1;
    plain[SMVM_HEADER] = SMVM_S_IDENTITY;
    plain[SMVM_HEADER + 2] = (uint8_t)at;
    for (uint32_t i = 0; i < 3; i++) {
        plain[SMVM_LENGTH_AT + i] = (uint8_t)(n >> 8 * i);
        plain[SMVM_HEADER + 5 + i] = (uint8_t)((n - at) >> 8 * i);
    }
    for (uint32_t i = at; i < n; i++)
        plain[i] = (uint8_t)(i * 37);
    image_sign(plain, n, box->key, 0x01020304, out);
}

static uint64_t ask(bool wanted, const char *what, unsigned n)
{
    box->number = 0;
    check(sim_until_ready(&sim) && box->is_right == wanted && box->number == 0x01020304, what, n);
    return sim.cycles;
}

int main(int argc, char **argv)
{
    uint8_t image[KILO + 64];
    uint64_t cycles = 0;

    if (argc < 2 || !sim_open(&sim, argv[1]) || !sim_until_ready(&sim))
        return 1;
    box = sim_mailbox(&sim);
    for (unsigned i = 0; i < SMVM_KEY; i++)
        box->key[i] = (uint8_t)(0xF3u * i + 77);
    flash = sim_flash(&sim) + box->image;
    for (uint32_t length = KILO - 20; length <= KILO; length++) {
        make(length, image);
        memcpy(flash, image, length);
        cycles = ask(true, "what is signed is not right", length);
    }
    printf("%lu cycles for 1 KB\n", (unsigned long)cycles);
    for (unsigned i = 40; i < KILO; i += 9) {
        if (i >= KILO - SMVM_AUTH && i < KILO - SMVM_AUTH + 4)
            continue;                                  // the number, which the check returns
        flash[i] ^= (uint8_t)(1u << i % 8);
        check(ask(false, "what was changed is right", i) == cycles, "it took another time", i);
        flash[i] ^= (uint8_t)(1u << i % 8);
    }
    box->key[7] ^= 1;
    check(ask(false, "another key is right", 7) == cycles, "another key took another time", 7);
    printf("%lu passed, %lu failed\n", passed, failed);
    return failed != 0;
}
