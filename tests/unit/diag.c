// SPDX-License-Identifier: Apache-2.0
// Diagnostics: how they are collected and sorted, and the exact output of each renderer.
#include <string.h>

#include "compiler/diag/diag.h"
#include "tests/test.h"
#include "tests/unit/host.h"

static Arena arena;
static Diags diags;

static const Source *source(const char *name, const char *text, size_t len)
{
    return source_new(&arena, name, text, len);
}

static Span span(const Source *src, const char *what, size_t len)
{
    return (Span){src, (uint32_t)(strstr(src->text, what) - src->text), (uint32_t)len};
}

static void start(void)
{
    HOST_ARENA(&arena);
    diags_init(&diags, &arena);
}

static const char *rendered(size_t most)
{
    DiagStyle style = {false, most};
    Buf out;

    diags_sort(&diags);
    buf_init(&out, &arena);
    diags_render_text(&diags, &style, &out);
    return buf_text(&out);
}

static void check_text(const char *found, const char *expected)
{
    if (strcmp(found, expected) != 0)
        fprintf(stderr, "---- found\n%s---- expected\n%s", found, expected);
    CHECK(strcmp(found, expected) == 0);
}

// The example in the manual of the command.
static void test_example(void)
{
    static const char text[] = "[state_vector]\nU64 G\nU32 S\n\nbool  valveOpen\n\n\n\n\n\n\n\n\n\n\n\n\n    valve0pe = true\n";
    const Source *s;
    Diag *d;

    start();
    s = source("tank.sm", text, sizeof text - 1);
    d = diag_report(&diags, DIAG_unknown_element, span(s, "valve0pe", 8), "valve0pe");
    diag_label(&diags, d, DIAG_label_did_you_mean, "valveOpen");
    diag_note(&diags, d, span(s, "valveOpen", 9), DIAG_note_declared_here, "valveOpen");
    check_text(rendered(20), "tank.sm:18:5: error: unknown element 'valve0pe' [E0204]\n"
                             "   18 |     valve0pe = true\n"
                             "      |     ^~~~~~~~ did you mean 'valveOpen'?\n"
                             "tank.sm:5:7: note: 'valveOpen' is declared here\n"
                             "1 error\n");
    arena_free(&arena);
}

// A tab is printed as a blank, and invisible characters by name.  The caret stays below its character.
static void test_unprintable(void)
{
    static const char text[] = "\ta\x01\t\xff \xc3\xa9 \xe2\x80\xae" "bad\tx\n";
    const Source *s;

    start();
    s = source("a\033.sm", text, sizeof text - 1);
    diag_report(&diags, DIAG_unknown_element, span(s, "bad", 3), "b\nd");
    check_text(rendered(20), "a\\x1B.sm:1:13: error: unknown element 'b\\x0Ad' [E0204]\n"
                             "    1 |  a\\x01 \\xFF \xc3\xa9 <U+202E>bad x\n"
                             "      |                       ^~~\n"
                             "1 error\n");
    arena_free(&arena);
}

static void test_places(void)
{
    static const char text[] = "\xef\xbb\xbfone\r\ntwo\nlast";
    const Source *s;

    start();
    s = source("a.sm", text, sizeof text - 1);
    diag_report(&diags, DIAG_unknown_element, (Span){s, 3, 99}, "1");                    // a span of several lines is cut
    diag_report(&diags, DIAG_unknown_element, (Span){s, (uint32_t)sizeof text - 1, 0}, "2");     // after the end of the source
    diag_report(&diags, DIAG_unknown_element, (Span){s, 6, 0}, "3");                     // at the end of the line
    diag_report(&diags, DIAG_unknown_element, (Span){NULL, 0, 0}, "4");                  // without a source
    check_text(rendered(20), "a.sm:1:1: error: unknown element '1' [E0204]\n"
                             "    1 | one\n"
                             "      | ^~~\n"
                             "a.sm:1:4: error: unknown element '3' [E0204]\n"
                             "    1 | one\n"
                             "      |    ^\n"
                             "a.sm:3:5: error: unknown element '2' [E0204]\n"
                             "    3 | last\n"
                             "      |     ^\n"
                             "error: unknown element '4' [E0204]\n"
                             "4 errors\n");
    arena_free(&arena);
}

