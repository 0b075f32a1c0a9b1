// SPDX-License-Identifier: Apache-2.0
// Without an argument: writes docs/diagnostics.md to standard output.  With one: tells whether that file still is what would
// be written, line ends apart.
#include <string.h>

#include "compiler/diag/diag.h"
#include "tests/unit/host.h"

static size_t read_without_cr(FILE *f, char *at, size_t most)
{
    size_t n = 0;

    for (int c; n < most && (c = getc(f)) != EOF; )
        if (c != '\r')
            at[n++] = (char)c;
    return n;
}

static int compare(const Buf *made, const char *path)
{
    FILE *f = fopen(path, "rb");
    char *kept = malloc(made->n + 1);
    bool same = f && kept && read_without_cr(f, kept, made->n + 1) == made->n && memcmp(kept, made->at, made->n) == 0;

    if (f)
        fclose(f);
    free(kept);
    if (!same)
        printf("%s is not what codes.def says any more: make docs\n", path);
    printf("%d passed, %d failed\n", same, !same);
    return !same;
}

static int run(Arena *arena, const char *path)
{
    Buf out;

    buf_init(&out, arena);
    diags_write_markdown(&out);
    if (path)
        return compare(&out, path);
    return fwrite(out.at, 1, out.n, stdout) != out.n;
}

int main(int argc, char **argv)
{
    static Arena arena;
    static int code;

    HOST_ARENA(&arena);
    code = run(&arena, argc > 1 ? argv[1] : NULL);
    arena_free(&arena);
    return code;
}
