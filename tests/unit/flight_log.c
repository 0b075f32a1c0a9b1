// SPDX-License-Identifier: Apache-2.0
// The reader of flight logs on a file that was crafted to cost time: it stops, returns what it has read, and reports the rest as not read.
#include <string.h>

#include "compiler/report/flight_log.h"
#include "runtime-c/log_block.h"
#include "tests/test.h"
#include "tests/unit/host.h"

enum { PACKED = 4, RECORD = LOG_HEAD + 8 + PACKED + LOG_CHECK, SIZE = 100000 };

typedef struct File { uint8_t bytes[SIZE]; uint32_t n, identity; } File;

static void append(File *f, const void *bytes, uint32_t n)
{
    memcpy(f->bytes + f->n, bytes, n);
    f->n += n;
}

static void append_block(File *f, LogKind kind, const uint8_t *payload, uint32_t n)
{
    const uint32_t start = f->n, crc = kind == LOG_DESCRIPTION ? SM_CRC32_START : f->identity;
    uint8_t head[LOG_HEAD], check[LOG_CHECK];

    log_put_head(head, kind, n);
    append(f, head, sizeof head);
    append(f, payload, n);
    log_put32(check, sm_crc32_end(log_crc_update(crc, f->bytes + start, LOG_HEAD + n)));
    append(f, check, sizeof check);
}

// Appends a description with one U32 element x, without machines, tasks, executors or names of events.
static void append_description(File *f)
{
    uint8_t d[64] = {LOG_VERSION};
    uint32_t n = LOG_IDENTITY;

    f->identity = log_crc_update(SM_CRC32_START, d, LOG_IDENTITY);
    log_put16(d + n, 1), d[n + 2] = 'v', n += 3;              // name of the state vector
    log_put32(d + n, PACKED), n += 4;
    log_put16(d + n, 1), log_put16(d + n + 2, 1), d[n + 4] = 'r', log_put16(d + n + 5, 1), n += 7;        // one region, one element in it
    log_put16(d + n, 1), d[n + 2] = SM_U32, log_put16(d + n + 3, 1), d[n + 5] = 'x', n += 6;
    n += 8;                                                   // four counts of 0
    append_block(f, LOG_DESCRIPTION, d, n);
}

static void append_records(File *f, uint32_t n)
{
    uint8_t payload[8 + PACKED] = {0};

    while (n-- > 0)
        append_block(f, LOG_RECORD, payload, sizeof payload);
}

// Appends heads of blocks that each claim `length` bytes of the file, with wrong checksums.
static void append_traps(File *f, LogKind kind, uint32_t length, uint32_t n)
{
    uint8_t head[LOG_HEAD];

    log_put_head(head, kind, length);
    while (n-- > 0)
        append(f, head, sizeof head);
}

static Log *read_file(Arena *arena, File *f) { return log_read(arena, f->bytes, f->n); }

static void test_whole(Arena *arena, File *f)
{
    const Log *log;

    f->n = 0;
    append_description(f);
    append_records(f, 3000);
    log = read_file(arena, f);
    CHECK(log->session.n == 1 && log->session.at[0]->records == 3000 && log->damaged == 0 && log->unread == 0);
    f->n -= 5;
    log = read_file(arena, f);
    CHECK(log->session.at[0]->records == 2999 && log->damaged == RECORD - 5 && log->torn == RECORD - 5 && log->unread == 0);
}

// Traps for the second pass of the reader: blocks of events can have any multiple of their size.
static void test_traps_of_events(Arena *arena, File *f)
{
    const Log *log;
    uint32_t start;

    f->n = 0;
    append_description(f);
    append_records(f, 10);
    start = f->n;
    append_traps(f, LOG_EVENTS, LOG_EVENT * 3000, 100);
    append_records(f, 3000);
    log = read_file(arena, f);
    CHECK(log->session.n == 1 && log->session.at[0]->records == 10);
    CHECK(log->unread >= 3000 * RECORD && log->torn == 0 && log->damaged > 0 && log->damaged <= 600 && log->damaged_ranges == 1);
    CHECK(start + log->damaged + log->unread == f->n);
}

// Traps for the search of descriptions.  The reader still reads what precedes them.
static void test_traps_of_descriptions(Arena *arena, File *f)
{
    const Log *log;

    f->n = 0;
    append_description(f);
    append_records(f, 10);
    append_traps(f, LOG_DESCRIPTION, 57000, 100);
    append_records(f, 3000);
    log = read_file(arena, f);
    CHECK(log->session.n == 1 && log->session.at[0]->records == 10);
    CHECK(log->unread >= 3000 * RECORD && log->torn == 0);
}

int main(void)
{
    static File f;
    Arena arena;

    HOST_ARENA(&arena);
    test_whole(&arena, &f);
    test_traps_of_events(&arena, &f);
    test_traps_of_descriptions(&arena, &f);
    arena_free(&arena);
    return test_end("flight_log");
}
