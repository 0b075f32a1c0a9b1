// SPDX-License-Identifier: Apache-2.0
// Random applications of 2 to 5 machines, each run by one script, against a slow reference.
//
//     random SEED COUNT [FOLDER]
//
// A machine is a program of tests/diff. The application binds its elements to elements of its own, or to elements of earlier machines. The
// reference compiles every machine alone, with a state vector of its own, and steps it on the reference interpreter in the order that
// docs/language.md 8.71 to 8.81 prescribes; it shares no code with the script's run. After every tick, all elements, the locals and T of
// every machine, and how often the sections of the script have run must be equal.  So must be the elements of the flat machines of the application
// (flat_app.h), one seen from each machine.
//
// With FOLDER, writes each application there instead, with C tasks that play its script and the final values: tests/joint/sim.sh builds
// them for the simulation.  clause 8.71 clause 8.72 clause 8.73 clause 8.75 clause 8.76 clause 8.80
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compiler/cover/flat_app.h"
#include "compiler/script/ref.h"
#include "compiler/script/script.h"
#include "tests/diff/gen.h"
#include "tests/diff/subject.h"
#include "tests/heap.h"
#include "tests/test.h"

enum { MACHINES = 5, EXECUTORS = 3, GROUPS = 4, ELEMENTS = 400, INPUTS = 60, COUNTERS = 6, ENABLED = 2, TICKS = 60 };

// ---- what was generated ----

typedef struct One {              // a machine
    Gen *g;
    Subject subject;
    const Program *p;
    Engine *engine;
    EngineStep answer;
    uint32_t element[GEN_VARS_MAX];       // by Var.index of an element: its Shared
    bool is_written[GEN_VARS_MAX];        // by Var.index of a local: the script writes it
    EngineWrite write[2 * GEN_VARS_MAX];  // to locals, since its last step
    uint32_t writes;
    uint32_t mode;                // the Shared of its @mode; 0: none
    uint32_t initial;             // number of its first state
    uint64_t period;
    bool counts;                  // this tick is one of its own
} One;

typedef struct Shared {           // an element of the application
    char name[24];
    SmType type;
    uint64_t cell, start;         // start: from [start], a whole number
    bool is_special;              // the time, an S, a mode
    uint32_t last;                // 1 + the last machine that uses it
} Shared;

typedef struct Group { uint64_t period; One *machine[MACHINES]; uint32_t machines; } Group;
typedef struct Executor { Group group[GROUPS]; uint32_t groups; } Executor;

typedef struct Input {            // at G == g: an element, or a local of a machine, becomes value / 2
    uint64_t g;
    uint32_t shared;
    One *machine;                 // of a local; NULL: an element
    const Var *local;
    int value;
} Input;

typedef struct Counter { One *machine; uint32_t state; uint64_t ran; } Counter;

static Arena arena;
static Rng rng;
static One one[MACHINES];
static uint32_t ones;
static Shared shared[ELEMENTS];
static uint32_t shareds;
static Executor executor[EXECUTORS];
static uint32_t executors;
static Input input[INPUTS];
static uint32_t inputs;
static Counter counter[COUNTERS];
static uint32_t counters;
static uint64_t tick_ns, now_tick, start_g;
static const char *difference;
static bool for_runtime;          // the first executor runs a task in every tick, which plays the script

static struct { uint32_t applications, shared, fractions, modes, executors, transitions, disabled, locals, ran; } met;

static uint64_t g_at(uint64_t tick) { return start_g + tick * tick_ns / 1000000; }

// ---- generating ----

static uint32_t add_shared(SmType type, bool is_special)
{
    Shared *s = &shared[shareds];

    *s = (Shared){.type = type, .is_special = is_special};
    snprintf(s->name, sizeof s->name, "e%u", (unsigned)shareds);
    return shareds++;
}

// Returns an element of an earlier machine; ELEMENTS: none fits.
static uint32_t pick_shared(SmType type, uint32_t machine)
{
    uint32_t from = rng_below(&rng, shareds);

    for (uint32_t i = 0; i < shareds; i++) {
        Shared *s = &shared[(from + i) % shareds];
        if (s->type == type && !s->is_special && s->last != machine + 1)
            return (from + i) % shareds;
    }
    return ELEMENTS;
}

