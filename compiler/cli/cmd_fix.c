// SPDX-License-Identifier: Apache-2.0
// smc fix FILE…: applies the edits that the findings of `smc check` propose, lists them, and reports the remaining findings.
#include <string.h>

#include "compiler/cli/cli.h"

enum { ROUNDS = 10 };         // most rounds: one edit can reveal another error

typedef struct Fix {
    Cli *c;
    CompileInput in;
    CompileOptions o;
    const Source **was;       // by argument: the source as first read, before any edit
    size_t *fixed;            // by argument: number of findings fixed
} Fix;

// Compiles the current texts of all files. The diagnostics remain in the session.
static void compile_and_diagnose(Fix *f)
{
    Compiled out;

    diags_init(&f->c->session.diags, &f->c->session.arena);
    for (size_t i = 0; i < f->in.n && f->in.vector; i++)       // --sv can name one of the files, which is then fixed too
        if (strcmp(f->c->file[i], f->c->value[OPT_SV]) == 0)
            f->in.vector = f->in.at[i].text;
    compile_sources(&f->c->session, &f->in, &f->o, &out);
}

// ---- edits ----

static size_t count_code(const Diags *d, DiagCode code)
{
    size_t n = 0;

    for (size_t i = 0; i < d->list.n; i++)
        n += d->list.at[i]->code == code;
    return n;
}

// Returns the position of the first error of a file; UINT32_MAX if the file has no error.
static uint32_t first_error(const Diags *d, const Source *src)
{
    for (size_t i = 0; i < d->list.n; i++)
        if (d->list.at[i]->severity == DIAG_ERROR && d->list.at[i]->span.src == src)
            return d->list.at[i]->span.at;
    return UINT32_MAX;
}

// Whether a round has improved the sources: fewer errors remain; or as many remain, but the first error of the file is further down than before
// (a later one was revealed), or some diagnostic that has edits occurs less often.
static bool is_better(const Diags *now, const Source *src, const Diags *before, const Source *was)
{
    const uint32_t grown = src->len > was->len ? src->len - was->len : 0, old = first_error(before, was);

    if (now->errors != before->errors)
        return now->errors < before->errors;
    if (old != UINT32_MAX && first_error(now, src) > old + grown)
        return true;
    for (size_t i = 0; i < before->list.n; i++) {
        const Diag *d = before->list.at[i];
        if (d->edits.n && count_code(now, d->code) < count_code(before, d->code))
            return true;
    }
    return false;
}

// Applies the edits that the diagnostics propose to file i. Returns false, with the file unchanged, if no edit applies or the result is not better.
static bool apply_edits_to_file(Fix *f, size_t i)
{
    Cli *c = f->c;
    Diags before = c->session.diags;
    const Source *was = f->in.at[i].text;
    Buf text;
    size_t made;

    buf_init(&text, &c->session.arena);
    if ((made = diags_apply_edits(&before, was, &text)) == 0)
        return false;
    f->in.at[i].text = source_new(&c->session.arena, was->name, buf_text(&text), text.n);
    compile_and_diagnose(f);
    if (!is_better(&c->session.diags, f->in.at[i].text, &before, was)) {
        f->in.at[i].text = was;
        c->session.diags = before;
        return false;
    }
    f->fixed[i] += made;
    return true;
}

// ---- the command ----

// Writes the changed files, unless --dry-run is given, and adds their changed lines to `report`. Returns false after the message of a failed
// write.
static bool write_fixed(Fix *f, Buf *report)
{
    Cli *c = f->c;

    for (size_t i = 0; i < c->files; i++) {
        OsOutput out = {c->file[i], f->in.at[i].text->text, f->in.at[i].text->len};
        if (f->fixed[i] == 0)
            continue;
        if (!c->given[OPT_DRY_RUN] && cli_write_edited(c, &out) != EXIT_OK)
            return false;
        fix_write_changes(f->was[i], f->in.at[i].text, report);
        buf_printf(report, "%s: %lu %s\n", c->file[i], (unsigned long)f->fixed[i], c->given[OPT_DRY_RUN] ? "to fix" : "fixed");
    }
    return true;
}

int cmd_fix(Cli *c)
{
    Fix f = {.c = c};
    bool any = true;          // the last round fixed something
    int code, left;
    Buf report;

    if (c->files == 0)
        return cli_usage_error(c, TEXT_fix_what);
    if (!cli_check_sources(c, false) || !cli_compile_options(c, &f.o))
        return EXIT_USAGE;
    if ((code = cli_read_inputs(c, &f.in)) != EXIT_OK)
        return code;
    f.in.app = NULL;          // files that an application names are fixed by separate calls
    f.was = ARENA_ARRAY(&c->session.arena, const Source *, c->files);
    f.fixed = ARENA_ARRAY(&c->session.arena, size_t, c->files);
    for (size_t i = 0; i < c->files; i++)
        f.was[i] = f.in.at[i].text;
    compile_and_diagnose(&f);
    for (int round = 0; round < ROUNDS && any; round++) {
        any = false;
        for (size_t i = 0; i < c->files; i++)
            any = apply_edits_to_file(&f, i) || any;
    }
    buf_init(&report, &c->session.arena);
    code = write_fixed(&f, &report) ? EXIT_OK : EXIT_ENVIRONMENT;
    left = cli_print_diagnostics(c);
    return cli_print(c, cli_is_standard_output(c, OPT_MESSAGE_FILE) ? 2 : 1, &report) && code == EXIT_OK ? left : EXIT_ENVIRONMENT;
}
