// SPDX-License-Identifier: Apache-2.0
// A file of the folder is overwritten only if it is empty, or if smc mutate has written it for this machine and it was not edited since.  The name of
// a script consists of the name of the machine, the position of the change, and which change of that position it is, so a second call writes the same
// files.
#include "compiler/cli/mutate_scripts.h"

#include <string.h>

#include "compiler/base/path.h"
#include "compiler/cover/cover.h"
#include "compiler/search/generated.h"
#include "compiler/search/script_writer.h"

#define MADE_BY "smc mutate"

enum { STEPS_MOST = 1000000 };        // a script that runs longer is ended

typedef struct ScriptsRun {
    Cli *c;
    Arena *arena;
    Mutation *u;
    const Program *p;
    const char *machine, *folder;
    MutateScripts *out;
} ScriptsRun;

// Returns the path of a mutant's script: tank-change-18-21-1.ss, with the line, the column, and which change of this position it is.
static const char *path_of(const ScriptsRun *r, const Mutant *m)
{
    const LineCol at = source_position(m->span.src, m->span.at);
    const Mutant *first = m;
    uint32_t n;

    while (first > mutation_list(r->u, &n) && first[-1].span.at == m->span.at)
        first--;
    return format_in(r->arena, "%s%s%s-change-%lu-%lu-%lu.ss", r->folder, path_ends_in_separator(r->folder) ? "" : "/", r->p->name->text,
                     (unsigned long)at.line, (unsigned long)at.col, (unsigned long)(m - first + 1));
}

// Whether a script can be written to this path: no file has it, or one that smc mutate wrote for this machine.
static bool can_write(const ScriptsRun *r, const char *path)
{
    enum { MOST = 1 << 24 };
    const char *why;
    char head, *text = NULL;
    size_t n;
    bool is_ours;

    if (!os_read_head(path, &head, 1, &n))
        return false;
    if (n == 0)
        return true;
    is_ours = os_read_file(path, MOST, &text, &n, &why) && generated_read(MADE_BY, r->machine, text, n) == GENERATED_WHOLE;
    os_alloc(NULL, text, 0);
    return is_ours;
}

// Appends the script that shows a mutant.  Returns false if its scenario cannot be written.
static bool write_text(const ScriptsRun *r, const Mutant *m, Buf *out)
{
    const LineCol at = source_position(m->span.src, m->span.at);
    const char *comment[] = {NULL, "", "The asserts show what the machine does, not what it should do: check them before you rely on them."};
    Scenario s = *m->scenario;
    const ScriptPage page = {.p = r->p, .scenario = &s, .engine = engine_ref_open(r->arena, r->p), .comment = comment, .comments = 3};
    Buf change, body;

    buf_init(&change, r->arena);
    buf_init(&body, r->arena);
    buf_printf(&change, "Fails if line %lu is changed: ", (unsigned long)at.line);
    mutant_write_change(r->arena, m, &change);
    buf_char(&change, '.');
    comment[0] = buf_text(&change);
    s.steps++;                                                 // one more step, which shows the state to which the last one leads
    if (!script_write(r->arena, &page, &body))
        return false;
    generated_write(MADE_BY, r->machine, &body, out);
    return true;
}

static bool passes_on_machine(const ScriptsRun *r, const Script *s, Engine *e)
{
    const ScriptOptions o = {.max_steps = STEPS_MOST, .is_compared = true, .is_silent = true};

    return script_run(r->arena, &r->c->session.diags, s, &e, 1, &o).outcome == SCRIPT_PASSED;
}

static bool fails_on(const ScriptsRun *r, const Script *s, const Mutant *m)
{
    return !passes_on_machine(r, s, engine_flat_open(r->arena, r->p, mutation_build(r->u, r->arena, m)));
}

// Records this script for each mutant that it shows and that has no script yet.
static void record_shown_mutants(const ScriptsRun *r, const Script *s, const char *path)
{
    uint32_t n;
    const Mutant *m = mutation_list(r->u, &n);

    for (uint32_t i = 0; i < n; i++)
        if (m[i].verdict == MUTANT_GENERATED && !r->out->by_mutant[i] && fails_on(r, s, &m[i])) {
            r->out->by_mutant[i] = path;
            r->out->shown++;
        }
}

// Writes the script of a mutant, if it passes on the machine and fails on the mutant.
static int write_script(const ScriptsRun *r, const Mutant *m)
{
    const char *path = path_of(r, m);
    Diags *diags = &r->c->session.diags;
    const Script *s;
    OsOutput file;
    Buf text;
    int code;

    buf_init(&text, r->arena);
    if (!write_text(r, m, &text))
        return EXIT_OK;
    s = session_script(&r->c->session, source_new(r->arena, path, buf_text(&text), text.n), r->p);
    diags_clear(diags);
    if (!s || !passes_on_machine(r, s, engine_ref_open(r->arena, r->p)) || !fails_on(r, s, m)) {
        diags_clear(diags);
        return EXIT_OK;
    }
    if (!can_write(r, path)) {
        cli_print_note(r->c, TEXT_mutate_kept, cli_printable_name(r->arena, path));
        return EXIT_OK;
    }
    file = (OsOutput){path, buf_text(&text), text.n};
    if ((code = cli_write_generated(r->c, &file)) != EXIT_OK)
        return code;
    r->out->scripts++;
    record_shown_mutants(r, s, path);
    diags_clear(diags);
    return EXIT_OK;
}

// Writes a script for each mutant for which inputs were found. A script that also fails on later mutants serves for these, too.
int mutate_write_scripts(Cli *c, Mutation *u, const Program *p, const char *machine, const char *folder, MutateScripts *out)
{
    Arena *arena = &c->session.arena;
    const ScriptsRun r = {c, arena, u, p, machine, folder, out};
    const char *why;
    uint32_t all, n;
    const Mutant *first = mutation_list(u, &all), **order = mutation_order(u, arena, MUTANT_GENERATED, &n);
    int code = EXIT_OK;

    *out = (MutateScripts){ARENA_ARRAY(arena, const char *, all + 1), 0, 0};
    if (!os_make_folder(folder, &why)) {
        cli_print_error(c, TEXT_cannot_write, cli_printable_name(arena, folder), why);
        return EXIT_ENVIRONMENT;
    }
    for (uint32_t i = 0; i < n && code == EXIT_OK; i++)
        if (!out->by_mutant[order[i] - first])
            code = write_script(&r, order[i]);
    return code;
}

void mutate_show_progress(const Mutation *u, ProgressLine *k)
{
    MutationScore s;

    if (!progress_is_due(k))
        return;
    s = mutation_score(u);
    if (s.of[MUTANT_WAITING])
        progress_show(k, format_in(&k->c->session.arena, "changes: %lu of %lu tried, %lu not noticed", s.all - s.of[MUTANT_WAITING], s.all,
                                   s.of[MUTANT_UNNOTICED]));
    else
        progress_show(k, format_in(&k->c->session.arena, "inputs found for %lu of %lu changes that no script notices", s.of[MUTANT_GENERATED],
                                   s.of[MUTANT_GENERATED] + s.of[MUTANT_UNNOTICED]));
}
