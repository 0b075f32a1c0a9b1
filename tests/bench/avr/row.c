// SPDX-License-Identifier: Apache-2.0
// Firmware: one machine of this folder in one form.  It steps each time the emulating computer (run.c) has written its inputs.  avr.sh defines
// HEADER, which contains the other declarations; MACHINE; SV, the type of the state vector; ROW_INIT and ROW_STEP.
#include HEADER
#include "tests/avr/mailbox.h"

static MACHINE;
static SV sv;
static TankBox box;

static void act(void) { ROW_STEP; }

int main(void)
{
    box.sv = (uint16_t)&sv;
    box.sv_size = sizeof sv;
    ROW_INIT;
    mailbox_serve(&box, act, 0);
}
