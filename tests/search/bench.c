// SPDX-License-Identifier: Apache-2.0
// How far searches come: for each machine the goals that were reached with a tenth of the effort and with all of it, and how fast.
//
//     bench [--effort=STEPS] [--seed=N] [--list] MACHINE.sm…      and a line for all machines together at each effort
//     bench [--effort=STEPS] [--seed=N] --expect=FILE       runs the machines of a table, and fails if one comes less far (expected.txt)
//     bench [--effort=STEPS] --bounds MACHINE.sm…           compares the changes in scenarios with proofs that fewer do not reach their goals
//     bench [--seed=N] --random=STEPS MACHINE.sm…           makes random runs, and fails if one covers what the search calls impossible.  Half of
//                                                           them begin as a run of the search
//
//     bench [--effort=STEPS] [--seed=N] --speed MACHINE.sm…        uses all of the effort, and prints steps a second of processor time
//
// A machine MACHINE.sm uses the vector MACHINE.sv, or the only .sv of its folder, if there is one.
#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "compiler/search/search.h"
#include "compiler/session.h"
#include "tests/unit/host.h"

static uint64_t effort = SEARCH_EFFORT, seed = 1, random_steps;
static int lists;
static bool speed, bounds;
static unsigned passed, failed;

static const Source *read_source(Arena *a, const char *path)
{
    FILE *f = fopen(path, "rb");
    char *text = malloc(1 << 22);
    size_t n;
    const Source *s;

    if (!f)
        return free(text), NULL;
    n = fread(text, 1, (1 << 22) - 1, f);
    text[n] = 0;
    fclose(f);
    s = source_new(a, path, arena_copy(a, text, n + 1), n);
    free(text);
    return s;
}

static const Source *find_vector(Arena *a, const char *path)
{
    char dir[500], own[600], found[900] = "";
    const char *slash = strrchr(path, '/');
    struct dirent *e;
    DIR *d;

    snprintf(own, sizeof own, "%.*s.sv", (int)strlen(path) - 3, path);
    if (read_source(a, own))
        return read_source(a, own);
    snprintf(dir, sizeof dir, "%.*s", slash ? (int)(slash - path) : 1, slash ? path : ".");
    d = opendir(dir);
    while (d && (e = readdir(d)) != NULL)
        if (strlen(e->d_name) > 3 && strcmp(e->d_name + strlen(e->d_name) - 3, ".sv") == 0)
            snprintf(found, sizeof found, "%s/%s", dir, e->d_name);
    if (d)
        closedir(d);
    return found[0] ? read_source(a, found) : NULL;
}

typedef struct Count { unsigned goals, reached, impossible, missing; } Count;

static Count count_kinds(const Cover *c, const SearchResult *r, unsigned kinds)
{
    Count n = {0, 0, 0, 0};

    for (uint32_t i = 1; i < r->places; i++)
        if (kinds >> c->place.at[i].kind & 1) {
            n.goals += r->find[i].outcome != SEARCH_NO_GOAL;
            n.reached += r->find[i].outcome == SEARCH_REACHED;
            n.impossible += r->find[i].outcome == SEARCH_IMPOSSIBLE;
            n.missing += r->find[i].outcome == SEARCH_NOT_FOUND;
        }
    return n;
}

static void list_missing(const Cover *c, const SearchResult *r)
{
    for (uint32_t i = 1; i < r->places; i++)
        if (r->find[i].outcome == SEARCH_NOT_FOUND) {
            const CoverPlace *p = &c->place.at[i];
            printf("      %s %d line %u `%.*s` nearest %.4g blocked by %u\n", cover_kind_name[p->kind], p->value, source_position(p->span.src, p->span.at).line,
                   (int)p->span.len, p->span.src->text + p->span.at, r->find[i].nearest, r->find[i].blocked_by);
        }
}

static void list_scenarios(const Cover *c, const SearchResult *r)
{
    for (uint32_t i = 0; i < r->chosens; i++) {
        const Scenario *s = &r->chosen[i].scenario;
        printf("      %u goals, %lu steps:", r->chosen[i].goals, (unsigned long)s->steps);
        for (size_t n = 0; n < s->changes; n++)
            printf(" %lu:%s=%g%s", (unsigned long)s->change[n].step, c->p->var.at[s->change[n].var]->name->text, s->change[n].a,
                   s->change[n].kind == SCENARIO_HOLD ? "" : s->change[n].kind == SCENARIO_COPY ? "c" : s->change[n].kind == SCENARIO_RAMP ? "r" : "~");
        for (size_t n = 0; n < s->loops; n++)
            printf(" [%lu every %lu to %lu]", (unsigned long)s->loop[n].from, (unsigned long)s->loop[n].period, (unsigned long)s->loop[n].to);
        printf("\n");
    }
}

