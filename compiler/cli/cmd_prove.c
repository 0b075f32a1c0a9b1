// SPDX-License-Identifier: Apache-2.0
// smc prove: decides for each requirement of a machine whether a run can violate it.
#include <string.h>

#include "compiler/base/os_signal.h"
#include "compiler/cli/deps.h"
#include "compiler/cli/prove_application.h"
#include "compiler/cli/runs.h"
#include "compiler/cli/whatif.h"
#include "compiler/prove/prove_given.h"
#include "compiler/prove/prove_text.h"

static const CliFormat formats[] = {{"text", {".txt", NULL, NULL}, NULL}, {"json", {".json", NULL, NULL}, NULL}};

// Refuses what an application decides itself, and scripts: searches begin with those of one machine.
static int check_app_arguments(Cli *c, const char *app)
{
    if (c->given[OPT_SV])
        return cli_usage_error(c, TEXT_app_names_vector, app);
    if (c->given[OPT_STEP] || c->given[OPT_INIT_STATE])
        return cli_usage_error(c, TEXT_prove_app_decides, app, c->given[OPT_STEP] ? "--step" : "--init-state");
    for (size_t i = 0; i < c->files; i++)
        if (has_suffix(c->file[i], ".ss"))
            return cli_usage_error(c, TEXT_prove_app_scripts, c->file[i]);
    return EXIT_OK;
}

static int check_arguments(Cli *c)
{
    size_t machines = 0, requirements = 0;

    for (size_t i = 0; i < c->files; i++) {
        const bool is_app = has_suffix(c->file[i], ".app");
        const bool is_requirements = has_suffix(c->file[i], ".rq"), is_machine = is_app || has_suffix(c->file[i], ".sm");
        const int code = is_app ? check_app_arguments(c, c->file[i]) : EXIT_OK;
        if (code != EXIT_OK)
            return code;
        if (!is_requirements && !is_machine && !has_suffix(c->file[i], ".ss"))
            return cli_usage_error(c, TEXT_not_machine_or_requirements, c->file[i],
                                   has_suffix(c->file[i], ".sv") ? "; name the state vector with --sv" : "");
        machines += is_machine;
        requirements += is_requirements;
    }
    if (machines != 1)
        return cli_usage_error(c, machines ? TEXT_one_machine : TEXT_machine_required, c->command->name, c->command->name);
    return requirements ? EXIT_OK : cli_usage_error(c, TEXT_prove_requirements);
}

static const State *find_init_state(const Cli *c, const Program *p)
{
    for (uint32_t s = 0; c->given[OPT_INIT_STATE] && s < p->state.n; s++)
        if (strcmp(p->state.at[s]->name->text, c->value[OPT_INIT_STATE]) == 0)
            return p->state.at[s];
    return NULL;
}

static int write_result(Cli *c, size_t format, const Program *p, const ProveResult *r)
{
    Buf out;

    buf_init(&out, &c->session.arena);
    (format == 0 ? prove_write_text : prove_write_json)(&c->session.arena, p, r, &out);
    return deps_write_result(c, &out);
}

static int prove_and_write_app(Cli *c, const Requirements *what, const ProveSettings *s, size_t format)
{
    int code, written;
    Buf out;

    buf_init(&out, &c->session.arena);
    os_signals_begin();
    os_signals_delay();
    code = prove_application(c, what, s, format > 0, &out);
    written = code == EXIT_PROBLEM ? EXIT_OK : deps_write_result(c, &out);
    os_signals_resume();                  // ends the process if a signal has asked to stop
    os_signals_end();
    return written == EXIT_OK ? code : written;
}

// Returns the exit code of the verdicts: the worst one decides.
static int exit_code_of_verdicts(const ProveResult *r)
{
    int code = EXIT_OK;

    for (uint32_t i = 0; i < r->n; i++)
        if (r->of[i].verdict == PROVE_VIOLATED)
            return EXIT_PROBLEM;
        else if (r->of[i].verdict == PROVE_UNDECIDED || r->of[i].verdict == PROVE_INTERRUPTED)
            code = EXIT_INCONCLUSIVE;
    return code;
}

// The context of the calls that show what has been decided.
typedef struct ProveProgress {
    Cli *c;
    const Requirements *what;
    bool prints;              // each verdict is printed when it and those before it are known
    bool is_lost;             // a verdict could not be printed
    bool *decided;            // by requirement: its verdict is known
    uint32_t printed;         // number of verdicts that have been printed
} ProveProgress;

