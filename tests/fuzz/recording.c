// SPDX-License-Identifier: Apache-2.0
// Fuzz target: a file with recorded data.  The first byte selects the settings, the rest is the file.  Nothing may crash or hang, the times of
// rows must increase from 0, and a second reader that receives the file in small pieces must read the same rows.
#include "compiler/data/recording.h"
#include "tests/fuzz/fuzz.h"

#include <string.h>

unsigned long fuzz_reached;           // inputs with at least one row
const unsigned fuzz_floor = 20;

// Reads a file 1 to 7 bytes at a time.
static bool read_pieces(DataStream *s, char *into, size_t n, size_t *got, const char **why)
{
    const DataMemory *m = s->self;
    const size_t piece = s->at % 7 + 1, left = m->size - s->at;

    (void)why;
    *got = piece < left ? piece : left;
    *got = *got < n ? *got : n;
    if (*got)
        memcpy(into, m->bytes + s->at, *got);
    s->at += *got;
    return true;
}

static void close_pieces(DataStream *s) { (void)s; }

static bool open_pieces(const DataFile *file, DataStream *s, const char **why)
{
    (void)why;
    *s = (DataStream){file->context, 0, read_pieces, close_pieces};
    return true;
}

static bool is_same(double a, double b) { return a == b || (a != a && b != b); }

static void check_same(const Recording *a, const RecordingRow *row_of_a, const Recording *b, const RecordingRow *row_of_b)
{
    FUZZ_CHECK(!a->error.text == !b->error.text && a->error.line == b->error.line && a->error.column == b->error.column);
    FUZZ_CHECK(a->rows == b->rows && a->bad_rows == b->bad_rows && a->first_bad_line == b->first_bad_line);
    if (a->error.text)
        return;
    FUZZ_CHECK(row_of_a->time == row_of_b->time && row_of_a->number == row_of_b->number && row_of_a->line == row_of_b->line);
    for (size_t i = 0; i < a->format->columns; i++)
        FUZZ_CHECK(is_same(row_of_a->value[i], row_of_b->value[i]));
}

static void read_rows(Arena *arena, Recording *a, Recording *b, const RecordingFormat *f)
{
    RecordingRow row[2] = {recording_new_row(arena, f), recording_new_row(arena, f)};
    RecordingRow same[2] = {recording_new_row(arena, f), recording_new_row(arena, f)};
    bool any = false, more;

    for (size_t i = 0;; i = 1 - i) {
        const double before = row[1 - i].time;
        more = recording_next(a, any ? &row[1 - i] : NULL, &row[i]);
        FUZZ_CHECK(recording_next(b, any ? &same[1 - i] : NULL, &same[i]) == more);
        if (!more)
            break;
        check_same(a, &row[i], b, &same[i]);
        FUZZ_CHECK(any ? row[i].time > before : row[i].time == 0);
        any = true;
    }
    check_same(a, &row[0], b, &row[0]);
    fuzz_reached += any;
}

static void read_file(Arena *arena, unsigned settings, const char *bytes, size_t n)
{
    const RecordingColumn column[] = {{"P", false, 1, 0}, {"Q", true, -0.1, 4}};
    const RecordingFormat f = {"t", settings & 1 ? TIME_S : TIME_MS, TIME_MS, settings & 2, settings & 4, settings & 8, column, 1 + (settings >> 4 & 1)};
    DataMemory whole, pieces;
    Recording a, b;
    bool opened;

    data_memory_init(&whole, "whole.csv", bytes, n);
    data_memory_init(&pieces, "pieces.csv", bytes, n);
    pieces.file.open = open_pieces;
    opened = recording_open(&a, arena, &whole.file, &f);
    FUZZ_CHECK(recording_open(&b, arena, &pieces.file, &f) == opened);
    if (opened)
        read_rows(arena, &a, &b, &f);
    recording_close(&a);
    recording_close(&b);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    Arena arena;
    jmp_buf oom;

    if (size == 0 || size > 1 << 21)
        return 0;
    arena_init(&arena, heap_alloc, NULL, &oom);
    if (setjmp(oom) == 0)
        read_file(&arena, data[0], (const char *)data + 1, size - 1);
    arena_free(&arena);
    return 0;
}
