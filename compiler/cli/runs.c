// SPDX-License-Identifier: Apache-2.0
#include "compiler/cli/runs.h"

#include <string.h>

enum { STEPS_MOST = 1000000 };        // of a script, as in smc test

int runs_machine(Cli *c, const char **machine)
{
    size_t machines = 0;

    for (size_t i = 0; i < c->files; i++) {
        const bool script = has_suffix(c->file[i], ".ss");
        if (!script && !has_suffix(c->file[i], ".sm") && strcmp(c->file[i], "-") != 0)
            return cli_usage(c, "'%s' is no machine (.sm) and no script (.ss)%s", c->file[i],
                             has_suffix(c->file[i], ".sv") ? "; name the state vector with --sv" : "");
        if (!script) {
            *machine = c->file[i];
            machines++;
        }
    }
    if (machines != 1)
        return cli_usage(c, machines ? "%s takes one machine at a time" : "%s wants a machine, as in 'smc %s tank.sm'",
                         c->command->name, c->command->name);
    return EXIT_OK;
}

bool runs_load(Cli *c, Source ***ss, Map *written)
{
    *ss = cli_load_scripts(c, written, NULL);
    for (size_t i = 0; i < c->files; i++)
        if (has_suffix(c->file[i], ".ss") && !(*ss)[i])
            return false;
    return true;
}

// ---- on the VM ----

static Engine *open_engine(Cli *c, const Program *p, const char **error)
{
    const ImageOptions names = {true, NULL};
    IrMachine *m = session_ir(&c->session, p, option_level(c));
    Buf image;

    *error = "the image cannot be made";
    buf_init(&image, &c->session.arena);
    if (!session_image(&c->session, &m, 1, &names, &image))
        return NULL;
    return engine_vm_open(&c->session.arena, p, (const uint8_t *)image.at, image.n, 0, error);
}

static void run_script(Cli *c, const Report *r, const Program *p, ReportRun *run, const Source *ss, Engine *vm)
{
    Session *s = &c->session;
    const ScriptOptions o = {STEPS_MOST, NULL, NULL, true};
    const Diags machine = s->diags;
    Engine *traced;

    run->name = report_file_name(ss->name);
    trace_init(&run->trace, &s->arena, p, &r->analysis.transition);
    diags_clear(&s->diags);
    if ((run->script = session_script(s, ss, p)) != NULL) {
        traced = trace_engine(&run->trace, vm);
        run->result = script_run(&s->arena, &s->diags, run->script, &traced, 1, &o);
    }
    diags_apply_allows(&s->diags);
    run->diags = s->diags;
    s->diags = machine;
}

int runs_make(Cli *c, Report *r, const Program *p, Source *const *ss)
{
    const char *error;
    Engine *vm;

    if (c->files < 2)
        return EXIT_OK;
    if ((vm = open_engine(c, p, &error)) == NULL) {
        cli_say(c, "%s", error);
        return EXIT_PROBLEM;
    }
    r->run = ARENA_ARRAY(&c->session.arena, ReportRun, c->files);
    for (size_t i = 0; i < c->files; i++)
        if (ss[i])
            run_script(c, r, p, &r->run[r->runs++], ss[i], vm);
    vm->close(vm);
    return EXIT_OK;
}
