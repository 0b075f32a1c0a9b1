// SPDX-License-Identifier: Apache-2.0
// smc mutate: changes a machine, or each machine of an application, in one place at a time, and lists the changes that no script notices.
#include "compiler/analysis/transitions.h"
#include "compiler/base/json.h"
#include "compiler/base/os_signal.h"
#include "compiler/base/path.h"
#include "compiler/cli/deps.h"
#include "compiler/cli/mutate_scripts.h"
#include "compiler/cli/runs.h"
#include "compiler/cli/whatif.h"
#include "compiler/cover/mutate.h"
#include "compiler/search/mutant_reach.h"

typedef struct MutateRun {
    Cli *c;
    Arena *arena;
    const Program *p;         // the machine, or the application
    const Program *machine_program;       // the machine that is changed: p, or one of the application's
    const Requirements *requirements;     // NULL: none
    Mutation *u;
    VEC(const Script *) script;
    const char *machine;      // the name of its file, without folders
    MutateScripts scripts;    // by_mutant is NULL without --scripts
    uint32_t tried;           // number of mutants that have run
    bool is_searched;         // the search of --generate has begun
    double least;             // the value of --min-score, in percent
    Buf out;                  // the text or JSON of the result
} MutateRun;

static const CliFormat formats[] = {{"text", {".txt", NULL, NULL}, NULL}, {"json", {".json", NULL, NULL}, NULL}};

// ---- text ----

// Returns the path of the script that --scripts wrote because it fails on this mutant, or NULL.
static const char *path_of_script(const MutateRun *r, const Mutant *m)
{
    uint32_t n;

    return r->scripts.by_mutant ? r->scripts.by_mutant[m - mutation_list(r->u, &n)] : NULL;
}

static void write_mutant(const MutateRun *r, const Mutant *m, Buf *out)
{
    const LineCol at = source_position(m->span.src, m->span.at);

    buf_printf(out, "  line %lu:%lu: ", (unsigned long)at.line, (unsigned long)at.col);
    mutant_write_change(r->arena, m, out);
    if (m->verdict == MUTANT_NOTICED)
        buf_printf(out, " [%s%s%s]", source_short_name(r->script.at[m->script]->src), m->violated ? ": " : "", m->violated ? m->violated->id->text : "");
    if (m->if_only_inputs_change)
        buf_str(out, " [if only inputs change]");
    if (m->scenario) {
        buf_str(out, "\n    ");
        mutant_write_scenario(r->machine_program, m, MUTANT_INPUTS_SHOWN, out);
    }
    if (path_of_script(r, m))
        buf_printf(out, " [%s]", path_file_name(path_of_script(r, m)));
    buf_char(out, '\n');
}

// Writes a title and the mutants with this verdict.
static void write_list(const MutateRun *r, MutantVerdict verdict, const char *title, Buf *out)
{
    uint32_t shown;
    const Mutant **order = mutation_order(r->u, r->arena, verdict, &shown);

    if (shown)
        buf_str(out, title);
    for (uint32_t i = 0; i < shown; i++)
        write_mutant(r, order[i], out);
}

// Writes how many changes each requirement notices: "requirements notice 3 of them: R1 2, R3 1".
static void write_requirements(const MutateRun *r, Buf *out)
{
    const size_t n = r->requirements ? r->requirements->at.n : 0;
    uint32_t mutants, sum = 0, *noticed = ARENA_ARRAY(r->arena, uint32_t, n);
    const Mutant *m = mutation_list(r->u, &mutants);

    for (uint32_t i = 0; i < mutants; i++)
        if (m[i].violated) {
            noticed[m[i].violated - r->requirements->at.at]++;
            sum++;
        }
    if (n)
        buf_printf(out, "requirements notice %lu of them", (unsigned long)sum);
    for (size_t i = 0, shown = 0; i < n; i++)
        if (noticed[i])
            buf_printf(out, "%s%s %lu", shown++ ? ", " : ": ", r->requirements->at.at[i].id->text, (unsigned long)noticed[i]);
    if (n)
        buf_char(out, '\n');
}

