// SPDX-License-Identifier: Apache-2.0
// The communication between a firmware of this folder and the emulating computer.  The firmware writes the address of its mailbox once to GPIOR1
// (low byte) and GPIOR2 (high byte), and these values to GPIOR0.
#ifndef AVR_MAILBOX_H
#define AVR_MAILBOX_H

#include <stdint.h>

enum { AVR_READY = 3, AVR_BEGIN = 1, AVR_END = 2 };    // READY: the computer can read and change the mailbox

// soft.c: one operation.
typedef struct Mailbox {
    uint64_t a, b, result;
    uint8_t op;
} Mailbox;

// vm.c: an image in flash, at an address to which the computer writes it; a state vector and memory in RAM.
enum { VM_VERIFY, VM_INIT, VM_STEP, VM_STORE, VM_LOAD };
typedef struct VmBox {
    uint64_t x, cell;         // VM_STORE: x is stored in `cell` as a `type`; VM_LOAD: x is loaded from `cell`
    uint16_t image, image_size, sv, sv_size, memory, memory_size, free;      // addresses and sizes; an image from 0x8000 on is in EEPROM; free: the first byte after static data
    uint16_t local, state;    // after VM_INIT and VM_STEP: offset of the machine's locals in `memory`; the next state
    uint8_t what;             // in: one of these
    int8_t result;            // out: as of smvm_verify, smvm_init, smvm_step
    uint16_t begins;          // in: the state in which the machine starts
    uint8_t type;             // in, of VM_STORE and VM_LOAD
    uint8_t cells;            // out: the firmware has VM_STORE and VM_LOAD
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

// psl.c: a timer of PSL_SLEEP ms, whose cycles are counted.  Then the number of checks that were true and false, and the line of the first false
// one.
enum { PSL_SLEEP = 50 };
typedef struct PslBox { uint16_t passed, failed, line; } PslBox;

// auth.c: whether an image in flash is signed with a key.
typedef struct AuthBox {
    uint32_t number;          // out
    uint16_t image, image_size;
    uint8_t is_right;         // out: the code is valid
    uint8_t key[16];          // in
} AuthBox;

// roll.c: a sample into the window, or a statistic of it.
enum { ROLL_SAMPLE = 255 };
typedef struct RollBox {
    uint64_t x;               // in: the sample; out: the statistic
    uint32_t n, kind;
    uint16_t window, window_size;      // address and size of the window in bytes
    uint8_t what;             // in: ROLL_SAMPLE, or which statistic
} RollBox;

// tank_bench.c: two machines, each on its own state vector, which the computer writes.
enum { TANK_EMITTED, TANK_HAND };
typedef struct TankBox {
    uint16_t sv, sv_size;
    uint8_t what;             // in: which of them
    uint8_t begins;           // in: the state in which both machines start first; 0: they do not start
    uint8_t result;           // out: whether the step was executed
} TankBox;

#ifdef __AVR__
#include <avr/io.h>

// The compiler must not move accesses to memory across this.
#define BARRIER __asm__ volatile("" ::: "memory")

// The main loop of a firmware: executes `act` when the computer requests it and counts its cycles, then calls `tell`.
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
