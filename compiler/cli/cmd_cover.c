// SPDX-License-Identifier: Apache-2.0
// smc cover: searches for inputs that reach what no script has tested, and writes each run as a script.
//
// 1. The given scripts run, and those of the folder that a person has edited.  The goals are the coverage places (transitions, branches,
//    conditions: cover.h) that they do not cover.  The search starts with the states along the given scripts.  A script that fails is left out:
//    what it covers counts as not tested.
// 2. The other scripts of the folder that smc has written run.  If they reach every goal that is not impossible, nothing is searched.
// 3. Else the search is the same as without them, so a second call finds the same, and nothing is written twice.  What it finds is written if
//    it reaches a goal that no script of the folder reaches.
#include <string.h>

#include "compiler/base/os_signal.h"
#include "compiler/base/path.h"
#include "compiler/cli/cover_run.h"
#include "compiler/cli/deps.h"
#include "compiler/cli/runs.h"
#include "compiler/search/scenario_record.h"
#include "compiler/search/script_writer.h"

enum {
    ALSO_MOST = 4,            // the most other goals that the comment of a script names
    GOAL_KINDS = COVER_PARAMETER      // number of kinds that can be goals: all but the last one, parameters, which are set and not reached
};

static const CliFormat formats[] = {{"text", {NULL}, NULL}, {"json", {NULL}, NULL}};

typedef struct CoverSettings { uint64_t effort, memory, seed, delta_t; size_t format; } CoverSettings;

// ---- options ----

// Reads a list of kinds of coverage such as "state,transition" into *kinds, a set of 1u << CoverKind. Returns false for an unknown kind.
static bool read_kinds(const char *text, unsigned *kinds)
{
    for (*kinds = 0;; text++) {
        const size_t n = strcspn(text, ",");
        int kind = 0;
        while (kind < GOAL_KINDS && (strlen(cover_kind_name[kind]) != n || strncmp(cover_kind_name[kind], text, n) != 0))
            kind++;
        if (kind == GOAL_KINDS)
            return false;
        *kinds |= 1u << kind;
        text += n;
        if (*text == '\0')
            return true;
    }
}

// Returns the names of all kinds of goals, for a message: "x, y and z".
static const char *list_kinds(Cli *c)
{
    Buf out;

    buf_init(&out, &c->session.arena);
    for (int k = 0; k < GOAL_KINDS; k++)
        buf_printf(&out, "%s%s", k == 0 ? "" : k + 1 < GOAL_KINDS ? ", " : " and ", cover_kind_name[k]);
    return buf_text(&out);
}

static int read_options(CoverRun *r, CoverSettings *s)
{
    Cli *c = r->c;

    *s = (CoverSettings){.effort = 150, .memory = 512, .seed = 1};
    r->kinds = SEARCH_KINDS;
    if (!c->given[OPT_OUTPUT] || strcmp(c->value[OPT_OUTPUT], "-") == 0 || !*c->value[OPT_OUTPUT])
        return cli_usage_error(c, TEXT_cover_folder, c->file[0]);
    r->folder = c->value[OPT_OUTPUT];
    c->given[OPT_OUTPUT] = false;                              // so that cli_choose_format does not derive the format from the name of the folder
    if (!cli_choose_format(c, formats, sizeof formats / sizeof *formats, &s->format))
        return EXIT_USAGE;
    c->given[OPT_OUTPUT] = true;
    if (c->given[OPT_GOALS] && !read_kinds(c->value[OPT_GOALS], &r->kinds))
        return cli_usage_error(c, TEXT_cover_goals, list_kinds(c));
    if (!cli_read_limit(c, OPT_EFFORT, "--effort", EFFORT_MOST, &s->effort) ||
        !cli_read_limit(c, OPT_MEMORY, "--memory", SIZE_MAX >> 20, &s->memory))
        return EXIT_USAGE;
    if (c->given[OPT_SEED] && (!cli_read_whole(c->value[OPT_SEED], &s->seed) || s->seed > SCRIPT_SEED_MAX))
        return cli_usage_error(c, TEXT_seed_value, c->value[OPT_SEED]);
    return EXIT_OK;
}

