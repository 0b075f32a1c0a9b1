// SPDX-License-Identifier: Apache-2.0
// Swaps: replaces machines of an application while it runs (docs/swapping.md 12.21 to 12.34).  One or several machines are exchanged
// between two ticks, all of them or none.  If a swap is refused or its preparation ends early, the old machines run on.
//
//     static const SmSwapChange change = {.machine = "tank", .image = image, .size = n, .mode = SM_SWAP_CONTINUE};
//     SmSwapStatus s;
//     if (sm_swap_begin(&stand_swaps, &change, 1) == SM_OK)
//         do sm_swap_status(&stand_swaps, &s); while (s.phase == SM_SWAP_PREPARING || s.phase == SM_SWAP_WAITING);      // in a thread that may wait
//     if (s.phase == SM_SWAP_TRIAL && …the machine does what it should…)
//         sm_swap_confirm(&stand_swaps);
//
// Phases of a swap:
//
//   sm_swap_begin ──▶ PREPARING ──▶ WAITING ──▶ TRIAL ──▶ CONFIRMED         by sm_swap_confirm
//                         │            │          └─────▶ RETURNED          the old machines run again
//                         └────────────┴────────────────▶ REFUSED           `reason` and `machine` say why
//
// PREPARING   The thread that writes the log, which has no deadline, copies the images, verifies and decodes them, and plans what is kept.
//             It uses no memory that a task uses.
// WAITING     At the end of a tick, if all executors of the concerned machines are between two ticks, the executor checks the remaining
//             conditions.  If all are met it exchanges all machines, which takes a pointer and a copy of what each machine keeps.
// TRIAL       The old machines are still in memory.  They return if a machine on trial has stepped `trial` times without a confirmation,
//             or has entered a state marked @abort.  With a storage, a confirmed swap is stored before the trial ends.
//
// The application has two slots of memory for each machine that can be swapped.  Nothing is allocated.  The machine in one slot runs, the
// other slot receives the next one.  smc generates all tables from a .app with @swap (docs/config.md 10.21).
#ifndef SM_SWAP_H
#define SM_SWAP_H

#include "runtime-c/app.h"
#include "runtime-c/swap_phases.h"

