// SPDX-License-Identifier: Apache-2.0
#include "compiler/prove/prove.h"

#include "compiler/prove/prove_equal.h"
#include "compiler/prove/prove_explore.h"
#include "compiler/prove/prove_given.h"
#include "compiler/prove/prove_goal.h"
#include "compiler/prove/prove_near.h"

enum {
    DELTA_T = 10,             // time from step to step, if neither the options, the machine nor a given run say it
    EFFORT = 30000000,        // how many steps the searches for a violation of a requirement run
    NEAR_SHARE = 32,          // 1 / NEAR_SHARE of the steps are for runs close to the given runs
    FIRST_SHARE = 16,         // 1 / FIRST_SHARE of the steps run before the proofs that need long
    STEPS_PER_VISIT = 20,     // an exploration that needs long visits at most a path for each of so many steps of the effort
    FEW_STEPS = 1000,         // a longer scenario is shortened
    FEW_CHANGES = 4,          // if a scenario changes inputs more often than this, further searches try to find a simpler one
    EFFORT_PREMISE = 2000000  // how many steps a search runs for the premise of a proved requirement
};

// The limits of an exploration: in the first round, in the second one, and later with few nodes, with more, and with all variables as keys.
typedef enum ProveSize { PROVE_BRIEF, PROVE_COARSE, PROVE_FEW, PROVE_LONG, PROVE_FINE } ProveSize;

static const ProveLimits limits_of[] = {{.nodes = 1500, .visits = 50000}, {.nodes = 1500, .visits = 300000}, {.nodes = 1500, .visits = 1500000},
                                       {.nodes = 4000, .visits = 1500000}, {.nodes = 4000, .visits = 1500000}};

// The attempts at a proof, from cheap to expensive.
static const struct { ProveLoosening loose; ProveSize size; } attempt[] = {
    {PROVE_LOOSE_ALL, PROVE_COARSE}, {PROVE_LOOSE_LONG, PROVE_COARSE}, {PROVE_LOOSE_UNLIKE, PROVE_COARSE}, {PROVE_EXACT, PROVE_COARSE},
    {PROVE_COMPARED, PROVE_COARSE}, {PROVE_RELATED, PROVE_COARSE},
    {PROVE_LOOSE_ALL, PROVE_FEW}, {PROVE_LOOSE_ALL, PROVE_LONG}, {PROVE_LOOSE_UNLIKE, PROVE_LONG},
    {PROVE_LOOSE_ALL, PROVE_FINE}, {PROVE_LOOSE_UNLIKE, PROVE_FINE}, {PROVE_EXACT, PROVE_FINE}, {PROVE_COMPARED, PROVE_FINE}};

enum { SETTINGS_MOST = 17 };  // how many settings of the parameters searches try: with 4 parameters, every combination of ends and the source's

enum { ATTEMPTS_FIRST = 6, ATTEMPTS = sizeof attempt / sizeof *attempt, SETS = 2 };

// What is kept of a requirement from round to round.
typedef struct ProveKept {
    bool is_decided;
    bool failed[SETS][ATTEMPTS];      // by set of assumptions: the exploration was complete, but no proof: a larger limit changes nothing
} ProveKept;

typedef struct ProveRun {
    Arena *arena;
    Arena work;               // memory of the current exploration or search
    Arena models;             // memory of the models of the current requirement
    const Requirements *all;
    const Program *p;
    const IrMachine *m;
    const ProveOptions *o;
    ProveResult *result;
    Cover *cover;
    Scenario *given;          // the given runs that are used: `givens` scenarios
    const ProveGiven **given_of;      // by index into `given`: the script run that it comes from
    const GivenResult **judged;       // by index into `given`, then by requirement: what the run shows
    uint32_t givens;
    const uint32_t *equal;    // by window of the requirements: as in ProveModel
    ProveKept *kept;          // by requirement
    const uint64_t **setting; // `settings` values of all parameters, by Var.index, for searches; the first one, NULL: those of the source
    uint32_t settings, now;   // now: the one that searches use
    bool stopped;             // go_on has returned false
} ProveRun;

static uint64_t effort_of(const ProveRun *v) { return v->o->effort ? v->o->effort : EFFORT; }