// ---- the given scripts ----

// Checks and runs the scripts that the command line names, counts what they cover, and records their runs as starting points of the search.
static int run_given(CoverRun *r, const CompileInput *in, size_t given, const Compiled *made)
{
    const ScriptOptions o = {.max_steps = COVER_STEPS_MOST, .is_compared = true, .is_silent = true};
    Engine *counting[] = {cover_open_engine(r->given), cover_open_engine(r->all)}, *recording[] = {NULL, counting[1]};
    bool *writable = arena_alloc(r->arena, r->p->var.n);
    int code;

    search_default_inputs(r->p, writable);
    for (size_t i = 0; i < given; i++)
        if (in->at[i].kind == FILE_SS && !made->of[i].is_included) {
            const Script *s = session_script(&r->c->session, in->at[i].text, r->p);
            if (s)
                vec_push(r->arena, &r->script, s);
        }
    if ((code = cli_print_diagnostics(r->c)) != EXIT_OK)
        return code;
    for (uint32_t i = 0; i < r->script.n; i++) {
        const Script *s = r->script.at[i];
        if (!cover_accept_script(r, s->src->name, s))
            continue;
        recording[0] = scenario_record_open(r->arena, r->p, counting[0], s->delta_t, writable, SCENARIO_FEW_CHANGES);
        script_run(r->arena, &r->c->session.diags, s, recording, 2, &o);
        vec_push(r->arena, &r->recorded, scenario_recorded(recording[0]));
    }
    return cli_print_diagnostics(r->c);
}

// ---- searching ----

typedef struct CoverProgress { CoverRun *r; double last; uint64_t steps; bool is_shown; } CoverProgress;

static void show_progress(CoverProgress *k, const SearchProgress *p)
{
    const double now = os_seconds();
    Buf out;

    if (now - k->last < 0.2 || !os_is_terminal(2))
        return;
    buf_init(&out, k->r->arena);
    buf_printf(&out, "\r%lu goals reached, %lu left, %.1f million steps a second, %lu %%  ", (unsigned long)p->reached, (unsigned long)p->left,
               (double)(p->steps - k->steps) / (now - k->last) / 1e6, (unsigned long)(p->effort ? 100 * p->steps / p->effort : 0));
    cli_print(k->r->c, 2, &out);
    k->last = now;
    k->steps = p->steps;
    k->is_shown = true;
}

// Called by the search now and then: shows its progress. Returns whether the search is to go on, until a signal arrives.
static bool go_on(void *context, const SearchProgress *p)
{
    CoverProgress *k = context;

    show_progress(k, p);
    k->r->was_interrupted = os_signal_waiting() != 0;
    return !k->r->was_interrupted;
}

// Erases the line of progress.
static void end_progress(CoverProgress *k)
{
    Buf out;

    buf_init(&out, k->r->arena);
    buf_printf(&out, "\r%70s\r", "");
    if (k->is_shown)
        cli_print(k->r->c, 2, &out);
}

// Searches for inputs that reach the goals. With `watch`, the only goals are the conditions that it watches (pairs of states without a
// transition).
static SearchResult *run_search(CoverRun *r, const CoverSettings *s, const SearchWatch *watch)
{
    CoverProgress progress = {r, os_seconds(), 0, false};
    const SearchOptions o = {.seed = s->seed, .effort = s->effort * 1000000, .memory = (size_t)s->memory << 20, .delta_t = s->delta_t, .kinds = r->kinds, .given = r->recorded.at, .givens = r->recorded.n,
                             .no_places = watch != NULL, .loops = true, .watch = watch, .go_on = go_on, .context = &progress};
    SearchResult *result = search_run(r->arena, r->given, &o);

    end_progress(&progress);
    return result;
}

