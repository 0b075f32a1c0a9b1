// SPDX-License-Identifier: Apache-2.0
// Properties of engines and of runs in lock step that scripts cannot test: refused steps, stored elements, engines that fail or differ, the
// largest time, and memory that is refused at any request.
#include <stdlib.h>
#include <string.h>

#include "compiler/compile.h"
#include "tests/test.h"

static long allocations_left = -1;                    // -1: no limit

static void *heap(void *context, void *old, size_t size)
{
    (void)context;
    if (size == 0) {
        free(old);
        return NULL;
    }
    if (allocations_left == 0)
        return NULL;
    if (allocations_left > 0)
        allocations_left--;
    return realloc(old, size);
}

static const char machine[] =
    "[state_vector]\nU64 G\nU32 S\nF64 x\nF64 y\nbool b\n[local]\nU8 n = 3\n"
    "[A]\n.entry\n n = n + 1\n x == 1: -> B\n.step\n y = roll_max(x, 3)\n b = n > 3\n x == 2: -> A\n.exit\n x = 7\n"
    "[B]\n.step\n n = 0\n y = roll_min(0/x, 2)\n";

static const char script[] =
    "[options]\ndelta_t 10\n[all_states]\nG == 30: @stop\nx == 0: @assert y == 0\n";

typedef struct Fixture {
    Session s;
    Program *p;
    Script *script;
    Engine *e;
    EngineStep out;
} Fixture;

static void set_up(Fixture *f, jmp_buf *oom)
{
    MachineInput in = {0};

    session_init(&f->s, heap, NULL, oom);
    in.sm = source_new(&f->s.arena, "app.sm", machine, strlen(machine));
    f->p = session_program(&f->s, &in);
    f->script = session_script(&f->s, source_new(&f->s.arena, "app.ss", script, strlen(script)), f->p);
    f->e = engine_ref_open(&f->s.arena, f->p);
    engine_step_init(&f->out, &f->s.arena, f->p);
}

static uint32_t var(const Fixture *f, const char *name)
{
    for (size_t i = 0; i < f->p->var.n; i++)
        if (strcmp(f->p->var.at[i]->name->text, name) == 0)
            return (uint32_t)i;
    abort();
}

static uint64_t bits(double x) { uint64_t u; memcpy(&u, &x, sizeof u); return u; }
static uint64_t cell(const Fixture *f, const char *name) { return f->out.cell[var(f, name)]; }
static bool stored(const Fixture *f, const char *name) { return f->out.stored[var(f, name)]; }

static EngineStatus step(Fixture *f, uint64_t g, double x)
{
    EngineWrite w[2] = {{var(f, "G"), g}, {var(f, "x"), bits(x)}};

    return f->e->step(f->e, w, 2, &f->out);
}

static void check_steps(Fixture *f)
{
    CHECK(f->e->init(f->e, 1, &f->out) == ENGINE_OK && cell(f, "S") == 1 && cell(f, "n") == 3 && f->out.next_is_first);
    CHECK(step(f, 5, 0) == ENGINE_OK && cell(f, "n") == 4 && cell(f, "T") == 0 && cell(f, "b") == 1 && !f->out.next_is_first);
    CHECK(stored(f, "S") && stored(f, "y") && stored(f, "b") && !stored(f, "x") && !stored(f, "n") && !stored(f, "T"));
    CHECK(step(f, 8, 2) == ENGINE_OK && f->out.next_state == 1 && f->out.next_is_first && cell(f, "x") == bits(7));
    CHECK(!stored(f, "S") && stored(f, "x") && cell(f, "T") == 3 && cell(f, "y") == bits(2));
    CHECK(step(f, 9, 1) == ENGINE_OK && f->out.next_state == 2 && cell(f, "n") == 5 && cell(f, "T") == 0);
    CHECK(stored(f, "S") && !stored(f, "y") && stored(f, "x"));                   // .entry left: no .step, but .exit
    CHECK(step(f, 10, 0) == ENGINE_OK && cell(f, "S") == 2 && cell(f, "n") == 0 && cell(f, "y") == bits(0));
}

static void check_refused(Fixture *f)
{
    uint64_t before = cell(f, "T");

    CHECK(step(f, 10, 3) == ENGINE_REFUSED && step(f, 9, 3) == ENGINE_REFUSED && step(f, 0, 3) == ENGINE_REFUSED);
    CHECK(cell(f, "x") == bits(3) && cell(f, "T") == before && !stored(f, "y") && f->out.next_state == 2);
    CHECK(step(f, UINT64_MAX, 3) == ENGINE_REFUSED && step(f, UINT64_MAX - 1, 3) == ENGINE_OK);
    CHECK(cell(f, "T") == UINT64_MAX - 11 && step(f, UINT64_MAX - 1, 3) == ENGINE_REFUSED);
    CHECK(f->e->init(f->e, 1, &f->out) == ENGINE_OK && !stored(f, "y") && cell(f, "x") == 0);
    CHECK(step(f, UINT64_MAX, 0) == ENGINE_REFUSED && f->out.next_is_first && step(f, 0, -1) == ENGINE_OK);
    CHECK(cell(f, "y") == bits(-1));                                              // windows are empty after init
    CHECK(f->e->init(f->e, 0, &f->out) == ENGINE_BROKEN && f->e->init(f->e, 3, &f->out) == ENGINE_BROKEN && f->e->error);
}

// ---- engines that differ, fail, refuse ----

typedef struct Spoiler {      // an engine that does the same as another engine until its third step
    Engine engine;
    Engine *inner;
    int steps, what;
    uint32_t var;
} Spoiler;

