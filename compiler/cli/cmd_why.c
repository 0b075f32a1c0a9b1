// SPDX-License-Identifier: Apache-2.0
// smc why: explains a step of a script.
#include <ctype.h>
#include <string.h>

#include "compiler/cli/runs.h"
#include "compiler/cli/setting.h"
#include "compiler/script/why.h"
#include "compiler/syntax/time_unit.h"

enum { STEPS_MOST = 1000000, DEPTH = 5, DEPTH_MOST = 1000 };      // the default of --max-steps; the default and the largest value of --depth

static const CliFormat formats[] = {{"text", {NULL, NULL, NULL}, NULL}, {"json", {NULL, NULL, NULL}, NULL}};

typedef struct WhyCommand {
    Cli *c;
    Arena *arena;
    const Program *p;         // the machine or the application in the form that its scripts run
    const Script *script;
    const Requirements *requirements;
    const char *to, *of, *unit;       // the state, variable and unit of time that the question names; NULL: it names none
    const char *app;          // the path of the application; NULL: a machine
    ScriptSettings setting;
    ScriptOptions o;
    WhyQuestion q;
    uint64_t seed;
} WhyCommand;

// ---- arguments ----

// Whether the word is a unit that belongs to the number of --at before it, as in `--at 3 s`.
static bool is_time_word(const Cli *c, const char *word)
{
    return c->given[OPT_AT] && time_unit_find(word) != TIME_NONE && isdigit((unsigned char)c->value[OPT_AT][strlen(c->value[OPT_AT]) - 1]);
}

static bool is_file(const char *word)
{
    static const char *const suffixes[] = {".sm", ".app", ".ss", ".rq", ".sv", ".smt", ".cov", ".csv", ".io", ".net"};

    for (size_t i = 0; i < sizeof suffixes / sizeof *suffixes; i++)
        if (has_suffix(word, suffixes[i]))
            return true;
    return strchr(word, '/') != NULL;
}

// Stores the state or the variable that the question is about in *to. Reports a second one, and returns the exit code.
static int set_word(WhyCommand *y, const char **to, const char *word)
{
    if (y->to || y->of)
        return cli_usage_error(y->c, TEXT_why_twice, word);
    *to = word;
    return EXIT_OK;
}

// Reads an argument that is no file.  next: the argument after it, or NULL; sets *took_next if it belongs to this one.
static int read_word(WhyCommand *y, const char *word, const char *next, bool *took_next)
{
    const char *state = word + 2;

    if (strcmp(word, "-") == 0)
        return cli_usage_error(y->c, TEXT_why_arrow);
    if (strncmp(word, "->", 2) != 0 && is_time_word(y->c, word) && !y->unit) {
        y->unit = word;
        return EXIT_OK;
    }
    if (strncmp(word, "->", 2) != 0)
        return set_word(y, &y->of, word);
    while (*state == ' ')
        state++;
    *took_next = *state == '\0';
    state = *took_next ? next : state;
    return state ? set_word(y, &y->to, state) : cli_usage_error(y->c, TEXT_why_arrow_state);
}

// Separates the files from the words of the question, and checks that they are a machine, a script and requirements.
static int read_arguments(WhyCommand *y)
{
    Cli *c = y->c;
    size_t files = 0, machines = 0, scripts = 0;
    int code;

    y->to = c->given[OPT_TO] ? c->value[OPT_TO] : NULL;
    if (c->given[OPT_OF] && (code = set_word(y, &y->of, c->value[OPT_OF])) != EXIT_OK)
        return code;
    for (size_t i = 0; i < c->files; i++) {
        const char *word = c->file[i];
        bool took_next = false;
        if (is_file(word))
            c->file[files++] = word;
        else if ((code = read_word(y, word, i + 1 < c->files ? c->file[i + 1] : NULL, &took_next)) != EXIT_OK)
            return code;
        i += took_next;
    }
    c->files = files;
    for (size_t i = 0; i < files; i++) {
        y->app = has_suffix(c->file[i], ".app") ? c->file[i] : y->app;
        if (has_suffix(c->file[i], ".sm") || has_suffix(c->file[i], ".app"))
            machines++;
        else if (has_suffix(c->file[i], ".ss"))
            scripts++;
        else if (!has_suffix(c->file[i], ".rq"))
            return cli_usage_error(c, TEXT_why_files, c->file[i]);
    }
    return machines == 1 && scripts == 1 ? EXIT_OK : cli_usage_error(c, TEXT_why_what);
}

