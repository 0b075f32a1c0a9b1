// SPDX-License-Identifier: Apache-2.0
// A flight log in words: duration, size, events, and the range of each element.
#include <string.h>

#include "compiler/report/describe.h"
#include "compiler/report/flight.h"
#include "compiler/report/page.h"
#include "compiler/report/trace.h"
#include "stdlib/convert.h"
#include "stdlib/result.h"

// ---- shared ----

// Writes nanoseconds as seconds, exactly: "12.05".
void flight_write_time(Buf *out, uint64_t ns)
{
    unsigned long fraction = (unsigned long)(ns % 1000000000u);
    int digits = 9;

    buf_printf(out, "%llu", (unsigned long long)(ns / 1000000000u));
    if (fraction == 0)
        return;
    for (; fraction % 10 == 0; digits--)
        fraction /= 10;
    buf_printf(out, ".%0*lu", digits, fraction);
}

size_t flight_element_count(const Flight *f, const LogDescription *d) { return f->elements ? f->elements : d->elements; }

const LogElement *flight_element(const Flight *f, const LogDescription *d, size_t i)
{
    return f->elements ? f->element[i] : &d->element[i];
}

// ---- events ----

// Returns the name of a task or executor, or for example "task 3" if the log does not contain it.
static const char *numbered_name(const Flight *f, const LogNames *names, const char *what, uint16_t number)
{
    return number < names->n && names->name[number][0] ? format_in(f->arena, "%s %s", what, names->name[number])
                                                       : format_in(f->arena, "%s %u", what, (unsigned)number);
}

static const char *machine_name(const Flight *f, const LogDescription *d, uint16_t number)
{
    const LogMachine *m = log_machine_by_number(d, number);

    return m && m->name[0] ? m->name : format_in(f->arena, "machine %u", (unsigned)number);
}

static const char *mode_name(Arena *arena, uint32_t mode)
{
    static const char *const names[] = {"disabled", "safed", "enabled"};

    return mode < 3 ? names[mode] : format_in(arena, "mode %lu (safed)", (unsigned long)mode);
}

static void write_state_change(const Flight *f, const LogSession *s, const LogEvent *e, Buf *out)
{
    const LogMachine *m = log_machine_of_event(f->arena, s, e);

    buf_printf(out, "%s: ", machine_name(f, s->d, e->source));
    if (e->a == 0)
        buf_printf(out, "starts in %s", log_state_name(f->arena, m, e->b));
    else
        buf_printf(out, "%s -> %s", log_state_name(f->arena, m, e->a), log_state_name(f->arena, m, e->b));
}

// Returns the sentence of result -a.
static const char *result_text(uint32_t a) { return a <= 0x7FFFFFFF ? sm_result_text((SmResult)-(int32_t)a) : "?"; }

// Event of a task: a failure with its result, or (a = 0) the recovery after b failures.
static void write_fault(const Flight *f, const char *task, const LogEvent *e, Buf *out)
{
    if (e->a == 0)
        buf_printf(out, "%s recovered after %s", task, describe_count(f->arena, e->b, "failure", "failures"));
    else
        buf_printf(out, "%s failed: %s", task, result_text(e->a));
}

// Writes an event of a kind that this version does not know.
static void write_unknown_event(const LogDescription *d, const LogEvent *e, Buf *out)
{
    const char *name = log_kind_name(d, e->kind);

    buf_printf(out, "%s %u: source %u, a %lu, b %lu", name ? name : "event", (unsigned)e->kind, (unsigned)e->source, (unsigned long)e->a,
               (unsigned long)e->b);
}

// Event at the end of a swapped image's trial period. b identifies the image; a is how the trial ended.
static void write_trial_end(const Flight *f, const LogDescription *d, const LogEvent *e, Buf *out)
{
    static const char *const ends[] = {"?", "was confirmed", "was not confirmed in time", "entered a state marked @abort"};

    buf_printf(out, "%s: image %08lx %s", machine_name(f, d, e->source), (unsigned long)e->b, ends[e->a < 4 ? e->a : 0]);
}

// Writes an event in words, as in "mission: Coast -> Recovery" and "task engine fails: it is in use".
void flight_write_event(const Flight *f, const LogSession *s, const LogEvent *e, Buf *out)
{
    const LogDescription *d = s->d;
    static const char *const restored[] = {
        "", " with the saved state vector", "; the saved state vector could not be used: it is damaged or has another layout"};
    const char *task = numbered_name(f, &d->task, "task", e->source);

    switch (e->kind) {
    case LOG_EVENT_START:
        buf_printf(out, "the application started%s%s", restored[e->a < 2 ? e->a : 2], e->b ? ", after a watchdog reset" : "");
        break;
    case LOG_EVENT_STATE: write_state_change(f, s, e, out); break;
    case LOG_EVENT_MODE: buf_printf(out, "%s: %s -> %s", task, mode_name(f->arena, e->a), mode_name(f->arena, e->b)); break;
    case LOG_EVENT_FAULT: write_fault(f, task, e, out); break;
    case LOG_EVENT_OVERRUN:
        buf_printf(out, "%s was late by %lu us and skipped %s", numbered_name(f, &d->executor, "executor", e->source),
                   (unsigned long)e->b, describe_count(f->arena, e->a, "tick", "ticks"));
        break;
    case LOG_EVENT_REFUSED:
        buf_printf(out, "%s did not step because time did not advance (%s so far)", machine_name(f, d, e->source),
                   describe_count(f->arena, e->a, "time", "times"));
        break;
    case LOG_EVENT_SWAP:
        buf_printf(out, "%s: image %08lx was replaced by %08lx", machine_name(f, d, e->source), (unsigned long)e->a, (unsigned long)e->b);
        break;
    case LOG_EVENT_TRIAL: write_trial_end(f, d, e, out); break;
    case LOG_EVENT_SWAP_REFUSED:
        buf_printf(out, "%s was not replaced: %s", machine_name(f, d, e->source), log_swap_refusal(e->a));
        break;
    case LOG_EVENT_STORED:
        if (e->b == 0)
            buf_printf(out, "%s started with the stored image %08lx", machine_name(f, d, e->source), (unsigned long)e->a);
        else
            buf_printf(out, "%s did not start with the stored image: %s", machine_name(f, d, e->source), log_swap_refusal(e->b));
        break;
    case LOG_EVENT_NOT_STORED: buf_printf(out, "a confirmed swap could not be stored, so its trial goes on: %s", result_text(e->a)); break;
    case LOG_EVENT_HOST_REFUSED:
        buf_printf(out, "a request of a host was refused: %s (swap %08lx)", result_text(e->a), (unsigned long)e->b);
        break;
    case LOG_EVENT_STOP: buf_str(out, "the application was stopped"); break;
    default: write_unknown_event(d, e, out); break;
    }
}

