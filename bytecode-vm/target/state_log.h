// SPDX-License-Identifier: Apache-2.0
// Stores transitions in non-volatile memory, where they survive a restart.  The log is a ring of records (runtime-c/link/transition.h) in the
// part of a slot that its image does not use.  An image that needs the whole slot leaves no room for a log.
//
//     smvm_state_log_open(&log, image, size of its slot);
//     if (smvm_state_log_is_idle(&log) && sm_events_read(&events, &cursor, &e, 1, &lost) == 1)
//         smvm_state_log_add(&log, &e, lost);
//     if (smvm_state_log_next(&log, &at, &byte) && …the memory has begun to write the byte at this offset…)
//         smvm_state_log_advance(&log);
//
// The caller writes byte by byte, when the memory is ready and no step has to wait for it.  A record that is not complete is ignored.
//
// Wear: a full ring overwrites its oldest record, so each byte is written once per `records` transitions.  A start stores at most
// STATE_LOG_CREDIT transitions at once, and one more per call of smvm_state_log_add_credit.
#ifndef SMVM_STATE_LOG_H
#define SMVM_STATE_LOG_H

#include "bytecode-vm/smvm.h"
#include "runtime-c/event.h"
#include "runtime-c/link/transition.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { STATE_LOG_CREDIT = 64, STATE_LOG_LEAST = 8 };   // STATE_LOG_LEAST: a memory with room for fewer records stores nothing

typedef struct StateLog {
    SmvmBytes image;            // the image whose transitions are recorded
    uint8_t records;          // how many records fit; 0: none is stored
    uint8_t next;             // index in the ring of the record that is written next
    uint8_t number;           // sequence number of that record
    uint8_t credit;           // how many more records may be written now, to limit wear
    uint8_t lost;             // transitions that were not stored since the last record
    uint8_t written;          // bytes of `record` that the memory has; LINK_TRANSITION: all, so that the log is idle
    uint8_t record[LINK_TRANSITION];        // the record that is being written
} StateLog;

// Opens the log of an image in a slot of this size, after the newest record that it contains.
void smvm_state_log_open(StateLog *l, SmvmBytes image, SmvmAt slot_size);

static inline bool smvm_state_log_is_idle(const StateLog *l) { return l->written == LINK_TRANSITION; }

// Begins a record, if the event is a transition.  `lost`: number of events lost before `e`.  The log must be idle.
void smvm_state_log_add(StateLog *l, const SmEvent *e, uint32_t lost);

// Stores the next byte to write in *byte, and its offset from the start of the image in *at.  Returns false if the log is idle.
bool smvm_state_log_next(const StateLog *l, SmvmAt *at, uint8_t *byte);
void smvm_state_log_advance(StateLog *l);

void smvm_state_log_add_credit(StateLog *l);                 // one more transition may be stored; at most STATE_LOG_CREDIT

#ifdef __cplusplus
}
#endif
#endif
