// SPDX-License-Identifier: Apache-2.0
// A simulated board: store, agent and events, with a memory of psl/sim whose content survives restarts.
#ifndef TESTS_STORE_BOARD_H
#define TESTS_STORE_BOARD_H

#include <string.h>

#include "bytecode-vm/permit.h"
#include "bytecode-vm/target/agent.h"
#include "tests/store/image.h"

enum { BOARD_BODY = 37, BOARD_EVENTS = 16 };       // an odd size, which is no multiple of the memory's unit of writing

typedef struct Board {
    const char *memory;
    uint8_t slots;
    Store store;
    Agent agent;
    AgentBoard board;
    uint8_t frame[LINK_ROOM(BOARD_BODY)];
    uint8_t slot;             // the slot of the running image
    SmResult may, fits;
    bool (*is_authentic)(SmvmBytes image, uint32_t *number);      // checks the authentication code; NULL: the board has no key
    const uint8_t *key;       // the key with which permits are checked; NULL: none are required
    SmResult permitted;       // the result of the last check of a permit
    uint32_t mark;
    unsigned left;            // how often the agent has made it leave its slot
    bool up;                  // it has power, and answers requests
    SmEvent storage[BOARD_EVENTS];
    SmEvents events;
} Board;

static SmResult board_may(void *context) { return ((Board *)context)->may; }

static SmResult board_fits(void *context, SmvmBytes image)
{
    (void)image;
    return ((Board *)context)->fits;
}

static SmResult board_leave(void *context, const uint8_t *begin, uint8_t n)
{
    Board *b = context;

    if (b->key && (b->permitted = smvm_permit_check(begin, n, sm_link_load(b->store.choice.newest, 4), b->key)) != SM_OK)
        return b->permitted;
    b->slot = STORE_BUILT_IN;
    b->left++;
    return SM_OK;
}

// The board has pins 1 to 3, with the numbers 1 to 3.
static uint8_t board_pin(uint16_t number, uint8_t kind)
{
    return kind == 2 && number >= 1 && number <= 3 ? (uint8_t)number : SMVM_NO_PIN;
}

static bool board_opens(Board *b)
{
    if (!image_store(&b->store, b->memory, b->slots))
        return false;
    b->store.is_authentic = b->is_authentic;
    return true;
}

// Switches the power on: the content of RAM is lost.
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
        b->board.machines = 3;
        b->board.abilities = LINK_WINDOWS | LINK_PARAMETERS;
        b->board.functions = 0x70001;
        b->board.ram_digital = 10;
        b->board.ram_analog = 26;
        b->board.period = 300;
        b->board.cycles = 14400;
        b->board.physical_pin = board_pin;
        b->board.mark = b->mark;
        smvm_agent_init(&b->agent, &b->store, &b->board, &b->events, b->frame, BOARD_BODY);
    }
    return b->up;
}

// Resets to a new board with an empty memory.
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

// Returns the length of the answer in b->frame; 0: none.  If the memory cannot be read, its power is off, and the board does not answer.
static uint16_t board_takes(Board *b, uint8_t byte)
{
    const uint16_t n = b->up ? smvm_agent_receive(&b->agent, byte) : 0;
    uint8_t probe;

    if (n > 0)
        b->up = pal_nvm_read(b->store.nvm, 0, &probe, 1) == SM_OK;
    return b->up ? n : 0;
}

#endif