static int compare(const void *a, const void *b) { return *(const int *)a - *(const int *)b; }

// Opens a machine.  Returns NULL if it does not compile.
static Program *open_machine(Session *s, const char *path)
{
    MachineInput in = {NULL, NULL, NULL, NULL};
    Program *p;

    session_init(s, heap_alloc, NULL, &host_oom);
    in.sm = read_source(&s->arena, path);
    p = in.sm ? session_program(s, &in) : NULL;
    if (!p && in.sm) {
        in.sv = find_vector(&s->arena, path);
        p = in.sv ? session_program(s, &in) : NULL;
    }
    return p;
}

// What a search has found.
typedef struct Result {
    Cover *c;
    SearchResult *r;
    unsigned reached, impossible, missing;
    int *changes, *times;     // changes of inputs in each scenario, and times at which inputs change, each in ascending order
    int median, most, median_times, most_times;
    double seconds;
} Result;

enum { SCRIPTS_MOST = 20000, MANY_CHANGES = 10 };

// All machines together, with one effort.
typedef struct Total {
    unsigned machines, reached, impossible, missing, scripts;
    Count guards, conditions;
    int changes[SCRIPTS_MOST], times[SCRIPTS_MOST];
    double seconds, longest;
} Total;

static Total total[2];        // with a tenth of the effort, and with all of it

// Sorts n numbers and returns the middle one; 0 if n is 0.
static int sort(int *at, unsigned n)
{
    qsort(at, n, sizeof *at, compare);
    return n ? at[n / 2] : 0;
}

static unsigned count_many(const int *at, unsigned n)
{
    unsigned many = 0;

    for (unsigned i = 0; i < n; i++)
        many += at[i] > MANY_CHANGES;
    return many;
}

static Result search_machine(Session *s, const Program *p, uint64_t steps)
{
    const SearchOptions o = {.seed = seed, .effort = steps, .loops = true};
    Result x = {.c = cover_new(&s->arena, p)};
    const clock_t begin = clock();
    Count all;

    cover_settle(x.c);
    x.r = search_run(&s->arena, x.c, &o);
    x.seconds = (double)(clock() - begin) / CLOCKS_PER_SEC;
    all = count_kinds(x.c, x.r, SEARCH_KINDS);
    x.reached = all.reached;
    x.impossible = all.impossible;
    x.missing = all.missing;
    x.changes = calloc(x.r->chosens + 1, sizeof *x.changes);
    x.times = calloc(x.r->chosens + 1, sizeof *x.times);
    for (uint32_t i = 0; i < x.r->chosens; i++) {
        x.changes[i] = (int)x.r->chosen[i].scenario.changes;
        x.times[i] = (int)scenario_times(&x.r->chosen[i].scenario);
    }
    x.median = sort(x.changes, x.r->chosens);
    x.median_times = sort(x.times, x.r->chosens);
    x.most = x.r->chosens ? x.changes[x.r->chosens - 1] : 0;
    x.most_times = x.r->chosens ? x.times[x.r->chosens - 1] : 0;
    return x;
}

static void add_count(Count *to, Count n)
{
    to->goals += n.goals;
    to->reached += n.reached;
    to->impossible += n.impossible;
    to->missing += n.missing;
}

static void add_result(Total *t, const Result *x)
{
    t->machines++;
    t->reached += x->reached;
    t->impossible += x->impossible;
    t->missing += x->missing;
    add_count(&t->guards, count_kinds(x->c, x->r, 1u << COVER_TRANSITION | 1u << COVER_GUARD));
    add_count(&t->conditions, count_kinds(x->c, x->r, 1u << COVER_CONDITION));
    for (uint32_t i = 0; i < x->r->chosens && t->scripts < SCRIPTS_MOST; i++) {
        t->changes[t->scripts] = x->changes[i];
        t->times[t->scripts++] = x->times[i];
    }
    t->seconds += x->seconds;
    t->longest = x->seconds > t->longest ? x->seconds : t->longest;
}

