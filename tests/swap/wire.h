// SPDX-License-Identifier: Apache-2.0
// A simulated line between the host of smc and an application (stage.h), which loses, repeats and cuts off what a test selects.  Every tick of
// the application must step the machine.
#ifndef SM_SWAP_WIRE_H
#define SM_SWAP_WIRE_H

#include "compiler/device/app_host.h"
#include "tests/swap/stage.h"

// Sources of machines "a" and "b" that add a number to their output in every step.
#define COUNT(by) A "[local]\nU32 n = 0\n[A] @swap\n.step\nn = n + " #by "\nout = n\n"
#define COUNT_B(by) B "[local]\nU32 n = 0\n[A] @swap\n.step\nn = n + " #by "\nmore = n\n"

// Their images: "a" adds 1 or 10, "b" adds 1 or 10.
extern SwapMachine one, ten, b_one, b_ten;
extern const char right_key[33], wrong_key[33];

typedef struct Wire {
    uint32_t sent;            // bytes that the host has sent
    uint32_t cut;             // the line is cut after this many bytes; UINT32_MAX: never
    uint32_t frames;          // frames that have arrived; each has one answer
    uint32_t lose, lose_answer, repeat;   // number of the frame to lose, of the answer to lose, of the frame to deliver twice; UINT32_MAX: none
    LinkReceiver in;
    uint8_t received[LINK_ROOM(LINK_BODY_MAX)];
    uint8_t answers[8 * LINK_ROOM(LINK_BODY_MAX)];
    size_t first, end;        // the answers that the host has not read yet: `answers` from first to end - 1
    uint32_t refuse;          // at this frame the application itself begins a swap that is refused; 0: never
    uint32_t ends_busy;       // how often END was answered with SM_E_BUSY
    uint32_t steps;           // ticks of the application
} Wire;

extern Wire wire;

// Runs the application for a tick, and a part of a preparation.
void run_application(void);
// Connects the host to a new line, without faults.
void connect_host(LinkHost *h);
// Starts an application with machine `one`, and perhaps a second one.  key_file: see stage_reach.
void begin_with(const SwapMachine *b, const char *key_file);
// Resets the simulation, connects the host, and starts an application with machine `one`.
void begin(LinkHost *h);
// Writes a swap of machine "a", and of "b" if it is not NULL.  key: signs it; NULL: it is not signed.
void make_swap(Buf *out, Arena *arena, const SwapMachine *a, const SwapMachine *b, uint8_t mode, const uint8_t *key, uint32_t number);
// Sends a swap to the application.  Returns the step of the transfer that failed, or APPLICATION_DONE.
ApplicationStep send_swap(LinkHost *h, const Buf *swap, const uint8_t *key, uint32_t number, uint16_t session);

// ---- link_keys.c ----

// Runs the tests of swaps with keys.
void test_keys(Arena *arena);

#endif
