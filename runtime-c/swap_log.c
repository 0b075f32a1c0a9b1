// SPDX-License-Identifier: Apache-2.0
// Writes the names of a new machine into the flight log.  The block is generated piece by piece, so it needs no memory.
#include "runtime-c/swap_log.h"

#include "runtime-c/log_block.h"
#include "runtime-c/log_describe.h"

enum { AT_ONCE = 64 };

typedef struct NamesBlock {
    SmLog *log;
    uint32_t crc, n;          // n: bytes in `bytes`, which are not in the file yet
    uint8_t bytes[AT_ONCE];
    SmResult result;
} NamesBlock;

// Writes the buffered bytes of the block to the file, and updates the size of the file.
static void append_bytes(NamesBlock *b)
{
    uint64_t size;

    if (b->result == SM_OK && b->n > 0)
        b->result = pal_log_append(b->log->out, b->bytes, (size_t)b->n);
    if (pal_log_size(b->log->out, &size) == SM_OK && size > b->log->written)
        b->log->written = size;                           // after an error, a part of them may be in the file
    b->log->unsynced = true;
    b->n = 0;
}

// Appends a byte to the block of names.
static void put_byte(NamesBlock *b, uint8_t byte)
{
    b->crc = sm_crc32_byte(b->crc, byte);
    b->bytes[b->n++] = byte;
    if (b->n == AT_ONCE)
        append_bytes(b);
}

static void put_bytes(NamesBlock *b, const uint8_t *bytes, uint32_t n)
{
    while (n-- > 0)
        put_byte(b, *bytes++);
}

// Returns the length of a name, at most UINT16_MAX.
static uint16_t name_length(const char *name)
{
    uint16_t n = 0;

    while (n < UINT16_MAX && name[n] != '\0')
        n++;
    return n;
}

static void put_name(NamesBlock *b, const char *name)
{
    const uint16_t n = name_length(name);
    uint8_t bytes[2];

    log_put16(bytes, n);
    put_bytes(b, bytes, 2);
    put_bytes(b, (const uint8_t *)name, n);
}

// Whether the last bytes that sm_log_drain wrote to the file complete a block.
static bool is_between_blocks(const SmLog *log)
{
    return log->out.id != 0 && log->description_size > 0 && log->description_done == log->description_size && log->tail == log->checksummed;
}

// Appends a block with the names of the states of the machine in `slot`, whose image has the checksum `identity`.  If false, the caller
// tries again later.
bool sm_swap_log_names(SmLog *log, const SmMachine *m, const void *slot, uint32_t identity)
{
    const uint32_t states = m->type->states(slot);
    uint32_t length = LOG_NAMES_HEAD;
    uint8_t head[LOG_HEAD + LOG_NAMES_HEAD], check[LOG_CHECK];
    NamesBlock b = {log, 0, 0, {0}, SM_OK};

    if (!is_between_blocks(log))
        return false;
    for (uint32_t i = 1; i <= states; i++)
        length += 2u + name_length(m->type->state_name(slot, i));
    log_put_head(head, LOG_NAMES, length);
    log_put16(head + LOG_HEAD, m->number);
    log_put32(head + LOG_HEAD + 2, identity);
    log_put32(head + LOG_HEAD + 6, states);
    b.crc = sm_log_identity_crc(log);
    put_bytes(&b, head, sizeof head);
    for (uint32_t i = 1; i <= states; i++)
        put_name(&b, m->type->state_name(slot, i));
    log_put32(check, sm_crc32_end(b.crc));
    put_bytes(&b, check, LOG_CHECK);
    append_bytes(&b);
    return b.result == SM_OK;
}