#ifdef __cplusplus
extern "C" {
#endif

// One machine of a swap.  What it points to must stay unchanged while the swap is PREPARING.
typedef struct SmSwapChange {
    const char *machine;      // name of the machine in the application
    const uint8_t *image;     // the new image (.smb), with one machine
    uint32_t size;            // bytes of `image`
    uint8_t mode;             // SmSwapMode; there is no default
    const char *state;        // to restart: the name of the first state; NULL: the first of the machine
    bool built_in;            // the image with which the application was built; `image` and `size` are not used
} SmSwapChange;

typedef struct SmSwapStatus {
    SmSwapPhase phase;
    SmSwapReason reason;      // REFUSED: why
    uint16_t machine;         // REFUSED: which machine, an index into SmSwaps.machine.  SM_SWAP_NO_MACHINE: an index into the changes
    SmSwapEnd end;            // CONFIRMED and RETURNED: how the trial ended
    uint32_t number;          // how many swaps have begun, modulo 2^32
    SmResult stored;          // TRIAL: the last result of storing a confirmed swap.  After a failure the trial continues
} SmSwapStatus;

// ---- the tables of an application ----

// What is specific to the kind of a machine: bytecode-vm/target/slot.h for images.  `slot`, `from` and `to` are memory for one machine each;
// `m` is the machine that runs in one of them.
typedef struct SmSwapType {
    // Reads the machine with which the application was built, in `slot`.
    void (*init)(void *slot, void *other);
    // Runs part `part` of the preparation of the machine in `to`, which does not run.  Called for parts 0 to parts - 1 in order.
    uint8_t parts;
    SmSwapReason (*prepare)(void *to, const void *from, const SmSwapChange *change, const SmMachine *m, uint8_t part);
    // Whether `to` may replace `from` now.
    SmSwapReason (*check)(const void *from, const void *to, uint8_t mode);
    // Replaces `from` by `to`.  Called inside a critical section of the state vector.  Cannot fail once `check` has succeeded.
    void (*exchange)(const void *from, void *to, uint8_t mode, const SmMachine *m);
    // Like `exchange`, to return to the old machine, which is in `to`.  Returns whether it continues; otherwise it restarts in its first @safe state.
    bool (*give_back)(const void *from, void *to, const SmMachine *m);
    // Whether the state that the next step runs is marked @abort.
    bool (*is_aborting)(const void *slot);
    // The checksum of the image; 0: the preparation has not yet accepted an image.
    uint32_t (*identity)(const void *slot);
    // Sets *range to output i of the machine; the last one is S.  Returns false if the machine has fewer outputs, or no accepted image.
    bool (*output)(const void *slot, uint32_t i, SmRange *range);
} SmSwapType;

// A machine that can be swapped.
typedef struct SmSwappable {
    SmMachine *machine;       // its `self` is slot[0] at the start
    const SmSwapType *type;
    void *slot[2];
    uint16_t executor;        // the index of its executor in SmSwaps.gate
    // The fields below belong to the runtime; initially all zero.
    uint8_t running;          // index of the slot that runs
    bool concerned;           // the current swap replaces this machine
    SmSwapChange change;
    uint32_t steps;           // number of steps since the exchange
    bool was_aborting;        // at the last check, its state was marked @abort
    uint32_t state;           // the state that its next step runs, as of the end of the last tick of its executor
    uint32_t built_in;        // checksum of the image with which the application was built
    uint32_t stored;          // checksum of its image in the storage; 0: none
    SmMachine logged;         // for SmLog.machine: has the names of the image that ran when the last preparation began
    const void *unnamed;      // the slot whose names are not in the log yet; or NULL
} SmSwappable;

// An executor that runs such machines, or any other one.
typedef struct SmSwapGate {
    struct SmSwaps *swaps;
    bool is_in_tick;          // the executor is inside a tick; only the runtime uses it
} SmSwapGate;

// Serves requests from outside the program (bytecode-vm/target/swap_link.h).  All functions are called by the thread that writes the log.
typedef struct SmSwapService {
    SmResult (*open)(struct SmSwapService *self, SmApp *app);    // before init of the tasks.  A failure prevents the start
    void (*serve)(struct SmSwapService *self, uint64_t budget);   // handles received requests, for at most `budget` nanoseconds
    void (*close)(struct SmSwapService *self);
} SmSwapService;

// Stores the images of confirmed swaps, so that they run again after a restart (bytecode-vm/target/swap_store.h).  The thread that writes the
// log calls all functions.
typedef struct SmSwapStorage {
    // Before init of the tasks: lets each machine with a stored image start with it.  A failure prevents the start.
    SmResult (*open)(struct SmSwapStorage *self, struct SmSwaps *s, SmApp *app);
    // Stores the images that run now, all of them or none.  SM_OK: they are stored permanently.  Any other result: the next start finds what
    // was stored before.
    SmResult (*save)(struct SmSwapStorage *self, struct SmSwaps *s);
    void (*close)(struct SmSwapStorage *self);
} SmSwapStorage;

// What a host can ask about a machine.
typedef struct SmSwapMachineState {
    uint32_t identity;        // checksum of its image
    uint32_t state;           // number of its state
    const void *slot;         // the slot that runs; its image stays valid until the next call of sm_swaps_prepare
    const void *newest;       // the slot that the last swap has prepared; NULL: the last swap does not concern the machine
    bool is_on_trial;
    bool is_built_in;         // its image is the one with which the application was built
    bool is_stored;           // its image is stored, and runs again after a restart
} SmSwapMachineState;

// `writing` is the first field, because SmApp.writing points to it.
typedef struct SmSwaps {
    SmWriting writing;        // SM_SWAP_WRITING
    const SmWriting *next;    // &sm_writing if the application has a log or saves its state vector; else NULL
    SmSwapService *service;   // serves requests from outside; or NULL
    SmSwapStorage *storage;   // stores confirmed images; NULL: after a restart, the machines with which the application was built run
    SmSwappable *machine;
    uint16_t machines;
    SmSwapGate *gate;         // by executor
    uint16_t gates;
    uint32_t trial;           // how many steps a machine is on trial: at least 1
    SmStateVec *sv;
    SmEvents *events;
    const SmElement *armed;   // a bool: while it is true, swaps are refused; NULL: never
    const SmRange *written;   // the elements that other code stores: other machines, inputs, messages, the runtime
    uint16_t writtens;
    // The fields below belong to the runtime; initially all zero.
    uint32_t is_open;         // shared.h: the lock is open
    PalLock lock;             // protects everything below, SmSwapGate.is_in_tick, and the fields of SmSwappable for the runtime
    SmSwapStatus status;
    bool refusal_due;         // the refusal is not yet in the events
    bool end_due;             // the confirmation is not yet in the events
    bool confirming;          // TRIAL: confirmed, and not yet stored.  The trial does not end meanwhile
    bool failure_due;         // the failure to store is not yet in the events
    uint16_t at;              // PREPARING: the machine that is being prepared
    uint8_t part;             // PREPARING: the next part of its preparation
    uint32_t tries;           // WAITING: how many ticks have ended in which an executor was inside another one
} SmSwaps;

#define SM_SWAP_WRITING {sm_swaps_restore, sm_swaps_write, sm_swaps_close}

// ---- swaps: can be called from any task or thread ----

// Begins a swap of n machines.
// SM_E_BUSY: another one is in progress, or ended in the current tick, or the application has not started.  SM_E_ARGUMENT: n is 0, or a pointer
// is NULL.  SM_E_TIMEOUT: a thread has ended inside a critical section, so no swap is possible any more.  Every other problem is in the status.
SmResult sm_swap_begin(SmSwaps *s, const SmSwapChange *change, uint16_t n);

// Reads the status of the last swap.  SM_E_BUSY: the application has not started.
SmResult sm_swap_status(SmSwaps *s, SmSwapStatus *status);

// Ends the trial: the new machines stay.  With a storage, the phase is CONFIRMED when they are stored; if that fails, the trial continues.
// SM_E_ARGUMENT: no machine is on trial.
SmResult sm_swap_confirm(SmSwaps *s);

// Reads what is known of a machine: an index into SmSwaps.machine.  Only for the thread that prepares.  SM_E_BUSY: the application has not
// started.  SM_E_MISSING: there is no such machine.
SmResult sm_swap_machine(SmSwaps *s, uint16_t machine, SmSwapMachineState *out);

// Returns the machine of this name; NULL if no machine that can be swapped has it.
SmSwappable *sm_swap_find_machine(const SmSwaps *s, const char *name);

// Returns the machine that was refused; NULL if no swap was, or if the application has no such machine.
const SmSwappable *sm_swap_refused_machine(const SmSwaps *s, const SmSwapStatus *status);

// Whether the machine in slot `to` would be a second writer of an element: another part of the application stores it, and the machine in slot
// `from` does not.
bool sm_swap_adds_writer(const SmSwaps *s, const SmSwappable *w, const void *from, const void *to);

// Returns the sentence of a reason; "" for an unknown one.
const char *sm_swap_reason_text(SmSwapReason reason);

// ---- called by the generated tables ----

// SmTaskInit and SmTaskStep of a machine that can be swapped; the context is an SmSwappable.
SmResult sm_swappable_init(void *swappable);
SmResult sm_swappable_step(void *swappable, const SmTick *tick);

// The first and the last task of each executor, in rate groups of their own that run at every tick; the context is an SmSwapGate.
SmResult sm_swap_gate_init(void *gate);
SmResult sm_swap_gate_enter(void *gate, const SmTick *tick);
SmResult sm_swap_gate_leave(void *gate, const SmTick *tick);

// The functions of SM_SWAP_WRITING.
SmResult sm_swaps_restore(struct SmApp *app);
void sm_swaps_write(struct SmApp *app, uint64_t budget);
void sm_swaps_close(struct SmApp *app, const SmTick *last);

// Runs the next part of a preparation.  Returns false if there was none.  Only one thread may call it.
bool sm_swaps_prepare(SmSwaps *s);

// Stores a swap that sm_swap_confirm has confirmed, if there is one, and ends its trial.  Returns the result of storing.  Only the thread
// that prepares may call it.
SmResult sm_swaps_save(SmSwaps *s);

#ifdef __cplusplus
}
#endif
#endif
