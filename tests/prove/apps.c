// SPDX-License-Identifier: Apache-2.0
// Checks verdicts of smc prove on random applications: of each requirement that a machine decides alone (prove_app.h).
//
//   proved, vacuous   no random run of the application violates it.  Runs are of the reference interpreter, longer ones of flat machines, and
//                     anything that the deciding machine does not store has any value in each tick, as other tasks could write it
//   violated alone    the scenario violates it in its last step, on this machine alone
//
// An application has two or three machines, some of which share elements, have longer periods or an @mode.  [start] sets some elements.
//
//     apps SEED COUNT [TICKS]
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compiler/cover/cover.h"
#include "compiler/prove/prove_app.h"
#include "compiler/script/monitor.h"
#include "stdlib/convert.h"
#include "tests/diff/subject.h"
#include "tests/heap.h"
#include "tests/prove/held_text.h"
#include "tests/prove/related_text.h"

enum { MACHINES = 3, ELEMENTS = 120, REQUIREMENTS = 6, INTERPRETED_MOST = 256, TICK = 10, EVERY_MOST = 4 };

typedef enum Kind { KIND_ANY, KIND_RELATED, KIND_HELD, KINDS } Kind;

// ---- what was generated ----

typedef struct One {              // a machine
    Kind kind;
    Related related;
    Held held;
    const char *text;
    Subject subject;              // the machine compiled alone
    const Program *p;
    uint32_t element[GEN_VARS_MAX];       // by Var.index of an element: its Shared
    uint32_t every;               // its period in ticks
    uint32_t mode;                // the Shared of its @mode; 0: none
    uint32_t initial;             // number of its first state
} One;

typedef struct Shared {           // an element of the application; 0 is the time
    SmType type;
    bool is_special;              // the time, an S, a mode
    uint32_t last;                // 1 + the last machine that uses it
    uint32_t start;               // from [start]; 0: none
} Shared;

static Arena arena;
static Rng rng;
static One one[MACHINES];
static uint32_t ones;
static Shared shared[ELEMENTS];
static uint32_t shareds;

static struct { uint64_t applications, verdict[PROVE_VERDICTS], undecidable, shared, modes, slow, starts, violations, ticks, interpreted; } met;

// ---- generating ----

static uint32_t add_shared(SmType type, bool is_special)
{
    shared[shareds] = (Shared){.type = type, .is_special = is_special};
    return shareds++;
}

// Returns an element of an earlier machine; ELEMENTS: none fits.
static uint32_t pick_shared(SmType type, uint32_t machine)
{
    const uint32_t from = rng_below(&rng, shareds);

    for (uint32_t i = 0; i < shareds; i++) {
        const Shared *s = &shared[(from + i) % shareds];
        if (s->type == type && !s->is_special && s->last != machine + 1)
            return (from + i) % shareds;
    }
    return ELEMENTS;
}

// Prints and compiles a machine.  Returns an error, or NULL.
static const char *print_machine(One *m)
{
    Buf sm;
    Gen *g;
    uint64_t seed;

    buf_init(&sm, &arena);
    m->kind = (Kind)rng_below(&rng, KINDS);
    if (m->kind == KIND_RELATED)
        m->related = related_print_machine(&rng, &sm);
    else if (m->kind == KIND_HELD)
        m->held = held_print_machine(&rng, &sm);
    else {
        do {
            seed = rng_u64(&rng);
            g = gen_seed_has_additions(seed) ? NULL : gen_program(&arena, seed, 4);
        } while (!g || g->with_sv);
        for (size_t i = 0; i < g->var.n; i++)
            g->var.at[i]->outside = false;
        gen_print_sm(g, &sm);
    }
    m->text = buf_text(&sm);
    return subject_compile_text(&m->subject, m->text, &arena);
}

static const char *add_machine(uint32_t k)
{
    One *m = &one[k];
    const char *error;

    memset(m, 0, sizeof *m);
    if ((error = print_machine(m)) != NULL)
        return error;
    m->p = m->subject.program;
    for (size_t v = 0; v < m->p->var.n; v++) {
        const Var *var = m->p->var.at[v];
        uint32_t e = ELEMENTS;
        if (var->kind != VAR_ELEMENT)
            continue;
        if (var != m->p->g && var != m->p->s && rng_percent(&rng, 50))
            e = pick_shared(var->type, k);
        met.shared += e != ELEMENTS;
        m->element[v] = var == m->p->g ? 0 : e != ELEMENTS ? e : add_shared(var->type, var == m->p->s);
        shared[m->element[v]].last = k + 1;
    }
    if (rng_percent(&rng, 15))
        m->mode = add_shared(SM_U8, true);
    m->every = m->p->step || rng_percent(&rng, 75) ? 1 : 2 << rng_below(&rng, 2);
    m->initial = 1 + rng_below(&rng, (uint32_t)m->p->state.n);
    met.modes += m->mode > 0;
    met.slow += m->every > 1;
    return NULL;
}