// ---- writing ----

// Returns the goal by which a script is named: the last of its transitions that leads to where it ends, else its last transition, else
// its first goal.
static uint32_t main_goal(const CoverRun *r, const SearchScenario *s)
{
    uint32_t found = 0, ending = 0;

    for (uint32_t i = 0; i < s->goals; i++) {
        const CoverPlace *p = &r->all->place.at[s->goal[i]];
        if (p->kind != COVER_TRANSITION || r->all->hits[s->goal[i]] > 0)
            continue;
        found = s->goal[i];
        ending = p->to == s->end ? found : ending;
    }
    for (uint32_t i = 0; i < s->goals && !found; i++)
        if (r->all->hits[s->goal[i]] == 0)
            found = s->goal[i];
    return ending ? ending : found;
}

// Lists the other transitions that a script is the first to take, at most ALSO_MOST of them.
static const char *list_others(const CoverRun *r, const SearchScenario *s, uint32_t goal)
{
    uint32_t n = 0;
    Buf out;

    buf_init(&out, r->arena);
    for (uint32_t i = 0; i < s->goals && n < ALSO_MOST; i++)
        if (s->goal[i] != goal && r->all->hits[s->goal[i]] == 0 && r->all->place.at[s->goal[i]].kind == COVER_TRANSITION)
            buf_printf(&out, "%s%s", n++ ? " " : "The run also shows: ", goal_sentence(r->text, s->goal[i]));
    return buf_text(&out);
}

// Writes a scenario (a run that the search has found) as a script, runs it and stores it in the folder.  EXIT_INTERNAL: the script does not pass
// or does not reach its goal.
static int write_script(CoverRun *r, const Scenario *found, const char *stem, const char *goal, const char *also, const State *not_entered)
{
    const bool skeleton = r->c->given[OPT_SKELETONS];
    Scenario s = *found;
    const char *comment[] = {goal, "", skeleton ? "Write what must be true at each time, as an @assert." : "The asserts show what the machine does, not what it should do: check them before you rely on them.", also};
    const ScriptPage page = {.p = r->p, .scenario = &s, .engine = engine_ref_open(r->arena, r->p), .comment = comment, .comments = *also ? 4 : 3,
                             .is_skeleton = skeleton, .not_entered = not_entered};
    const ScriptOptions o = {.max_steps = COVER_STEPS_MOST, .is_compared = true, .is_silent = true};
    Engine *e = cover_open_engine(r->all);
    const Script *script;
    Buf body, out;
    OsOutput file;
    int code;

    buf_init(&body, r->arena);
    buf_init(&out, r->arena);
    s.steps++;                                                 // one more step, which shows the state to which the last one leads
    if (!script_write(r->arena, &page, &body))
        return EXIT_INTERNAL;
    generated_write(COVER_MADE_BY, r->machine, &body, &out);
    script = session_script(&r->c->session, source_new(r->arena, stem, buf_text(&out), out.n), r->p);
    diags_clear(&r->c->session.diags);
    if (!script || script_run(r->arena, &r->c->session.diags, script, &e, 1, &o).outcome != SCRIPT_PASSED)
        return EXIT_INTERNAL;
    file = (OsOutput){cover_new_path(r, stem), buf_text(&out), out.n};
    if ((code = cli_write_generated(r->c, &file)) == EXIT_OK) {
        const NewScript n = {file.path, goal, file.bytes, file.n, also};
        vec_push(r->arena, &r->new_one, n);
    }
    return code;
}

static int write_found_scripts(CoverRun *r)
{
    int code = EXIT_OK;

    for (uint32_t i = 0; i < r->result->chosens && code == EXIT_OK; i++) {
        const SearchScenario *s = &r->result->chosen[i];
        const uint32_t goal = main_goal(r, s);
        if (goal == 0)
            continue;
        code = write_script(r, &s->scenario, goal_file_stem(r->text, goal), goal_sentence(r->text, goal), list_others(r, s, goal), NULL);
        cover_settle(r->all);
    }
    return code;
}

