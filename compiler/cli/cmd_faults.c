// SPDX-License-Identifier: Apache-2.0
// smc faults: makes each input of a machine faulty, and lists what that does to the runs of scripts.
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "compiler/base/json.h"
#include "compiler/base/os_signal.h"
#include "compiler/base/path.h"
#include "compiler/cli/setting.h"
#include "compiler/cli/whatif.h"
#include "compiler/whatif/fault_script.h"

enum { RUNS_MOST = 200000, LATE = 5, DROPPED = 10, SCRIPTS_MOST = 1000 };

// One line of the list: the faults of one kind, of the same inputs and with the same outcome.
typedef struct FaultLine {
    const FaultResult *r;     // the result of the first run of this line
    uint32_t others;          // how many other triggers have the same outcome
    const char *script;       // the file that reproduces it; NULL: none
    const char *text;         // its contents
} FaultLine;

typedef struct FaultsRun {
    Cli *c;
    Arena *arena;
    WhatIf w;
    FaultOptions o;
    ScriptSettings setting;
    VEC(const Var *) input;
    VEC(uint64_t) at;
    FaultOutcome fail_on;     // FAULT_HAS_NONE: no outcome makes the command fail
    Faults *f;
    VEC(FaultLine) line;
    uint32_t scripts;         // lines with a script
    bool is_interrupted;
} FaultsRun;

static const CliFormat formats[] = {{"text", {".txt", NULL, NULL}, NULL}, {"json", {".json", NULL, NULL}, NULL}};

// ---- the list ----

static bool is_same_line(const FaultResult *a, const FaultResult *b)
{
    if (a->faults != b->faults || a->outcome != b->outcome)
        return false;
    for (uint32_t i = 0; i < a->faults; i++)
        if (a->fault[i].input != b->fault[i].input || a->fault[i].kind != b->fault[i].kind)
            return false;
    return true;
}

static int compare_lines(const void *a, const void *b)
{
    const FaultResult *x = ((const FaultLine *)a)->r, *y = ((const FaultLine *)b)->r;

    if (x->faults != y->faults)
        return x->faults < y->faults ? -1 : 1;
    if (x->outcome != y->outcome)
        return x->outcome > y->outcome ? -1 : 1;
    return x < y ? -1 : x > y;
}

static int compare_inputs(const void *a, const void *b)
{
    const FaultResult *x = *(const FaultResult *const *)a, *y = *(const FaultResult *const *)b;
    int by = (int)x->faults - (int)y->faults;

    by = by ? by : (int)x->outcome - (int)y->outcome;
    for (uint32_t i = 0; i < x->faults && by == 0; i++) {
        by = (int)x->fault[i].input - (int)y->fault[i].input;
        by = by ? by : (int)x->fault[i].kind - (int)y->fault[i].kind;
    }
    return by ? by : x < y ? -1 : x > y;
}

// Collects the results with an effect in lines; with -v, each in a line of its own.
static void collect_lines(FaultsRun *r)
{
    const uint32_t n = r->f->result.n;
    const FaultResult **order = arena_array(r->arena, n + 1, sizeof *order);
    uint32_t shown = 0;

    for (uint32_t i = 0; i < n; i++)
        if (r->f->result.at[i].outcome != FAULT_HAS_NONE)
            order[shown++] = &r->f->result.at[i];
    qsort(order, shown, sizeof *order, compare_inputs);
    for (uint32_t i = 0; i < shown; i++) {
        const FaultLine line = {order[i], 0, NULL, NULL};
        if (!r->c->given[OPT_VERBOSE] && i > 0 && is_same_line(order[i], order[i - 1]))
            r->line.at[r->line.n - 1].others++;
        else
            vec_push(r->arena, &r->line, line);
    }
    if (r->line.n > 1)
        qsort(r->line.at, r->line.n, sizeof *r->line.at, compare_lines);
}

// ---- text ----

static const char *plural(uint64_t n) { return n == 1 ? "" : "s"; }

static bool is_column(const Faults *f, FaultKind kind)
{
    for (uint32_t i = 0; i < f->input.n; i++)
        if (f->options.kinds >> kind & 1 && fault_applies(&f->input.at[i], kind))
            return true;
    return false;
}