// Returns how many paths a long exploration can visit: fewer with less effort, but not fewer than a short one.
static uint64_t visits_of_long(const ProveRun *v)
{
    const uint64_t most = limits_of[PROVE_LONG].visits, least = limits_of[PROVE_COARSE].visits, share = effort_of(v) / STEPS_PER_VISIT;

    return share > most ? most : share < least ? least : share;
}

// Whether the caller wants to go on.  Once ProveOptions.go_on has returned false, the answer stays false.
static bool goes_on(void *run)
{
    ProveRun *v = run;

    v->stopped = v->stopped || (v->o->go_on && !v->o->go_on(v->o->context));
    return !v->stopped;
}

// ---- proofs ----

// Tries a proof.  Returns whether no run violates the requirement under the assumptions.
static bool try_proof(ProveRun *v, ProveModel *model, unsigned assumed, ProveSize size, ProveExplored *x, ProveOf *of)
{
    ProveLimits limits = limits_of[size];

    if (size >= PROVE_FEW)
        limits.visits = visits_of_long(v);
    if (v->o->visits && (size != PROVE_BRIEF || v->o->visits < limits.visits))
        limits.visits = v->o->visits;
    limits.memory = v->o->memory ? v->o->memory : SEARCH_MEMORY;
    limits.go_on = goes_on;
    limits.context = v;
    *x = prove_explore(&v->models, &v->work, model, v->result->init_state, assumed, size == PROVE_FINE, &limits);
    of->visits += x->visits;
    of->nodes = x->nodes;
    return x->closed && !x->violated;
}

// Removes the assumptions that the proof does not need, one after another.
static unsigned weaken_assumptions(ProveRun *v, ProveModel *model, unsigned assumed, ProveSize size, ProveExplored *x, ProveOf *of)
{
    for (int a = PROVE_ASSUMPTIONS - 1; a >= 0; a--) {
        ProveExplored without;
        const unsigned less = assumed & ~(1u << a);
        if (less == assumed || !goes_on(v) || !try_proof(v, model, less, size, &without, of) || without.premise != x->premise)
            continue;
        assumed = less;
        *x = without;
    }
    of->nodes = x->nodes;
    return assumed;
}

// Whether the fact says more than the type of the variable.
static bool is_narrower_than_type(Fact f, SmType type)
{
    const Fact t = fact_of_type(type);

    return f.lo > t.lo || f.hi < t.hi;
}

static const ProveInvariant *invariants_of(const ProveRun *v, const ProveModel *model, const ProveExplored *x)
{
    ProveInvariant *out = arena_array(v->arena, v->p->state.n, sizeof *out);

    for (uint32_t s = 0; s < v->p->state.n; s++) {
        out[s].state = v->p->state.at[s];
        out[s].reached = x->reached[s];
        for (uint32_t k = 0; x->reached[s] && k < v->p->var.n; k++) {
            const Var *var = v->p->var.at[k];
            const uint32_t at = v->m->var_of[k];
            const Fact f = at == IR_NONE ? fact_of_type(var->type) : x->after[(size_t)s * model->ir->var.n + at];
            const ProveBound bound = {var, f};
            if (at != IR_NONE && (var->written || var == v->p->t) && is_narrower_than_type(f, var->type))
                vec_push(v->arena, &out[s].bound, bound);
        }
    }
    return out;
}

// What the attempts at the proof of a requirement have in common.
typedef struct ProveProof {
    ProveModel *model[PROVE_LOOSENINGS];
    unsigned assumed[SETS];   // `sets` sets of assumptions, the one with fewer assumptions first
    uint32_t sets;
} ProveProof;

// Stores the inputs with numbers that can influence the requirement, and how many variables cannot.
static void note_inputs(const ProveRun *v, const ProveModel *model, ProveOf *of)
{
    for (uint32_t n = 0; n < v->m->var.n; n++)
        of->irrelevant += model->var[n].kind == PROVE_IRRELEVANT;
    for (uint32_t n = 0; n < v->p->var.n; n++) {
        const Var *var = v->p->var.at[n];
        if (v->m->var_of[n] == IR_NONE || var->type == SM_BOOL || model->var[v->m->var_of[n]].kind != PROVE_INPUT)
            continue;
        if (!var->range && of->unrangeds < PROVE_WIDES)
            of->unranged[of->unrangeds++] = var;
        else if (var->range && !v->o->assume_ranges && of->rangeds < PROVE_WIDES)
            of->ranged[of->rangeds++] = var;
    }
}