// Reads the options of the question, except its time. Returns EXIT_OK, or the exit code after a message.
static int read_options(WhyCommand *y)
{
    Cli *c = y->c;
    uint64_t depth = DEPTH;

    y->o.max_steps = STEPS_MOST;
    y->o.seed = c->given[OPT_SEED] ? &y->seed : NULL;
    if (!cli_read_limit(c, OPT_MAX_STEPS, "--max-steps", UINT64_MAX, &y->o.max_steps))
        return EXIT_USAGE;
    if (c->given[OPT_SEED] && (!cli_read_whole(c->value[OPT_SEED], &y->seed) || y->seed > SCRIPT_SEED_MAX))
        return cli_usage_error(c, TEXT_seed_value, c->value[OPT_SEED]);
    if (c->given[OPT_AT] && c->given[OPT_AT_STEP])
        return cli_usage_error(c, TEXT_why_two_steps);
    if (!cli_read_limit(c, OPT_AT_STEP, "--at-step", UINT64_MAX, &y->q.at_step))
        return EXIT_USAGE;
    if (c->given[OPT_DEPTH] && (!cli_read_whole(c->value[OPT_DEPTH], &depth) || depth > DEPTH_MOST))
        return cli_usage_error(c, TEXT_why_depth, c->value[OPT_DEPTH]);
    y->q.depth = (uint32_t)depth;
    return EXIT_OK;
}

// Reads the time of --at in units of G, with a unit after it or in an argument of its own.
static int read_time(WhyCommand *y)
{
    const char *text = y->c->value[OPT_AT];

    if (!y->c->given[OPT_AT])
        return EXIT_OK;
    y->q.has_g = true;
    return cli_read_time(y->c, y->unit ? format_in(y->arena, "%s %s", text, y->unit) : text, y->p->time_unit, &y->q.at_g);
}

// ---- the names of the question ----

static size_t machine_count(const WhyCommand *y) { return engine_machines(y->p); }

// Returns the state that the question names, in the machine with this index; NULL: the machine has no such state.
static const State *find_state(const WhyCommand *y, size_t machine)
{
    const Str name = y->to ? str_find(&y->c->session.strings, y->to, strlen(y->to)) : NULL;

    return name ? map_find(&engine_program(y->p, machine)->state_by_name, name) : NULL;
}

// Finds the variable that the question names: by its name in the machine, or by the name of its state-vector element. Bindings can make them differ.
static const Var *find_variable(const WhyCommand *y, size_t machine)
{
    const Program *p = engine_program(y->p, machine);
    const Str name = y->of ? str_find(&y->c->session.strings, y->of, strlen(y->of)) : NULL;
    const Var *found = name ? map_find(&p->by_name, name) : NULL;

    for (size_t i = 0; name && !found && i < p->var.n; i++)
        if (p->var.at[i]->kind == VAR_ELEMENT && p->var.at[i]->element->name == name)
            found = p->var.at[i];
    return found;
}

// Returns the names of all machines: "drogue, main".
static const char *list_machines(const WhyCommand *y)
{
    Buf out;

    buf_init(&out, y->arena);
    for (size_t i = 0; i < machine_count(y); i++)
        buf_printf(&out, "%s%s", i ? ", " : "", engine_machine_name(y->p, i));
    return buf_text(&out);
}

// Whether the machine is meant by the question: it has the state, or assigns the variable.  An input belongs to the first one that has it.
static bool can_answer_for(const WhyCommand *y, size_t machine)
{
    const Var *v = find_variable(y, machine);

    if (!v || v->written)
        return find_state(y, machine) || v;
    for (size_t i = 0; i < machine_count(y); i++) {
        const Var *other = i == machine ? NULL : find_variable(y, i);
        if (other && (other->written || i < machine))
            return false;
    }
    return true;
}

// ---- names that are unknown ----

typedef VEC(const char *) Names;

