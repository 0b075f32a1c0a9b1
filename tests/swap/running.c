// SPDX-License-Identifier: Apache-2.0
// Swaps in a running application: the clauses of docs/swapping.md from 12.21 on, and every point at which a swap can fail.
#include <stdlib.h>
#include <string.h>

#include "tests/swap/stage.h"
#include "tests/test.h"

#include "runtime-c/psl/sim/sim.h"

#define COUNT(by) A "[local]\nU32 n = 0\n[A] @swap\n.step\nn = n + " #by "\nout = n\n"
#define COUNT_B(by) B "[local]\nU32 n = 0\n[A] @swap\n.step\nn = n + " #by "\nmore = n\n"

static SwapMachine one, ten, b_one, b_ten;

static void compile(SwapMachine *m, const char *text) { machine_compile(m, text, STAGE_SV, 2, true); }

static void ticks(unsigned n)
{
    while (n-- > 0)
        stage_tick(0);
}

static void reset_and_begin(const StagePlan *plan)
{
    sim_reset();
    stage_begin(plan);
}

// Begins with only machine `a`.
static void begin(const SwapMachine *a)
{
    const StagePlan plan = {.a = a, .room = STAGE_ROOM};

    reset_and_begin(&plan);
}

// Swaps machine `a` for `to`, and runs until the machines are exchanged or the swap is refused.  Returns the reason of the refusal.
static SmSwapReason swap(const SwapMachine *to, SmSwapMode mode, const char *state)
{
    CHECK(stage_swap("a", to, mode, state) == SM_OK);
    stage_settle();
    return stage_status().reason;
}

// ---- the exchange ----

static void test_exchange(void)
{
    SmEvent e;

    // clause 12.21: between two ticks; clause 12.28: a pointer is exchanged; clause 12.34: the events have both identities
    begin(&one);
    ticks(5);
    CHECK(stage_number(AT_OUT) == 5);
    CHECK(stage_swap("a", &ten, SM_SWAP_CONTINUE, NULL) == SM_OK && stage_phase() == SM_SWAP_PREPARING);
    while (stage_phase() == SM_SWAP_PREPARING)
        CHECK(sm_swaps_prepare(&stage.swaps));
    CHECK(stage_phase() == SM_SWAP_WAITING && !sm_swaps_prepare(&stage.swaps) && stage.machine[0].machine->self == &stage.slot[0][0]);
    ticks(1);
    CHECK(stage_number(AT_OUT) == 6 && stage_phase() == SM_SWAP_TRIAL && stage.machine[0].machine->self == &stage.slot[0][1]);
    ticks(1);
    CHECK(stage_number(AT_OUT) == 16);
    CHECK(stage_events(SM_EVENT_SWAP, &e) == 1 && e.a == stage_identity(&one) && e.b == stage_identity(&ten) && e.source == 0);
    CHECK(e.time == 5 * PAL_MILLISECOND && stage_events(SM_EVENT_STATE, NULL) == 1 && stage_events(SM_EVENT_FAULT, NULL) == 0);
    // clause 12.31
    CHECK(sm_swap_confirm(&stage.swaps) == SM_OK && stage_phase() == SM_SWAP_CONFIRMED && sm_swap_confirm(&stage.swaps) == SM_E_ARGUMENT);
    ticks(200);
    CHECK(stage_number(AT_OUT) == 2016 && stage_events(SM_EVENT_SWAP, NULL) == 1);
    CHECK(stage_events(SM_EVENT_TRIAL, &e) == 1 && e.a == SM_SWAP_WAS_CONFIRMED && e.b == stage_identity(&ten));
    // clause 12.20: a swap back
    CHECK(swap(&one, SM_SWAP_CONTINUE, NULL) == SM_SWAP_NOT_REFUSED && sm_swap_confirm(&stage.swaps) == SM_OK);
    ticks(1);
    CHECK(stage_events(SM_EVENT_SWAP, &e) == 2 && e.a == stage_identity(&ten) && e.b == stage_identity(&one));
    CHECK(stage.machine[0].machine->self == &stage.slot[0][0]);
    const double before = stage_number(AT_OUT);
    ticks(1);
    CHECK(stage_number(AT_OUT) == before + 1);
    // to the same image
    CHECK(swap(&one, SM_SWAP_CONTINUE, NULL) == SM_SWAP_NOT_REFUSED);
    CHECK(stage_events(SM_EVENT_SWAP, &e) == 3 && e.a == e.b);
    ticks(1);
    CHECK(stage_events(SM_EVENT_FAULT, NULL) == 0);
}

