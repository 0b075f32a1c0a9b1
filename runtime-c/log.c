// SPDX-License-Identifier: Apache-2.0
// The step's side of the log: puts blocks into the ring.  A block is contiguous.  If it does not fit before the end of the ring,
// `end` records the end of the last block, and the next one starts at the front. head == tail means empty, so the ring is never
// filled completely.
#include "runtime-c/log.h"

#include <string.h>

#include "runtime-c/handover.h"
#include "runtime-c/log_block.h"

enum { EVENTS_AT_ONCE = 4 };

// Whether the file is a log that may be appended to: empty, or beginning like a log with at most one damaged byte.  Zeros are
// accepted too, because some file systems leave them in place of data that was not synced.  If the file is shorter than the
// beginning of a log, only the mark is checked.
static bool is_log(const SmLog *log)
{
    enum { BEGINNING = LOG_HEAD + 9 };                    // bytes of a log up to and including the start offset of the first session, which is 0
    const uint8_t beginning[9] = {LOG_VERSION};
    const uint32_t n = log->start < BEGINNING ? (uint32_t)log->start : BEGINNING;
    uint8_t b[BEGINNING] = {0};
    bool zeros = true;

    if (n == 0 || pal_log_read(log->out, b, (size_t)n) != SM_OK)
        return n == 0;
    for (uint32_t i = 0; i < n; i++)
        zeros = zeros && b[i] == 0;
    if (zeros || n < BEGINNING)
        return zeros || b[0] == LOG_MARK;
    if (b[0] == LOG_MARK || b[1] == LOG_DESCRIPTION)
        return (b[0] == LOG_MARK && b[1] == LOG_DESCRIPTION) || memcmp(b + LOG_HEAD, beginning, sizeof beginning) == 0;
    return false;
}

static SmResult open_file(SmLog *log)
{
    SmResult r = pal_log_open(&log->out, log->file);

    if (r != SM_OK)
        return r;
    r = pal_log_size(log->out, &log->start);
    if (r == SM_OK && !is_log(log))
        r = SM_E_FOREIGN;
    if (r != SM_OK) {
        (void)pal_log_close(log->out);
        log->out.id = 0;
    }
    return r;
}

SmResult sm_log_init(void *context)
{
    SmLog *log = (SmLog *)context;
    SmResult r;

    if (!log || !log->file || !log->sv || !log->buffer || !log->names || log->names->layout != log->sv->layout)
        return SM_E_ARGUMENT;
    if (log->room < SM_LOG_LEAST(log->sv->layout->whole.packed))
        return SM_E_MEMORY;
    r = sm_handover_open(&log->lock);
    if (r == SM_OK)
        r = open_file(log);
    log->written = log->start;
    return r;
}

// ---- room in the ring ----

// Stores in *at the position of the next block, which has n bytes.  Returns false if there is no space for it, or the lock timed
// out.
static bool find_space(SmLog *log, uint32_t n, uint32_t *at)
{
    uint32_t tail;

    if (sm_handover_lock(log->lock) != SM_OK)
        return false;
    tail = log->tail;
    sm_handover_unlock(log->lock);
    *at = log->head;
    if (log->head < tail)
        return n < tail - log->head;
    if (n <= log->room - log->head)
        return true;
    *at = 0;
    return n < tail;
}

// Passes the block of n bytes at `at` to the drain.  A block at the front follows a wrap-around, so `end` is set too.  Returns
// false if the lock timed out.
static bool hand_over_block(SmLog *log, uint32_t at, uint32_t n)
{
    if (sm_handover_lock(log->lock) != SM_OK)
        return false;
    if (at == 0)
        log->end = log->head;
    log->head = at + n;
    sm_handover_unlock(log->lock);
    return true;
}

// ---- blocks ----

static void encode_event(uint8_t *to, const SmEvent *e)
{
    log_put64(to, e->time);
    to[8] = e->kind;
    log_put16(to + 9, e->source);
    log_put32(to + 11, e->a);
    log_put32(to + 15, e->b);
}

// Puts up to EVENTS_AT_ONCE events into a block and returns their number.  Without space, the events stay in the event ring.
static uint32_t append_events_block(SmLog *log)
{
    SmEvent e[EVENTS_AT_ONCE];
    uint32_t at, n, lost = 0;
    uint8_t *to;

    if (!find_space(log, SM_LOG_BLOCK + EVENTS_AT_ONCE * LOG_EVENT, &at))
        return 0;
    n = sm_events_read(log->events, &log->cursor, e, EVENTS_AT_ONCE, &lost);
    log->lost += lost;
    if (n == 0)
        return 0;
    to = log->buffer + at;
    log_put_head(to, LOG_EVENTS, n * LOG_EVENT);
    for (uint32_t i = 0; i < n; i++)
        encode_event(to + LOG_HEAD + i * LOG_EVENT, &e[i]);
    if (!hand_over_block(log, at, SM_LOG_BLOCK + n * LOG_EVENT))
        log->lost += n;
    return n;
}

// Appends the events of the event ring.  At most as many as the ring has room for, so that events emitted meanwhile cannot prolong the loop.
static void append_events(SmLog *log)
{
    uint32_t left = log->events ? log->events->room : 0, n = 1;

    while (left > 0 && n > 0) {
        n = append_events_block(log);
        left -= n < left ? n : left;
    }
}

// Appends a GAP block with the losses that the log has not reported yet, if there are any.
static void append_gap(SmLog *log)
{
    uint32_t at;

    if ((log->dropped == log->dropped_reported && log->lost == log->lost_reported) || !find_space(log, SM_LOG_BLOCK + LOG_DROPPED, &at))
        return;
    log_put_head(log->buffer + at, LOG_GAP, LOG_DROPPED);
    log_put32(log->buffer + at + LOG_HEAD, log->dropped - log->dropped_reported);
    log_put32(log->buffer + at + LOG_HEAD + 4, log->lost - log->lost_reported);
    if (hand_over_block(log, at, SM_LOG_BLOCK + LOG_DROPPED)) {
        log->dropped_reported = log->dropped;
        log->lost_reported = log->lost;
    }
}

// Copies the state vector into a record in the ring. SM_E_FULL: there is no space.
static SmResult append_record(SmLog *log, uint64_t time)
{
    const SmRegion *whole = &log->sv->layout->whole;
    uint32_t at;
    SmResult r;

    if (!find_space(log, SM_LOG_RECORD(whole->packed), &at))
        return SM_E_FULL;
    log_put_head(log->buffer + at, LOG_RECORD, 8 + whole->packed);
    log_put64(log->buffer + at + LOG_HEAD, time);
    r = sm_pack_region(log->sv, whole, log->buffer + at + LOG_HEAD + 8, (size_t)whole->packed);
    if (r == SM_OK && !hand_over_block(log, at, SM_LOG_RECORD(whole->packed)))
        r = SM_E_TIMEOUT;
    return r;
}

// Copies the events since the last step and the state vector into the ring.  SM_E_FULL: there was no space for the record.
SmResult sm_log_step(void *context, const SmTick *tick)
{
    SmLog *log = (SmLog *)context;
    SmResult r;

    append_events(log);
    append_gap(log);
    r = append_record(log, tick->time);
    log->dropped += r != SM_OK;
    return r;
}
