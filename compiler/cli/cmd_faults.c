// SPDX-License-Identifier: Apache-2.0
// smc faults: makes each input of a machine faulty, and lists what that does to the runs of scripts.
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "compiler/base/json.h"
#include "compiler/base/os_signal.h"
#include "compiler/base/path.h"
#include "compiler/cli/deps.h"
#include "compiler/cli/fault_lines.h"
#include "compiler/cli/progress.h"
#include "compiler/cli/setting.h"
#include "compiler/cli/whatif.h"
#include "compiler/whatif/fault_script.h"

typedef struct FaultsRun {
    Cli *c;
    Arena *arena;
    WhatIf w;
    FaultOptions o;
    ScriptSettings setting;
    VEC(const Var *) input;   // the inputs that --inputs names
    VEC(uint64_t) at;         // the times that --at names, in units of G
    FaultOutcome fail_on;     // FAULT_HAS_NONE: no outcome makes the command fail
    Faults *f;
    FaultLines lines;
    bool is_interrupted;
} FaultsRun;

static const CliFormat formats[] = {{"text", {".txt", NULL, NULL}, NULL}, {"json", {".json", NULL, NULL}, NULL}};

// ---- text ----

static const char *plural(uint64_t n) { return n == 1 ? "" : "s"; }

// Whether the matrix has a column for this kind of fault: it was requested and some input can have it.
static bool is_column(const Faults *f, FaultKind kind)
{
    for (uint32_t i = 0; i < f->input.n; i++)
        if (f->options.kinds >> kind & 1 && fault_applies(&f->input.at[i], kind))
            return true;
    return false;
}

static bool has_column(const Faults *f)
{
    bool any = false;

    for (int k = 0; k < FAULT_KIND_COUNT && !any; k++)
        any = is_column(f, (FaultKind)k);
    return any;
}

// Returns the cell of the table of worst outcomes; "": the input was not given this fault.
static const char *worst_text(const FaultsRun *r, uint32_t input, FaultKind kind)
{
    Buf b;

    if (!(r->f->options.kinds >> kind & 1) || !fault_applies(&r->f->input.at[input], kind))
        return "";
    buf_init(&b, r->arena);
    fault_write_worst(r->f, input, kind, &b);
    return b.n ? buf_text(&b) : "-";
}

// Writes a table of the worst outcomes: a row for each input, a column for each kind of fault.
static void write_matrix(const FaultsRun *r, Buf *out)
{
    const Faults *f = r->f;
    const uint32_t rows = f->input.n + 1u;                       // the first one has the heads
    const char **cell = ARENA_ARRAY(r->arena, const char *, rows * (FAULT_KIND_COUNT + 1u));
    uint32_t columns = 1;
    size_t *width;

    for (uint32_t i = 0; i < rows; i++)
        cell[i] = i == 0 ? "input" : f->input.at[i - 1].var->report_name->text;
    for (int k = 0; k < FAULT_KIND_COUNT; k++)
        if (is_column(f, (FaultKind)k)) {
            for (uint32_t i = 0; i < rows; i++)
                cell[columns * rows + i] = i == 0 ? fault_kind_name[k] : worst_text(r, i - 1, (FaultKind)k);
            columns++;
        }
    width = ARENA_ARRAY(r->arena, size_t, columns);
    for (uint32_t i = 0; i < columns * rows; i++)
        width[i / rows] = strlen(cell[i]) > width[i / rows] ? strlen(cell[i]) : width[i / rows];
    for (uint32_t i = 0; i < rows; i++) {
        for (uint32_t k = 0; k < columns; k++)
            buf_printf(out, "%s%-*s", k ? "  " : "", (int)width[k], cell[k * rows + i]);
        while (out->n && out->at[out->n - 1] == ' ')
            out->n--;
        buf_char(out, '\n');
    }
}

// Writes the name, the trigger and the effect of a fault, and how many other triggers had the same outcome.
static void write_line(const FaultsRun *r, const FaultLine *line, Buf *out)
{
    buf_str(out, "  ");
    fault_write_name(r->f, line->r, out);
    buf_char(out, ' ');
    fault_write_trigger(r->f, line->r, out);
    buf_str(out, ": ");
    fault_write_effect(r->f, line->r, out);
    if (line->others)
        buf_printf(out, "; and %lu more trigger%s", (unsigned long)line->others, plural(line->others));
    if (line->script)
        buf_printf(out, " [%s]", path_file_name(line->script));
    buf_char(out, '\n');
}

