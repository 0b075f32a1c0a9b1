// SPDX-License-Identifier: Apache-2.0
#include "compiler/data/recording.h"

#include <string.h>

#include "compiler/base/buf.h"
#include "compiler/base/str.h"
#include "compiler/base/utf8.h"
#include "compiler/syntax/number.h"

enum {
    NEAR_MOST = 3, NAMES_MOST = 12,       // maximum number of columns that a message proposes; that a message lists
    COMPARED_MOST = 4096,                 // columns that are compared with a name to find these
    SHOWN_MOST = 40                       // bytes of a cell that a message shows
};

// Records an error. column: index of the wanted column, RECORDING_TIME or RECORDING_FILE; line 0: none. Always returns false.
static bool fail(Recording *r, int column, uint64_t line, const char *text)
{
    r->error = (RecordingError){text, line, column};
    return false;
}

static bool fail_csv(Recording *r) { return fail(r, RECORDING_FILE, r->csv.error_line, r->csv.error); }

// ---- the text of a cell ----

// Returns the text of a cell of the CSV file for a message: cut to a readable length, with \xNN for bytes that are not UTF-8 or not visible.
static const char *show_cell(Arena *arena, const char *cell, size_t n)
{
    Buf out;

    buf_init(&out, arena);
    for (size_t i = 0; i < n;) {
        uint32_t code;
        const size_t length = utf8_decode(cell + i, n - i, &code);
        if (out.n > SHOWN_MOST) {
            buf_str(&out, "...");
            break;
        }
        if (length && !utf8_is_hidden(code))
            buf_put(&out, cell + i, length);
        else
            buf_printf(&out, "\\x%02x", (unsigned)(unsigned char)cell[i]);
        i += length && !utf8_is_hidden(code) ? length : 1;
    }
    return buf_text(&out);
}

// Removes blanks at both ends of a cell.
static void trim(char **cell, size_t *n)
{
    while (*n && (**cell == ' ' || **cell == '\t'))
        ++*cell, --*n;
    while (*n && ((*cell)[*n - 1] == ' ' || (*cell)[*n - 1] == '\t'))
        --*n;
}

static bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Whether a cell is a word, in capital or small letters.
static bool is_word(const char *cell, size_t n, const char *word)
{
    if (strlen(word) != n)
        return false;
    for (size_t i = 0; i < n; i++)
        if ((cell[i] | 0x20) != word[i])
            return false;
    return true;
}

// Whether a cell without its sign is a decimal number: digits, with a point anywhere, and an exponent.  If `comma`, the point can be a comma,
// which is replaced by a point.
static bool is_decimal(char *cell, size_t n, bool comma)
{
    size_t i = 0, digits = 0;

    for (; i < n && is_digit(cell[i]); i++)
        digits++;
    if (i < n && (cell[i] == '.' || (comma && cell[i] == ','))) {
        cell[i++] = '.';
        for (; i < n && is_digit(cell[i]); i++)
            digits++;
    }
    if (digits == 0)
        return false;
    if (i < n && (cell[i] == 'e' || cell[i] == 'E')) {
        i++;
        i += i < n && (cell[i] == '-' || cell[i] == '+');
        if (i == n)
            return false;
        while (i < n && is_digit(cell[i]))
            i++;
    }
    return i == n;
}

// Converts a number of the compiler (SmF64) to the double with the same bits.
static double to_double(SmF64 x)
{
    const uint64_t bits = sm_bits(x);
    double y;

    memcpy(&y, &bits, sizeof y);
    return y;
}

static double make_infinity(void) { return to_double(sm_from_bits(0x7ff0000000000000u)); }
double recording_no_value(void) { return to_double(sm_from_bits(0x7ff8000000000000u)); }

typedef enum CellKind { CELL_NUMBER, CELL_MISSING, CELL_WRONG, CELL_TOO_LARGE } CellKind;

// Reads cell i of the current record.  `unit`: TIME_NONE for a value; otherwise it is a time, to be converted to the unit of G.
static CellKind read_number(Recording *r, size_t i, TimeUnit unit, double *x)
{
    char *cell = csv_cell(&r->csv, i);
    size_t n = csv_cell_length(&r->csv, i);
    bool is_negative, fits;
    SmF64 value;

    trim(&cell, &n);
    is_negative = n > 0 && *cell == '-';
    if (n == 0 || is_word(cell, n, "nan") || is_word(cell, n, "-nan"))
        return CELL_MISSING;
    if (is_negative || *cell == '+')
        cell++, n--;
    if (!is_decimal(cell, n, r->csv.delimiter != ',')) {
        *x = is_word(cell, n, "true") ? 1 : is_word(cell, n, "inf") || is_word(cell, n, "infinity") ? make_infinity() : 0;
        if (*x == 0 && !is_word(cell, n, "false"))
            return CELL_WRONG;
        *x = is_negative ? -*x : *x;
        return CELL_NUMBER;
    }
    fits = unit == TIME_NONE ? number_to_f64(cell, n, &value) : time_to_f64(cell, n, unit, r->format->g_unit, &value);
    *x = is_negative ? -to_double(value) : to_double(value);
    return fits ? CELL_NUMBER : CELL_TOO_LARGE;
}

