// SPDX-License-Identifier: Apache-2.0
// Finds the undamaged blocks of a log.
//
//   1. Finds all descriptions.  Their checksums do not depend on a session.
//   2. Walks the blocks in order.  The checksum of a block is tried with the current session, then with the next session, whose own
//      description may be damaged.  Bytes that do not begin a block are skipped one by one.
//
// A crafted file could force a checksum over all following bytes at every byte.  So each of the two steps counts the bytes in failed
// checksums and stops at a number that real damage does not reach.  The walk reads no further than the search for descriptions: without
// them it could not assign blocks to sessions.  The rest of the file is reported as unread, because it can contain undamaged blocks.
#include <string.h>

#include "compiler/base/buf.h"
#include "compiler/report/flight_log.h"
#include "runtime-c/log_block.h"

typedef struct LogReader {
    Arena *arena;
    const uint8_t *bytes;
    uint32_t n;
    VEC(LogDescription *) found;
    size_t next;                  // index into `found` of the first description that the walk has not passed
    VEC(LogSession *) sessions;   // the session of each description in `found`; a repeated description repeats its session
    LogSession *current;
    size_t *next_other;           // by index into `sessions`: the next index with a different session
    uint64_t failed_bytes;        // bytes covered by failed checksums in this step (1 or 2 above)
    uint32_t searched;            // end of the part of the file in which all descriptions are known
    uint32_t intact_end;          // end of the last undamaged block: a damaged range begins here
    Log *log;
} LogReader;

// Whether failed_bytes is within its limit.  Real damage causes far fewer than 16 checksums over each byte of the file.
static bool may_continue(const LogReader *r) { return r->failed_bytes <= 16 * (uint64_t)r->n + 65536; }

// Stores the content length of the block at `pos`.  False if no block can begin there.
static bool match_block_head(const LogReader *r, uint32_t pos, uint32_t *length)
{
    if (r->n - pos < LOG_HEAD + LOG_CHECK || r->bytes[pos] != LOG_MARK)
        return false;
    *length = log_get32(r->bytes + pos + 2);
    return *length <= r->n - pos - LOG_HEAD - LOG_CHECK;
}

// Returns whether the checksum of a block is right; if not, adds its length to failed_bytes.  `crc`: its start value.
static bool check_checksum(LogReader *r, uint32_t pos, uint32_t length, uint32_t crc)
{
    const bool good = sm_crc32_end(log_crc_update(crc, r->bytes + pos, LOG_HEAD + length)) == log_get32(r->bytes + pos + LOG_HEAD + length);

    r->failed_bytes += good ? 0 : LOG_HEAD + length;
    return good;
}

// ---- descriptions ----

// Adds the description at `pos` to `found`.  False if the block is damaged or no description.
static bool try_add_description(LogReader *r, uint32_t pos, uint32_t length)
{
    LogDescription *d;

    if (r->bytes[pos + 1] != LOG_DESCRIPTION || !check_checksum(r, pos, length, SM_CRC32_START))
        return false;
    d = ARENA_NEW(r->arena, LogDescription);
    d->pos = pos;
    d->size = LOG_HEAD + length + LOG_CHECK;
    if (log_parse_description(r->arena, r->bytes + pos + LOG_HEAD, length, d))
        vec_push(r->arena, &r->found, d);
    else
        r->log->newer = r->log->newer || d->version > LOG_VERSION;
    return true;
}

// First pass: finds all intact blocks that describe a session. Bytes that begin no such block are skipped one by one.
static void find_descriptions(LogReader *r)
{
    uint32_t pos = 0, length;

    while (pos < r->n && may_continue(r)) {
        const uint8_t *mark = memchr(r->bytes + pos, LOG_MARK, r->n - pos);
        pos = mark ? (uint32_t)(mark - r->bytes) : r->n;
        if (mark && match_block_head(r, pos, &length) && try_add_description(r, pos, length))
            pos += LOG_HEAD + length + LOG_CHECK;
        else if (mark)
            pos++;
    }
    r->searched = pos;
}

// ---- sessions ----

// Whether b is a repeated copy of description a.
static bool is_same_session(const LogDescription *a, const LogDescription *b)
{
    return a->start == b->start && a->layout == b->layout && a->packed == b->packed;
}

static LogSession *find_or_create_session(LogReader *r, LogDescription *d)
{
    LogSession *s;

    if (r->sessions.n > 0 && is_same_session(r->sessions.at[r->sessions.n - 1]->d, d))
        return r->sessions.at[r->sessions.n - 1];
    s = ARENA_NEW(r->arena, LogSession);
    s->d = d;
    return s;
}