// ---- pairs of states without a transition ----

// Returns the goal, as a sentence, of a script that shows a missing transition: the machine stays in m->in although the condition is true that
// leads to m->to from another state.
static const char *pair_goal(const CoverRun *r, const MustNot *m)
{
    return format_in(r->arena, MUST_NOT_GOAL "%s -> %s, even while %s, which leads there from %s.", m->in->name->text, m->to->name->text,
                     condition_text(r->arena, m->other->when), m->other->from->name->text);
}

// Returns the path of a script that an earlier call wrote for the pair of states with this goal, or NULL.
static const char *find_old_pair(const CoverRun *r, const char *goal)
{
    for (uint32_t i = 0; i < r->old.n; i++)
        if (r->old.at[i].verdict != OLD_STALE && strcmp(generated_goal(r->arena, r->old.at[i].src->text, r->old.at[i].src->len), goal) == 0)
            return r->old.at[i].path;
    return NULL;
}

// For each pair of states without a transition, searches a run in which the condition of another transition to the second state is true, while
// the machine stays in the first. Writes each run as a script.
static int write_pairs(CoverRun *r, const CoverSettings *s)
{
    const MustNots *m = must_not_list(r->arena, r->p);
    bool is_open = false;
    int code = EXIT_OK;

    for (uint32_t i = 0; i < m->at.n; i++) {
        const CoverPair pair = {&m->at.at[i], find_old_pair(r, pair_goal(r, &m->at.at[i]))};
        vec_push(r->arena, &r->pair, pair);
        is_open = is_open || !pair.path;
    }
    if (!is_open || r->was_interrupted)
        return EXIT_OK;
    SearchResult *found = run_search(r, s, &m->watch);
    for (uint32_t i = 0; i < m->at.n && code == EXIT_OK; i++) {
        const SearchFind *f = &found->find[found->places + i];
        const MustNot *pair = &m->at.at[i];
        if (r->pair.at[i].path || f->outcome != SEARCH_REACHED)
            continue;
        code = write_script(r, &found->chosen[f->scenario].scenario,
                            format_in(r->arena, "%s-must-not-%s-to-%s", r->p->name->text, goal_name_part(r->arena, pair->in->name->text),
                                      goal_name_part(r->arena, pair->to->name->text)),
                            pair_goal(r, pair), "", pair->to);
        if (code == EXIT_OK)
            r->pair.at[i].path = r->new_one.at[r->new_one.n - 1].path;
    }
    return code;
}

// ---- the command ----

// Marks the goals as impossible that the search has proved unreachable, although the facts (known bounds of variables) do not exclude them.
static void accept_proofs(CoverRun *r)
{
    for (uint32_t i = 1; i < r->all->place.n; i++)
        if (r->result->find[i].outcome == SEARCH_IMPOSSIBLE && r->all->hits[i] == 0)
            r->all->place.at[i].impossible = r->result->find[i].reason;
}

static bool has_open_goal(const CoverRun *r)
{
    for (uint32_t i = 1; i < r->all->place.n; i++)
        if (cover_is_goal(r, i) && r->all->hits[i] == 0 && !r->all->place.at[i].impossible)
            return true;
    return false;
}

// Searches for what reaches the open goals and writes the scripts, until a signal asks to stop.
static int search_and_write(CoverRun *r, const CoverSettings *s)
{
    int code = EXIT_OK;

    os_signals_begin();
    os_signals_delay();
    if (has_open_goal(r)) {
        r->result = run_search(r, s, NULL);
        code = write_found_scripts(r);
        accept_proofs(r);
    }
    if (code == EXIT_OK && r->c->given[OPT_MUST_NOT])
        code = write_pairs(r, s);
    return code;
}

