// SPDX-License-Identifier: Apache-2.0
// Firmware: the runner of the generic firmware, with its image in EEPROM and the pins of the chip.  It steps when the host requests it
// (mailbox.h).
#include "bytecode-vm/firmware/runner.h"
#include "runtime-c/psl/avr/avr.h"
#include "tests/avr/mailbox.h"

static uint64_t memory[FIRMWARE_MEMORY / 8];
static SmvmRunner runner = {.memory = memory, .size = sizeof memory};
static PinsBox box __attribute__((aligned(8)));       // so that the host can read it directly
extern char __heap_start;

#define BARRIER __asm__ volatile("" ::: "memory")

static int8_t act(void)
{
    SmvmVerdict why;

    switch (box.what) {
    case PINS_VERIFY: return (int8_t)smvm_verify(FIRMWARE_EEPROM, E2END + 1, &why);
    case PINS_OPEN: return (int8_t)smvm_runner_open(&runner, FIRMWARE_EEPROM);
    case PINS_STEP: smvm_runner_step(&runner, &box.g); break;
    default: smvm_runner_stop(&runner);
    }
    return 0;
}

int main(void)
{
    box.memory = (uint16_t)memory;
    box.memory_size = sizeof memory;
    box.free = (uint16_t)&__heap_start;
    GPIOR1 = (uint8_t)(uint16_t)&box;
    GPIOR2 = (uint8_t)((uint16_t)&box >> 8);
    for (;;) {
        GPIOR0 = AVR_READY;
        BARRIER;
        GPIOR0 = AVR_BEGIN;
        BARRIER;
        box.result = act();
        BARRIER;
        GPIOR0 = AVR_END;
        BARRIER;
    }
}
