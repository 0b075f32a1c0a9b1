// SPDX-License-Identifier: Apache-2.0
// The generic firmware: upload this once.  From then on the board takes machines and their pins over the cable, while it runs:
//     smc build recovery.sm --sv recovery.sv --io recovery.io
//     smc flash recovery.smb --port=/dev/ttyACM0
// The lamp on pin 13 lights up for a moment every second until then.  For an Uno, a Nano, a Pro Mini
// (there the line has 57600 bits per second at 8 MHz: add --speed=57600) and a Mega.
#include <smc.h>

#ifndef SMVM_HAS_FIRMWARE
#error "smc's firmware runs on an Uno, a Nano or a Pro Mini (ATmega328P) and on a Mega (ATmega2560), at 16 or 8 MHz: choose one of them in Tools, Board. The examples TankC and TankImage run on every board"
#endif

void setup()
{
    smvm_firmware();                  // never returns
}

void loop() {}