// Fills in `sessions` and `next_other` from the descriptions.
static void list_sessions(LogReader *r)
{
    for (size_t i = 0; i < r->found.n; i++) {
        LogSession *s = find_or_create_session(r, r->found.at[i]);
        vec_push(r->arena, &r->sessions, s);
    }
    r->next_other = ARENA_ARRAY(r->arena, size_t, r->sessions.n + 1);
    for (size_t i = r->sessions.n; i-- > 0;)
        r->next_other[i] = i + 1 < r->sessions.n && r->sessions.at[i + 1] == r->sessions.at[i] ? r->next_other[i + 1] : i + 1;
}

// Makes s the current session, and adds it to the log when its first block is found.
static void select_session(LogReader *r, LogSession *s)
{
    if (!s->listed)
        vec_push(r->arena, &r->log->session, s);
    s->listed = true;
    r->current = s;
}

// ---- blocks ----

// Whether a block of this kind can have this length in a session.
static bool is_valid_block_length(const LogSession *s, uint8_t kind, uint32_t length)
{
    switch (kind) {
    case LOG_RECORD: return length == 8 + (uint64_t)s->d->packed;
    case LOG_EVENTS: return length > 0 && length % LOG_EVENT == 0;
    case LOG_GAP: return length == LOG_DROPPED;
    case LOG_NAMES: return length >= LOG_NAMES_HEAD;
    default: return false;
    }
}

static void add_swaps(LogReader *r, LogSession *s, const LogItem *events)
{
    for (uint32_t i = 0; i < events->n; i++) {
        const LogEvent e = log_read_event(events, i);
        const LogSwap swap = {e.time, e.source, e.a, e.b};
        if (e.kind == LOG_EVENT_SWAP)
            vec_push(r->arena, &s->swap, swap);
    }
}

// Adds the names of the states of an image that was swapped in during the session.
static void add_names(LogReader *r, LogSession *s, uint32_t pos, uint32_t length)
{
    LogImage image;

    if (log_parse_names(r->arena, r->bytes + pos + LOG_HEAD, length, &image))
        vec_push(r->arena, &s->image, image);
}

// Adds the block at `pos` to the session: a record, events or a gap. `length`: bytes of its contents.
static void add_item(LogReader *r, LogSession *s, uint32_t pos, uint32_t length)
{
    LogItem item = {ITEM_RECORD, 0, r->bytes + pos + LOG_HEAD};

    if (r->bytes[pos + 1] == LOG_NAMES) {
        add_names(r, s, pos, length);
        return;
    }
    if (r->bytes[pos + 1] == LOG_RECORD) {
        const uint64_t time = log_get64(item.at);
        if (s->records++ == 0)
            s->first = s->last = time;
        s->first = time < s->first ? time : s->first;
        s->last = time > s->last ? time : s->last;
    } else if (r->bytes[pos + 1] == LOG_EVENTS) {
        item.kind = ITEM_EVENTS;
        item.n = length / LOG_EVENT;
        s->events += item.n;
        add_swaps(r, s, &item);
    } else {
        item.kind = ITEM_GAP;
        s->dropped += log_read_gap(&item).records;
        s->lost += log_read_gap(&item).events;
    }
    vec_push(r->arena, &s->item, item);
}

// Adds the block at `pos` if its checksum is right for session s; s can be NULL.
static bool try_add_block(LogReader *r, LogSession *s, uint32_t pos, uint32_t length)
{
    if (!s || !is_valid_block_length(s, r->bytes[pos + 1], length) || !check_checksum(r, pos, length, s->d->identity))
        return false;
    select_session(r, s);
    add_item(r, s, pos, length);
    return true;
}

// Returns the session that follows the current one, or NULL.  If its description is damaged, its first blocks follow those of the current one.
static LogSession *following_session(const LogReader *r)
{
    size_t i = r->next;

    if (i < r->sessions.n && r->sessions.at[i] == r->current)
        i = r->next_other[i];
    return i < r->sessions.n ? r->sessions.at[i] : NULL;
}

// Processes the undamaged block at pos and returns its size, or 0 if no undamaged block begins there.
static uint32_t read_block(LogReader *r, uint32_t pos)
{
    uint32_t length;

    if (r->next < r->found.n && r->found.at[r->next]->pos == pos) {
        select_session(r, r->sessions.at[r->next]);
        return r->found.at[r->next++]->size;
    }
    if (!match_block_head(r, pos, &length) ||
        (!try_add_block(r, r->current, pos, length) && !try_add_block(r, following_session(r), pos, length)))
        return 0;
    return LOG_HEAD + length + LOG_CHECK;
}

// Counts the bytes between the last undamaged block and `pos`, if any, as a damaged range.
static void record_damage(LogReader *r, uint32_t pos)
{
    if (pos == r->intact_end)
        return;
    r->log->damaged += pos - r->intact_end;
    r->log->damaged_ranges++;
    if (pos == r->n)
        r->log->torn = pos - r->intact_end;
}

