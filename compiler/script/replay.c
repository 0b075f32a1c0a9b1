// SPDX-License-Identifier: Apache-2.0
#include "compiler/script/replay.h"

#include <inttypes.h>
#include <string.h>

#include "compiler/data/recording.h"
#include "compiler/script/ref.h"

// ---- cursors ----

// A position in the data: the last row at or before a time, and the row after it.
typedef struct Cursor {
    uint64_t delay;           // the cursor reads the data at time G - delay
    Recording file;
    RecordingFormat format;
    RecordingColumn *column;  // the columns of the data that the script declares
    Span *span;               // by column: position of its name in the script
    RecordingRow now, next;   // the last row at or before the cursor's time; the row after it
    bool has_now, has_next;   // whether these rows exist
    uint64_t between;         // number of rows that were skipped because they are between the times of two successive steps
} Cursor;

// A @compare of the script.
typedef struct ReplayCompare {
    const ScriptCompare *of;  // its definition
    Cursor *cursor;
    size_t column;            // index in cursor->column
    CompareResult result;
} ReplayCompare;

struct Replay {
    Arena *arena;
    Diags *diags;
    const Script *s;
    const ScriptData *d;
    Cursor **cursor;          // one for each delay; the first has delay 0 and reads the columns that the script writes to inputs
    size_t cursors;
    ReplayCompare *compare;      // by @compare of the script: its state
    double *recorded;         // by @compare: the recorded value that the last step was compared with; NaN: none
};

static double to_double(SmF64 x) { return ref_read(SM_F64, sm_bits(x)); }

// Adds a column to a cursor.  Returns its index.
static size_t add_column(Cursor *c, const ScriptColumn *in)
{
    const size_t i = c->format.columns++;

    c->column[i] = (RecordingColumn){in->name->text, in->is_scaled, to_double(in->scale), to_double(in->offset)};
    c->span[i] = in->span;
    return i;
}

// Adds a cursor: columns with different delays are read at different times, so each delay has its own position in the file.
static Cursor *add_cursor(Replay *r, uint64_t delay)
{
    Cursor *c = ARENA_NEW(r->arena, Cursor);
    const size_t most = r->d->column.n + r->d->compare.n;

    c->delay = delay;
    c->column = ARENA_ARRAY(r->arena, RecordingColumn, most);
    c->span = ARENA_ARRAY(r->arena, Span, most);
    c->format = (RecordingFormat){.time = r->d->time->text, .unit = r->d->unit, .g_unit = r->s->program->time_unit, .whole_times = r->s->by_rows,
                                  .stop_at_bad_time = r->d->stops_at_bad_time, .missing_is_nan = r->d->missing_is_nan, .column = c->column};
    r->cursor[r->cursors++] = c;
    return c;
}

// Returns the cursor for a delay; adds it if no @compare before has this delay.
static Cursor *find_cursor(Replay *r, uint64_t delay)
{
    for (size_t i = 0; i < r->cursors; i++)
        if (r->cursor[i]->delay == delay)
            return r->cursor[i];
    return add_cursor(r, delay);
}

// Adds the cursors that the columns of the script need, and opens nothing.
static void add_cursors(Replay *r)
{
    Cursor *first = add_cursor(r, 0);

    for (size_t i = 0; i < r->d->column.n; i++)
        add_column(first, &r->d->column.at[i]);
    for (size_t i = 0; i < r->d->compare.n; i++) {
        const ScriptCompare *of = &r->d->compare.at[i];
        Cursor *c = find_cursor(r, of->delay);
        r->compare[i] = (ReplayCompare){.of = of, .cursor = c, .column = add_column(c, &of->column)};
    }
}

// ---- reading ----

// Returns "flight.csv:17".
static const char *format_place(const Replay *r, uint64_t line)
{
    return line ? format_in(r->arena, "%s:%" PRIu64, r->d->source->name, line) : r->d->source->name;
}

// Reports the error of a file.  Returns false.
static bool report_error(const Replay *r, const Cursor *c)
{
    const RecordingError *e = &c->file.error;
    const Span span = e->column == RECORDING_FILE ? r->d->file_span : e->column == RECORDING_TIME ? r->d->time_span : c->span[e->column];

    script_note_include(r->diags, r->s, diag_report(r->diags, DIAG_data_wrong, span, format_place(r, e->line), e->text));
    return false;
}

// Reads the row after c->next, which becomes c->now.
static bool read_next(const Replay *r, Cursor *c)
{
    const RecordingRow was = c->now;

    c->now = c->next;
    c->next = was;
    c->has_now = true;
    c->has_next = recording_next(&c->file, &c->now, &c->next);
    return !c->file.error.text || report_error(r, c);
}