// A file that was loaded twice is one file: its errors are reported once.  Another name or another content is another file.
static void test_same_file_twice(void)
{
    static const char text[] = "one\ntwo\n";
    const Source *s[4];

    start();
    s[0] = source("a.ss", text, sizeof text - 1);
    s[1] = source("b.ss", text, sizeof text - 1);
    s[2] = source("a.ss", text, sizeof text - 1);
    s[3] = source("a.ss", "one\ntwO\n", sizeof text - 1);
    for (unsigned i = 0; i < 4; i++)
        diag_report(&diags, DIAG_moment_missed, (Span){s[i], 0, 3}, "G", "15", "10");
    diag_report(&diags, DIAG_moment_missed, (Span){s[2], 4, 3}, "G", "25", "10");
    diag_report(&diags, DIAG_moment_missed, (Span){s[0], 4, 3}, "G", "25", "10");
    CHECK(diags.warnings == 4 && diags.list.n == 4 && diags.files.n == 3);
    arena_free(&arena);
}

// Of a line of a megabyte, only the part around the caret is printed.
static void test_long_line(void)
{
    enum { N = 1000000, AT = 500000 };
    static char text[N + 1];
    const char *out, *line, *end;
    const Source *s;

    start();
    memset(text, 'a', N);
    text[AT] = 'X';
    s = source("a.sm", text, N);
    diag_report(&diags, DIAG_unknown_element, (Span){s, AT, 3}, "X");
    out = rendered(20);
    line = strstr(out, "    1 | ");
    CHECK(strlen(out) < 600 && line && strncmp(line + 8, "...aaa", 6) == 0);
    end = line ? strchr(line, '\n') : NULL;
    CHECK(end && strncmp(end - 3, "...", 3) == 0 && end - line < 200);
    CHECK(line && end && strchr(line, 'X') - line == strchr(end, '^') - (end + 1));
    CHECK(end && strncmp(strchr(end, '^'), "^~~\n", 4) == 0);
    arena_free(&arena);
}

static void test_large_line_number(void)
{
    enum { N = 123455 };
    static char text[N + 2];
    const Source *s;

    start();
    memset(text, '\n', N);
    text[N] = 'x';
    s = source("a.sm", text, N + 1);
    diag_report(&diags, DIAG_unknown_element, (Span){s, N, 1}, "x");
    check_text(rendered(20), "a.sm:123456:1: error: unknown element 'x' [E0204]\n"
                             "123456 | x\n"
                             "       | ^\n"
                             "1 error\n");
    arena_free(&arena);
}

static void test_collecting(void)
{
    static const char text[] = "a b c d";
    const Source *s, *t;

    start();
    s = source("s", text, 7);
    t = source("t", text, 7);
    diag_report(&diags, DIAG_unknown_element, (Span){t, 2, 1}, "t2");
    diag_report(&diags, DIAG_unknown_element, (Span){s, 4, 1}, "s4");
    diag_report(&diags, DIAG_unknown_element, (Span){t, 0, 1}, "t0");
    diag_report(&diags, DIAG_unknown_element, (Span){t, 0, 2}, "said already");
    diag_report(&diags, DIAG_expected_end, (Span){t, 0, 2}, "another code");
    diags.muted = true;
    diag_report(&diags, DIAG_unknown_element, (Span){t, 6, 1}, "muted");
    diags.muted = false;
    diags_sort(&diags);
    CHECK(diags.errors == 4 && diags.list.n == 4 && diags.warnings == 0);
    CHECK(strstr(diags.list.at[0]->text, "t0") && strstr(diags.list.at[1]->text, "another"));
    CHECK(strstr(diags.list.at[2]->text, "t2") && strstr(diags.list.at[3]->text, "s4"));
    arena_free(&arena);
}