static void add_machine(uint32_t k)
{
    One *m = &one[k];
    uint64_t seed;
    const char *error;

    memset(m, 0, sizeof *m);
    do {
        seed = rng_u64(&rng);
        m->g = gen_seed_has_additions(seed) ? NULL : gen_program(&arena, seed, 2);
    } while (!m->g || m->g->with_sv);
    for (size_t i = 0; i < m->g->var.n; i++)
        m->g->var.at[i]->outside = m->g->var.at[i]->is_local && m->g->var.at[i]->roll_size == 0;
    error = subject_compile(&m->subject, m->g, &arena);
    if (error) {
        fprintf(stderr, "a generated machine does not compile:\n%s\n", error);
        exit(1);
    }
    m->p = m->subject.program;
    for (size_t v = 0; v < m->p->var.n; v++) {
        const Var *var = m->p->var.at[v];
        uint32_t e = ELEMENTS;
        if (var->kind != VAR_ELEMENT)
            continue;
        if (var != m->p->g && var != m->p->s && rng_percent(&rng, 40))
            e = pick_shared(var->type, k);
        met.shared += e != ELEMENTS;
        m->element[v] = var == m->p->g ? 0 : e != ELEMENTS ? e : add_shared(var->type, var == m->p->s);
        shared[m->element[v]].last = k + 1;
    }
    if (rng_percent(&rng, 40))
        m->mode = add_shared(SM_U8, true);
    met.modes += m->mode > 0;
    m->initial = 1 + rng_below(&rng, (uint32_t)m->p->state.n);
    m->engine = engine_ref_open(&m->subject.session.arena, m->p);
    engine_step_init(&m->answer, &m->subject.session.arena, m->p);
}

// ---- flat machines of the application ----

typedef struct FlatOne {
    const FlatView *view;
    FlatMachine *f;
    void *run;
    One *machine;             // whose view it is
    bool is_compared;         // false from when the script writes a local of another machine, which the view does not have
} FlatOne;

static FlatOne flat[MACHINES];
static uint32_t flats;
static uint64_t flat_ticks;

static void flat_begin(Arena *a, const Program *joint)
{
    const IrMachine *ir[MACHINES];

    for (size_t i = 0; i < joint->joint->member.n; i++)
        ir[i] = ir_build(a, engine_program(joint, i));
    for (flats = 0; flats < joint->joint->member.n; flats++) {
        const Member *m = &joint->joint->member.at[flats];
        FlatOne *x = &flat[flats];
        x->view = flat_view_new(a, joint, flats, ir);
        x->f = flat_app_join(flat_new(a, x->view->m, NULL), x->view->app);
        x->run = arena_alloc(a, x->f->size);
        x->machine = &one[m->name->text[1] - '0'];
        x->is_compared = true;
        flat_start(x->f, x->run, m->initial->number);
    }
}

// Returns the cell of a variable of the view.
static uint64_t *flat_cell(const FlatOne *x, const Var *v) { return &flat_cells(x->f, x->run)[x->view->m->var_of[v->index]]; }

static void flat_write_element(const char *name, uint64_t cell)
{
    for (uint32_t i = 0; i < flats; i++)
        for (size_t v = 0; v < flat[i].view->p->var.n; v++)
            if (flat[i].view->p->var.at[v]->kind == VAR_ELEMENT && strcmp(flat[i].view->p->var.at[v]->element->name->text, name) == 0)
                *flat_cell(&flat[i], flat[i].view->p->var.at[v]) = cell;
}

static void flat_write_local(const One *m, const Var *v, uint64_t cell)
{
    for (uint32_t i = 0; i < flats; i++)
        if (flat[i].machine != m)
            flat[i].is_compared = false;
        else
            *flat_cell(&flat[i], flat[i].view->p->var.at[v->index]) = cell;
}

static uint64_t gcd(uint64_t a, uint64_t b) { return b ? gcd(b, a % b) : a; }

