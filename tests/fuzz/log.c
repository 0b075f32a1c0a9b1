// SPDX-License-Identifier: Apache-2.0
// Fuzz target: any bytes as a flight log, first unchanged, then with corrected checksums in everything that resembles a block.  Every output
// format is written from the result.
#include <setjmp.h>

#include "compiler/report/flight.h"
#include "runtime-c/log_block.h"
#include "tests/fuzz/fuzz.h"
#include "tests/heap.h"

static void show(Flight *f, Buf *out)
{
    flight_write_text(f, out);
    for (size_t i = 0; i < f->log->session.n; i++) {
        f->session = f->log->session.at[i];
        f->machine = f->session->d->machines ? &f->session->d->machine[0] : NULL;
        flight_write_csv(f, out);
        flight_write_json(f, out);
        if (f->session->records > 0 && f->session->d->elements < 20)
            flight_write_svg(f, out);
    }
}

unsigned long fuzz_reached;           // inputs in which a session was found
const unsigned fuzz_floor = 50;

static bool read_and_show(const uint8_t *data, size_t size)
{
    static jmp_buf oom;
    volatile bool found = false;
    Arena arena;
    Flight f;
    Buf out;

    arena_init(&arena, heap_alloc, NULL, &oom);
    if (setjmp(oom) == 0) {
        memset(&f, 0, sizeof f);
        f.arena = &arena;
        f.name = "log";
        f.log = log_read(&arena, data, (uint32_t)size);
        buf_init(&out, &arena);
        show(&f, &out);
        found = f.log->session.n > 0;
    }
    arena_free(&arena);
    return found;
}

// Corrects all blocks, one after another, as if each belonged to the last description before it.
static void put_right(uint8_t *data, size_t size)
{
    uint32_t identity = SM_CRC32_START;
    size_t at = 0;

    while (at + LOG_HEAD + LOG_CHECK <= size) {
        const uint32_t length = log_get32(data + at + 2) % 2048;
        const bool first = data[at + 1] == LOG_DESCRIPTION;
        if (at + LOG_HEAD + LOG_CHECK + length > size)
            return;
        data[at] = LOG_MARK;
        log_put32(data + at + 2, length);
        log_put32(data + at + LOG_HEAD + length, sm_crc32_end(log_crc_update(first ? SM_CRC32_START : identity, data + at, LOG_HEAD + length)));
        if (first && length >= LOG_IDENTITY)
            identity = log_crc_update(SM_CRC32_START, data + at + LOG_HEAD, LOG_IDENTITY);
        at += LOG_HEAD + LOG_CHECK + length;
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    uint8_t *copy;

    if (size > 65536)
        return 0;
    read_and_show(data, size);
    copy = malloc(size + 1);
    memcpy(copy, data, size);
    put_right(copy, size);
    fuzz_reached += read_and_show(copy, size);
    free(copy);
    return 0;
}