static void test_limits(void)
{
    static char text[30000];
    const Source *s;
    const char *out;

    start();
    memset(text, 'a', sizeof text);
    s = source("s", text, sizeof text);
    for (uint32_t i = 0; i < sizeof text; i++)
        diag_report(&diags, DIAG_unknown_element, (Span){s, i, 1}, "a");
    diag_report(&diags, DIAG_annotation_above, (Span){s, 0, 1}, "a", "b");
    CHECK(diags.errors == sizeof text && diags.list.n == DIAG_KEPT_MAX + 1);
    out = rendered(2);
    CHECK(strstr(out, "and 29998 more errors\n30000 errors, 1 warning\n"));
    out = rendered(0);
    CHECK(strstr(out, "and 20000 more errors\n30000 errors, 1 warning\n"));
    arena_free(&arena);
}

static void test_json(void)
{
    static const char text[] = "ab\ncd\n";
    const Source *s;
    Diag *d;
    Buf out;

    start();
    s = source("dir\\a\".sm", text, 6);
    d = diag_report(&diags, DIAG_unknown_element, (Span){s, 3, 2}, "\xff\xc3\xa9\t");
    diag_label(&diags, d, DIAG_label_did_you_mean, "ab");
    diag_note(&diags, d, (Span){s, 0, 2}, DIAG_note_declared_here, "ab");
    diag_note_step(&diags, d, (Span){0}, DIAG_note_declared_here, "c");
    diag_edit(&diags, d, (Span){s, 3, 2}, "ab");
    diag_report(&diags, DIAG_annotation_above, (Span){0}, "a", "b");
    buf_init(&out, &arena);
    diags_render_json(&diags, &out);
    check_text(buf_text(&out),
        "{\"severity\":\"error\",\"code\":\"E0204\",\"message\":\"unknown element '\\ufffd\xc3\xa9\\u0009'\","
        "\"file\":\"dir\\\\a\\\".sm\",\"line\":2,\"column\":1,\"endLine\":2,\"endColumn\":3,\"label\":\"did you mean 'ab'?\","
        "\"notes\":[{\"message\":\"'ab' is declared here\",\"file\":\"dir\\\\a\\\".sm\",\"line\":1,\"column\":1,\"endLine\":1,"
        "\"endColumn\":3,\"step\":null},{\"message\":\"'c' is declared here\",\"file\":null,\"line\":null,\"column\":null,"
        "\"endLine\":null,\"endColumn\":null,\"step\":1}],\"edits\":[{\"text\":\"ab\",\"file\":\"dir\\\\a\\\".sm\",\"line\":2,\"column\":1,\"endLine\":2,"
        "\"endColumn\":3}],\"flag\":null,\"group\":null}\n"
        "{\"severity\":\"warning\",\"code\":\"W0301\",\"message\":\"'@a' belongs to 'b' above it, not to what follows on its line\","
        "\"file\":null,\"line\":null,\"column\":null,\"endLine\":null,\"endColumn\":null,\"label\":null,\"notes\":[],\"edits\":[],"
        "\"flag\":\"annotation-above\",\"group\":\"all\"}\n");
    arena_free(&arena);
}