// Writes all lines. Each group with the same outcome and number of faults has a heading.
static void write_lines(const FaultsRun *r, Buf *out)
{
    bool has_others = false;

    for (uint32_t i = 0; i < r->lines.at.n; i++) {
        const FaultResult *x = r->lines.at.at[i].r;
        if (i == 0 || x->faults != r->lines.at.at[i - 1].r->faults || x->outcome != r->lines.at.at[i - 1].r->outcome)
            buf_printf(out, "%s%s:\n", x->faults > 1 ? "two faults, and worse than each alone: " : "", fault_outcome_words[x->outcome]);
        write_line(r, &r->lines.at.at[i], out);
        has_others |= r->lines.at.at[i].others > 0;
    }
    if (has_others)
        buf_str(out, "smc faults -v lists each trigger\n");
}

// Writes a note for each input whose range is not declared: where the assumed range comes from.
static void write_ranges(const FaultsRun *r, Buf *out)
{
    for (uint32_t i = 0; i < r->f->input.n; i++) {
        Buf range;
        buf_init(&range, r->arena);
        if (fault_write_range(&r->f->input.at[i], &range))
            buf_printf(out, "note: %s\n", buf_text(&range));
    }
}

// Returns how many single faults have an effect.
static unsigned long count_effects(const Faults *f)
{
    unsigned long n = 0;

    for (uint32_t i = 0; i < f->result.n; i++)
        n += f->result.at[i].faults == 1 && f->result.at[i].outcome != FAULT_HAS_NONE;
    return n;
}

static void write_text(const FaultsRun *r, Buf *out)
{
    const Faults *f = r->f;

    buf_printf(out, "faults of %s: %lu input%s, %lu trigger%s in %lu script%s; %lu of %" PRIu64 " faults have an effect\n", f->p->name->text,
               (unsigned long)f->input.n, plural(f->input.n), (unsigned long)f->trigger.n, plural(f->trigger.n),
               (unsigned long)(f->scripts - f->baseline.left_out),
               plural(f->scripts - f->baseline.left_out),
               count_effects(f), f->faults - f->pairs);
    baseline_write_text(&f->baseline, out);
    if (f->options.pairs)
        buf_printf(out, "two faults at once: %" PRIu64 " pair%s, %" PRIu64 " of them worse than each alone\n", f->pairs, plural(f->pairs),
                   f->pairs_worse);
    if (r->c->given[OPT_VERBOSE])
        buf_printf(out, "%" PRIu64 " run%s; the outcome of every other fault follows from these\n", f->runs, plural(f->runs));
    if (f->input.n)
        write_matrix(r, out);
    write_lines(r, out);
    write_ranges(r, out);
    if (r->c->given[OPT_SCRIPTS])
        buf_printf(out, "%lu of %lu line%s can be reproduced by a script in %s\n", (unsigned long)r->lines.scripts, (unsigned long)r->lines.at.n,
                   plural(r->lines.at.n),
                   r->c->value[OPT_SCRIPTS]);
}

// ---- JSON ----

static void write_number(double x, Buf *out)
{
    format_number_shortest(out, x);
}

static void write_json_inputs(const Faults *f, Buf *out)
{
    buf_str(out, "\"inputs\":[");
    for (uint32_t i = 0; i < f->input.n; i++) {
        const FaultInput *in = &f->input.at[i];
        buf_str(out, i ? ",{\"name\":" : "{\"name\":");
        json_put_string(out, in->var->report_name->text);
        if (in->has_range) {
            buf_str(out, ",\"low\":");
            write_number(in->lo, out);
            buf_str(out, ",\"high\":");
            write_number(in->hi, out);
            buf_printf(out, ",\"declared\":%s", in->range_is_seen ? "false" : "true");
        }
        buf_char(out, '}');
    }
    buf_str(out, "]");
}

// Writes the cells of the table of worst outcomes that are not empty.
static void write_json_matrix(const FaultsRun *r, Buf *out)
{
    const char *before = "\n";

    buf_str(out, "\"matrix\":[");
    for (uint32_t i = 0; i < r->f->input.n; i++)
        for (int k = 0; k < FAULT_KIND_COUNT; k++)
            if (*worst_text(r, i, (FaultKind)k)) {
                buf_printf(out, "%s{\"input\":\"%s\",\"kind\":\"%s\",\"outcome\":\"%s\",\"effect\":\"%s\"}", before,
                           r->f->input.at[i].var->report_name->text, fault_kind_name[k],
                           fault_outcome_name[faults_find_worst(r->f, i, (FaultKind)k)], worst_text(r, i, (FaultKind)k));
                before = ",\n";
            }
    buf_str(out, "],\n");
}

