// SPDX-License-Identifier: Apache-2.0
// smc diff: compares what two machines do.  Exit codes are those of diff: 0 the same behaviour, 1 another one, 2 wrong input, which includes a
// source with errors.
#include "compiler/base/path.h"
#include "compiler/cli/deps.h"
#include "compiler/cli/runs.h"
#include "compiler/diff/diff.h"

enum { STEPS_MOST = 1000000 };        // a script that runs longer is ended, unless --max-steps allows it

typedef void WriteDiff(const ProgramDiff *d, Buf *out);

static const CliFormat formats[] = {{"text", {".txt", NULL, NULL}, NULL}, {"markdown", {".md", NULL, NULL}, NULL},
                                    {"json", {".json", NULL, NULL}, NULL},
                                    {"svg", {".svg", NULL, NULL}, "a browser"}};
enum { FORMATS = sizeof formats / sizeof *formats };

// One of the two machines, compiled, and the scripts as checked for it.
typedef struct Version {
    CompileInput in;
    Compiled made;
    DiffSide side;
    Diags findings;
    const Program *scripted;      // the machine as its scripts run it
} Version;

static int check_arguments(Cli *c)
{
    size_t machines = 0;

    for (size_t i = 0; i < c->files; i++) {
        if (has_suffix(c->file[i], ".app"))
            return runs_refuse_app(c, c->file[i]);
        if (!has_suffix(c->file[i], ".ss") && !has_suffix(c->file[i], ".sm"))
            return cli_usage_error(c, TEXT_not_machine_or_script, c->file[i],
                                   has_suffix(c->file[i], ".sv") ? "; name the state vector with --sv" : "");
        machines += has_suffix(c->file[i], ".sm");
    }
    return machines == 2 ? EXIT_OK : cli_usage_error(c, TEXT_diff_machines);
}

// Compiles machine number `wanted` of the two on the command line, without the other one.  EXIT_OK, or the exit code after a message.
static int compile_version(Cli *c, const CompileInput *all, size_t wanted, const CompileOptions *o, Version *v)
{
    Buf *image;
    int code;

    v->in = *all;
    v->in.at = ARENA_ARRAY(&c->session.arena, CompileSource, all->n);
    v->in.n = 0;
    for (size_t i = 0, machine = 0; i < all->n; i++)
        if (all->at[i].kind != FILE_SM || machine++ == wanted)
            v->in.at[v->in.n++] = all->at[i];
    diags_clear(&c->session.diags);
    compile_sources(&c->session, &v->in, o, &v->made);
    v->findings = c->session.diags;
    if (c->session.diags.errors)
        return (code = cli_print_diagnostics(c)) == EXIT_PROBLEM ? EXIT_USAGE : code;
    diags_clear(&c->session.diags);
    for (size_t i = 0; i < v->in.n; i++)
        if (v->in.at[i].kind == FILE_SM) {
            const CompiledSource *of = &v->made.of[i];
            image = v->made.artefact.at[0].bytes;
            v->scripted = of->scripted;
            v->side = (DiffSide){of->program, of->ir, &v->findings, of->measured, image->n,
                                 smvm_logic_identity((SmvmBytes)image->at)};
        }
    return EXIT_OK;
}

// Compiles a script for one of the two machines; NULL if it has errors with that machine, which are not reported.
static const Script *compile_script(Cli *c, const Version *v, const Source *src)
{
    const Script *s;

    diags_clear(&c->session.diags);
    s = session_script(&c->session, src, v->scripted);
    diags_clear(&c->session.diags);
    return s;
}

// Runs every script on both machines.  One that has errors for both is wrong input.  EXIT_OK, or the exit code after a message.
static int run_scripts(Cli *c, ProgramDiff *d, const Version *old, const Version *new, uint64_t max_steps)
{
    int code = EXIT_OK;

    for (size_t i = 0; i < new->in.n; i++)
        if (new->in.at[i].kind == FILE_SS && !new->made.of[i].is_included) {
            const Source *src = new->in.at[i].text;
            const Script *a = compile_script(c, old, src), *b = compile_script(c, new, src);
            diff_run_script(d, source_short_name(src), a, b, max_steps);
            if (!a && !b) {
                session_script(&c->session, src, new->scripted);
                code = cli_print_diagnostics(c) == EXIT_ENVIRONMENT ? EXIT_ENVIRONMENT : EXIT_USAGE;
            }
        }
    return code;
}

static int write_result(Cli *c, const ProgramDiff *d, size_t format)
{
    static WriteDiff *const writer[FORMATS] = {diff_write_text, diff_write_markdown, diff_write_json, diff_write_svg};
    OsOutput file[2] = {{c->given[OPT_OUTPUT] ? c->value[OPT_OUTPUT] : "-", NULL, 0}};
    size_t files = 1;
    Buf out;

    buf_init(&out, d->arena);
    writer[format](d, &out);
    file[0].bytes = buf_text(&out);
    file[0].n = out.n;
    if (deps_wanted(c))
        deps_add_rule(c, file, &files, deps_list_inputs(c));
    return cli_write_outputs(c, file, files);
}

int cmd_diff(Cli *c)
{
    const OsOutput output = {c->given[OPT_OUTPUT] ? c->value[OPT_OUTPUT] : "-", NULL, 0};
    uint64_t max_steps = STEPS_MOST;
    size_t format;
    CompileInput in;
    CompileOptions o;
    Version old = {.scripted = NULL}, new = {.scripted = NULL};
    ProgramDiff *d;
    int code;

    if ((code = check_arguments(c)) != EXIT_OK)
        return code;
    if (!cli_choose_format(c, formats, FORMATS, &format) || !cli_compile_options(c, &o) || (deps_wanted(c) && !deps_check_name(c, &output)))
        return EXIT_USAGE;
    if (!cli_read_limit(c, OPT_MAX_STEPS, "--max-steps", UINT64_MAX, &max_steps))
        return EXIT_USAGE;
    if ((code = cli_read_inputs(c, &in)) != EXIT_OK)
        return code;
    o.opt_level = 2;
    o.emit = EMIT_BYTECODE;
    o.measure = true;
    o.scripts_later = true;
    if ((code = compile_version(c, &in, 0, &o, &old)) != EXIT_OK || (code = compile_version(c, &in, 1, &o, &new)) != EXIT_OK)
        return code;
    d = diff_programs(&c->session.arena, &old.side, &new.side);
    if ((code = run_scripts(c, d, &old, &new, max_steps)) != EXIT_OK || (code = write_result(c, d, format)) != EXIT_OK)
        return code;
    return diff_is_same(d) ? EXIT_OK : EXIT_PROBLEM;
}