// Reports that cell i of the record is no number, or too large. column: the wanted column that it belongs to.
static bool fail_cell(Recording *r, int column, size_t i, CellKind kind)
{
    const char *cell = show_cell(r->arena, csv_cell(&r->csv, i), csv_cell_length(&r->csv, i));

    return fail(r, column, r->csv.line,
                format_in(r->arena, kind == CELL_TOO_LARGE ? "'%s' is too large for an F64" : "'%s' is not a number", cell));
}

// ---- the header ----

static bool is_equal_without_case(const char *a, const char *b)
{
    while (*a && (*a == *b || ((*a | 0x20) == (*b | 0x20) && (*a | 0x20) >= 'a' && (*a | 0x20) <= 'z')))
        a++, b++;
    return *a == *b;
}

// Returns the edit distance between a name in the header and `name`: 0 if they differ only in case, any number above `most` if it exceeds
// `most`.
static size_t name_distance(const char *name, const char *cell, size_t most)
{
    return *cell && is_equal_without_case(name, cell) ? 0 : *cell ? str_distance(name, cell, most + 1) : most + 1;
}

// Returns the names in the header that are most similar to `name`: "'P1' or 'P2'"; NULL if no name is similar.
static const char *find_near_names(Recording *r, const char *name)
{
    const size_t most = strlen(name) / 3;
    const char *list = NULL;
    size_t n = 0;

    for (size_t distance = 0; distance <= most; distance++)
        for (size_t i = 0; i < r->header_cells && i < COMPARED_MOST && n < NEAR_MOST; i++)
            if (name_distance(name, csv_cell(&r->csv, i), most) == distance) {
                const char *near = show_cell(r->arena, csv_cell(&r->csv, i), csv_cell_length(&r->csv, i));
                list = list ? format_in(r->arena, "%s or '%s'", list, near) : format_in(r->arena, "'%s'", near);
                n++;
            }
    return list;
}

static const char *list_names(Recording *r)
{
    Buf out;

    buf_init(&out, r->arena);
    for (size_t i = 0; i < r->header_cells && i < NAMES_MOST; i++)
        buf_printf(&out, "%s'%s'", i ? ", " : "", show_cell(r->arena, csv_cell(&r->csv, i), csv_cell_length(&r->csv, i)));
    if (r->header_cells > NAMES_MOST)
        buf_printf(&out, " and %lu more", (unsigned long)(r->header_cells - NAMES_MOST));
    return buf_text(&out);
}

// Reports that the header lacks a column, with similar names or the list of all.
static bool fail_unknown(Recording *r, const char *name, int column)
{
    const char *near = find_near_names(r, name);

    return fail(r, column, r->csv.line,
                near ? format_in(r->arena, "there is no column '%s'; did you mean %s?", name, near)
                     : format_in(r->arena, "there is no column '%s'; the header has %s", name, list_names(r)));
}

// Whether cell i of the header is this name, apart from blanks around it.
static bool is_header_name(const Recording *r, size_t i, const char *name)
{
    char *cell = csv_cell(&r->csv, i);
    size_t n = csv_cell_length(&r->csv, i);

    trim(&cell, &n);
    return strlen(name) == n && memcmp(cell, name, n) == 0;
}

// Finds the column of a name in the header, which is the current record.
static bool find_column(Recording *r, const char *name, int column, size_t *found)
{
    size_t n = 0;

    for (size_t i = r->header_cells; i-- > 0;)
        if (is_header_name(r, i, name)) {
            *found = i;
            n++;
        }
    if (n > 1)
        return fail(r, column, r->csv.line, format_in(r->arena, "%lu columns have the name '%s'", (unsigned long)n, name));
    return n == 1 || fail_unknown(r, name, column);
}

static bool is_utf8(const char *s, size_t n)
{
    uint32_t code;
    size_t length = 1;

    for (size_t i = 0; i < n && length; i += length)
        length = utf8_decode(s + i, n - i, &code);
    return length > 0;
}

// Whether the first record contains a number where a name is expected, so that it is no header.
static bool is_row_of_numbers(Recording *r)
{
    bool any = false;
    double x;

    for (size_t i = 0; i < r->header_cells; i++) {
        const CellKind kind = read_number(r, i, TIME_NONE, &x);
        if (kind == CELL_WRONG)
            return false;
        any = any || kind == CELL_NUMBER;
    }
    return any;
}