static int write_dependencies(CoverRun *r)
{
    OsOutput out[2] = {{r->folder, NULL, 0}};
    size_t n = 1;

    if (!deps_wanted(r->c))
        return EXIT_OK;
    deps_add_rule(r->c, out, &n, deps_list_inputs(r->c));
    return cli_write_outputs(r->c, &out[1], 1);
}

static int write_results(CoverRun *r, const CoverSettings *s)
{
    const CoverTotals t = cover_count(r);
    Buf out;

    buf_init(&out, r->arena);
    (s->format == 0 ? cover_write_report : cover_write_goals_json)(r, &out);
    if (!cli_print(r->c, 1, &out))
        return EXIT_ENVIRONMENT;
    if (r->was_interrupted)
        cli_print_error(r->c, TEXT_cover_interrupted);
    else if (t.not_found)
        cli_print_error(r->c, s->effort < EFFORT_MOST ? TEXT_cover_not_found : TEXT_cover_not_found_at_all, t.not_found, t.goals,
                        (unsigned long)(s->effort < EFFORT_MOST / 10 ? 10 * s->effort : EFFORT_MOST));
    if (!r->was_interrupted && t.not_found && r->result && r->result->memory_reached)
        cli_print_error(r->c, TEXT_cover_memory, (unsigned long)s->memory, (unsigned long)(4 * s->memory));
    if (!baseline_is_complete(&r->given_run))
        cli_print_error(r->c, TEXT_cover_left_out, (unsigned long)r->given_run.left_out, (unsigned long)r->given_run.run.n);
    return r->was_interrupted ? EXIT_INCONCLUSIVE : !baseline_is_complete(&r->given_run) ? EXIT_PROBLEM : t.not_found ? EXIT_INCONCLUSIVE : EXIT_OK;
}

// Covers a machine: runs the scripts of the command line and of the folder, searches, writes scripts and results. given: number of sources that
// the command line names.
static int cover_machine(CoverRun *r, CompileInput *in, size_t given, const CompileOptions *o, const Compiled *made, CoverSettings *s)
{
    int code;

    r->given = cover_new(r->arena, r->p);
    r->all = cover_new(r->arena, r->p);
    r->text = goal_texts_new(r->arena, r->all);
    baseline_init(&r->given_run, r->arena, NULL);
    if ((code = run_given(r, in, given, made)) != EXIT_OK || (code = cover_run_folder(r)) != EXIT_OK)
        return code;
    s->delta_t = o->step ? o->step : r->script.n ? r->script.at[0]->delta_t : SEARCH_DELTA_T;
    cover_settle(r->given);
    cover_settle(r->all);
    if ((code = search_and_write(r, s)) == EXIT_OK && (code = write_dependencies(r)) == EXIT_OK)
        code = write_results(r, s);
    os_signals_resume();                  // ends the process if a signal has asked to stop
    os_signals_end();
    return code;
}

int cmd_cover(Cli *c)
{
    CoverRun r = {.c = c, .arena = &c->session.arena};
    CoverSettings settings;
    CompileInput in;
    CompileOptions o;
    Compiled made;
    size_t given;
    int code;

    if ((code = runs_check_arguments(c)) != EXIT_OK || (code = read_options(&r, &settings)) != EXIT_OK)
        return code;
    if (!cli_compile_options(c, &o))
        return EXIT_USAGE;
    if ((code = cli_read_inputs(c, &in)) != EXIT_OK)
        return code;
    given = in.n;
    for (size_t i = 0; i < given; i++)
        if (in.at[i].kind == FILE_SM)
            r.machine = path_file_name(in.at[i].text->name);
    if ((code = cover_read_folder(&r, &in)) != EXIT_OK)
        return code;
    if ((code = runs_compile(c, &in, &o, &made)) != EXIT_OK)
        return code;
    r.p = runs_find_machine(&in, &made)->scripted;
    return cover_machine(&r, &in, given, &o, &made, &settings);
}
