// SPDX-License-Identifier: Apache-2.0
// Exports a recorded session for other programs: as CSV, one line per record; as JSON, one line per record, event or gap, in file order.
// Numbers have enough digits to convert back to exactly the same value.
#include "compiler/base/json.h"
#include "compiler/report/flight.h"
#include "compiler/script/script.h"

static void write_cell(const LogItem *record, const LogElement *e, Buf *out)
{
    format_cell_shortest(out, e->type, log_read_cell(record, e));
}

// ---- CSV ----

void flight_write_csv(const Flight *f, Buf *out)
{
    const LogSession *s = f->session;
    size_t number = 1;

    while (number < f->log->session.n && f->log->session.at[number - 1] != s)
        number++;
    buf_str(out, "session,seconds");
    for (size_t i = 0; i < flight_element_count(f, s->d); i++)
        buf_printf(out, ",%s", flight_element(f, s->d, i)->name);
    buf_char(out, '\n');
    for (size_t i = 0; i < s->item.n; i++) {
        const LogItem *record = &s->item.at[i];
        if (record->kind != ITEM_RECORD)
            continue;
        buf_printf(out, "%lu,", (unsigned long)number);
        flight_write_time(out, log_read_time(record));
        for (size_t k = 0; k < flight_element_count(f, s->d); k++) {
            buf_char(out, ',');
            write_cell(record, flight_element(f, s->d, k), out);
        }
        buf_char(out, '\n');
    }
}

// ---- JSON ----

// Whether a cell can be written as a number in JSON: not NaN or infinite.
static bool is_finite_number(SmType type, uint64_t cell)
{
    const SmKind kind = sm_type_info[type].kind;

    if (kind != SM_KIND_FLOAT)
        return true;
    return type == SM_F32 ? (cell >> 23 & 0xff) != 0xff : (cell >> 52 & 0x7ff) != 0x7ff;
}

static void write_record(const Flight *f, const LogSession *s, const LogItem *record, Buf *out)
{
    buf_str(out, "{\"time\":");
    flight_write_time(out, log_read_time(record));
    for (size_t i = 0; i < flight_element_count(f, s->d); i++) {
        const LogElement *e = flight_element(f, s->d, i);
        const bool plain = is_finite_number(e->type, log_read_cell(record, e));
        buf_str(out, i ? "," : ",\"values\":{");
        json_put_string(out, e->name);
        buf_str(out, plain ? ":" : ":\"");
        write_cell(record, e, out);
        buf_str(out, plain ? "" : "\"");
    }
    buf_str(out, flight_element_count(f, s->d) ? "}}\n" : "}\n");
}

static void write_event(const Flight *f, const LogSession *s, const LogEvent *e, Buf *out)
{
    Buf words;

    buf_init(&words, f->arena);
    flight_write_event(f, s, e, &words);
    buf_str(out, "{\"time\":");
    flight_write_time(out, e->time);
    buf_str(out, ",\"event\":");
    json_put_string(out, log_kind_name(s->d, e->kind));
    buf_printf(out, ",\"number\":%u,\"source\":%u,\"a\":%lu,\"b\":%lu,\"text\":", (unsigned)e->kind, (unsigned)e->source,
               (unsigned long)e->a, (unsigned long)e->b);
    json_put_string(out, buf_text(&words));
    buf_str(out, "}\n");
}

void flight_write_json(const Flight *f, Buf *out)
{
    const LogSession *s = f->session;

    for (size_t i = 0; i < s->item.n; i++) {
        const LogItem *item = &s->item.at[i];
        LogEvent e;
        LogGap gap;
        switch (item->kind) {
        case ITEM_RECORD: write_record(f, s, item, out); break;
        case ITEM_EVENTS:
            for (uint32_t k = 0; k < item->n; k++) {
                e = log_read_event(item, k);
                write_event(f, s, &e, out);
            }
            break;
        case ITEM_GAP:
            gap = log_read_gap(item);
            buf_printf(out, "{\"dropped\":%lu,\"lost\":%lu}\n", (unsigned long)gap.records, (unsigned long)gap.events);
            break;
        }
    }
}