static void test_restart(void)
{
    SwapMachine states;
    SmEvent e;

    // clause 12.22: restart in the first state or in a named one; the event STATE has the state in which it starts
    compile(&states, A "[First]\n.step\nout = 1\n[Second]\n.step\nout = 2\n");
    begin(&one);
    ticks(3);
    CHECK(swap(&states, SM_SWAP_RESTART, "Second") == SM_SWAP_NOT_REFUSED && stage_u32(AT_SA) == 2);
    ticks(1);
    CHECK(stage_number(AT_OUT) == 2 && stage_events(SM_EVENT_STATE, &e) == 2 && e.a == 0 && e.b == 2);
    begin(&one);
    ticks(3);
    CHECK(swap(&states, SM_SWAP_RESTART, NULL) == SM_SWAP_NOT_REFUSED && stage_u32(AT_SA) == 1);
    ticks(1);
    CHECK(stage_number(AT_OUT) == 1);
    machine_free(&states);
}

// ---- all or none ----

static void begin_two(bool two_executors, bool guarded)
{
    const StagePlan plan = {.a = &one, .b = &b_one, .room = STAGE_ROOM, .two_executors = two_executors, .guarded = guarded};

    reset_and_begin(&plan);
}

static SmResult swap_two(const SwapMachine *a, const SwapMachine *b)
{
    const SmSwapChange change[] = {{"b", b->image, b->image_size, SM_SWAP_CONTINUE, NULL, false}, {"a", a->image, a->image_size, SM_SWAP_CONTINUE, NULL, false}};

    return sm_swap_begin(&stage.swaps, change, 2);
}

static void test_two_machines(void)
{
    // clause 12.21: all or none
    begin_two(false, false);
    ticks(2);
    CHECK(swap_two(&ten, &b_ten) == SM_OK);
    stage_settle();
    CHECK(stage_phase() == SM_SWAP_TRIAL && stage_events(SM_EVENT_SWAP, NULL) == 2);
    const double a = stage_number(AT_OUT), b = stage_number(AT_MORE);
    ticks(1);
    CHECK(stage_number(AT_OUT) == a + 10 && stage_number(AT_MORE) == b + 10);
    // The image of one of them has no room or is invalid: neither is exchanged.
    begin_two(false, false);
    stage.slot[1][1].size = 8;
    CHECK(swap_two(&ten, &b_ten) == SM_OK);
    stage_settle();
    CHECK(stage_phase() == SM_SWAP_REFUSED && stage_status().reason == SM_SWAP_NO_MEMORY && stage_status().machine == 1);
    CHECK(stage_events(SM_EVENT_SWAP, NULL) == 0 && stage.machine[0].machine->self == &stage.slot[0][0]);
    // One of them cannot continue.
    SwapMachine gone;
    compile(&gone, A "[Other]\n");
    begin_two(false, false);
    CHECK(swap_two(&gone, &b_ten) == SM_OK);
    stage_settle();
    CHECK(stage_phase() == SM_SWAP_REFUSED && stage_status().reason == SM_SWAP_NO_GONE && stage_status().machine == 0);
    CHECK(stage_events(SM_EVENT_SWAP, NULL) == 0);
    machine_free(&gone);
}

// The exchange waits while a step's stores have not yet reached the guarded vector.
static void test_stores_due(void)
{
    unsigned due = 0;

    for (uint32_t after = 0; after < 40; after++) {
        begin_two(false, true);
        ticks(2);
        CHECK(swap_two(&ten, &b_ten) == SM_OK);
        while (sm_swaps_prepare(&stage.swaps)) {}
        sim_fail(SIM_lock_take, after, SM_E_TIMEOUT);
        ticks(1);
        if (stage.machine[0].machine->write_back_due || stage.machine[1].machine->write_back_due) {
            due++;
            CHECK(stage_phase() == SM_SWAP_WAITING);
            ticks(1);
            CHECK(stage_phase() == SM_SWAP_TRIAL && stage_number(AT_OUT) == 4 && stage_number(AT_MORE) == 4);
        }
    }
    CHECK(due == 2);
}

