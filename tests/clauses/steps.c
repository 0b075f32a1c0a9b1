// SPDX-License-Identifier: Apache-2.0
// Clauses of docs/language.md that a state script cannot test, because it always advances time and stores no NaN.  They are tested on every
// engine through engine.h.  A comment names the clause that each part tests.
#include <stdlib.h>
#include <string.h>

#include "compiler/device/engine_c.h"
#include "compiler/compile.h"
#include "tests/heap.h"
#include "tests/test.h"

static const char machine[] =
    "[options]\nstep 10 ms\n"
    "[state_vector]\nU64 time @alias G\nU32 mode @alias S\nF64 x\nF64 y\nF32 f\nF64 high\nF64 entries\nF64 seen\nbool inA\nU8 same\nbool never\n"
    "F64 before\nF64 speed\nbool long\nbool often\n"
    "[local]\nU32 n = 5\n"
    "[A]\n.entry\n    entries = entries + 1\n"
    ".step\n    n = n + 1\n    high = roll_max(x, 3)\n    y = 1 / x + 1 / f\n    same = 7\n    seen = S\n    inA = S == A\n"
    "    before = prev(x)\n    speed = rate(x, 2)\n    long = held(x < 40, 10 ms)\n    often = held(x < 40, 2 steps)\n"
    "    if x == 99: never = true\n    if x == 5: -> B\n"
    "[B]\n.step\n    seen = S\n    if x == 6: -> A\n";

typedef struct Rig {
    Session s;
    Program *p;
    Engine *e;
    EngineStep out;
} Rig;

static const char *const names[] = {"ref", "vm", "c"};

static bool open_engine(Rig *r, const char *name)
{
    IrMachine *ir = session_ir(&r->s, r->p, 2);
    Buf image;
    ImageOptions options = {true, NULL};          // locals are compared by name
    const char *error = NULL;

    if (strcmp(name, "ref") == 0)
        r->e = engine_ref_open(&r->s.arena, r->p);
    else if (strcmp(name, "c") == 0)
        r->e = engine_c_open(&r->s.arena, r->p, ir, false, &error);
    else {
        buf_init(&image, &r->s.arena);
        if (session_image(&r->s, &ir, 1, &options, &image))
            r->e = engine_vm_open(&r->s.arena, r->p, (const uint8_t *)image.at, image.n, 0, &error);
    }
    if (!r->e)
        fprintf(stderr, "%s: %s\n", name, error ? error : "cannot be opened");
    return r->e != NULL;
}

static bool set_up(Rig *r, const char *name, jmp_buf *oom)
{
    MachineInput in = {0};

    memset(r, 0, sizeof *r);
    session_init(&r->s, heap_alloc, NULL, oom);
    in.sm = source_new(&r->s.arena, "app.sm", machine, strlen(machine));
    r->p = session_program(&r->s, &in);
    if (!r->p || !open_engine(r, name))
        return false;
    engine_step_init(&r->out, &r->s.arena, r->p);
    return r->e->init(r->e, 1, &r->out) == ENGINE_OK;
}

static const Var *var(const Rig *r, const char *name)
{
    for (size_t i = 0; i < r->p->var.n; i++)
        if (strcmp(r->p->var.at[i]->name->text, name) == 0)
            return r->p->var.at[i];
    abort();
}

static uint64_t cell(const Rig *r, const char *name) { return r->out.cell[var(r, name)->index]; }
static bool stored(const Rig *r, const char *name) { return r->out.stored[var(r, name)->index] != 0; }

static double number(const Rig *r, const char *name)
{
    uint64_t bits = cell(r, name);
    double x;

    memcpy(&x, &bits, sizeof x);
    return x;
}

static uint64_t bits_of(double x)
{
    uint64_t bits;

    memcpy(&bits, &x, sizeof bits);
    return bits;
}

// Runs a step at time g, after writing one element.
static EngineStatus step(Rig *r, uint64_t g, const char *name, uint64_t value)
{
    EngineWrite write[2] = {{var(r, "time")->index, g}, {var(r, name)->index, value}};

    return r->e->step(r->e, write, 2, &r->out);
}

static EngineStatus step_x(Rig *r, uint64_t g, double x) { return step(r, g, "x", bits_of(x)); }

// clause 6.1, clause 6.2: starting stores the state's number and makes T 0; no step has run.
static void test_start(Rig *r)
{
    CHECK(r->e->init(r->e, 2, &r->out) == ENGINE_OK);
    CHECK(cell(r, "mode") == 2 && cell(r, "T") == 0 && cell(r, "n") == 5 && r->out.next_state == 2);
    CHECK(number(r, "entries") == 0);
    CHECK(r->e->init(r->e, 1, &r->out) == ENGINE_OK);
    CHECK(cell(r, "mode") == 1 && r->out.next_state == 1);
}

