// SPDX-License-Identifier: Apache-2.0
#include "compiler/data/csv.h"

#include <string.h>

#include "compiler/base/buf.h"

// ---- bytes ----

// Records an error.  Returns false.
static bool fail(Csv *c, uint64_t line, const char *error)
{
    c->error = error;
    c->error_line = line;
    return false;
}

static bool fail_nul(Csv *c) { return fail(c, c->next_line, "a NUL byte: the file is not text"); }

// Reads the next bytes of the file into the buffer.  Returns false at the end of the file, and after an error.
static bool read_buffer(Csv *c)
{
    const char *why = "";

    c->at = c->end = 0;
    while (!c->at_eof && c->end < CSV_BUFFER) {
        size_t got = 0;
        if (!c->stream.read(&c->stream, c->buffer + c->end, CSV_BUFFER - c->end, &got, &why))
            return fail(c, c->next_line, format_in(c->arena, "cannot read any further: %s", why));
        c->at_eof = got == 0;
        c->end += got;
    }
    return c->end > 0;
}

// Whether there is a next byte.  False at the end of the file, and after an error.
static bool fill(Csv *c) { return c->at < c->end || (!c->error && read_buffer(c)); }

static bool starts_with(const Csv *c, const char *bytes, size_t n) { return c->end >= n && memcmp(c->buffer, bytes, n) == 0; }

// Returns the character of , ; and tab that the first line contains most often outside quotes; a comma if the line contains none of them.
static char find_delimiter(const Csv *c)
{
    static const char choice[] = {',', ';', '\t'};
    size_t count[sizeof choice] = {0}, best = 0;
    bool quoted = false;

    for (size_t i = c->at; i < c->end && (quoted || (c->buffer[i] != '\n' && c->buffer[i] != '\r')); i++) {
        quoted = quoted != (c->buffer[i] == '"');
        for (size_t k = 0; k < sizeof choice; k++)
            count[k] += !quoted && c->buffer[i] == choice[k];
    }
    for (size_t k = 1; k < sizeof choice; k++)
        if (count[k] > count[best])
            best = k;
    return choice[best];
}

// Reads the start of the file: its byte order mark, and the delimiter.
static void begin_file(Csv *c)
{
    if (!fill(c))
        return;
    if (starts_with(c, "\xff\xfe", 2) || starts_with(c, "\xfe\xff", 2))
        fail(c, 1, "the file is UTF-16; save it as UTF-8");
    else if (starts_with(c, "\xef\xbb\xbf", 3))
        c->at = 3;
    c->delimiter = find_delimiter(c);
}

bool csv_open(Csv *c, Arena *arena, const DataFile *file)
{
    const char *why = "";

    memset(c, 0, sizeof *c);
    c->arena = arena;
    c->line = c->next_line = 1;
    if (!file->open(file, &c->stream, &why)) {
        c->error = why;
        return false;
    }
    c->is_open = true;
    c->buffer = arena_alloc_unzeroed(arena, CSV_BUFFER);
    c->capacity = 1024;
    c->text = arena_alloc_unzeroed(arena, c->capacity);
    c->cell_capacity = 64;
    c->cell = ARENA_ARRAY(arena, uint32_t, c->cell_capacity);
    return true;
}

void csv_close(Csv *c)
{
    if (c->is_open)
        c->stream.close(&c->stream);
    c->is_open = false;
}

// ---- a record ----

static bool fail_long_record(Csv *c) { return fail(c, c->line, format_in(c->arena, "the record is longer than %d bytes", CSV_RECORD_MAX)); }

// Appends bytes to the text of the current record.
static void add_bytes(Csv *c, const char *bytes, size_t n)
{
    while (c->capacity - c->size < n) {
        c->text = arena_grow(c->arena, c->text, c->capacity, 2 * c->capacity);
        c->capacity *= 2;
    }
    memcpy(c->text + c->size, bytes, n);
    c->size += n;
}

