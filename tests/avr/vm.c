// SPDX-License-Identifier: Apache-2.0
// Firmware: the VM as it flies, on whatever image the computer puts into its flash (mailbox.h).
#include <avr/io.h>
#include <avr/pgmspace.h>
#include <string.h>

#include "bytecode-vm/smvm.h"
#include "tests/avr/mailbox.h"

#ifndef VM_IMAGE
#define VM_IMAGE 1024
#endif

#ifdef VM_EEPROM
#define IMAGE FIRMWARE_EEPROM
#else
static const uint8_t image[VM_IMAGE] PROGMEM = {1};
#define IMAGE ((uint16_t)image)
#endif
static uint64_t sv[32], memory[96];
static VmBox box __attribute__((aligned(2)));       // so that the computer may look at it as it is
extern char __heap_start;

#define BARRIER __asm__ volatile("" ::: "memory")

static int8_t init(void)
{
    SmvmMachine m;
    SmvmVector vector = {sv, 0, 0};

    if (!smvm_machine(IMAGE, 0, &m))
        return -100;
    vector.size = m.sv_size;
    vector.layout = m.layout;
    return (int8_t)smvm_init(memory, sizeof memory, &m, &vector, box.begins);
}

static int8_t act(void)
{
#ifndef VM_UNCHECKED
    SmvmVerdict why;

    if (box.what == VM_VERIFY)
        return (int8_t)smvm_verify(IMAGE, VM_IMAGE, &why);
#endif
    if (box.what == VM_INIT)
        return init();
    return (int8_t)smvm_step((SmVm *)memory, sv);
}

int main(void)
{
    box.image = IMAGE;
    box.image_size = VM_IMAGE;
    box.sv = (uint16_t)sv;
    box.sv_size = sizeof sv;
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
        const SmVm *vm = (const SmVm *)memory;
        box.local = vm->local;
        box.state = vm->state;
        memcpy(box.stored, vm->stored, sizeof box.stored);
        BARRIER;
    }
}
