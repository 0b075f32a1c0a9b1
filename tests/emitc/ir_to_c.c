// SPDX-License-Identifier: Apache-2.0
// IR text to C, for tests that want to look at emitted C without a machine's source: ir_to_c FILE.ir OUT [PREFIX]
// writes OUT.c and OUT.h.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compiler/emit/c/emit_c.h"

static void *host_alloc(void *context, void *old, size_t size)
{
    (void)context;
    if (size == 0) {
        free(old);
        return NULL;
    }
    return realloc(old, size);
}

static char text[1 << 24];

static int write_file(const char *stem, const char *ending, const Buf *b)
{
    char path[1000];
    FILE *f;

    snprintf(path, sizeof path, "%s%s", stem, ending);
    f = fopen(path, "w");
    if (!f)
        return 1;
    fwrite(buf_text(b), 1, b->n, f);
    return fclose(f) != 0;
}

static const char *last_name(const char *path) { return strrchr(path, '/') ? strrchr(path, '/') + 1 : path; }

int main(int argc, char **argv)
{
    Arena arena;
    jmp_buf oom;
    StrPool strings;
    Buf header, code;
    const char *error;
    IrMachine *m;
    EmitCOptions o = { 0 };
    FILE *f = argc > 2 ? fopen(argv[1], "r") : NULL;

    if (!f || setjmp(oom))
        return 2;
    arena_init(&arena, host_alloc, NULL, &oom);
    str_pool_init(&strings, &arena);
    m = ir_read(&arena, &strings, text, fread(text, 1, sizeof text, f), &error);
    if (!m || (error = ir_verify(&arena, m)) != NULL) {
        fprintf(stderr, "%s: %s\n", argv[1], error);
        return 1;
    }
    buf_init(&header, &arena);
    buf_init(&code, &arena);
    o.prefix = argc > 3 ? argv[3] : NULL;
    o.header = format_in(&arena, "%s.h", last_name(argv[2]));
    emit_c_machine(&arena, m, &o, &header, &code);
    fclose(f);
    return write_file(argv[2], ".h", &header) || write_file(argv[2], ".c", &code);
}