static void plan_executors(void)
{
    static const uint64_t bases[] = {1000000, 2000000, 2500000, 3000000, 5000000, 10000000};

    executors = 1 + rng_below(&rng, EXECUTORS);
    tick_ns = 0;
    for (uint32_t x = 0; x < executors; x++) {
        const uint64_t base = bases[rng_below(&rng, sizeof bases / sizeof *bases)];
        const uint32_t rotation = rng_below(&rng, GROUPS);
        executor[x] = (Executor){.groups = 1 + rng_below(&rng, GROUPS)};
        for (uint32_t r = 0; r < executor[x].groups; r++)         // the shortest period is that of all, so it divides the others
            executor[x].group[(r + rotation) % executor[x].groups] = (Group){.period = base * (r + 1)};
        tick_ns = gcd(tick_ns, base);
    }
    if (for_runtime)
        executor[0] = (Executor){.groups = 1, .group = {{.period = tick_ns}}};
    for (uint32_t k = 0; k < ones; k++) {
        const uint32_t fastest = for_runtime && tick_ns < 1000000 ? 1 : 0;       // a machine is not faster than G counts
        Executor *e = &executor[fastest < executors ? fastest + rng_below(&rng, executors - fastest) : 0];
        Group *g = &e->group[rng_below(&rng, e->groups)];
        g->machine[g->machines++] = &one[k];
        one[k].period = g->period;
    }
    met.executors += executors > 1;
    met.fractions += tick_ns % 1000000 != 0;
}

// A random value, in halves; a bool and a mode get small ones.
static int random_value(bool is_mode) { return is_mode ? 2 * (int)rng_below(&rng, 4) : (int)rng_below(&rng, 601) - 300; }

static void plan_inputs(void)
{
    inputs = counters = 0;
    start_g = rng_percent(&rng, 25) ? 1000 : 0;
    while (inputs < INPUTS) {
        Input *in = &input[inputs];
        One *m = &one[rng_below(&rng, ones)];
        const uint32_t v = rng_below(&rng, (uint32_t)m->p->var.n), e = rng_below(&rng, shareds);
        *in = (Input){.g = g_at(rng_below(&rng, TICKS))};
        if (rng_percent(&rng, 30) && m->mode) {
            in->shared = m->mode;
            in->value = rng_percent(&rng, 60) ? 2 * ENABLED : random_value(true);
        } else if (!for_runtime && rng_percent(&rng, 30) && m->p->var.at[v]->kind == VAR_LOCAL && m->p->var.at[v]->outside) {
            in->machine = m;
            in->local = m->p->var.at[v];
            in->value = random_value(false);
            m->is_written[v] = true;
            met.locals++;
        } else if (!shared[e].is_special && e > 0) {
            in->shared = e;
            in->value = random_value(false);
        } else {
            continue;
        }
        inputs++;
    }
    for (uint32_t e = 1; e < shareds; e++)
        shared[e].start = !shared[e].is_special && shared[e].type != SM_BOOL && rng_percent(&rng, 10) ? rng_below(&rng, 100) : 0;
    for (uint32_t k = 0; k < ones; k++)
        if (one[k].mode)
            shared[one[k].mode].start = rng_percent(&rng, 70) ? ENABLED : 0;
    for (uint32_t i = 0; i < COUNTERS; i++) {
        Counter c = {&one[rng_below(&rng, ones)], 0, 0};
        bool is_new = true;
        c.state = 1 + rng_below(&rng, (uint32_t)c.machine->p->state.n);
        for (uint32_t n = 0; n < counters; n++)
            is_new = is_new && !(counter[n].machine == c.machine && counter[n].state == c.state);
        if (is_new)
            counter[counters++] = c;
    }
}

// ---- its text ----