// With two executors, the exchange waits until neither is executing a tick.
static void test_two_executors(void)
{
    begin_two(true, true);
    stage_tick(0);
    stage_tick(1);
    CHECK(swap_two(&ten, &b_ten) == SM_OK);
    while (sm_swaps_prepare(&stage.swaps)) {}
    const SmTick tick = {0, 0};
    CHECK(sm_swap_gate_enter(&stage.gate[1], &tick) == SM_OK);
    for (int i = 0; i < 5; i++)
        stage_tick(0);
    CHECK(stage_phase() == SM_SWAP_WAITING && stage_number(AT_OUT) == 6);
    CHECK(sm_swap_gate_leave(&stage.gate[1], &tick) == SM_OK && stage_phase() == SM_SWAP_TRIAL);
    stage_tick(0);
    stage_tick(1);
    CHECK(stage_number(AT_OUT) == 16 && stage_number(AT_MORE) == 11);
    // clause 12.27: an executor never ends its tick, because its thread has ended
    begin_two(true, true);
    CHECK(sm_swap_gate_enter(&stage.gate[1], &tick) == SM_OK);
    CHECK(swap_two(&ten, &b_ten) == SM_OK);
    stage_settle();
    CHECK(stage_phase() == SM_SWAP_REFUSED && stage_status().reason == SM_SWAP_NO_BOUNDARY);
    CHECK(stage_events(SM_EVENT_SWAP, NULL) == 0);
    // A swap of a machine that the other executor runs does not wait for it.
    CHECK(swap(&ten, SM_SWAP_CONTINUE, NULL) == SM_SWAP_NOT_REFUSED && stage_phase() == SM_SWAP_TRIAL);
}

// ---- writers ----

// The elements that the tests use as those of another part of the application.
static const SmRange only_out[] = {{AT_OUT, 8}}, only_more[] = {{AT_MORE, 8}}, only_sb[] = {{AT_SB, 4}};

// Begins with both machines, in an application where something else stores these elements.
static void begin_both(const SmRange *written, uint16_t n)
{
    begin_two(false, false);
    stage.swaps.written = written;
    stage.swaps.writtens = n;
    ticks(2);
}

// Swaps both machines.  Returns the reason of the refusal, and in *machine which one was refused.
static SmSwapReason swap_both(const SwapMachine *a, const SwapMachine *b, uint16_t *machine)
{
    CHECK(swap_two(a, b) == SM_OK);
    stage_settle();
    *machine = stage_status().machine;
    return stage_status().reason;
}

// clause 12.58: a new machine stores nothing that another part of the application stores
static void test_writers(void)
{
    SwapMachine takes, takes_p, gives, b_takes_p, state;
    uint16_t failed;

    compile(&takes, A "F64 more\n[A] @swap\n.step\nmore = 1\n");
    compile(&takes_p, A "[A] @swap\n.step\np = 1\n");
    compile(&gives, B "[A] @swap\n.step\nif 1 > 2: p = 0\n");
    compile(&b_takes_p, B "[A] @swap\n.step\np = 2\nmore = 3\n");
    compile(&state, "[state_vector]\nU64 time @alias G\nU32 sb @alias S\nF64 out\n[A] @swap\n.step\nout = 1\n");
    begin_both(NULL, 0);
    CHECK(swap(&takes, SM_SWAP_CONTINUE, NULL) == SM_SWAP_NO_WRITER && stage_status().machine == 0);
    CHECK(swap(&state, SM_SWAP_RESTART, NULL) == SM_SWAP_NO_WRITER);            // two machines with the same S
    CHECK(swap(&takes_p, SM_SWAP_CONTINUE, NULL) == SM_SWAP_NOT_REFUSED);       // no one else stores p
    begin_both(NULL, 0);
    CHECK(swap_both(&takes, &gives, &failed) == SM_SWAP_NOT_REFUSED && stage_phase() == SM_SWAP_TRIAL);         // b gives it up
    begin_both(NULL, 0);
    CHECK(swap_both(&takes_p, &b_takes_p, &failed) == SM_SWAP_NO_WRITER && failed == 0);      // both begin to store p
    ticks(3);
    CHECK(stage_number(AT_OUT) >= 5 && stage_number(AT_MORE) == stage_number(AT_OUT));           // both old machines have stepped on
    // inputs, messages and machines that cannot be swapped are in a table; what the old machine stores too is allowed
    begin_both(only_more, 1);
    CHECK(swap_both(&takes, &gives, &failed) == SM_SWAP_NO_WRITER && failed == 0);
    begin_both(only_out, 1);
    CHECK(swap(&ten, SM_SWAP_CONTINUE, NULL) == SM_SWAP_NOT_REFUSED);
    begin_both(only_sb, 1);
    CHECK(swap(&state, SM_SWAP_RESTART, NULL) == SM_SWAP_NO_WRITER);
    machine_free(&takes);
    machine_free(&takes_p);
    machine_free(&gives);
    machine_free(&b_takes_p);
    machine_free(&state);
}