// Second pass: reads each intact block into its session; bytes between intact blocks are recorded as damage.
static void read_blocks(LogReader *r)
{
    uint32_t pos = 0;

    r->failed_bytes = 0;
    while (pos < r->searched && may_continue(r)) {
        const uint32_t size = read_block(r, pos);
        if (size > 0) {
            record_damage(r, pos);
            r->intact_end = pos + size;
        }
        pos += size > 0 ? size : 1;
        while (r->next < r->found.n && r->found.at[r->next]->pos < pos)
            r->next++;                                    // the description is inside the block that has just been read
    }
    record_damage(r, pos);
    r->log->unread = r->n - pos;
}

// Reads a log.  `bytes` must outlive the result.
Log *log_read(Arena *arena, const uint8_t *bytes, uint32_t n)
{
    LogReader r;

    memset(&r, 0, sizeof r);
    r.arena = arena;
    r.bytes = bytes;
    r.n = n;
    r.log = ARENA_NEW(arena, Log);
    r.log->size = n;
    find_descriptions(&r);
    list_sessions(&r);
    read_blocks(&r);
    return r.log;
}

// ---- contents ----

LogEvent log_read_event(const LogItem *item, uint32_t i)
{
    const uint8_t *at = item->at + (size_t)i * LOG_EVENT;

    return (LogEvent){log_get64(at), at[8], log_get16(at + 9), log_get32(at + 11), log_get32(at + 15)};
}

LogGap log_read_gap(const LogItem *item) { return (LogGap){log_get32(item->at), log_get32(item->at + 4)}; }
uint64_t log_read_time(const LogItem *record) { return log_get64(record->at); }

// Returns the value of an element in a record, as a bit cell of its type (stdlib/convert.h).
uint64_t log_read_cell(const LogItem *record, const LogElement *e)
{
    const uint8_t *at = record->at + 8 + e->at;
    uint64_t cell = 0;

    for (unsigned i = 0; i < sm_type_info[e->type].bytes; i++)
        cell |= (uint64_t)at[i] << 8 * i;
    return e->type == SM_BOOL ? cell != 0 : cell;
}

// ---- names ----

const LogElement *log_find_element(const LogDescription *d, const char *name)
{
    for (uint32_t i = 0; i < d->elements; i++)
        if (strcmp(d->element[i].name, name) == 0)
            return &d->element[i];
    return NULL;
}

const LogMachine *log_find_machine(const LogDescription *d, const char *name)
{
    for (uint32_t i = 0; i < d->machines; i++)
        if (strcmp(d->machine[i].name, name) == 0)
            return &d->machine[i];
    return NULL;
}

const LogMachine *log_machine_by_number(const LogDescription *d, uint16_t number)
{
    for (uint32_t i = 0; i < d->machines; i++)
        if (d->machine[i].number == number)
            return &d->machine[i];
    return NULL;
}

// Returns the last swap of the event's machine before the event; NULL if it was not swapped before.  A swap is at the end of a tick, so of the
// events of that tick it follows the transitions and precedes the start of the new machine.
static const LogSwap *swap_before(const LogSession *s, const LogEvent *e)
{
    for (size_t i = s->swap.n; i-- > 0;)
        if (s->swap.at[i].machine == e->source && (s->swap.at[i].time < e->time || (s->swap.at[i].time == e->time && e->a == 0)))
            return &s->swap.at[i];
    return NULL;
}

// Returns the checksum of the image that a machine ran first; the machine has been swapped.
static uint32_t first_image(const LogSession *s, uint16_t machine)
{
    size_t i = 0;

    while (s->swap.at[i].machine != machine)
        i++;
    return s->swap.at[i].from;
}

// Returns the machine of event STATE, with the names of the image that ran then.
const LogMachine *log_machine_of_event(Arena *arena, const LogSession *s, const LogEvent *e)
{
    const LogMachine *m = log_machine_by_number(s->d, e->source);
    const LogSwap *swap = m ? swap_before(s, e) : NULL;
    LogMachine *other;

    if (!swap || swap->to == first_image(s, e->source))
        return m;
    other = ARENA_NEW(arena, LogMachine);
    *other = *m;
    other->state.n = 0;
    for (size_t i = 0; i < s->image.n; i++)
        if (s->image.at[i].machine == e->source && s->image.at[i].identity == swap->to)
            other->state = s->image.at[i].state;
    return other;
}

const char *log_kind_name(const LogDescription *d, uint8_t kind)
{
    for (uint32_t i = 0; i < d->kinds; i++)
        if (d->kind[i].kind == kind)
            return d->kind[i].name;
    return NULL;
}

// Returns the name of a state, or "state 7" if it has none.
const char *log_state_name(Arena *arena, const LogMachine *m, uint32_t state)
{
    if (m && state >= 1 && state <= m->state.n && m->state.name[state - 1][0])
        return m->state.name[state - 1];
    return format_in(arena, "state %lu", (unsigned long)state);
}