static void write_json_triggers(const Faults *f, Buf *out)
{
    buf_str(out, "\"triggers\":[");
    for (uint32_t i = 0; i < f->trigger.n; i++) {
        const FaultTrigger *t = &f->trigger.at[i];
        buf_str(out, i ? ",\n{\"script\":" : "\n{\"script\":");
        json_put_string(out, source_short_name(f->script[t->script]->src));
        buf_printf(out, ",\"step\":%" PRIu64 ",\"G\":%" PRIu64 ",\"state\":\"%s\"", t->step, t->g, t->state->name->text);
        if (t->from)
            buf_printf(out, ",\"from\":\"%s\"", t->from->name->text);
        buf_char(out, '}');
    }
    buf_str(out, "]");
}

static void write_json_result(const FaultsRun *r, const FaultResult *x, Buf *out)
{
    Buf effect;

    buf_init(&effect, r->arena);
    fault_write_effect(r->f, x, &effect);
    buf_str(out, "{\"faults\":[");
    for (uint32_t i = 0; i < x->faults; i++)
        buf_printf(out, "%s{\"input\":\"%s\",\"kind\":\"%s\"}", i ? "," : "", r->f->input.at[x->fault[i].input].var->report_name->text,
                   fault_kind_name[x->fault[i].kind]);
    buf_printf(out, "],\"trigger\":%lu,\"outcome\":\"%s\",\"end\":\"%s\"", (unsigned long)x->trigger, fault_outcome_name[x->outcome],
               x->end->name->text);
    if (x->violated)
        buf_printf(out, ",\"requirement\":\"%s\",\"by\":\"%s\",\"violated_G\":%" PRIu64, r->f->options.requirements->at.at[x->violated - 1].id->text,
                   x->violated_in_truth ? "true values" : "readings", x->violated_at.g);
    if (x->failed)
        buf_printf(out, ",\"failed_G\":%" PRIu64, x->failed_at.g);
    if (x->differs)
        buf_printf(out, ",\"differs\":\"%s\",\"differs_G\":%" PRIu64, x->differs->report_name->text, x->differs_at.g);
    buf_str(out, ",\"effect\":");
    json_put_string(out, buf_text(&effect));
    for (uint32_t i = 0; i < r->lines.at.n; i++)
        if (r->lines.at.at[i].r == x && r->lines.at.at[i].script) {
            buf_str(out, ",\"reproduced_by\":");
            json_put_string(out, path_file_name(r->lines.at.at[i].script));
        }
    buf_char(out, '}');
}

static void write_json(const FaultsRun *r, Buf *out)
{
    const Faults *f = r->f;

    buf_printf(out, "{\"smc-faults\":1,\"%s\":\"%s\",\"faults\":%" PRIu64 ",\"runs\":%" PRIu64 ",\"pairs\":%" PRIu64 ",\"complete\":%s",
               f->p->joint ? "application" : "machine", f->p->name->text, f->faults, f->runs, f->pairs,
               f->is_cut || r->is_interrupted ? "false" : "true");
    baseline_write_json(&f->baseline, out);
    buf_str(out, ",\n");
    write_json_inputs(f, out);
    buf_str(out, ",\n");
    write_json_matrix(r, out);
    write_json_triggers(f, out);
    buf_str(out, ",\n\"results\":[");
    for (uint32_t i = 0; i < f->result.n; i++) {
        buf_str(out, i ? ",\n" : "\n");
        write_json_result(r, &f->result.at[i], out);
    }
    buf_str(out, "]}\n");
}

// ---- running ----

// Runs the faults, until a signal asks to stop.
static void run_faults(FaultsRun *r)
{
    ProgressLine k = {r->c, 0, false};

    os_signals_begin();
    os_signals_delay();
    while (!(r->is_interrupted = os_signal_waiting() != 0) && faults_run_next(r->f))
        fault_lines_show_progress(r->f, &k);
    progress_end(&k);
}