// ---- refusals ----

// Checks that a swap of machine `a` was refused, and that machine `one` continued without change.
static void check_refused(SmSwapReason why)
{
    SmEvent e;
    const double before = stage_number(AT_OUT);

    CHECK(stage_phase() == SM_SWAP_REFUSED);
    CHECK(stage_status().reason == why && *sm_swap_reason_text(why) != '\0');
    CHECK(stage_events(SM_EVENT_SWAP, NULL) == 0 && stage_events(SM_EVENT_FAULT, NULL) == 0);
    if (why != SM_SWAP_NO_MACHINE)
        CHECK(stage_events(SM_EVENT_SWAP_REFUSED, &e) == 1 && e.a == (uint32_t)why && e.source == 0);
    ticks(1);
    CHECK(stage_number(AT_OUT) == before + 1);
}

static void check_refusal(const SwapMachine *to, SmSwapMode mode, const char *state, SmSwapReason why)
{
    begin(&one);
    ticks(2);
    CHECK(swap(to, mode, state) == why);
    check_refused(why);
}

// Compiles an image with two machines.
static SwapMachine two_in_one(void)
{
    const ImageOptions options = {.debug = true};
    IrMachine *both[] = {one.ir, b_one.ir};
    SwapMachine m = one;
    Buf image;

    buf_init(&image, &one.session.arena);
    CHECK(session_image(&one.session, both, 2, &options, &image));
    m.image = (const uint8_t *)image.at;
    m.image_size = (uint32_t)image.n;
    return m;
}