// Builds the models of a requirement, one for each way to make it less exact, and the assumptions under which they are explored.
static void begin_proof(ProveRun *v, ProveProof *p, const ProveOf *of)
{
    const unsigned ranges = v->o->assume_ranges ? 1u << PROVE_RANGES : 0, all = ranges | 1u << PROVE_OWN_OUTPUTS | 1u << PROVE_ZERO_START;

    *p = (ProveProof){.assumed = {all, all | 1u << PROVE_PARAMETERS}, .sets = program_has_parameters(v->p) && !v->o->any_parameters ? 2 : 1};
    for (int loose = 0; loose < PROVE_LOOSENINGS; loose++)
        p->model[loose] = prove_model_new(&v->models, v->m, v->all, of->what, v->result->delta_t, (ProveLoosening)loose, v->equal);
}

// Returns the variable or window of the program that a variable of the model stands for, to name it in the verdict.
static ProveWide wide_of(const ProveRun *v, const ProveModel *model, uint32_t var)
{
    ProveWide w = {.window = model->var[var].window};

    for (uint32_t k = 0; k < v->p->var.n; k++)
        if (v->m->var_of[k] == var)
            w.var = v->p->var.at[k];
    return w;
}

// Adds a variable or window to those with too many values, unless it is in the list.
static void add_wide_value(ProveOf *of, ProveWide w)
{
    for (uint32_t n = 0; n < of->wides; n++)
        if (of->wide[n].var == w.var && of->wide[n].window == w.window)
            return;
    of->wide[of->wides++] = w;
}

// Stores what kept an attempt from being a proof.
static void note_obstacle(const ProveRun *v, const ProveModel *model, const ProveExplored *x, ProveOf *of)
{
    of->obstacle = x->closed ? PROVE_FACTS_TOO_WEAK : PROVE_TOO_LARGE;
    of->wides = 0;
    for (uint32_t n = 0; n < x->wides; n++)
        add_wide_value(of, wide_of(v, model, x->wide[n]));
    for (uint32_t s = 0; x->closed && s < v->p->state.n; s++)
        of->excluded[s] |= !x->entered[s];
}

// Tries an attempt under the assumptions, and then under fewer.  Returns whether it is a proof.  *failed: no limit can make it one.
static bool try_attempt(ProveRun *v, ProveModel *model, unsigned assumed, ProveSize size, ProveOf *of, bool *failed)
{
    ProveExplored x;

    if (!try_proof(v, model, assumed, size, &x, of)) {
        *failed = x.closed;
        note_obstacle(v, model, &x, of);
        return false;
    }
    of->assumed = weaken_assumptions(v, model, assumed, size == PROVE_BRIEF ? PROVE_COARSE : size, &x, of);
    of->is_loose = model->loosened > 0;
    of->is_compared = model->compared > 0;
    of->is_related = model->pairs > 0;
    of->verdict = x.premise ? PROVE_PROVED : PROVE_VACUOUS;
    of->invariant = invariants_of(v, model, &x);
    return true;
}

// Whether a model is the same as one with which the attempt is made, too.
static bool is_repeated(const ProveProof *p, ProveLoosening loose)
{
    const uint32_t n = p->model[loose]->loosened;

    if (loose == PROVE_COMPARED)
        return p->model[loose]->compared == 0;
    if (loose == PROVE_RELATED)
        return p->model[loose]->pairs == 0;
    return loose != PROVE_EXACT && (n == 0 || (loose != PROVE_LOOSE_ALL && n == p->model[PROVE_LOOSE_ALL]->loosened));
}

// Whether an attempt with these keys was complete, but no proof.
static bool has_failed(const bool *failed, uint32_t n)
{
    for (uint32_t before = 0; before < n; before++)
        if (failed[before] && attempt[before].loose == attempt[n].loose && attempt[n].size < PROVE_FINE)
            return true;
    return failed[n];
}