// Writes for how many changes the search has found inputs, and how the user gets them.
static void write_search_result(const MutateRun *r, const MutationScore *s, Buf *out)
{
    const bool can_write = s->of[MUTANT_GENERATED] && !r->c->given[OPT_SCRIPTS] && !r->p->joint;

    buf_printf(out, "inputs were found for %lu of the %lu changes that no script notices%s\n", s->of[MUTANT_GENERATED],
               s->of[MUTANT_GENERATED] + s->of[MUTANT_UNNOTICED], can_write ? "; --scripts=DIR writes them as scripts" : "");
}

static void write_text(MutateRun *r)
{
    Buf *const out = &r->out;
    const MutationScore s = mutation_score(r->u);

    buf_printf(out, "mutations of %s: %lu of %lu changes are noticed (", r->machine_program->name->text, s.of[MUTANT_NOTICED], s.noticeable);
    buf_percent(out, s.of[MUTANT_NOTICED], s.noticeable, 1);
    buf_str(out, " %)");
    if (s.of[MUTANT_EQUIVALENT])
        buf_printf(out, ", and %lu make no difference", s.of[MUTANT_EQUIVALENT]);
    if (r->tried < s.all)
        buf_printf(out, ", and %lu of %lu were not tried", s.all - r->tried, s.all);
    buf_char(out, '\n');
    baseline_write_text(mutation_baseline(r->u), out);
    write_requirements(r, out);
    if (r->is_searched)
        write_search_result(r, &s, out);
    write_list(r, MUTANT_GENERATED, "not noticed; these inputs would show it:\n", out);
    write_list(r, MUTANT_UNNOTICED, r->is_searched ? "not noticed, and no inputs were found that would show it:\n" : "not noticed:\n", out);
    if (r->scripts.by_mutant)
        buf_printf(out, "%lu script%s in %s show%s %lu of these changes\n", r->scripts.scripts, r->scripts.scripts == 1 ? "" : "s",
                   r->c->value[OPT_SCRIPTS], r->scripts.scripts == 1 ? "s" : "",
                   r->scripts.shown);
    if (r->c->given[OPT_VERBOSE]) {
        write_list(r, MUTANT_NOTICED, "noticed:\n", out);
        write_list(r, MUTANT_EQUIVALENT, "no difference:\n", out);
    }
}

// ---- JSON ----

static void write_json_mutant(const MutateRun *r, const Mutant *m, Buf *out)
{
    const LineCol at = source_position(m->span.src, m->span.at);

    buf_printf(out, "{\"line\":%lu,\"column\":%lu,\"at\":%lu,\"length\":%lu,\"old\":", (unsigned long)at.line, (unsigned long)at.col,
               (unsigned long)m->span.at, (unsigned long)m->span.len);
    json_put_string(out, source_text(r->arena, m->span));
    buf_str(out, ",\"new\":");
    json_put_string(out, m->text);
    buf_printf(out, ",\"danger\":\"%s\",\"verdict\":\"%s\"", mutant_danger_name[m->danger], mutant_verdict_name[m->verdict]);
    if (m->verdict == MUTANT_NOTICED) {
        buf_str(out, ",\"script\":");
        json_put_string(out, source_short_name(r->script.at[m->script]->src));
        if (m->violated)
            buf_printf(out, ",\"requirement\":\"%s\"", m->violated->id->text);
    }
    if (m->if_only_inputs_change)
        buf_str(out, ",\"if\":\"only inputs change\"");
    if (m->scenario) {
        Buf words;
        buf_init(&words, r->arena);
        mutant_write_scenario(r->machine_program, m, SIZE_MAX, &words);
        buf_str(out, ",\"inputs\":");
        json_put_string(out, buf_text(&words));
    }
    if (path_of_script(r, m)) {
        buf_str(out, ",\"shown_by\":");
        json_put_string(out, path_file_name(path_of_script(r, m)));
    }
    buf_char(out, '}');
}

