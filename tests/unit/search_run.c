// SPDX-License-Identifier: Apache-2.0
// Searches on machines whose answers are known (tests/search/machines).  Every scenario is replayed on the reference interpreter and on a flat
// machine, which agree in every step, and reaches the goals that are stored for it.
#include <stdlib.h>
#include <string.h>

#include "compiler/search/search.h"
#include "compiler/session.h"
#include "stdlib/convert.h"
#include "tests/test.h"
#include "tests/unit/host.h"

enum { TEXT = 20000, EFFORT = 20000000 };

static char text[TEXT];

static Program *load(Session *s, const char *name)
{
    char path[200];
    FILE *f;
    size_t n;
    MachineInput in = {NULL, NULL, NULL, NULL};

    session_init(s, heap_alloc, NULL, &host_oom);
    snprintf(path, sizeof path, "tests/search/machines/%s.sm", name);
    f = fopen(path, "rb");
    n = f ? fread(text, 1, TEXT - 1, f) : 0;
    if (f)
        fclose(f);
    text[n] = '\0';
    in.sm = source_new(&s->arena, name, text, n);
    return n ? session_program(s, &in) : NULL;
}

static Cover *make_cover(Session *s, const Program *p)
{
    Cover *c = cover_new(&s->arena, p);

    cover_settle(c);
    return c;
}

// ---- replays ----

typedef struct Trace { const Program *p; uint64_t hash, steps; } Trace;

static void hash_step(void *context, uint64_t step, const EngineStep *r)
{
    Trace *t = context;

    t->steps = step;
    for (uint32_t v = 0; v < t->p->var.n; v++)
        t->hash = (t->hash ^ r->cell[v]) * UINT64_C(0x100000001b3);
    t->hash = (t->hash ^ r->next_state) * UINT64_C(0x100000001b3);
}

// Whether the changes are in order, and no variable changes twice in a step.
static bool is_well_formed(const Scenario *s)
{
    for (size_t i = 0; i < s->changes; i++) {
        if (s->change[i].step == 0 || s->change[i].step > s->steps || (i && s->change[i].step < s->change[i - 1].step))
            return false;
        for (size_t n = 0; n < i; n++)
            if (s->change[i].step == s->change[n].step && s->change[i].var == s->change[n].var)
                return false;
    }
    return true;
}

static void check_scenarios(Session *s, const Program *p, const SearchResult *r)
{
    for (uint32_t i = 0; i < r->chosens; i++) {
        const SearchScenario *x = &r->chosen[i];
        Cover *c = make_cover(s, p);
        Engine *ref = engine_ref_open(&s->arena, p);
        Trace a = {p, 1, 0}, b = {p, 1, 0};
        CHECK(is_well_formed(&x->scenario));
        CHECK(scenario_run(&s->arena, p, &x->scenario, ref, hash_step, &a) == ENGINE_OK);
        CHECK(scenario_run(&s->arena, p, &x->scenario, cover_open_engine(c), hash_step, &b) == ENGINE_OK);
        CHECK(a.hash == b.hash && a.steps == x->scenario.steps && b.steps == a.steps);
        cover_settle(c);
        for (uint32_t g = 0; g < x->goals; g++)
            CHECK(x->goal[g] >= r->places || c->hits[x->goal[g]] > 0);
        for (uint32_t g = 1; g < r->places; g++)
            CHECK(c->hits[g] == 0 || r->find[g].outcome != SEARCH_IMPOSSIBLE);
        CHECK(x->goals > 0);
    }
    for (uint32_t g = 1; g < r->finds; g++)
        CHECK(r->find[g].outcome != SEARCH_REACHED || r->find[g].scenario < r->chosens);
}

// ---- machines ----

static unsigned count(const SearchResult *r, SearchOutcome outcome)
{
    unsigned n = 0;

    for (uint32_t i = 1; i < r->finds; i++)
        n += r->find[i].outcome == outcome;
    return n;
}

static void check_machine_of(const char *name, unsigned impossible)
{
    Session s;
    Program *p;
    Cover *c;
    SearchResult *r;
    const SearchOptions o = {.seed = 1, .effort = EFFORT};

    host_check(setjmp(host_oom));
    p = load(&s, name);
    CHECK(p != NULL);
    if (!p)
        return;
    c = make_cover(&s, p);
    r = search_run(&s.arena, c, &o);
    test_count(count(r, SEARCH_NOT_FOUND) == 0, name);
    test_count(count(r, SEARCH_IMPOSSIBLE) == impossible, name);
    test_count(count(r, SEARCH_REACHED) > 10 && count(r, SEARCH_REACHED) + impossible == c->place.n - 1, name);
    test_count(r->refuted == 0, name);
    test_count(r->steps <= EFFORT, name);
    check_scenarios(&s, p, r);
    session_free(&s);
}