static void test_refusals(void)
{
    SwapMachine other, names, gone, unmarked, slow;

    compile(&gone, A "[B] @swap\n.step\nout = 5\n");
    compile(&unmarked, A "[local]\nU32 n = 0\n[A]\n.step\nn = n + 1\nout = n\n");
    compile(&slow, A "[local]\nU32 n = 0\n[A]\n.step\nn = n + 1\nout = n + sqrt(n) * n + p / 3\nout = out + p * p\n");
    machine_compile(&other, "[state_vector]\nU64 G\nU32 S\nF64 out\n[A]\n", NULL, 2, true);
    machine_compile(&names, COUNT(5), STAGE_SV, 2, false);
    // clause 12.2
    check_refusal(&other, SM_SWAP_RESTART, NULL, SM_SWAP_NO_LAYOUT);
    // clause 12.22: there is no default mode
    check_refusal(&ten, (SmSwapMode)0, NULL, SM_SWAP_NO_MODE);
    check_refusal(&ten, SM_SWAP_RESTART, "Nowhere", SM_SWAP_NO_STATE);
    check_refusal(&ten, SM_SWAP_RESTART, "", SM_SWAP_NO_STATE);
    check_refusal(&gone, SM_SWAP_CONTINUE, NULL, SM_SWAP_NO_GONE);
    check_refusal(&names, SM_SWAP_CONTINUE, NULL, SM_SWAP_NO_NAMES);
    check_refusal(&names, SM_SWAP_RESTART, "A", SM_SWAP_NO_STATE);
    check_refusal(&names, SM_SWAP_RESTART, "", SM_SWAP_NO_STATE);
    begin(&one);
    CHECK(swap(&names, SM_SWAP_RESTART, NULL) == SM_SWAP_NOT_REFUSED && stage_phase() == SM_SWAP_TRIAL);
    // clause 12.24
    const StagePlan plan = {.a = &unmarked, .room = STAGE_ROOM};
    reset_and_begin(&plan);
    ticks(2);
    CHECK(swap(&ten, SM_SWAP_CONTINUE, NULL) == SM_SWAP_NO_UNMARKED);
    check_refused(SM_SWAP_NO_UNMARKED);
    // clause 12.25
    begin(&one);
    stage_arm(true);
    CHECK(swap(&ten, SM_SWAP_CONTINUE, NULL) == SM_SWAP_NO_ARMED);
    check_refused(SM_SWAP_NO_ARMED);
    stage_arm(false);
    CHECK(swap(&ten, SM_SWAP_CONTINUE, NULL) == SM_SWAP_NOT_REFUSED && stage_phase() == SM_SWAP_TRIAL);
    // clause 12.26: the limit for the longest step
    for (uint32_t longest = smvm_longest_step(&one.m); longest <= smvm_longest_step(&slow.m); longest++) {
        const StagePlan limited = {.a = &one, .room = STAGE_ROOM, .longest = longest};
        reset_and_begin(&limited);
        ticks(1);
        CHECK(swap(&slow, SM_SWAP_CONTINUE, NULL) == (longest < smvm_longest_step(&slow.m) ? SM_SWAP_NO_SLOW : SM_SWAP_NOT_REFUSED));
        if (longest < smvm_longest_step(&slow.m))
            check_refused(SM_SWAP_NO_SLOW);
    }
    // clause 12.23: machines that cannot be swapped
    begin(&one);
    CHECK(stage_swap("c", &ten, SM_SWAP_CONTINUE, NULL) == SM_OK);
    ticks(2);
    check_refused(SM_SWAP_NO_MACHINE);
    CHECK(stage_swap(NULL, &ten, SM_SWAP_CONTINUE, NULL) == SM_OK);
    ticks(2);
    check_refused(SM_SWAP_NO_MACHINE);
    begin(&one);
    const SmSwapChange twice[] = {{"a", ten.image, ten.image_size, SM_SWAP_CONTINUE, NULL, false}, {"a", ten.image, ten.image_size, SM_SWAP_CONTINUE, NULL, false}};
    CHECK(sm_swap_begin(&stage.swaps, twice, 2) == SM_OK);
    ticks(1);
    check_refused(SM_SWAP_NO_TWICE);
    CHECK(sm_swap_begin(&stage.swaps, twice, 0) == SM_E_ARGUMENT && sm_swap_begin(&stage.swaps, NULL, 1) == SM_E_ARGUMENT);
    const SwapMachine several = two_in_one();
    check_refusal(&several, SM_SWAP_CONTINUE, NULL, SM_SWAP_NO_SEVERAL);
    const SmSwapChange none = {"a", NULL, 0, SM_SWAP_CONTINUE, NULL, false};
    begin(&one);
    CHECK(sm_swap_begin(&stage.swaps, &none, 1) == SM_OK);
    stage_settle();
    check_refused(SM_SWAP_NO_IMAGE);
    machine_free(&other);
    machine_free(&names);
    machine_free(&gone);
    machine_free(&unmarked);
    machine_free(&slow);
}

// ---- the trial ----