static void print_app(Buf *out)
{
    uint32_t tasks = 0;

    buf_str(out, "[options]\nstate_vector \"joint.sv\"\ntime e0 1 ms\n\n[start]\n");
    buf_printf(out, "e0 = %" PRIu64 "\n", start_g);
    for (uint32_t e = 1; e < shareds; e++)
        if (shared[e].start)
            buf_printf(out, "e%u = %" PRIu64 "\n", (unsigned)e, shared[e].start);
    for (uint32_t x = 0; x < executors; x++) {
        buf_printf(out, "\n[x%u]\n", (unsigned)x);
        for (uint32_t r = 0; r < executor[x].groups; r++) {
            const Group *g = &executor[x].group[r];
            buf_printf(out, "every %" PRIu64 " us:\n", g->period / 1000);
            if (for_runtime && x == 0 && r == 0)
                buf_str(out, "    task player\n");
            else if (g->machines == 0)
                buf_printf(out, "    task t%u\n", (unsigned)tasks++);
            for (uint32_t k = 0; k < g->machines; k++) {
                const One *m = g->machine[k];
                buf_printf(out, "    machine m%u \"m%u.sm\" {\n", (unsigned)(m - one), (unsigned)(m - one));
                for (size_t v = 0; v < m->p->var.n; v++)
                    if (m->p->var.at[v]->kind == VAR_ELEMENT)
                        buf_printf(out, "        %s = e%u\n", m->p->var.at[v]->name->text, (unsigned)m->element[v]);
                buf_printf(out, "    }%s @state %s", (m - one) % 2 ? " @bytecode" : "", m->p->state.at[m->initial - 1]->name->text);
                if (m->mode)
                    buf_printf(out, " @mode e%u", (unsigned)m->mode);
                buf_char(out, '\n');
            }
        }
    }
}

static void print_sv(Buf *out)
{
    buf_str(out, "[options]\nlock\n[A]\n");
    for (uint32_t e = 0; e < shareds; e++)
        buf_printf(out, "%s e%u\n", sm_type_info[shared[e].type].spelling, (unsigned)e);
}

static void print_script(Buf *out)
{
    buf_str(out, "[local]\n");
    for (uint32_t i = 0; i < counters; i++)
        buf_printf(out, "U32 ran%u = 0\n", (unsigned)i);
    buf_str(out, "U32 ticks = 0\n");
    for (uint32_t i = 0; i < counters; i++) {
        const unsigned k = (unsigned)(counter[i].machine - one);
        buf_printf(out, "[m%u.%s]\ntrue: ran%u = ran%u + 1\n", k, counter[i].machine->p->state.at[counter[i].state - 1]->name->text, (unsigned)i, (unsigned)i);
    }
    buf_str(out, "[all_states]\ntrue: ticks = ticks + 1\n");
    for (uint32_t i = 0; i < inputs; i++) {
        const Input *in = &input[i];
        buf_printf(out, "G == %" PRIu64 ": ", in->g);
        if (in->machine)
            buf_printf(out, "m%u.%s", (unsigned)(in->machine - one), in->local->name->text);
        else
            buf_printf(out, "e%u", (unsigned)in->shared);
        buf_printf(out, " = %d / 2\n", in->value);
    }
    buf_printf(out, "ticks == %u: @assert true\nticks == %u: @stop\n", (unsigned)TICKS, (unsigned)TICKS);
}

// ---- the reference ----

static bool is_enabled(const One *m) { return m->mode == 0 || shared[m->mode].cell == ENABLED; }

static void reference_init(void)
{
    now_tick = 0;
    for (uint32_t e = 0; e < shareds; e++)
        shared[e].cell = ref_convert(shared[e].type, (double)shared[e].start);
    shared[0].cell = start_g;
    for (uint32_t k = 0; k < ones; k++) {
        One *m = &one[k];
        m->writes = 0;
        m->engine->init(m->engine, m->initial, &m->answer);
        shared[m->element[m->p->s->index]].cell = m->initial;
    }
}

static void reference_step(One *m)
{
    EngineWrite all[3 * GEN_VARS_MAX];
    uint32_t n = 0;

    if (!is_enabled(m)) {
        met.disabled++;
        return;
    }
    for (size_t v = 0; v < m->p->var.n; v++)
        if (m->p->var.at[v]->kind == VAR_ELEMENT)
            all[n++] = (EngineWrite){(uint32_t)v, shared[m->element[v]].cell};
    memcpy(all + n, m->write, m->writes * sizeof *all);
    n += m->writes;
    m->writes = 0;
    if (m->engine->step(m->engine, all, n, &m->answer) != ENGINE_OK)
        difference = "the reference refused a step";
    met.ran++;
    met.transitions += m->answer.next_is_first;
    for (size_t v = 0; v < m->p->var.n; v++)
        if (m->p->var.at[v]->kind == VAR_ELEMENT && m->answer.stored[v])
            shared[m->element[v]].cell = m->answer.cell[v];
}