// Makes the attempts from number `from` to `to` - 1 that have not failed.  Returns whether one is a proof.  If they are brief, more is assumed only
// once none can succeed without.
static bool try_proofs(ProveRun *v, const ProveProof *p, ProveOf *of, uint32_t from, uint32_t to, bool are_brief)
{
    ProveKept *kept = &v->kept[of - v->result->of];
    bool is_open = false;

    for (uint32_t set = 0; set < p->sets && !(is_open && are_brief); set++)
        for (uint32_t n = from; n < to; n++) {
            const ProveSize size = are_brief ? PROVE_BRIEF : attempt[n].size;
            if (has_failed(kept->failed[set], n) || is_repeated(p, attempt[n].loose))
                continue;
            if (!goes_on(v))
                return false;
            if (try_attempt(v, p->model[attempt[n].loose], p->assumed[set], size, of, &kept->failed[set][n]))
                return true;
            is_open = is_open || !kept->failed[set][n];
        }
    return false;
}

// ---- violations ----

static GoalSearch new_search(ProveRun *v, const ProveOf *of, GoalKind kind, uint64_t seed, uint64_t effort)
{
    return (GoalSearch){.all = v->all, .requirement = (size_t)(of->what - v->all->at.at), .kind = kind, .delta_t = v->result->delta_t, .seed = seed, .effort = effort ? effort : 1,
                        .init_state = v->result->init_state, .initial = v->setting[v->now], .assume_ranges = v->o->assume_ranges, .given = v->given, .givens = v->givens, .memory = v->o->memory, .go_on = goes_on, .context = v};
}

// Runs a search, and adds its steps and the states that it has visited to those of the requirement.
static GoalFound run_goal_search(ProveRun *v, ProveOf *of, const GoalSearch *g)
{
    GoalFound found = goal_search(v->arena, &v->work, v->cover, g);

    for (uint32_t s = 0; s < v->p->state.n; s++)
        of->tried[s] |= found.tried[s];
    of->steps += found.steps;
    v->result->steps += found.steps;
    if (found.unconfirmed)
        v->result->bug = "the reference interpreter does not confirm a run that the search has found";
    return found;
}

// Searches for a run that reaches the goal: a violation, or the premise.  Each setting of the parameters gets an equal part of the effort.  If a
// run is found, v->now is its setting.
static GoalFound search_goal(ProveRun *v, ProveOf *of, GoalKind kind, uint64_t seed, uint64_t effort)
{
    GoalFound found = {.scenario = NULL};
    bool premise_seen = false;

    for (v->now = 0; v->now < v->settings && !found.scenario && goes_on(v); v->now += !found.scenario) {
        const GoalSearch g = new_search(v, of, kind, seed, effort / v->settings);
        found = run_goal_search(v, of, &g);
        premise_seen = premise_seen || found.premise_seen;
    }
    v->now = found.scenario ? v->now : 0;
    found.premise_seen = premise_seen;
    return found;
}

static bool is_simpler(const Scenario *a, const Scenario *b) { return a->changes < b->changes || (a->changes == b->changes && a->steps < b->steps); }

// Searches a violation with fewer changes.  A run with special values changes many inputs at once, and simplifying does not find all that it does not
// need.
static const Scenario *search_simpler(ProveRun *v, ProveOf *of, const Scenario *found)
{
    static const uint32_t share[] = {FIRST_SHARE, 4};     // 1 / n of the effort

    for (uint32_t n = 0; n < sizeof share / sizeof *share && found->changes > FEW_CHANGES && goes_on(v); n++) {
        GoalSearch g = new_search(v, of, GOAL_VIOLATION, n + 1, effort_of(v) / share[n]);
        g.usual_values = true;
        g.givens = 0;
        const Scenario *other = run_goal_search(v, of, &g).scenario;
        if (other && is_simpler(other, found))
            found = other;
    }
    return found;
}

// Leaves out changes and waits that a long violation does not need.
static const Scenario *shorten_violation(ProveRun *v, ProveOf *of, const Scenario *s)
{
    const GoalSearch g = new_search(v, of, GOAL_VIOLATION, 1, effort_of(v) / FIRST_SHARE);
    uint64_t steps;

    if (s->changes <= FEW_CHANGES && s->steps <= FEW_STEPS)
        return s;
    s = near_shorten(v->arena, &v->work, v->m, &g, s, &steps);
    of->steps += steps;
    v->result->steps += steps;
    return s;
}

// Returns a simpler violation, or the same one.
static const Scenario *simplify_violation(ProveRun *v, ProveOf *of, const Scenario *found)
{
    const Scenario *short_one = shorten_violation(v, of, found), *other = search_simpler(v, of, short_one);

    return other == short_one ? other : shorten_violation(v, of, other);
}

