// SPDX-License-Identifier: Apache-2.0
// The drain's side of the log: fills in checksums and writes the ring to the medium.  It writes the description first, and repeats
// it from time to time, so that a log whose beginning is damaged can still be read.
//
// If the medium fails in the middle of a piece, the file's size shows how much was written.  The next write continues there.
#include "runtime-c/handover.h"
#include "runtime-c/log_block.h"
#include "runtime-c/log_describe.h"
#include "runtime-c/pal/clock.h"

enum { DESCRIBE_AT_ONCE = 64 };

// Appends n bytes to the file.  Returns how many of them are in the file now, which after an error can be fewer than n.
static uint32_t append_to_file(SmLog *log, const uint8_t *bytes, uint32_t n)
{
    uint64_t size = log->written;
    uint32_t done = n;

    log->result = pal_log_append(log->out, bytes, (size_t)n);
    if (log->result != SM_OK) {
        (void)pal_log_size(log->out, &size);
        done = size < log->written || size - log->written > n ? 0 : (uint32_t)(size - log->written);
    }
    log->written += done;
    log->unsynced = log->unsynced || done > 0;
    return done;
}

// ---- the description ----

// Whether a description has begun and is not complete.
static bool is_describing(const SmLog *log)
{
    return log->description_done < log->description_size;
}

static void begin_description(SmLog *log)
{
    log->description_size = sm_log_description_size(log);
    log->description_done = 0;
    log->described_at = log->written;
}

static void write_description_piece(SmLog *log)
{
    uint8_t bytes[DESCRIBE_AT_ONCE];
    const uint32_t n = sm_log_describe(log, log->description_size, log->description_done, bytes, DESCRIBE_AT_ONCE);

    log->description_done += append_to_file(log, bytes, n);
}

// Whether a description must be written: none has been yet, or SM_LOG_AGAIN bytes have followed the last one.  Its own size is
// added, so that other data comes between two descriptions even if SM_LOG_AGAIN is small.
static bool is_description_due(const SmLog *log)
{
    return log->description_size == 0 || log->written - log->described_at > (uint64_t)log->description_size + SM_LOG_AGAIN;
}

// ---- the ring ----

// Returns the end of the contiguous blocks that start at the tail; the tail itself if the lock timed out.  Moves the tail to the
// front first if it is at the end of the ring.
static uint32_t find_contiguous_end(SmLog *log)
{
    uint32_t limit;

    if (sm_handover_lock(log->lock) != SM_OK)
        return log->tail;
    if (log->head < log->tail && log->tail == log->end)
        log->tail = log->checksummed = 0;
    limit = log->head < log->tail ? log->end : log->head;
    sm_handover_unlock(log->lock);
    return limit;
}

// Fills in the checksums of blocks before `limit`: of at least one block, then up to SM_LOG_PIECE bytes.  If the description is
// due, it stops after one block.
static void add_checksums(SmLog *log, uint32_t limit)
{
    const uint32_t identity = sm_log_identity_crc(log), most = is_description_due(log) ? 0 : SM_LOG_PIECE;

    while (log->checksummed < limit && (log->checksummed == log->tail || log->checksummed - log->tail < most)) {
        uint8_t *block = log->buffer + log->checksummed;
        const uint32_t n = LOG_HEAD + log_get32(block + 2);

        log_put32(block + n, sm_crc32_end(log_crc_update(identity, block, n)));
        log->checksummed += n + LOG_CHECK;
    }
}

// Adds the first n bytes after the tail, which are in the file now, to the free space of the ring.
static void release_written(SmLog *log, uint32_t n)
{
    if (sm_handover_lock(log->lock) != SM_OK)
        return;                                           // retried next time; these bytes will then be in the file twice
    log->tail += n;
    sm_handover_unlock(log->lock);
}

// Writes one piece: of the description if one is due or begun, else of the ring.  Returns false if there was nothing to write.
static bool drain_piece(SmLog *log)
{
    uint32_t limit, n;

    if (!is_describing(log) && is_description_due(log) && log->tail == log->checksummed)       // only between blocks of the ring
        begin_description(log);
    if (is_describing(log)) {
        write_description_piece(log);
        return true;
    }
    limit = find_contiguous_end(log);
    if (log->tail == limit)
        return false;
    add_checksums(log, limit);
    n = log->checksummed - log->tail;
    n = n < SM_LOG_PIECE ? n : SM_LOG_PIECE;
    release_written(log, append_to_file(log, log->buffer + log->tail, n));
    return true;
}

// ---- for the application ----

static void sync_file(SmLog *log, uint64_t now)
{
    SmResult r = log->unsynced ? pal_log_sync(log->out) : SM_OK;

    if (r != SM_OK)
        log->result = r;
    log->unsynced = log->unsynced && r != SM_OK;
    log->synced_at = now;
}

// Writes pieces until the ring is empty, the medium fails, or `budget` has passed since `start`.  Returns whether data remains.
static bool drain_until(SmLog *log, uint64_t start, uint64_t budget)
{
    bool left;

    do {
        log->result = SM_OK;
        left = drain_piece(log) && log->result == SM_OK;
    } while (left && pal_clock_now() - start < budget);
    return left;
}

// Writes the ring to the medium until it is empty or `budget` nanoseconds have passed.  Returns whether data remains; false also if the
// medium fails.
bool sm_log_drain(SmLog *log, uint64_t budget)
{
    const uint64_t start = pal_clock_now();
    const bool left = drain_until(log, start, budget);

    if (pal_clock_now() - log->synced_at >= SM_LOG_SYNC)
        sync_file(log, pal_clock_now());
    return left;
}

// Writes the whole ring, waits for the medium and closes the file.
SmResult sm_log_close(SmLog *log)
{
    (void)sm_log_drain(log, UINT64_MAX);
    sync_file(log, pal_clock_now());
    (void)pal_log_close(log->out);
    log->out.id = 0;
    if (log->lock.id != 0)
        (void)pal_lock_close(log->lock);
    log->lock.id = 0;
    return log->result;
}
