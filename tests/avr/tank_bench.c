// SPDX-License-Identifier: Apache-2.0
// Firmware: the emitted tank and the handwritten one (tank_hand.c), of which one makes a step when the computer requests it (mailbox.h).
#include <avr/io.h>

#include "tests/avr/mailbox.h"
#include "tests/avr/tank_hand.h"

static Tank tank;
static Hand hand;
static TankSv sv[2];
static TankBox box;

static void step(void)
{
    if (box.what == TANK_HAND)
        box.result = tank_by_hand_step(&hand, &sv[TANK_HAND]);
    else
        box.result = tank_step(&tank, &sv[TANK_EMITTED]) == TANK_OK;
}

static void begin(void)
{
    tank_by_hand_init(&hand, &sv[TANK_HAND], box.begins);
    tank_init(&tank, &sv[TANK_EMITTED], box.begins);
}

int main(void)
{
    box.sv = (uint16_t)sv;
    box.sv_size = sizeof sv[0];
    box.begins = 1;
    begin();
    GPIOR1 = (uint8_t)(uint16_t)&box;
    GPIOR2 = (uint8_t)((uint16_t)&box >> 8);
    for (;;) {
        GPIOR0 = AVR_READY;
        BARRIER;
        if (box.begins != 0)
            begin();
        GPIOR0 = AVR_BEGIN;
        BARRIER;
        step();
        BARRIER;
        GPIOR0 = AVR_END;
        BARRIER;
    }
}