// Searches for a violation with what is left of the effort.  Returns whether there is one.
static bool search_violation(ProveRun *v, ProveOf *of, uint64_t seed, uint64_t effort)
{
    const GoalFound found = search_goal(v, of, GOAL_VIOLATION, seed, effort);

    of->premise_seen = of->premise_seen || found.premise_seen || found.scenario;
    if (!found.scenario)
        return false;
    of->verdict = PROVE_VIOLATED;
    of->scenario = simplify_violation(v, of, found.scenario);
    v->now = 0;
    return true;
}

// Searches with the rest of the effort: short searches with other random numbers, then long ones.  Where a state has to last almost as long as it
// can, one search commits to early exits from it, and another one to late exits.
static const uint64_t most_steps[] = {1000000, 1000000, 1000000, 1000000, 4000000, 4000000, UINT64_MAX};

enum { SEARCHES_SHORT = 4, SEARCHES = sizeof most_steps / sizeof *most_steps };

// Makes the searches from number `from` to `to` - 1.  Returns whether one has found a violation.
static bool search_again(ProveRun *v, ProveOf *of, uint32_t from, uint32_t to)
{
    const uint64_t effort = effort_of(v);
    bool found = false;

    for (uint32_t n = from; n < to && !found && of->steps < effort && goes_on(v); n++)
        found = search_violation(v, of, n + 2, most_steps[n] < effort - of->steps ? most_steps[n] : effort - of->steps);
    return found;
}

// ---- parameters ----

// Adds a setting: the values of the source, but `which` parameters at an end of their range.  Both sets have a bit for each parameter, in the
// order of the source; highest: those that are at the upper end.
static void add_setting(ProveRun *v, uint64_t which, uint64_t highest)
{
    uint64_t *cell = arena_array(v->arena, v->p->var.n, sizeof *cell), bit = 1;
    bool is_other = false;

    for (uint32_t i = 0; i < v->p->var.n; i++) {
        const Var *var = v->p->var.at[i];
        cell[i] = var->init;
        if (!var->parameter)
            continue;
        if (which & bit)
            cell[i] = sm_cell_from_f64(var->type, highest & bit ? var->parameter->hi : var->parameter->lo);
        bit <<= 1;
        is_other = is_other || cell[i] != var->init;
    }
    if (is_other && v->settings < SETTINGS_MOST)
        v->setting[v->settings++] = cell;
}

// Lists the settings of the parameters with which searches run.  If parameters can have any value: all of them at the lowest, all at the highest,
// if they are few in every other combination of both ends, and each of them alone at both.
static void list_settings(ProveRun *v)
{
    enum { FEW = 4 };
    uint64_t parameters = 0;

    v->setting = ARENA_ARRAY(v->arena, const uint64_t *, SETTINGS_MOST);
    v->settings = 1;
    for (uint32_t i = 0; i < v->p->var.n; i++)
        parameters += v->p->var.at[i]->parameter != NULL;
    if (!v->o->any_parameters || parameters == 0)
        return;
    add_setting(v, UINT64_MAX, 0);
    add_setting(v, UINT64_MAX, UINT64_MAX);
    for (uint64_t highest = 1; parameters <= FEW && highest + 1 < UINT64_C(1) << parameters; highest++)
        add_setting(v, UINT64_MAX, highest);
    for (uint64_t i = 0; i < parameters && i < 64 && parameters > 1; i++) {
        add_setting(v, UINT64_C(1) << i, 0);
        add_setting(v, UINT64_C(1) << i, UINT64_MAX);
    }
}

// ---- given runs ----

// Runs the scripts that are given and judges all requirements in each.
static void judge_givens(ProveRun *v)
{
    const ProveOptions *o = v->o;

    v->given = arena_array(v->arena, o->givens + 1u, sizeof *v->given);
    v->given_of = arena_array(v->arena, o->givens + 1u, sizeof *v->given_of);
    v->judged = arena_array(v->arena, o->givens + 1u, sizeof *v->judged);
    for (uint32_t i = 0; i < o->givens && goes_on(v); i++) {
        if (!prove_uses_given(&o->given[i], v->result->init_state, v->result->delta_t))
            continue;
        v->given[v->givens] = o->given[i].run;
        v->given_of[v->givens] = &o->given[i];
        v->judged[v->givens++] = prove_judge_given(v->arena, v->all, &o->given[i].run);
        v->result->steps += o->given[i].run.steps;
    }
}