static void write_inputs(uint64_t g)
{
    for (uint32_t i = 0; i < inputs; i++) {
        const Input *in = &input[i];
        const double x = in->value / 2.0;
        if (in->g != g)
            continue;
        if (!in->machine) {
            shared[in->shared].cell = ref_convert(shared[in->shared].type, x);
            flat_write_element(shared[in->shared].name, shared[in->shared].cell);
        } else {
            One *m = in->machine;
            const EngineWrite w = {in->local->index, ref_convert(in->local->type, x)};
            m->answer.cell[w.var] = w.cell;
            flat_write_local(m, in->local, w.cell);
            if (m->writes == 2 * GEN_VARS_MAX)
                memmove(m->write, m->write + 1, --m->writes * sizeof *m->write);
            m->write[m->writes++] = w;
        }
    }
}

static bool is_due(const One *m) { return now_tick * tick_ns % m->period == 0; }

// Runs one tick.
static void reference_tick(void)
{
    const uint64_t g = g_at(now_tick);

    shared[0].cell = g;
    for (uint32_t k = 0; k < ones; k++)
        one[k].counts = is_due(&one[k]) && is_enabled(&one[k]);
    for (uint32_t i = 0; i < counters; i++)
        counter[i].ran += counter[i].machine->counts && counter[i].machine->answer.next_state == counter[i].state;
    write_inputs(g);
    flat_write_element(shared[0].name, g);
    for (uint32_t x = 0; x < executors; x++)
        for (uint32_t r = 0; r < executor[x].groups; r++)
            for (uint32_t k = 0; k < executor[x].group[r].machines; k++)
                if (is_due(executor[x].group[r].machine[k]))
                    reference_step(executor[x].group[r].machine[k]);
    now_tick++;
}

// ---- comparing ----

// Runs a tick of each flat machine, and compares its elements with those of the reference.
static void compare_flats(void)
{
    for (uint32_t i = 0; i < flats && !difference; i++) {
        const FlatOne *x = &flat[i];
        if (!flat_step(x->f, x->run))
            difference = "a flat machine refused a tick";
        for (size_t v = 0; v < x->view->p->var.n && x->is_compared; v++) {
            const Var *var = x->view->p->var.at[v];
            for (uint32_t e = 0; e < shareds && var->kind == VAR_ELEMENT; e++)
                if (!difference && strcmp(shared[e].name, var->element->name->text) == 0 && *flat_cell(x, var) != shared[e].cell)
                    difference = format_in(&arena, "%s of flat machine %u after tick %" PRIu64 ": %" PRIx64 ", wanted %" PRIx64, shared[e].name,
                                           (unsigned)i, now_tick, *flat_cell(x, var), shared[e].cell);
        }
        flat_ticks += x->is_compared;
    }
}

typedef struct Comparison { StrPool *strings; const Program *p; const Script *script; } Comparison;

static void expect_cell(const Comparison *c, const uint64_t *cell, const char *name, uint64_t wanted)
{
    const Var *v = map_find(&c->p->by_name, str_c(c->strings, name));

    if (!difference && (!v || cell[v->index] != wanted))
        difference = format_in(&arena, "%s after tick %" PRIu64 ": %" PRIx64 ", wanted %" PRIx64, name, now_tick, v ? cell[v->index] : 0, wanted);
}

static void compare_tick(void *context, const ScriptStep *step)
{
    const Comparison *c = context;

    reference_tick();
    compare_flats();
    for (uint32_t e = 0; e < shareds; e++)
        expect_cell(c, step->cell, shared[e].name, shared[e].cell);
    for (uint32_t k = 0; k < ones; k++)
        for (size_t v = 0; v < one[k].p->var.n; v++)
            if (one[k].p->var.at[v]->kind != VAR_ELEMENT)
                expect_cell(c, step->cell, format_in(&arena, "m%u.%s", (unsigned)k, one[k].p->var.at[v]->name->text), one[k].answer.cell[v]);
    for (uint32_t i = 0; i < counters && !difference; i++)
        if (step->cell[c->script->local.at[i]->index] != counter[i].ran)
            difference = format_in(&arena, "section %u has run %" PRIu64 " times, wanted %" PRIu64, (unsigned)i,
                                   step->cell[c->script->local.at[i]->index], counter[i].ran);
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
    Buf text;

    if (f->kind == FILE_SV)
        return source(s, name, print_sv);
    buf_init(&text, &s->arena);
    gen_print_sm(one[name[1] - '0'].g, &text);
    return source_new(&s->arena, name, buf_text(&text), text.n);
}

