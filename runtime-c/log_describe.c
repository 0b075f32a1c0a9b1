// SPDX-License-Identifier: Apache-2.0
// The description of the log's format and names, which begins each session (docs/log.md).  It is generated again for each piece
// that is written, so it needs no memory.
#include <string.h>

#include "runtime-c/log_block.h"
#include "runtime-c/log_describe.h"

// Receives all bytes of the description in order, and stores those from byte `from` on, at most `room` of them, at `out`.
typedef struct DescriptionSink {
    uint32_t at;              // number of bytes received so far
    uint32_t from, room;      // stores the bytes from `from` on, at most `room` of them
    uint8_t *out;
    uint32_t crc;
} DescriptionSink;

// Appends a byte to the description.  Stores it only if it is in the part that the caller requested; the CRC covers every byte.
static void put_byte(DescriptionSink *s, uint8_t byte)
{
    if (s->at >= s->from && s->at - s->from < s->room)
        s->out[s->at - s->from] = byte;
    s->crc = sm_crc32_byte(s->crc, byte);
    s->at++;
}

static void put_bytes(DescriptionSink *s, const uint8_t *bytes, uint32_t n)
{
    while (n-- > 0)
        put_byte(s, *bytes++);
}

static void put_u16(DescriptionSink *s, uint16_t x)
{
    uint8_t bytes[2];

    log_put16(bytes, x);
    put_bytes(s, bytes, 2);
}

static void put_u32(DescriptionSink *s, uint32_t x)
{
    uint8_t bytes[4];

    log_put32(bytes, x);
    put_bytes(s, bytes, 4);
}

static void put_name(DescriptionSink *s, const char *name)
{
    uint16_t length = 0;

    while (name && name[length] != '\0' && length < UINT16_MAX)
        length++;
    put_u16(s, length);
    put_bytes(s, (const uint8_t *)name, length);
}

// ---- parts of the description ----

static void encode_identity(const SmLog *log, uint8_t *to)
{
    to[0] = LOG_VERSION;
    log_put64(to + 1, log->start);
    log_put32(to + 9, log->sv->layout->hash);
}

static void put_layout(DescriptionSink *s, const SmNames *names)
{
    const SmLayout *l = names->layout;

    put_name(s, names->vector);
    put_u32(s, l->whole.packed);
    put_u16(s, l->regions);
    for (uint16_t i = 0; i < l->regions; i++) {
        put_name(s, names->region[i]);
        put_u16(s, l->region[i].count);
    }
    put_u16(s, l->elements);
    for (uint16_t i = 0; i < l->elements; i++) {
        put_byte(s, l->element[i].type);
        put_name(s, names->element[i]);
    }
}

// Returns the index of a machine's element S in the layout; 0xFFFF if no element is at its offset.
static uint16_t state_element_index(const SmLayout *l, const SmMachine *m)
{
    const SmRange at = m->type->state_number(m->self);
    uint16_t i = 0;

    while (i < l->elements && l->element[i].offset != at.offset)
        i++;
    return i < l->elements ? i : UINT16_MAX;
}

static void put_machine(DescriptionSink *s, const SmLayout *l, const SmMachine *m)
{
    const uint32_t states = m->type->states(m->self);

    put_u16(s, m->number);
    put_name(s, m->name);
    put_u16(s, state_element_index(l, m));
    put_u32(s, states);
    for (uint32_t i = 1; i <= states; i++)
        put_name(s, m->type->state_name(m->self, i));
}

static void put_names(DescriptionSink *s, const char *const *name, uint16_t n)
{
    put_u16(s, name ? n : 0);
    for (uint16_t i = 0; name && i < n; i++)
        put_name(s, name[i]);
}

static void put_event_names(DescriptionSink *s)
{
    static const uint8_t kinds[] = {
#define SM_EVENT(name, number, source, a, b, text) number,
#include "runtime-c/events.def"
#undef SM_EVENT
    };

    put_u16(s, sizeof kinds);
    for (uint16_t i = 0; i < sizeof kinds; i++) {
        put_byte(s, kinds[i]);
        put_name(s, sm_event_name(kinds[i]));
    }
}

static void put_description(DescriptionSink *s, const SmLog *log, uint32_t length)
{
    uint8_t bytes[LOG_IDENTITY];

    log_put_head(bytes, LOG_DESCRIPTION, length);
    put_bytes(s, bytes, LOG_HEAD);
    encode_identity(log, bytes);
    put_bytes(s, bytes, LOG_IDENTITY);
    put_layout(s, log->names);
    put_u16(s, log->machines);
    for (uint16_t i = 0; i < log->machines; i++)
        put_machine(s, log->sv->layout, log->machine[i]);
    put_names(s, log->task, log->tasks);
    put_names(s, log->executor, log->executors);
    put_event_names(s);
    put_u32(s, sm_crc32_end(s->crc));
}

// ---- for the log ----

// Returns the size of the whole block in bytes, including its head and checksum.
uint32_t sm_log_description_size(const SmLog *log)
{
    DescriptionSink s = {0, 0, 0, NULL, SM_CRC32_START};

    put_description(&s, log, 0);
    return s.at;
}

// Fills `out` with up to `room` bytes of a block of `size` bytes, from byte `from` on, and returns the number of bytes.
uint32_t sm_log_describe(const SmLog *log, uint32_t size, uint32_t from, uint8_t *out, uint32_t room)
{
    DescriptionSink s = {0, 0, 0, NULL, SM_CRC32_START};

    s.from = from;
    s.room = room < size - from ? room : size - from;
    s.out = out;
    put_description(&s, log, size - LOG_HEAD - LOG_CHECK);
    return s.room;
}

// Returns the CRC of the session's identity, not finalised.
uint32_t sm_log_identity_crc(const SmLog *log)
{
    uint8_t bytes[LOG_IDENTITY];

    encode_identity(log, bytes);
    return log_crc_update(SM_CRC32_START, bytes, LOG_IDENTITY);
}