// Reports an incomplete campaign, and outcomes at least as serious as --fail-on. Returns the exit code that they require.
static int report_fail_on(const FaultsRun *r)
{
    unsigned long n = 0, failed = 0;

    for (uint32_t i = 0; i < r->f->result.n; i++)
        failed += r->f->result.at[i].outcome == FAULT_HAS_FAILED;
    if (failed > 0 && !r->o.requirements)
        cli_print_note(r->c, TEXT_faults_asserts, failed);
    if (r->f->is_cut)
        cli_print_note(r->c, TEXT_faults_cut, (unsigned long)r->f->runs);
    if (r->is_interrupted)
        cli_print_error(r->c, TEXT_faults_interrupted, (unsigned long)r->f->runs);
    for (uint32_t i = 0; i < r->f->result.n; i++)
        n += r->fail_on != FAULT_HAS_NONE && r->f->result.at[i].outcome >= r->fail_on;
    if (n == 0)
        return EXIT_OK;
    cli_print_error(r->c, TEXT_faults_fail_on, n, plural(n), fault_outcome_words[r->fail_on]);
    return EXIT_PROBLEM;
}

static int run_and_report(FaultsRun *r, size_t format)
{
    Buf out;
    int code, incomplete;

    r->f = faults_new(r->arena, r->w.p, r->w.script.at, r->w.script.n, &r->o);
    incomplete = whatif_report_baseline(r->c, &r->f->baseline, "fault");
    if (r->f->baseline.left_out == r->w.script.n) {
        faults_end(r->f);
        return incomplete;
    }
    if (r->f->input.n == 0)
        cli_print_warning(r->c, TEXT_faults_no_input);
    if (r->f->input.n && !has_column(r->f))
        cli_print_warning(r->c, TEXT_faults_no_kind, r->c->value[OPT_KINDS]);
    if (r->f->trigger.n == 0)
        cli_print_warning(r->c, TEXT_faults_no_trigger);
    run_faults(r);
    r->lines = (FaultLines){.c = r->c, .p = r->w.p, .f = r->f};
    fault_lines_collect(&r->lines, r->c->given[OPT_VERBOSE]);
    buf_init(&out, r->arena);
    if ((code = fault_lines_write_scripts(&r->lines)) == EXIT_OK) {
        if (format == 0)
            write_text(r, &out);
        else
            write_json(r, &out);
        code = deps_write_result(r->c, &out);
    }
    if (code == EXIT_OK)
        code = report_fail_on(r);
    code = code == EXIT_OK ? incomplete : code;
    faults_end(r->f);
    os_signals_resume();                  // ends the process if a signal has asked to stop
    os_signals_end();
    return code;
}

// ---- options ----

// Returns names as a list: "stuck, dead and flipped".
static const char *list_names(Arena *arena, const char *const *name, int n, const char *last)
{
    Buf out;

    buf_init(&out, arena);
    for (int i = 0; i < n; i++)
        buf_printf(&out, "%s%s%s%s", i == 0 ? "" : i + 1 < n ? ", " : " ", i > 0 && i + 1 == n ? last : "", i > 0 && i + 1 == n ? " " : "", name[i]);
    return buf_text(&out);
}

// Called for each word of a list: adds the kind of fault with this name. Returns false after a message.
static bool add_kind(void *context, const char *word, size_t n)
{
    FaultsRun *r = context;

    for (int k = 0; k < FAULT_KIND_COUNT; k++)
        if (strlen(fault_kind_name[k]) == n && memcmp(fault_kind_name[k], word, n) == 0) {
            r->o.kinds |= 1u << k;
            return true;
        }
    cli_usage_error(r->c, TEXT_faults_kind, list_names(r->arena, fault_kind_name, FAULT_KIND_COUNT, "and"),
                    format_in(r->arena, "%.*s", (int)n, word));
    return false;
}

// Called for each word of a list: adds a time at which faults begin. Returns false after a message.
static bool add_time(void *context, const char *word, size_t n)
{
    FaultsRun *r = context;
    uint64_t g;

    if (cli_read_time(r->c, format_in(r->arena, "%.*s", (int)n, word), r->w.p->time_unit, &g) != EXIT_OK)
        return false;
    vec_push(r->arena, &r->at, g);
    return true;
}

// Called for each word of a list: adds the input with this name, into which faults are injected. Returns false after a message.
static bool add_input(void *context, const char *word, size_t n)
{
    FaultsRun *r = context;
    const Program *p = r->w.p;
    const char *name = format_in(r->arena, "%.*s", (int)n, word);

    for (size_t i = 0; i < p->var.n; i++) {
        const Var *v = p->var.at[i];
        if (v->kind != VAR_ELEMENT || v == p->g || v->state_of ||
            (strcmp(v->name->text, name) != 0 && (!v->alias || strcmp(v->alias->text, name) != 0)))
            continue;
        if (p->joint && fault_is_written(p, v)) {
            cli_print_error(r->c, TEXT_faults_shared, name);
            return false;
        }
        for (uint32_t k = 0; k < r->input.n; k++)
            if (r->input.at[k] == v)
                return true;
        vec_push(r->arena, &r->input, v);
        return true;
    }
    cli_print_error(r->c, TEXT_faults_input, p->name->text, name);
    return false;
}

