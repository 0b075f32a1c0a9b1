// SPDX-License-Identifier: Apache-2.0
// A flight as a drawing: the states of a machine as bands, and elements below them, over time.  It reuses the plot of
// a script's run: the records of a session are distributed over the plot's slots of time.  A band begins at the exact time of its event,
// to the nanosecond.  The circle that marks this event on the curve of an element is at the last value in the slot of the event.
#include <string.h>

#include "compiler/report/flight.h"
#include "compiler/report/page_style.h"
#include "compiler/report/plot.h"

// A session being converted to a plot.
typedef struct FlightDrawing {
    const Flight *f;
    const LogSession *s;
    StrPool names;
    Program p;
    Trace t;
    double span;                  // duration in nanoseconds, including one period after the last record
} FlightDrawing;

// ---- time ----

// Returns the position of a time on the axis in slots, with fraction.
static double position_of_time(const FlightDrawing *d, uint64_t time)
{
    const double share = time <= d->s->first ? 0 : (double)(time - d->s->first) / d->span;

    return (share < 1 ? share : 1) * (double)d->t.steps;
}

// Returns the slot that contains a time.  Rounding can make the computed position up to a millionth of a slot too small.
static uint64_t slot_of_time(const FlightDrawing *d, uint64_t time)
{
    const uint64_t slot = (uint64_t)(position_of_time(d, time) + 1e-6);

    return slot < d->t.steps ? slot : d->t.steps - 1;
}

// Distributes the records over the slots of the plot: one slot each, or TRACE_BUCKETS slots for more records.
static void init_time_axis(FlightDrawing *d)
{
    const uint64_t n = d->s->records;
    const double length = (double)(d->s->last - d->s->first);

    d->span = length > 0 && n > 1 ? length / (double)(n - 1) * (double)n : 1;
    d->t.steps = n < TRACE_BUCKETS ? n : TRACE_BUCKETS;
    d->t.per = 1;
    d->t.first_g = d->s->first;
    d->t.last_g = d->s->first + (uint64_t)(d->span * ((double)(d->t.steps - 1) / (double)d->t.steps));
    d->t.unit = 1e-9;
    d->t.axis = "Time since the application started, s";
}

// ---- elements ----

// Adds a value to the range that a slot of time (one column of the plot) shows. `first`: the slot is still empty.
static void add_value(TraceBucket *b, double x, bool first)
{
    if (first || b->first != b->first)
        *b = (TraceBucket){x, x, x, x};
    if (x != x)                                   // a slot with numbers and NaN shows only the numbers
        return;
    b->lo = x < b->lo ? x : b->lo;
    b->hi = x > b->hi ? x : b->hi;
    b->last = x;
}

// Stores the values of an element in the slots of its series.  A slot without a record repeats the last value before it.
static void fill_series(FlightDrawing *d, TraceSeries *series, const LogElement *e)
{
    bool *filled = ARENA_ARRAY(d->f->arena, bool, (size_t)d->t.steps);        // by slot: some record falls into it

    for (size_t i = 0; i < d->s->item.n; i++) {
        const LogItem *item = &d->s->item.at[i];
        if (item->kind == ITEM_RECORD) {
            const size_t slot = (size_t)slot_of_time(d, log_read_time(item));
            const double x = flight_value(e->type, log_read_cell(item, e));
            add_value(&series->at[slot], x, !filled[slot]);
            filled[slot] = true;
            series->infinite = series->infinite || (x == x && x - x != 0);
            series->nan = series->nan || x != x;
        }
    }
    for (uint64_t k = 1; k < d->t.steps; k++)             // a slot without a record repeats the last value before it
        if (!filled[k])
            add_value(&series->at[k], series->at[k - 1].last, true);
    for (uint64_t k = 0; k < d->t.steps; k++)
        series->changes = series->changes || series->at[k].lo != series->at[0].first || series->at[k].hi != series->at[0].first;
}

// Adds an element of the log as a series of the plot, with a variable made up for it, because the plot expects a program.
static void add_series(FlightDrawing *d, const LogElement *e)
{
    TraceSeries *series = ARENA_NEW(d->f->arena, TraceSeries);
    Var *v = ARENA_NEW(d->f->arena, Var);

    v->kind = VAR_ELEMENT;
    v->type = e->type;
    v->name = str_c(&d->names, e->name);
    series->v = v;
    fill_series(d, series, e);
    series->changes = series->changes || d->f->elements > 0;      // elements that the user asked for are always drawn
    vec_push(d->f->arena, &d->t.series, series);
}

static bool is_state_element(const FlightDrawing *d, const LogElement *e)
{
    return d->f->elements == 0 && d->f->machine && d->f->machine->s != LOG_NONE && e == &d->s->d->element[d->f->machine->s];
}

// ---- states ----

// Returns the number of a state in the drawing; 0 if it has none of that name.
static uint32_t drawn_state(const FlightDrawing *d, const char *name)
{
    for (size_t i = 0; i < d->p.state.n; i++)
        if (strcmp(d->p.state.at[i]->name->text, name) == 0)
            return (uint32_t)i + 1;
    return 0;
}

// Adds a state to the made-up program of the plot; its number is its position in the list.
static void add_state(FlightDrawing *d, const char *name)
{
    State *s = ARENA_NEW(d->f->arena, State);

    s->name = str_c(&d->names, name);
    vec_push(d->f->arena, &d->p.state, s);
    s->number = (uint32_t)d->p.state.n;
}

