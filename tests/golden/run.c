// SPDX-License-Identifier: Apache-2.0
// Runs golden cases: compares the output, the files and the exit codes of the smc command.
//
//     run SMC CASE.smt…            UPDATE=1 in the environment: the actual output is written into the cases instead, except for `...` and `[..]`
//                                  where they still match
//
// The parts of a case are files of an empty folder in which its `args` lines, one command each, are run by the shell one
// after another with the command's path before them.  Then are compared:
//     -- stdout --, -- stderr --   all that was printed; without the part, nothing may have been
//     -- exit --                   the commands' exit codes; without the part, all 0
//     -- file NAME --              the content of that file afterwards
// In a part NAME.smt a line of that file which would end the part begins with a backslash: `\-- app.sm --`.
// expect.h defines `...` and `[..]`.  `-- stdin --` is the standard input of the commands.
#define _XOPEN_SOURCE 700

#include <errno.h>
#include <setjmp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "compiler/script/testfile.h"
#include "tests/golden/expect.h"
#include "tests/heap.h"

typedef struct Golden {
    Arena arena;
    const TestFile *f;
    const char *folder;
    const char *smc;
    Buf why;
    Buf codes, zeros;         // the actual exit codes; the codes if every command succeeds
} Golden;

static void die(const char *what, const char *path)
{
    fprintf(stderr, "%s '%s': %s\n", what, path, strerror(errno));
    exit(3);
}

// ---- files ----

static const char *read_file(Arena *arena, const char *path, size_t *n)
{
    FILE *in = fopen(path, "rb");
    char block[4096];
    Buf b;

    buf_init(&b, arena);
    if (!in)
        return NULL;
    while ((*n = fread(block, 1, sizeof block, in)) > 0)
        buf_put(&b, block, *n);
    fclose(in);
    *n = b.n;
    return buf_text(&b);
}

static void write_file(const char *path, const char *text, size_t n)
{
    FILE *out = fopen(path, "wb");

    if (!out || fwrite(text, 1, n, out) != n || fclose(out) != 0)
        die("cannot write", path);
}

static const char *in_folder(Golden *g, const char *name) { return format_in(&g->arena, "%s/%s", g->folder, name); }

// ---- expectations ----

static size_t without_blank_end(const char *text, size_t n)
{
    while (n && text[n - 1] == '\n')
        n--;
    return n;
}

static void expect(Golden *g, const char *part_name, const char *otherwise, const char *got, size_t n)
{
    const TestPart *p = testfile_part(g->f, part_name);
    const char *want = p ? p->text : otherwise;
    size_t m = without_blank_end(want, strlen(want));

    n = without_blank_end(got, n);
    if (expect_matches(want, want + m, got, got + n))
        return;
    buf_printf(&g->why, "%s: expected\n%.*s\n%s: came\n%.*s\n", part_name, (int)m, want, part_name, (int)n, got);
}

static void expect_file(Golden *g, const TestPart *p, const char *name)
{
    size_t n;
    const char *got = read_file(&g->arena, in_folder(g, name), &n);

    if (got)
        expect(g, p->name, "", got, n);
    else
        buf_printf(&g->why, "%s was not written\n", name);
}

// ---- running ----

static bool is_special(const TestPart *p)
{
    return strcmp(p->name, "stdout") == 0 || strcmp(p->name, "stderr") == 0 || strcmp(p->name, "exit") == 0 ||
           strcmp(p->name, "stdin") == 0 || strncmp(p->name, "file ", 5) == 0;
}

static void make_folders(const char *path)
{
    char *copy = strdup(path);

    for (char *at = copy + 1; (at = strchr(at, '/')) != NULL; at++) {
        *at = '\0';
        if (mkdir(copy, 0700) != 0 && errno != EEXIST)
            die("cannot make", copy);
        *at = '/';
    }
    free(copy);
}

// Returns a nested .smt without the backslashes before its part lines.
static Buf unquoted(Golden *g, const TestPart *p)
{
    Buf b;

    buf_init(&b, &g->arena);
    for (size_t i = 0; i < p->n; i++)
        if (p->text[i] != '\\' || (i > 0 && p->text[i - 1] != '\n') || strncmp(p->text + i, "\\-- ", 4) != 0)
            buf_char(&b, p->text[i]);
    return b;
}

static void lay_out(Golden *g)
{
    const TestPart *input = testfile_part(g->f, "stdin");

    write_file(in_folder(g, ".in"), input ? input->text : "", input ? input->n : 0);
    for (size_t i = 0; i < g->f->part.n; i++) {
        const TestPart *p = &g->f->part.at[i];
        Buf text = unquoted(g, p);
        if (is_special(p))
            continue;
        make_folders(in_folder(g, p->name));
        write_file(in_folder(g, p->name), buf_text(&text), text.n);
    }
}

