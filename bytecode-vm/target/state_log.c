// SPDX-License-Identifier: Apache-2.0
#include "bytecode-vm/target/state_log.h"

#include <string.h>

#include "bytecode-vm/image.h"

static SmvmAt length_of(const StateLog *l) { return smvm_read_offset(l->image, SMVM_LENGTH_AT, 3); }
static uint32_t checksum_of(const StateLog *l) { return smvm_uint(l->image, SMVM_CRC_AT, 4); }

// Returns the offset of a record from the start of the image.
static SmvmAt record_at(const StateLog *l, uint8_t index) { return (SmvmAt)(length_of(l) + (SmvmAt)index * LINK_TRANSITION); }

// Reads record `index` of the ring into *t. Returns false if the bytes there are no record of the image.
static bool load_record(const StateLog *l, uint8_t index, LinkTransition *t)
{
    SmvmAt at = record_at(l, index);
    uint8_t record[LINK_TRANSITION];

    for (uint8_t i = 0; i < LINK_TRANSITION; i++)
        record[i] = smvm_u8(l->image, at++);
    return sm_link_load_transition(record, checksum_of(l), t);
}

static uint8_t index_after(const StateLog *l, uint8_t index) { return (uint8_t)(index + 1u) == l->records ? 0 : (uint8_t)(index + 1u); }

// Sets l->next to the index after the latest record, and l->number to the sequence number after that record's.
static void find_latest_record(StateLog *l)
{
    bool found = false;
    LinkTransition t;

    for (uint8_t i = 0; i < l->records; i++)
        if (load_record(l, i, &t) && (!found || sm_link_is_later(t.number, (uint8_t)(l->number - 1u)))) {
            found = true;
            l->next = index_after(l, i);
            l->number = (uint8_t)(t.number + 1u);
        }
}

// Opens the log of an image in a slot of this size, after the newest record that it contains.
void smvm_state_log_open(StateLog *l, SmvmBytes image, SmvmAt slot_size)
{
    const SmvmAt length = smvm_read_offset(image, SMVM_LENGTH_AT, 3),
        room = length > slot_size ? 0 : (SmvmAt)((slot_size - length) / LINK_TRANSITION);

    memset(l, 0, sizeof *l);
    l->image = image;
    l->written = LINK_TRANSITION;
    l->credit = STATE_LOG_CREDIT;
    if (room >= STATE_LOG_LEAST)
        l->records = (uint8_t)(room > LINK_TRANSITIONS ? LINK_TRANSITIONS : room);
    find_latest_record(l);
}

static void count_lost(StateLog *l, uint32_t lost)
{
    l->lost = lost >= (uint8_t)(LINK_LOST_MAX - l->lost) ? LINK_LOST_MAX : (uint8_t)(l->lost + lost);
}

// Begins a record, if the event is a transition.  `lost`: number of events lost before `e`.
void smvm_state_log_add(StateLog *l, const SmEvent *e, uint32_t lost)
{
    LinkTransition t;

    count_lost(l, lost);
    if (e->kind != SM_EVENT_STATE || l->records == 0)
        return;
    if (l->credit == 0) {
        count_lost(l, 1);
        return;
    }
    l->credit--;
    t.number = l->number;
    t.machine = (uint8_t)e->source;
    t.lost = l->lost;
    t.from = (uint16_t)e->a;
    t.to = (uint16_t)e->b;
    t.time = (uint32_t)(e->time >> 20);
    sm_link_store_transition(l->record, &t, checksum_of(l));
    l->lost = 0;
    l->written = 0;
}

// Stores the next byte to write in *byte, and its offset from the start of the image in *at.  Returns false if the log is idle.
bool smvm_state_log_next(const StateLog *l, SmvmAt *at, uint8_t *byte)
{
    if (smvm_state_log_is_idle(l))
        return false;
    *at = (SmvmAt)(record_at(l, l->next) + l->written);
    *byte = l->record[l->written];
    return true;
}

void smvm_state_log_advance(StateLog *l)
{
    if (++l->written < LINK_TRANSITION)
        return;
    l->number++;
    l->next = index_after(l, l->next);
}

// Lets the log store one more transition; at most STATE_LOG_CREDIT.
void smvm_state_log_add_credit(StateLog *l)
{
    if (l->credit < STATE_LOG_CREDIT)
        l->credit++;
}
