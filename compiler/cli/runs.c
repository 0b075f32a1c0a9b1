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

const CompiledSource *runs_find_machine(const CompileInput *in, const Compiled *made)
{
    size_t i = 0;

    while (in->at[i].kind != FILE_SM)
        i++;
    return &made->of[i];
}

// ---- on the VM ----

int runs_execute(Cli *c, Report *r, const Program *p, const CompileInput *in)
{
    const ScriptOptions o = {.max_steps = STEPS_MOST, .is_compared = true};
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
            review_run_script(&c->session, r, p, in->at[i].text, NULL, engines.at, engines.n, &o, &r->run[r->runs++]);
    engines_close(&engines);
    return EXIT_OK;
}
