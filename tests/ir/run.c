// SPDX-License-Identifier: Apache-2.0
// Runs passes on IR text and compares what comes out.
//
//     run FILE.smt…     `passes NAME,NAME` in the header, the parts `ir` and `ir out`.  An `ir` that names no machine gets
//                       the declarations below in front, and they are taken off what comes out.
//     run FILE.ir…      reads, checks, prints, reads again: the text must stay as it is, comment lines apart
//     run -p FILE.smt   prints what came out, to be looked at and put into the file
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compiler/passes/pass.h"
#include "compiler/script/testfile.h"
#include "tests/test.h"

static const char preamble[] =
    "machine \"test\"\n"
    "vector \"test\" size 96 hash 0x00000000\n"
    "\n"
    "element U64 G at 0 is G\n"
    "element U32 S at 8 is S\n"
    "element I8 i8 writable at 12\n"
    "element U8 u8 writable at 13\n"
    "element I16 i16 writable at 14\n"
    "element U16 u16 writable at 16\n"
    "element I32 i32 writable at 20\n"
    "element U32 u32 writable at 24\n"
    "element I64 i64 writable at 32\n"
    "element U64 u64 writable at 40\n"
    "element F32 f32 writable at 48\n"
    "element bool flag writable at 52\n"
    "element F64 x writable at 56\n"
    "element F64 y writable at 64\n"
    "element bool a at 72\n"
    "element bool b at 73\n"
    "element bool c at 74\n"
    "time U64 T\n";

static void *from_heap(void *context, void *old, size_t size)
{
    (void)context;
    if (size)
        return realloc(old, size);
    free(old);
    return NULL;
}

static char *read_all(const char *path, size_t *n)
{
    FILE *f = fopen(path, "rb");
    char *text = NULL;

    if (!f || fseek(f, 0, SEEK_END) != 0 || !(text = malloc((size_t)ftell(f) + 1))) {
        fprintf(stderr, "cannot read %s\n", path);
        exit(3);
    }
    *n = (size_t)ftell(f);
    rewind(f);
    *n = fread(text, 1, *n, f);
    text[*n] = '\0';
    fclose(f);
    return text;
}

static bool complain(const char *file, const char *what, const char *details)
{
    fprintf(stderr, "%s: %s%s%s\n", file, what, details ? ": " : "", details ? details : "");
    return false;
}

static bool has_suffix(const char *name, const char *suffix)
{
    size_t n = strlen(name), m = strlen(suffix);

    return n > m && strcmp(name + n - m, suffix) == 0;
}

// ---- .ir: there and back ----

static const char *print_of(Arena *a, const char *file, const char *text, size_t n)
{
    StrPool strings;
    const char *error;
    IrMachine *m;
    Buf out;

    str_pool_init(&strings, a);
    m = ir_read(a, &strings, text, n, &error);
    if (m)
        error = ir_verify(a, m);
    if (error)
        return complain(file, error, NULL), NULL;
    buf_init(&out, a);
    ir_print(m, &out);
    return buf_text(&out);
}

static const char *without_comment_lines(Arena *a, const char *text)
{
    Buf out;

    buf_init(&out, a);
    while (*text) {
        size_t n = strcspn(text, "\n");
        if (*text != '#')
            buf_put(&out, text, n + (text[n] == '\n'));
        text += n + (text[n] == '\n');
    }
    return buf_text(&out);
}

static bool check_round_trip(Arena *a, const char *file, const char *text, size_t n)
{
    const char *once = print_of(a, file, text, n);
    const char *twice = once ? print_of(a, file, once, strlen(once)) : NULL;

    if (!twice)
        return false;
    if (strcmp(once, twice) != 0)
        return complain(file, "printed, read and printed again it is not the same", NULL);
    return strcmp(without_comment_lines(a, text), once) == 0 || complain(file, "it is not printed as it stands", NULL);
}

// ---- .smt: passes ----

static const char *run_passes(Arena *a, const char *file, const char *passes, const char *text)
{
    PassOptions o = {0, passes, true, NULL, NULL};
    StrPool strings;
    const char *error;
    IrMachine *m;
    Buf out;

    str_pool_init(&strings, a);
    m = ir_read(a, &strings, text, strlen(text), &error);
    if (m)
        error = passes_run(a, m, &o);
    if (error)
        return complain(file, error, NULL), NULL;
    buf_init(&out, a);
    ir_print(m, &out);
    return buf_text(&out);
}

static const char *without_preamble(const char *text)
{
    size_t n = strlen(preamble);

    return strncmp(text, preamble, n) == 0 ? text + n : text;
}

static const char *skip_empty_lines(const char *text)
{
    return text + strspn(text, "\n");
}

static bool check_passes(Arena *a, const char *file, const char *text, size_t n, bool print)
{
    TestFile *t = testfile_parse(a, file, text, n);
    const TestPart *in = t->error ? NULL : testfile_part(t, "ir"), *out = t->error ? NULL : testfile_part(t, "ir out");
    const char *passes = t->error ? NULL : testfile_header(t, "passes"), *got;

    if (!in || !out || !passes)
        return complain(file, "no header `passes`, part `ir` or part `ir out`", t->error);
    got = strstr(in->text, "machine ") ? in->text : format_in(a, "%s%s", preamble, in->text);
    got = run_passes(a, file, passes, got);
    if (!got)
        return false;
    if (!strstr(in->text, "machine "))
        got = without_preamble(got);
    got = skip_empty_lines(got);
    if (print)
        fputs(got, stdout);
    return print || strcmp(got, skip_empty_lines(out->text)) == 0 || complain(file, "something else came out", NULL);
}

static bool check_file(const char *file, bool print)
{
    size_t n;
    char *text = read_all(file, &n);
    volatile bool ok = false;
    jmp_buf oom;
    Arena a;

    arena_init(&a, from_heap, NULL, &oom);
    if (setjmp(oom) == 0)
        ok = has_suffix(file, ".ir") ? check_round_trip(&a, file, text, n) : check_passes(&a, file, text, n, print);
    arena_free(&a);
    free(text);
    return ok;
}

int main(int argc, char **argv)
{
    bool print = argc > 1 && strcmp(argv[1], "-p") == 0;

    for (int i = 1 + print; i < argc; i++)
        CHECK(check_file(argv[i], print));
    return print ? 0 : test_end("ir");
}