// Adds the states of the machine, and those that only images have that replaced it.
static void add_states(FlightDrawing *d)
{
    const LogMachine *m = d->f->machine;

    for (uint32_t i = 1; m && i <= m->state.n; i++)
        add_state(d, log_state_name(d->f->arena, m, i));
    for (size_t i = 0; m && i < d->s->image.n; i++)
        for (uint32_t k = 0; d->s->image.at[i].machine == m->number && k < d->s->image.at[i].state.n; k++)
            if (drawn_state(d, d->s->image.at[i].state.name[k]) == 0)
                add_state(d, d->s->image.at[i].state.name[k]);
    d->t.entered = ARENA_ARRAY(d->f->arena, uint64_t, d->p.state.n + 1);
}

static bool was_swapped(const FlightDrawing *d, const LogMachine *m)
{
    for (size_t i = 0; i < d->s->swap.n; i++)
        if (d->s->swap.at[i].machine == m->number)
            return true;
    return false;
}

// Returns the number in the drawing of the state that event e leads to.
static uint32_t state_of_event(const FlightDrawing *d, const LogEvent *e)
{
    const LogMachine *m = log_machine_of_event(d->f->arena, d->s, e);

    return m == d->f->machine ? e->b : drawn_state(d, log_state_name(d->f->arena, m, e->b));
}

// Adds the entry of a state at `time`. All visits are counted, the first TRACE_VISITS_MAX are drawn.
static void add_visit(FlightDrawing *d, uint32_t state, uint64_t time)
{
    TraceVisit v = {NULL, slot_of_time(d, time), time, position_of_time(d, time)};

    if (state < 1 || state > d->p.state.n)
        return;
    v.state = d->p.state.at[state - 1];
    d->t.entered[state - 1]++;
    if (d->t.visits++ < TRACE_VISITS_MAX)
        vec_push(d->f->arena, &d->t.visit, v);
}

// Adds the visits of the machine's states. Events have their exact times. If some are missing, the visits come from the element that stores the
// number of the state, at the times of records.
static void add_visits(FlightDrawing *d)
{
    const LogMachine *m = d->f->machine;
    uint64_t last = 0;            // number of the state in the previous record

    if (!m)
        return;
    if ((d->s->lost == 0 && d->f->log->damaged == 0) || m->s == LOG_NONE)
        for (size_t i = 0; i < d->s->item.n; i++)
            for (uint32_t k = 0; d->s->item.at[i].kind == ITEM_EVENTS && k < d->s->item.at[i].n; k++) {
                const LogEvent e = log_read_event(&d->s->item.at[i], k);
                if (e.kind == LOG_EVENT_STATE && e.source == m->number)
                    add_visit(d, state_of_event(d, &e), e.time);
            }
    if (d->t.visits > 0 || m->s == LOG_NONE || was_swapped(d, m))      // after a swap, a number in the element can mean another state
        return;
    for (size_t i = 0; i < d->s->item.n; i++) {
        const LogItem *item = &d->s->item.at[i];
        const uint64_t now = item->kind == ITEM_RECORD ? log_read_cell(item, &d->s->d->element[m->s]) : last;
        if (now != last && now <= d->p.state.n)
            add_visit(d, (uint32_t)now, log_read_time(item));
        last = now;
    }
}

// ---- the file ----

// Writes the value of "--name" among the variables of the light page.
static void write_variable(Buf *out, const char *name, size_t n)
{
    const char *at = plot_style_light;

    while ((at = strstr(at, "--")) != NULL)
        if (strncmp(at, name, n) == 0 && at[n] == ':') {
            buf_put(out, at + n + 1, strcspn(at + n + 1, ";}"));
            return;
        } else {
            at += 2;
        }
}

// Writes the rules with variables replaced by their values, for viewers that do not support variables.
static void write_style(Buf *out)
{
    const char *at = plot_style, *next;

    while ((next = strstr(at, "var(")) != NULL) {
        const size_t n = strcspn(next + 4, ")");
        buf_put(out, at, (size_t)(next - at));
        write_variable(out, next + 4, n);
        at = next + 4 + n + 1;
    }
    buf_str(out, at);
}

static void write_drawing(const FlightDrawing *d, Buf *out)
{
    Buf body;
    const long high = plot_draw_body(d->f->arena, &d->t, &body);

    buf_printf(out, "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"plot smc-flight\" width=\"%d\" height=\"", PLOT_WIDE / 10);
    plot_write_tenths(out, high + PLOT_GAP);
    buf_printf(out, "\" viewBox=\"0 0 %d ", PLOT_WIDE / 10);
    plot_write_tenths(out, high + PLOT_GAP);
    buf_str(out, "\">\n<style>\n.plot text{font-family:Helvetica,Arial,sans-serif}\n");
    write_style(out);
    buf_printf(out, "</style>\n%s\n<rect width=\"100%%\" height=\"100%%\" fill=\"", plot_defs);
    write_variable(out, "--bg", 4);
    buf_str(out, "\"/>\n");
    buf_put(out, body.at, body.n);
    buf_str(out, "</svg>\n");
}

void flight_write_svg(const Flight *f, Buf *out)
{
    FlightDrawing *d = ARENA_NEW(f->arena, FlightDrawing);

    d->f = f;
    d->s = f->session;
    str_pool_init(&d->names, f->arena);
    d->t.arena = f->arena;
    d->t.p = &d->p;
    init_time_axis(d);
    add_states(d);
    add_visits(d);
    for (size_t i = 0; i < flight_element_count(f, d->s->d); i++)
        if (!is_state_element(d, flight_element(f, d->s->d, i)))
            add_series(d, flight_element(f, d->s->d, i));
    write_drawing(d, out);
}
