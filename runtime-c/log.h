// SPDX-License-Identifier: Apache-2.0
// The flight log: the whole state vector and all events, again and again, in a file that tells by itself what is in it (docs/log.md;
// `smc log` reads it).  A task's step packs a record into a buffer in memory; a thread without a deadline (or the executor, where
// there is none) brings it to the medium.  When the medium is too slow, records are dropped and counted, in the log as well: a step never waits.
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
    SmEvents *events;
    const SmMachine *const *machine;      // whose names of states the log tells
    uint16_t machines;
    uint8_t *buffer;          // a ring of `room` bytes, a power of two
    uint32_t room;
    // What follows is the runtime's; all zero at first.
    PalLogFile out;
    uint32_t cursor;          // of events
    uint32_t head, tail;      // written and drained so far, modulo 2^32
    uint32_t dropped;         // records
} SmLog;

SmResult sm_log_init(void *log);
SmResult sm_log_step(void *log, const SmTick *tick);
// Brings to the medium what is in the buffer, for at most `budget` nanoseconds; from one thread only, any.  True: something is left.
bool sm_log_drain(SmLog *log, uint64_t budget);

#ifdef __cplusplus
}
#endif
#endif