static bool open_cursor(const Replay *r, Cursor *c)
{
    if (!recording_open(&c->file, r->arena, r->d->source, &c->format))
        return report_error(r, c);
    c->now = recording_new_row(r->arena, &c->format);
    c->next = recording_new_row(r->arena, &c->format);
    c->has_next = recording_next(&c->file, NULL, &c->next);
    if (c->file.error.text)
        return report_error(r, c);
    if (c->has_next)
        return true;
    c->file.error = (RecordingError){"the file has no row with a time", 0, RECORDING_FILE};
    return report_error(r, c);
}

// Moves a cursor to a time, so that c->now is the last row at or before it.
static bool move_cursor(const Replay *r, Cursor *c, uint64_t time)
{
    const double t = ref_read(SM_U64, time);
    uint64_t passed = 0;

    for (; c->has_next && c->next.time <= t; passed++)
        if (!read_next(r, c))
            return false;
    c->between += passed > 1 ? passed - 1 : 0;
    return true;
}

// Returns the value of column i at time t, to which the cursor has been moved; NaN: the column has no value there.
static double interpolate(const Cursor *c, size_t i, double t)
{
    const double a = c->now.value[i], b = c->has_next ? c->next.value[i] : a, from = c->now.time;
    double whole, part, share, rise;

    if (!c->has_next)
        return a;
    whole = c->next.time - from;
    part = t - from;
    share = part / whole;
    rise = (b - a) * share;
    return a + rise;
}

// ---- the run ----

static Replay *new_replay(Arena *arena, Diags *diags, const Script *s)
{
    Replay *r = ARENA_NEW(arena, Replay);

    r->arena = arena;
    r->diags = diags;
    r->s = s;
    r->d = s->data;
    r->cursor = ARENA_ARRAY(arena, Cursor *, s->data->compare.n + 1);
    r->compare = ARENA_ARRAY(arena, ReplayCompare, s->data->compare.n);
    r->recorded = ARENA_ARRAY(arena, double, s->data->compare.n);
    add_cursors(r);
    return r;
}

bool replay_check(Arena *arena, Diags *diags, const Script *s)
{
    const Replay *r = new_replay(arena, diags, s);
    bool good = true;

    for (size_t i = 0; i < r->cursors && good; i++) {
        Cursor *c = r->cursor[i];
        good = recording_open(&c->file, arena, s->data->source, &c->format) || report_error(r, c);
        recording_close(&c->file);
    }
    return good;
}

Replay *replay_open(Arena *arena, Diags *diags, const Script *s)
{
    Replay *r = new_replay(arena, diags, s);

    for (size_t i = 0; i < r->cursors; i++)
        if (!open_cursor(r, r->cursor[i])) {
            replay_close(r);
            return NULL;
        }
    return r;
}

void replay_close(Replay *r)
{
    for (size_t i = 0; i < r->cursors; i++)
        recording_close(&r->cursor[i]->file);
}

bool replay_advance(Replay *r, uint64_t g, void (*write)(void *context, const Var *v, double value), void *context)
{
    Cursor *c = r->cursor[0];
    const double t = ref_read(SM_U64, g);

    if (!move_cursor(r, c, g))
        return false;
    for (size_t i = 0; i < r->d->column.n; i++) {
        const Var *v = r->d->column.at[i].var;
        const double x = r->d->is_linear && v->type != SM_BOOL ? interpolate(c, i, t) : c->now.value[i];
        const bool has_value = c->now.value[i] == c->now.value[i];    // x can be NaN although it has: between two infinities
        if (has_value || r->d->missing_is_nan)
            write(context, v, x);
    }
    return true;
}

bool replay_find_next_time(const Replay *r, uint64_t *g)
{
    const Cursor *c = r->cursor[0];

    if (c->has_next)
        *g = ref_convert(SM_U64, c->next.time);
    return c->has_next && *g < UINT64_MAX;
}

// ---- comparing ----

// Adds G to the list of times at which an element differs from the recording, or extends the last entry.
static void add_span(CompareResult *c, uint64_t g, bool continues)
{
    if (!continues && c->spans++ < COMPARE_SPANS_MAX)
        c->span[c->spans - 1] = (CompareSpan){g, g};
    else if (c->spans <= COMPARE_SPANS_MAX)
        c->span[c->spans - 1].to = g;
}

// Compares an element with the recorded value, and counts where they differ by more than the tolerance.
static void compare_values(ReplayCompare *k, uint64_t g, double element, double recorded)
{
    const RecordingRow *row = &k->cursor->now;
    const double difference = element == recorded ? 0 : element > recorded ? element - recorded : recorded - element;
    const ComparePoint point = {g, row->number, row->line, element, recorded, difference};
    CompareResult *c = &k->result;
    const bool differed = c->differs;

    c->steps++;
    c->differs = !(point.difference <= to_double(k->of->tolerance));
    if (!c->differs)
        return;
    add_span(c, g, differed);
    if (c->failed++ == 0)
        c->first = c->worst = point;
    if (point.difference > c->worst.difference)
        c->worst = point;
}