// ---- options ----

static bool same_scenario(const Scenario *a, const Scenario *b)
{
    bool same = a->steps == b->steps && a->changes == b->changes && a->delta_t == b->delta_t;

    for (size_t i = 0; same && i < a->changes; i++) {
        const ScenarioChange *x = &a->change[i], *y = &b->change[i];
        same = x->step == y->step && x->var == y->var && x->kind == y->kind && x->a == y->a && x->b == y->b && x->source == y->source;
    }
    return same;
}

static bool same_result(const SearchResult *a, const SearchResult *b)
{
    bool same = a->steps == b->steps && a->chosens == b->chosens && a->finds == b->finds;

    for (uint32_t i = 0; same && i < a->finds; i++)
        same = a->find[i].outcome == b->find[i].outcome && a->find[i].scenario == b->find[i].scenario && a->find[i].nearest == b->find[i].nearest;
    for (uint32_t i = 0; same && i < a->chosens; i++)
        same = same_scenario(&a->chosen[i].scenario, &b->chosen[i].scenario) && a->chosen[i].goals == b->chosen[i].goals;
    return same;
}

// The same seed has the same result, whatever the limit of memory, if it is large enough.
static void check_determinism(void)
{
    static const size_t memory[3] = {0, 0, (size_t)100 << 20};
    SearchResult *r[3];
    Session s;
    Program *p;

    host_check(setjmp(host_oom));
    p = load(&s, "lock");
    for (int i = 0; i < 3; i++)
        r[i] = search_run(&s.arena, make_cover(&s, p), &(SearchOptions){.seed = 7, .effort = 300000, .memory = memory[i]});
    CHECK(same_result(r[0], r[1]));
    CHECK(same_result(r[0], r[2]));
    session_free(&s);
}

static bool stop_soon(void *context, const SearchProgress *p)
{
    int *calls = context;

    CHECK(p->reached + p->left == p->goals);
    return ++*calls < 3;
}

// A caller that stops a search has what was found until then.
static void check_stop(void)
{
    int calls = 0;
    SearchResult *r;
    Session s;
    Program *p;

    host_check(setjmp(host_oom));
    p = load(&s, "handshake");
    r = search_run(&s.arena, make_cover(&s, p), &(SearchOptions){.go_on = stop_soon, .context = &calls});
    CHECK(r->stopped && calls == 3);
    CHECK(count(r, SEARCH_REACHED) > 0 && r->chosens > 0);
    check_scenarios(&s, p, r);
    session_free(&s);
}

// Returns how many goals a search with so little effort has reached.
static unsigned check_effort_of(const char *name, uint64_t effort)
{
    SearchResult *r;
    Session s;
    Program *p;
    unsigned reached;

    host_check(setjmp(host_oom));
    p = load(&s, name);
    r = search_run(&s.arena, make_cover(&s, p), &(SearchOptions){.seed = 3, .effort = effort});
    test_count(r->steps <= effort, name);
    check_scenarios(&s, p, r);
    reached = count(r, SEARCH_REACHED);
    session_free(&s);
    return reached;
}

// The effort is never exceeded, and what it allows to find has been replayed.
static void check_effort(void)
{
    static const uint64_t effort[] = {1, 2, 10, 100, 1000, 10000, 100000, 1000000};
    static const char *const name[] = {"lock", "timer", "vote", "handshake"};

    for (size_t m = 0; m < sizeof name / sizeof *name; m++)
        for (size_t i = 0; i < sizeof effort / sizeof *effort; i++)
            CHECK(check_effort_of(name[m], effort[i]) > 10 || effort[i] < 1000);
}

// An allocator that knows the most bytes that were allocated at one time.
typedef struct Heap { size_t now, most; } Heap;

static void *counted_alloc(void *context, void *old, size_t size)
{
    Heap *h = context;
    size_t *block = old ? (size_t *)old - 2 : NULL;

    if (block)
        h->now -= block[0];
    if (size == 0)
        return free(block), NULL;
    block = realloc(block, size + 2 * sizeof *block);
    if (!block)
        return NULL;
    block[0] = size;
    h->now += size;
    h->most = h->now > h->most ? h->now : h->most;
    return block + 2;
}