static void plan_starts(void)
{
    for (uint32_t e = 1; e < shareds; e++)
        if (!shared[e].is_special && shared[e].type != SM_BOOL && rng_percent(&rng, 5)) {
            shared[e].start = 1 + rng_below(&rng, 100);
            met.starts++;
        }
}

static void print_sv(Buf *out)
{
    buf_str(out, "[A]\n");
    for (uint32_t e = 0; e < shareds; e++)
        buf_printf(out, "%s e%u\n", sm_type_info[shared[e].type].spelling, (unsigned)e);
}

static void print_app_machine(const One *m, Buf *out)
{
    buf_printf(out, "    machine m%u \"m%u.sm\" {\n", (unsigned)(m - one), (unsigned)(m - one));
    for (size_t v = 0; v < m->p->var.n; v++)
        if (m->p->var.at[v]->kind == VAR_ELEMENT)
            buf_printf(out, "        %s = e%u\n", m->p->var.at[v]->name->text, (unsigned)m->element[v]);
    buf_printf(out, "    } @state %s", m->p->state.at[m->initial - 1]->name->text);
    if (m->mode)
        buf_printf(out, " @mode e%u", (unsigned)m->mode);
    buf_char(out, '\n');
}

// Prints the machines that step in every so many ticks.
static void print_group(uint32_t every, Buf *out)
{
    bool is_first = true;

    for (uint32_t k = 0; k < ones; k++) {
        if (one[k].every != every)
            continue;
        if (is_first)
            buf_printf(out, "every %u ms:\n", (unsigned)(TICK * every));
        is_first = false;
        print_app_machine(&one[k], out);
    }
}

static void print_app(Buf *out)
{
    buf_printf(out, "[options]\nstate_vector \"random.sv\"\ntime e0 1 ms\n\n[start]\n");
    for (uint32_t e = 1; e < shareds; e++)
        if (shared[e].start)
            buf_printf(out, "e%u = %u\n", (unsigned)e, (unsigned)shared[e].start);
    buf_str(out, "\n[all]\n");
    for (uint32_t every = 1; every <= EVERY_MOST; every++)
        print_group(every, out);
}

// ---- requirements ----

// Prints a comparison or a bool of the machine's own variables.
static void print_atom(const One *m, Buf *out)
{
    static const char *const relation[] = {"==", "!=", "<", "<=", ">", ">="};
    const Var *v = m->p->var.at[rng_below(&rng, (uint32_t)m->p->var.n)];

    if (rng_percent(&rng, 30) || v == m->p->s || v == m->p->g || (v->kind == VAR_ELEMENT && !v->written && rng_percent(&rng, 90)))
        buf_printf(out, "S == %s", m->p->state.at[rng_below(&rng, (uint32_t)m->p->state.n)]->name->text);
    else if (v->type == SM_BOOL)
        buf_printf(out, "%s%s", rng_percent(&rng, 50) ? "not " : "", v->name->text);
    else
        buf_printf(out, "%s %s %d", v->name->text, relation[rng_below(&rng, 6)], (int)rng_below(&rng, 40) * (rng_percent(&rng, 30) ? 10 : 1) - 5);
}

static void print_condition(const One *m, Buf *out)
{
    const uint32_t form = rng_below(&rng, 10);

    if (form < 2)
        buf_str(out, "held(");
    print_atom(m, out);
    if (form >= 5) {
        buf_str(out, form < 8 ? " and " : " or ");
        print_atom(m, out);
    }
    if (form < 2)
        buf_printf(out, ", %u ms)", (unsigned)(TICK * (1 + rng_below(&rng, 6))));
}

static void print_any(const One *m, Buf *out)
{
    static const char *const begin[] = {"never ", "always ", "always ", "always (", "never ("}, *const between[] = {"", "", " implies ", " leads to ", ") before ("};
    const uint32_t form = rng_below(&rng, 5);

    buf_str(out, begin[form]);
    if (form == 3)
        buf_printf(out, "%s", "");
    print_condition(m, out);
    if (form >= 2) {
        buf_str(out, form == 3 ? ") leads to (" : between[form]);
        print_condition(m, out);
    }
    if (form == 3)
        buf_printf(out, ") within %u ms", (unsigned)(TICK * (1 + rng_below(&rng, 30))));
    if (form == 4)
        buf_char(out, ')');
}

static bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_'; }

// Prints a requirement of a machine with the names that they have in the application: `S` as `m1.S`.  A state beside S has its own name.
static void print_with_machine(const One *m, const char *text, Buf *out)
{
    bool compares = false;

    while (*text) {
        size_t n = 0;
        Str name;
        while (is_letter(text[n]))
            n++;
        if (n == 0) {
            compares = *text == '=' || (compares && *text == ' ');
            buf_char(out, *text++);
            continue;
        }
        name = str_c(&((Subject *)(size_t)&m->subject)->session.strings, format_in(&arena, "%.*s", (int)n, text));
        if (map_find(&m->p->by_name, name) == m->p->g)
            buf_char(out, 'G');
        else
            buf_printf(out, "%s%.*s", map_find(&m->p->by_name, name) || (map_find(&m->p->state_by_name, name) && !compares)
                                          ? format_in(&arena, "m%u.", (unsigned)(m - one)) : "", (int)n, text);
        compares = false;
        text += n;
    }
}

static void print_requirements(Buf *out)
{
    for (int i = 0; i < REQUIREMENTS; i++) {
        const One *m = &one[rng_below(&rng, ones)];
        Buf own;
        buf_init(&own, &arena);
        if (m->kind == KIND_RELATED && rng_percent(&rng, 70))
            related_print_requirement(&rng, &m->related, &own);
        else if (m->kind == KIND_HELD && rng_percent(&rng, 70))
            held_print_requirement(&rng, &m->held, &own);
        else
            print_any(m, &own);
        if (own.n && buf_text(&own)[own.n - 1] == '\n')
            own.n--;
        buf_printf(out, "R%d \"random\" ", i + 1);
        print_with_machine(m, format_in(&arena, "%.*s", (int)own.n, buf_text(&own)), out);
        buf_char(out, '\n');
    }
}

// ---- runs of the application ----

typedef struct AppTest {
    const Program *p;             // the joined Program
    const ProveApp *app;
    FlatMachine **flat;           // by machine
    size_t requirement;           // the one that is judged, and its machine
    const Member *decider;
} AppTest;

// Whether the deciding machine stores the variable.
static bool decider_stores(const AppTest *t, const Var *v)
{
    for (size_t i = 0; i < t->decider->program->var.n; i++)
        if (t->decider->var[i] == v)
            return t->decider->program->var.at[i]->written || t->decider->s == v;
    return false;
}

static uint64_t any_cell(SmType type)
{
    const uint32_t r = rng_below(&rng, 100);

    if (r < 5)
        return sm_cell_from_f64(type, rng_percent(&rng, 50) ? 1e300 : -1e300);
    if (r < 8)
        return sm_cell_from_f64(type, sm_from_bits(UINT64_C(0x7ff8000000000000)));
    return sm_cell_from_f64(type, r < 50 ? (double)rng_below(&rng, 5) - 1 : ((double)rng_below(&rng, 801) - 400) / 4);
}

// Runs so many ticks.  Returns what is wrong; NULL: nothing.
static const char *run_randomly(const AppTest *t, uint64_t ticks)
{
    Monitor *monitor = monitor_new(&arena, t->app->what, t->p->step);
    void *situation = arena_alloc(&arena, monitor->size);
    const bool is_short = ticks <= INTERPRETED_MOST, pure = rng_percent(&rng, 50);
    Engine *e = is_short ? engine_ref_open(&arena, t->p) : engine_flat_open_machines(&arena, t->p, t->flat, NULL, 0);
    const uint32_t change = 1 + rng_below(&rng, 60);
    EngineWrite write[2 * ELEMENTS];
    const char *wrong = NULL;
    EngineStep step;

    met.interpreted += is_short;
    monitor_start(monitor, situation);
    engine_step_init(&step, &arena, t->p);
    if (e->init(e, 1, &step) != ENGINE_OK)
        wrong = "does not start";
    for (uint64_t k = 0; k < ticks && !wrong; k++) {
        uint32_t n = 1;
        write[0] = (EngineWrite){t->p->g->index, k * t->p->step};
        for (uint32_t v = 0; v < t->p->var.n; v++) {
            const Var *var = t->p->var.at[v];
            if (var->kind != VAR_ELEMENT || var == t->p->g || var->state_of || decider_stores(t, var) || (pure && program_uses_of(t->p, var).written))
                continue;
            if (k == 0 || rng_percent(&rng, change))
                write[n++] = (EngineWrite){v, rng_percent(&rng, 20) && var->type == SM_U8 ? MODE_ENABLED : any_cell(var->type)};
        }
        met.ticks++;
        if (e->step(e, write, n, &step) != ENGINE_OK) {
            wrong = "refuses a tick";
            break;
        }
        for (size_t m = 0; m < t->p->joint->member.n; m++)
            monitor->ran[m] = step.machine[m].ran;
        monitor_step(monitor, situation, step.cell);
        if (monitor->result[t->requirement] == MONITOR_VIOLATED)
            wrong = format_in(&arena, "violates it in tick %" PRIu64 " of a run %s", k + 1, is_short ? "of the interpreter" : "of flat machines");
    }
    e->close(e);
    return wrong;
}

