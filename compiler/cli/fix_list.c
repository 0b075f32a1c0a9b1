// SPDX-License-Identifier: Apache-2.0
// Lists the changes of smc fix in a file, line by line. Where two texts differ, they are resynchronised at the nearest lines that both
// contain.
#include <string.h>

#include "compiler/cli/cli.h"

// A source before and after its edits.
typedef struct SourcePair { const Source *was, *is; } SourcePair;

// Whether line i of `was` equals line k of `is`.
static bool same_line(const SourcePair *t, uint32_t i, uint32_t k)
{
    uint32_t n, m;
    const char *a = source_line(t->was, i, &n), *b = source_line(t->is, k, &m);

    return n == m && memcmp(a, b, n) == 0;
}

// Finds how many lines were removed at line i of `was` and added at line k of `is`, until both texts continue with equal lines or end.
static void find_change(const SourcePair *t, uint32_t i, uint32_t k, uint32_t *removed, uint32_t *added)
{
    const uint32_t n = t->was->lines + 1 - i, m = t->is->lines + 1 - k;

    for (uint32_t both = 1; both < n + m; both++)
        for (uint32_t g = 0; g <= both; g++)
            if (g < n && both - g < m && same_line(t, i + g, k + both - g)) {
                *removed = g;
                *added = both - g;
                return;
            }
    *removed = n;
    *added = m;
}

// Writes one line of a source after its mark, "  - " or "  + ".
static void write_line(Buf *out, const char *mark, const Source *s, uint32_t line)
{
    uint32_t len;
    const char *text = source_line(s, line, &len);

    buf_str(out, mark);
    diag_put_printable(out, text, len);
    buf_char(out, '\n');
}

void fix_write_changes(const Source *was, const Source *is, Buf *out)
{
    const SourcePair t = {was, is};
    uint32_t i = 1, k = 1, removed, added;

    while (i <= was->lines || k <= is->lines) {
        if (i <= was->lines && k <= is->lines && same_line(&t, i, k)) {
            i++, k++;
            continue;
        }
        find_change(&t, i, k, &removed, &added);
        buf_printf(out, "%s:%lu:\n", was->name, (unsigned long)i);
        for (; removed > 0; removed--)
            write_line(out, "  - ", was, i++);
        for (; added > 0; added--)
            write_line(out, "  + ", is, k++);
    }
}