static EngineStatus spoil_init(Engine *e, uint32_t state, EngineStep *out)
{
    Spoiler *s = e->self;
    EngineStatus status = s->inner->init(s->inner, state, out);

    s->steps = 0;
    if (s->what == 6)
        out->next_state = 99;
    return status;
}

static EngineStatus spoil_step(Engine *e, const EngineWrite *write, uint32_t n, EngineStep *out)
{
    Spoiler *s = e->self;
    EngineStatus status = s->inner->step(s->inner, write, n, out);

    if (++s->steps < 3)
        return status;
    switch (s->what) {
    case 0: out->cell[s->var] ^= 1; break;
    case 1: out->next_state = 2; break;
    case 2: out->stored[s->var] ^= 1; break;
    case 3: e->error = "the line is dead"; return ENGINE_BROKEN;
    case 4: return ENGINE_REFUSED;
    case 5: out->next_is_first = true; break;
    case 6: break;
    }
    return status;
}

static void close_nothing(Engine *e) { (void)e; }

static ScriptResult run_spoiled(Fixture *f, int what, bool alone)
{
    Spoiler spoiler = {{"spoiler", f->p, NULL, &spoiler, spoil_init, spoil_step, close_nothing, NULL},
                       engine_ref_open(&f->s.arena, f->p), 0, what, var(f, "y")};
    Engine *both[2] = {f->e, &spoiler.engine};
    ScriptOptions o = {.max_steps = 100};

    return script_run(&f->s.arena, &f->s.diags, f->script, alone ? both + 1 : both, alone ? 1 : 2, &o);
}

static bool ends(Fixture *f, int what, bool alone, ScriptOutcome outcome, const char *text)
{
    ScriptResult r = run_spoiled(f, what, alone);

    return r.outcome == outcome && r.difference && strstr(r.difference, text);
}

static void check_lock_step(Fixture *f)
{
    CHECK(ends(f, 0, false, SCRIPT_DIFFERENT, "y: ref has 0 (bits 0x0000000000000000), spoiler has 5e-324"));
    CHECK(f->s.diags.errors == 1 && strstr(f->s.diags.list.at[0]->text, "the engines differ after step 3: y: ref"));
    CHECK(ends(f, 1, false, SCRIPT_DIFFERENT, "next state: ref goes to A, spoiler to B"));
    CHECK(ends(f, 2, false, SCRIPT_DIFFERENT, "y: ref stored it in this step, spoiler did not"));
    CHECK(ends(f, 3, false, SCRIPT_BROKEN, "the line is dead") && ends(f, 3, true, SCRIPT_BROKEN, "the line is dead"));
    CHECK(ends(f, 4, false, SCRIPT_DIFFERENT, "ref ran it, spoiler refused it"));
    CHECK(ends(f, 4, true, SCRIPT_BROKEN, "refused a step although G advanced"));
    CHECK(ends(f, 5, false, SCRIPT_DIFFERENT, "spoiler makes a transition in this step, ref does not"));
    CHECK(ends(f, 6, true, SCRIPT_BROKEN, "a state that the machine does not have"));
    CHECK(run_spoiled(f, 7, false).outcome == SCRIPT_PASSED);
}

static void check_end_of_time(Fixture *f)
{
    ScriptOptions o = {.max_steps = 100};

    f->script->delta_t = UINT64_MAX / 3;                                          // the third advance would give 2^64-1
    CHECK(script_run(&f->s.arena, &f->s.diags, f->script, &f->e, 1, &o).steps == 3);
    f->script->delta_t = UINT64_MAX / 3 - 1;                                      // and this reaches 2^64-4
    CHECK(script_run(&f->s.arena, &f->s.diags, f->script, &f->e, 1, &o).steps == 4);
    f->script->delta_t = 10;
    CHECK(script_run(&f->s.arena, &f->s.diags, f->script, &f->e, 1, &o).steps == 4);
    o.max_steps = 4;
    CHECK(script_run(&f->s.arena, &f->s.diags, f->script, &f->e, 1, &o).outcome == SCRIPT_PASSED);
    o.max_steps = 3;
    CHECK(script_run(&f->s.arena, &f->s.diags, f->script, &f->e, 1, &o).outcome == SCRIPT_ENDLESS);
}

static int shown;

static void show(void *context, const ScriptStep *step)
{
    shown++;
    CHECK(context == &shown && step->number == (uint64_t)shown && step->g == 10 * (step->number - 1) && step->state->number == 1);
}

static void check_after_step(Fixture *f)
{
    ScriptOptions o = {.max_steps = 100, .after_step = show, .context = &shown};

    script_run(&f->s.arena, &f->s.diags, f->script, &f->e, 1, &o);
    CHECK(shown == 4);
}

static bool run_with(Fixture *f, long allocations)     // returns false when memory ran out
{
    ScriptOptions o = {.max_steps = 100};
    jmp_buf oom;

    memset(f, 0, sizeof *f);
    allocations_left = allocations;
    if (setjmp(oom)) {
        session_free(&f->s);
        return false;
    }
    set_up(f, &oom);
    CHECK(script_run(&f->s.arena, &f->s.diags, f->script, &f->e, 1, &o).outcome == SCRIPT_PASSED);
    session_free(&f->s);
    return true;
}

int main(void)
{
    static Fixture f;
    static long n;            // number of allocations that succeed
    jmp_buf oom;

    if (setjmp(oom))
        return 1;
    set_up(&f, &oom);
    check_steps(&f);
    check_refused(&f);
    check_lock_step(&f);
    check_end_of_time(&f);
    check_after_step(&f);
    session_free(&f.s);
    while (!run_with(&f, n))
        n++;
    allocations_left = -1;
    CHECK(n > 0);
    return test_end("script_run");
}