// ---- violations ----

typedef struct Violation { Monitor *monitor; void *situation; size_t requirement; uint64_t step; } Violation;

static void judge_violation(void *context, uint64_t step, const EngineStep *result)
{
    Violation *v = context;

    monitor_step(v->monitor, v->situation, result->cell);
    if (v->step == 0 && v->monitor->result[v->requirement] == MONITOR_VIOLATED)
        v->step = step;
}

// Whether the scenario of a verdict violates the requirement in its last step, on the machine alone.
static bool is_violated(const AppTest *t, const ProveOf *of)
{
    const Requirements *own = t->app->own[t->decider - t->p->joint->member.at];
    Violation v = {monitor_new(&arena, own, t->p->step), NULL, (size_t)(of->what - own->at.at), 0};
    Engine *e = engine_ref_open(&arena, t->decider->program);

    v.situation = arena_alloc(&arena, v.monitor->size);
    monitor_start(v.monitor, v.situation);
    scenario_run(&arena, t->decider->program, of->scenario, e, judge_violation, &v);
    e->close(e);
    met.violations++;
    return v.step == of->scenario->steps;
}

// ---- one application ----

static const char *check_verdict(AppTest *t, size_t i, uint64_t ticks)
{
    const ProveOf *of = prove_app_verdict(t->app, i);
    const char *wrong = NULL, *id = t->app->what->at.at[i].id->text;

    met.undecidable += of == NULL;
    if (!of)
        return NULL;
    met.verdict[of->verdict]++;
    t->requirement = i;
    t->decider = &t->p->joint->member.at[t->app->decider[i]];
    if (of->verdict == PROVE_VIOLATED && !is_violated(t, of))
        return format_in(&arena, "%s is violated alone, but its scenario does not end with that", id);
    if (of->verdict != PROVE_PROVED && of->verdict != PROVE_VACUOUS)
        return NULL;
    for (uint64_t done = 0, length = 64; !wrong && done < ticks; done += length, length = length < ticks / 4 ? length * 2 : length)
        wrong = run_randomly(t, length);
    return wrong ? format_in(&arena, "%s is proved, but a run %s", id, wrong) : NULL;
}

static jmp_buf out_of_memory;

static const Source *source(Session *s, const char *name, void (*print)(Buf *out))
{
    Buf text;

    buf_init(&text, &s->arena);
    print(&text);
    return source_new(&s->arena, name, buf_text(&text), text.n);
}

static const Source *find_source(Session *s, const AppFile *f)
{
    const char *name = f->name.text->text;

    return f->kind == FILE_SV ? source(s, name, print_sv) : source_new(&s->arena, name, one[name[1] - '0'].text, strlen(one[name[1] - '0'].text));
}

static const char *text_of_diags(Session *s)
{
    const DiagStyle style = {false, 5};
    Buf text;

    buf_init(&text, &arena);
    diags_render_text(&s->diags, &style, &text);
    return buf_text(&text);
}

