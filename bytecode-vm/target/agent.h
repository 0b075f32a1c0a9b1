// SPDX-License-Identifier: Apache-2.0
// The device's side of the link protocol (docs/link.md): receives bytes, answers requests, updates the store.
//
//     if (pal_serial_receive(line, &byte, 1, &n, 0) == SM_OK && (length = smvm_agent_receive(&agent, byte)) > 0)
//         pal_serial_send(line, agent.frame, length, &sent, …);
//     if (agent.restart)
//         …restart after the answer has been sent…
//
// A host may repeat every request.  The agent changes nothing while the board is armed or in a state that is not @safe; the board decides
// this in `may_update`.
#ifndef SMVM_AGENT_H
#define SMVM_AGENT_H

#include "bytecode-vm/target/store.h"
#include "runtime-c/event.h"
#include "runtime-c/link/link.h"

#ifdef __cplusplus
extern "C" {
#endif

// The properties of the board, and functions that the agent calls on it.
typedef struct AgentBoard {
    void *context;
    uint32_t ram;             // bytes available to machines
    uint32_t longest_step;    // limit on the instructions of a step; 0: none
    uint8_t machines;         // the most machines that an image may have, up to 63; 0: any number
    uint8_t abilities;        // what machines may have: LINK_WINDOWS, LINK_PARAMETERS (runtime-c/link/link.h)
    uint32_t functions;       // the elementary functions that machines can call (SMVM_FUNCTIONS)
    uint8_t ram_digital, ram_analog;      // bytes of `ram` that each digital pin takes, and each analog pin
    uint16_t period;          // milliseconds between steps of an image that was sent without a period
    uint16_t cycles;          // limit on the cycles of a step on an ATmega, for each millisecond of its period; 0: none
    uint32_t mark;            // identifies the board's key (smvm_auth_mark), if it has one
    SmvmPhysicalPin *physical_pin;  // NULL: the board has no pins, or cannot report the pins of its chip
    // Whether an update may begin now.  SM_E_ARMED: the board is armed.  SM_E_UNSAFE: a machine is in a state that is not @safe.
    SmResult (*may_update)(void *context);
    // Whether this board can run the image.  SM_E_MEMORY: too little RAM.  SM_E_MISSING: it uses a pin that the board lacks.  SM_E_LAYOUT: its
    // machines and pins belong to different state vectors.
    SmResult (*fits)(void *context, SmvmBytes image);
    // For boards with one slot: called when a BEGIN with this body of n bytes arrives, to run the built-in image from now on.  Any other result
    // than SM_OK refuses the BEGIN, and the image in the slot must continue to run (bytecode-vm/permit.h).
    SmResult (*leave_slot)(void *context, const uint8_t *begin, uint8_t n);
    SmvmBytes built_in;
    uint32_t built_in_size;   // bytes; 0: there is no built-in image
} AgentBoard;

typedef struct Agent {
    Store *store;
    const AgentBoard *board;
    SmEvents *events;         // the board's events, for hosts that request them; or NULL
    uint8_t *frame;           // buffer of LINK_ROOM(body) bytes: first the request, then its answer
    uint8_t body;             // the largest body of a request or an answer
    uint8_t block;            // the number of payload bytes that a host should send in each DATA: the most that fit, in whole write units
    LinkReceiver in;            // assembles received bytes to frames
    uint8_t n;                // bytes of the body of the current request
    uint8_t length;           // bytes of the body of the answer, without the result
    bool restart;             // a host asked for a restart: the caller restarts the board after it has sent the answer
} Agent;

// Initialises *a.  `body` is at least 28, for an answer with one event (32 on a board with a key), and at most LINK_BODY_MAX.  Sets a->block to
// the payload of DATA that fits into a body, rounded down to the write unit.
void smvm_agent_init(Agent *a, Store *store, const AgentBoard *board, SmEvents *events, uint8_t *frame, uint8_t body);

// Processes a received byte.  Returns the length of the answer in a->frame, or 0 if no answer is to be sent.  The caller must send the answer
// before it passes the next byte.
uint16_t smvm_agent_receive(Agent *a, uint8_t byte);

#ifdef __cplusplus
}
#endif
#endif