static void test_trial(void)
{
    SwapMachine aborts, lost;
    SmEvent e;

    // clause 12.30: the swap is not confirmed in time
    const StagePlan plan = {.a = &one, .room = STAGE_ROOM, .trial = 7};
    reset_and_begin(&plan);
    ticks(4);
    CHECK(swap(&ten, SM_SWAP_CONTINUE, NULL) == SM_SWAP_NOT_REFUSED);
    double before = stage_number(AT_OUT);
    ticks(6);
    CHECK(stage_phase() == SM_SWAP_TRIAL);
    ticks(1);
    CHECK(stage_phase() == SM_SWAP_RETURNED && stage_status().end == SM_SWAP_TOOK_TOO_LONG && stage_number(AT_OUT) == before + 70);
    ticks(1);
    CHECK(stage_number(AT_OUT) == before + 71 && sm_swap_confirm(&stage.swaps) == SM_E_ARGUMENT);
    CHECK(stage_events(SM_EVENT_TRIAL, &e) == 1 && e.a == SM_SWAP_TOOK_TOO_LONG && e.b == stage_identity(&ten));
    CHECK(stage_events(SM_EVENT_SWAP, &e) == 2 && e.a == stage_identity(&ten) && e.b == stage_identity(&one));
    CHECK(stage_events(SM_EVENT_STATE, NULL) == 1);
    // the same again, from the other slot
    CHECK(swap(&ten, SM_SWAP_CONTINUE, NULL) == SM_SWAP_NOT_REFUSED && sm_swap_confirm(&stage.swaps) == SM_OK);
    ticks(20);
    CHECK(stage_phase() == SM_SWAP_CONFIRMED && stage_events(SM_EVENT_SWAP, &e) == 3);
    // It enters a state marked @abort.  The old machine has no such state: it restarts in its first @safe state.
    compile(&aborts, A "[A]\n.step\nout = 100\np > 3: -> Stop\n[Stop] @abort\n.step\nout = 200\n");
    compile(&lost, A "[First]\n.step\n-> Wait\n[Wait] @safe\n.entry\nout = 300\n.step\n-> A\n[A] @swap\n.step\np < 1: -> Wait\n");
    begin(&lost);
    stage_set_number(AT_P, 2);
    ticks(5);
    CHECK(stage_u32(AT_SA) == 3 && swap(&aborts, SM_SWAP_CONTINUE, NULL) == SM_SWAP_NOT_REFUSED && stage_u32(AT_SA) == 1);
    stage_set_number(AT_P, 4);
    ticks(1);
    CHECK(stage_phase() == SM_SWAP_RETURNED && stage_status().end == SM_SWAP_ABORTED && stage_u32(AT_SA) == 2 && stage_number(AT_OUT) == 100);
    CHECK(stage_events(SM_EVENT_STATE, &e) >= 3 && e.a == 0 && e.b == 2);
    ticks(1);
    CHECK(stage_number(AT_OUT) == 300);
    // A machine that is already in such a state at the exchange does not enter it.
    SwapMachine stopped;
    compile(&stopped, A "[A] @swap\n.step\nout = 1\n[Stop] @abort @safe\n.step\nout = 2\n");
    const StagePlan in_abort = {.a = &stopped, .room = STAGE_ROOM, .trial = 10};
    reset_and_begin(&in_abort);
    CHECK(swap(&stopped, SM_SWAP_RESTART, "Stop") == SM_SWAP_NOT_REFUSED);
    ticks(3);
    CHECK(stage_phase() == SM_SWAP_TRIAL && sm_swap_confirm(&stage.swaps) == SM_OK);
    ticks(1);
    CHECK(swap(&stopped, SM_SWAP_CONTINUE, NULL) == SM_SWAP_NOT_REFUSED);
    ticks(3);
    CHECK(stage_phase() == SM_SWAP_TRIAL);
    // clause 12.29: no other swap begins during a trial, nor while one is prepared or waits.
    CHECK(stage_swap("a", &ten, SM_SWAP_CONTINUE, NULL) == SM_E_BUSY && stage_phase() == SM_SWAP_TRIAL);
    begin_two(false, false);
    CHECK(stage_swap("a", &ten, SM_SWAP_CONTINUE, NULL) == SM_OK && stage_swap("b", &b_ten, SM_SWAP_CONTINUE, NULL) == SM_E_BUSY);
    while (sm_swaps_prepare(&stage.swaps))
        CHECK(stage_swap("b", &b_ten, SM_SWAP_CONTINUE, NULL) == SM_E_BUSY);
    CHECK(stage_phase() == SM_SWAP_WAITING && stage_swap("b", &b_ten, SM_SWAP_CONTINUE, NULL) == SM_E_BUSY);
    ticks(1);
    CHECK(stage_phase() == SM_SWAP_TRIAL && stage_swap("b", &b_ten, SM_SWAP_CONTINUE, NULL) == SM_E_BUSY);
    CHECK(sm_swap_confirm(&stage.swaps) == SM_OK);
    ticks(1);
    CHECK(stage_swap("b", &b_ten, SM_SWAP_CONTINUE, NULL) == SM_OK);
    stage_settle();
    CHECK(stage_phase() == SM_SWAP_TRIAL && stage_status().number == 2);
    machine_free(&stopped);
    machine_free(&aborts);
    machine_free(&lost);
}