// ---- the summary ----

static void write_events(const Flight *f, const LogSession *s, Buf *out)
{
    if (s->events)
        buf_str(out, "\n  events\n");
    for (size_t i = 0; i < s->item.n; i++)
        for (uint32_t k = 0; s->item.at[i].kind == ITEM_EVENTS && k < s->item.at[i].n; k++) {
            const LogEvent e = log_read_event(&s->item.at[i], k);
            buf_str(out, "    ");
            flight_write_time(out, e.time);
            buf_str(out, " s  ");
            flight_write_event(f, s, &e, out);
            buf_char(out, '\n');
        }
}

// ---- values ----

// Returns the value of a logged cell.
double flight_value(SmType type, uint64_t cell)
{
    unsigned char memory[8] = {0};
    float f = 0;
    double d = 0;

    sm_cell_store(type, memory, cell);
    if (type == SM_F32)
        memcpy(&f, memory, sizeof f);
    if (type == SM_F64)
        memcpy(&d, memory, sizeof d);
    return f != f ? (double)f : d != d ? d : trace_cell_value(type, cell);
}

// Writes the smallest, largest, first and last value of an element in the records of a session.
static void write_value_range(const Flight *f, const LogSession *s, const LogElement *e, Buf *out)
{
    uint64_t first = 0, last = 0, lo = 0, hi = 0, nans = 0;       // cells; lo and hi of numbers only
    bool any = false, any_number = false;

    for (size_t i = 0; i < s->item.n; i++) {
        uint64_t cell;
        double value;
        if (s->item.at[i].kind != ITEM_RECORD)
            continue;
        cell = log_read_cell(&s->item.at[i], e);
        value = flight_value(e->type, cell);
        first = any ? first : cell;
        last = cell;
        any = true;
        if (value != value) {
            nans++;
            continue;
        }
        if (!any_number || value < flight_value(e->type, lo))
            lo = cell;
        if (!any_number || value > flight_value(e->type, hi))
            hi = cell;
        any_number = true;
    }
    buf_printf(out, "    %-24s %-5s ", e->name, sm_type_info[e->type].spelling);
    if (any_number)
        buf_printf(out, "%s .. %s, from %s to %s", report_format_cell(f->arena, e->type, lo), report_format_cell(f->arena, e->type, hi),
                   report_format_cell(f->arena, e->type, first), report_format_cell(f->arena, e->type, last));
    if (nans)
        buf_printf(out, "%snan in %s", any_number ? ", " : "", describe_count(f->arena, nans, "record", "records"));
    buf_char(out, '\n');
}

static void write_session(const Flight *f, size_t number, const LogSession *s, Buf *out)
{
    buf_printf(out, "\nsession %lu: %s, %s, layout %08lx\n", (unsigned long)number, s->d->vector,
               describe_count(f->arena, s->d->elements, "element", "elements"), (unsigned long)s->d->layout);
    buf_printf(out, "  %s", describe_count(f->arena, s->records, "record", "records"));
    if (s->records > 0) {
        buf_str(out, " from ");
        flight_write_time(out, s->first);
        buf_str(out, " s to ");
        flight_write_time(out, s->last);
        buf_str(out, " s");
    }
    buf_printf(out, ", %s", describe_count(f->arena, s->events, "event", "events"));
    if (s->dropped)
        buf_printf(out, "; %s dropped", describe_count(f->arena, s->dropped, "record", "records"));
    if (s->lost)
        buf_printf(out, "; %s lost", describe_count(f->arena, s->lost, "event", "events"));
    buf_char(out, '\n');
    write_events(f, s, out);
    if (s->records == 0)
        return;
    buf_str(out, "\n  elements: minimum .. maximum, from first to last value\n");
    for (size_t i = 0; i < flight_element_count(f, s->d); i++)
        write_value_range(f, s, flight_element(f, s->d, i), out);
}

void flight_write_text(const Flight *f, Buf *out)
{
    const Log *log = f->log;

    buf_printf(out, "%s: %s, %s", f->name, describe_count(f->arena, log->size, "byte", "bytes"),
               describe_count(f->arena, log->session.n, "session", "sessions"));
    if (log->damaged)
        buf_printf(out, ", %s damaged in %s", describe_count(f->arena, log->damaged, "byte", "bytes"),
                   describe_count(f->arena, log->damaged_ranges, "place", "places"));
    if (log->unread)
        buf_printf(out, ", %s not read", describe_count(f->arena, log->unread, "byte", "bytes"));
    buf_char(out, '\n');
    for (size_t i = 0; i < f->log->session.n; i++)
        if (!f->session || f->session == f->log->session.at[i])
            write_session(f, i + 1, f->log->session.at[i], out);
}
