// SPDX-License-Identifier: Apache-2.0
// Runs passes on IR text and compares the result.
//
//     run FILE.smt…     `passes NAME,NAME` in the header, the parts `ir` and `ir out`.  An `ir` that names no machine gets
//                       the declarations below before it, and they are removed from the result.
//                       With a part NAME.sm instead of `ir` the machine is built first, unoptimised; `passes` may be absent.
//                       Without a part `ir out` the machine is built and must be reproduced by its text, at every
//                       -O: so all cases of conformance/ can be given.
//     run FILE.ir…      reads, checks, prints, reads again: the text must not change, except for comment lines
//     run -p FILE.smt   prints the results, to be reviewed and put into the file
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compiler/passes/pass.h"
#include "compiler/case.h"
#include "tests/heap.h"
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

static bool compared;                  // a part of the file was compared; a case that only has errors has no IR, and is no test

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

// ---- machines from text ----

static IrMachine *read_machine(Session *s, const char *file, const char *text, size_t n)
{
    const char *error;
    IrMachine *m = ir_read(&s->arena, &s->strings, text, n, &error);

    if (m)
        error = ir_verify(&s->arena, m);
    if (error)
        return complain(file, error, NULL), NULL;
    return m;
}

static const char *print_of(Session *s, const IrMachine *m)
{
    Buf out;

    buf_init(&out, &s->arena);
    ir_print(m, &out);
    return buf_text(&out);
}

// Returns NULL if the case has no machine, or the machine has errors.
static const Program *program_of(Session *s, const TestFile *t)
{
    const CompileOptions o = {.skip_analyses = true};
    CaseSources sources;
    Compiled made;

    case_list_sources(s, t, &sources);
    compile_sources(s, &sources.in, &o, &made);
    for (size_t i = 0; i < sources.in.n; i++)
        if (sources.in.at[i].kind == FILE_SM)
            return made.of[i].program;
    return NULL;
}

// ---- there and back ----

static bool same_after_reading(Session *s, const char *file, const IrMachine *m)
{
    const char *once = (compared = true, print_of(s, m));
    const IrMachine *again = read_machine(s, file, once, strlen(once));

    return again && (strcmp(once, print_of(s, again)) == 0 || complain(file, "printed, read and printed again it is not the same", once));
}

static const char *without_comment_lines(Session *s, const char *text)
{
    Buf out;

    buf_init(&out, &s->arena);
    while (*text) {
        size_t n = strcspn(text, "\n");
        if (*text != '#')
            buf_put(&out, text, n + (text[n] == '\n'));
        text += n + (text[n] == '\n');
    }
    return buf_text(&out);
}

static bool check_ir_file(Session *s, const char *file, const char *text, size_t n)
{
    const IrMachine *m = read_machine(s, file, text, n);

    if (!m || !same_after_reading(s, file, m))
        return false;
    return strcmp(without_comment_lines(s, text), print_of(s, m)) == 0 || complain(file, "it is not printed as it stands", NULL);
}

static bool check_every_level(Session *s, const char *file, const TestFile *t)
{
    const Program *p = program_of(s, t);

    for (int level = 0; p && level <= 2; level++)
        if (!same_after_reading(s, file, session_ir(s, p, level)))
            return false;
    return true;
}

// ---- passes ----

static const char *without_preamble(const char *text)
{
    size_t n = strlen(preamble);

    return strncmp(text, preamble, n) == 0 ? text + n : text;
}

static const char *skip_empty_lines(const char *text)
{
    return text + strspn(text, "\n");
}

static IrMachine *machine_of(Session *s, const TestFile *t)
{
    const TestPart *ir = testfile_part(t, "ir");
    const Program *p;
    const char *text;

    if (!ir) {
        p = program_of(s, t);
        return p ? session_ir(s, p, 0) : (complain(t->name, "the machine does not compile", NULL), NULL);
    }
    text = strstr(ir->text, "machine ") ? ir->text : format_in(&s->arena, "%s%s", preamble, ir->text);
    return read_machine(s, t->name, text, strlen(text));
}

static bool check_passes(Session *s, const TestFile *t, bool print)
{
    PassOptions o = {.only = testfile_header(t, "passes"), .verify = true, .soft = testfile_header(t, "soft") != NULL};
    IrMachine *m = machine_of(s, t);
    const char *wrong = m ? passes_run(&s->arena, m, &o) : NULL, *got;

    if (!m || wrong)
        return wrong ? complain(t->name, wrong, NULL) : false;
    compared = true;
    got = skip_empty_lines(without_preamble(print_of(s, m)));
    if (print)
        fputs(got, stdout);
    return print || strcmp(got, skip_empty_lines(testfile_part(t, "ir out")->text)) == 0 || complain(t->name, "something else came out", got);
}

static bool check_smt(Session *s, const char *file, const char *text, size_t n, bool print)
{
    TestFile *t = testfile_parse(&s->arena, file, text, n);

    if (t->error)
        return complain(file, t->error, NULL);
    if (testfile_part(t, "ir out"))
        return check_passes(s, t, print);
    return check_every_level(s, file, t);
}

static bool check_file(const char *file, bool print)
{
    size_t n;
    char *text = read_all(file, &n);
    volatile bool ok = false;
    jmp_buf oom;
    Session s;

    session_init(&s, heap_alloc, NULL, &oom);
    if (setjmp(oom) == 0)
        ok = has_suffix(file, ".ir") ? check_ir_file(&s, file, text, n) : check_smt(&s, file, text, n, print);
    session_free(&s);
    free(text);
    return ok;
}

int main(int argc, char **argv)
{
    bool print = argc > 1 && strcmp(argv[1], "-p") == 0;

    for (int i = 1 + print; i < argc; i++) {
        compared = false;
        if (!check_file(argv[i], print))
            test_count(false, argv[i]);
        else if (compared)
            test_count(true, argv[i]);
    }
    return print ? 0 : test_end("ir");
}