static double percent_of(Count n) { return n.goals > n.impossible ? 100.0 * n.reached / (n.goals - n.impossible) : 100; }

// Prints the middle and the largest of n sorted numbers, and how many are above MANY_CHANGES.
static void print_spread(const char *what, const int *at, unsigned n)
{
    printf(" %s median %d max %d, %u with more than %d;", what, n ? at[n / 2] : 0, n ? at[n - 1] : 0, count_many(at, n), MANY_CHANGES);
}

static void print_total(Total *t, int percent)
{
    if (t->machines == 0)
        return;
    sort(t->changes, t->scripts);
    sort(t->times, t->scripts);
    printf("%u machines at %d%%: goals %u reached, %u impossible, %u not found; transitions and guards %u of %u (%.2f %%); MC/DC %u of %u (%.2f %%); %u scripts;",
           t->machines, percent, t->reached, t->impossible, t->missing, t->guards.reached, t->guards.goals - t->guards.impossible, percent_of(t->guards),
           t->conditions.reached, t->conditions.goals - t->conditions.impossible, percent_of(t->conditions), t->scripts);
    print_spread("changes", t->changes, t->scripts);
    print_spread("times", t->times, t->scripts);
    printf(" %.1f s, at most %.1f\n", t->seconds, t->longest);
}

static void print_result(const char *path, const Result *x, int percent)
{
    const Count guards = count_kinds(x->c, x->r, 1u << COVER_TRANSITION | 1u << COVER_GUARD), conditions = count_kinds(x->c, x->r, 1u << COVER_CONDITION);

    printf("%-30.30s %4d%% guards %4u = %4u + %3u i + %3u  mcdc %4u = %4u + %3u i + %3u  all left %3u  %3u scripts, changes %d max %d, times %d max %d  %6.1f M steps %5.1f M/s %6.2f s\n",
           path + (strlen(path) > 30 ? strlen(path) - 30 : 0), percent, guards.goals, guards.reached, guards.impossible, guards.missing, conditions.goals,
           conditions.reached, conditions.impossible, conditions.missing, x->missing, x->r->chosens, x->median, x->most, x->median_times, x->most_times, (double)x->r->steps / 1e6,
           (double)x->r->steps / 1e6 / (x->seconds > 0 ? x->seconds : 1), x->seconds);
}

static void free_result(const Result *x)
{
    free(x->changes);
    free(x->times);
}

static void run(const char *path)
{
    Session s;
    Program *p;

    host_check(setjmp(host_oom));
    p = open_machine(&s, path);
    if (!p) {
        printf("%-30.30s does not compile\n", path);
        return;
    }
    for (int part = 10; part >= 1; part -= 9) {
        const Result x = search_machine(&s, p, effort / (uint64_t)part);
        print_result(path, &x, 100 / part);
        failed += x.r->refuted > 0;
        add_result(&total[part == 1], &x);
        free_result(&x);
        if (lists && part == 1)
            list_missing(x.c, x.r);
        if (lists > 1 && part == 1)
            list_scenarios(x.c, x.r);
        fflush(stdout);
    }
    session_free(&s);
}

// ---- bounds ----

// A goal is impossible if only some of the inputs change, and the others have their initial values: then a scenario that reaches it changes others.
typedef struct Bounds {
    Session s;
    const Program *p;
    Cover *c;
    bool *writable;           // by Var.index
    uint32_t input[400], inputs;
    unsigned *least;          // by place: the fewest inputs that a scenario must change to reach it, as far as it is proved
    bool *one, *two;          // by place: no input alone reaches it, no two of them do
} Bounds;

// The number of scripts with more than two changes, of those that are proved to need more than two, and of those that are proved to need all.
typedef struct BoundCount { unsigned scripts, many, proved, tight, wrong; } BoundCount;

static BoundCount bound_total;

static const SearchResult *prove_goals(Bounds *b)
{
    return search_run(&b->s.arena, b->c, &(SearchOptions){.seed = 1, .effort = 1000, .writable = b->writable, .drafts = true, .memory = 1 << 22});
}

static void list_inputs(Bounds *b)
{
    search_default_inputs(b->p, b->writable);
    for (uint32_t v = 0; v < b->p->var.n && b->inputs < 400; v++) {
        const Var *var = b->p->var.at[v];
        if (b->writable[v] && b->c->m->var_of[v] != IR_NONE && var != b->p->g && var != b->p->s && var != b->p->t)
            b->input[b->inputs++] = v;
    }
}

