// SPDX-License-Identifier: Apache-2.0
#include "compiler/cli/runs.h"

#include <string.h>

#include "compiler/cli/test.h"

enum { STEPS_MOST = 1000000 };        // a script that runs longer is ended; the default limit of smc test

// Returns the path of the first file of a kind that an application names, or `otherwise`.
static const char *find_app_file(Cli *c, const CompileInput *in, FileKind kind, const char *otherwise)
{
    const AppFiles *files = &in->app->files;

    for (size_t i = 0; i < files->n; i++)
        if (files->at[i].kind == kind && files->at[i].src)
            return cli_printable_name(&c->session.arena, files->at[i].src->name);
    return otherwise;
}

// Reports that the command is for one machine, and names the files of the application to use instead.
int runs_refuse_app(Cli *c, const char *app)
{
    CompileSource source = {.text = cli_read_source(c, app), .kind = FILE_APP};
    CompileInput in = {.at = &source, .n = 1};

    if (!source.text)
        return EXIT_ENVIRONMENT;
    cli_load_app(c, &in);
    diags_clear(&c->session.diags);
    return cli_usage_error(c, TEXT_not_an_app, app, c->command->name, c->command->name, find_app_file(c, &in, FILE_SM, "MACHINE.sm"),
                           strcmp(c->command->name, "prove") == 0 ? " REQUIREMENTS.rq" : "", find_app_file(c, &in, FILE_SV, "VECTOR.sv"));
}

// Checks that the arguments are one machine and scripts.  Returns EXIT_OK, or the exit code after a message.
int runs_check_arguments(Cli *c)
{
    const bool judges = c->command->run == cmd_report || c->command->run == cmd_mutate || c->command->run == cmd_faults ||
        c->command->run == cmd_sweep;
    size_t machines = 0;

    for (size_t i = 0; i < c->files; i++) {
        if (has_suffix(c->file[i], ".app"))
            return runs_refuse_app(c, c->file[i]);
        const bool script = has_suffix(c->file[i], ".ss") || (judges && has_suffix(c->file[i], ".rq"));
        if (!script && !has_suffix(c->file[i], ".sm") && strcmp(c->file[i], "-") != 0)
            return cli_usage_error(c, TEXT_not_machine_or_script, c->file[i],
                                   has_suffix(c->file[i], ".sv") ? "; name the state vector with --sv" : "");
        machines += !script;
    }
    if (machines != 1)
        return cli_usage_error(c, machines ? TEXT_one_machine : TEXT_machine_required,
                               c->command->name, c->command->name);
    return EXIT_OK;
}

// Compiles `in` without analyses and without the scripts, which the command compiles itself.
int runs_compile(Cli *c, const CompileInput *in, CompileOptions *o, Compiled *made)
{
    o->scripts_later = true;
    o->skip_analyses = true;
    compile_sources(&c->session, in, o, made);
    return cli_print_diagnostics(c);
}

// Returns the machine among the compiled sources.
const CompiledSource *runs_find_machine(const CompileInput *in, const Compiled *made)
{
    size_t i = 0;

    while (in->at[i].kind != FILE_SM)
        i++;
    return &made->of[i];
}

// ---- on the VM ----

// Runs the scripts of `in` into r->run and measures their coverage, on an image with names of the machine compiled for scripts.
int runs_execute(Cli *c, Report *r, const CompileInput *in, const Compiled *made)
{
    const Program *p = runs_find_machine(in, made)->scripted;
    const ScriptOptions o = {.max_steps = STEPS_MOST, .is_compared = true, .requirements = runs_find_machine(in, made)->requirements};
    EngineSet engines = {{NULL}, 0, NULL};
    Cover *cover;

    r->requirements = o.requirements;
    if (in->n < 2)
        return EXIT_OK;
    if (!engines_open(&engines, &c->session, p, 1u << ENGINE_VM, options_opt_level(c))) {
        cli_print_error(c, TEXT_sentence, engines.error);
        return EXIT_PROBLEM;
    }
    cover = cover_new(&c->session.arena, p);
    engines.at[engines.n++] = cover_open_engine(cover);
    r->run = ARENA_ARRAY(&c->session.arena, ReportRun, in->n);
    for (size_t i = 0; i < in->n; i++)
        if (in->at[i].kind == FILE_SS && !made->of[i].is_included)
            review_run_script(&c->session, r, p, in->at[i].text, NULL, engines.at, engines.n, &o, &r->run[r->runs++]);
    engines_close(&engines);
    cover_settle(cover);
    r->cover = cover;
    return EXIT_OK;
}
