// SPDX-License-Identifier: Apache-2.0
// Runs a firmware as a program: its standard input and output are the chip's console.  cc.sh appends the content of the flash to this program,
// then the chip's name in 16 bytes and the size of the flash in 4.
#include <simavr/sim_avr.h>
#include <stdio.h>
#include <string.h>

#include "tests/avr/sim.h"

#define PATIENCE 1600000000u  // cycles without output until the run ends

static uint8_t own[8000000];

int main(void)
{
    Sim s;
    FILE *f = fopen("/proc/self/exe", "rb");
    const size_t n = f != NULL ? fread(own, 1, sizeof own, f) : 0;
    uint32_t size = 0;
    int state = cpu_Running;

    if (n < 20 || n == sizeof own)
        return 1;
    memcpy(&size, own + n - 4, 4);
    if (size > n - 20 || !sim_open_flash(&s, (const char *)own + n - 20, own + n - 20 - size, size))
        return 1;
    sim_connect(&s);
    while (state != cpu_Done && state != cpu_Crashed && ((avr_t *)s.avr)->cycle - s.begin < PATIENCE)
        state = avr_run(s.avr);
    fprintf(stderr, "the firmware has ended, or says nothing\n");
    return 1;
}