static bool is_not_interrupted(void *context)
{
    return !os_signal_waiting() && !((const ProveProgress *)context)->is_lost;
}

// On a terminal, shows the requirement that is being tried, and how many have been decided. If all have been, erases that line.
static void show_progress(void *context, uint32_t done, uint32_t now)
{
    const ProveProgress *k = context;
    Buf out;

    if (!os_is_terminal(2))
        return;
    buf_init(&out, &k->c->session.arena);
    if (done < k->what->at.n)
        buf_printf(&out, "\r%lu of %lu requirements decided, now %.30s  ", (unsigned long)done, (unsigned long)k->what->at.n,
                   k->what->at.at[now].id->text);
    else
        buf_printf(&out, "\r%70s\r", "");
    cli_print(k->c, 2, &out);
}

// Prints the verdict on requirement i, and those after it that were known before, in the order of the files.  The first one has before it what
// precedes the verdicts.
static void print_verdict(void *context, const ProveResult *r, uint32_t i)
{
    ProveProgress *k = context;
    Arena *arena = &k->c->session.arena;
    Buf out;

    k->decided[i] = true;
    if (!k->prints || k->is_lost || i != k->printed)
        return;
    show_progress(k, (uint32_t)k->what->at.n, 0);         // erases the line
    buf_init(&out, arena);
    if (i == 0)
        prove_write_head(k->what->program, r, &out);
    for (; k->printed < r->n && k->decided[k->printed]; k->printed++)
        prove_write_verdict(arena, k->what->program, r, k->printed, &out);
    k->is_lost = !cli_print(k->c, 1, &out);
}

// ---- scripts ----

// Returns the requirements, checked against the machine as it is without scripts. Scripts can write its locals, which a proof does not allow for.
static const Requirements *requirements_without_scripts(Cli *c, const CompileInput *in, const CompiledSource *machine)
{
    const Source **rq = ARENA_ARRAY(&c->session.arena, const Source *, in->n);
    const Diags reported = c->session.diags;
    const Requirements *out;
    size_t n = 0;

    if (machine->scripted == machine->program || machine->scripted->joint)
        return machine->requirements;
    for (size_t i = 0; i < in->n; i++)
        if (in->at[i].kind == FILE_RQ)
            rq[n++] = in->at[i].text;
    diags_init(&c->session.diags, &c->session.arena);
    out = session_requirements(&c->session, rq, n, machine->program);
    c->session.diags = reported;
    return out ? out : machine->requirements;
}

typedef VEC(ProveGiven) Givens;

// Runs the scripts of `in`, which have to pass, and records the runs in *out: searches for a violation start from them.
static int run_scripts(Cli *c, const CompileInput *in, const Compiled *made, const Program *p, Givens *out)
{
    const Program *scripted = runs_find_machine(in, made)->scripted;
    ProveGiven g;

    for (size_t i = 0; i < in->n; i++) {
        if (in->at[i].kind != FILE_SS || made->of[i].is_included)
            continue;
        if (cli_print_diagnostics(c) != EXIT_OK)
            return EXIT_PROBLEM;
        if (!prove_record_script(&c->session.arena, &c->session.diags, scripted, p, made->of[i].script, &g)) {
            diags_clear(&c->session.diags);           // the reason is not printed: a script that fails is no error here
            cli_print_note(c, TEXT_prove_failing, g.name, (unsigned long long)g.ran);
        }
        vec_push(&c->session.arena, out, g);
    }
    return cli_print_diagnostics(c);
}

// ---- the command ----

// The requirements of --requirements.
typedef struct ProveSelection { Cli *c; const Requirements *all; bool *is_chosen; } ProveSelection;

// Returns the ids of all requirements: "R1, R2, R3".
static const char *ids_of(Arena *arena, const Requirements *all)
{
    Buf out;

    buf_init(&out, arena);
    for (size_t i = 0; i < all->at.n; i++)
        buf_printf(&out, "%s%s", i ? ", " : "", all->at.at[i].id->text);
    return buf_text(&out);
}

// Called for each word of --requirements: selects the requirement with this id. Returns false after a message.
static bool add_id(void *context, const char *word, size_t n)
{
    const ProveSelection *s = context;
    bool found = false;

    for (size_t i = 0; i < s->all->at.n; i++)
        if (s->all->at.at[i].id->len == n && memcmp(s->all->at.at[i].id->text, word, n) == 0)
            found = s->is_chosen[i] = true;
    if (!found)
        cli_print_error(s->c, TEXT_prove_no_requirement, (int)n, word, ids_of(&s->c->session.arena, s->all));
    return found;
}