// Adds 1 to the bound of each goal that is impossible while this input has its initial value.
static void bound_without(Bounds *b, uint32_t input)
{
    const SearchResult *r;

    b->writable[input] = false;
    r = prove_goals(b);
    b->writable[input] = true;
    for (uint32_t g = 1; g < b->c->place.n; g++)
        b->least[g] += r->find[g].outcome == SEARCH_IMPOSSIBLE;
}

// Notes the goals that are possible if only these two inputs change, which can be the same.
static void bound_with(Bounds *b, uint32_t x, uint32_t y)
{
    const SearchResult *r;

    memset(b->writable, 0, b->p->var.n * sizeof *b->writable);
    b->writable[x] = b->writable[y] = true;
    r = prove_goals(b);
    for (uint32_t g = 1; g < b->c->place.n; g++)
        if (r->find[g].outcome != SEARCH_IMPOSSIBLE) {
            b->two[g] = false;
            b->one[g] &= x != y;
        }
}

static void find_bounds(Bounds *b)
{
    const uint32_t places = b->c->place.n;

    b->writable = calloc(b->p->var.n + 1, sizeof *b->writable);
    b->least = calloc(places, sizeof *b->least);
    b->one = malloc(places);
    b->two = malloc(places);
    memset(b->one, true, places);
    memset(b->two, true, places);
    list_inputs(b);
    for (uint32_t x = 0; x < b->inputs; x++)
        bound_without(b, b->input[x]);
    for (uint32_t x = 0; x < b->inputs; x++)
        for (uint32_t y = x; y < b->inputs; y++)
            bound_with(b, b->input[x], b->input[y]);
    for (uint32_t g = 1; g < places; g++) {
        const unsigned by_number = b->two[g] ? 3 : b->one[g] ? 2 : 0;
        b->least[g] = b->least[g] > by_number ? b->least[g] : by_number;
    }
}

static unsigned count_inputs(const Scenario *s)
{
    unsigned n = 0;

    for (size_t i = 0; i < s->changes; i++) {
        bool is_new = true;
        for (size_t j = 0; j < i; j++)
            is_new &= s->change[j].var != s->change[i].var;
        n += is_new;
    }
    return n;
}

// Compares the scenarios of a search with the bounds of their goals: one that changes fewer inputs than are proved necessary refutes the proof.
static void compare_with_bounds(const char *path, const Bounds *b, const SearchResult *r)
{
    BoundCount n = {.scripts = r->chosens};

    for (uint32_t i = 0; i < r->chosens; i++) {
        const SearchScenario *x = &r->chosen[i];
        unsigned least = 0;
        for (uint32_t g = 0; g < x->goals; g++)
            least = b->least[x->goal[g]] > least ? b->least[x->goal[g]] : least;
        n.many += x->scenario.changes > 2;
        n.proved += least > 2;
        n.tight += x->scenario.changes <= least;
        n.wrong += count_inputs(&x->scenario) < least;
    }
    printf("%-40s %4u scripts, %4u with more than 2 changes, %4u proved to need more than 2, %4u to need all, %u wrong\n", path, n.scripts, n.many, n.proved,
           n.tight, n.wrong);
    fflush(stdout);
    bound_total.scripts += n.scripts;
    bound_total.many += n.many;
    bound_total.proved += n.proved;
    bound_total.tight += n.tight;
    failed += n.wrong > 0;
}

static void run_bounds(const char *path)
{
    Bounds b = {.inputs = 0};

    host_check(setjmp(host_oom));
    b.p = open_machine(&b.s, path);
    b.c = cover_new(&b.s.arena, b.p);
    cover_settle(b.c);
    find_bounds(&b);
    compare_with_bounds(path, &b, search_run(&b.s.arena, b.c, &(SearchOptions){.seed = seed, .effort = effort, .loops = true}));
    free(b.writable);
    free(b.least);
    free(b.one);
    free(b.two);
    session_free(&b.s);
}

static void print_bounds(void)
{
    if (bound_total.scripts)
        printf("all machines: %u scripts, %u with more than 2 changes, %u proved to need more than 2, %u to need all\n", bound_total.scripts, bound_total.many,
               bound_total.proved, bound_total.tight);
}