// How many bytes a search allocates beyond those of its machine, with a limit of its memory.
static size_t measure_memory(const char *name, uint64_t effort, size_t memory, bool *memory_reached, SearchResult *copy)
{
    Heap h = {0, 0};
    Arena a;
    SearchResult *r;
    Session s;
    Program *p;
    Cover *c;
    size_t before;

    host_check(setjmp(host_oom));
    p = load(&s, name);
    c = make_cover(&s, p);
    arena_init(&a, counted_alloc, &h, &host_oom);
    before = h.now;
    r = search_run(&a, c, &(SearchOptions){.seed = 5, .effort = effort, .memory = memory});
    *memory_reached = r->memory_reached;
    copy->steps = r->steps;
    copy->chosens = r->chosens;
    arena_free(&a);
    session_free(&s);
    return h.most - before;
}

// With a limit, a search of eight times as many steps needs no more memory.
static void check_memory(void)
{
    const size_t limit = 100 * 1024;
    bool was_reached[3];
    SearchResult r[3] = {{0}};
    const size_t little = measure_memory("unfound", 500000, limit, &was_reached[0], &r[0]), much = measure_memory("unfound", 4000000, limit, &was_reached[1], &r[1]);

    CHECK(much <= little && much < 2000000);
    CHECK(was_reached[0] && was_reached[1]);
    measure_memory("unfound", 4000000, limit, &was_reached[2], &r[2]);
    CHECK(was_reached[2] && r[1].steps == r[2].steps && r[1].chosens == r[2].chosens);
    measure_memory("unfound", 500000, 0, &was_reached[2], &r[2]);
    CHECK(!was_reached[2]);
}

// Memory for no more than a few snapshots still leads to results.
static void check_little_memory(void)
{
    SearchResult *r;
    Session s;
    Program *p;

    host_check(setjmp(host_oom));
    p = load(&s, "vote");
    r = search_run(&s.arena, make_cover(&s, p), &(SearchOptions){.effort = 300000, .memory = 3000});
    CHECK(count(r, SEARCH_REACHED) > 30 && r->memory_reached);
    check_scenarios(&s, p, r);
    session_free(&s);
}

// Goals that some scripts have covered are no goals.
static void check_covered(void)
{
    Session s;
    Program *p;
    Cover *c;
    SearchResult *r;

    host_check(setjmp(host_oom));
    p = load(&s, "timer");
    c = make_cover(&s, p);
    for (uint32_t i = 1; i < c->place.n; i++)
        c->hits[i] = i != c->place.n - 1;
    r = search_run(&s.arena, c, &(SearchOptions){.effort = EFFORT});
    CHECK(count(r, SEARCH_NO_GOAL) == c->place.n - 2 && count(r, SEARCH_REACHED) == 1 && r->chosens == 1);
    session_free(&s);
}

// ---- goals of the caller ----

// The situation counts the steps in which `fired` was true.
typedef struct Watched { const Program *p; uint32_t fired, t; } Watched;

static void start_watch(void *self, void *situation)
{
    (void)self;
    *(uint64_t *)situation = 0;
}

static void step_watch(void *self, void *situation, const uint64_t *cell, double *distance)
{
    const Watched *w = self;
    uint64_t *steps = situation;

    *steps += cell[w->fired] != 0;
    distance[0] = *steps >= 100 ? 0 : 100 - (double)*steps;
    distance[1] = SEARCH_UNKNOWN;
}

static void check_watch(void)
{
    Session s;
    Program *p;
    SearchResult *r;
    Watched w = {NULL, 0, 0};
    SearchWatch watch = {.self = &w, .goals = 2, .size = sizeof(uint64_t), .start = start_watch, .step = step_watch};

    host_check(setjmp(host_oom));
    w.p = p = load(&s, "timer");
    w.fired = ((Var *)map_find(&p->by_name, str_intern(&s.strings, "fired", 5)))->index;
    r = search_run(&s.arena, make_cover(&s, p), &(SearchOptions){.effort = EFFORT, .no_places = true, .watch = &watch});
    CHECK(r->find[r->places].outcome == SEARCH_REACHED && r->find[r->places + 1].outcome == SEARCH_NOT_FOUND);
    CHECK(r->chosens == 1 && r->chosen[0].scenario.steps > 60000 && r->chosen[0].scenario.changes <= 2);
    check_scenarios(&s, p, r);
    session_free(&s);
}

// ---- waits ----

