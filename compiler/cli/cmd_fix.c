// SPDX-License-Identifier: Apache-2.0
// smc fix FILE…: applies the edits that the findings of `smc check` propose, lists them, and reports the remaining findings.
#include <string.h>

#include "compiler/cli/cli.h"
#include "compiler/syntax/parse.h"

enum { ROUNDS = 10 };         // one edit can reveal another error

typedef struct Fix {
    Cli *c;
    Source **src, **was;      // of each argument: the current text, and the text as read
    size_t *fixed;            // number of findings fixed in each
    const Source *sv;         // from --sv; NULL: none
    size_t machines;
} Fix;

// ---- messages ----

static const Source *state_vector(const Fix *f)
{
    const Cli *c = f->c;

    for (size_t i = 0; f->sv && i < c->files; i++)
        if (strcmp(c->file[i], c->value[OPT_SV]) == 0)
            return f->src[i];
    return f->sv;
}

static bool is_script_of_machine(const Fix *f, size_t i)
{
    return f->machines == 1 && has_suffix(f->c->file[i], ".ss");
}

static void diagnose_machine(Fix *f, size_t machine)
{
    Cli *c = f->c;
    Map written = {&c->session.arena, NULL, NULL, 0, 0};
    MachineInput in = {f->src[machine], state_vector(f), NULL, option_level(c)};
    Source **ss = ARENA_ARRAY(&c->session.arena, Source *, c->files);
    Program *p;

    for (size_t i = 0; i < c->files; i++)
        if (is_script_of_machine(f, i))
            ss[i] = f->src[i];
    cli_note_scripts(c, ss, &written);
    if ((p = session_program(&c->session, &in)) != NULL) {
        session_analyse(&c->session, p);
        in.written_outside = &written;
        p = session_program_for_scripts(&c->session, &in, p);
    }
    for (size_t i = 0; i < c->files; i++)
        if (is_script_of_machine(f, i) && p)
            session_script(&c->session, f->src[i], p);
        else if (is_script_of_machine(f, i))
            session_parse(&c->session, f->src[i], FILE_SS);
}

static void diagnose(Fix *f)
{
    Cli *c = f->c;
    Diags *d = &c->session.diags;

    diags_init(d, &c->session.arena);
    for (size_t i = 0; i < c->files; i++)
        if (has_suffix(c->file[i], ".sm"))
            diagnose_machine(f, i);
        else if (has_suffix(c->file[i], ".sv"))
            session_state_vector(&c->session, f->src[i]);
        else if (has_suffix(c->file[i], ".io") && f->sv)
            session_io(&c->session, f->src[i], f->sv);
        else if (has_suffix(c->file[i], ".io"))
            session_parse(&c->session, f->src[i], FILE_IO);
        else if (has_suffix(c->file[i], ".app"))
            session_parse(&c->session, f->src[i], FILE_APP);
        else if (!is_script_of_machine(f, i))
            session_parse(&c->session, f->src[i], FILE_SS);
    diags_apply_allows(d);
    diags_select(d, &c->warn);
    diags_sort(d);
}

// ---- edits ----

static size_t count(const Diags *d, DiagCode code)
{
    size_t n = 0;

    for (size_t i = 0; i < d->list.n; i++)
        n += d->list.at[i]->code == code;
    return n;
}

// Returns the position of the first error of a file; UINT32_MAX if there is none.
static uint32_t first_error(const Diags *d, const Source *src)
{
    for (size_t i = 0; i < d->list.n; i++)
        if (d->list.at[i]->severity == DIAG_ERROR && d->list.at[i]->span.src == src)
            return d->list.at[i]->span.at;
    return UINT32_MAX;
}