// ---- random runs ----

enum { CONSTANTS_MOST = 400, LONGEST_RUN = 20, LONGEST_HOLD = 15 };       // the latter as powers of 2, in steps

typedef struct RandomRuns {
    const Cover *c;
    uint64_t state;           // of the random numbers
    double constant[CONSTANTS_MOST];
    uint32_t constants;
    bool *is_input;           // by Var.index
    uint64_t *due;            // by Var.index: the step of the next change
    unsigned hold;            // changes are up to 2^hold steps apart in this run
    void *run;                // the state of the machine
} RandomRuns;

static uint64_t any(RandomRuns *r, uint64_t below)
{
    uint64_t z = r->state += UINT64_C(0x9e3779b97f4a7c15);

    z = (z ^ z >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ z >> 27) * UINT64_C(0x94d049bb133111eb);
    return (z ^ z >> 31) % below;
}

static void add_constants(RandomRuns *r, const IrFn *f)
{
    for (uint32_t i = 0; f && i < f->ins.n; i++)
        if (f->ins.at[i].op == IR_const && f->ins.at[i].type == SM_F64 && r->constants < CONSTANTS_MOST)
            r->constant[r->constants++] = sm_cell_to_f64(SM_F64, f->ins.at[i].bits);
}

// A value that the machine compares with or one beside it, one in the range of the input or an end of it, or any small number.
static double any_value(RandomRuns *r, const Var *v)
{
    static const double beside[] = {0, 0, 1, -1, 0.1, -0.1};
    const Range *range = v->range;

    if (v->type == SM_BOOL)
        return (double)any(r, 2);
    if (range && any(r, 100) < 40)
        return any(r, 4) == 0 ? any(r, 2) ? range->hi : range->lo : range->lo + (range->hi - range->lo) * (double)any(r, 1001) / 1000;
    if (r->constants && any(r, 100) < 85)
        return r->constant[any(r, r->constants)] + beside[any(r, 6)];
    return any(r, 4) == 0 ? (double)any(r, 2000001) - 1000000 : (double)any(r, 201) - 100;
}

static void change_inputs(RandomRuns *r, uint64_t *cell, uint64_t step)
{
    for (uint32_t i = 0; i < r->c->p->var.n; i++) {
        const Var *v = r->c->p->var.at[i];
        if (!r->is_input[i] || r->c->m->var_of[i] == IR_NONE || r->due[i] > step)
            continue;
        cell[r->c->m->var_of[i]] = scenario_cell(r->c->p, &(ScenarioChange){.var = i, .kind = SCENARIO_HOLD, .a = any_value(r, v)}, step + 1, NULL);
        r->due[i] = step + 1 + any(r, UINT64_C(1) << any(r, r->hold + 1));
    }
}

// Sets what a scenario sets in step `step`.  now: by Var.index, the change that determines the value; next: the first change that has not begun.
static void follow_scenario(RandomRuns *r, const Scenario *s, uint64_t step, const ScenarioChange **now, size_t *next, uint64_t *value)
{
    const Program *p = r->c->p;
    uint64_t *cell = flat_cells(r->c->flat, r->run);

    for (; *next < s->changes && s->change[*next].step <= step; ++*next)
        now[s->change[*next].var] = &s->change[*next];
    for (uint32_t i = 0; i < p->var.n; i++)
        value[i] = r->c->m->var_of[i] == IR_NONE ? p->var.at[i]->init : cell[r->c->m->var_of[i]];
    for (uint32_t i = 0; i < p->var.n; i++)
        if (now[i] && r->c->m->var_of[i] != IR_NONE)
            cell[r->c->m->var_of[i]] = scenario_cell(p, now[i], step, value);
}

// Begins a run as a scenario of the search does, up to any of its steps.  Returns the number of steps, at most `most`.  So random runs also go
// on from the states that they would never reach.
static uint64_t begin_as_scenario(RandomRuns *r, const Scenario *s, uint64_t most)
{
    const uint64_t steps = 1 + any(r, s->steps < most ? s->steps : most);
    const ScenarioChange **now = calloc(r->c->p->var.n, sizeof *now);
    uint64_t *value = calloc(r->c->p->var.n, sizeof *value);
    FlatMachine *f = r->c->flat;
    size_t next = 0;

    flat_start(f, r->run, s->init_state->number);
    for (uint64_t i = 0; i < steps; i++) {
        follow_scenario(r, s, i + 1, now, &next, value);
        flat_cells(f, r->run)[r->c->m->g] = i * s->delta_t;
        flat_step(f, r->run);
    }
    free(now);
    free(value);
    return steps;
}