// Steps are numbered notes, and a code flow in SARIF.
static void test_steps(void)
{
    const PlainMessages none = {NULL, 0, 0};
    const Source *s;
    Diag *d;
    Buf out;

    start();
    s = source("a.sm", "one two\n", 8);
    d = diag_report(&diags, DIAG_annotation_above, (Span){s, 0, 3}, "x", "y");
    diag_note_step(&diags, d, (Span){s, 0, 3}, DIAG_note_declared_here, "first");
    diag_note(&diags, d, (Span){s, 4, 3}, DIAG_note_declared_here, "aside");
    diag_note_step(&diags, d, (Span){0}, DIAG_note_declared_here, "second");
    check_text(rendered(0),
        "a.sm:1:1: warning: '@x' belongs to 'y' above it, not to what follows on its line [W0301 annotation-above]\n"
        "    1 | one two\n"
        "      | ^~~\n"
        "a.sm:1:1: note: step 1: 'first' is declared here\n"
        "a.sm:1:5: note: 'aside' is declared here\n"
        "note: step 2: 'second' is declared here\n"
        "1 warning\n");
    buf_init(&out, &arena);
    diags_render_sarif(&diags, &none, "1", &out);
    CHECK(strstr(buf_text(&out), "\"codeFlows\":[{\"threadFlows\":[{\"locations\":[{\"location\":{\"physicalLocation\":{"
        "\"artifactLocation\":{\"uri\":\"a.sm\"},\"region\":{\"startLine\":1,\"startColumn\":1,\"endLine\":1,\"endColumn\":4}},"
        "\"message\":{\"text\":\"'first' is declared here\"}}},{\"location\":{\"message\":{\"text\":\"'second' is declared here\"}}}]}]}]"));
    CHECK(strstr(buf_text(&out), "\"relatedLocations\":[{\"physicalLocation\":{\"artifactLocation\":{\"uri\":\"a.sm\"},\"region\":{"
        "\"startLine\":1,\"startColumn\":5,\"endLine\":1,\"endColumn\":8}},\"message\":{\"text\":\"'aside' is declared here\"}}]"));
    arena_free(&arena);
}

// Messages that are not diagnostics have their severity in SARIF, and only an error makes the run unsuccessful.
static void test_sarif_severities(void)
{
    PlainMessage message[] = {{"warning", "w"}, {"note", "n"}, {"error", "e"}};
    PlainMessages plain = {message, 2, 2};
    Buf out;

    HOST_ARENA(&arena);
    diags_init(&diags, &arena);
    buf_init(&out, &arena);
    diags_render_sarif(&diags, &plain, "1", &out);
    CHECK(strstr(buf_text(&out), "\"executionSuccessful\":true"));
    CHECK(strstr(buf_text(&out), "{\"level\":\"warning\",\"message\":{\"text\":\"w\"}},\n{\"level\":\"note\",\"message\":{\"text\":\"n\"}}]"));
    out.n = 0;
    plain.n = 3;
    diags_render_sarif(&diags, &plain, "1", &out);
    CHECK(strstr(buf_text(&out), "\"executionSuccessful\":false") && strstr(buf_text(&out), "{\"level\":\"error\""));
    arena_free(&arena);
}

static DiagFingerprint print_of(const char *name, const char *text, uint32_t at)
{
    const Source *s = source(name, text, (uint32_t)strlen(text));
    DiagFingerprint p;

    diags_init(&diags, &arena);
    diag_report(&diags, DIAG_annotation_above, (Span){s, at, 1}, "x", "y");
    p = *diags_fingerprints(&diags, &arena);
    return p;
}

// A fingerprint depends on the line's words, not on its position, indentation, comments or folder.
static void test_fingerprints(void)
{
    DiagFingerprint one, twins[2];
    const Source *s;

    start();
    one = print_of("a/b.sm", "x = 1 + 2", 4);
    CHECK(one.twin == 1);
    CHECK(print_of("b.sm", "\n\n  x  = 1\t+ 2  # why\n", 10).hash == one.hash);
    CHECK(print_of("a/b.sm", "x = 1 +2", 4).hash != one.hash);
    CHECK(print_of("a/c.sm", "x = 1 + 2", 4).hash != one.hash);
    CHECK(print_of("b.sm", "x \"#1\"", 0).hash != print_of("b.sm", "x \"#2\"", 0).hash);
    diags_init(&diags, &arena);
    s = source("b.sm", "x = 1 + 2\n\nx = 1 + 2", 20);
    diag_report(&diags, DIAG_annotation_above, (Span){s, 12, 1}, "x", "y");
    diag_report(&diags, DIAG_annotation_above, (Span){s, 0, 1}, "x", "y");
    memcpy(twins, diags_fingerprints(&diags, &arena), sizeof twins);
    CHECK(twins[0].hash == one.hash && twins[1].hash == one.hash && twins[0].twin == 2 && twins[1].twin == 1);
    arena_free(&arena);
}

