// SPDX-License-Identifier: Apache-2.0
// smc report: one page about a machine for a design review.  Findings are those of `smc check` with the same files; costs are of
// the image that `smc build` makes; the scripts are run on the VM, on an image with names.
#include <string.h>

#include "bytecode-vm/smvm.h"
#include "compiler/analysis/analysis.h"
#include "compiler/cli/cli.h"
#include "compiler/emit/report/report.h"
#include "compiler/version.h"

typedef void WriteReport(const Doc *d, Buf *out);

static const CliFormat formats[] = {
    {"html", {".html", ".htm", NULL}}, {"text", {".txt", NULL, NULL}}, {"json", {".json", NULL, NULL}}};
enum { FORMATS = sizeof formats / sizeof *formats };

enum { STEPS_MOST = 1000000 };        // of a script, as in smc test

typedef struct ReportCommand {
    Cli *c;
    const char *machine;
    const Source *sm, *sv;
    Report r;
    bool failed;                      // a script did
} ReportCommand;

// ---- the machine as it flies ----

static bool make_image(ReportCommand *x, IrMachine *m, bool debug, Buf *image)
{
    const ImageOptions o = {debug, NULL};

    buf_init(image, &x->c->session.arena);
    return session_image(&x->c->session, &m, 1, &o, image);
}

// Compiled once more, without regard to what scripts write: all that can be said of it has been said.
static Program *compile_alone(ReportCommand *x)
{
    Session *s = &x->c->session;
    const MachineInput in = {x->sm, x->sv, NULL, option_level(x->c)};
    const Diags said = s->diags;
    Program *p;

    diags_init(&s->diags, &s->arena);
    p = session_program(s, &in);
    s->diags = said;
    return p;
}

static bool weigh(ReportCommand *x)
{
    Session *s = &x->c->session;
    Program *p = compile_alone(x);
    Buf image, with_lines;
    IrMachine *m;

    if (!p)
        return false;
    s->hide_locals = true;
    m = session_ir(s, p, option_level(x->c));
    s->hide_locals = false;
    if (!make_image(x, m, false, &image) || !make_image(x, m, true, &with_lines))
        return false;
    cost_of_machine(&s->arena, (const uint8_t *)with_lines.at, 0, COST_INSTRUCTIONS, &x->r.cost);
    cost_of_machine(&s->arena, (const uint8_t *)with_lines.at, 0, COST_CYCLES_FLASH, &x->r.flash);
    cost_of_machine(&s->arena, (const uint8_t *)with_lines.at, 0, COST_CYCLES_EEPROM, &x->r.eeprom);
    x->r.image = (const uint8_t *)image.at;
    x->r.image_size = image.n;
    return true;
}

// ---- what is found in it ----

static int look_at_machine(ReportCommand *x, const Map *written)
{
    Session *s = &x->c->session;
    const MachineInput in = {x->sm, x->sv, written, option_level(x->c)};
    Program *p = session_program(s, &in);

    if (!p)
        return EXIT_PROBLEM;
    x->r.arena = &s->arena;
    x->r.maker = "smc " SMC_VERSION;
    s->warnings = DIAG_GROUPS_ALL;
    session_analyse(s, p);
    diags_apply_allows(&s->diags);
    diags_sort(&s->diags);
    analysis_begin(&x->r.analysis, &s->arena, &s->diags, p);
    return s->diags.errors == 0 && weigh(x) ? EXIT_OK : EXIT_PROBLEM;
}

// ---- its scripts ----

static Engine *open_engine(ReportCommand *x, const Program *p, const char **error)
{
    Session *s = &x->c->session;
    Buf image;

    *error = "the image cannot be made";
    if (!make_image(x, session_ir(s, p, option_level(x->c)), true, &image))
        return NULL;
    return engine_vm_open(&s->arena, p, (const uint8_t *)image.at, image.n, 0, error);
}

