// SPDX-License-Identifier: Apache-2.0
// The generic firmware: upload this once.  From then on the board takes machines and their pins over the cable, while it runs:
//     smc build recovery.sm --sv recovery.sv --io recovery.io
//     smc flash recovery.smb --port=/dev/ttyACM0
// The lamp on pin 13 lights up for a moment every second until then.  For an Uno and a Mega.
#include <smc.h>

void setup()
{
    smvm_firmware();                  // never returns
}

void loop() {}
