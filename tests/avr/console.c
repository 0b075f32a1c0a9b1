// SPDX-License-Identifier: Apache-2.0
// Firmware: standard input and output through two registers that the emulator watches (sim_connect), so that a program which reads and writes
// runs on the chip unchanged.
#include <avr/io.h>
#include <stdio.h>

static int give(char c, FILE *f)
{
    (void)f;
    GPIOR1 = (uint8_t)c;
    return 0;
}

static int take(FILE *f)
{
    (void)f;
    return GPIOR2;
}

static FILE console = FDEV_SETUP_STREAM(give, take, _FDEV_SETUP_RW);

__attribute__((constructor, used)) static void connect(void) { stdin = stdout = &console; }