// Returns the number of the given run that violates the requirement after the fewest steps; `givens`: no given run violates it.  *confirmed receives the run
// up to there.
static uint32_t find_violating_given(ProveRun *v, const ProveOf *of, const Scenario **confirmed)
{
    const GoalSearch g = new_search(v, of, GOAL_VIOLATION, 1, 1);
    uint32_t best = v->givens;

    *confirmed = NULL;
    for (uint32_t i = 0; i < v->givens; i++) {
        const Scenario *s = v->judged[i][g.requirement].violated ? goal_end_scenario(v->arena, &g, &v->given[i]) : NULL;
        if (!s || (*confirmed && s->steps >= (*confirmed)->steps))
            continue;
        *confirmed = s;
        best = i;
    }
    return best;
}

// Stores a run that violates the requirement, or a simpler one.
static void keep_violation(ProveRun *v, ProveOf *of, const Scenario *s)
{
    GoalSearch g = new_search(v, of, GOAL_VIOLATION, 1, effort_of(v) / FIRST_SHARE);
    const Scenario *simpler;

    s = shorten_violation(v, of, s);
    g.given = s;
    g.givens = 1;
    simpler = run_goal_search(v, of, &g).scenario;
    of->verdict = PROVE_VIOLATED;
    of->premise_seen = true;
    of->scenario = simplify_violation(v, of, simpler && is_simpler(simpler, s) ? simpler : s);
}

// If a given run violates the requirement, records the violation with a simplified scenario, and returns true.
static bool record_violation_by_given(ProveRun *v, ProveOf *of)
{
    const size_t requirement = (size_t)(of->what - v->all->at.at);
    const Scenario *given;
    const uint32_t n = find_violating_given(v, of, &given);

    for (uint32_t i = 0; i < v->givens; i++) {
        of->premise_seen |= v->judged[i][requirement].premise_seen;
        of->steps += v->given[i].steps;
    }
    if (!given)
        return false;
    of->given = v->given_of[n];
    of->given_step = v->judged[n][requirement].violated;
    keep_violation(v, of, given);
    return true;
}

// Whether a given run violates the requirement with other values of few inputs.
static bool is_violated_near_given(ProveRun *v, ProveOf *of)
{
    const GoalSearch g = new_search(v, of, GOAL_VIOLATION, 1, effort_of(v) / NEAR_SHARE);
    ProveNear *near;
    NearFound found;

    if (v->givens == 0 || !goes_on(v))
        return false;
    found = near_search(v->arena, &v->work, v->m, &g);
    of->steps += found.steps;
    v->result->steps += found.steps;
    of->premise_seen |= found.premise_seen;
    if (!found.scenario)
        return false;
    of->near = near = ARENA_NEW(v->arena, ProveNear);
    *near = (ProveNear){.given = v->given_of[found.given], .vars = found.turns, .from = found.from, .to = found.to, .step = found.scenario->steps};
    for (uint32_t i = 0; i < found.turns; i++) {
        near->var[i] = found.turn[i].var;
        near->value[i] = found.turn[i].value;
    }
    keep_violation(v, of, found.scenario);
    return true;
}

// ---- rounds ----

// All requirements are tried in each round, so that none waits for another one that needs long.  Most are decided in the first ones.
typedef enum ProveRound {
    ROUND_BRIEF,              // the given runs, and proofs with a small limit
    ROUND_COARSE,             // the same proofs, runs close to the given ones, and a short search
    ROUND_FINE,               // proofs that need long
    ROUND_SEARCHES,           // short searches with other random numbers
    ROUND_REST,               // searches with the rest of the effort
    ROUNDS
} ProveRound;

// After a proof, searches for a run that comes to the premise.
static void search_premise(ProveRun *v, ProveOf *of)
{
    if (of->verdict == PROVE_PROVED && !of->premise_seen && goes_on(v))
        of->premise_seen = search_goal(v, of, GOAL_PREMISE, 1, EFFORT_PREMISE < effort_of(v) ? EFFORT_PREMISE : effort_of(v)).premise_seen;
    v->now = 0;
}