// Opens the VM for each machine, and joins them.
static Engine *open_vm(Session *s, const Program *p)
{
    Engine *machine[MACHINES];
    const char *error;

    for (size_t i = 0; i < engine_machines(p); i++)
        if ((machine[i] = session_open_vm(s, p->joint->member.at[i].program, 2, false, &error)) == NULL)
            return NULL;
    return engine_app_open(&s->arena, p, machine);
}

// Compiles the application and its script, and runs it. Returns false if it does not compile.
static bool run_application(void)
{
    Session s;
    CompileSource at[2];
    CompileApp app;
    CompileInput in = {.at = at, .n = 2, .app = &app};
    CompileOptions o = {.skip_analyses = true};
    Compiled made;
    Engine *engine[2];
    bool good;

    session_init(&s, heap_alloc, NULL, &out_of_memory);
    memset(at, 0, sizeof at);
    at[0] = (CompileSource){.text = source(&s, "joint.app", print_app), .kind = FILE_APP};
    at[1] = (CompileSource){.text = source(&s, "joint.ss", print_script), .kind = FILE_SS};
    compile_open_app(&s, at[0].text, &app);
    for (size_t i = 0; i < app.files.n; i++)
        app.files.at[i].src = find_source(&s, &app.files.at[i]);
    good = compile_sources(&s, &in, &o, &made);
    if (good) {
        Comparison c = {&s.strings, made.of[0].scripted, made.of[1].script};
        const ScriptOptions run = {.max_steps = 10 * TICKS, .after_step = compare_tick, .context = &c};
        ScriptResult r;
        engine[0] = engine_ref_open(&s.arena, c.p);
        engine[1] = open_vm(&s, c.p);
        reference_init();
        flat_begin(&s.arena, c.p);
        r = script_run(&s.arena, &s.diags, c.script, engine, 2, &run);
        if (!difference && r.outcome != SCRIPT_PASSED)
            difference = format_in(&arena, "the script ended with outcome %d: %s", (int)r.outcome, r.difference ? r.difference : "");
        if (!difference && r.steps != TICKS)
            difference = "the script had another number of ticks";
        engine[1]->close(engine[1]);
    } else {
        const DiagStyle style = {false, 5};
        Buf text;
        buf_init(&text, &arena);
        diags_render_text(&s.diags, &style, &text);
        difference = buf_text(&text);
    }
    session_free(&s);
    return good;
}

// ---- for the simulation ----

static void write_file(const char *folder, const char *name, const Buf *text)
{
    const char *path = format_in(&arena, "%s/%s", folder, name);
    FILE *f = fopen(path, "wb");

    if (!f || fwrite(text->at, 1, text->n, f) != text->n || fclose(f) != 0) {
        fprintf(stderr, "cannot write %s\n", path);
        exit(3);
    }
}