// Stores where the text of the next cell begins.
static void begin_cell(Csv *c)
{
    if (c->cells + 1 == c->cell_capacity) {
        c->cell = arena_grow(c->arena, c->cell, c->cell_capacity * sizeof *c->cell, 2 * c->cell_capacity * sizeof *c->cell);
        c->cell_capacity *= 2;
    }
    c->cell[c->cells] = (uint32_t)c->size;
}

// Ends the text of a cell with a NUL, and begins the next one.
static void end_cell(Csv *c)
{
    add_bytes(c, "", 1);
    c->cells++;
    begin_cell(c);
}

// Consumes the line end at the next byte, which is LF or CR.
static void consume_line_end(Csv *c)
{
    const bool is_cr = c->buffer[c->at++] == '\r';

    c->next_line++;
    if (is_cr && fill(c) && c->buffer[c->at] == '\n')
        c->at++;
}

// Copies the bytes of an unquoted cell up to the next byte that can end it, or the end of the buffer.
static void copy_plain(Csv *c)
{
    const char delimiter = c->delimiter, *from = c->buffer + c->at, *end = c->buffer + c->end, *at = from;

    while (at < end && *at != delimiter && *at != '\n' && *at != '\r' && *at != '\0')
        at++;
    add_bytes(c, from, (size_t)(at - from));
    c->at += (size_t)(at - from);
}

// Reads a cell after its opening quote, through its closing quote.  Returns false after an error.
static bool read_quoted(Csv *c)
{
    const uint64_t opened = c->next_line;

    while (fill(c) && c->size <= CSV_RECORD_MAX) {
        const char byte = c->buffer[c->at++];
        if (byte == '\0')
            return fail_nul(c);
        if (byte == '"' && !(fill(c) && c->buffer[c->at] == '"'))
            return !c->error;
        c->at += byte == '"';
        c->next_line += byte == '\n' || (byte == '\r' && !(fill(c) && c->buffer[c->at] == '\n'));
        add_bytes(c, &byte, 1);
    }
    return c->error ? false : fail(c, opened, "a quote that opens here is not closed");
}

// Reads a cell, and the delimiter or the line end after it.  Sets *is_last if it ends the record.  Returns false after an error.
static bool read_cell(Csv *c, bool *is_last)
{
    const bool is_quoted = fill(c) && c->buffer[c->at] == '"';

    if (is_quoted) {
        c->at++;
        if (!read_quoted(c))
            return false;
    }
    while (fill(c)) {
        const char byte = c->buffer[c->at];
        if (byte == c->delimiter) {
            c->at++;
            end_cell(c);
            return true;
        }
        if (byte == '\n' || byte == '\r') {
            consume_line_end(c);
            break;
        }
        if (byte == '\0')
            return fail_nul(c);
        if (is_quoted)
            return fail(c, c->next_line, "text after the closing quote of a cell");
        copy_plain(c);
        if (c->size > CSV_RECORD_MAX)
            return fail_long_record(c);
    }
    end_cell(c);
    *is_last = true;
    return !c->error;
}

// Reads a record.  Returns false after an error.
static bool read_record(Csv *c)
{
    bool is_last = false;

    c->line = c->next_line;
    c->size = c->cells = 0;
    begin_cell(c);
    while (!is_last) {
        if (!read_cell(c, &is_last))
            return false;
        if (c->size > CSV_RECORD_MAX)
            return fail_long_record(c);
    }
    return true;
}

// Whether the current record is an empty line.
static bool is_blank(const Csv *c) { return c->cells == 1 && c->size == 1; }

CsvResult csv_next(Csv *c)
{
    if (!c->delimiter)
        begin_file(c);
    while (fill(c)) {
        if (c->error || !read_record(c))
            return CSV_ERROR;
        if (!is_blank(c))
            return CSV_RECORD;
    }
    return c->error ? CSV_ERROR : CSV_END;
}
