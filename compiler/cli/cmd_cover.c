// SPDX-License-Identifier: Apache-2.0
// smc cover: searches for inputs that reach what no script has tested, and writes each run as a script.
//
// 1. The given scripts run, and those of the folder that a person has edited.  The goals are the coverage places (transitions, branches,
//    conditions: cover.h) that they do not cover.  The search starts with the states along the given scripts.  A script that fails is left out:
//    what it covers counts as not tested.
// 2. The other scripts of the folder that smc has written run.  If they reach every goal that is not impossible, nothing is searched.
// 3. Else the search is the same as without them, so a second call finds the same, and nothing is written twice.  What it finds is written if
//    it reaches a goal that no script of the folder reaches.
#include <string.h>

#include "compiler/base/os_signal.h"
#include "compiler/base/path.h"
#include "compiler/cli/cover_run.h"
#include "compiler/cli/deps.h"
#include "compiler/cli/runs.h"
#include "compiler/search/scenario_record.h"
#include "compiler/search/search_app.h"

enum {
    GOAL_KINDS = COVER_PARAMETER      // number of kinds that can be goals: all but the last one, parameters, which are set and not reached
};

static const CliFormat formats[] = {{"text", {NULL}, NULL}, {"json", {NULL}, NULL}};

// ---- options ----

// Reads a list of kinds of coverage such as "state,transition" into *kinds, a set of 1u << CoverKind. Returns false for an unknown kind.
static bool read_kinds(const char *text, unsigned *kinds)
{
    for (*kinds = 0;; text++) {
        const size_t n = strcspn(text, ",");
        int kind = 0;
        while (kind < GOAL_KINDS && (strlen(cover_kind_name[kind]) != n || strncmp(cover_kind_name[kind], text, n) != 0))
            kind++;
        if (kind == GOAL_KINDS)
            return false;
        *kinds |= 1u << kind;
        text += n;
        if (*text == '\0')
            return true;
    }
}

// Returns the names of all kinds of goals, for a message: "x, y and z".
static const char *list_kinds(Cli *c)
{
    Buf out;

    buf_init(&out, &c->session.arena);
    for (int k = 0; k < GOAL_KINDS; k++)
        buf_printf(&out, "%s%s", k == 0 ? "" : k + 1 < GOAL_KINDS ? ", " : " and ", cover_kind_name[k]);
    return buf_text(&out);
}

static int read_options(CoverRun *r, CoverSettings *s)
{
    Cli *c = r->c;

    *s = (CoverSettings){.effort = 150, .memory = 512, .seed = 1};
    r->kinds = SEARCH_KINDS;
    if (!c->given[OPT_OUTPUT] || strcmp(c->value[OPT_OUTPUT], "-") == 0 || !*c->value[OPT_OUTPUT])
        return cli_usage_error(c, TEXT_cover_folder, c->file[0]);
    r->folder = c->value[OPT_OUTPUT];
    c->given[OPT_OUTPUT] = false;                              // so that cli_choose_format does not derive the format from the name of the folder
    if (!cli_choose_format(c, formats, sizeof formats / sizeof *formats, &s->format))
        return EXIT_USAGE;
    c->given[OPT_OUTPUT] = true;
    if (c->given[OPT_GOALS] && !read_kinds(c->value[OPT_GOALS], &r->kinds))
        return cli_usage_error(c, TEXT_cover_goals, list_kinds(c));
    if (!cli_read_limit(c, OPT_EFFORT, "--effort", EFFORT_MOST, &s->effort) ||
        !cli_read_limit(c, OPT_MEMORY, "--memory", SIZE_MAX >> 20, &s->memory))
        return EXIT_USAGE;
    if (c->given[OPT_SEED] && (!cli_read_whole(c->value[OPT_SEED], &s->seed) || s->seed > SCRIPT_SEED_MAX))
        return cli_usage_error(c, TEXT_seed_value, c->value[OPT_SEED]);
    return EXIT_OK;
}

