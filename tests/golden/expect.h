// SPDX-License-Identifier: Apache-2.0
// Expectations of golden cases: a line `...` matches any number of lines, `[..]` in a line any text.  Private to run.c and its test.
#ifndef TESTS_GOLDEN_EXPECT_H
#define TESTS_GOLDEN_EXPECT_H

#include <stdbool.h>
#include <string.h>

#include "compiler/base/buf.h"
#include "compiler/base/vec.h"

// ---- does it match? ----

static bool expect_line_matches(const char *want, size_t n, const char *got, size_t m)
{
    static const char any[] = "[..]";

    while (n) {
        if (n >= 4 && memcmp(want, any, 4) == 0) {
            for (size_t skip = 0; skip <= m; skip++)
                if (expect_line_matches(want + 4, n - 4, got + skip, m - skip))
                    return true;
            return false;
        }
        if (m == 0 || *want != *got)
            return false;
        want++, n--, got++, m--;
    }
    return m == 0;
}

static size_t expect_line_length(const char *at, const char *end)
{
    const char *lf = at < end ? memchr(at, '\n', (size_t)(end - at)) : NULL;

    return (size_t)((lf ? lf : end) - at);
}

static const char *expect_after_line(const char *at, const char *end)
{
    at += expect_line_length(at, end);
    return at < end ? at + 1 : at;
}

static bool expect_is_gap(const char *line, size_t n) { return n == 3 && memcmp(line, "...", 3) == 0; }

static bool expect_matches(const char *want, const char *want_end, const char *got, const char *got_end)
{
    while (want < want_end) {
        size_t n = expect_line_length(want, want_end);
        if (expect_is_gap(want, n)) {
            want = expect_after_line(want, want_end);
            for (;; got = expect_after_line(got, got_end)) {
                if (expect_matches(want, want_end, got, got_end))
                    return true;
                if (got == got_end)
                    return false;
            }
        }
        if (got == got_end || !expect_line_matches(want, n, got, expect_line_length(got, got_end)))
            return false;
        want = expect_after_line(want, want_end);
        got = expect_after_line(got, got_end);
    }
    return got == got_end;
}

// ---- the actual output, written with the wildcards that still match ----

typedef struct ExpectLine { const char *at; size_t n; } ExpectLine;
typedef VEC(ExpectLine) ExpectLines;

// The distance of the expected lines from i on and the actual lines from j on is `cost[i][j]`.  An added line costs least, a removed one most,
// so that `...` does not swallow its neighbours when they change, nor those that are still there.
typedef struct ExpectMerge {
    ExpectLines want, got;
    unsigned *cost;
} ExpectMerge;

enum { EXPECT_CAME = 3, EXPECT_REPLACED, EXPECT_GONE };

static void expect_lines(Arena *arena, const char *at, size_t n, ExpectLines *out)
{
    for (const char *end = at + n; at < end; at = expect_after_line(at, end)) {
        const ExpectLine line = {at, expect_line_length(at, end)};
        vec_push(arena, out, line);
    }
}

static unsigned *expect_cost(const ExpectMerge *m, size_t i, size_t j) { return &m->cost[i * (m->got.n + 1) + j]; }

static unsigned expect_pair(const ExpectMerge *m, size_t i, size_t j)      // costs of pairing an expected line with an actual one
{
    const ExpectLine *want = &m->want.at[i], *got = &m->got.at[j];

    return expect_line_matches(want->at, want->n, got->at, got->n) ? 0 : EXPECT_REPLACED;
}

static bool expect_gap_at(const ExpectMerge *m, size_t i) { return expect_is_gap(m->want.at[i].at, m->want.at[i].n); }

static unsigned expect_least(const ExpectMerge *m, size_t i, size_t j)
{
    const bool more = i < m->want.n, came = j < m->got.n, gap = more && expect_gap_at(m, i);
    unsigned least = more || came ? (unsigned)-1 : 0, next;

    if (came && (next = *expect_cost(m, i, j + 1) + (gap ? 0 : EXPECT_CAME)) < least)
        least = next;
    if (more && (next = *expect_cost(m, i + 1, j) + (gap ? 0 : EXPECT_GONE)) < least)
        least = next;
    if (more && came && !gap && (next = *expect_cost(m, i + 1, j + 1) + expect_pair(m, i, j)) < least)
        least = next;
    return least;
}

static void expect_put(Buf *out, const ExpectLine *line)
{
    buf_put(out, line->at, line->n);
    buf_char(out, '\n');
}

static void expect_walk(const ExpectMerge *m, Buf *out)
{
    size_t i = 0, j = 0;

    while (i < m->want.n || j < m->got.n) {
        const bool more = i < m->want.n, came = j < m->got.n, gap = more && expect_gap_at(m, i);
        const unsigned cost = *expect_cost(m, i, j);
        if (more && came && !gap && cost == *expect_cost(m, i + 1, j + 1) + expect_pair(m, i, j)) {
            expect_put(out, expect_pair(m, i, j) ? &m->got.at[j] : &m->want.at[i]);
            i++, j++;
        } else if (gap && cost == *expect_cost(m, i + 1, j)) {
            expect_put(out, &m->want.at[i++]);
        } else if (came && cost == *expect_cost(m, i, j + 1) + (gap ? 0 : EXPECT_CAME)) {
            if (!gap)
                expect_put(out, &m->got.at[j]);
            j++;
        } else {
            i++;
        }
    }
}

static void expect_update(Arena *arena, const char *want, size_t n, const char *got, size_t k, Buf *out)
{
    ExpectMerge m;

    memset(&m, 0, sizeof m);
    expect_lines(arena, want, n, &m.want);
    expect_lines(arena, got, k, &m.got);
    m.cost = ARENA_ARRAY(arena, unsigned, (m.want.n + 1) * (m.got.n + 1));
    for (size_t i = m.want.n + 1; i-- > 0;)
        for (size_t j = m.got.n + 1; j-- > 0;)
            *expect_cost(&m, i, j) = expect_least(&m, i, j);
    expect_walk(&m, out);
}

#endif
