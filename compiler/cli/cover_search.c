// SPDX-License-Identifier: Apache-2.0
// The searches of smc cover, and the scripts that they write.
//
// In an application, the goals of one machine after the other are searched, twice.  What the search for one machine finds is where the searches for
// the next ones begin, so that a state which one machine reaches is known to those that wait for it.
#include <string.h>

#include "compiler/base/os_signal.h"
#include "compiler/cli/cover_run.h"
#include "compiler/search/script_writer.h"
#include "compiler/search/search_app.h"

enum {
    ALSO_MOST = 4,            // the most other goals that the comment of a script names
    ROUNDS = 2                // of searches for all machines of an application
};

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

static SearchOptions options_of(const CoverRun *r, const CoverSettings *s, CoverProgress *progress)
{
    return (SearchOptions){.seed = s->seed, .effort = s->effort * 1000000, .memory = (size_t)s->memory << 20, .delta_t = s->delta_t,
                           .kinds = r->kinds, .given = r->recorded.at, .givens = r->recorded.n, .loops = true, .go_on = go_on, .context = progress};
}

// Searches for inputs that reach the goals. With `watch`, the only goals are the conditions that it watches (pairs of states without a
// transition).
static SearchResult *run_search(CoverRun *r, const CoverSettings *s, const SearchWatch *watch)
{
    CoverProgress progress = {r, os_seconds(), 0, false};
    SearchOptions o = options_of(r, s, &progress);
    SearchResult *result;

    o.no_places = watch != NULL;
    o.watch = watch;
    result = search_run(r->arena, r->given[0], &o);

    end_progress(&progress);
    return result;
}

// ---- writing ----

// Returns the goal by which a script is named: the last of its transitions that leads to where it ends, else its last transition, else
// its first goal.
static uint32_t main_goal(const Cover *all, const SearchScenario *s)
{
    uint32_t found = 0, ending = 0;

    for (uint32_t i = 0; i < s->goals; i++) {
        const CoverPlace *p = &all->place.at[s->goal[i]];
        if (p->kind != COVER_TRANSITION || all->hits[s->goal[i]] > 0)
            continue;
        found = s->goal[i];
        ending = p->to == s->end ? found : ending;
    }
    for (uint32_t i = 0; i < s->goals && !found; i++)
        if (all->hits[s->goal[i]] == 0)
            found = s->goal[i];
    return ending ? ending : found;
}

// Lists the other transitions that a script is the first to take, at most ALSO_MOST of them.
static const char *list_others(const CoverRun *r, size_t machine, const SearchScenario *s, uint32_t goal)
{
    const Cover *all = r->all[machine];
    uint32_t n = 0;
    Buf out;

    buf_init(&out, r->arena);
    for (uint32_t i = 0; i < s->goals && n < ALSO_MOST; i++)
        if (s->goal[i] != goal && all->hits[s->goal[i]] == 0 && all->place.at[s->goal[i]].kind == COVER_TRANSITION)
            buf_printf(&out, "%s%s", n++ ? " " : "The run also shows: ", goal_sentence(r->text[machine], s->goal[i]));
    return buf_text(&out);
}

// Writes a scenario (a run that the search has found) as a script, runs it and stores it in the folder.  EXIT_INTERNAL: the script does not pass
// or does not reach its goal.  every: number of ticks between steps of the machine.
static int write_script(CoverRun *r, const Scenario *found, const char *stem, const char *goal, const char *also, const State *not_entered,
                        uint64_t every)
{
    const bool skeleton = r->c->given[OPT_SKELETONS];
    Scenario s = *found;
    const char *comment[] = {goal, "", "The asserts show what the machine does, not what it should do: check them before you rely on them.", also};
    const ScriptPage page = {.p = r->p, .scenario = &s, .engine = engine_ref_open(r->arena, r->p), .comment = comment, .comments = *also ? 4 : 3,
                             .is_skeleton = skeleton, .not_entered = not_entered};
    const ScriptOptions o = {.max_steps = COVER_STEPS_MOST, .is_compared = true, .is_silent = true};
    Engine *e = cover_open_engines(r->arena, r->p, r->all);
    const Script *script;
    Buf body, out;
    OsOutput file;
    int code;

    if (skeleton)
        comment[2] = "Write what must be true at each time, as an @assert.";
    buf_init(&body, r->arena);
    buf_init(&out, r->arena);
    s.steps += every;                                          // one more step, which shows the state to which the last one leads
    if (!script_write(r->arena, &page, &body))
        return EXIT_INTERNAL;
    generated_write(COVER_MADE_BY, r->file, &body, &out);
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

// Writes the scripts of what a search for a machine's goals has found.
static int write_found_scripts(CoverRun *r, size_t machine, const SearchScenario *chosen, uint32_t n)
{
    GoalTexts *text = r->text[machine];
    int code = EXIT_OK;

    for (uint32_t i = 0; i < n && code == EXIT_OK; i++) {
        const SearchScenario *s = &chosen[i];
        const uint32_t goal = main_goal(r->all[machine], s);
        if (goal == 0)
            continue;
        code = write_script(r, &s->scenario, goal_file_stem(text, goal), goal_sentence(text, goal), list_others(r, machine, s, goal), NULL,
                            r->p->joint ? r->p->joint->member.at[machine].every : 1);
        cover_settle_each(r, r->all);
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
                            pair_goal(r, pair), "", pair->to, 1);
        if (code == EXIT_OK)
            r->pair.at[i].path = r->new_one.at[r->new_one.n - 1].path;
    }
    return code;
}

