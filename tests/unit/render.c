// SPDX-License-Identifier: Apache-2.0
// The output for diagnostics: excerpts of long and of invalid source lines.
#include <stdlib.h>
#include <string.h>

#include "compiler/diag/diag.h"
#include "tests/heap.h"
#include "tests/test.h"

// Returns the output for a diagnostic at byte `at` of a source.
static const char *rendered(Arena *a, const char *text, size_t len, uint32_t at)
{
    DiagStyle style = {false, 20};
    Span span = {source_new(a, "x.sm", text, len), at, 1};
    Diags d;
    Buf out;

    diags_init(&d, a);
    diag_report(&d, DIAG_unknown_element, span, "p");
    buf_init(&out, a);
    diags_render_text(&d, &style, &out);
    return buf_text(&out);
}

// `met` reports a failure to the caller, even if the error was reported before or no sink receives it.
static void errors_met(Arena *a)
{
    Span span = {source_new(a, "x.sm", "p", 1), 0, 1};
    Diags d;

    diags_init(&d, a);
    diag_report(&d, DIAG_unknown_element, span, "p");
    CHECK(d.errors_seen == 1 && d.errors == 1 && d.list.n == 1);
    diag_report(&d, DIAG_unknown_element, span, "p");
    CHECK(d.errors_seen == 2 && d.errors == 1 && d.list.n == 1);
    d.muted = true;
    span.at = 1;
    diag_report(&d, DIAG_unknown_element, span, "q");
    CHECK(d.errors_seen == 3 && d.errors == 1 && d.list.n == 1);
}

int main(void)
{
    char line[400];
    jmp_buf oom;
    Arena a;

    if (setjmp(oom))
        return 1;
    arena_init(&a, heap_alloc, NULL, &oom);

    CHECK(strstr(rendered(&a, "ab = p\n", 7, 5), "    1 | ab = p\n      |      ^") != NULL);
    CHECK(strstr(rendered(&a, "a\tp\n", 4, 2), "    1 | a p\n      |   ^") != NULL);
    CHECK(strstr(rendered(&a, "a\0p\n", 4, 2), "a\\x00p\n      |      ^") != NULL);

    memset(line, 'x', sizeof line);
    CHECK(strstr(rendered(&a, line, sizeof line, 200), "...x") != NULL);           // cut on both sides
    CHECK(strlen(rendered(&a, line, sizeof line, 200)) < 500);
    memset(line, 0xBF, sizeof line);                                              // begins inside a character
    CHECK(strstr(rendered(&a, line, sizeof line, 0), "    1 | \\xBF") != NULL);

    errors_met(&a);
    arena_free(&a);
    return test_end("render");
}
