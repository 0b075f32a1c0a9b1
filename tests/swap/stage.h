// SPDX-License-Identifier: Apache-2.0
// An application with two machines that can be swapped, for the tests of runtime-c/swap.h.  The test calls its ticks and its preparations.
#ifndef SM_SWAP_STAGE_H
#define SM_SWAP_STAGE_H

#include "bytecode-vm/target/swap_link.h"
#include "bytecode-vm/target/swap_store.h"
#include "tests/swap/machine.h"

// The source of the state vector, and the offsets of its elements.
#define STAGE_SV "[Stage]\nU64 time\nU32 sa\nU32 sb\nF64 p\nF64 out\nF64 more\nbool armed\n"
enum { AT_TIME = 0, AT_SA = 8, AT_SB = 12, AT_P = 16, AT_OUT = 24, AT_MORE = 32, AT_ARMED = 40, STAGE_SIZE = 48 };

// The first lines of the source of machine "a", and of machine "b".
#define A "[state_vector]\nU64 time @alias G\nU32 sa @alias S\nF64 p\nF64 out\n"
#define B "[state_vector]\nU64 time @alias G\nU32 sb @alias S\nF64 p\nF64 more\n"

enum { STAGE_ROOM = 16384, STAGE_EVENTS = 64, STAGE_WORKERS = 5 };

typedef struct Stage {
    SmSwaps swaps;
    SmvmSlot slot[2][2];      // by machine and slot
    SmSwappable machine[2];
    SmSwapGate gate[2];
    SmExecutor executor[2];
    uint32_t calls[STAGE_WORKERS];        // by task that is not a machine: number of its calls
    SmEvents events;
    SmApp app;
    SmSwapLink link;          // set up by stage_reach
    SmSwapStore store;        // set up by stage_store
} Stage;

extern Stage stage;

typedef struct StagePlan {
    const SwapMachine *a, *b; // b may be NULL
    uint32_t room;            // bytes of each slot, at most STAGE_ROOM
    uint32_t trial;           // length of the trial in ticks; 0: 100
    uint32_t longest;
    bool two_executors;       // b runs in a second executor
    bool guarded, decoded;
    uint64_t period[2];       // of each executor, in nanoseconds; 0: 1 ms
    void (*act)(const SmTick *tick);      // called once per tick in the first executor, after the machines; NULL: none
} StagePlan;

// Sets up the application, with nothing running, and initialises its tasks.
void stage_begin(const StagePlan *plan);
// Like stage_begin, without initialising the tasks, for sm_app_run.
void stage_set_up(const StagePlan *plan);

// Sets up stage.link, with room for a swap of both machines.  `key_file`: the file of the key, whose numbers are stored in "eeprom"; NULL: no
// key.  Opens nothing.
void stage_reach(SmSwapPlace place, const char *name, const char *key_file);

// Sets up stage.store for images of up to `image` bytes.  `key` may be NULL.  Opens nothing.
void stage_store(const char *name, uint32_t image, const uint8_t *key);

// Called after stage_set_up: loads stored images, and initialises the tasks.  Returns the result of sm_swaps_restore.
SmResult stage_start(void);

void stage_tick(unsigned executor);       // runs the next tick of an executor
// Runs ticks of the first executor, with a part of the preparation between two ticks, until the swap is neither PREPARING nor WAITING.
void stage_settle(void);

SmSwapStatus stage_status(void);
SmSwapPhase stage_phase(void);
double stage_number(uint32_t at);         // returns the value of the element at this offset
uint32_t stage_u32(uint32_t at);
void stage_set_number(uint32_t at, double value);
void stage_arm(bool armed);

// Begins a swap of machine "a" (or "b") by an image.
SmResult stage_swap(const char *name, const SwapMachine *to, SmSwapMode mode, const char *state);

// Returns the number of events of a kind since stage_begin; *last receives the last one.
unsigned stage_events(SmEventKind kind, SmEvent *last);
uint32_t stage_identity(const SwapMachine *m);

#endif