// Adds the names of the states of a machine, or of its elements and locals.
static void add_names(const WhyCommand *y, size_t machine, bool states, Names *out)
{
    const Program *p = engine_program(y->p, machine);

    for (size_t i = 0; states && i < p->state.n; i++)
        vec_push(y->arena, out, p->state.at[i]->name->text);
    for (size_t i = 0; !states && i < p->var.n; i++) {
        vec_push(y->arena, out, p->var.at[i]->name->text);
        if (p->var.at[i]->kind == VAR_ELEMENT)
            vec_push(y->arena, out, p->var.at[i]->element->name->text);
    }
}

static const char *join_names(const WhyCommand *y, const Names *names)
{
    Buf out;

    buf_init(&out, y->arena);
    for (size_t i = 0; i < names->n; i++)
        buf_printf(&out, "%s%s", i ? ", " : "", names->at[i]);
    return buf_text(&out);
}

static const char *const kind_of_name[] = {"element or local", "state"};

// Reports a name that the machine of the question does not have.
static int report_unknown(WhyCommand *y, bool is_state, const char *word)
{
    const char *near, *machine = engine_machine_name(y->p, y->q.machine);
    Names names = {0};

    add_names(y, y->q.machine, !is_state, &names);
    for (size_t i = 0; i < names.n; i++)
        if (strcmp(names.at[i], word) == 0)
            return cli_usage_error(y->c, is_state ? TEXT_why_is_variable : TEXT_why_is_state, word, machine, word);
    names.n = 0;
    add_names(y, y->q.machine, is_state, &names);
    near = str_nearest(word, names.at, names.n);
    if (near)
        return cli_usage_error(y->c, TEXT_why_no_name_near, machine, kind_of_name[is_state], word, near);
    if (is_state)
        return cli_usage_error(y->c, TEXT_why_no_state, machine, word, join_names(y, &names));
    return cli_usage_error(y->c, TEXT_why_no_name, machine, kind_of_name[is_state], word);
}

// Reports a name that no machine of an application has.
static int report_unknown_to_all(WhyCommand *y, bool is_state, const char *word)
{
    const char *near;
    Names names = {0};

    for (size_t i = 0; i < machine_count(y); i++)
        add_names(y, i, is_state, &names);
    near = str_nearest(word, names.at, names.n);
    if (near)
        return cli_usage_error(y->c, TEXT_why_no_machine_has_near, y->app, kind_of_name[is_state], word, near);
    return cli_usage_error(y->c, TEXT_why_no_machine_has, y->app, kind_of_name[is_state], word);
}

// ---- what the question is about ----

// Reads the machine that --machine names, or the question, as in drogue.Firing.  *word: its name, or NULL.
static int read_machine(WhyCommand *y, const char **word)
{
    const char **asked = y->to ? &y->to : &y->of, *given = y->c->given[OPT_MACHINE] ? y->c->value[OPT_MACHINE] : NULL;
    const char *point = *asked ? strchr(*asked, '.') : NULL;

    *word = given;
    if (given && !y->p->joint)
        return cli_usage_error(y->c, TEXT_why_machine_of_app);
    if (!point || point[1] == '\0' || !y->p->joint)
        return EXIT_OK;
    *word = format_in(y->arena, "%.*s", (int)(point - *asked), *asked);
    if (given && strcmp(given, *word) != 0)
        return cli_usage_error(y->c, TEXT_why_other_machine, *asked, given);
    *asked = point + 1;
    return EXIT_OK;
}

// Selects the machine of an application.  Without --machine or the name of a machine, the question must be about only one of them.
static int choose_machine(WhyCommand *y)
{
    const char *word, *asked;
    size_t found = 0, n = 0;
    const int code = read_machine(y, &word);

    if (code != EXIT_OK)
        return code;
    asked = y->to ? y->to : y->of;
    for (size_t i = 0; i < machine_count(y); i++)
        if (word ? strcmp(word, engine_machine_name(y->p, i)) == 0 : machine_count(y) == 1 || can_answer_for(y, i)) {
            found = i;
            n++;
        }
    if (word && n == 0)
        return cli_usage_error(y->c, TEXT_why_no_machine, y->app, word, list_machines(y));
    if (!asked && n != 1)
        return cli_usage_error(y->c, TEXT_why_which_step, y->app, list_machines(y));
    if (n == 0)
        return report_unknown_to_all(y, y->to != NULL, asked);
    if (n > 1)
        return cli_usage_error(y->c, TEXT_why_which_machine, asked, list_machines(y));
    y->q.machine = (uint32_t)found;
    return EXIT_OK;
}

