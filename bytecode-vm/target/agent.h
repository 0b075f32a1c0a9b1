// SPDX-License-Identifier: Apache-2.0
// The device's end of the link (docs/link.md): takes bytes, answers requests, updates the store.
//
//     if (pal_serial_receive(line, &byte, 1, &n, 0) == SM_OK && (length = smvm_agent_receive(&agent, byte)) > 0)
//         pal_serial_send(line, agent.frame, length, &sent, …);
//     if (agent.restart)
//         …start anew, once the answer is out…
//
// Every request may come twice.  What is armed, or in a state that is not @safe, is not touched: the board decides, with
// `may_update`.
#ifndef SMVM_AGENT_H
#define SMVM_AGENT_H

#include "bytecode-vm/target/store.h"
#include "runtime-c/event.h"
#include "runtime-c/link/link.h"

#ifdef __cplusplus
extern "C" {
#endif

// What the firmware knows and does.
typedef struct AgentBoard {
    void *context;
    uint32_t ram;             // bytes that machines may need
    uint32_t longest_step;    // instructions that a step may take; 0: nobody minds
    uint8_t machines;         // how many an image may have; 0: any number
    bool windows;             // whether they may have any
    uint8_t ram_digital, ram_analog;      // what a pin takes of `ram`
    uint16_t period;          // milliseconds between steps of an image that came without
    uint16_t cycles;          // of an ATmega that a step may take for each millisecond of its period; 0: nobody minds
    uint32_t mark;            // of its key (smvm_auth_mark), where it has one
    SmvmPinPlace *pin_place;  // NULL: it has no pins, or does not say
    SmResult (*may_update)(void *context);                        // SM_OK, SM_E_ARMED, SM_E_UNSAFE
    // Whether this board can run it: RAM, pins, state vector.  SM_E_MEMORY, SM_E_MISSING, SM_E_LAYOUT.
    SmResult (*fits)(void *context, SmvmBytes image);
    void (*leave_slot)(void *context);                            // from now on the built-in image runs (boards with one slot)
    SmvmBytes built_in;
    uint32_t built_in_size;   // 0: there is none
} AgentBoard;

typedef struct Agent {
    Store *store;
    const AgentBoard *board;
    SmEvents *events;         // or NULL
    uint8_t *frame;           // LINK_ROOM(body) bytes: what arrives, and then the answer
    uint8_t body, block;      // the largest body it takes; the bytes of DATA that it likes
    LinkReceiver in;
    uint8_t n, length;        // of the body of the request at hand, and of its answer behind the result
    bool restart;             // somebody asked for it
} Agent;

// `body` is 28 (an event; 32 with a key) to LINK_BODY_MAX; block: body less the head of DATA, rounded down to what the memory writes.
void smvm_agent_init(Agent *a, Store *store, const AgentBoard *board, SmEvents *events, uint8_t *frame, uint8_t body);

// Takes a byte; gives the length of the answer in a->frame, 0 if there is none to send.  Sent it must be before the next byte is
// taken.
uint16_t smvm_agent_receive(Agent *a, uint8_t byte);

#ifdef __cplusplus
}
#endif
#endif