// Makes the attempts of a round at a proof.  Returns whether one has succeeded.
static bool prove_in_round(ProveRun *v, ProveOf *of, ProveRound round)
{
    const bool is_fine = round == ROUND_FINE;
    ProveProof proof;

    arena_reset(&v->models);
    begin_proof(v, &proof, of);
    if (round == ROUND_BRIEF)
        note_inputs(v, proof.model[PROVE_EXACT], of);
    if (!try_proofs(v, &proof, of, is_fine ? ATTEMPTS_FIRST : 0, is_fine ? ATTEMPTS : ATTEMPTS_FIRST, round == ROUND_BRIEF))
        return false;
    search_premise(v, of);
    return true;
}

// Makes the attempts of a round to decide a requirement.  Returns whether it is decided.
static bool decide_in_round(ProveRun *v, ProveOf *of, ProveRound round)
{
    switch (round) {
    case ROUND_BRIEF: return record_violation_by_given(v, of) || prove_in_round(v, of, round);
    case ROUND_COARSE:
        return prove_in_round(v, of, round) || is_violated_near_given(v, of) || search_violation(v, of, 1, effort_of(v) / FIRST_SHARE);
    case ROUND_FINE: return prove_in_round(v, of, round);
    case ROUND_SEARCHES: return search_again(v, of, 0, SEARCHES_SHORT);
    case ROUND_REST: return search_again(v, of, SEARCHES_SHORT, SEARCHES);
    case ROUNDS: break;
    }
    return false;
}

// The verdict "undecided" means that all attempts failed.  If the caller stops before all were made, the verdict is "interrupted".
static void run_round(ProveRun *v, ProveRound round, uint32_t *decided)
{
    ProveResult *r = v->result;

    for (uint32_t i = 0; i < r->n && goes_on(v); i++) {
        if (v->kept[i].is_decided)
            continue;
        if (v->o->progress)
            v->o->progress(v->o->context, *decided, i);
        v->kept[i].is_decided = decide_in_round(v, &r->of[i], round);
        if (!v->kept[i].is_decided && round == ROUNDS - 1 && goes_on(v)) {
            r->of[i].verdict = PROVE_UNDECIDED;
            v->kept[i].is_decided = true;
        }
        *decided += v->kept[i].is_decided;
        if (v->kept[i].is_decided && v->o->decided)
            v->o->decided(v->o->context, r, i);
    }
}

ProveResult *prove_run(Arena *arena, const Requirements *r, const ProveOptions *o)
{
    ProveResult *result = ARENA_NEW(arena, ProveResult);
    ProveRun v = {.arena = arena, .all = r, .p = r->program, .o = o, .result = result};
    uint32_t decided = 0;

    arena_init_within(&v.work, arena);
    arena_init_within(&v.models, arena);
    v.m = ir_build(arena, v.p);
    v.cover = cover_new(arena, v.p);
    v.equal = prove_find_equal_windows(arena, v.m, r);
    result->delta_t = v.p->step ? v.p->step : o->delta_t ? o->delta_t : o->givens ? o->given[0].run.delta_t : DELTA_T;
    result->init_state = o->init_state ? o->init_state : v.p->state.at[0];
    result->n = r->at.n;
    result->effort = effort_of(&v);
    result->can_prove_longer = visits_of_long(&v) < limits_of[PROVE_LONG].visits;
    result->given = o->given;
    result->givens = o->givens;
    list_settings(&v);
    judge_givens(&v);
    result->of = ARENA_ARRAY(arena, ProveOf, r->at.n + 1);
    v.kept = ARENA_ARRAY(arena, ProveKept, r->at.n + 1);
    for (uint32_t i = 0; i < r->at.n; i++) {
        result->of[i].what = &r->at.at[i];
        result->of[i].verdict = PROVE_INTERRUPTED;
        result->of[i].tried = ARENA_ARRAY(arena, bool, v.p->state.n);
        result->of[i].excluded = ARENA_ARRAY(arena, bool, v.p->state.n);
    }
    for (int round = 0; round < ROUNDS; round++)
        run_round(&v, (ProveRound)round, &decided);
    for (uint32_t i = 0; i < r->at.n && o->decided; i++)
        if (!v.kept[i].is_decided)
            o->decided(o->context, result, i);
    return result;
}
