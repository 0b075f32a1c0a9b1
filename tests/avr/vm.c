// SPDX-License-Identifier: Apache-2.0
// Firmware: the VM as in flight, with any image that the computer writes to its flash (mailbox.h).
#include <avr/pgmspace.h>
#include <string.h>

#include "bytecode-vm/image.h"
#include "tests/avr/mailbox.h"

#ifndef VM_ROOM
#define VM_ROOM 1024
#endif

#ifdef FIRMWARE_EEPROM                  // configured like the generic firmware
#define IMAGE FIRMWARE_EEPROM
#else
static const uint8_t image[VM_ROOM] PROGMEM = {1};
#define IMAGE ((uint16_t)image)
#endif
static uint64_t sv[32], memory[96];
static VmBox box __attribute__((aligned(8)));       // so that the host can read it directly
extern char __heap_start;

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

static int8_t asked(void)
{
    if (box.what == VM_STEP)
        return (int8_t)smvm_step((SmVm *)memory, sv);
#ifndef VM_UNCHECKED
    if (box.what == VM_VERIFY) {
        SmvmVerdict why;
        return (int8_t)smvm_verify(IMAGE, VM_ROOM, &why);
    }
#endif
#ifdef VM_CELLS
    if (box.what == VM_STORE)
        smvm_store(sm_from_bits(box.x), box.type, &box.cell);
    if (box.what == VM_LOAD)
        box.x = sm_bits(smvm_load(box.type, &box.cell));
#endif
    return box.what == VM_INIT ? init() : 0;
}

static void act(void) { box.result = asked(); }

static void tell(void)
{
    const SmVm *vm = (const SmVm *)memory;

    box.local = vm->local;
    box.state = vm->state;
    memcpy(box.stored, vm->stored, sizeof box.stored);
}

int main(void)
{
    box.image = IMAGE;
    box.image_size = VM_ROOM;
    box.sv = (uint16_t)sv;
    box.sv_size = sizeof sv;
    box.memory = (uint16_t)memory;
    box.memory_size = sizeof memory;
    box.free = (uint16_t)&__heap_start;
#ifdef VM_CELLS
    box.cells = 1;
#endif
    mailbox_serve(&box, act, tell);
}