// Checks the values that a refused step must not change, and that a step changes.
static void expect_values(const Rig *r, uint64_t t, uint64_t n, double high, double entries)
{
    CHECK(cell(r, "T") == t);
    CHECK(cell(r, "n") == n);
    CHECK(number(r, "high") == high);
    CHECK(number(r, "entries") == entries);
}

// clause 6.3: a step whose time has not advanced is refused and changes nothing, not even windows.
static void test_step_without_progress_is_refused(Rig *r)
{
    const uint64_t last = UINT64_MAX;

    CHECK(step_x(r, last, 50) == ENGINE_REFUSED);             // refused even if it is a first step
    expect_values(r, 0, 5, 0, 0);
    CHECK(step_x(r, 0, 1) == ENGINE_OK);                      // 0 is a valid time
    expect_values(r, 0, 6, 1, 1);
    CHECK(step_x(r, 0, 60) == ENGINE_REFUSED);
    CHECK(step_x(r, last, 60) == ENGINE_REFUSED);             // a refused step does not count as a step that ran
    expect_values(r, 0, 6, 1, 1);
    CHECK(step_x(r, 10, 2) == ENGINE_OK);
    expect_values(r, 10, 7, 2, 1);
    CHECK(step_x(r, 10, 70) == ENGINE_REFUSED);
    CHECK(step_x(r, 9, 70) == ENGINE_REFUSED);
    CHECK(step_x(r, 10, 70) == ENGINE_REFUSED);               // the step at 9 was refused: 10 is still the last time
    expect_values(r, 10, 7, 2, 1);
    CHECK(step_x(r, 11, 1) == ENGINE_OK);
    expect_values(r, 11, 8, 2, 1);
    CHECK(step_x(r, last - 1, 1) == ENGINE_OK);
    expect_values(r, last - 1, 9, 2, 1);
    CHECK(step_x(r, last, 1) == ENGINE_REFUSED);
    expect_values(r, last - 1, 9, 2, 1);
}

static void expect_remembered(const Rig *r, double before, double speed, bool held)
{
    CHECK(number(r, "before") == before);
    CHECK(number(r, "speed") == speed);
    CHECK(cell(r, "long") == held && cell(r, "often") == held);
}

// clause 6.3: prev, rate and held take no sample in a refused step.
static void test_refused_step_takes_no_sample(Rig *r)
{
    CHECK(step_x(r, 0, 1) == ENGINE_OK);
    expect_remembered(r, 1, 0, false);
    CHECK(step_x(r, 0, 60) == ENGINE_REFUSED);
    CHECK(step_x(r, 10, 2) == ENGINE_OK);
    expect_remembered(r, 1, 100, true);
    CHECK(step_x(r, 10, 70) == ENGINE_REFUSED);
    CHECK(step_x(r, 9, 70) == ENGINE_REFUSED);
    expect_remembered(r, 1, 100, true);
    CHECK(step_x(r, 20, 4) == ENGINE_OK);
    expect_remembered(r, 2, 200, true);
}

// clause 7.33: the run of held begins again where G advances by more than two steps, even by one unit more.
static void test_gap_is_more_than_two_steps(Rig *r)
{
    CHECK(step_x(r, 0, 1) == ENGINE_OK);
    CHECK(step_x(r, 20, 2) == ENGINE_OK);
    expect_remembered(r, 1, 50, true);
    CHECK(step_x(r, 41, 42) == ENGINE_OK);
    expect_remembered(r, 2, 40 / 0.021, false);               // x < 40 is false
    CHECK(step_x(r, 42, 1) == ENGINE_OK);
    CHECK(step_x(r, 62, 1) == ENGINE_OK);
    expect_remembered(r, 1, 0, true);
    CHECK(step_x(r, 83, 1) == ENGINE_OK);                     // a gap of 21
    expect_remembered(r, 1, 0, false);
    CHECK(step_x(r, 92, 1) == ENGINE_OK);
    CHECK(cell(r, "long") == 0 && cell(r, "often") == 1);     // true since 83
    CHECK(step_x(r, 93, 1) == ENGINE_OK);
    expect_remembered(r, 1, 0, true);
}