// With two executors, all machines roll back together.
static void test_return_of_two(void)
{
    const StagePlan plan = {.a = &one, .b = &b_one, .room = STAGE_ROOM, .trial = 3, .two_executors = true, .guarded = true};
    const SmTick tick = {0, 0};

    reset_and_begin(&plan);
    stage_tick(1);
    CHECK(swap_two(&ten, &b_ten) == SM_OK);
    stage_settle();
    CHECK(stage_phase() == SM_SWAP_TRIAL && sm_swap_gate_enter(&stage.gate[1], &tick) == SM_OK);
    ticks(5);
    CHECK(stage_phase() == SM_SWAP_TRIAL && stage_status().end == SM_SWAP_TOOK_TOO_LONG && sm_swap_confirm(&stage.swaps) == SM_E_ARGUMENT);
    CHECK(sm_swap_gate_leave(&stage.gate[1], &tick) == SM_OK && stage_phase() == SM_SWAP_RETURNED);
    const double a = stage_number(AT_OUT), b = stage_number(AT_MORE);
    stage_tick(0);
    stage_tick(1);
    CHECK(stage_number(AT_OUT) == a + 1 && stage_number(AT_MORE) == b + 1);
}

// ---- what is kept ----

static void test_items(void)
{
    SmvmSwapItem item;
    unsigned kept = 0, n = 0;

    // clause 12.32
    begin(&one);
    ticks(1);
    CHECK(swap(&ten, SM_SWAP_CONTINUE, NULL) == SM_SWAP_NOT_REFUSED);
    for (; smvm_slot_item(&stage.slot[0][1], n, &item); n++)
        kept += item.fate == SMVM_SWAP_KEPT;
    CHECK(n == 2 && kept == 2);
    begin(&one);
    CHECK(swap(&ten, SM_SWAP_RESTART, NULL) == SM_SWAP_NOT_REFUSED && !smvm_slot_item(&stage.slot[0][1], 0, &item));
    // the same in a slot that an earlier swap has used
    begin(&one);
    for (int i = 0; i < 3; i++) {
        CHECK(swap(&ten, i < 2 ? SM_SWAP_CONTINUE : SM_SWAP_RESTART, NULL) == SM_SWAP_NOT_REFUSED && sm_swap_confirm(&stage.swaps) == SM_OK);
        ticks(1);
    }
    CHECK(stage.machine[0].running == 1 && !smvm_slot_item(&stage.slot[0][1], 0, &item));
}

// ---- every point at which a swap can fail ----

// Returns how many bytes of a slot a swap to `ten` uses.
static uint32_t used_bytes(void)
{
    begin(&one);
    CHECK(swap(&ten, SM_SWAP_CONTINUE, NULL) == SM_SWAP_NOT_REFUSED);
    return stage.slot[0][1].used;
}