static void write_matrix(const Faults *f, Buf *out)
{
    size_t widest = strlen("input");

    for (uint32_t i = 0; i < f->input.n; i++)
        widest = f->input.at[i].var->report_name->len > widest ? f->input.at[i].var->report_name->len : widest;
    buf_printf(out, "%-*s", (int)widest, "input");
    for (int k = 0; k < FAULT_KIND_COUNT; k++)
        if (is_column(f, (FaultKind)k))
            buf_printf(out, "  %-9s", fault_kind_name[k]);
    for (uint32_t i = 0; i < f->input.n; i++) {
        while (out->n && out->at[out->n - 1] == ' ')
            out->n--;
        buf_printf(out, "\n%-*s", (int)widest, f->input.at[i].var->report_name->text);
        for (int k = 0; k < FAULT_KIND_COUNT; k++) {
            const bool applies = f->options.kinds >> k & 1 && fault_applies(&f->input.at[i], (FaultKind)k);
            const FaultOutcome worst = faults_find_worst(f, i, (FaultKind)k);
            if (is_column(f, (FaultKind)k))
                buf_printf(out, "  %-9s", !applies ? "" : worst == FAULT_HAS_NONE ? "-" : fault_outcome_name[worst]);
        }
    }
    while (out->n && out->at[out->n - 1] == ' ')
        out->n--;
    buf_char(out, '\n');
}

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

static void write_lines(const FaultsRun *r, Buf *out)
{
    for (uint32_t i = 0; i < r->line.n; i++) {
        const FaultResult *x = r->line.at[i].r;
        if (i == 0 || x->faults != r->line.at[i - 1].r->faults || x->outcome != r->line.at[i - 1].r->outcome)
            buf_printf(out, "%s%s:\n", x->faults > 1 ? "two faults, and worse than each alone: " : "", fault_outcome_words[x->outcome]);
        write_line(r, &r->line.at[i], out);
    }
}