static void write_json(MutateRun *r)
{
    Buf *const out = &r->out;
    const MutationScore s = mutation_score(r->u);
    uint32_t n;
    const Mutant *m = mutation_list(r->u, &n);

    buf_printf(out, "{\"smc-mutations\":1,\"machine\":\"%s\",\"score\":", r->machine_program->name->text);
    buf_percent(out, s.of[MUTANT_NOTICED], s.noticeable, 1);
    for (int v = MUTANT_NOTICED; v < MUTANT_VERDICT_COUNT; v++)
        buf_printf(out, ",\"%s\":%lu", mutant_verdict_name[v], s.of[v]);
    buf_printf(out, ",\"waiting\":%lu", s.of[MUTANT_WAITING]);
    baseline_write_json(mutation_baseline(r->u), out);
    buf_str(out, ",\"mutants\":[\n");
    for (uint32_t i = 0; i < n; i++) {
        write_json_mutant(r, &m[i], out);
        buf_str(out, i + 1 < n ? ",\n" : "\n");
    }
    buf_str(out, "]}\n");
}

// ---- running ----

// Runs the mutants, until a signal asks to stop.
static void run_mutants(MutateRun *r)
{
    ProgressLine k = {r->c, 0, false};

    while (!os_signal_waiting() && mutation_run_next(r->u)) {
        r->tried++;
        mutate_show_progress(r->u, &k);
    }
    r->is_searched = r->c->given[OPT_GENERATE] && !os_signal_waiting();
    while (r->c->given[OPT_GENERATE] && !os_signal_waiting() && mutation_search_next(r->u, MUTATE_SEARCH_STEPS))
        mutate_show_progress(r->u, &k);
    while (r->c->given[OPT_GENERATE] && !os_signal_waiting() && mutant_reach_next(r->u, MUTANT_REACH_EFFORT, MUTATE_SEARCH_STEPS))
        mutate_show_progress(r->u, &k);
    progress_end(&k);
}

// Compares the score with --min-score. Returns EXIT_PROBLEM after a message if it is lower.
static int check_min_score(MutateRun *r)
{
    const MutationScore s = mutation_score(r->u);
    Buf percent;

    if (!r->c->given[OPT_MIN_SCORE] || s.percent >= r->least)
        return EXIT_OK;
    buf_init(&percent, r->arena);
    buf_percent(&percent, s.of[MUTANT_NOTICED], s.noticeable, 1);
    cli_print_error(r->c, TEXT_score_too_low, format_in(r->arena, "%s %%", buf_text(&percent)),
                    r->p->joint ? format_in(r->arena, " of %s", r->machine_program->name->text) : "", format_in(r->arena, "%g %%", r->least));
    return EXIT_PROBLEM;
}

// Whether every script fails without a change.
static bool has_no_script(const MutateRun *r) { return mutation_baseline(r->u)->left_out == r->script.n; }

// Changes one machine, and adds what is found to the result.
static int mutate_machine(MutateRun *r, size_t member, uint64_t max_steps, size_t format)
{
    int code = EXIT_OK;

    r->tried = 0;
    r->machine_program = engine_program(r->p, member);
    r->u = mutation_new(r->arena, r->p, member, r->script.at, r->script.n, r->requirements, max_steps);
    if (member == 0 || has_no_script(r))
        whatif_report_baseline(r->c, mutation_baseline(r->u), "change");
    if (has_no_script(r)) {
        mutation_end(r->u);
        return EXIT_PROBLEM;
    }
    run_mutants(r);
    if (r->c->given[OPT_SCRIPTS])
        code = mutate_write_scripts(r->c, r->u, r->p, r->machine, r->c->value[OPT_SCRIPTS], &r->scripts);
    if (code == EXIT_OK) {
        (format == 0 ? write_text : write_json)(r);
        code = check_min_score(r);
    }
    code = code == EXIT_OK && !baseline_is_complete(mutation_baseline(r->u)) ? EXIT_PROBLEM : code;
    if (r->tried < mutation_score(r->u).all)
        cli_print_error(r->c, TEXT_mutate_interrupted, (unsigned long)r->tried, mutation_score(r->u).all);
    mutation_end(r->u);
    return code;
}