// Every second run begins as a scenario of `found`.
static void make_random_runs(RandomRuns *r, const SearchResult *found)
{
    FlatMachine *f = r->c->flat;
    uint64_t left = random_steps;
    Arena *arena = r->c->arena;
    Scenario *plain = ARENA_ARRAY(arena, Scenario, found->chosens + 1);

    r->run = calloc(1, f->size);
    for (uint32_t i = 0; i < found->chosens; i++)
        plain[i] = scenario_unroll(arena, &found->chosen[i].scenario);
    while (left > 0) {
        uint64_t steps = UINT64_C(1) << (4 + any(r, LONGEST_RUN - 3)), begun = 0;
        r->hold = (unsigned)any(r, LONGEST_HOLD + 1);
        memset(r->due, 0, r->c->p->var.n * sizeof *r->due);
        if (found->chosens && any(r, 2))
            begun = begin_as_scenario(r, &plain[any(r, found->chosens)], left);
        else
            flat_start(f, r->run, 1);
        left -= begun;
        steps = steps < left ? steps : left;
        left -= steps;
        for (uint64_t i = begun; i < begun + steps; i++) {
            uint64_t *cell = flat_cells(f, r->run);
            change_inputs(r, cell, i);
            cell[r->c->m->g] = i * found->delta_t;
            flat_step(f, r->run);
        }
    }
    free(r->run);
}

static void compare_counts(const char *path, Cover *run, const SearchResult *found)
{
    unsigned impossible = 0, covered = 0, wrong = 0;

    cover_settle(run);
    for (uint32_t i = 1; i < run->place.n; i++) {
        impossible += found->find[i].outcome == SEARCH_IMPOSSIBLE;
        covered += run->hits[i] > 0;
        wrong += found->find[i].outcome == SEARCH_IMPOSSIBLE && run->hits[i] > 0;
    }
    printf("%s: %lu random steps, seed %lu: %u of %u places covered, %u impossible, of which %u are covered\n", path, (unsigned long)random_steps, (unsigned long)seed,
           covered, (unsigned)run->place.n - 1, impossible, wrong);
    fflush(stdout);
    failed += wrong > 0 || covered == 0;
}

static bool has_impossible(const SearchResult *r)
{
    for (uint32_t i = 1; i < r->places; i++)
        if (r->find[i].outcome == SEARCH_IMPOSSIBLE)
            return true;
    return false;
}

