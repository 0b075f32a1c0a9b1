// SPDX-License-Identifier: Apache-2.0
// Splits an .smt file into its header and its parts, line by line.
#include "compiler/script/testfile.h"

#include <string.h>

#include "compiler/base/buf.h"
#include "compiler/base/str.h"

enum { PARTS_MOST = 1000 };

typedef struct TestReader {
    Arena *arena;
    TestFile *f;
    const char *at, *end;
    uint32_t line;            // number of the line that was read last, from 1
} TestReader;

// A line of the file, without its LF or CR LF.
typedef struct TestLine { const char *at; size_t n; } TestLine;

// Reads the next line; returns false at the end of the file.
static bool next_line(TestReader *r, TestLine *line)
{
    const char *lf;

    if (r->at == r->end)
        return false;
    lf = memchr(r->at, '\n', (size_t)(r->end - r->at));
    line->at = r->at;
    line->n = (size_t)((lf ? lf : r->end) - r->at);
    r->at = lf ? lf + 1 : r->end;
    r->line++;
    if (line->n && line->at[line->n - 1] == '\r')
        line->n--;
    return true;
}

static const char *copy_text(TestReader *r, const char *at, size_t n)
{
    char *text = arena_alloc(r->arena, n + 1);

    memcpy(text, at, n);
    return text;
}

// Stores the first error of the file.
static void set_error(TestReader *r, uint32_t line, const char *what)
{
    if (!r->f->error)
        r->f->error = format_in(r->arena, "line %lu: %s", (unsigned long)line, what);
}

static bool is_digit(char c) { return c >= '0' && c <= '9'; }

static TestLine trim_line(TestLine l)
{
    while (l.n && is_space_or_tab(l.at[0]))
        l.at++, l.n--;
    while (l.n && is_space_or_tab(l.at[l.n - 1]))
        l.n--;
    return l;
}

// ---- parts ----

// Whether a line has the form `-- NAME --`.
static bool is_part_line(TestLine l)
{
    l = trim_line(l);
    return l.n > 6 && memcmp(l.at, "-- ", 3) == 0 && memcmp(l.at + l.n - 3, " --", 3) == 0;
}

// Returns the part of this name; NULL if the file has none.
const TestPart *testfile_part(const TestFile *f, const char *name)
{
    for (size_t i = 0; i < f->part.n; i++)
        if (strcmp(f->part.at[i].name, name) == 0)
            return &f->part.at[i];
    return NULL;
}

// Reads the lines of a part; `head` is its first line.
static void read_part(TestReader *r, TestLine head)
{
    const TestLine mark = trim_line(head);                       // "-- NAME --"
    TestLine l = trim_line((TestLine){mark.at + 3, mark.n - 6});
    TestPart p = {copy_text(r, l.at, l.n), r->at, 0, r->line + 1};
    TestReader before = *r;

    if (r->f->part.n == PARTS_MOST)
        set_error(r, r->line, "too many parts");
    if (testfile_part(r->f, p.name))
        set_error(r, r->line, "a second part of this name");
    while (next_line(r, &l)) {
        if (is_part_line(l)) {
            *r = before;                              // the next part begins here
            break;
        }
        p.n = (size_t)(r->at - p.text);
        before = *r;
    }
    p.text = copy_text(r, p.text, p.n);
    vec_push(r->arena, &r->f->part, p);
}

// ---- announced diagnostics ----

// Whether a line starts with the code of a diagnostic: E or W and four digits.
static bool is_code(TestLine l)
{
    return l.n >= 5 && (l.at[0] == 'E' || l.at[0] == 'W') && is_digit(l.at[1]) && is_digit(l.at[2]) && is_digit(l.at[3]) &&
           is_digit(l.at[4]) && (l.n == 5 || is_space_or_tab(l.at[5]));
}

// Returns the position of the first `#!` in a line, or NULL.
static const char *find_marker(TestLine l)
{
    for (size_t i = 0; i + 1 < l.n; i++)
        if (l.at[i] == '#' && l.at[i + 1] == '!')
            return l.at + i;
    return NULL;
}

// Reads the diagnostics that a line of a part announces.  `line`: its number within the part.
static void read_expected_of_line(TestReader *r, size_t part, uint32_t line, TestLine l)
{
    const char *mark = find_marker(l);

    while (mark) {
        const char *end = l.at + l.n, *next;
        TestLine rest = {mark + 2, (size_t)(end - mark) - 2};
        TestExpected e = {part, line, NULL, NULL};

        next = find_marker(rest);
        rest = trim_line((TestLine){rest.at, next ? (size_t)(next - rest.at) : rest.n});
        if (!is_code(rest)) {
            set_error(r, r->f->part.at[part].line + line - 1, "after #! the code of a diagnostic is expected, as in #! E0204 unknown element");
            return;
        }
        e.id = copy_text(r, rest.at, 5);
        rest = trim_line((TestLine){rest.at + 5, rest.n - 5});
        e.text = copy_text(r, rest.at, rest.n);
        vec_push(r->arena, &r->f->expected, e);
        mark = next;
    }
}

