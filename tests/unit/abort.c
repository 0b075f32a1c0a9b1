// SPDX-License-Identifier: Apache-2.0
// The abort matrix: the paths to an abort, their times, the inputs that they depend on, and what the ability to abort depends on.
#include <string.h>

#include "compiler/analysis/abort.h"
#include "compiler/compile.h"
#include "tests/test.h"
#include "tests/unit/host.h"

static const char machine[] =
    "[state_vector]\nU64 G\nU32 S\nF32 pressure @read_only @range 1 40\nF64 thrust @read_only\nbool kill @read_only\nbool valve\n"
    "[local]\nF64 mean = 0\n"
    "[Idle]\n.step\n kill: -> Abort\n thrust > 5 and T > 10: -> Fill\n"                                   // 1
    "[Fill]\n.step\n mean = roll_avg(pressure, 5)\n mean > 40 or kill: -> Shut\n pressure > 30: -> Burn\n T > 9: -> Vent\n"   // 2
    "[Burn]\n.entry\n valve = true\n.step\n valve { pressure > 38: -> Abort }\n T > 100: -> Coast\n"                             // 3
    "[Coast]\n.step\n T > 100: -> Vent\n thrust > 1e9: -> Loop\n"                                         // 4
    "[Vent]\n.step\n T > 100: -> Abort\n"                                                                 // 5
    "[Shut]\n.step\n thrust > 0: -> Close\n else: -> Abort\n"                                             // 6
    "[Close]\n.entry\n valve = false\n -> Abort\n"                                                        // 7
    "[Loop]\n.step\n -> Loop2\n"                                                                          // 8
    "[Loop2]\n.step\n -> Loop\n"                                                                          // 9
    "[Lost]\n.step\n kill: -> Abort\n"                                                                    // 10
    "[Abort] @abort\n.step\n T > 5: -> Idle\n";                                                           // 11

static Analysis analyse(Session *s, const char *text)
{
    MachineInput in = {0};
    Analysis a;

    session_init(s, heap_alloc, NULL, &host_oom);
    in.sm = source_new(&s->arena, "m.sm", text, strlen(text));
    analysis_begin(&a, &s->arena, &s->diags, session_program(s, &in));
    return a;
}

static bool is_path(const AbortRow *r, size_t w, const char *guard, uint32_t steps)
{
    return w < r->path.n && strcmp(r->path.at[w].guard, guard) == 0 && r->path.at[w].steps == steps;
}

static bool depends_on(const AbortPath *w, const char *sensors, bool time, bool input)
{
    char text[64] = "";

    for (size_t i = 0; i < w->sensors; i++)
        strcat(strcat(text, w->sensor[i]->name->text), " ");
    return strcmp(text, sensors) == 0 && w->by_time == time && w->by_input == input;
}

static void test_paths(const AbortMatrix *x)
{
    const AbortRow *r = x->row;

    CHECK(x->declared && x->n == 11);
    CHECK(r[0].path.n == 1 && is_path(&r[0], 0, "kill", 1));                      // Fill is not bound for an @abort state
    CHECK(r[1].path.n == 2 && is_path(&r[1], 0, "mean > 40 or kill", 3) && is_path(&r[1], 1, "T > 9", ABORT_NOT_BOUNDED));
    CHECK(r[2].path.n == 1 && is_path(&r[2], 0, "valve and pressure > 38", 1));
    CHECK(r[3].path.n == 1 && is_path(&r[3], 0, "T > 100", ABORT_NOT_BOUNDED));   // Loop is not bound either
    CHECK(r[5].path.n == 2 && is_path(&r[5], 0, "thrust > 0", 2) && is_path(&r[5], 1, "not (thrust > 0)", 1));
    CHECK(r[6].path.n == 1 && is_path(&r[6], 0, "", 1));
    CHECK(r[7].path.n == 0 && r[8].path.n == 0 && r[10].path.n == 0);
    CHECK(r[1].steps == 3 && r[2].steps == 1 && r[3].steps == 0);
}

static void test_onward(const AbortMatrix *x)
{
    const State *s = x->row[1].path.at[0].first->to;

    CHECK(s->number == 6);
    s = abort_next_state(x, s);
    CHECK(s->number == 7);                          // the longer of the two
    s = abort_next_state(x, s);
    CHECK(s->is_abort && abort_next_state(x, s) == NULL && abort_next_state(x, x->row[7].state) == NULL);
}

static void test_depends_on(const AbortMatrix *x)
{
    CHECK(depends_on(&x->row[0].path.at[0], "", false, true));
    CHECK(depends_on(&x->row[1].path.at[0], "pressure ", false, true));               // through a local and a window
    CHECK(depends_on(&x->row[2].path.at[0], "pressure ", false, false));
    CHECK(depends_on(&x->row[3].path.at[0], "", true, false));
}

static void test_verdicts(const AbortMatrix *x)
{
    static const AbortVerdict verdict[] = {ABORT_BY_COMMAND, ABORT_OK, ABORT_ONE_SENSOR, ABORT_LATER, ABORT_OK, ABORT_OK,
                                           ABORT_OK, ABORT_NO_PATH, ABORT_NO_PATH, ABORT_UNREACHED, ABORT_ITSELF};
    const AbortRow *burn = &x->row[2];

    for (size_t s = 0; s < x->n; s++)
        CHECK(x->row[s].verdict == verdict[s]);
    CHECK(burn->blind && strcmp(burn->blind->name->text, "pressure") == 0 && strcmp(burn->blind_at, "less than 1") == 0);
    CHECK(burn->single == burn->blind && burn->stuck >= 1 && burn->stuck < 38);
    CHECK(!x->row[1].blind && !x->row[1].single);
}

static void test_nothing_declared(void)
{
    Session s;
    Analysis a = analyse(&s, "[state_vector]\nU64 G\nU32 S\nF64 x @read_only\n[A]\n.step\n x > 5: -> B\n[B]\n");
    const AbortMatrix x = abort_build_matrix(trials_of(&a));

    CHECK(!x.declared && x.n == 2 && x.row[0].path.n == 0 && x.row[0].verdict == ABORT_NO_PATH);
    session_free(&s);
}

int main(void)
{
    Session s;
    Analysis a;
    AbortMatrix x;

    host_check(setjmp(host_oom));
    a = analyse(&s, machine);
    x = abort_build_matrix(trials_of(&a));
    test_paths(&x);
    test_onward(&x);
    test_depends_on(&x);
    test_verdicts(&x);
    test_nothing_declared();
    session_free(&s);
    return test_end("abort");
}
