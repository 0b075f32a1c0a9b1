// SPDX-License-Identifier: Apache-2.0
#include "compiler/cli/runs.h"

#include <string.h>

#include "compiler/cli/test.h"

enum { STEPS_MOST = 1000000 };        // a script that runs longer is ended; the default limit of smc test

int runs_check_arguments(Cli *c)
{
    size_t machines = 0;

    for (size_t i = 0; i < c->files; i++) {
        const bool script = has_suffix(c->file[i], ".ss");
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

const CompiledSource *runs_machine(const CompileInput *in, const Compiled *made)
{
    size_t i = 0;

    while (in->at[i].kind != FILE_SM)
        i++;
    return &made->of[i];
}

// ---- on the VM ----

static void run_script(Cli *c, const Report *r, const Program *p, ReportRun *run, const Source *ss, Engine *vm)
{
    Session *s = &c->session;
    const ScriptOptions o = {STEPS_MOST, NULL, NULL, true};
    const Diags machine = s->diags;
    Engine *traced;

    run->name = report_base_name(ss->name);
    trace_init(&run->trace, &s->arena, p, &r->analysis.transition);
    diags_clear(&s->diags);
    if ((run->script = session_script(s, ss, p)) != NULL) {
        traced = trace_wrap_engine(&run->trace, vm);
        run->result = script_run(&s->arena, &s->diags, run->script, &traced, 1, &o);
    }
    diags_apply_allows(&s->diags);
    run->diags = s->diags;
    s->diags = machine;
}

int runs_execute(Cli *c, Report *r, const Program *p, const CompileInput *in)
{
    EngineSet engines = {{NULL}, 0, NULL};

    if (in->n < 2)
        return EXIT_OK;
    if (!engines_open(&engines, &c->session, p, 1u << ENGINE_VM, options_opt_level(c))) {
        cli_print_error(c, TEXT_sentence, engines.error);
        return EXIT_PROBLEM;
    }
    r->run = ARENA_ARRAY(&c->session.arena, ReportRun, in->n);
    for (size_t i = 0; i < in->n; i++)
        if (in->at[i].kind == FILE_SS)
            run_script(c, r, p, &r->run[r->runs++], in->at[i].text, engines.at[0]);
    engines_close(&engines);
    return EXIT_OK;
}
