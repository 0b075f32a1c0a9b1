// SPDX-License-Identifier: Apache-2.0
// The recording of a run: a single extreme sample of a long run is preserved, visits and transitions are counted, and memory does not grow.
#include <setjmp.h>
#include <string.h>

#include "compiler/report/trace.h"
#include "compiler/compile.h"
#include "stdlib/convert.h"
#include "tests/test.h"
#include "tests/unit/host.h"

static const char text[] =
    "[state_vector]\nU64 G\nU32 S\nF64 x @read_only\nbool b\n[local]\nF64 fixed = 2 @read_only\nU8 n = 0\n"
    "[A]\n.step\n n = n + 1\n b = x > 5\n x > 5: -> B\n x < -5: -> B\n[B]\n.step\n x < 5: -> A\n T > 100: -> B\n";

typedef struct Fake { Engine engine; const Program *p; uint64_t step; } Fake;

static uint64_t cell_of(double x)
{
    uint64_t bits;

    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static EngineStatus fake_init(Engine *e, uint32_t state, EngineStep *out)
{
    (void)state;
    ((Fake *)e->self)->step = 0;
    return out->status = ENGINE_OK;
}

// Sets x to the number of the step, with one exception.  A and B alternate every thousand steps.  Step 7 is refused.
static EngineStatus fake_step(Engine *e, const EngineWrite *write, uint32_t n, EngineStep *out)
{
    Fake *f = e->self;
    const uint64_t k = f->step++;

    (void)write;
    (void)n;
    out->cell[f->p->g->index] = 10 * k;
    out->cell[f->p->s->index] = 1 + k / 1000 % 2;
    out->cell[f->p->t->index] = k % 1000 * 10;
    out->cell[2] = cell_of(k == 43210 ? -1e6 : (double)k);
    out->cell[3] = k > 90000;
    return k == 7 ? ENGINE_REFUSED : ENGINE_OK;
}

static void fake_close(Engine *e) { ((Fake *)e->self)->step = UINT64_MAX; }

static void run(Engine *e, const Program *p, Arena *arena, uint64_t steps)
{
    EngineStep out;

    engine_step_init(&out, arena, p);
    CHECK(e->init(e, 1, &out) == ENGINE_OK);
    for (uint64_t k = 0; k < steps; k++)
        CHECK(e->step(e, NULL, 0, &out) == (k == 7 ? ENGINE_REFUSED : ENGINE_OK));
    e->close(e);
}

static void check_series(const Trace *t)
{
    const TraceSeries *x = t->series.at[0], *b = t->series.at[1], *n = t->series.at[2];
    const size_t used = trace_buckets(t);
    size_t wild = 0;

    CHECK(t->series.n == 3 && strcmp(x->v->name->text, "x") == 0 && strcmp(n->v->name->text, "n") == 0);
    CHECK(x->changes && b->changes && !n->changes && !x->infinite);
    CHECK(used > TRACE_BUCKETS / 2 && used <= TRACE_BUCKETS);
    for (size_t i = 0; i < used; i++)
        wild += x->at[i].lo == -1e6;
    CHECK(wild == 1);
    CHECK(x->at[0].first == 0 && x->at[used - 1].last == 99999 && x->at[used - 1].hi == 99999);
    CHECK(b->at[0].hi == 0 && b->at[used - 1].lo == 1);
}

static void check_visits(const Trace *t)
{
    CHECK(t->visit.n == 100 && t->visits == 100 && t->visit.at[1].g == 10000 && t->visit.at[1].state->number == 2);
    CHECK(t->entered[0] == 50 && t->entered[1] == 50 && t->spent[0] == 49999 && t->spent[1] == 50000);
    CHECK(t->taken[0] == 50 && t->taken[1] == 0 && t->taken[2] == 49 && t->taken[3] == 0);  // both transitions to B are counted at the first one
    CHECK(t->first_g == 0 && t->last_g == 999990 && t->steps == 99999);
}

int main(void)
{
    MachineInput in = {0};
    Session s;
    Program *p;
    Transitions transitions;
    Fake fake;
    Trace t;

    host_check(setjmp(host_oom));
    session_init(&s, heap_alloc, NULL, &host_oom);
    in.sm = source_new(&s.arena, "m.sm", text, strlen(text));
    p = session_program(&s, &in);
    CHECK(p != NULL);
    if (!p)
        return test_end("report_trace");
    memset(&fake, 0, sizeof fake);
    fake.p = p;
    fake.engine.program = p;
    fake.engine.self = &fake;
    fake.engine.init = fake_init;
    fake.engine.step = fake_step;
    fake.engine.close = fake_close;
    transitions = transitions_of(&s.arena, p);
    trace_init(&t, &s.arena, p, &transitions);
    run(trace_wrap_engine(&t, &fake.engine), p, &s.arena, 100000);
    CHECK(fake.step == UINT64_MAX);
    check_series(&t);
    check_visits(&t);
    CHECK(trace_cell_value(SM_I8, 0xff) == -1 && trace_cell_value(SM_BOOL, 1) == 1 && trace_cell_value(SM_F32, 0x3fc00000) == 1.5);
    session_free(&s);
    return test_end("report_trace");
}
