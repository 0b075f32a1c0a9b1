// SPDX-License-Identifier: Apache-2.0
#include "compiler/cli/whatif.h"

#include <string.h>

#include "compiler/cli/deps.h"
#include "compiler/cli/runs.h"

enum { STEPS_MOST = 1000000 };        // the default of --max-steps

// Checks the scripts and adds them to w->script. EXIT_OK, or EXIT_PROBLEM after their diagnostics.
static int check_scripts(Cli *c, WhatIf *w, const CompileInput *in, const Compiled *made)
{
    for (size_t i = 0; i < in->n; i++)
        if (in->at[i].kind == FILE_SS && !made->of[i].is_included) {
            const Script *s = session_script(&c->session, in->at[i].text, w->p);
            if (s)
                vec_push(&c->session.arena, &w->script, s);
        }
    return cli_print_diagnostics(c);
}

// Compiles the machine, scripts and requirements that the command names, and reads --max-steps.
int whatif_load(Cli *c, WhatIf *w)
{
    const CompiledSource *m;
    CompileInput in;
    CompileOptions o;
    Compiled made;
    size_t scripts = 0;
    int code;

    w->max_steps = STEPS_MOST;
    if ((code = runs_check_arguments(c)) != EXIT_OK)
        return code;
    for (size_t i = 0; i < c->files; i++)
        scripts += has_suffix(c->file[i], ".ss");
    if (scripts == 0)
        return cli_usage_error(c, TEXT_whatif_script, c->command->name, c->command->name, c->file[0]);
    if (!cli_read_limit(c, OPT_MAX_STEPS, "--max-steps", UINT64_MAX, &w->max_steps) || !deps_check_result(c))
        return EXIT_USAGE;
    if (!cli_compile_options(c, &o))
        return EXIT_USAGE;
    if ((code = cli_read_inputs(c, &in)) != EXIT_OK)
        return code;
    if ((code = runs_compile(c, &in, &o, &made)) != EXIT_OK)
        return code;
    m = runs_find_machine(&in, &made);
    w->p = m->scripted;
    w->requirements = m->requirements;
    return check_scripts(c, w, &in, &made);
}

int whatif_report_baseline(Cli *c, const Baseline *b, const char *what)
{
    const BaselineRun *first = b->run.at;

    if (baseline_is_complete(b))
        return EXIT_OK;
    if (b->left_out == b->run.n)
        cli_print_error(c, TEXT_baseline_none, first->name, first->why, what);
    else
        cli_print_error(c, TEXT_baseline_part, what, (unsigned long)(b->left_out + b->ignoring), (unsigned long)b->run.n);
    return EXIT_PROBLEM;
}

// Calls `add` for each word between commas. Returns false as soon as one call does.
bool whatif_read_list(const char *list, void *context, bool (*add)(void *context, const char *word, size_t n))
{
    for (const char *at = list; ; at++) {
        const size_t n = strcspn(at, ",");
        if (!add(context, at, n))
            return false;
        at += n;
        if (*at == '\0')
            return true;
    }
}
