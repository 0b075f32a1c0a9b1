// SPDX-License-Identifier: Apache-2.0
// A flight log (docs/log.md), read: any bytes at all give what is whole in them.
#ifndef SMC_LOG_H
#define SMC_LOG_H

#include <stdbool.h>
#include <stdint.h>

#include "compiler/base/vec.h"
#include "stdlib/types.h"

enum { LOG_NONE = 0xFFFF };       // no element

typedef struct LogElement {
    const char *name;
    SmType type;
    uint32_t at;                  // byte in a packed vector
} LogElement;

typedef struct LogNames { const char **name; uint32_t n; } LogNames;

typedef struct LogMachine {
    uint16_t number;
    const char *name;
    uint16_t s;                   // the element that holds its state's number; LOG_NONE
    LogNames state;               // name[0] is state 1
} LogMachine;

typedef struct LogKindName { uint8_t kind; const char *name; } LogKindName;

// What a description says.
typedef struct LogDescription {
    uint32_t pos, size;           // where it lies in the file
    uint8_t version;
    uint64_t start;
    uint32_t layout;
    uint32_t identity;            // the CRC, not ended, from which those of the session's blocks go on
    const char *vector;
    uint32_t packed;
    LogElement *element;
    uint32_t elements;
    LogMachine *machine;
    uint32_t machines;
    LogNames task, executor;      // by number; none where the log does not tell
    LogKindName *kind;            // of events
    uint32_t kinds;
} LogDescription;

typedef struct LogEvent {
    uint64_t time;                // nanoseconds since the application started
    uint8_t kind;
    uint16_t source;
    uint32_t a, b;
} LogEvent;

// Every kind of event that is known here.
typedef enum LogEventKind {
#define SM_EVENT(name, number, source, a, b, text) LOG_EVENT_##name = number,
#include "runtime-c/events.def"
#undef SM_EVENT
    LOG_EVENT_KINDS
} LogEventKind;

typedef enum LogItemKind { ITEM_RECORD, ITEM_EVENTS, ITEM_GAP } LogItemKind;

typedef struct LogItem {
    LogItemKind kind;
    uint32_t n;                   // EVENTS: how many
    const uint8_t *at;            // RECORD: its time; EVENTS: the first; GAP: the counts
} LogItem;

// One run of an application.
typedef struct LogSession {
    const LogDescription *d;
    bool entered;                 // the reader's
    VEC(LogItem) item;            // in the order of the file
    uint64_t records, events;
    uint64_t first, last;         // times of its first and last record
    uint64_t dropped, lost;       // records and events that the application had no room for
} LogSession;

typedef struct Log {
    VEC(LogSession *) session;
    uint64_t size;
    uint64_t damaged;             // bytes that belong to nothing whole
    uint64_t places;              // in so many stretches
    uint64_t torn;                // of `damaged`: at the end of the file
    bool newer;                   // there is a description of a version that is not known here
} Log;

// `bytes` stay where they are.  No session: nothing is readable.
Log *log_read(Arena *arena, const uint8_t *bytes, uint32_t n);

typedef struct LogGap { uint32_t records, events; } LogGap;       // that were dropped, that were lost
LogGap log_gap(const LogItem *item);
LogEvent log_event(const LogItem *item, uint32_t i);
uint64_t log_time(const LogItem *record);
// An element of a record as a bit cell of its type (stdlib/convert.h).
uint64_t log_cell(const LogItem *record, const LogElement *e);

const LogElement *log_find_element(const LogDescription *d, const char *name);        // or NULL
const LogMachine *log_find_machine(const LogDescription *d, const char *name);
const LogMachine *log_machine(const LogDescription *d, uint16_t number);
const char *log_state_name(Arena *arena, const LogMachine *m, uint32_t state);        // "state 7" where it has no name

// ---- inside: describe.c ----

// What a description says whose checksum is right; false: it contradicts itself, or its version is not known.
bool log_parse(Arena *arena, const uint8_t *bytes, uint32_t n, LogDescription *d);

#endif