// clause 12.33: memory is refused at every size, the image is cut or damaged at every byte, and the preparation ends after every part.
static void test_every_point(void)
{
    const uint32_t needed = used_bytes();
    uint8_t *image = malloc(ten.image_size);
    unsigned points = 0;

    CHECK(needed > ten.image_size && needed < STAGE_ROOM);
    for (uint32_t room = 0; room <= needed; room++, points++) {
        const StagePlan plan = {.a = &one, .room = room};
        reset_and_begin(&plan);
        ticks(2);
        CHECK(swap(&ten, SM_SWAP_CONTINUE, NULL) == (room < needed ? SM_SWAP_NO_MEMORY : SM_SWAP_NOT_REFUSED));
        if (room < needed)
            check_refused(SM_SWAP_NO_MEMORY);
    }
    for (uint32_t at = 0; at < ten.image_size; at++, points += 2) {
        SmSwapChange change = {"a", image, at, SM_SWAP_CONTINUE, NULL, false};
        memcpy(image, ten.image, ten.image_size);
        begin(&one);
        ticks(2);
        CHECK(sm_swap_begin(&stage.swaps, &change, 1) == SM_OK);
        stage_settle();
        check_refused(SM_SWAP_NO_IMAGE);
        image[at] ^= 0x40;
        change.size = ten.image_size;
        begin(&one);
        ticks(2);
        CHECK(sm_swap_begin(&stage.swaps, &change, 1) == SM_OK);
        stage_settle();
        check_refused(SM_SWAP_NO_IMAGE);
    }
    for (unsigned parts = 0;; parts++, points++) {
        begin(&one);
        ticks(2);
        CHECK(stage_swap("a", &ten, SM_SWAP_CONTINUE, NULL) == SM_OK);
        for (unsigned i = 0; i < parts; i++)
            CHECK(sm_swaps_prepare(&stage.swaps));
        if (stage_phase() != SM_SWAP_PREPARING)
            break;
        ticks(50);
        CHECK(stage_number(AT_OUT) == 52 && stage_phase() == SM_SWAP_PREPARING && stage_events(SM_EVENT_SWAP, NULL) == 0);
        CHECK(stage_swap("a", &ten, SM_SWAP_CONTINUE, NULL) == SM_E_BUSY);
    }
    // The lock times out at each call in turn.  The machine continues, and the swap happens later or not at all.
    for (uint32_t after = 0; after < 60; after++, points++) {
        begin(&one);
        ticks(2);
        sim_fail(SIM_lock_take, after, SM_E_TIMEOUT);
        (void)stage_swap("a", &ten, SM_SWAP_CONTINUE, NULL);
        for (int i = 0; i < 20; i++) {
            const double before = stage_number(AT_OUT);
            (void)sm_swaps_prepare(&stage.swaps);
            ticks(1);
            CHECK(stage_number(AT_OUT) == before + 1 || stage_number(AT_OUT) == before + 10);
        }
    }
    CHECK(points > 1500);
    free(image);
}

// ---- 100,000 swaps at 1 kHz ----

enum { SWAPS = 100000 };

static unsigned exchanged, refused;
static double expected;

// Begins a swap or confirms one, whenever that is possible, and checks the machine's counter.
static void act(const SmTick *tick)
{
    const SmSwapStatus s = stage_status();
    const bool is_ten = stage.machine[0].running == 1;

    (void)tick;
    expected += is_ten ? 10 : 1;
    CHECK(stage_number(AT_OUT) == expected);
    if (s.phase == SM_SWAP_TRIAL) {
        exchanged++;
        CHECK(sm_swap_confirm(&stage.swaps) == SM_OK);
    } else if (s.phase != SM_SWAP_PREPARING && s.phase != SM_SWAP_WAITING) {
        refused += s.phase == SM_SWAP_REFUSED;
        if (exchanged == SWAPS)
            sm_app_stop(&stage.app);
        else
            (void)stage_swap("a", is_ten ? &one : &ten, SM_SWAP_CONTINUE, NULL);
    }
}

static void test_many(bool decoded)
{
    const StagePlan plan = {.a = &one, .room = STAGE_ROOM, .decoded = decoded, .act = act};

    exchanged = refused = 0;
    expected = 0;
    sim_reset();
    stage_set_up(&plan);
    CHECK(sm_app_run(&stage.app) == SM_OK);
    CHECK(exchanged == SWAPS && refused == 0);
    CHECK(stage.executor[0].skipped == 0 && stage.executor[0].overruns == 0 && stage.executor[0].late_max == 0);
    for (int i = 0; i < STAGE_WORKERS; i++)
        CHECK(stage.calls[i] == stage.executor[0].ticks);
    CHECK(stage.machine[0].machine->refused == 0);
}

int main(void)
{
    compile(&one, COUNT(1));
    compile(&ten, COUNT(10));
    compile(&b_one, COUNT_B(1));
    compile(&b_ten, COUNT_B(10));
    test_exchange();
    test_restart();
    test_two_machines();
    test_stores_due();
    test_two_executors();
    test_refusals();
    test_writers();
    test_trial();
    test_return_of_two();
    test_items();
    test_every_point();
    test_many(false);
    test_many(true);
    return test_end("swap/running");
}