// clause 6.3, clause 6.5: a refused step before a state's first step does not affect it.
static void test_refusal_before_a_first_step(Rig *r)
{
    CHECK(step_x(r, 100, 5) == ENGINE_OK);
    CHECK(r->out.next_state == 2 && cell(r, "mode") == 1);
    CHECK(step_x(r, 100, 6) == ENGINE_REFUSED);
    CHECK(r->out.next_state == 2 && cell(r, "mode") == 1);
    CHECK(step_x(r, 130, 6) == ENGINE_OK);
    CHECK(cell(r, "mode") == 2 && cell(r, "T") == 0 && r->out.next_state == 1);
    CHECK(step_x(r, 131, 0) == ENGINE_OK);
    CHECK(number(r, "entries") == 2 && cell(r, "T") == 0);
    CHECK(step_x(r, 151, 0) == ENGINE_OK);
    CHECK(cell(r, "T") == 20);
}

// clause 6.16: an element counts as stored when an assignment to it ran, whether or not its value changed; S at a first step.
static void test_stored_elements_are_reported(Rig *r)
{
    CHECK(step_x(r, 0, 1) == ENGINE_OK);
    CHECK(stored(r, "mode") && stored(r, "y") && stored(r, "high") && stored(r, "same") && stored(r, "entries"));
    CHECK(!stored(r, "x") && !stored(r, "never") && !stored(r, "f") && !stored(r, "time"));
    CHECK(step_x(r, 1, 1) == ENGINE_OK);
    CHECK(stored(r, "same") && stored(r, "seen") && stored(r, "y"));
    CHECK(!stored(r, "mode") && !stored(r, "entries") && !stored(r, "never"));
    CHECK(step_x(r, 2, 99) == ENGINE_OK);
    CHECK(stored(r, "never") && cell(r, "never") == 1);
}

// clause 6.17: a number stored in S from outside is read unchanged, and has no effect on the state.
static void test_stored_S_does_not_change_the_state(Rig *r)
{
    CHECK(step_x(r, 0, 1) == ENGINE_OK && cell(r, "inA") == 1);
    CHECK(step(r, 1, "mode", 2) == ENGINE_OK);
    CHECK(number(r, "seen") == 2 && cell(r, "n") == 7 && r->out.next_state == 1 && cell(r, "mode") == 2);
    CHECK(cell(r, "inA") == 0);                               // clause 3.33: the comparison with a state's name reads that number
    CHECK(step_x(r, 2, 5) == ENGINE_OK && r->out.next_state == 2);
    CHECK(step(r, 3, "mode", 77) == ENGINE_OK);
    CHECK(cell(r, "mode") == 2 && number(r, "seen") == 2);    // a first step stores it again
}

// clause 2.5: a NaN of any sign and payload that other code has stored reads as +0, also where a window samples.
static void test_nan_reads_as_zero(Rig *r)
{
    static const uint64_t nan64[] = {0x7ff8000000000000, 0xfff8000000000000, 0x7ff0000000000001, 0xffffffffffffffff};
    static const uint64_t nan32[] = {0x7fc00000, 0xffc00000, 0x7f800001, 0xffffffff};
    const double infinity = 1e308 * 10;

    CHECK(step(r, 0, "f", 0x3f800000) == ENGINE_OK);
    for (uint64_t i = 0; i < 4; i++) {
        CHECK(step(r, 1 + i, "x", nan64[i]) == ENGINE_OK);
        CHECK(number(r, "y") == infinity && number(r, "high") == 0);
    }
    CHECK(step_x(r, 10, 1) == ENGINE_OK);
    CHECK(number(r, "y") == 2);
    for (uint64_t i = 0; i < 4; i++) {
        CHECK(step(r, 11 + i, "f", nan32[i]) == ENGINE_OK);
        CHECK(number(r, "y") == infinity);
    }
}

static void run(const char *name, void (*part)(Rig *r))
{
    jmp_buf oom;
    Rig r;

    if (setjmp(oom)) {
        CHECK(!"memory");
        return;
    }
    if (set_up(&r, name, &oom))
        part(&r);
    else
        CHECK(!"an engine");
    if (r.e)
        r.e->close(r.e);
    session_free(&r.s);
}

int main(void)
{
    static void (*const parts[])(Rig *r) = {
        test_start, test_step_without_progress_is_refused, test_refused_step_takes_no_sample, test_refusal_before_a_first_step,
        test_gap_is_more_than_two_steps, test_stored_elements_are_reported, test_stored_S_does_not_change_the_state, test_nan_reads_as_zero};

    for (size_t e = 0; e < sizeof names / sizeof *names; e++)
        for (size_t i = 0; i < sizeof parts / sizeof *parts; i++)
            run(names[e], parts[i]);
    return test_end("clauses: steps");
}