static void read_expected_of_part(TestReader *r, size_t part)
{
    const TestPart *p = &r->f->part.at[part];
    TestReader lines = {r->arena, r->f, p->text, p->text + p->n, 0};
    TestLine l;

    while (next_line(&lines, &l))
        read_expected_of_line(&lines, part, lines.line, l);
}

// ---- header ----

static void read_header_line(TestReader *r, TestLine l)
{
    TestHeader h = {NULL, NULL, r->line};
    size_t n = 0;

    l = trim_line(l);
    if (l.n == 0 || l.at[0] == '#')
        return;
    while (n < l.n && !is_space_or_tab(l.at[n]))
        n++;
    h.key = copy_text(r, l.at, n);
    l = trim_line((TestLine){l.at + n, l.n - n});
    h.value = copy_text(r, l.at, l.n);
    vec_push(r->arena, &r->f->header, h);
}

// Returns the number, or 0 if the text is not a decimal number of at most 64 bits.
static uint64_t read_number(const char *text)
{
    uint64_t n = 0;

    for (; is_digit(*text); text++) {
        if (n > (UINT64_MAX - 9) / 10)
            return 0;
        n = n * 10 + (uint64_t)(*text - '0');
    }
    return *text ? 0 : n;
}

// Returns the line number of the first header with this key; 0 if no header has it.
static uint32_t find_header_line(const TestFile *f, const char *key)
{
    for (size_t i = 0; i < f->header.n; i++)
        if (strcmp(f->header.at[i].key, key) == 0)
            return f->header.at[i].line;
    return 0;
}

// Returns the outcome that a test without `expect` must have: TEST_ERROR if it announces an error of the compiler, TEST_FAIL if it
// announces an error of a run, E075x.
static TestOutcome default_outcome(const TestFile *f)
{
    TestOutcome outcome = TEST_PASS;

    for (size_t i = 0; i < f->expected.n; i++) {
        const char *id = f->expected.at[i].id;
        if (id[0] == 'E' && strncmp(id, "E075", 4) != 0)
            return TEST_ERROR;
        if (id[0] == 'E')
            outcome = TEST_FAIL;
    }
    return outcome;
}

// Returns the number that a header key has as its value; 0 if the key is absent.
static uint64_t read_header_number(TestReader *r, const char *key)
{
    const char *value = testfile_header(r->f, key);
    uint64_t n = value ? read_number(value) : 0;

    if (value && n == 0)
        set_error(r, find_header_line(r->f, key), format_in(r->arena, "%s takes a whole number from 1", key));
    return n;
}

static void interpret_header_keys(TestReader *r)
{
    TestFile *f = r->f;
    const char *expect = testfile_header(f, "expect");

    f->outcome = default_outcome(f);
    f->steps = read_header_number(r, "steps");
    f->advance = read_header_number(r, "advance");
    if (!expect)
        return;
    if (strcmp(expect, "pass") == 0)
        f->outcome = TEST_PASS;
    else if (strcmp(expect, "fail") == 0)
        f->outcome = TEST_FAIL;
    else if (strcmp(expect, "error") == 0)
        f->outcome = TEST_ERROR;
    else
        set_error(r, find_header_line(f, "expect"), "expect takes pass, fail or error");
}

// ---- the file ----

// Parses text, which is not copied.  Everything is allocated in the arena.
TestFile *testfile_parse(Arena *arena, const char *name, const char *text, size_t n)
{
    TestFile *f = ARENA_NEW(arena, TestFile);
    TestReader r = {arena, f, text, text + n, 0};
    TestLine l;

    f->name = name;
    while (!f->error && next_line(&r, &l)) {
        if (is_part_line(l))
            read_part(&r, l);
        else
            read_header_line(&r, l);
    }
    for (size_t i = 0; i < f->part.n; i++)
        if (testfile_is_source(&f->part.at[i]))
            read_expected_of_part(&r, i);
    interpret_header_keys(&r);
    if (f->part.n == 0)
        set_error(&r, r.line, "no part was found: a part begins with a line as -- app.sm --");
    return f;
}

// Returns the value of the first header with this key; NULL if no header has it.
const char *testfile_header(const TestFile *f, const char *key)
{
    for (size_t i = 0; i < f->header.n; i++)
        if (strcmp(f->header.at[i].key, key) == 0)
            return f->header.at[i].value;
    return NULL;
}

bool testfile_has_suffix(const TestPart *p, const char *suffix)
{
    size_t n = strlen(p->name), m = strlen(suffix);

    return n > m && strcmp(p->name + n - m, suffix) == 0;
}

bool testfile_is_source(const TestPart *p)
{
    static const char *const suffixes[] = {".sv", ".sm", ".ss", ".io", ".net", ".app", ".rq"};

    for (size_t i = 0; i < sizeof suffixes / sizeof *suffixes; i++)
        if (testfile_has_suffix(p, suffixes[i]))
            return true;
    return false;
}

// Whether a header's value, a list of words, contains this word.
bool testfile_has_word(const char *list, const char *word)
{
    size_t n = strlen(word);

    for (const char *at = list; (at = strstr(at, word)) != NULL; at += n)
        if ((at == list || is_space_or_tab(at[-1])) && (at[n] == '\0' || is_space_or_tab(at[n])))
            return true;
    return false;
}
