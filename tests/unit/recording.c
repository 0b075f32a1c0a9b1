// SPDX-License-Identifier: Apache-2.0
// Tests the reader of recorded data with files that no test case can contain: byte order marks, line ends, NUL bytes, long records, files that
// cannot be read to their end.  Its memory must not grow with the number of rows.  Clauses 8.56, 8.57, 8.70.
#include <string.h>

#include "compiler/data/recording.h"
#include "tests/test.h"
#include "tests/unit/host.h"

static const RecordingColumn columns[] = {{"P", false, 1, 0}};
static const RecordingFormat format = {"t", TIME_MS, TIME_MS, false, false, false, columns, 1};

typedef struct Reading { Recording r; double sum; unsigned long rows; } Reading;

static void read_all(Arena *arena, const DataFile *file, Reading *out)
{
    RecordingRow row[2] = {recording_new_row(arena, &format), recording_new_row(arena, &format)};

    out->sum = 0;
    out->rows = 0;
    if (recording_open(&out->r, arena, file, &format))
        while (recording_next(&out->r, out->rows ? &row[(out->rows + 1) % 2] : NULL, &row[out->rows % 2])) {
            out->sum += row[out->rows % 2].value[0];
            out->rows++;
        }
    recording_close(&out->r);
}

// ---- good files ----

static void check_good(const char *name, const char *bytes, size_t n, unsigned long rows, double sum)
{
    DataMemory m;
    Reading got;
    Arena arena;

    HOST_ARENA(&arena);
    data_memory_init(&m, name, bytes, n);
    read_all(&arena, &m.file, &got);
    test_count(!got.r.error.text && got.rows == rows && got.sum == sum, name);
    arena_free(&arena);
}
#define GOOD(name, bytes, rows, sum) check_good(name, bytes, sizeof bytes - 1, rows, sum)

static void test_good_files(void)
{
    GOOD("LF", "t,P\n0,1\n1,2\n", 2, 3);
    GOOD("no end of the last line", "t,P\n0,1\n1,2", 2, 3);
    GOOD("CR LF", "t,P\r\n0,1\r\n1,2\r\n", 2, 3);
    GOOD("CR", "t,P\r0,1\r1,2\r", 2, 3);
    GOOD("empty lines", "\n\nt,P\n\n0,1\r\n\r\n1,2\n\n", 2, 3);
    GOOD("byte order mark", "\xef\xbb\xbft,P\n0,1\n1,2\n", 2, 3);
    GOOD("byte order mark and quotes", "\xef\xbb\xbf\"t\",\"P\"\n\"0\",\"1\"\n1,2\n", 2, 3);
    GOOD("line ends in quotes", "t,P,n\n0,1,\"a\r\nb\nc\rd\"\n1,2,\"\"\"\"\n", 2, 3);
    GOOD("blanks around names", " t ,\tP\n 0 ,\t1\n1,2 \n", 2, 3);
    GOOD("text that is not UTF-8 in another column", "t,P,n\n0,1,\xb0\n1,2,\n", 2, 3);
    GOOD("a quote within a cell", "t,P,n\n0,1,5\" pipe\n1,2,\n", 2, 3);
    GOOD("minus zero and a sign", "t,P\n0,-0\n1,+3\n", 2, 3);
    GOOD("negative times", "t,P\n-5,1\n-4.5,2\n", 2, 3);
}

// ---- bad files ----

static void check_bad(const char *bytes, size_t n, uint64_t line, int column, const char *text)
{
    DataMemory m;
    Reading got;
    Arena arena;

    HOST_ARENA(&arena);
    data_memory_init(&m, "bad.csv", bytes, n);
    read_all(&arena, &m.file, &got);
    if (got.r.error.text && strstr(got.r.error.text, text) && got.r.error.line == line && got.r.error.column == column)
        test_count(true, text);
    else {
        fprintf(stderr, "line %lu, column %d: %s\n", (unsigned long)got.r.error.line, got.r.error.column, got.r.error.text ? got.r.error.text : "no error");
        test_count(false, text);
    }
    arena_free(&arena);
}
#define BAD(bytes, line, column, text) check_bad(bytes, sizeof bytes - 1, line, column, text)