// The situation is 1 after a step with `main`.
typedef struct MainWatch { uint32_t main, altitude; } MainWatch;

static void watch_main(void *self, void *situation, const uint64_t *cell, double *distance)
{
    const MainWatch *w = self;
    uint64_t *was_main = situation;
    const bool reached = cell[w->main] && !*was_main && sm_cell_to_f64(SM_F64, cell[w->altitude]) >= 50;

    *distance = reached ? 0 : 1;
    *was_main = cell[w->main];
}

static uint32_t index_of(Session *s, const Program *p, const char *name)
{
    return ((Var *)map_find(&p->by_name, str_intern(&s->strings, name, strlen(name))))->index;
}

// A long wait for a timer becomes short, although a later change then has to come later.
static void check_waits(void)
{
    Session s;
    Program *p;
    SearchResult *r;
    MainWatch w;
    SearchWatch watch = {.self = &w, .goals = 1, .size = sizeof(uint64_t), .start = start_watch, .step = watch_main};

    host_check(setjmp(host_oom));
    p = load(&s, "wait");
    w = (MainWatch){index_of(&s, p, "main"), index_of(&s, p, "altitude")};
    {
        const ScenarioChange change[] = {{1, index_of(&s, p, "armed"), SCENARIO_HOLD, 1, 0, 0}, {1, w.altitude, SCENARIO_HOLD, 110, 0, 0},
                                         {204, w.altitude, SCENARIO_HOLD, 49, 0, 0}, {205, w.altitude, SCENARIO_HOLD, 100, 0, 0}};
        const Scenario given = {.init_state = p->state.at[0], .delta_t = 10, .steps = 205, .change = change, .changes = 4};
        r = search_run(&s.arena, make_cover(&s, p), &(SearchOptions){.effort = EFFORT, .no_places = true, .watch = &watch, .given = &given, .givens = 1});
    }
    CHECK(r->find[r->places].outcome == SEARCH_REACHED && r->chosens == 1 && r->chosen[0].scenario.changes == 4);
    CHECK(r->chosen[0].scenario.steps == 4);
    check_scenarios(&s, p, r);
    session_free(&s);
}

// ---- given scenarios ----

// The situation is a hash of the altitudes of all steps.  `wanted`: after all of the given scenario.
typedef struct RunWatch { uint32_t altitude, state; uint64_t wanted; } RunWatch;

static uint64_t hash_of(uint64_t h, uint64_t cell) { return (h ^ cell) * UINT64_C(0x100000001b3); }

static void watch_run(void *self, void *situation, const uint64_t *cell, double *distance)
{
    const RunWatch *w = self;
    uint64_t *h = situation;

    *h = hash_of(hash_of(*h, cell[w->altitude]), cell[w->state]);
    *distance = *h == w->wanted ? 0 : 1;
}

static void hash_given(void *context, uint64_t step, const EngineStep *r)
{
    RunWatch *w = context;

    (void)step;
    w->wanted = hash_of(hash_of(w->wanted, r->cell[w->altitude]), r->cell[w->state]);
}

// A given scenario runs exactly, also the long waits after its transitions: nothing else comes to its last step.
static void check_given(uint64_t seed)
{
    Session s;
    Program *p;
    Engine *e;
    SearchResult *r;
    RunWatch w;
    SearchWatch watch = {.self = &w, .goals = 1, .size = sizeof(uint64_t), .start = start_watch, .step = watch_run};

    host_check(setjmp(host_oom));
    p = load(&s, "wait");
    w = (RunWatch){index_of(&s, p, "altitude"), p->s->index, 0};
    {
        const ScenarioChange change[] = {{1, index_of(&s, p, "armed"), SCENARIO_HOLD, 1, 0, 0}, {1, w.altitude, SCENARIO_HOLD, 110.75, 0, 0},
                                         {2204, w.altitude, SCENARIO_HOLD, 49.125, 0, 0}, {2900, w.altitude, SCENARIO_HOLD, 100, 0, 0}};
        const Scenario given = {.init_state = p->state.at[0], .delta_t = 10, .steps = 3500, .change = change, .changes = 4};
        e = engine_ref_open(&s.arena, p);
        CHECK(scenario_run(&s.arena, p, &given, e, hash_given, &w) == ENGINE_OK);
        e->close(e);
        r = search_run(&s.arena, make_cover(&s, p), &(SearchOptions){.seed = seed, .effort = 40000, .no_places = true, .watch = &watch, .given = &given, .givens = 1});
    }
    CHECK(r->find[r->places].outcome == SEARCH_REACHED && r->chosens == 1 && r->chosen[0].scenario.steps == 3500);
    check_scenarios(&s, p, r);
    session_free(&s);
}

