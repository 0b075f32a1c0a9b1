// SPDX-License-Identifier: Apache-2.0
// Golden cases: what wildcards match, and that a case which is rewritten keeps the wildcards that still match (tests/golden/expect.h).
#include "tests/golden/expect.h"

#include <stdlib.h>

#include "tests/test.h"
#include "tests/unit/host.h"

static Arena arena;

static bool matches(const char *want, const char *got)
{
    return expect_matches(want, want + strlen(want), got, got + strlen(got));
}

static bool becomes(const char *want, const char *got, const char *now)
{
    Buf out;

    buf_init(&out, &arena);
    expect_update(&arena, want, strlen(want), got, strlen(got), &out);
    if (strcmp(buf_text(&out), now) != 0)
        fprintf(stderr, "came:\n%s", buf_text(&out));
    return strcmp(buf_text(&out), now) == 0 && matches(now, got);
}

int main(void)
{
    HOST_ARENA(&arena);
    CHECK(matches("a\n...\nb\n", "a\nb\n") && matches("a\n...\nb\n", "a\nx\ny\nb\n") && !matches("a\n...\nb\n", "a\nx\n"));
    CHECK(matches("took [..] ms", "took 12 ms") && !matches("took [..] ms", "took 12 s"));

    CHECK(becomes("", "a\nb\n", "a\nb\n") && becomes("a\n", "", ""));
    CHECK(becomes("took [..] ms\nold\n", "took 12 ms\nnew\n", "took [..] ms\nnew\n"));
    CHECK(becomes("took [..] ms\nold\n", "lasted 12 ms\nnew\n", "lasted 12 ms\nnew\n"));
    CHECK(becomes("a\n...\nb\n", "a\nx\ny\nc\n", "a\n...\nc\n"));
    CHECK(becomes("old\n...\nb\n", "new\nx\nb\n", "new\n...\nb\n"));
    CHECK(becomes("a\n...\nb\n[..]: c\n", "z\na\nx\nb\nnew\n7: c\nlast\n", "z\na\n...\nb\nnew\n[..]: c\nlast\n"));
    CHECK(becomes("a\n...\nb\n...\nc\n", "a\n1\n2\nc\n", "a\n...\n1\n...\nc\n"));
    arena_free(&arena);
    return test_end("golden_expect");
}