// The edits of a diagnostic are applied together; none of them is applied if an earlier diagnostic has edited the same text.
static void test_edits(void)
{
    static const char text[] = "abcdefgh";
    const Source *s;
    Diag *d;
    Buf out;

    start();
    s = source("s", text, 8);
    buf_init(&out, &arena);
    CHECK(diags_apply_edits(&diags, s, &out) == 0 && strcmp(buf_text(&out), text) == 0);
    d = diag_report(&diags, DIAG_unknown_element, (Span){s, 0, 1}, "1");
    diag_edit(&diags, d, (Span){s, 6, 1}, "GG");
    diag_edit(&diags, d, (Span){s, 1, 2}, "");
    d = diag_report(&diags, DIAG_unknown_element, (Span){s, 1, 1}, "2");            // overlaps the first
    diag_edit(&diags, d, (Span){s, 2, 2}, "X");
    diag_edit(&diags, d, (Span){s, 8, 0}, "Y");
    d = diag_report(&diags, DIAG_unknown_element, (Span){s, 2, 1}, "3");
    diag_edit(&diags, d, (Span){s, 3, 0}, "<");                                     // an insertion at its end: too close
    d = diag_report(&diags, DIAG_unknown_element, (Span){s, 3, 1}, "4");
    diag_edit(&diags, d, (Span){s, 4, 0}, "(");
    diag_edit(&diags, d, (Span){s, 5, 0}, ")");
    buf_init(&out, &arena);
    CHECK(diags_apply_edits(&diags, s, &out) == 2);
    check_text(buf_text(&out), "ad(e)fGGh");
    arena_free(&arena);
}

// Ids are unique and in order, no page is empty.
static void test_table(void)
{
    char last[8] = "00E000", key[8];

    for (int i = 0; i < DIAG_COUNT; i++) {
        const DiagInfo *row = &diag_info[i];
        if (!row->id)
            continue;
        CHECK(strlen(row->id) == 5 && row->page && strlen(row->page) > 40 && row->page[strlen(row->page) - 1] == '\n');
        CHECK((row->id[0] == 'W') == (row->severity == DIAG_WARNING) && (row->id[0] == 'W') == (row->flag != NULL));
        snprintf(key, sizeof key, "%.2s%c%s", row->id + 1, row->id[0], row->id + 3);     // chapter, E or W, number
        CHECK(strcmp(key, last) > 0);
        CHECK(diag_find(row->id) == row);
        strcpy(last, key);
    }
    CHECK(diag_find("e0204") == &diag_info[DIAG_unknown_element]);
    CHECK(diag_find("annotation-above") == &diag_info[DIAG_annotation_above]);
    CHECK(!diag_find("E9999") && !diag_find("") && !diag_find("E020"));
}

// The document contains the page of every row.
static void test_markdown(void)
{
    size_t rows = 0, pages = 0;
    const char *at;
    Buf out;

    start();
    buf_init(&out, &arena);
    diags_write_markdown(&out);
    for (int i = 0; i < DIAG_COUNT; i++)
        rows += diag_info[i].id != NULL;
    for (at = strstr(buf_text(&out), "\n## 1 "); (at = strstr(at, "\n### ")) != NULL; at++)
        pages++;
    CHECK(rows == pages);
    arena_free(&arena);
}

int main(void)
{
    test_example();
    test_unprintable();
    test_places();
    test_same_file_twice();
    test_long_line();
    test_large_line_number();
    test_collecting();
    test_limits();
    test_json();
    test_steps();
    test_sarif_severities();
    test_fingerprints();
    test_edits();
    test_table();
    test_markdown();
    return test_end("diag");
}