// ---- loops ----

static bool has_change(const Scenario *s, size_t i, uint64_t step, double a) { return i < s->changes && s->change[i].step == step && s->change[i].a == a; }

static void check_unrolled(void)
{
    const ScenarioChange change[] = {{1, 0, SCENARIO_HOLD, 7, 0, 0}, {3, 1, SCENARIO_HOLD, 1, 0, 0}, {5, 1, SCENARIO_HOLD, 2, 0, 0}, {14, 0, SCENARIO_HOLD, 8, 0, 0}};
    const ScenarioLoop loop = {3, 4, 12};
    const Scenario s = {.delta_t = 1, .steps = 20, .change = change, .changes = 4, .loop = &loop, .loops = 1};
    Session session;
    Scenario flat;

    session_init(&session, heap_alloc, NULL, &host_oom);
    host_check(setjmp(host_oom));
    flat = scenario_unroll(&session.arena, &s);
    CHECK(flat.loops == 0 && flat.changes == 7 && flat.steps == 20);
    CHECK(has_change(&flat, 0, 1, 7) && has_change(&flat, 1, 3, 1) && has_change(&flat, 2, 5, 2) && has_change(&flat, 3, 7, 1) && has_change(&flat, 4, 9, 2));
    CHECK(has_change(&flat, 5, 11, 1) && has_change(&flat, 6, 14, 8));
    CHECK(scenario_loop_at(&s, 2) == NULL && scenario_loop_at(&s, 3) == &loop && scenario_loop_at(&s, 6) == &loop && scenario_loop_at(&s, 7) == NULL);
    session_free(&session);
}

// A count of a hundred and more needs as many pulses.  With loops, no scenario has more changes than a person writes; without, some have.
static void check_loops(void)
{
    size_t most[2] = {0, 0};
    volatile unsigned loops = 0;

    for (volatile int with = 0; with < 2; with = with + 1) {
        Session s;
        Program *p;
        SearchResult *r;
        host_check(setjmp(host_oom));
        p = load(&s, "winch");
        CHECK(p != NULL);
        if (!p)
            return;
        r = search_run(&s.arena, make_cover(&s, p), &(SearchOptions){.seed = 1, .effort = EFFORT, .loops = with});
        CHECK(count(r, SEARCH_NOT_FOUND) == 0);
        for (uint32_t i = 0; i < r->chosens; i++) {
            most[with] = r->chosen[i].scenario.changes > most[with] ? r->chosen[i].scenario.changes : most[with];
            loops = loops + (r->chosen[i].scenario.loops > 0);
        }
        check_scenarios(&s, p, r);
        session_free(&s);
    }
    CHECK(most[0] > 200 && most[1] <= 20 && loops > 3);
}

// Inputs that a later state needs are set together with those of an earlier one, where that is possible.
static void check_times(void)
{
    Session s;
    Program *p;
    SearchResult *r;
    volatile size_t changes = 0, times = 0;

    host_check(setjmp(host_oom));
    p = load(&s, "bounds");
    CHECK(p != NULL);
    if (!p)
        return;
    r = search_run(&s.arena, make_cover(&s, p), &(SearchOptions){.seed = 1, .effort = EFFORT, .loops = true});
    for (uint32_t i = 0; i < r->chosens; i++) {
        changes = changes + r->chosen[i].scenario.changes;
        times = times + scenario_times(&r->chosen[i].scenario);
    }
    CHECK(changes > 40 && times <= 26);
    check_scenarios(&s, p, r);
    session_free(&s);
}

int main(void)
{
    check_machine_of("timer", 0);
    check_machine_of("window", 0);
    check_machine_of("handshake", 0);
    check_machine_of("vote", 0);
    check_machine_of("lock", 1);
    check_machine_of("stuck", 0);
    check_machine_of("impossible", 15);
    check_machine_of("bounds", 8);
    check_machine_of("proofs", 43);
    check_machine_of("stays", 19);
    check_determinism();
    check_stop();
    check_effort();
    check_memory();
    check_little_memory();
    check_covered();
    check_watch();
    check_waits();
    for (uint64_t seed = 0; seed < 8; seed++)
        check_given(seed);
    check_unrolled();
    check_loops();
    check_times();
    return test_end("search_run");
}
