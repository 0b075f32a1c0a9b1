// SPDX-License-Identifier: Apache-2.0
// .smt files: header, parts byte for byte, announced diagnostics, and the errors of malformed ones.
#include "compiler/script/testfile.h"

#include <stdlib.h>
#include <string.h>

#include "tests/heap.h"
#include "tests/test.h"

static Arena arena;
static jmp_buf oom;

static TestFile *parse(const char *text) { return testfile_parse(&arena, "t.smt", text, strlen(text)); }

static bool refused(const char *text, const char *why)
{
    const TestFile *f = parse(text);

    return f->error && strstr(f->error, why);
}

static void check_header(void)
{
    TestFile *f = parse("# a comment\nspec 5.7, 5.8  Two guards.\r\n\non\tref vm\nsteps 12\nexpect fail\n-- a.ss --\n");

    CHECK(!f->error && f->header.n == 4 && f->header.at[1].line == 4);
    CHECK(strcmp(testfile_header(f, "spec"), "5.7, 5.8  Two guards.") == 0 && !testfile_header(f, "args"));
    CHECK(testfile_has_word(testfile_header(f, "on"), "vm") && !testfile_has_word(testfile_header(f, "on"), "v"));
    CHECK(f->steps == 12 && f->outcome == TEST_FAIL && f->part.n == 1 && f->part.at[0].n == 0);
}

static void check_parts(void)
{
    TestFile *f = parse("-- a.sm --\nx = 1\n\n -- no part\n--y--\n-- ir out --\r\nlast");

    CHECK(f->part.n == 2 && f->part.at[0].line == 2 && f->part.at[1].line == 7);
    CHECK(strcmp(testfile_part(f, "a.sm")->text, "x = 1\n\n -- no part\n--y--\n") == 0);
    CHECK(strcmp(testfile_part(f, "ir out")->text, "last") == 0 && !testfile_part(f, "a"));
    CHECK(testfile_is_source(&f->part.at[0]) && !testfile_is_source(&f->part.at[1]));
    f = parse(" \t--  app.sm  -- \nx\n  -- b --\n");                                  // blanks around the line and the name
    CHECK(f->part.n == 2 && testfile_part(f, "app.sm") && strcmp(testfile_part(f, "app.sm")->text, "x\n") == 0 && testfile_part(f, "b"));
}

static void check_expected(void)
{
    TestFile *f = parse("-- a.sm --\nfirst\n x #! E0204 unknown element #! W0501 \n-- report --\n#! nothing\n-- b.ss --\n#! E0312");

    CHECK(!f->error && f->expected.n == 3 && f->outcome == TEST_ERROR);
    CHECK(f->expected.at[0].line == 2 && f->expected.at[1].line == 2 && f->expected.at[2].line == 1);
    CHECK(strcmp(f->expected.at[0].id, "E0204") == 0 && strcmp(f->expected.at[0].text, "unknown element") == 0);
    CHECK(strcmp(f->expected.at[1].text, "") == 0 && f->expected.at[2].part == 2);
    CHECK(parse("-- a.ss --\n#! E0750 x\n#! W0750")->outcome == TEST_FAIL);
    CHECK(parse("-- a.ss --\n#! E0701 x")->outcome == TEST_ERROR);                      // of a script that is not run
    CHECK(parse("-- a.ss --\n#! E0760 x")->outcome == TEST_ERROR && parse("-- a.ss --\n#! E0759 x")->outcome == TEST_FAIL);
    CHECK(parse("-- a.ss --\n#! E0751 x\n#! E0204 y")->outcome == TEST_ERROR);
    CHECK(parse("-- a.ss --\n#! W0750 x")->outcome == TEST_PASS);
    CHECK(parse("expect pass\n-- a.ss --\n#! E0750 x")->outcome == TEST_PASS);
}

static void check_malformed(void)
{
    CHECK(refused("", "no part") && refused("spec 1\n", "no part"));
    CHECK(refused("-- a.sm --\n\nx #! 204", "line 3: after #!") && refused("-- a.sm --\n#!E02041", "line 2"));
    CHECK(refused("-- a --\n-- a --\n", "line 2: a second part"));
    CHECK(refused("expect maybe\n-- a --\n", "line 1: expect") && refused("steps 0\n-- a --\n", "steps"));
    CHECK(refused("steps 99999999999999999999\n-- a --\n", "steps") && refused("steps 1x\n-- a --\n", "steps"));
}

static void check_any_bytes(void)
{
    char text[300];
    unsigned r = 1;

    for (int i = 0; i < 20000; i++) {                 // checks only that parsing terminates
        static const char pieces[] = "-- a.sm --\n#! E0204\r\n\0 \t-";
        for (size_t j = 0; j < sizeof text; j++)
            text[j] = pieces[(r = r * 1664525u + 1013904223u) >> 16 & 15];
        CHECK(testfile_parse(&arena, "t", text, r % sizeof text)->name != NULL);
        arena_free(&arena);
    }
}

int main(void)
{
    if (setjmp(oom))
        return 1;
    arena_init(&arena, heap_alloc, NULL, &oom);
    check_header();
    check_parts();
    check_expected();
    check_malformed();
    check_any_bytes();
    arena_free(&arena);
    return test_end("testfile");
}