// The player writes the script's inputs. After the last tick it prints all elements, before anything else of the next tick, and stops.
static void print_player(Buf *out)
{
    buf_str(out, "#include <inttypes.h>\n#include <stdio.h>\n#include <string.h>\n#include \"joint_app.h\"\n#include \"stdlib/convert.h\"\n\n"
                 "static void put(unsigned e, uint64_t cell)\n{\n    const SmElement *x = &joint_element[e];\n"
                 "    sm_cell_store(x->type, (uint8_t *)joint_vector.at + x->offset, cell);\n}\n\n"
                 "static uint64_t get(unsigned e)\n{\n    const SmElement *x = &joint_element[e];\n"
                 "    return sm_cell_load(x->type, (const uint8_t *)joint_vector.at + x->offset);\n}\n\n"
                 "SmResult player_step(const SmTick *tick)\n{\n    const uint64_t g = get(0);\n\n");
    buf_printf(out, "    if (tick->number == %u) {\n        for (unsigned e = 1; e < %u; e++)\n"
                    "            printf(\"e%%u %%\" PRIx64 \"\\n\", e, get(e));\n        sm_app_stop(&joint_app);\n    }\n"
                    "    if (tick->number >= %u)\n        return SM_OK;\n", (unsigned)TICKS, (unsigned)shareds, (unsigned)TICKS);
    for (uint32_t i = 0; i < inputs; i++)
        buf_printf(out, "    if (g == %" PRIu64 "u)\n        put(%u, 0x%" PRIx64 "u);\n", input[i].g, (unsigned)input[i].shared,
                   ref_convert(shared[input[i].shared].type, input[i].value / 2.0));
    buf_str(out, "    return SM_OK;\n}\n");
    for (uint32_t x = 0, tasks = 0; x < executors; x++) {
        for (uint32_t r = 0; r < executor[x].groups; r++)
            if (executor[x].group[r].machines == 0 && !(x == 0 && r == 0))
                buf_printf(out, "SmResult t%u_step(const SmTick *tick)\n{\n    (void)tick;\n    return SM_OK;\n}\n", (unsigned)tasks++);
    }
}

static void write_application(const char *folder)
{
    static const struct { const char *name; void (*print)(Buf *out); } file[] = {
        {"joint.app", print_app}, {"joint.sv", print_sv}, {"joint.ss", print_script}, {"player.c", print_player}};
    Buf text;

    for (size_t i = 0; i < sizeof file / sizeof *file; i++) {
        buf_init(&text, &arena);
        file[i].print(&text);
        write_file(folder, file[i].name, &text);
    }
    for (uint32_t k = 0; k < ones; k++) {
        buf_init(&text, &arena);
        gen_print_sm(one[k].g, &text);
        write_file(folder, format_in(&arena, "m%u.sm", (unsigned)k), &text);
    }
    buf_init(&text, &arena);
    for (uint32_t e = 1; e < shareds; e++)
        buf_printf(&text, "e%u %" PRIx64 "\n", (unsigned)e, shared[e].cell);
    write_file(folder, "expected.txt", &text);
}

// ---- all of them ----

static void test_one(uint64_t seed, const char *folder)
{
    diff_arena_init(&arena);
    rng.state = rng_mix(seed, 71);
    shareds = 0;
    add_shared(SM_U64, true);
    ones = 2 + rng_below(&rng, MACHINES - 1);
    difference = NULL;
    for (uint32_t k = 0; k < ones; k++)
        add_machine(k);
    for_runtime = folder != NULL;
    plan_executors();
    plan_inputs();
    run_application();
    if (difference) {
        Buf text;
        buf_init(&text, &arena);
        print_app(&text);
        fprintf(stderr, "seed %" PRIu64 ": %s\n%s", seed, difference, buf_text(&text));
    } else if (folder) {
        write_application(folder);
    }
    test_count(difference == NULL, "an application");
    met.applications += difference == NULL;
    for (uint32_t k = 0; k < ones; k++)
        subject_free(&one[k].subject);
    arena_free(&arena);
}

int main(int argc, char **argv)
{
    const uint64_t seed = argc > 1 ? strtoull(argv[1], NULL, 10) : 1, count = argc > 2 ? strtoull(argv[2], NULL, 10) : 100;

    for (uint64_t i = 0; i < count; i++)
        test_one(seed + i, argc > 3 ? argv[3] : NULL);
    if (argc > 3)
        return difference != NULL;

    printf("%u of %" PRIu64 " applications, %u steps, %u transitions, %u disabled steps, %u shared elements, %u with fractions, %u with executors, %u "
           "modes, %u written locals, %" PRIu64 " ticks of flat machines\n", met.applications, count, met.ran, met.transitions, met.disabled,
           met.shared, met.fractions, met.executors, met.modes, met.locals, flat_ticks);
    CHECK(met.applications == count);
    CHECK(count < 50 || (met.transitions > count && met.disabled > count && met.shared > count && met.fractions > count / 20 && met.executors > count / 3 &&
                         met.modes > count / 3 && met.locals > count && flat_ticks > 15 * count));
    return test_end("joint/random");
}
