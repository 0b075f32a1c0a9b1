// SPDX-License-Identifier: Apache-2.0
// The folder of smc cover: the scripts that earlier calls have written, and the names of new ones.
#include <stdlib.h>
#include <string.h>

#include "compiler/base/path.h"
#include "compiler/cli/cover_run.h"

static const char *path_in_folder(const CoverRun *r, const char *name)
{
    return format_in(r->arena, "%s%s%s", r->folder, path_ends_in_separator(r->folder) ? "" : "/", name);
}

// ---- reading ----

// Whether the command line names this file.
static bool is_argument(const Cli *c, const char *path)
{
    for (size_t i = 0; i < c->files; i++)
        if (os_same_file(c->file[i], path))
            return true;
    return false;
}

// Reads a file of the folder if smc has written it for this machine.
static int read_old_script(CoverRun *r, const char *name)
{
    const char *path = path_in_folder(r, name);
    char head[512];
    OldScript old = {.path = path};
    size_t n;

    if (!has_suffix(name, ".ss") || is_argument(r->c, path) || !os_read_head(path, head, sizeof head, &n) ||
        generated_read(COVER_MADE_BY, r->file, head, n) == GENERATED_OTHER)
        return EXIT_OK;
    if ((old.src = cli_read_source(r->c, path)) == NULL)
        return EXIT_ENVIRONMENT;
    old.verdict = generated_read(COVER_MADE_BY, r->file, old.src->text, old.src->len) == GENERATED_WHOLE ? OLD_VALID : OLD_EDITED;
    vec_push(r->arena, &r->old, old);
    return EXIT_OK;
}

// Appends the scripts of the folder to the sources that are compiled.
static void add_sources(CoverRun *r, CompileInput *in)
{
    CompileSource *all = arena_array(r->arena, in->n + r->old.n, sizeof *all);

    memcpy(all, in->at, in->n * sizeof *all);
    for (uint32_t i = 0; i < r->old.n; i++)
        all[in->n + i] = (CompileSource){.text = r->old.at[i].src, .kind = FILE_SS};
    in->at = all;
    in->n += r->old.n;
}

// Creates or lists the folder, and adds the scripts in it that smc has written for this machine to the sources.
int cover_read_folder(CoverRun *r, CompileInput *in)
{
    const char *why = NULL;
    char **names;
    int code = EXIT_OK;

    if (!os_make_folder(r->folder, &why) || !os_list_folder(r->folder, &names, &r->names, &why)) {
        cli_print_error(r->c, TEXT_cannot_write, cli_printable_name(r->arena, r->folder), why);
        return EXIT_ENVIRONMENT;
    }
    r->name = ARENA_ARRAY(r->arena, const char *, r->names + 1);
    for (size_t i = 0; i < r->names; i++)
        r->name[i] = format_in(r->arena, "%s", names[i]);
    free(names);
    for (size_t i = 0; i < r->names && code == EXIT_OK; i++)
        code = read_old_script(r, r->name[i]);
    add_sources(r, in);
    return code;
}

// ---- running ----

static bool run_script(CoverRun *r, const Script *s, Engine *e)
{
    const ScriptOptions o = {.max_steps = COVER_STEPS_MOST, .is_compared = true, .is_silent = true};

    return script_run(r->arena, &r->c->session.diags, s, &e, 1, &o).outcome == SCRIPT_PASSED;
}

bool cover_accept_script(CoverRun *r, const char *name, const Script *s)
{
    const ScriptOptions o = {.max_steps = COVER_STEPS_MOST, .is_compared = true, .is_silent = true};
    Engine *e = cover_open_engines(r->arena, r->p, cover_new_each(r));
    const ScriptResult result = script_run(r->arena, &r->c->session.diags, s, &e, 1, &o);

    return baseline_add(&r->given_run, name, s, &result);
}

// Returns whether the Covers (one for each machine) have counted a coverage place whose goal is this sentence. *is_known: some machine has such a
// place.
static bool covers_goal(const CoverRun *r, Cover *const *cover, const char *goal, bool *is_known)
{
    bool found = false;

    *is_known = false;
    for (size_t m = 0; m < r->machines; m++)
        for (uint32_t i = 1; i < cover[m]->place.n; i++)
            if (strcmp(goal_sentence(r->text[m], i), goal) == 0) {
                *is_known = true;
                found = found || cover[m]->hits[i] > 0;
            }
    return found;
}