// Changes the machine, or each machine of the application in turn, and writes what is found.
static int mutate_machines(MutateRun *r, uint64_t max_steps, size_t format)
{
    const size_t machines = engine_machines(r->p);
    int code = EXIT_OK, written;

    os_signals_begin();
    os_signals_delay();
    buf_init(&r->out, r->arena);
    if (r->p->joint && format > 0)
        buf_printf(&r->out, "{\"smc-mutations\":1,\"application\":\"%s\",\"machines\":[\n", r->p->name->text);
    for (size_t i = 0; i < machines && code <= EXIT_PROBLEM && !os_signal_waiting(); i++) {
        int now;
        buf_str(&r->out, format > 0 && i > 0 ? "," : "");
        now = mutate_machine(r, i, max_steps, format);
        if (has_no_script(r))
            return now;
        code = now > code ? now : code;
    }
    if (r->p->joint && format > 0)
        buf_str(&r->out, "]}\n");
    written = code <= EXIT_PROBLEM ? deps_write_result(r->c, &r->out) : code;
    os_signals_resume();                  // ends the process if a signal has asked to stop
    os_signals_end();
    return written == EXIT_OK ? code : written;
}

// ---- the command ----

// Checks the scripts.  EXIT_OK, or EXIT_PROBLEM after their diagnostics.
static int check_scripts(MutateRun *r, const CompileInput *in, const Compiled *made)
{
    for (size_t i = 0; i < in->n; i++)
        if (in->at[i].kind == FILE_SS && !made->of[i].is_included) {
            const Script *s = session_script(&r->c->session, in->at[i].text, r->p);
            if (s)
                vec_push(r->arena, &r->script, s);
        }
    return cli_print_diagnostics(r->c);
}

static int read_options(MutateRun *r, uint64_t *max_steps, size_t *format)
{
    Cli *c = r->c;
    const char *end = "";

    c->given[OPT_GENERATE] = c->given[OPT_GENERATE] || c->given[OPT_SCRIPTS];
    if (!cli_choose_format(c, formats, sizeof formats / sizeof *formats, format) ||
        !cli_read_limit(c, OPT_MAX_STEPS, "--max-steps", UINT64_MAX, max_steps) || !deps_check_result(c))
        return EXIT_USAGE;
    if (c->given[OPT_MIN_SCORE] && ((end = cli_read_percent(c->value[OPT_MIN_SCORE], &r->least)) == NULL || *end != '\0'))
        return cli_usage_error(c, TEXT_min_score_form, c->value[OPT_MIN_SCORE]);
    return EXIT_OK;
}

int cmd_mutate(Cli *c)
{
    MutateRun r = {.c = c, .arena = &c->session.arena};
    uint64_t max_steps = MUTATE_STEPS_MOST;
    size_t format, scripts = 0;
    CompileInput in;
    CompileOptions o;
    Compiled made;
    int code;

    if ((code = runs_check_arguments(c)) != EXIT_OK || (code = read_options(&r, &max_steps, &format)) != EXIT_OK)
        return code;
    for (size_t i = 0; i < c->files; i++)
        scripts += has_suffix(c->file[i], ".ss");
    if (scripts == 0)
        return cli_usage_error(c, TEXT_mutate_script, c->file[0]);
    if (!cli_compile_options(c, &o))
        return EXIT_USAGE;
    if ((code = cli_read_inputs(c, &in)) != EXIT_OK)
        return code;
    for (size_t i = 0; i < in.n; i++)
        if (in.at[i].kind == FILE_SM)
            r.machine = path_file_name(in.at[i].text->name);
    if ((code = runs_compile(c, &in, &o, &made)) != EXIT_OK)
        return code;
    r.p = runs_find_machine(&in, &made)->scripted;
    r.requirements = runs_find_machine(&in, &made)->requirements;
    if ((code = check_scripts(&r, &in, &made)) != EXIT_OK)
        return code;
    return mutate_machines(&r, max_steps, format);
}