static void write_ranges(const Faults *f, Buf *out)
{
    for (uint32_t i = 0; i < f->input.n; i++) {
        const FaultInput *in = &f->input.at[i];
        if (!in->range_is_seen)
            continue;
        buf_printf(out, "note: '%s' has no @range; ", in->var->report_name->text);
        if (in->has_range) {
            buf_str(out, "its range in the runs without a fault is ");
            format_number_shortest(out, in->lo);
            buf_str(out, " to ");
            format_number_shortest(out, in->hi);
        } else
            buf_str(out, "it never changes, so it has no faults that depend on a range");
        buf_char(out, '\n');
    }
}

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
               (unsigned long)f->input.n, plural(f->input.n), (unsigned long)f->trigger.n, plural(f->trigger.n), (unsigned long)f->scripts, plural(f->scripts),
               count_effects(f), f->faults - f->pairs);
    if (f->options.pairs)
        buf_printf(out, "two faults at once: %" PRIu64 " pair%s, %" PRIu64 " of them worse than each alone\n", f->pairs, plural(f->pairs), f->pairs_worse);
    if (r->c->given[OPT_VERBOSE])
        buf_printf(out, "%" PRIu64 " run%s; the outcome of every other fault follows from these\n", f->runs, plural(f->runs));
    if (f->input.n)
        write_matrix(f, out);
    write_lines(r, out);
    write_ranges(f, out);
    if (r->c->given[OPT_SCRIPTS])
        buf_printf(out, "%lu of %lu line%s can be reproduced by a script in %s\n", (unsigned long)r->scripts, (unsigned long)r->line.n, plural(r->line.n),
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

static void write_json_triggers(const Faults *f, Buf *out)
{
    buf_str(out, "\"triggers\":[");
    for (uint32_t i = 0; i < f->trigger.n; i++) {
        const FaultTrigger *t = &f->trigger.at[i];
        buf_str(out, i ? ",\n{\"script\":" : "\n{\"script\":");
        json_put_string(out, path_portable_name(f->script[t->script]->src->name));
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
    buf_printf(out, "],\"trigger\":%lu,\"outcome\":\"%s\",\"end\":\"%s\"", (unsigned long)x->trigger, fault_outcome_name[x->outcome], x->end->name->text);
    if (x->violated)
        buf_printf(out, ",\"requirement\":\"%s\",\"by\":\"%s\",\"violated_G\":%" PRIu64, r->f->options.requirements->at.at[x->violated - 1].id->text,
                   x->violated_in_truth ? "true values" : "readings", x->violated_at.g);
    if (x->failed)
        buf_printf(out, ",\"failed_G\":%" PRIu64, x->failed_at.g);
    if (x->differs)
        buf_printf(out, ",\"differs\":\"%s\",\"differs_G\":%" PRIu64, x->differs->report_name->text, x->differs_at.g);
    buf_str(out, ",\"effect\":");
    json_put_string(out, buf_text(&effect));
    for (uint32_t i = 0; i < r->line.n; i++)
        if (r->line.at[i].r == x && r->line.at[i].script) {
            buf_str(out, ",\"reproduced_by\":");
            json_put_string(out, path_file_name(r->line.at[i].script));
        }
    buf_char(out, '}');
}

static void write_json(const FaultsRun *r, Buf *out)
{
    const Faults *f = r->f;

    buf_printf(out, "{\"smc-faults\":1,\"machine\":\"%s\",\"faults\":%" PRIu64 ",\"runs\":%" PRIu64 ",\"pairs\":%" PRIu64 ",\"complete\":%s,\n", f->p->name->text, f->faults, f->runs, f->pairs,
               f->is_cut || r->is_interrupted ? "false" : "true");
    write_json_inputs(f, out);
    buf_str(out, ",\n");
    write_json_triggers(f, out);
    buf_str(out, ",\n\"results\":[");
    for (uint32_t i = 0; i < f->result.n; i++) {
        buf_str(out, i ? ",\n" : "\n");
        write_json_result(r, &f->result.at[i], out);
    }
    buf_str(out, "]}\n");
}

// ---- the scripts that reproduce ----

// Returns the path from a folder to that of a file, "" or with a separator at its end; NULL: that would need a system call.
static const char *path_to_folder_of(Arena *arena, const char *folder, const char *file)
{
    const size_t to_name = (size_t)(path_file_name(file) - file);
    const char *at = path_simplify(arena, folder), *up = "";

    if (path_is_absolute(file))
        return format_in(arena, "%.*s", (int)to_name, file);
    if (path_is_absolute(folder) || strncmp(at, "..", 2) == 0)
        return NULL;
    while (*at) {
        const size_t n = strcspn(at, "/\\");
        if (n > 0 && !(n == 1 && at[0] == '.'))
            up = format_in(arena, "%s../", up);
        at += n + (at[n] != '\0');
    }
    return format_in(arena, "%s%.*s", up, (int)to_name, file);
}

static const char *name_script(const FaultsRun *r, const FaultLine *line, unsigned long number)
{
    const char *folder = r->c->value[OPT_SCRIPTS];
    const char *name = format_in(r->arena, "%03lu", number);

    for (uint32_t i = 0; i < line->r->faults; i++)
        name = format_in(r->arena, "%s-%s-%s", name, r->f->input.at[line->r->fault[i].input].var->report_name->text, fault_kind_name[line->r->fault[i].kind]);
    return format_in(r->arena, "%s%s%s.ss", folder, path_ends_in_separator(folder) ? "" : "/", name);
}

static const char *command_for(const FaultsRun *r, const char *script)
{
    const Cli *c = r->c;
    const char *command = "smc test";

    for (size_t i = 0; i < c->files; i++)
        if (!has_suffix(c->file[i], ".ss"))
            command = format_in(r->arena, "%s %s", command, c->file[i]);
    if (c->given[OPT_SV])
        command = format_in(r->arena, "%s --sv %s", command, c->value[OPT_SV]);
    for (size_t i = 0; i < c->set.n; i++)
        command = format_in(r->arena, "%s --set=%s", command, c->set.at[i]);
    if (c->given[OPT_SEED])
        command = format_in(r->arena, "%s --seed=%s", command, c->value[OPT_SEED]);
    return format_in(r->arena, "%s %s", command, script);
}

// Checks and runs the text of a script.  Returns whether it reproduces the fault.
static bool try_script(FaultsRun *r, const FaultResult *x, const char *path, const Buf *text)
{
    Session *session = &r->c->session;
    Source *src = source_new(r->arena, path, buf_text(text), text->n);
    const Diags was = session->diags;
    const Script *s;
    bool is_good;

    session->diags.muted = true;
    s = session_script(session, src, r->w.p);
    is_good = s && session->diags.errors_seen == was.errors_seen && fault_script_reproduces(r->arena, r->f, x, s);
    session->diags = was;
    return is_good;
}

static void make_script(FaultsRun *r, FaultLine *line, unsigned long number)
{
    const char *path = name_script(r, line, number), *original = r->w.path.at[r->f->trigger.at[line->r->trigger].script];
    const FaultScriptPlace place = {path_to_folder_of(r->arena, r->c->value[OPT_SCRIPTS], original), command_for(r, path)};
    Buf edited, recorded;

    buf_init(&edited, r->arena);
    buf_init(&recorded, r->arena);
    line->script = path;
    line->text = buf_text(&edited);
    if (!fault_script_write_edited(r->arena, r->f, line->r, &place, &edited) && try_script(r, line->r, path, &edited))
        line->text = buf_text(&edited);
    else if (!fault_script_write_recorded(r->arena, r->f, line->r, &place, &recorded) && try_script(r, line->r, path, &recorded))
        line->text = buf_text(&recorded);
    else
        line->script = NULL;
    r->scripts += line->script != NULL;
}

// Makes and writes the scripts of all lines.  EXIT_OK, or the exit code after a message.
static int write_scripts(FaultsRun *r)
{
    OsOutput *out = ARENA_ARRAY(r->arena, OsOutput, r->line.n + 1);
    const char *why;
    size_t n = 0;
    int code;

    if (!r->c->given[OPT_SCRIPTS])
        return EXIT_OK;
    if (!os_make_folder(r->c->value[OPT_SCRIPTS], &why)) {
        cli_print_error(r->c, TEXT_cannot_write, r->c->value[OPT_SCRIPTS], why);
        return EXIT_ENVIRONMENT;
    }
    for (uint32_t i = 0; i < r->line.n && i < SCRIPTS_MOST && !os_signal_waiting(); i++) {
        make_script(r, &r->line.at[i], i + 1);
        if (r->line.at[i].script)
            out[n++] = (OsOutput){r->line.at[i].script, r->line.at[i].text, strlen(r->line.at[i].text)};
    }
    code = outputs_check(r->c, out, n);
    for (size_t i = 0; i < n && code == EXIT_OK; i++)        // one by one: their number has no limit
        code = cli_write_outputs(r->c, &out[i], 1);
    return code;
}

// ---- running ----

// Runs the faults, until a signal asks to stop.
static void run_faults(FaultsRun *r)
{
    os_signals_begin();
    os_signals_delay();
    while (!(r->is_interrupted = os_signal_waiting() != 0) && faults_run_next(r->f))
        ;
}

static int judge(const FaultsRun *r)
{
    unsigned long n = 0;

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
    uint32_t failing;
    int code;

    r->f = faults_new(r->arena, r->w.p, r->w.script.at, r->w.script.n, &r->o);
    failing = faults_find_failing(r->f);
    if (failing < r->w.script.n) {
        cli_print_error(r->c, TEXT_faults_fails, r->w.script.at[failing]->src->name);
        faults_end(r->f);
        return EXIT_PROBLEM;
    }
    if (r->f->input.n == 0)
        cli_print_warning(r->c, TEXT_faults_no_input);
    if (r->f->trigger.n == 0)
        cli_print_warning(r->c, TEXT_faults_no_trigger);
    run_faults(r);
    collect_lines(r);
    buf_init(&out, r->arena);
    if ((code = write_scripts(r)) == EXIT_OK) {
        if (format == 0)
            write_text(r, &out);
        else
            write_json(r, &out);
        code = whatif_write(r->c, &out);
    }
    if (code == EXIT_OK)
        code = judge(r);
    faults_end(r->f);
    os_signals_resume();                  // ends the process if a signal has asked to stop
    os_signals_end();
    return code;
}

// ---- options ----

static bool add_kind(void *context, const char *word, size_t n)
{
    FaultsRun *r = context;

    for (int k = 0; k < FAULT_KIND_COUNT; k++)
        if (strlen(fault_kind_name[k]) == n && memcmp(fault_kind_name[k], word, n) == 0) {
            r->o.kinds |= 1u << k;
            return true;
        }
    cli_usage_error(r->c, TEXT_faults_kind, format_in(r->arena, "%.*s", (int)n, word));
    return false;
}

static bool add_time(void *context, const char *word, size_t n)
{
    FaultsRun *r = context;
    uint64_t g;

    if (cli_read_time(r->c, format_in(r->arena, "%.*s", (int)n, word), r->w.p->time_unit, &g) != EXIT_OK)
        return false;
    vec_push(r->arena, &r->at, g);
    return true;
}

static bool add_input(void *context, const char *word, size_t n)
{
    FaultsRun *r = context;
    const Program *p = r->w.p;
    const char *name = format_in(r->arena, "%.*s", (int)n, word);

    for (size_t i = 0; i < p->var.n; i++) {
        const Var *v = p->var.at[i];
        if (v->kind != VAR_ELEMENT || v == p->g || v == p->s || (strcmp(v->name->text, name) != 0 && (!v->alias || strcmp(v->alias->text, name) != 0)))
            continue;
        for (uint32_t k = 0; k < r->input.n; k++)
            if (r->input.at[k] == v)
                return true;
        vec_push(r->arena, &r->input, v);
        return true;
    }
    cli_print_error(r->c, TEXT_faults_input, p->name->text, name);
    return false;
}

// Reads an option that is a percentage above 0, as a part.  Returns false after a message.
static bool read_part(Cli *c, OptionId id, const char *spelling, double *part)
{
    const char *end = "";
    double percent;

    if (!c->given[id])
        return true;
    if ((end = cli_read_percent(c->value[id], &percent)) == NULL || *end != '\0' || percent == 0) {
        cli_usage_error(c, TEXT_faults_percent, spelling, c->value[id]);
        return false;
    }
    *part = percent / 100;
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
    cli_usage_error(r->c, TEXT_faults_outcome, r->c->value[OPT_FAIL_ON]);
    return false;
}

static bool read_options(FaultsRun *r, size_t *format)
{
    Cli *c = r->c;
    FaultSizes *sizes = &r->o.sizes;

    *sizes = (FaultSizes){0.05, 0.02, LATE, DROPPED, 0};
    r->o.max_runs = RUNS_MOST;
    r->o.pairs = c->given[OPT_PAIRS];
    if (!cli_choose_format(c, formats, sizeof formats / sizeof *formats, format) || !read_part(c, OPT_FAULT_OFFSET, "--offset", &sizes->offset) ||
        !read_part(c, OPT_FAULT_NOISE, "--noise", &sizes->noise) || !read_steps(c, OPT_LATE, "--late", &sizes->late) ||
        !read_steps(c, OPT_DROPPED, "--dropped", &sizes->dropped) || !read_fail_on(r))
        return false;
    if (c->given[OPT_MAX_RUNS] && !cli_read_count(c->value[OPT_MAX_RUNS], &r->o.max_runs))
        return cli_usage_error(c, TEXT_number_from_1, "--max-runs", c->value[OPT_MAX_RUNS]), false;
    r->o.has_seed = c->given[OPT_SEED];
    if (r->o.has_seed && (!cli_read_whole(c->value[OPT_SEED], &sizes->seed) || sizes->seed > SCRIPT_SEED_MAX))
        return cli_usage_error(c, TEXT_seed_value, c->value[OPT_SEED]), false;
    if (!c->given[OPT_KINDS])
        r->o.kinds = (1u << FAULT_KIND_COUNT) - 1;
    return !c->given[OPT_KINDS] || whatif_read_list(c->value[OPT_KINDS], r, add_kind);
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