// Finds the state and the variable of the question in its machine.
static int find_names(WhyCommand *y)
{
    y->q.to = find_state(y, y->q.machine);
    y->q.of = find_variable(y, y->q.machine);
    if (y->to && !y->q.to)
        return report_unknown(y, true, y->to);
    return y->of && !y->q.of ? report_unknown(y, false, y->of) : EXIT_OK;
}

// ---- the command ----

// Compiles the machine and the script.  EXIT_OK, or the exit code after messages.
static int compile_machine_and_script(WhyCommand *y)
{
    Cli *c = y->c;
    CompileInput in;
    CompileOptions o;
    Compiled made;
    size_t machine = 0;
    int code;

    if (!cli_compile_options(c, &o))
        return EXIT_USAGE;
    if ((code = cli_read_inputs(c, &in)) != EXIT_OK)
        return code;
    if ((code = runs_compile(c, &in, &o, &made)) != EXIT_OK)
        return code;
    while (in.at[machine].kind != FILE_SM && in.at[machine].kind != FILE_APP)
        machine++;
    y->p = made.of[machine].scripted;
    y->requirements = made.of[machine].requirements;
    for (size_t i = 0; i < in.n; i++)
        if (in.at[i].kind == FILE_SS)
            y->script = session_script(&c->session, in.at[i].text, y->p);
    return cli_print_diagnostics(c);
}

// Reports why the question has no answer, if so. Returns the exit code.
static int report_status(WhyCommand *y, const WhyAnswer *a)
{
    const char *asked = format_in(y->arena, "%llu", (unsigned long long)(y->q.at_step ? y->q.at_step : y->q.at_g));

    switch (a->status) {
    case WHY_ANSWERED: return EXIT_OK;
    case WHY_BETWEEN_STEPS:
        if (a->steps == 1)
            cli_print_error(y->c, TEXT_why_before, asked, (unsigned long long)a->after);
        else
            cli_print_error(y->c, TEXT_why_between, asked, (unsigned long long)a->before, (unsigned long long)a->after);
        break;
    case WHY_ENDED_BEFORE:
        cli_print_error(y->c, y->q.at_step ? TEXT_why_ended_step : TEXT_why_ended, asked, (unsigned long long)a->steps,
                        (unsigned long long)a->before);
        break;
    case WHY_NO_STEP: cli_print_error(y->c, TEXT_why_never_ran, engine_machine_name(y->p, y->q.machine)); break;
    case WHY_NOT_RUN: cli_print_error(y->c, TEXT_why_not_run); break;
    }
    return EXIT_PROBLEM;
}

static int write_answer(WhyCommand *y, size_t format)
{
    WhyAnswer a;
    Buf out;
    int code;

    y->o.setting = y->setting.at;
    y->o.settings = y->setting.n;
    y->o.requirements = y->requirements;
    a = why_ask(y->arena, y->script, &y->o, &y->q);
    if ((code = report_status(y, &a)) != EXIT_OK)
        return code;
    buf_init(&out, y->arena);
    if (format == 0)
        why_write_text(&a, &out);
    else
        why_write_json(&a, &out);
    return cli_print(y->c, 1, &out) ? EXIT_OK : EXIT_ENVIRONMENT;
}

int cmd_why(Cli *c)
{
    WhyCommand y = {.c = c, .arena = &c->session.arena};
    size_t format;
    int code;

    if (!cli_choose_format(c, formats, sizeof formats / sizeof *formats, &format))
        return EXIT_USAGE;
    if ((code = read_arguments(&y)) != EXIT_OK || (code = read_options(&y)) != EXIT_OK || (code = compile_machine_and_script(&y)) != EXIT_OK ||
        (code = settings_read(c, y.p, &y.setting)) != EXIT_OK || (code = read_time(&y)) != EXIT_OK || (code = choose_machine(&y)) != EXIT_OK ||
        (code = find_names(&y)) != EXIT_OK)
        return code;
    return write_answer(&y, format);
}
