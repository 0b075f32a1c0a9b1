// SPDX-License-Identifier: Apache-2.0
// The flight log: a file that contains the whole state vector and all events over time, and a description of its own format
// (docs/log.md; `smc log` reads it).  A task's step packs a record into a ring in memory.  A thread without a deadline writes the
// ring to the medium; without threads the executor does.  If the medium is too slow, records are dropped, and the log reports how
// many.  A step never waits.
//
// Step and drain may run in two threads.  Each accesses only its own part of the ring.  A lock protects only the few positions
// that separate the parts.  A platform without locks has no threads either, and then no lock is taken.
#ifndef SM_LOG_H
#define SM_LOG_H

#include "runtime-c/machine.h"
#include "runtime-c/pal/log.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct SmLog {
    const char *file;         // name of the file, for pal_log_open
    SmStateVec *sv;
    const SmNames *names;     // names of the elements and regions of sv
    SmEvents *events;         // events to log; or NULL
    const SmMachine *const *machine;      // machines whose state names the log describes
    uint16_t machines;
    uint8_t *buffer;          // the ring: `room` bytes, at least SM_LOG_LEAST(packed size of the vector)
    uint32_t room;
    const char *const *task;  // names of the tasks by number, for the readers of events; or NULL
    uint16_t tasks;
    const char *const *executor;          // names of the executors by number; or NULL
    uint16_t executors;
    // The fields below belong to the runtime; initially all zero.
    PalLogFile out;
    PalLock lock;             // protects head, end and tail
    uint32_t head, end;       // set by sm_log_step: position of the next block; end of the last block before the ring wrapped around
    uint32_t tail, checksummed;    // set by sm_log_drain: start of the bytes that are not written yet; end of the blocks that have their checksum
    uint32_t cursor;          // the log's cursor in the event ring
    uint32_t dropped, lost;   // totals: records dropped for lack of space, events overwritten before the step read them
    uint32_t dropped_reported, lost_reported;  // parts of these totals that the log already reports
    uint64_t start;           // size of the file in bytes before this session
    uint64_t written;         // size of the file now
    uint64_t described_at;    // value of `written` when the last description began
    uint32_t description_done, description_size;  // bytes of the description that are written; its total size.  Both 0: not begun
    uint64_t synced_at;       // PAL clock time of the last sync
    bool unsynced;
    SmResult result;          // result of the last access to the medium
} SmLog;

// Sizes in bytes: the overhead of a block; a record; the smallest ring, in which one record fits wherever the free space begins.
#define SM_LOG_BLOCK 10u
#define SM_LOG_RECORD(packed) (SM_LOG_BLOCK + 8u + (packed))
#define SM_LOG_LEAST(packed) (2u * SM_LOG_RECORD(packed) + 192u)

// Opens the file.  This and the step are compatible with SmTaskInit and SmTaskStep; the context is an SmLog.
// SM_E_MEMORY: the ring is smaller than SM_LOG_LEAST.  SM_E_FOREIGN: the file has content that is not a log; it is left unchanged.
// Other results as for pal_log_open.
SmResult sm_log_init(void *log);

// Copies the events since the last step and the state vector into the ring.  SM_E_FULL: there was no space for the record.
SmResult sm_log_step(void *log, const SmTick *tick);

// Writes the ring to the medium in pieces of up to SM_LOG_PIECE bytes, until it is empty or `budget` nanoseconds have passed; at
// least one piece.  Every SM_LOG_SYNC nanoseconds it also waits for the medium.  Call it from one thread only; any thread will do.
// Returns true if data remains.  Returns false also if the medium fails: the data stays in the ring, and the next call retries.
// The first call begins with the description, so call it only after all machines are initialised.
bool sm_log_drain(SmLog *log, uint64_t budget);

// Writes the whole ring, waits for the medium and closes the file.  Call it when no step runs any more.  The result is that of the
// medium.
SmResult sm_log_close(SmLog *log);

#ifdef __cplusplus
}
#endif
#endif