// ---- the given scripts ----

// Checks and runs the scripts that the command line names, counts what they cover, and records their runs as starting points of the search.
static int run_given(CoverRun *r, const CompileInput *in, size_t given, const Compiled *made)
{
    const ScriptOptions o = {.max_steps = COVER_STEPS_MOST, .is_compared = true, .is_silent = true};
    Engine *const counting = cover_open_engines(r->arena, r->p, r->given), *recording[2] = {NULL, cover_open_engines(r->arena, r->p, r->all)};
    bool *writable = arena_alloc(r->arena, r->p->var.n);
    int code;

    (r->p->joint ? search_app_inputs : search_default_inputs)(r->p, writable);
    for (size_t i = 0; i < given; i++)
        if (in->at[i].kind == FILE_SS && !made->of[i].is_included) {
            const Script *s = session_script(&r->c->session, in->at[i].text, r->p);
            if (s)
                vec_push(r->arena, &r->script, s);
        }
    if ((code = cli_print_diagnostics(r->c)) != EXIT_OK)
        return code;
    for (uint32_t i = 0; i < r->script.n; i++) {
        const Script *s = r->script.at[i];
        if (!cover_accept_script(r, s->src->name, s))
            continue;
        recording[0] = scenario_record_open(r->arena, r->p, counting, r->p->joint ? r->p->step : s->delta_t, writable, SCENARIO_FEW_CHANGES);
        script_run(r->arena, &r->c->session.diags, s, recording, 2, &o);
        vec_push(r->arena, &r->recorded, scenario_recorded(recording[0]));
    }
    return cli_print_diagnostics(r->c);
}

// ---- the command ----

static int write_dependencies(CoverRun *r)
{
    OsOutput out[2] = {{r->folder, NULL, 0}};
    size_t n = 1;

    if (!deps_wanted(r->c))
        return EXIT_OK;
    deps_add_rule(r->c, out, &n, deps_list_inputs(r->c));
    return cli_write_outputs(r->c, &out[1], 1);
}

static int write_results(CoverRun *r, const CoverSettings *s)
{
    CoverTotals t = {0, 0, 0, 0};
    bool is_full = false;
    Buf out;

    for (size_t m = 0; m < r->machines; m++) {
        const CoverTotals own = cover_count(r, m);
        t.goals += own.goals;
        t.not_found += own.not_found;
        is_full = is_full || (own.not_found && r->result[m] && r->result[m]->memory_reached);
    }

    buf_init(&out, r->arena);
    (s->format == 0 ? cover_write_report : cover_write_goals_json)(r, &out);
    if (!cli_print(r->c, 1, &out))
        return EXIT_ENVIRONMENT;
    if (r->was_interrupted)
        cli_print_error(r->c, TEXT_cover_interrupted);
    else if (t.not_found)
        cli_print_error(r->c, s->effort < EFFORT_MOST ? TEXT_cover_not_found : TEXT_cover_not_found_at_all, t.not_found, t.goals,
                        (unsigned long)(s->effort < EFFORT_MOST / 10 ? 10 * s->effort : EFFORT_MOST));
    if (!r->was_interrupted && is_full)
        cli_print_error(r->c, TEXT_cover_memory, (unsigned long)s->memory, (unsigned long)(4 * s->memory));
    if (!baseline_is_complete(&r->given_run))
        cli_print_error(r->c, TEXT_cover_left_out, (unsigned long)r->given_run.left_out, (unsigned long)r->given_run.run.n);
    return r->was_interrupted ? EXIT_INCONCLUSIVE : !baseline_is_complete(&r->given_run) ? EXIT_PROBLEM : t.not_found ? EXIT_INCONCLUSIVE : EXIT_OK;
}

