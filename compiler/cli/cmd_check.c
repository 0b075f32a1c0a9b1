// SPDX-License-Identifier: Apache-2.0
// smc check: checks sources and images without running them.
#include "compiler/analysis/analysis.h"
#include "compiler/cli/app.h"
#include "compiler/cli/cli.h"

// Checks every script of the call against machine p.
static int check_scripts(Cli *c, Source *const *ss, const Program *p)
{
    for (size_t i = 0; i < c->files; i++)
        if (has_suffix(c->file[i], ".ss")) {
            if (!ss[i])
                return EXIT_ENVIRONMENT;
            session_script(&c->session, ss[i], p);
        }
    return EXIT_OK;
}

// Checks the machine as it will fly: without names.
static void check_limits(Cli *c, const Program *p)
{
    c->session.hide_locals = true;
    limits_check(c, p, session_ir(&c->session, p, option_level(c)));
    c->session.hide_locals = false;
}

typedef VEC(const Program *) Programs;
typedef VEC(const IoMap *) IoMaps;

static int check_machine_file(Cli *c, const char *path, const Source *sv, Programs *all)
{
    Map written = {&c->session.arena, NULL, NULL, 0, 0};
    MachineInput in = {cli_load(c, path), sv, NULL, option_level(c)};
    Source **ss;
    Program *p;

    if (!in.sm)
        return EXIT_ENVIRONMENT;
    ss = cli_load_scripts(c, &written, NULL);
    if ((p = session_program(&c->session, &in)) == NULL)
        return EXIT_OK;
    vec_push(&c->session.arena, all, p);
    session_analyse(&c->session, p);
    if (limits_given(c))
        check_limits(c, p);
    in.written_outside = &written;
    p = session_program_for_scripts(&c->session, &in, p);
    return p ? check_scripts(c, ss, p) : EXIT_OK;
}

static int check_file(Cli *c, const char *path, const Source *sv, Programs *all, IoMaps *pins)
{
    Source *src;
    IoMap *io;

    if (has_suffix(path, ".sm") || path[0] == '-')
        return check_machine_file(c, path, sv, all);
    if (!has_suffix(path, ".sv") && !has_suffix(path, ".io"))
        return EXIT_OK;
    if ((src = cli_load(c, path)) == NULL)
        return EXIT_ENVIRONMENT;
    if (has_suffix(path, ".sv"))
        session_state_vector(&c->session, src);
    else if ((io = session_io(&c->session, src, sv)) != NULL)
        vec_push(&c->session.arena, pins, io);
    return EXIT_OK;
}

// Reports findings that require all machines together.
static void check_together(Cli *c, const Programs *all, const IoMaps *pins)
{
    analyse_together(&c->session.arena, &c->session.diags, all->at, all->n);
    for (size_t i = 0; i < pins->n; i++)
        for (size_t m = 0; m < all->n; m++)
            analyse_pins(&c->session.arena, &c->session.diags, pins->at[i], all->at[m]);
}

static int check_use(Cli *c)
{
    size_t machines = 0, scripts = 0;
    const char *pins = NULL;

    if (c->files == 0)
        return cli_usage(c, "check wants a file, as in 'smc check tank.sm'");
    for (size_t i = 0; i < c->files; i++) {
        const char *path = c->file[i];
        machines += has_suffix(path, ".sm") || (path[0] == '-' && path[1] == '\0');
        scripts += has_suffix(path, ".ss");
        pins = has_suffix(path, ".io") ? path : pins;
        if (has_suffix(path, ".app"))
            return cli_usage(c, "an application is checked alone: it names its files itself");
        if (!has_suffix(path, ".sm") && !has_suffix(path, ".ss") && !has_suffix(path, ".sv") && !has_suffix(path, ".io") &&
            (path[0] != '-' || path[1]))
            return cli_usage(c, "'%s' is no source: names end in .sm, .sv, .ss, .io or .app", path);
    }
    if (pins && !c->given[OPT_SV])
        return cli_usage(c, "pins are checked with their state vector, as in 'smc check %s --sv app.sv'", pins);
    if (!limits_known(c))
        return EXIT_USAGE;
    if (scripts && machines == 0)
        return cli_usage(c, "a script is checked together with its machine, as in 'smc check tank.sm tank.ss'");
    if (scripts && machines > 1)
        return cli_usage(c, "scripts are checked with one machine at a time, as in 'smc check tank.sm tank.ss'");
    return EXIT_OK;
}

int cmd_check(Cli *c)
{
    const Source *sv = NULL;
    Programs all = {NULL, 0, 0};
    IoMaps pins = {NULL, 0, 0};
    int code, reported;

    if (c->files && has_suffix(c->file[0], ".app"))
        return check_app_file(c);
    code = check_use(c);
    if (code != EXIT_OK)
        return code;
    if (c->given[OPT_SV] && (sv = cli_load(c, c->value[OPT_SV])) == NULL)
        return EXIT_ENVIRONMENT;
    for (size_t i = 0; i < c->files && code == EXIT_OK; i++)
        code = check_file(c, c->file[i], sv, &all, &pins);
    if (sv)
        check_together(c, &all, &pins);
    reported = cli_report(c);
    return code != EXIT_OK ? code : reported;
}