static void test_bad_files(void)
{
    BAD("", 0, RECORDING_FILE, "the file is empty");
    BAD("\xef\xbb\xbf", 0, RECORDING_FILE, "the file is empty");
    BAD("\n\r\n", 0, RECORDING_FILE, "the file is empty");
    BAD("\xff\xfet\0,\0P\0\n\0", 1, RECORDING_FILE, "UTF-16");
    BAD("\xfe\xff\0t\0,\0P\0\n", 1, RECORDING_FILE, "UTF-16");
    BAD("t\0,\0P\0\n\0", 1, RECORDING_FILE, "NUL");
    BAD("t,P\n0,1\n1,\0\n", 3, RECORDING_FILE, "NUL");
    BAD("t,P\n0,1\n1,\"\n\0\"\n", 4, RECORDING_FILE, "NUL");
    BAD("t,P,\xb0\n0,1,2\n", 1, RECORDING_FILE, "not UTF-8");
    BAD("x,P\n0,1\n", 1, RECORDING_TIME, "no column 't'");
    BAD("t;p\n0;1\n", 1, 0, "did you mean 'p'?");
    BAD("t,one,two,three\n0,1\n", 1, 0, "the header has 't', 'one', 'two', 'three'");
    BAD("t,P,t\n0,1,2\n", 1, RECORDING_TIME, "2 columns have the name 't'");
    BAD("1,2,3\n4,5,6\n", 1, RECORDING_FILE, "numbers instead of the names");
    BAD("t,P\n0,1\n\n1\n", 4, RECORDING_FILE, "1 cells, and the header has 2");
    BAD("t,P\n0,1\n1,2,\n", 3, RECORDING_FILE, "3 cells, and the header has 2");
    BAD("t,P\n0,\"1\n1,2\n", 2, RECORDING_FILE, "not closed");
    BAD("t,P\n0,\"1\" \n1,2\n", 2, RECORDING_FILE, "text after the closing quote");
    BAD("t,P\nzero,1\n", 2, RECORDING_TIME, "'zero' is not a number");
    BAD("t,P\n0,1\n1e400,1\n", 3, RECORDING_TIME, "'1e400' is too large");
    BAD("t,P\n0,1e\n", 2, 0, "'1e' is not a number");
    BAD("t,P\n0,1e+\n", 2, 0, "not a number");
    BAD("t,P\n0,.\n", 2, 0, "'.' is not a number");
    BAD("t,P\n0,1.2.3\n", 2, 0, "not a number");
    BAD("t;P\n0;1.2,3\n", 2, 0, "not a number");
    BAD("t,P\n0,0x10\n", 2, 0, "not a number");
    BAD("t,P\n0,1_000\n", 2, 0, "not a number");
    BAD("t,P\n0,- 1\n", 2, 0, "not a number");
    BAD("t,P\n0,\x1b[31m\xb0\n", 2, 0, "'\\x1b[31m\\xb0' is not a number");
    BAD("t,P\n0,\xe2\x80\xae" "1\n", 2, 0, "\\xe2\\x80\\xae");
}

static void test_long_records(void)
{
    static char text[CSV_RECORD_MAX + 1000];

    memset(text, 'a', sizeof text);
    memcpy(text, "t,P,n\n0,1,", 10);
    check_bad(text, sizeof text, 2, RECORDING_FILE, "longer than 1048576 bytes");
    check_bad(text + 11, sizeof text - 11, 1, RECORDING_FILE, "longer than 1048576 bytes");
    text[10] = '"';
    check_bad(text, sizeof text, 2, RECORDING_FILE, "a quote that opens here is not closed");
    text[10] = 'a';                                   // the longest that is accepted
    text[CSV_RECORD_MAX - 10] = '\n';
    memcpy(text + CSV_RECORD_MAX - 9, "1,2,\n", 5);
    check_good("a long record", text, CSV_RECORD_MAX - 4, 2, 3);
}

// ---- files that are made while they are read ----

static size_t allocated;

static void *counting_alloc(void *context, void *old, size_t size)
{
    allocated += size;
    return heap_alloc(context, old, size);
}

typedef struct Made { DataFile file; unsigned long rows; bool fails; } Made;

// Makes a row for each call; `at` is the number of rows so far.  Rows have 16 bytes, so they fit the buffer of the reader.
static bool read_made(DataStream *s, char *into, size_t n, size_t *got, const char **why)
{
    const Made *m = s->self;
    char text[20];

    *got = 0;
    if (s->at > m->rows) {
        *why = "the disk is gone";
        return !m->fails;
    }
    *got = 16;
    CHECK(n >= 16 && snprintf(text, sizeof text, s->at == 0 ? "t,P            \n" : "%013lu,2\n", (unsigned long)s->at) == 16);
    memcpy(into, text, 16);
    s->at++;
    return true;
}

static void close_made(DataStream *s) { s->self = NULL; }

static bool open_made(const DataFile *file, DataStream *s, const char **why)
{
    (void)why;
    *s = (DataStream){file->context, 0, read_made, close_made};
    return true;
}

static size_t memory_for(unsigned long rows)
{
    Made m = {{"made.csv", NULL, open_made}, rows, false};
    Reading got;
    Arena arena;

    m.file.context = &m;
    allocated = 0;
    host_check(setjmp(host_oom));
    arena_init(&arena, counting_alloc, NULL, &host_oom);
    read_all(&arena, &m.file, &got);
    CHECK(!got.r.error.text && got.rows == rows && got.sum == 2 * (double)got.rows);
    arena_free(&arena);
    return allocated;
}

static void test_memory(void)
{
    const size_t few = memory_for(100), many = memory_for(200000);

    CHECK(few > 0 && many == few);
}

static void test_read_error(void)
{
    Made m = {{"made.csv", NULL, open_made}, 10, true};
    Reading got;
    Arena arena;

    HOST_ARENA(&arena);
    m.file.context = &m;
    read_all(&arena, &m.file, &got);
    CHECK(got.r.error.text && strstr(got.r.error.text, "cannot read any further: the disk is gone") && got.r.error.column == RECORDING_FILE);
    arena_free(&arena);
}

int main(void)
{
    test_good_files();
    test_bad_files();
    test_long_records();
    test_memory();
    test_read_error();
    return test_end("recording");
}
