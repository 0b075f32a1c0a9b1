// SPDX-License-Identifier: Apache-2.0
// The communication between a firmware of this folder and the emulating computer.  The firmware writes the address of its
// mailbox to GPIOR1 (low) and GPIOR2 (high) once, and these to GPIOR0.
#ifndef AVR_MAILBOX_H
#define AVR_MAILBOX_H

#include <stdint.h>

enum { AVR_READY = 3, AVR_BEGIN = 1, AVR_END = 2 };    // READY: the computer may look into the mailbox and change it

// soft.c: one operation.
typedef struct Mailbox {
    uint64_t a, b, result;
    uint8_t op;
} Mailbox;

// vm.c: an image at a place in flash that the computer fills, a state vector and memory in RAM.
enum { VM_VERIFY, VM_INIT, VM_STEP, VM_STORE, VM_LOAD };
typedef struct VmBox {
    uint64_t x, cell;         // VM_STORE: x goes to the cell, as what `type` keeps of it; VM_LOAD: it comes from there
    uint16_t image, image_size, sv, sv_size, memory, memory_size, free;      // addresses and sizes; an image from 0x8000 on is in EEPROM; free: the first byte after static data
    uint16_t local, state;    // of the machine after VM_INIT and VM_STEP: where its locals are behind `memory`, the next state
    uint8_t what;             // in: one of these
    int8_t result;            // out: as of smvm_verify, smvm_init, smvm_step
    uint16_t begins;          // in: the state to begin at
    uint8_t type;             // in, of VM_STORE and VM_LOAD
    uint8_t cells;            // out: there are these two
    uint8_t stored[8];        // bits of the first 64 outputs
} VmBox;

// pins.c: an image with its pins, in EEPROM.
enum { PINS_VERIFY, PINS_OPEN, PINS_STEP, PINS_STOP };
typedef struct PinsBox {
    uint64_t g;               // in
    uint16_t image, memory, memory_size, free;
    uint8_t what;             // in: one of these
    int8_t result;            // out
} PinsBox;

// psl.c: a timer of PSL_SLEEP ms, whose cycles are counted.  Then the checks that held and did not, and the line of the first that did not.
enum { PSL_SLEEP = 50 };
typedef struct PslBox { uint16_t passed, failed, line; } PslBox;

// auth.c: whether an image in flash is signed with a key.
typedef struct AuthBox {
    uint32_t number;          // out
    uint16_t image, image_size;
    uint8_t is_right;         // out
    uint8_t key[16];          // in
} AuthBox;

// roll.c: a sample into the window, or a statistic of it.
enum { ROLL_SAMPLE = 255 };
typedef struct RollBox {
    uint64_t x;               // in: the sample; out: the statistic
    uint32_t n, kind;
    uint16_t window, window_size;      // where it is, in bytes
    uint8_t what;             // in: ROLL_SAMPLE, or which statistic
} RollBox;

// tank_bench.c: two machines on a state vector each, which the computer writes.
enum { TANK_EMITTED, TANK_HAND };
typedef struct TankBox {
    uint16_t sv, sv_size;
    uint8_t what;             // in: which of them
    uint8_t begins;           // in: both begin at this state first, or 0
    uint8_t result;           // out: whether it ran
} TankBox;

#ifdef __AVR__
#include <avr/io.h>

// What is in memory there is so for what follows.
#define BARRIER __asm__ volatile("" ::: "memory")

// What a firmware does: `act` at the computer's word, whose cycles are counted, then `tell`.
static inline __attribute__((always_inline, noreturn)) void mailbox_serve(void *box, void (*act)(void), void (*tell)(void))
{
    GPIOR1 = (uint8_t)(uint16_t)box;
    GPIOR2 = (uint8_t)((uint16_t)box >> 8);
    for (;;) {
        GPIOR0 = AVR_READY;
        BARRIER;
        GPIOR0 = AVR_BEGIN;
        BARRIER;
        act();
        BARRIER;
        GPIOR0 = AVR_END;
        if (tell != 0)
            tell();
        BARRIER;
    }
}
#endif

#endif