// A round is better in one of two cases. Some findings are fixed and no other errors appeared, so fewer editable findings remain. Or the
// first error is fixed, and a later one was revealed.
static bool is_better(const Diags *now, const Source *src, const Diags *before, const Source *was)
{
    const uint32_t grown = src->len > was->len ? src->len - was->len : 0, old = first_error(before, was);

    if (now->errors != before->errors)
        return now->errors < before->errors;
    if (old != UINT32_MAX && first_error(now, src) > old + grown)
        return true;
    for (size_t i = 0; i < before->list.n; i++) {
        const Diag *d = before->list.at[i];
        if (d->edits.n && count(now, d->code) < count(before, d->code))
            return true;
    }
    return false;
}

// Runs one round on one file; returns false if there was nothing to do, or it did not help.
static bool improve(Fix *f, size_t i)
{
    Cli *c = f->c;
    Diags before = c->session.diags;
    Source *was = f->src[i];
    Buf text;
    size_t made;

    buf_init(&text, &c->session.arena);
    if ((made = diags_apply_edits(&before, was, &text)) == 0)
        return false;
    f->src[i] = source_new(&c->session.arena, was->name, buf_text(&text), text.n);
    diagnose(f);
    if (!is_better(&c->session.diags, f->src[i], &before, was)) {
        f->src[i] = was;
        c->session.diags = before;
        return false;
    }
    f->fixed[i] += made;
    return true;
}

static void improve_all(Fix *f)
{
    bool any = true;

    for (int round = 0; round < ROUNDS && any; round++) {
        any = false;
        for (size_t i = 0; i < f->c->files; i++)
            any = improve(f, i) || any;
    }
}

// ---- the command ----

static bool load(Fix *f)
{
    Cli *c = f->c;

    f->src = ARENA_ARRAY(&c->session.arena, Source *, c->files);
    f->was = ARENA_ARRAY(&c->session.arena, Source *, c->files);
    f->fixed = ARENA_ARRAY(&c->session.arena, size_t, c->files);
    for (size_t i = 0; i < c->files; i++) {
        f->machines += has_suffix(c->file[i], ".sm");
        if ((f->was[i] = f->src[i] = cli_load(c, c->file[i])) == NULL)
            return false;
    }
    return !c->given[OPT_SV] || (f->sv = cli_load(c, c->value[OPT_SV])) != NULL;
}

static bool write_fixed(Fix *f, Buf *report)
{
    Cli *c = f->c;

    for (size_t i = 0; i < c->files; i++) {
        OsOutput out = {c->file[i], f->src[i]->text, f->src[i]->len};
        if (f->fixed[i] == 0)
            continue;
        if (!c->given[OPT_DRY_RUN] && cli_rewrite(c, &out) != EXIT_OK)
            return false;
        fix_list(f->was[i], f->src[i], report);
        buf_printf(report, "%s: %lu %s\n", c->file[i], (unsigned long)f->fixed[i], c->given[OPT_DRY_RUN] ? "to fix" : "fixed");
    }
    return true;
}

static int check_use(Cli *c)
{
    if (c->files == 0)
        return cli_usage(c, "fix wants a file, as in 'smc fix tank.sm'");
    for (size_t i = 0; i < c->files; i++)
        if (!has_suffix(c->file[i], ".sm") && !has_suffix(c->file[i], ".ss") && !has_suffix(c->file[i], ".sv") &&
            !has_suffix(c->file[i], ".io") && !has_suffix(c->file[i], ".app"))
            return cli_usage(c, "'%s' is no source: names end in .sm, .sv, .ss, .io or .app", c->file[i]);
    return EXIT_OK;
}

int cmd_fix(Cli *c)
{
    Fix f = {.c = c};
    int code = check_use(c), left;
    Buf report;

    if (code != EXIT_OK)
        return code;
    if (!step_known(c))
        return EXIT_USAGE;
    if (!load(&f))
        return EXIT_ENVIRONMENT;
    diagnose(&f);
    improve_all(&f);
    buf_init(&report, &c->session.arena);
    code = write_fixed(&f, &report) ? EXIT_OK : EXIT_ENVIRONMENT;
    left = cli_report(c);
    return cli_print(c, 1, &report) && code == EXIT_OK ? left : EXIT_ENVIRONMENT;
}
