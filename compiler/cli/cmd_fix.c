// SPDX-License-Identifier: Apache-2.0
// smc fix FILE…: makes the edits that the diagnostics of the sources propose, and says what is left.
#include "compiler/cli/cli.h"
#include "compiler/syntax/parse.h"

enum { ROUNDS = 10 };         // one edit may bring another mistake to light

static bool kind_of(const char *path, FileKind *kind)
{
    static const struct { const char *suffix; FileKind kind; } kinds[] = {{".sm", FILE_SM}, {".sv", FILE_SV}, {".ss", FILE_SS}};

    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        if (has_suffix(path, kinds[i].suffix)) {
            *kind = kinds[i].kind;
            return true;
        }
    return false;
}

static void diagnose(Cli *c, const Source *src, FileKind kind)
{
    diags_init(&c->session.diags, &c->session.arena);
    parse_file(&c->session.arena, &c->session.strings, &c->session.diags, src, kind);
    diags_sort(&c->session.diags);
}

// The text after as many rounds as make it better; *fixed counts the diagnostics that are gone.
static Source *improve(Cli *c, Source *src, FileKind kind, size_t *fixed)
{
    for (int i = 0; i < ROUNDS; i++) {
        size_t errors = c->session.diags.errors, made;
        Source *better;
        Buf text;
        buf_init(&text, &c->session.arena);
        made = diags_apply_edits(&c->session.diags, src, &text);
        if (made == 0)
            break;
        better = source_new(&c->session.arena, src->name, buf_text(&text), text.n);
        diagnose(c, better, kind);
        if (c->session.diags.errors >= errors) {          // it did not help: the text before stands
            diagnose(c, src, kind);
            break;
        }
        *fixed += made;
        src = better;
    }
    return src;
}

static int fix_file(Cli *c, const char *path, Buf *report)
{
    Source *src = cli_load(c, path), *better;
    FileKind kind = FILE_SM;
    size_t fixed = 0;
    int left;

    if (!src)
        return EXIT_ENVIRONMENT;
    kind_of(path, &kind);
    diagnose(c, src, kind);
    better = improve(c, src, kind, &fixed);
    if (better != src) {
        OsOutput out = {path, better->text, better->len};
        if (!cli_write(c, &out, 1))
            return EXIT_ENVIRONMENT;
        buf_printf(report, "%s: %lu fixed\n", path, (unsigned long)fixed);
    }
    left = cli_report(c);
    return left;
}

int cmd_fix(Cli *c)
{
    int code = EXIT_OK;
    FileKind kind;
    Buf report;

    if (c->files == 0)
        return cli_usage(c, "fix wants a file, as in 'smc fix tank.sm'");
    for (size_t i = 0; i < c->files; i++)
        if (!kind_of(c->file[i], &kind))
            return cli_usage(c, "'%s' is no source: names end in .sm, .sv or .ss", c->file[i]);
    buf_init(&report, &c->session.arena);
    for (size_t i = 0; i < c->files; i++) {
        int one = fix_file(c, c->file[i], &report);
        if (one > code)
            code = one;
        if (one == EXIT_ENVIRONMENT)
            break;
    }
    return cli_print(c, 1, &report) ? code : EXIT_ENVIRONMENT;
}
