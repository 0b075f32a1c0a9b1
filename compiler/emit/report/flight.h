// SPDX-License-Identifier: Apache-2.0
// What `smc log` shows of a flight log: a summary in words, tables for other programs, a drawing.
#ifndef SMC_FLIGHT_H
#define SMC_FLIGHT_H

#include "compiler/base/buf.h"
#include "compiler/log/log.h"

typedef struct Flight {
    Arena *arena;
    const char *name;             // of the file
    const Log *log;
    const LogSession *session;    // the one that is shown; of text: NULL is all
    const LogElement *const *element;     // those that are shown, of that session; none: all
    size_t elements;
    const LogMachine *machine;    // whose states the drawing shows; or NULL
} Flight;

void flight_text(const Flight *f, Buf *out);
void flight_csv(const Flight *f, Buf *out);
void flight_json(const Flight *f, Buf *out);
void flight_svg(const Flight *f, Buf *out);

// ---- inside ----

// Nanoseconds as seconds, exactly: "12.05".
void flight_time(Buf *out, uint64_t ns);
// "mission: Coast -> Recovery", "task engine fails: it is in use".
void flight_event(const Flight *f, const LogDescription *d, const LogEvent *e, Buf *out);
// As the log has it: NaN is NaN here, and not the 0 that machines read.
double flight_number(SmType type, uint64_t cell);
size_t flight_elements(const Flight *f, const LogDescription *d);
const LogElement *flight_element(const Flight *f, const LogDescription *d, size_t i);

#endif