Cover **cover_new_each(const CoverRun *r)
{
    Cover **out = ARENA_ARRAY(r->arena, Cover *, r->machines);

    for (size_t m = 0; m < r->machines; m++)
        out[m] = cover_new(r->arena, engine_program(r->p, m));
    return out;
}

void cover_settle_each(const CoverRun *r, Cover *const *cover)
{
    for (size_t m = 0; m < r->machines; m++)
        cover_settle(cover[m]);
}

// Covers a machine, or an application: runs the scripts of the command line and of the folder, searches, writes scripts and results. given: number
// of sources that the command line names.
static int cover_program(CoverRun *r, CompileInput *in, size_t given, const CompileOptions *o, const Compiled *made, CoverSettings *s)
{
    int code;

    r->machines = engine_machines(r->p);
    r->given = cover_new_each(r);
    r->all = cover_new_each(r);
    r->text = ARENA_ARRAY(r->arena, GoalTexts *, r->machines);
    r->result = ARENA_ARRAY(r->arena, const SearchResult *, r->machines);
    for (size_t m = 0; m < r->machines; m++)
        r->text[m] = goal_texts_new(r->arena, r->all[m], r->p, m);
    baseline_init(&r->given_run, r->arena, NULL);
    if ((code = run_given(r, in, given, made)) != EXIT_OK || (code = cover_run_folder(r)) != EXIT_OK)
        return code;
    s->delta_t = o->step ? o->step : r->script.n ? r->script.at[0]->delta_t : SEARCH_DELTA_T;
    cover_settle_each(r, r->given);
    cover_settle_each(r, r->all);
    os_signals_begin();
    os_signals_delay();
    if ((code = cover_search(r, s)) == EXIT_OK && (code = write_dependencies(r)) == EXIT_OK)
        code = write_results(r, s);
    os_signals_resume();                  // ends the process if a signal has asked to stop
    os_signals_end();
    return code;
}

// Checks that the search can set the times of an application.
static int check_app_time(Cli *c, const Program *p)
{
    const char *why = search_app_refusal(p);

    if (!why)
        return EXIT_OK;
    cli_print_error(c, TEXT_cover_app_time, c->file[0], why);
    return EXIT_PROBLEM;
}

// Refuses what an application decides itself, and what is for one machine.
static int check_app_options(Cli *c)
{
    for (size_t i = 0; i < c->files; i++) {
        if (!has_suffix(c->file[i], ".app"))
            continue;
        if (c->given[OPT_STEP])
            return cli_usage_error(c, TEXT_prove_app_decides, c->file[i], "--step");
        if (c->given[OPT_MUST_NOT])
            return cli_usage_error(c, TEXT_cover_app_pairs, c->file[i]);
    }
    return EXIT_OK;
}

int cmd_cover(Cli *c)
{
    CoverRun r = {.c = c, .arena = &c->session.arena};
    CoverSettings settings;
    CompileInput in;
    CompileOptions o;
    Compiled made;
    size_t given;
    int code;

    if ((code = runs_check_arguments(c)) != EXIT_OK || (code = read_options(&r, &settings)) != EXIT_OK || (code = check_app_options(c)) != EXIT_OK)
        return code;
    if (!cli_compile_options(c, &o))
        return EXIT_USAGE;
    if ((code = cli_read_inputs(c, &in)) != EXIT_OK)
        return code;
    given = in.n;
    for (size_t i = 0; i < given; i++)
        if (in.at[i].kind == (in.app ? FILE_APP : FILE_SM))
            r.file = path_file_name(in.at[i].text->name);
    if ((code = cover_read_folder(&r, &in)) != EXIT_OK)
        return code;
    if ((code = runs_compile(c, &in, &o, &made)) != EXIT_OK)
        return code;
    r.p = runs_find_machine(&in, &made)->scripted;
    if (r.p->joint && (code = check_app_time(c, r.p)) != EXIT_OK)
        return code;
    return cover_program(&r, &in, given, &o, &made, &settings);
}