// Makes random runs of a machine.  Each place that the search has proved impossible has to be without a count.
static void run_randomly(const char *path)
{
    Session s;
    Program *p;
    Cover *judged;
    SearchResult *found;
    Cover *run;
    RandomRuns r = {.state = seed};

    host_check(setjmp(host_oom));
    p = open_machine(&s, path);
    if (!p) {
        printf("%s does not compile\n", path);
        failed++;
        return;
    }
    judged = cover_new(&s.arena, p);
    cover_settle(judged);
    found = search_run(&s.arena, judged, &(SearchOptions){.seed = 1, .effort = effort / 10, .loops = true});
    if (!has_impossible(found)) {
        printf("%s: no goal is impossible\n", path);
        session_free(&s);
        return;
    }
    r.c = run = cover_new(&s.arena, p);
    r.is_input = calloc(p->var.n, sizeof *r.is_input);
    r.due = calloc(p->var.n, sizeof *r.due);
    search_default_inputs(p, r.is_input);
    add_constants(&r, r.c->m->sample);
    for (uint32_t i = 0; i < r.c->m->state.n; i++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            add_constants(&r, r.c->m->state.at[i].block[b]);
    make_random_runs(&r, found);
    compare_counts(path, run, found);
    free(r.is_input);
    free(r.due);
    session_free(&s);
}

// ---- speed ----

static void start_never(void *self, void *situation) { (void)self, (void)situation; }

// A goal that no run comes near to, so that the search ends with its effort.
static void never(void *self, void *situation, const uint64_t *cell, double *distance)
{
    (void)self, (void)situation, (void)cell;
    *distance = SEARCH_UNKNOWN;
}

static void measure_speed(const char *path)
{
    const SearchWatch watch = {.goals = 1, .size = 1, .start = start_never, .step = never};
    const SearchOptions o = {.seed = seed, .effort = effort, .loops = true, .watch = &watch};
    Session s;
    Program *p;
    Cover *c;
    SearchResult *r;
    clock_t begin;
    double seconds;

    host_check(setjmp(host_oom));
    p = open_machine(&s, path);
    c = cover_new(&s.arena, p);
    cover_settle(c);
    begin = clock();
    r = search_run(&s.arena, c, &o);
    seconds = (double)(clock() - begin) / CLOCKS_PER_SEC;
    printf("%s: %lu steps, %.1f million a second\n", path, (unsigned long)r->steps, (double)r->steps / 1e6 / (seconds > 0 ? seconds : 1));
    session_free(&s);
}

// ---- the table ----

typedef struct Expected { char path[300]; unsigned reached, impossible, missing; int median, most, median_times, most_times; } Expected;

static bool is_as_expected(const Result *x, const Expected *e)
{
    return x->reached >= e->reached && x->impossible >= e->impossible && x->missing <= e->missing && x->median <= e->median && x->most <= e->most
           && x->median_times <= e->median_times && x->most_times <= e->most_times && x->r->steps <= effort;
}

static void check(const Expected *e)
{
    Session s;
    Program *p;
    Result x;

    host_check(setjmp(host_oom));
    p = open_machine(&s, e->path);
    if (!p) {
        printf("search: %s does not compile\n", e->path);
        failed++;
        return;
    }
    x = search_machine(&s, p, effort);
    free_result(&x);
    if (lists)
        printf("%-40s %4u %3u %3u %3d %3d %3d %3d\n", e->path, x.reached, x.impossible, x.missing, x.median, x.most, x.median_times, x.most_times);
    fflush(stdout);
    if (x.r->refuted) {
        failed++;
        printf("search: %s: %u goals that are proved impossible are reached\n", e->path, (unsigned)x.r->refuted);
    }
    if (is_as_expected(&x, e)) {
        passed++;
    } else {
        failed++;
        printf("search: %s: %u reached, %u impossible, %u not found, changes %d, at most %d, times %d, at most %d, %lu steps; the table has %u, %u, %u, %d, %d, %d, %d\n",
               e->path, x.reached, x.impossible, x.missing, x.median, x.most, x.median_times, x.most_times, (unsigned long)x.r->steps, e->reached, e->impossible,
               e->missing, e->median, e->most, e->median_times, e->most_times);
    }
    session_free(&s);
}

static int check_table(const char *path)
{
    FILE *f = fopen(path, "r");
    char line[400];
    Expected e;

    while (f && fgets(line, sizeof line, f))
        if (line[0] != '#' && line[0] != '\n') {
            if (sscanf(line, "%299s %u %u %u %d %d %d %d", e.path, &e.reached, &e.impossible, &e.missing, &e.median, &e.most, &e.median_times, &e.most_times) == 8) {
                check(&e);
            } else {
                printf("search: %s: a line that is no row: %s", path, line);
                failed++;
            }
        }
    if (f)
        fclose(f);
    printf("search: %u passed, %u failed\n", passed, failed);
    return failed != 0 || passed == 0;
}

int main(int argc, char **argv)
{
    for (int i = 1; i < argc; i++)
        if (strncmp(argv[i], "--effort=", 9) == 0)
            effort = strtoull(argv[i] + 9, NULL, 10);
        else if (strncmp(argv[i], "--seed=", 7) == 0)
            seed = strtoull(argv[i] + 7, NULL, 10);
        else if (strncmp(argv[i], "--expect=", 9) == 0)
            return check_table(argv[i] + 9);
        else if (strncmp(argv[i], "--random=", 9) == 0)
            random_steps = strtoull(argv[i] + 9, NULL, 10);
        else if (strcmp(argv[i], "--list") == 0)
            lists++;
        else if (strcmp(argv[i], "--speed") == 0)
            speed = true;
        else if (strcmp(argv[i], "--bounds") == 0)
            bounds = true;
        else
            (speed ? measure_speed : random_steps ? run_randomly : bounds ? run_bounds : run)(argv[i]);
    print_bounds();
    print_total(&total[0], 10);
    print_total(&total[1], 100);
    return failed != 0;
}
