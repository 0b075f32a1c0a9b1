// SPDX-License-Identifier: Apache-2.0
#include "compiler/cli/runs.h"

#include <string.h>

#include "compiler/cli/test.h"
#include "compiler/prove/prove.h"

enum { STEPS_MOST = 1000000 };        // a script that runs longer is ended; the default limit of smc test

// Returns the path of the application's state vector.
static const char *find_app_vector(Cli *c, const AppFiles *files)
{
    for (size_t i = 0; i < files->n; i++)
        if (files->at[i].kind == FILE_SV && files->at[i].src)
            return cli_printable_name(&c->session.arena, files->at[i].src->name);
    return "VECTOR.sv";
}

// Appends the bindings of a machine as an option: " --bind go=apogee,fire=drogueFire".  A parameter with a value of its own is named in a remark.
static void write_bindings(const AstBindings *b, Buf *out)
{
    size_t bound = 0, values = 0;

    for (size_t i = 0; i < b->n; i++)
        if (b->at[i].element.text)
            buf_printf(out, "%s%s=%s", bound++ ? "," : " --bind ", b->at[i].name.text->text, b->at[i].element.text->text);
    for (size_t i = 0; i < b->n; i++)
        if (!b->at[i].element.text && b->at[i].name.text)
            buf_printf(out, "%s%s", values++ ? ", " : ", without its values of ", b->at[i].name.text->text);
}

// Returns what precedes the machine's file in the arguments of a command.
static const char *files_before(const char *command) { return strcmp(command, "diff") == 0 ? "OLD.sm " : ""; }

// Writes the command for one machine of the application.
static void write_command(Cli *c, const AppFiles *files, const AppInstance *m, const char *command, Buf *out)
{
    const AppFile *file = &files->at[m->file];

    buf_printf(out, "\n  %s: smc %s %s%s --sv %s", m->task->name.text->text, command, files_before(command),
               file->src ? cli_printable_name(&c->session.arena, file->src->name) : file->name.text->text, find_app_vector(c, files));
    write_bindings(&m->task->bindings, out);
}

// Reports that the command is for one machine, and the command for each machine of the application.
int runs_refuse_app(Cli *c, const char *app)
{
    const char *command = c->command->name;
    CompileSource source = {.text = cli_read_source(c, app), .kind = FILE_APP};
    CompileInput in = {.at = &source, .n = 1};
    Buf commands, all;

    if (!source.text)
        return EXIT_ENVIRONMENT;
    cli_load_app(c, &in);
    diags_clear(&c->session.diags);
    buf_init(&commands, &c->session.arena);
    for (size_t i = 0; i < in.app->files.instances; i++)
        write_command(c, &in.app->files, &in.app->files.instance[i], command, &commands);
    if (commands.n == 0)
        return cli_usage_error(c, TEXT_not_an_app, app, command, command, files_before(command), find_app_vector(c, &in.app->files));
    buf_init(&all, &c->session.arena);
    buf_printf(&all, TEXT_not_an_app_but, cli_printable_name(&c->session.arena, app), command, buf_text(&commands));
    cli_print(c, 2, &all);
    return EXIT_USAGE;
}

// Whether the command accepts an application: scripts that mutate writes are for one machine.
static bool accepts_app(const Cli *c)
{
    return (c->command->run == cmd_mutate && !c->given[OPT_SCRIPTS]) || c->command->run == cmd_faults || c->command->run == cmd_sweep ||
           c->command->run == cmd_report || c->command->run == cmd_cover;
}

// Checks that the arguments are one machine, or application, and scripts.  Returns EXIT_OK, or the exit code after a message.
int runs_check_arguments(Cli *c)
{
    const bool judges = c->command->run == cmd_report || c->command->run == cmd_mutate || c->command->run == cmd_faults ||
        c->command->run == cmd_sweep;
    size_t machines = 0;

    for (size_t i = 0; i < c->files; i++) {
        const bool app = has_suffix(c->file[i], ".app");
        if (app && !accepts_app(c))
            return runs_refuse_app(c, c->file[i]);
        if (app && c->given[OPT_SV])
            return cli_usage_error(c, TEXT_app_names_vector, c->file[i]);
        const bool script = has_suffix(c->file[i], ".ss") || (judges && has_suffix(c->file[i], ".rq"));
        if (!script && !app && !has_suffix(c->file[i], ".sm") && strcmp(c->file[i], "-") != 0)
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

    while (in->at[i].kind != FILE_SM && in->at[i].kind != FILE_APP)
        i++;
    return &made->of[i];
}

bool runs_report_contradiction(Cli *c, const Requirements *r)
{
    Diags *d = &c->session.diags;
    const Requirement *first, *second;

    if (!prove_find_contradiction(&c->session.arena, r, &first, &second))
        return false;
    diag_note(d, diag_report(d, DIAG_requirements_contradict, second->span, second->id->text, first->id->text), first->span, DIAG_note_first_here);
    return true;
}

// ---- on the VM ----

// Returns the scripts of `in` that run, `*n` of them.
static const Source **list_scripts(Cli *c, const CompileInput *in, const Compiled *made, size_t *n)
{
    const Source **script = ARENA_ARRAY(&c->session.arena, const Source *, in->n);

    *n = 0;
    for (size_t i = 0; i < in->n; i++)
        if (in->at[i].kind == FILE_SS && !made->of[i].is_included)
            script[(*n)++] = in->at[i].text;
    return script;
}

int runs_execute_app(Cli *c, Report *r, const CompileInput *in, const Compiled *made)
{
    Arena *arena = &c->session.arena;
    const ScriptOptions o = {.max_steps = STEPS_MOST, .is_compared = true, .requirements = runs_find_machine(in, made)->requirements};
    const Source **script = list_scripts(c, in, made, &r->runs);
    EngineSet engines = {{NULL}, 0, NULL};
    Engine **counting = ARENA_ARRAY(arena, Engine *, r->members);
    Cover **cover = ARENA_ARRAY(arena, Cover *, r->members);

    r->requirements = o.requirements;
    if (r->runs == 0)
        return EXIT_OK;
    if (!engines_open(&engines, &c->session, r->analysis.p, 1u << ENGINE_VM, options_opt_level(c))) {
        cli_print_error(c, TEXT_sentence, engines.error);
        return EXIT_PROBLEM;
    }
    r->run = ARENA_ARRAY(arena, ReportRun, r->runs);
    for (size_t i = 0; i < r->members; i++) {
        cover[i] = cover_new(arena, r->member[i].of->program);
        counting[i] = cover_open_engine(cover[i]);
        r->member[i].run = ARENA_ARRAY(arena, ReportRun, r->runs);
        r->member[i].runs = r->runs;
    }
    for (size_t i = 0; i < r->runs; i++)
        review_run_app_script(&c->session, r, script[i], engines.at[0], counting, &o, i);
    engines_close(&engines);
    for (size_t i = 0; i < r->members; i++) {
        cover_settle(cover[i]);
        r->member[i].cover = cover[i];
    }
    return EXIT_OK;
}

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
