// SPDX-License-Identifier: Apache-2.0
// The flight log: the whole state vector and all events, again and again, in a file that tells by itself what is in it (docs/log.md;
// `smc log` reads it).  A task's step packs a record into a ring in memory; a thread without a deadline (or the executor, where
// there is none) brings it to the medium.  When the medium is too slow, records are dropped and counted, in the log as well: a step never waits.
//
// Step and drain may be in two threads: each touches its own part of the ring, and a lock is held around the few numbers alone that say where
// one part ends and the other begins.  Where the platform has no locks it has no threads either, and none is taken.
#ifndef SM_LOG_H
#define SM_LOG_H

#include "runtime-c/machine.h"
#include "runtime-c/pal/log.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct SmLog {
    const char *file;         // a name as pal/log.h takes it
    SmStateVec *sv;
    const SmNames *names;     // of sv
    SmEvents *events;         // or NULL
    const SmMachine *const *machine;      // whose names of states the log tells
    uint16_t machines;
    uint8_t *buffer;          // the ring: `room` bytes, SM_LOG_LEAST(packed size of the vector) or more
    uint32_t room;
    const char *const *task;  // names of the tasks by their numbers, for readers of events; or NULL
    uint16_t tasks;
    const char *const *executor;          // likewise of the executors
    uint16_t executors;
    // What follows is the runtime's; all zero at first.
    PalLogFile out;
    PalLock lock;             // around head, end and tail
    uint32_t head, end;       // the step's: where the next block begins; where the last one ended before the ring began anew
    uint32_t tail, closed;    // the drain's: what is not on its way yet; up to where checksums are filled in
    uint32_t cursor;          // of events
    uint32_t dropped, lost;   // records that found no room, events that nobody read in time; in all
    uint32_t dropped_told, lost_told;     // of these, what the log has told
    uint64_t start;           // bytes that the file held before this session
    uint64_t written;         // bytes that it holds now
    uint64_t described;       // `written` when the description was last begun
    uint32_t describing, description;     // bytes of it that are written, and that there are; 0 and 0: not begun
    uint64_t synced_at;       // on the PAL clock
    bool unsynced;
    SmResult result;          // of the medium, the last time
} SmLog;

// Bytes around what a block holds; a record; the smallest ring: whatever lies at its end or front, one record finds room.
#define SM_LOG_BLOCK 10u
#define SM_LOG_RECORD(packed) (SM_LOG_BLOCK + 8u + (packed))
#define SM_LOG_LEAST(packed) (2u * SM_LOG_RECORD(packed) + 192u)

// Opens the file.  As SmTaskInit and SmTaskStep; the context is an SmLog.
// SM_E_MEMORY: the ring is smaller than SM_LOG_LEAST.  SM_E_FOREIGN: the file holds something that is no log; it stays as it is.
// Otherwise as pal_log_open.
SmResult sm_log_init(void *log);

// Puts the events since the last step and the state vector into the ring.  SM_E_FULL: there was no room for the record.
SmResult sm_log_step(void *log, const SmTick *tick);

// Brings to the medium what is in the ring, in pieces of up to SM_LOG_PIECE bytes, until nothing is left or `budget` nanoseconds are over;
// one piece at least.  Every SM_LOG_SYNC nanoseconds it also waits for the medium.  From one thread only, any.  True: something is left.
// False as well when the medium refuses: it stays in the ring, the next call tries again.
// The first call begins with the description, and should come when all machines have been initialised.
bool sm_log_drain(SmLog *log, uint64_t budget);

// Drains all, waits for the medium, closes the file.  When no step runs any more.  The result is that of the medium.
SmResult sm_log_close(SmLog *log);

#ifdef __cplusplus
}
#endif
#endif