static int shell(const char *command)
{
    int status = system(command);

    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

static void run_commands(Golden *g)
{
    buf_init(&g->codes, &g->arena);
    buf_init(&g->zeros, &g->arena);
    for (size_t i = 0; i < g->f->header.n; i++) {
        const TestHeader *h = &g->f->header.at[i];
        if (strcmp(h->key, "args") != 0)
            continue;
        buf_printf(&g->zeros, "%s0", g->zeros.n ? " " : "");
        buf_printf(&g->codes, "%s%d", g->codes.n ? " " : "", shell(format_in(&g->arena, "ROOT=$PWD; cd '%s' && SMC='%s' && { \"$SMC\" %s; } <.in >>.out 2>>.err", g->folder,
                                                                        g->smc, h->value)));
    }
}

static void compare(Golden *g)
{
    size_t n;
    const char *text;

    if ((text = read_file(&g->arena, in_folder(g, ".out"), &n)) != NULL)
        expect(g, "stdout", "", text, n);
    if ((text = read_file(&g->arena, in_folder(g, ".err"), &n)) != NULL)
        expect(g, "stderr", "", text, n);
    expect(g, "exit", buf_text(&g->zeros), buf_text(&g->codes), g->codes.n);
    for (size_t i = 0; i < g->f->part.n; i++)
        if (strncmp(g->f->part.at[i].name, "file ", 5) == 0)
            expect_file(g, &g->f->part.at[i], g->f->part.at[i].name + 5);
}

// ---- UPDATE=1 ----

static void put_part(Buf *out, const char *name, const char *text, size_t n)
{
    if (without_blank_end(text, n) == 0)
        return;
    buf_printf(out, "-- %s --\n", name);
    buf_put(out, text, without_blank_end(text, n));
    buf_char(out, '\n');
}

static void put_came(Golden *g, Buf *out, const char *part_name, const char *file)
{
    const TestPart *p = testfile_part(g->f, part_name);
    size_t n;
    const char *text = read_file(&g->arena, in_folder(g, file), &n);
    Buf merged;

    if (!text)
        return;
    buf_init(&merged, &g->arena);
    expect_update(&g->arena, p ? p->text : "", p ? without_blank_end(p->text, p->n) : 0, text, without_blank_end(text, n), &merged);
    put_part(out, part_name, buf_text(&merged), merged.n);
}

static void update(Golden *g, const char *path, const char *text)
{
    const char *end = strstr(text, "\n-- ");
    Buf out;

    buf_init(&out, &g->arena);
    buf_put(&out, text, end ? (size_t)(end + 1 - text) : strlen(text));
    for (size_t i = 0; i < g->f->part.n; i++) {
        const TestPart *p = &g->f->part.at[i];
        if (!is_special(p)) {
            buf_printf(&out, "-- %s --\n", p->name);
            buf_put(&out, p->text, p->n);
        } else if (strcmp(p->name, "stdin") == 0) {
            put_part(&out, p->name, p->text, p->n);
        } else if (strncmp(p->name, "file ", 5) == 0) {
            put_came(g, &out, p->name, p->name + 5);
        }
    }
    put_came(g, &out, "stdout", ".out");
    put_came(g, &out, "stderr", ".err");
    if (strcmp(buf_text(&g->codes), buf_text(&g->zeros)) != 0)
        put_part(&out, "exit", buf_text(&g->codes), g->codes.n);
    write_file(path, buf_text(&out), out.n);
}

// ---- a case ----

static bool run_case(Golden *g, const char *path)
{
    const char *tmp = getenv("TMPDIR");
    char *name = strdup(format_in(&g->arena, "%s/golden-XXXXXX", tmp && *tmp ? tmp : "/tmp"));
    const char *text;
    size_t n;

    if ((text = read_file(&g->arena, path, &n)) == NULL)
        die("cannot read", path);
    g->f = testfile_parse(&g->arena, path, text, n);
    buf_init(&g->why, &g->arena);
    if (g->f->error && !getenv("UPDATE"))
        buf_printf(&g->why, "%s\n", g->f->error);
    if (!testfile_header(g->f, "args"))
        buf_str(&g->why, "no args line\n");
    if ((g->folder = mkdtemp(name)) == NULL)
        die("cannot make", name);
    lay_out(g);
    run_commands(g);
    compare(g);
    if (g->why.n && getenv("UPDATE")) {
        update(g, path, text);
        g->why.n = 0;
    }
    shell(format_in(&g->arena, "rm -rf '%s'", g->folder));
    free(name);
    if (g->why.n)
        fprintf(stderr, "%s: failed\n%s", path, buf_text(&g->why));
    return g->why.n == 0;
}

int main(int argc, char **argv)
{
    int passed = 0, failed = 0;
    jmp_buf oom;

    if (argc < 2 || setjmp(oom)) {
        fputs("usage: run SMC CASE.smt...\n", stderr);
        return 2;
    }
    for (int i = 2; i < argc; i++) {
        Golden g = {.smc = realpath(argv[1], NULL)};
        arena_init(&g.arena, heap_alloc, NULL, &oom);
        *(run_case(&g, argv[i]) ? &passed : &failed) += 1;
        arena_free(&g.arena);
        free((void *)(size_t)g.smc);
    }
    printf("golden: %d passed, %d failed\n", passed, failed);
    return failed != 0 || passed == 0;
}