// Reads the header, and finds the time and every wanted column in it. Returns false after an error.
static bool read_header(Recording *r)
{
    const CsvResult result = csv_next(&r->csv);

    if (result == CSV_ERROR)
        return fail_csv(r);
    if (result == CSV_END)
        return fail(r, RECORDING_FILE, 0, "the file is empty");
    r->header_cells = r->csv.cells;
    if (!is_utf8(r->csv.text, r->csv.size))
        return fail(r, RECORDING_FILE, r->csv.line, "the header is not UTF-8");
    if (!find_column(r, r->format->time, RECORDING_TIME, &r->time_cell)) {
        if (is_row_of_numbers(r))
            return fail(r, RECORDING_FILE, r->csv.line, "the first line has numbers instead of the names of the columns");
        return false;
    }
    for (size_t i = 0; i < r->format->columns; i++)
        if (!find_column(r, r->format->column[i].name, (int)i, &r->cell[i]))
            return false;
    return true;
}

bool recording_open(Recording *r, Arena *arena, const DataFile *file, const RecordingFormat *format)
{
    memset(r, 0, sizeof *r);
    r->arena = arena;
    r->format = format;
    r->cell = ARENA_ARRAY(arena, size_t, format->columns);
    if (!csv_open(&r->csv, arena, file))
        return fail(r, RECORDING_FILE, 0, r->csv.error);
    return read_header(r);
}

void recording_close(Recording *r) { csv_close(&r->csv); }

RecordingRow recording_new_row(Arena *arena, const RecordingFormat *format)
{
    return (RecordingRow){0, 0, 0, ARENA_ARRAY(arena, double, format->columns)};
}

// ---- rows ----

// Rounds a time of at least 0 to a whole number, halves up.
static double round_time(double x)
{
    const double limit = 4503599627370496.0;          // 2^52: from here on every number is whole
    double whole;

    if (!(x >= 0 && x < limit))
        return x;
    whole = (double)(uint64_t)x;
    return x - whole >= 0.5 ? whole + 1 : whole;
}

// Reads the time of the current record.  Sets *is_bad if it is missing, or not later than that of the row before.
static bool read_time(Recording *r, double *time, bool *is_bad)
{
    const CellKind kind = read_number(r, r->time_cell, r->format->unit, time);
    const bool is_first = r->rows == r->bad_rows;         // no row before has had a time

    if (kind == CELL_WRONG || kind == CELL_TOO_LARGE || (kind == CELL_NUMBER && *time - *time != 0))
        return fail_cell(r, RECORDING_TIME, r->time_cell, kind);
    *is_bad = kind == CELL_MISSING;
    if (*is_bad)
        return true;
    if (is_first)
        r->first_time = *time;
    *time -= r->first_time;
    if (r->format->whole_times)
        *time = round_time(*time);
    *is_bad = !is_first && !(*time > r->last_time);
    return true;
}

// Reads wanted column i of the record. A missing value becomes NaN, or repeats the row before, as the format says.
static bool read_value(Recording *r, size_t i, const RecordingRow *before, double *value)
{
    const RecordingColumn *column = &r->format->column[i];
    const CellKind kind = read_number(r, r->cell[i], TIME_NONE, value);

    if (kind == CELL_WRONG || kind == CELL_TOO_LARGE)
        return fail_cell(r, (int)i, r->cell[i], kind);
    if (kind == CELL_MISSING)
        *value = r->format->missing_is_nan || !before ? recording_no_value() : before->value[i];
    else if (column->is_scaled) {
        const double product = *value * column->scale;
        *value = product + column->offset;
    }
    return true;
}

// Reads the next row. `before`: the previous row, for missing cells. Returns false at the end, and after an error (r->error).
bool recording_next(Recording *r, const RecordingRow *before, RecordingRow *row)
{
    bool is_bad = true;

    while (is_bad) {
        const CsvResult result = csv_next(&r->csv);
        if (result != CSV_RECORD)
            return result == CSV_ERROR && fail_csv(r);
        if (r->csv.cells != r->header_cells)
            return fail(r, RECORDING_FILE, r->csv.line,
                        format_in(r->arena, "the row has %lu cells, and the header has %lu", (unsigned long)r->csv.cells,
                                  (unsigned long)r->header_cells));
        if (!read_time(r, &row->time, &is_bad))
            return false;
        r->rows++;
        r->bad_rows += is_bad;
        if (is_bad && r->format->stop_at_bad_time)
            return fail(r, RECORDING_TIME, r->csv.line, "the time is missing, or not later than in the row before");
        if (is_bad && r->first_bad_line == 0)
            r->first_bad_line = r->csv.line;
    }
    r->last_time = row->time;
    row->number = r->rows;
    row->line = r->csv.line;
    for (size_t i = 0; i < r->format->columns; i++)
        if (!read_value(r, i, before, &row->value[i]))
            return false;
    return true;
}
