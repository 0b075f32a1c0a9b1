// SPDX-License-Identifier: Apache-2.0
// Reads the records of a CSV file (RFC 4180) one after the other, in memory that does not grow with the file.
//
// - Cells are separated by commas, semicolons or tabs: by the one that the first record contains most often.
// - Records end with LF, CR LF or CR.  Empty lines are skipped.
// - A cell that begins with a quote ends at the next single quote.  In it, two quotes are one, and line ends are text.
// - A UTF-8 byte order mark is skipped.  UTF-16 and NUL bytes are errors.
#ifndef SMC_CSV_H
#define SMC_CSV_H

#include <stdint.h>

#include "compiler/base/arena.h"
#include "compiler/data/data_file.h"

enum { CSV_RECORD_MAX = 1 << 20, CSV_BUFFER = 1 << 16 };      // maximum bytes of a record; bytes read at once

typedef enum CsvResult { CSV_RECORD, CSV_END, CSV_ERROR } CsvResult;

typedef struct Csv {
    Arena *arena;
    DataStream stream;
    char *buffer;             // CSV_BUFFER bytes, of which at … end - 1 are not yet read
    size_t at, end;
    bool is_open, at_eof;
    char delimiter;           // known after the first record
    uint64_t line;            // the line in which the current record begins, from 1
    uint64_t next_line;       // the line of the next byte
    char *text;               // the cells of the current record, each followed by a NUL
    size_t size, capacity;
    uint32_t *cell;           // cell i is text[cell[i]] … text[cell[i + 1] - 2]
    size_t cells, cell_capacity;
    uint64_t error_line;      // after CSV_ERROR: the line, 0: none
    const char *error;        // after CSV_ERROR: a sentence without a full stop
} Csv;

// Opens a file.  Returns false and sets c->error if it cannot be read.
bool csv_open(Csv *c, Arena *arena, const DataFile *file);
CsvResult csv_next(Csv *c);                       // reads the next record
void csv_close(Csv *c);                           // can be called more than once

static inline char *csv_cell(const Csv *c, size_t i) { return c->text + c->cell[i]; }
static inline size_t csv_cell_length(const Csv *c, size_t i) { return c->cell[i + 1] - c->cell[i] - 1; }

#endif
