// SPDX-License-Identifier: Apache-2.0
// smc report: one page about a machine for a design review. Findings are those of `smc check` with the same files. Costs are
// those of the image that `smc build` makes. The scripts run on the VM, on an image with names.
#include <string.h>

#include "bytecode-vm/smvm.h"
#include "compiler/analysis/analysis.h"
#include "compiler/cli/runs.h"
#include "compiler/version.h"

typedef void WriteReport(const Doc *d, Buf *out);

static const CliFormat formats[] = {
    {"html", {".html", ".htm", NULL}, "a browser"}, {"text", {".txt", NULL, NULL}, NULL}, {"json", {".json", NULL, NULL}, NULL}};
enum { FORMATS = sizeof formats / sizeof *formats };

typedef struct ReportCommand {
    Cli *c;
    const char *machine;
    const Source *sm, *sv, *pins;
    const IoMap *io;          // of the flight image; or NULL
    const Program *scripted;  // the machine, compiled for its scripts
    Report r;
} ReportCommand;

// ---- the machine as it flies ----

static bool make_image(ReportCommand *x, IrMachine *m, bool debug, Buf *image)
{
    const ImageOptions o = {debug, x->io};

    buf_init(image, &x->c->session.arena);
    return session_image(&x->c->session, &m, 1, &o, image);
}

static bool weigh(ReportCommand *x, const Program *p)
{
    Session *s = &x->c->session;
    Buf image, with_lines;
    IrMachine *m;

    if (x->pins && (x->io = session_io(s, x->pins, x->sv)) == NULL)
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

// ---- findings ----

static int look_at_machine(ReportCommand *x, const Map *written)
{
    Session *s = &x->c->session;
    MachineInput in = {x->sm, x->sv, NULL, option_level(x->c)};
    Program *p = session_program(s, &in);

    if (!p)
        return EXIT_PROBLEM;
    x->r.arena = &s->arena;
    x->r.maker = "smc " SMC_VERSION;
    x->r.step_given = x->c->given[OPT_STEP];
    s->warnings = DIAG_GROUPS_ALL;
    session_analyse(s, p);
    in.written_outside = written;
    if ((x->scripted = session_program_for_scripts(s, &in, p)) == NULL)
        return EXIT_PROBLEM;
    diags_apply_allows(&s->diags);
    diags_sort(&s->diags);
    analysis_begin(&x->r.analysis, &s->arena, &s->diags, p);
    x->r.analysis.step = s->step;
    return s->diags.errors == 0 && weigh(x, p) ? EXIT_OK : EXIT_PROBLEM;
}

// ---- the command ----

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
    return cli_write(x->c, &file, 1);
}

static int say_failed(const ReportCommand *x)
{
    int code = EXIT_OK;

    for (size_t i = 0; i < x->r.runs; i++)
        if (!x->r.run[i].script || x->r.run[i].result.outcome != SCRIPT_PASSED) {
            cli_say(x->c, "%s failed; the report says why", x->r.run[i].name);
            code = EXIT_PROBLEM;
        }
    return code;
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
    if ((code = runs_machine(c, &x.machine)) != EXIT_OK)
        return code;
    if ((writer = find_format(c)) == NULL)
        return EXIT_USAGE;
    if (!step_known(c))
        return EXIT_USAGE;
    if (c->given[OPT_IO] && !c->given[OPT_SV])
        return cli_usage(c, "--io names the pins of the image by the state vector that --sv names");
    if ((x.sm = cli_load(c, x.machine)) == NULL || (c->given[OPT_SV] && (x.sv = cli_load(c, c->value[OPT_SV])) == NULL)
        || (c->given[OPT_IO] && (x.pins = cli_load(c, c->value[OPT_IO])) == NULL) || !runs_load(c, &ss, &written))
        return EXIT_ENVIRONMENT;
    if ((code = look_at_machine(&x, &written)) != EXIT_OK || (code = runs_make(c, &x.r, x.scripted, ss)) != EXIT_OK) {
        cli_report(c);
        return code;
    }
    if ((code = write_report(&x, writer)) != EXIT_OK)
        return code;
    return say_failed(&x);
}
