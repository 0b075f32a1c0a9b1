// SPDX-License-Identifier: Apache-2.0
// Reads a flight log (docs/log.md).  Accepts any bytes, and returns the undamaged parts.
#ifndef SMC_FLIGHT_LOG_H
#define SMC_FLIGHT_LOG_H

#include <stdbool.h>
#include <stdint.h>

#include "compiler/base/vec.h"
#include "stdlib/types.h"

enum { LOG_NONE = 0xFFFF };       // for LogMachine.s: the log does not contain the element

typedef struct LogElement {
    const char *name;
    SmType type;
    uint32_t at;                  // byte offset in a packed vector
} LogElement;

typedef struct LogNames { const char **name; uint32_t n; } LogNames;

typedef struct LogMachine {
    uint16_t number;
    const char *name;
    uint16_t s;                   // index in LogDescription.element of the element with the number of the machine's state, or LOG_NONE
    LogNames state;               // names of the states; name[0] is that of state 1
} LogMachine;

typedef struct LogKindName { uint8_t kind; const char *name; } LogKindName;

// The contents of a description block.
typedef struct LogDescription {
    uint32_t pos, size;           // byte offset of its block in the file, and the size of the block
    uint8_t version;              // version of the log format
    uint64_t start;               // length of the file when the session began
    uint32_t layout;              // hash of the state vector's layout
    uint32_t identity;            // unfinished CRC-32 of the session's identity, from which the checksum of each block of the session continues
    const char *vector;           // name of the state vector
    uint32_t packed;              // bytes of a packed vector
    LogElement *element;
    uint32_t elements;
    LogMachine *machine;
    uint32_t machines;
    LogNames task, executor;      // names by number of the task or executor; empty if the log does not contain them
    LogKindName *kind;            // names of the kinds of events
    uint32_t kinds;
} LogDescription;

typedef struct LogEvent {
    uint64_t time;                // nanoseconds since the application started
    uint8_t kind;                 // LogEventKind, or a kind that this reader does not know
    uint16_t source;              // number of the machine, task or executor that the event is about
    uint32_t a, b;                // their meaning depends on the kind (runtime-c/events.def)
} LogEvent;

// Every kind of event that this reader knows.
typedef enum LogEventKind {
#define SM_EVENT(name, number, source, a, b, text) LOG_EVENT_##name = number,
#define SM_EVENT_OF_SWAP SM_EVENT
#include "runtime-c/events.def"
#undef SM_EVENT
    LOG_EVENT_KINDS
} LogEventKind;

typedef enum LogItemKind { ITEM_RECORD, ITEM_EVENTS, ITEM_GAP } LogItemKind;

typedef struct LogItem {
    LogItemKind kind;
    uint32_t n;                   // EVENTS: number of events
    const uint8_t *at;            // bytes in the block from which a reader goes on.  RECORD: its time; EVENTS: the first event; GAP: the counts
} LogItem;

// The names of the states of an image that has replaced another one.
typedef struct LogImage {
    uint16_t machine;             // number of the machine
    uint32_t identity;            // checksum of the image
    LogNames state;
} LogImage;

// A machine's image was replaced at the end of a tick.
typedef struct LogSwap {
    uint64_t time;                // nanoseconds since the application started
    uint16_t machine;             // LogMachine.number
    uint32_t from, to;            // checksums of the images
} LogSwap;

// One run of an application.
typedef struct LogSession {
    const LogDescription *d;
    bool listed;                  // Log.session contains the session (only flight_log_read.c uses this)
    VEC(LogItem) item;            // in the order of the file
    uint64_t records, events;     // how many the session has
    uint64_t first, last;         // times of its first and last record, in nanoseconds
    VEC(LogImage) image;
    VEC(LogSwap) swap;            // in order
    uint64_t dropped, lost;       // records and events that were left out because the application had no room for them
} LogSession;

typedef struct Log {
    VEC(LogSession *) session;
    uint64_t size;
    uint64_t damaged;             // bytes outside undamaged blocks
    uint64_t damaged_ranges;      // number of contiguous ranges of such bytes
    uint64_t torn;                // how many of the `damaged` bytes are at the end of the file, where a crash can have cut off a block
    uint64_t unread;              // bytes at the end of the file that were not read, because too many checksums before them are wrong
    bool newer;                   // the file contains a description of a later, unknown version
} Log;

// Reads a log.  `bytes` must outlive the result.  The result has no session if nothing is readable.
Log *log_read(Arena *arena, const uint8_t *bytes, uint32_t n);

typedef struct LogGap { uint32_t records, events; } LogGap;       // how many were left out, as LogSession.dropped and lost
LogGap log_read_gap(const LogItem *item);
LogEvent log_read_event(const LogItem *item, uint32_t i);
uint64_t log_read_time(const LogItem *record);
// Returns the value of an element in a record, as a bit cell of its type (stdlib/convert.h).
uint64_t log_read_cell(const LogItem *record, const LogElement *e);

// These return NULL if the log describes no such element or machine.
const LogElement *log_find_element(const LogDescription *d, const char *name);
const LogMachine *log_find_machine(const LogDescription *d, const char *name);
const LogMachine *log_machine_by_number(const LogDescription *d, uint16_t number);
// Returns the machine of event STATE, with the names of the image that ran then.  NULL: the log does not contain the machine.
const LogMachine *log_machine_of_event(Arena *arena, const LogSession *s, const LogEvent *e);
const char *log_kind_name(const LogDescription *d, uint8_t kind);                     // name of a kind of events; NULL: the log names none
const char *log_state_name(Arena *arena, const LogMachine *m, uint32_t state);        // its name, or "state 7" if it has none
const char *log_swap_refusal(uint32_t reason);        // why a swap was refused, from an event

// ---- inside: flight_log_description.c ----

// Parses the contents of a description whose checksum is right.  False if it is inconsistent or its version is unknown.
bool log_parse_description(Arena *arena, const uint8_t *bytes, uint32_t n, LogDescription *d);
// Parses the contents of a block of names.  False if it is inconsistent.
bool log_parse_names(Arena *arena, const uint8_t *bytes, uint32_t n, LogImage *image);

#endif
