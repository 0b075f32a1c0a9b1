// SPDX-License-Identifier: Apache-2.0
// Reads recorded data: rows of a CSV file with a header, of which one column is the time and others are values (language.md 8.54 to 8.70).
// Memory does not grow with the number of rows.
#ifndef SMC_RECORDING_H
#define SMC_RECORDING_H

#include "compiler/data/csv.h"
#include "compiler/syntax/time_unit.h"

// A column to read: value = cell * scale + offset.
typedef struct RecordingColumn {
    const char *name;         // the name in the header of the file
    bool is_scaled;           // false: value = cell, and the next two are not used
    double scale, offset;
} RecordingColumn;

typedef struct RecordingFormat {
    const char *time;         // name of the column with the times
    TimeUnit unit, g_unit;    // the unit of these times, and the unit to which they are converted
    bool whole_times;         // round times to whole units
    bool stop_at_bad_time;    // a row without a later time than the row before is an error; otherwise it is skipped
    bool missing_is_nan;      // a missing cell is NaN; otherwise it has the value of the row before
    const RecordingColumn *column;
    size_t columns;
} RecordingFormat;

typedef struct RecordingRow {
    uint64_t number, line;    // number of the row, from 1, bad ones included; the line in which it begins
    double time;              // 0 in the first row
    double *value;            // by column; NaN: the row has no value there
} RecordingRow;

// What is wrong with a file.  `column` is the index of the column that is concerned, RECORDING_TIME or RECORDING_FILE.
enum { RECORDING_TIME = -1, RECORDING_FILE = -2 };
typedef struct RecordingError { const char *text; uint64_t line; int column; } RecordingError;      // line 0: none; text NULL: no error

typedef struct Recording {
    const RecordingFormat *format;
    Arena *arena;
    Csv csv;
    size_t header_cells;
    size_t time_cell, *cell;  // index of the cell with the time in a record; by column: index of its cell
    double first_time;        // time of the first row, as in the file
    double last_time;         // time of the last row that was not bad
    uint64_t rows, bad_rows;  // rows read so far; how many of them had a bad time
    uint64_t first_bad_line;  // line of the first row with a bad time; 0: none
    RecordingError error;
} Recording;

// Opens a file and reads its header.  Returns false and sets r->error if it cannot be read, or lacks a column.
bool recording_open(Recording *r, Arena *arena, const DataFile *file, const RecordingFormat *format);
RecordingRow recording_new_row(Arena *arena, const RecordingFormat *format);
// Reads the next row into *row.  `before`: the row before it, for missing cells; NULL for the first.  Returns false at the end and after an
// error, which is then in r->error.
bool recording_next(Recording *r, const RecordingRow *before, RecordingRow *row);
double recording_no_value(void);                  // returns a NaN
void recording_close(Recording *r);

#endif