// Returns the requirements to decide, in the order of the files: those of --requirements, or all; NULL after a message.
static const Requirements *select_requirements(Cli *c, const Requirements *all)
{
    Arena *arena = &c->session.arena;
    ProveSelection s = {c, all, ARENA_ARRAY(arena, bool, all->at.n + 1)};
    Requirements *out;

    if (!c->given[OPT_REQUIREMENTS])
        return all;
    if (!whatif_read_list(c->value[OPT_REQUIREMENTS], &s, add_id))
        return NULL;
    out = ARENA_NEW(arena, Requirements);
    out->program = all->program;
    out->by_id = all->by_id;
    out->window = all->window;
    for (size_t i = 0; i < all->at.n; i++)
        if (s.is_chosen[i])
            vec_push(arena, &out->at, all->at.at[i]);
    return out;
}

static int prove_requirements(Cli *c, const Requirements *what, const Givens *given, const CompileOptions *o, const ProveSettings *s, size_t format)
{
    const Program *p = what->program;
    const bool is_printed = !c->given[OPT_OUTPUT] || strcmp(c->value[OPT_OUTPUT], "-") == 0;
    ProveProgress progress = {c, what, format == 0 && is_printed && what->at.n && !deps_wanted(c), false,
                              ARENA_ARRAY(&c->session.arena, bool, what->at.n + 1), 0};
    const ProveOptions options = {.delta_t = o->step, .init_state = find_init_state(c, p), .assume_ranges = c->given[OPT_ASSUME_RANGES],
                                  .any_parameters = c->given[OPT_ANY_PARAMETERS],
                                  .given = given->at, .givens = given->n, .effort = s->effort * 1000000, .memory = (size_t)s->memory << 20,
                                  .progress = show_progress, .decided = print_verdict,
                                  .go_on = is_not_interrupted, .context = &progress};
    const ProveResult *r;
    int code;

    if (c->given[OPT_INIT_STATE] && !options.init_state)
        return cli_usage_error(c, TEXT_no_state, c->value[OPT_INIT_STATE]);
    os_signals_begin();
    os_signals_delay();
    r = prove_run(&c->session.arena, what, &options);
    show_progress(&progress, (uint32_t)what->at.n, 0);
    code = progress.is_lost ? EXIT_PROBLEM : progress.prints ? EXIT_OK : write_result(c, format, p, r);
    os_signals_resume();                  // ends the process if a signal has asked to stop
    os_signals_end();
    if (code != EXIT_OK)
        return code;
    if (r->bug) {
        cli_print_error(c, TEXT_sentence, r->bug);
        return EXIT_INTERNAL;
    }
    return exit_code_of_verdicts(r);
}

int cmd_prove(Cli *c)
{
    const OsOutput file = {c->given[OPT_OUTPUT] ? c->value[OPT_OUTPUT] : "-", NULL, 0};
    ProveSettings settings = {0, 0};
    size_t format;
    CompileInput in;
    CompileOptions o;
    Compiled made;
    const Requirements *all, *what;
    Givens given = {.at = NULL};
    int code;

    if ((code = check_arguments(c)) != EXIT_OK)
        return code;
    if (!cli_choose_format(c, formats, sizeof formats / sizeof *formats, &format) || !cli_compile_options(c, &o))
        return EXIT_USAGE;
    if (!cli_read_limit(c, OPT_EFFORT, "--effort", EFFORT_MOST, &settings.effort) ||
        !cli_read_limit(c, OPT_MEMORY, "--memory", SIZE_MAX >> 20, &settings.memory))
        return EXIT_USAGE;
    if (deps_wanted(c) && !deps_check_name(c, &file))
        return EXIT_USAGE;
    if ((code = cli_read_inputs(c, &in)) != EXIT_OK)
        return code;
    o.skip_analyses = true;
    o.scripts_later = in.app != NULL;
    compile_sources(&c->session, &in, &o, &made);
    if ((code = cli_print_diagnostics(c)) != EXIT_OK)
        return code;
    all = requirements_without_scripts(c, &in, runs_find_machine(&in, &made));
    if ((what = select_requirements(c, all)) == NULL)
        return EXIT_USAGE;
    if ((code = run_scripts(c, &in, &made, what->program, &given)) != EXIT_OK)
        return code;
    if (in.app)
        return prove_and_write_app(c, what, &settings, format);
    if (runs_report_contradiction(c, all))
        return cli_print_diagnostics(c);
    return prove_requirements(c, what, &given, &o, &settings, format);
}
