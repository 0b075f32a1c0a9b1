// SPDX-License-Identifier: Apache-2.0
// Runs the checks of psl.c on an emulated ATmega328P, and measures its timer.
//   run_psl ELF HERTZ
#include <stdio.h>
#include <stdlib.h>

#include "tests/avr/mailbox.h"
#include "tests/avr/sim.h"

int main(int argc, char **argv)
{
    const uint32_t hertz = argc == 3 ? (uint32_t)strtoul(argv[2], NULL, 10) : 0;
    const PslBox *box;
    double ms;
    Sim sim;

    if (hertz == 0 || !sim_open_at(&sim, argv[1], hertz) || !sim_until_ready(&sim))
        return 1;
    box = sim_mailbox(&sim);
    if (!sim_until_ready(&sim))
        return 1;
    ms = (double)sim.cycles * 1000 / hertz;
    printf("platform layer at %lu Hz: %u passed, %u failed; a timer of %d ms takes %.3f ms\n", (unsigned long)hertz, box->passed, box->failed,
           PSL_SLEEP, ms);
    if (box->failed)
        printf("tests/avr/psl.c:%u: failed\n", box->line);
    return box->failed != 0 || box->passed == 0 || ms < PSL_SLEEP || ms > PSL_SLEEP + 0.2;
}