bool replay_compare(Replay *r, uint64_t g, const uint64_t *cell)
{
    const double no_value = recording_no_value();

    for (size_t i = 0; i < r->d->compare.n; i++) {
        ReplayCompare *k = &r->compare[i];
        const Var *v = k->of->column.var;

        r->recorded[i] = no_value;
        if (g < k->of->delay)
            continue;
        if (!move_cursor(r, k->cursor, g - k->of->delay))
            return false;
        r->recorded[i] = k->cursor->now.value[k->column];
        if (r->recorded[i] == r->recorded[i])
            compare_values(k, g, ref_read(v->type, cell[v->index]), r->recorded[i]);
    }
    return true;
}

const double *replay_recorded(const Replay *r) { return r->recorded; }

// ---- results ----

bool replay_differs(const Replay *r)
{
    for (size_t i = 0; i < r->d->compare.n; i++)
        if (r->compare[i].result.failed)
            return true;
    return false;
}

void replay_set_result(const Replay *r, ScriptResult *result)
{
    const Cursor *c = r->cursor[0];
    CompareResult *all = ARENA_ARRAY(r->arena, CompareResult, r->d->compare.n);

    for (size_t i = 0; i < r->d->compare.n; i++) {
        all[i] = r->compare[i].result;
        result->asserts_passed += all[i].steps > 0 && all[i].failed == 0;
    }
    result->compare = all;
    result->data_file = r->d->source->name;
    result->data_rows = c->file.rows;
    result->data_bad_rows = c->file.bad_rows;
    result->data_first_bad_line = c->file.first_bad_line;
    result->data_between = c->between;
}

static const char *count(const Replay *r, uint64_t n) { return format_in(r->arena, "%" PRIu64, n); }

static const char *value_text(const Replay *r, const ReplayCompare *k, double x)
{
    Buf out;

    buf_init(&out, r->arena);
    if (k->of->column.var->type == SM_BOOL && (x == 0 || x == 1))
        buf_str(&out, x == 0 ? "false" : "true");
    else
        format_number_shortest(&out, x);
    return buf_text(&out);
}

// Adds the first and the largest difference of a @compare to its report.
static void add_points(const Replay *r, const ReplayCompare *k, Diag *d)
{
    const ComparePoint *first = &k->result.first, *worst = &k->result.worst;
    Buf difference;

    diag_label(r->diags, d, DIAG_label_compare_first, count(r, first->g), count(r, first->row), format_place(r, first->line),
               value_text(r, k, first->element), value_text(r, k, first->recorded));
    buf_init(&difference, r->arena);
    format_number_shortest(&difference, worst->difference);
    if (worst->difference > first->difference)
        diag_note(r->diags, d, (Span){0}, DIAG_note_compare_worst, buf_text(&difference), count(r, worst->g), count(r, worst->row),
                  format_place(r, worst->line), value_text(r, k, worst->element), value_text(r, k, worst->recorded));
}

void compare_write_spans(const CompareResult *c, Buf *out)
{
    for (uint64_t i = 0; i < c->spans && i < COMPARE_SPANS_MAX; i++) {
        buf_printf(out, "%sG = %" PRIu64, i ? ", " : "", c->span[i].from);
        if (c->span[i].to > c->span[i].from)
            buf_printf(out, " to %" PRIu64, c->span[i].to);
    }
    if (c->spans > COMPARE_SPANS_MAX)
        buf_printf(out, " and %" PRIu64 " more times", c->spans - COMPARE_SPANS_MAX);
}

static void report_difference(const Replay *r, const ReplayCompare *k, const ScriptResult *result)
{
    const ScriptColumn *column = &k->of->column;
    Diag *d = diag_report(r->diags, DIAG_compare_failed, column->span, column->var->name->text, column->name->text, count(r, k->result.failed),
                          count(r, k->result.steps));
    Buf spans;

    script_note_include(r->diags, r->s, d);
    add_points(r, k, d);
    buf_init(&spans, r->arena);
    compare_write_spans(&k->result, &spans);
    diag_note(r->diags, d, (Span){0}, DIAG_note_compare_spans, buf_text(&spans));
    if (result->is_random)
        diag_note(r->diags, d, (Span){0}, DIAG_note_seed, count(r, result->seed));
}

void replay_report(const Replay *r, bool judged, const ScriptResult *result)
{
    const Recording *file = &r->cursor[0]->file;

    if (file->bad_rows && !file->error.text && !r->d->skips_bad_times)
        script_note_include(r->diags, r->s, diag_report(r->diags, DIAG_data_bad_times, r->d->time_span, count(r, file->bad_rows),
                                                        count(r, file->rows), format_place(r, file->first_bad_line)));
    for (size_t i = 0; judged && i < r->d->compare.n; i++) {
        const ReplayCompare *k = &r->compare[i];
        if (k->result.failed)
            report_difference(r, k, result);
        else if (k->result.steps == 0)
            script_note_include(r->diags, r->s, diag_report(r->diags, DIAG_compare_never, k->of->column.span));
    }
}
