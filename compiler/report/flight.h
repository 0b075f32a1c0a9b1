// SPDX-License-Identifier: Apache-2.0
// The output of `smc log` for a flight log: a summary in words, tables for other programs, a drawing.
#ifndef SMC_FLIGHT_H
#define SMC_FLIGHT_H

#include "compiler/base/buf.h"
#include "compiler/report/flight_log.h"

typedef struct Flight {
    Arena *arena;
    const char *name;             // name of the file
    const Log *log;
    const LogSession *session;    // the session to show; NULL, only for flight_write_text: all sessions
    const LogElement *const *element;     // the elements of the session to show
    size_t elements;              // length of `element`; 0: all elements of the session are shown
    const LogMachine *machine;    // the machine whose states are drawn; or NULL
} Flight;

void flight_write_text(const Flight *f, Buf *out);
void flight_write_csv(const Flight *f, Buf *out);
void flight_write_json(const Flight *f, Buf *out);
void flight_write_svg(const Flight *f, Buf *out);

// ---- internal ----

// Writes nanoseconds as seconds, exactly: "12.05".
void flight_write_time(Buf *out, uint64_t ns);
// Writes an event in words, as in "mission: Coast -> Recovery" and "task engine fails: it is in use".
void flight_write_event(const Flight *f, const LogSession *s, const LogEvent *e, Buf *out);
// Returns the value of a logged cell.  A NaN is returned as NaN, although machines read it as 0.
double flight_value(SmType type, uint64_t cell);
size_t flight_element_count(const Flight *f, const LogDescription *d);
const LogElement *flight_element(const Flight *f, const LogDescription *d, size_t i);

#endif
