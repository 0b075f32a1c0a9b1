// SPDX-License-Identifier: Apache-2.0
// Runs the checks of psl.c on an emulated Uno.
//   run_psl ELF
#include <stdio.h>

#include "tests/avr/mailbox.h"
#include "tests/avr/sim.h"

int main(int argc, char **argv)
{
    Sim sim;
    const PslBox *box;

    if (argc != 2 || !sim_open(&sim, argv[1]) || !sim_until_ready(&sim))
        return 1;
    box = sim_mailbox(&sim);
    if (!sim_until_ready(&sim))
        return 1;
    printf("platform layer: %u passed, %u failed\n", box->passed, box->failed);
    if (box->failed)
        printf("tests/avr/psl.c:%u: failed\n", box->line);
    return box->failed != 0 || box->passed == 0;
}