// ---- goals of one machine ----

// Marks the goals as impossible that the search has proved unreachable, although the facts (known bounds of variables) do not exclude them.
static void accept_proofs(const SearchResult *result, Cover *all)
{
    for (uint32_t i = 1; i < all->place.n; i++)
        if (result->find[i].outcome == SEARCH_IMPOSSIBLE && all->hits[i] == 0)
            all->place.at[i].impossible = result->find[i].reason;
}

// Whether a goal of the machine is neither covered nor impossible, with the counts of `cover`.
static bool has_open_goal(const CoverRun *r, size_t machine, const Cover *cover)
{
    for (uint32_t i = 1; i < cover->place.n; i++)
        if (cover_is_goal(r, machine, i) && cover->hits[i] == 0 && !cover->place.at[i].impossible)
            return true;
    return false;
}

// ---- an application ----

// What a search for the goals of a machine has found.
typedef struct Found { size_t machine; const SearchResult *result; } Found;

typedef struct AppSearch {
    CoverRun *r;
    const CoverSettings *s;
    Cover **seen;             // by machine: coverage by the given scripts and by what the searches have found, without the rest of the folder
    VEC(Scenario) start;      // where searches begin: the given scripts, and what was found
    VEC(Found) found;
    uint32_t *began;          // by machine: how many scenarios `start` had when its last search began
} AppSearch;

// Returns copies of the Covers of the given scripts.
static Cover **copy_given(const CoverRun *r)
{
    Cover **out = cover_new_each(r);

    for (size_t m = 0; m < r->machines; m++)
        memcpy(out[m]->hits, r->given[m]->hits, out[m]->place.n * sizeof *out[m]->hits);
    cover_settle_each(r, out);
    return out;
}

// Adds what a search has found to `seen` and to the beginnings of later searches.
static void add_found(AppSearch *k, size_t machine, const SearchResult *result)
{
    CoverRun *r = k->r;

    for (uint32_t i = 0; i < result->chosens; i++) {
        const Scenario *s = &result->chosen[i].scenario;
        scenario_run(r->arena, r->p, s, cover_open_engines(r->arena, r->p, k->seen), NULL, NULL);
        vec_push(r->arena, &k->start, *s);
    }
    cover_settle_each(r, k->seen);
    accept_proofs(result, k->seen[machine]);
    vec_push(r->arena, &k->found, ((Found){machine, result}));
}

// Returns the number of machines with open goals.
static size_t count_open(const AppSearch *k)
{
    size_t n = 0;

    for (size_t m = 0; m < k->r->machines; m++)
        n += has_open_goal(k->r, m, k->seen[m]);
    return n;
}

// Searches for the goals of a machine with the given effort, in steps.
static void search_machine(AppSearch *k, size_t machine, uint64_t effort)
{
    CoverRun *r = k->r;
    CoverProgress progress = {r, os_seconds(), 0, false};
    SearchOptions o = options_of(r, k->s, &progress);

    o.effort = effort;
    o.given = k->start.at;
    o.givens = k->start.n;
    k->began[machine] = k->start.n;
    r->result[machine] = search_app_run(search_app_new(r->arena, r->p, machine, k->seen), &o);
    end_progress(&progress);
    add_found(k, machine, r->result[machine]);
}

// Searches for the goals of all machines: the effort is shared equally by those that have open goals.
static int search_application(CoverRun *r, const CoverSettings *s)
{
    AppSearch k = {.r = r, .s = s, .seen = r->given, .began = ARENA_ARRAY(r->arena, uint32_t, r->machines)};
    uint64_t effort;
    int code = EXIT_OK;

    for (uint32_t i = 0; i < r->recorded.n; i++)
        vec_push(r->arena, &k.start, r->recorded.at[i]);
    k.seen = copy_given(r);
    effort = s->effort * 1000000 / (ROUNDS * (count_open(&k) + !count_open(&k)));
    for (int round = 0; round < ROUNDS; round++)
        for (size_t m = 0; m < r->machines && !r->was_interrupted; m++)
            if (has_open_goal(r, m, k.seen[m]) && (round == 0 || k.start.n > k.began[m] + r->result[m]->chosens))
                search_machine(&k, m, effort);
    for (uint32_t i = 0; i < k.found.n && code == EXIT_OK; i++)
        code = write_found_scripts(r, k.found.at[i].machine, k.found.at[i].result->chosen, k.found.at[i].result->chosens);
    for (uint32_t i = 0; i < k.found.n; i++)
        accept_proofs(k.found.at[i].result, r->all[k.found.at[i].machine]);
    return code;
}

// ---- all goals ----

static int search_one(CoverRun *r, const CoverSettings *s)
{
    int code;

    r->result[0] = run_search(r, s, NULL);
    code = write_found_scripts(r, 0, r->result[0]->chosen, r->result[0]->chosens);
    accept_proofs(r->result[0], r->all[0]);
    return code;
}

int cover_search(CoverRun *r, const CoverSettings *s)
{
    bool is_open = false;
    int code = EXIT_OK;

    for (size_t m = 0; m < r->machines; m++)
        is_open = is_open || has_open_goal(r, m, r->all[m]);
    if (is_open)
        code = (r->p->joint ? search_application : search_one)(r, s);
    if (code == EXIT_OK && r->c->given[OPT_MUST_NOT])
        code = write_pairs(r, s);
    return code;
}
