// SPDX-License-Identifier: Apache-2.0
// Parses the description of a session.  Its contents are not trusted although its checksum is right: an attacker may have written it.
#include <string.h>

#include "compiler/report/flight_log.h"
#include "runtime-c/log_block.h"

typedef struct LogCursor {
    Arena *arena;
    const uint8_t *at;
    uint32_t left;            // bytes from `at` to the end of the description
    bool wrong;               // the description is invalid; all later reads fail too
} LogCursor;

// Returns the next n bytes.  If fewer than n remain, sets c->wrong and returns 8 zero bytes, which is enough for the integers below.
static const uint8_t *read_bytes(LogCursor *c, uint32_t n)
{
    static const uint8_t nothing[8];
    const uint8_t *at = c->at;

    if (c->wrong || n > c->left) {
        c->wrong = true;
        return nothing;
    }
    c->at += n;
    c->left -= n;
    return at;
}

static uint8_t read_u8(LogCursor *c) { return read_bytes(c, 1)[0]; }
static uint16_t read_u16(LogCursor *c) { return log_get16(read_bytes(c, 2)); }
static uint32_t read_u32(LogCursor *c) { return log_get32(read_bytes(c, 4)); }
static uint64_t read_u64(LogCursor *c) { return log_get64(read_bytes(c, 8)); }

// Whether c can be part of a name.  Other bytes are replaced by '?', because they could have a meaning to a terminal or in a table.
static bool is_name_character(uint8_t c)
{
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_' || c == '.' || c == '-';
}

// Reads a length (16 bits) and as many characters. Characters that no name can have become '?'.
static const char *read_name(LogCursor *c)
{
    const uint16_t n = read_u16(c);
    const uint8_t *from = read_bytes(c, n);
    char *name;

    if (c->wrong)
        return "";
    name = arena_alloc(c->arena, (size_t)n + 1);
    for (uint16_t i = 0; i < n; i++)
        name[i] = is_name_character(from[i]) ? (char)from[i] : '?';
    name[n] = '\0';
    return name;
}

// Returns n, the number of items that follow, each at least `least` bytes long.  If too few bytes remain, fails and returns 0.
static uint32_t read_count(LogCursor *c, uint32_t n, uint32_t least)
{
    if (n > c->left / least)
        c->wrong = true;
    return c->wrong ? 0 : n;
}

// Reads n names; each takes at least 2 bytes, so a count that the remaining bytes cannot hold is refused.
static LogNames read_names(LogCursor *c, uint32_t n)
{
    LogNames names = {NULL, read_count(c, n, 2)};

    names.name = ARENA_ARRAY(c->arena, const char *, names.n + 1);
    for (uint32_t i = 0; i < names.n; i++)
        names.name[i] = read_name(c);
    return names;
}

// Skips the names of the regions and returns how many elements they have in total.
static uint32_t read_regions(LogCursor *c)
{
    const uint32_t n = read_count(c, read_u16(c), 4);
    uint32_t elements = 0;

    for (uint32_t i = 0; i < n; i++) {
        (void)read_name(c);
        elements += read_u16(c);
    }
    return elements;
}

// Reads type and name of each state-vector element. The sizes must add up to the packed record, and the number to that of the regions.
static void read_elements(LogCursor *c, LogDescription *d)
{
    const uint32_t expected = read_regions(c);
    uint32_t at = 0;

    d->elements = read_count(c, read_u16(c), 3);
    d->element = ARENA_ARRAY(c->arena, LogElement, d->elements + 1);
    for (uint32_t i = 0; i < d->elements; i++) {
        const uint8_t type = read_u8(c);
        c->wrong = c->wrong || type >= SM_TYPE_COUNT;
        d->element[i].type = c->wrong ? SM_U8 : (SmType)type;
        d->element[i].at = at;
        d->element[i].name = read_name(c);
        at += sm_type_info[d->element[i].type].bytes;
    }
    c->wrong = c->wrong || at != d->packed || d->elements != expected;
}

static void read_machines(LogCursor *c, LogDescription *d)
{
    d->machines = read_count(c, read_u16(c), 10);
    d->machine = ARENA_ARRAY(c->arena, LogMachine, d->machines + 1);
    for (uint32_t i = 0; i < d->machines; i++) {
        LogMachine *m = &d->machine[i];
        m->number = read_u16(c);
        m->name = read_name(c);
        m->s = read_u16(c);
        m->s = m->s < d->elements ? m->s : (uint16_t)LOG_NONE;
        m->state = read_names(c, read_u32(c));
    }
}

// Reads the names of the kinds of events.
static void read_kinds(LogCursor *c, LogDescription *d)
{
    d->kinds = read_count(c, read_u16(c), 3);
    d->kind = ARENA_ARRAY(c->arena, LogKindName, d->kinds + 1);
    for (uint32_t i = 0; i < d->kinds; i++) {
        d->kind[i].kind = read_u8(c);
        d->kind[i].name = read_name(c);
    }
}

// Parses the contents of a description whose checksum is right.
bool log_parse_description(Arena *arena, const uint8_t *bytes, uint32_t n, LogDescription *d)
{
    LogCursor c = {arena, bytes, n, n < LOG_IDENTITY};

    d->identity = n < LOG_IDENTITY ? 0 : log_crc_update(SM_CRC32_START, bytes, LOG_IDENTITY);
    d->version = read_u8(&c);
    if (d->version != LOG_VERSION)
        return false;
    d->start = read_u64(&c);
    d->layout = read_u32(&c);
    d->vector = read_name(&c);
    d->packed = read_u32(&c);
    read_elements(&c, d);
    read_machines(&c, d);
    d->task = read_names(&c, read_u16(&c));
    d->executor = read_names(&c, read_u16(&c));
    read_kinds(&c, d);
    return !c.wrong && c.left == 0;
}

// Parses the contents of a block of names.
bool log_parse_names(Arena *arena, const uint8_t *bytes, uint32_t n, LogImage *image)
{
    LogCursor c = {arena, bytes, n, false};

    image->machine = read_u16(&c);
    image->identity = read_u32(&c);
    image->state = read_names(&c, read_u32(&c));
    return !c.wrong && c.left == 0;
}

const char *log_swap_refusal(uint32_t reason)
{
    switch (reason) {
#define SM_SWAP(name, number, text) case number: return text;
#include "runtime-c/swaps.def"
#undef SM_SWAP
    default: return "?";
    }
}