// Judges an unedited script: it is stale if it does not compile, fails or does not reach its goal.
static void judge_script(CoverRun *r, OldScript *old)
{
    const char *goal = generated_goal(r->arena, old->src->text, old->src->len);
    const Script *s = session_script(&r->c->session, old->src, r->p);
    const bool is_pair = strncmp(goal, MUST_NOT_GOAL, strlen(MUST_NOT_GOAL)) == 0;
    bool is_known = true;

    diags_clear(&r->c->session.diags);
    old->verdict = OLD_STALE;
    if (!s) {
        old->why = "the machine no longer fits it";
    } else {
        Cover **alone = cover_new_each(r);
        if (!run_script(r, s, cover_open_engines(r->arena, r->p, alone)))
            old->why = "it fails";
        cover_settle_each(r, alone);
        if (!old->why && !is_pair && !covers_goal(r, alone, goal, &is_known))
            old->why = is_known ? "it does not reach its goal" : "the machine no longer has its goal";
    }
    if (old->why)
        return;
    old->verdict = OLD_VALID;
    run_script(r, s, cover_open_engines(r->arena, r->p, r->all));
}

// Runs an edited script like one that the command line names.
static int run_edited(CoverRun *r, const OldScript *old)
{
    const Script *s = session_script(&r->c->session, old->src, r->p);

    if (s && cover_accept_script(r, old->path, s)) {
        run_script(r, s, cover_open_engines(r->arena, r->p, r->given));
        run_script(r, s, cover_open_engines(r->arena, r->p, r->all));
    }
    return cli_print_diagnostics(r->c);
}

// Runs the scripts that cover_read_folder has read, and counts what they cover.
int cover_run_folder(CoverRun *r)
{
    int code = EXIT_OK;

    for (uint32_t i = 0; i < r->old.n && code == EXIT_OK; i++)
        if (r->old.at[i].verdict == OLD_EDITED)
            code = run_edited(r, &r->old.at[i]);
        else
            judge_script(r, &r->old.at[i]);
    return code;
}

// ---- new names ----

static bool equal_names(const char *a, const char *b)         // without regard to case, as some file systems compare
{
    for (; *a && *b; a++, b++)
        if ((*a >= 'A' && *a <= 'Z' ? *a - 'A' + 'a' : *a) != (*b >= 'A' && *b <= 'Z' ? *b - 'A' + 'a' : *b))
            return false;
    return *a == *b;
}

// Whether this file of the folder is neither a script that smc has written for this machine nor an argument.
static bool is_foreign(const CoverRun *r, const char *path)
{
    if (is_argument(r->c, path))
        return false;
    for (uint32_t i = 0; i < r->old.n; i++)
        if (equal_names(r->old.at[i].path, path))
            return false;
    return true;
}

// Returns whether a new script can have this name.  If so, and a stale script has the name, marks that script as replaced.
static bool claim_name(CoverRun *r, const char *name, const char *path)
{
    for (uint32_t i = 0; i < r->new_one.n; i++)
        if (strcmp(r->new_one.at[i].path, path) == 0)
            return false;
    for (uint32_t i = 0; i < r->old.n; i++)
        if (r->old.at[i].verdict == OLD_STALE && strcmp(r->old.at[i].path, path) == 0)
            return r->old.at[i].is_replaced = true;
    for (size_t i = 0; i < r->names; i++)
        if (equal_names(r->name[i], name)) {
            if (is_foreign(r, path))
                vec_push(r->arena, &r->in_the_way, path);
            return false;
        }
    return true;
}

// Returns the path for a new script: STEM.ss, or STEM-N.ss if a file that must stay has this name.
const char *cover_new_path(CoverRun *r, const char *stem)
{
    const char *name = format_in(r->arena, "%s.ss", stem);

    for (unsigned long n = 2; !claim_name(r, name, path_in_folder(r, name)); n++)
        name = format_in(r->arena, "%s-%lu.ss", stem, n);
    return path_in_folder(r, name);
}