// Compiles the application, decides its requirements and checks the verdicts.  Returns what is wrong.
static const char *test_application(const char *rq, uint64_t ticks)
{
    Session s;
    CompileSource at[2];
    CompileApp app;
    CompileInput in = {.at = at, .n = 2, .app = &app};
    CompileOptions o = {.skip_analyses = true};
    Compiled made;
    const char *wrong = NULL;

    session_init(&s, heap_alloc, NULL, &out_of_memory);
    memset(at, 0, sizeof at);
    at[0] = (CompileSource){.text = source(&s, "random.app", print_app), .kind = FILE_APP};
    at[1] = (CompileSource){.text = source_new(&s.arena, "random.rq", rq, strlen(rq)), .kind = FILE_RQ};
    compile_open_app(&s, at[0].text, &app);
    for (size_t i = 0; i < app.files.n; i++)
        app.files.at[i].src = find_source(&s, &app.files.at[i]);
    if (!compile_sources(&s, &in, &o, &made) || !made.of[0].requirements) {
        wrong = text_of_diags(&s);
    } else {
        const ProveOptions options = {.effort = 5000, .visits = 15000};
        ProveApp *all = prove_app_new(&s.arena, made.of[0].requirements);
        AppTest t = {.p = made.of[0].scripted, .app = all};
        t.flat = flat_new_machines(&arena, t.p);
        met.applications++;
        for (size_t m = 0; m < t.p->joint->member.n; m++)
            if (all->own[m] && prove_app_run(all, m, &options)->bug)
                wrong = "the reference interpreter does not confirm a violation";
        for (size_t i = 0; i < all->what->at.n && !wrong; i++)
            wrong = check_verdict(&t, i, ticks);
        wrong = wrong ? format_in(&arena, "%s", wrong) : NULL;
    }
    session_free(&s);
    return wrong;
}

static bool test_one(uint64_t seed, uint64_t ticks)
{
    const char *wrong = NULL;
    Buf rq, app;

    diff_arena_init(&arena);
    rng.state = rng_mix(seed, 4242);
    shareds = 0;
    add_shared(SM_U64, true);
    ones = 2 + rng_below(&rng, MACHINES - 1);
    for (uint32_t k = 0; k < ones && !wrong; k++)
        wrong = add_machine(k);
    buf_init(&rq, &arena);
    buf_init(&app, &arena);
    if (!wrong) {
        plan_starts();
        print_requirements(&rq);
        wrong = test_application(buf_text(&rq), ticks);
        print_app(&app);
    }
    if (wrong)
        fprintf(stderr, "seed %" PRIu64 ": %s\n%s\n%s", seed, wrong, buf_text(&rq), buf_text(&app));
    for (uint32_t k = 0; k < ones && one[k].p; k++)
        subject_free(&one[k].subject);
    memset(one, 0, sizeof one);
    arena_free(&arena);
    return wrong == NULL;
}

// Prints what the random applications did not have often enough, and returns how much that is: a campaign that lacks it shows nothing about it.
static uint64_t count_missed_floors(uint64_t count)
{
    static const struct { const char *what; const uint64_t *n; unsigned least; } floors[] = {        // `least`: in 100 applications
        {"compiled applications", &met.applications, 90}, {"proved", &met.verdict[PROVE_PROVED], 25}, {"violated alone", &met.violations, 50},
        {"that no machine decides", &met.undecidable, 50}, {"shared elements", &met.shared, 100}, {"modes", &met.modes, 10},
        {"longer periods", &met.slow, 10}, {"values of [start]", &met.starts, 25}, {"interpreted runs", &met.interpreted, 50},
    };
    uint64_t missed = 0;

    for (size_t i = 0; i < sizeof floors / sizeof *floors; i++)
        if (*floors[i].n < floors[i].least * count / 100) {
            printf("only %" PRIu64 " %s, at least %" PRIu64 " are needed\n", *floors[i].n, floors[i].what, floors[i].least * count / 100);
            missed++;
        }
    return missed;
}

int main(int argc, char **argv)
{
    const uint64_t seed = argc > 1 ? strtoull(argv[1], NULL, 10) : 1, count = argc > 2 ? strtoull(argv[2], NULL, 10) : 100;
    const uint64_t ticks = argc > 3 ? strtoull(argv[3], NULL, 10) : 3000;
    uint64_t good = 0, missed = 0;

    for (uint64_t i = 0; i < count; i++)
        good += test_one(seed + i, ticks);
    printf("%" PRIu64 " of %" PRIu64 " applications: %" PRIu64 " proved, %" PRIu64 " vacuous, %" PRIu64 " violated alone, %" PRIu64 " open, %" PRIu64
           " that no machine decides; %" PRIu64 " shared elements, %" PRIu64 " modes, %" PRIu64 " longer periods, %" PRIu64 " of [start]; %" PRIu64
           " ticks, %" PRIu64 " interpreted runs\n", good, count, met.verdict[PROVE_PROVED], met.verdict[PROVE_VACUOUS], met.verdict[PROVE_VIOLATED],
           met.verdict[PROVE_UNDECIDED], met.undecidable, met.shared, met.modes, met.slow, met.starts, met.ticks, met.interpreted);
    if (count >= 40)
        missed = count_missed_floors(count);
    printf("verdicts in applications: %" PRIu64 " passed, %" PRIu64 " failed\n", good, count - good + missed);
    return good != count || missed > 0;
}