static void run_script(ReportCommand *x, ReportRun *run, const Source *ss, const Program *p, Engine *vm)
{
    Session *s = &x->c->session;
    const ScriptOptions o = {STEPS_MOST, NULL, NULL, NULL};
    const Diags machine = s->diags;
    Engine *traced;

    run->name = report_file_name(ss->name);
    trace_init(&run->trace, &s->arena, p, &x->r.analysis.transition);
    diags_init(&s->diags, &s->arena);
    if ((run->script = session_script(s, ss, p)) != NULL) {
        traced = trace_engine(&run->trace, vm);
        run->result = script_run(&s->arena, &s->diags, run->script, &traced, 1, &o);
    }
    x->failed = x->failed || !run->script || run->result.outcome != SCRIPT_PASSED;
    run->diags = s->diags;
    s->diags = machine;
}

static int run_scripts(ReportCommand *x, Source *const *ss)
{
    Cli *c = x->c;
    const Program *p = x->r.analysis.p;
    const char *error;
    Engine *vm;

    if (c->files < 2)
        return EXIT_OK;
    if ((vm = open_engine(x, p, &error)) == NULL) {
        cli_say(c, "%s", error);
        return EXIT_PROBLEM;
    }
    x->r.run = ARENA_ARRAY(&c->session.arena, ReportRun, c->files);
    for (size_t i = 0; i < c->files; i++)
        if (ss[i])
            run_script(x, &x->r.run[x->r.runs++], ss[i], p, vm);
    vm->close(vm);
    return EXIT_OK;
}

// ---- the command ----

static int check_use(Cli *c, ReportCommand *x)
{
    size_t machines = 0;

    for (size_t i = 0; i < c->files; i++) {
        const bool script = has_suffix(c->file[i], ".ss");
        if (!script && !has_suffix(c->file[i], ".sm") && strcmp(c->file[i], "-") != 0)
            return cli_usage(c, "'%s' is no machine (.sm) and no script (.ss)%s", c->file[i],
                             has_suffix(c->file[i], ".sv") ? "; name the state vector with --sv" : "");
        if (!script) {
            x->machine = c->file[i];
            machines++;
        }
    }
    if (machines != 1)
        return cli_usage(c, machines ? "one machine is reported on at a time"
                                     : "report wants a machine, as in 'smc report tank.sm -o tank.html'");
    return EXIT_OK;
}

static WriteReport *find_format(Cli *c)
{
    static WriteReport *const writer[FORMATS] = {doc_write_html, doc_write_text, doc_write_json};
    size_t i;

    return cli_format(c, formats, FORMATS, &i) ? writer[i] : NULL;
}

static int write_report(ReportCommand *x, WriteReport *writer)
{
    OsOutput file = {x->c->given[OPT_OUTPUT] ? x->c->value[OPT_OUTPUT] : "-", NULL, 0};
    Buf out;

    buf_init(&out, &x->c->session.arena);
    writer(report_build(&x->r), &out);
    file.bytes = buf_text(&out);
    file.n = out.n;
    return cli_write(x->c, &file, 1) ? EXIT_OK : EXIT_ENVIRONMENT;
}

static void say_failed(const ReportCommand *x)
{
    for (size_t i = 0; i < x->r.runs; i++)
        if (!x->r.run[i].script || x->r.run[i].result.outcome != SCRIPT_PASSED)
            cli_say(x->c, "%s failed; the report says why", x->r.run[i].name);
}

int cmd_report(Cli *c)
{
    Map written = {&c->session.arena, NULL, NULL, 0, 0};
    ReportCommand x;
    WriteReport *writer;
    Source **ss;
    int code;

    memset(&x, 0, sizeof x);
    x.c = c;
    if ((code = check_use(c, &x)) != EXIT_OK)
        return code;
    if ((writer = find_format(c)) == NULL)
        return EXIT_USAGE;
    if ((x.sm = cli_load(c, x.machine)) == NULL || (c->given[OPT_SV] && (x.sv = cli_load(c, c->value[OPT_SV])) == NULL))
        return EXIT_ENVIRONMENT;
    ss = cli_load_scripts(c, &written);
    for (size_t i = 0; i < c->files; i++)
        if (has_suffix(c->file[i], ".ss") && !ss[i])
            return EXIT_ENVIRONMENT;
    if ((code = look_at_machine(&x, &written)) != EXIT_OK || (code = run_scripts(&x, ss)) != EXIT_OK) {
        cli_report(c);
        return code;
    }
    if ((code = write_report(&x, writer)) != EXIT_OK)
        return code;
    say_failed(&x);
    return x.failed ? EXIT_PROBLEM : EXIT_OK;
}