// Reads an option that is a percentage above 0 into *fraction, as a fraction: 0.05 for 5 %.  Returns false after a message.
static bool read_fraction(Cli *c, OptionId id, const char *spelling, double *fraction)
{
    const char *end = "";
    double percent;

    if (!c->given[id])
        return true;
    if ((end = cli_read_percent(c->value[id], &percent)) == NULL || *end != '\0' || percent == 0) {
        cli_usage_error(c, TEXT_faults_percent, spelling, c->value[id]);
        return false;
    }
    *fraction = percent / 100;
    return true;
}

// Reads an option that is a number of steps.  Returns false after a message.
static bool read_steps(Cli *c, OptionId id, const char *spelling, uint32_t *steps)
{
    enum { MOST = 10000 };
    uint64_t n;

    if (!c->given[id])
        return true;
    if (!cli_read_count(c->value[id], &n) || n > MOST) {
        cli_usage_error(c, TEXT_faults_steps, spelling, (int)MOST, c->value[id]);
        return false;
    }
    *steps = (uint32_t)n;
    return true;
}

static bool read_fail_on(FaultsRun *r)
{
    if (!r->c->given[OPT_FAIL_ON])
        return true;
    for (int i = FAULT_HAS_NONE + 1; i < FAULT_OUTCOME_COUNT; i++)
        if (strcmp(r->c->value[OPT_FAIL_ON], fault_outcome_name[i]) == 0) {
            r->fail_on = (FaultOutcome)i;
            return true;
        }
    cli_usage_error(r->c, TEXT_faults_outcome, list_names(r->arena, fault_outcome_name + 1, FAULT_OUTCOME_COUNT - 1, "or"), r->c->value[OPT_FAIL_ON]);
    return false;
}

static bool read_options(FaultsRun *r, size_t *format)
{
    Cli *c = r->c;
    FaultSizes *sizes = &r->o.sizes;

    fault_lines_set_defaults(&r->o);
    r->o.pairs = c->given[OPT_PAIRS];
    if (!cli_choose_format(c, formats, sizeof formats / sizeof *formats, format) || !read_fraction(c, OPT_FAULT_OFFSET, "--offset", &sizes->offset) ||
        !read_fraction(c, OPT_FAULT_NOISE, "--noise", &sizes->noise) || !read_steps(c, OPT_LATE, "--late", &sizes->late) ||
        !read_steps(c, OPT_DROPPED, "--dropped", &sizes->dropped) || !read_fail_on(r))
        return false;
    if (!cli_read_limit(c, OPT_MAX_RUNS, "--max-runs", UINT64_MAX, &r->o.max_runs))
        return false;
    r->o.has_seed = c->given[OPT_SEED];
    if (r->o.has_seed && (!cli_read_whole(c->value[OPT_SEED], &sizes->seed) || sizes->seed > SCRIPT_SEED_MAX))
        return cli_usage_error(c, TEXT_seed_value, c->value[OPT_SEED]), false;
    if (!c->given[OPT_KINDS])
        return true;
    r->o.kinds = 0;
    return whatif_read_list(c->value[OPT_KINDS], r, add_kind);
}

int cmd_faults(Cli *c)
{
    FaultsRun r = {.c = c, .arena = &c->session.arena};
    size_t format;
    int code;

    if (!read_options(&r, &format))
        return EXIT_USAGE;
    if ((code = whatif_load(c, &r.w)) != EXIT_OK)
        return code;
    if (c->given[OPT_AT] && !whatif_read_list(c->value[OPT_AT], &r, add_time))
        return EXIT_USAGE;
    if (c->given[OPT_INPUTS] && !whatif_read_list(c->value[OPT_INPUTS], &r, add_input))
        return EXIT_PROBLEM;
    if ((code = settings_read(c, r.w.p, &r.setting)) != EXIT_OK)
        return code;
    r.o.input = r.input.at;
    r.o.inputs = r.input.n;
    r.o.at = r.at.at;
    r.o.times = r.at.n;
    r.o.max_steps = r.w.max_steps;
    r.o.requirements = r.w.requirements;
    r.o.setting = r.setting.at;
    r.o.settings = r.setting.n;
    return run_and_report(&r, format);
}
