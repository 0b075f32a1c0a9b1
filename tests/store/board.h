// SPDX-License-Identifier: Apache-2.0
// A board in the simulation: store, agent and events over a memory of psl/sim, which outlives restarts.
#ifndef TESTS_STORE_BOARD_H
#define TESTS_STORE_BOARD_H

#include <string.h>

#include "bytecode-vm/target/agent.h"
#include "runtime-c/psl/sim/sim.h"

enum { BOARD_BODY = 37, BOARD_EVENTS = 16 };       // an odd body: no multiple of what a memory writes

typedef struct Board {
    const char *memory;
    uint8_t slots;
    Store store;
    Agent agent;
    AgentBoard board;
    uint8_t frame[LINK_ROOM(BOARD_BODY)];
    uint8_t slot;             // what runs
    SmResult may, fits;
    bool (*is_authentic)(SmvmBytes image, uint32_t *number);      // its key; NULL: none
    unsigned left;            // how often it had to leave its slot
    bool up;                  // it has power, and answers
    SmEvent storage[BOARD_EVENTS];
    SmEvents events;
} Board;

static SmResult board_may(void *context) { return ((Board *)context)->may; }

static SmResult board_fits(void *context, SmvmBytes image)
{
    (void)image;
    return ((Board *)context)->fits;
}

static void board_leave(void *context)
{
    Board *b = context;

    b->slot = STORE_BUILT_IN;
    b->left++;
}

static bool board_opens(Board *b)
{
    StorePlan plan = {SIM_NVM_SIZE, b->slots, {NULL, NULL}};
    PalNvm nvm;
    PalNvmInfo info;
    uint32_t unit, record;

    if (pal_nvm_open(&nvm, b->memory, SIM_NVM_SIZE) != SM_OK || pal_nvm_info(nvm, &info) != SM_OK)
        return false;
    unit = info.erase ? info.erase : info.write;
    record = (STORE_RECORD + unit - 1) / unit * unit;
    plan.image[0] = sim_nvm(b->memory) + 2 * record;
    plan.image[1] = plan.image[0] + (SIM_NVM_SIZE - 2 * record) / b->slots / unit * unit;
    if (smvm_store_open(&b->store, nvm, &plan) != SM_OK)
        return false;
    b->store.is_authentic = b->is_authentic;
    return true;
}

// Power on: what is in RAM is forgotten.
static bool board_start(Board *b)
{
    sim_power_on();
    b->up = board_opens(b) && smvm_store_boot(&b->store, &b->slot) == SM_OK;
    if (b->up) {
        memset(&b->board, 0, sizeof b->board);
        b->board.context = b;
        b->board.may_update = board_may;
        b->board.fits = board_fits;
        b->board.leave_slot = board_leave;
        b->board.ram = 1000;
        smvm_agent_init(&b->agent, &b->store, &b->board, &b->events, b->frame, BOARD_BODY);
    }
    return b->up;
}

// A new board with an empty memory.
static bool board_new(Board *b, const char *memory, uint8_t slots)
{
    memset(b, 0, sizeof *b);
    b->memory = memory;
    b->slots = slots;
    b->events.at = b->storage;
    b->events.room = BOARD_EVENTS;
    sim_reset();
    return sm_events_init(&b->events) == SM_OK && board_start(b);
}

// Gives the length of the answer in b->frame; 0: none.  A memory that cannot be read is one whose power went: nobody answers then.
static uint16_t board_takes(Board *b, uint8_t byte)
{
    const uint16_t n = b->up ? smvm_agent_receive(&b->agent, byte) : 0;
    uint8_t probe;

    if (n > 0)
        b->up = pal_nvm_read(b->store.nvm, 0, &probe, 1) == SM_OK;
    return b->up ? n : 0;
}

#endif
