// SPDX-License-Identifier: Apache-2.0
// Images of confirmed swaps run again after a restart: clauses 12.48 to 12.52 of docs/swapping.md, in the simulation.  The power is cut at every
// byte that the storage writes, every read and write fails once, and every byte of the memory is damaged.
#include <stdlib.h>
#include <string.h>

#include "runtime-c/psl/sim/sim.h"
#include "tests/swap/stage.h"
#include "tests/test.h"

#define COUNT(by) A "[local]\nU32 n = 0\n[A] @swap\n.step\nn = n + " #by "\nout = n\n"
#define COUNT_B(by) B "[local]\nU32 n = 0\n[A] @swap\n.step\nn = n + " #by "\nmore = n\n"
#define STATES(names) A names

enum { IMAGE_ROOM = 330 };    // bytes for each machine in the storage, so that two sets of two machines have room in the simulated memory

static SwapMachine one, ten, many, b_one, b_ten, here, there, elsewhere;
static StagePlan plan;
static uint32_t image_room;
static const uint8_t *key;

// ---- an application that is started again ----

// Restarts the simulated computer.  Only the content of the non-volatile memory is preserved.
static void reset_but_memory(void)
{
    static uint8_t content[SIM_NVM_SIZE];

    memcpy(content, sim_nvm("eeprom"), sizeof content);
    sim_reset();
    memcpy(sim_nvm("eeprom"), content, sizeof content);
}

// Starts the application with the content of the memory.
static SmResult restart(void)
{
    reset_but_memory();
    stage_set_up(&plan);
    stage_store("eeprom", image_room, key);
    return stage_start();
}

static void begin(const SwapMachine *a, const SwapMachine *b)
{
    sim_reset();
    plan = (StagePlan){.a = a, .b = b, .room = STAGE_ROOM, .trial = 50};
    image_room = IMAGE_ROOM;
    key = NULL;
    CHECK(restart() == SM_OK);
}

// Like restart, of an application that has other writers of these elements now.
static SmResult restart_with(const SmRange *written, uint16_t n)
{
    reset_but_memory();
    stage_set_up(&plan);
    stage_store("eeprom", image_room, key);
    stage.swaps.written = written;
    stage.swaps.writtens = n;
    return stage_start();
}

static uint32_t runs(uint16_t machine)
{
    SmSwapMachineState s;

    memset(&s, 0, sizeof s);
    (void)sm_swap_machine(&stage.swaps, machine, &s);
    return s.identity;
}

static bool is_running(uint16_t machine, const SwapMachine *m) { return runs(machine) == stage_identity(m); }

static void ticks(unsigned n)
{
    while (n-- > 0)
        stage_tick(0);
}

// Swaps machine "a", and with `both` also "b".  A NULL pointer selects the built-in image.  Returns whether they are on trial.
static bool swap(const SwapMachine *a, const SwapMachine *b, bool both)
{
    const SmSwapChange change[] = {{"a", a ? a->image : NULL, a ? a->image_size : 0, SM_SWAP_RESTART, NULL, a == NULL},
                                   {"b", b ? b->image : NULL, b ? b->image_size : 0, SM_SWAP_RESTART, NULL, b == NULL}};

    ticks(1);
    CHECK(sm_swap_begin(&stage.swaps, change, both ? 2 : 1) == SM_OK);
    stage_settle();
    return stage_phase() == SM_SWAP_TRIAL;
}

// Confirms the swap that is on trial.  Returns the result of storing it.
static SmResult confirm(void)
{
    CHECK(sm_swap_confirm(&stage.swaps) == SM_OK && stage_phase() == SM_SWAP_TRIAL);
    return sm_swaps_save(&stage.swaps);
}

static void swap_and_confirm(const SwapMachine *a)
{
    CHECK(swap(a, NULL, false) && confirm() == SM_OK && stage_phase() == SM_SWAP_CONFIRMED);
    ticks(1);
}

// Whether the last start reported this reason why machine "a" does not run the stored image.
static bool was_refused(SmSwapReason why)
{
    SmEvent e;

    return stage_events(SM_EVENT_STORED, &e) > 0 && e.b == (uint32_t)why && is_running(0, plan.a);
}

// ---- restarts ----

// clause 12.48: only a confirmed image runs again
static void test_restart(void)
{
    SmSwapMachineState s;
    SmEvent e;

    begin(&one, NULL);
    CHECK(is_running(0, &one) && stage_events(SM_EVENT_STORED, NULL) == 0 && stage.store.nvm.id != 0);
    CHECK(swap(&ten, NULL, false));
    CHECK(restart() == SM_OK && is_running(0, &one));
    swap_and_confirm(&ten);
    CHECK(stage_events(SM_EVENT_TRIAL, &e) == 1 && e.a == SM_SWAP_WAS_CONFIRMED);
    CHECK(sm_swap_machine(&stage.swaps, 0, &s) == SM_OK && s.is_stored && !s.is_built_in && !s.is_on_trial);
    CHECK(restart() == SM_OK && is_running(0, &ten) && stage_events(SM_EVENT_STORED, &e) == 1 && e.a == stage_identity(&ten) && e.b == 0);
    ticks(3);
    CHECK(stage_number(AT_OUT) == 30 && stage_u32(AT_SA) == 1);
    CHECK(sm_swap_machine(&stage.swaps, 0, &s) == SM_OK && s.is_stored && !s.is_built_in);
    // the application ends during a trial
    CHECK(swap(&many, NULL, false) && is_running(0, &many));
    CHECK(sm_swap_machine(&stage.swaps, 0, &s) == SM_OK && !s.is_stored && s.is_on_trial);
    CHECK(restart() == SM_OK && is_running(0, &ten));
    // the application ends before a confirmation is stored: ending stores it
    CHECK(swap(&many, NULL, false) && sm_swap_confirm(&stage.swaps) == SM_OK);
    sm_swaps_close(&stage.app, NULL);
    CHECK(restart() == SM_OK && is_running(0, &many));
    for (int i = 0; i < 5; i++) {                        // both heads are written in turn, with numbers above 2
        swap_and_confirm(i % 2 ? &many : &ten);
        CHECK(restart() == SM_OK && is_running(0, i % 2 ? &many : &ten));
    }
}

// clause 12.51: the return to the built-in machine
static void test_built_in(void)
{
    SmSwapMachineState s;

    begin(&one, NULL);
    swap_and_confirm(&ten);
    CHECK(restart() == SM_OK && is_running(0, &ten));
    CHECK(swap(NULL, NULL, false) && is_running(0, &one));
    ticks(60);                                             // the swap is not confirmed: the stored machine returns
    CHECK(stage_phase() == SM_SWAP_RETURNED && is_running(0, &ten));
    swap_and_confirm(NULL);
    CHECK(sm_swap_machine(&stage.swaps, 0, &s) == SM_OK && s.is_built_in && !s.is_stored && is_running(0, &one));
    CHECK(restart() == SM_OK && is_running(0, &one) && stage_events(SM_EVENT_STORED, NULL) == 0);
    // both slots have been used for other images
    swap_and_confirm(&ten);
    swap_and_confirm(&many);
    swap_and_confirm(NULL);
    CHECK(is_running(0, &one));
    ticks(4);
    CHECK(stage_number(AT_OUT) > 0);
    swap_and_confirm(&many);
    CHECK(restart() == SM_OK && is_running(0, &many));
}

// Sets of two machines.  Each confirmation stores all images that are not built in.
static void test_two_machines(void)
{
    begin(&one, &b_one);
    swap_and_confirm(&ten);
    CHECK(restart() == SM_OK && is_running(0, &ten) && is_running(1, &b_one));
    CHECK(swap(NULL, &b_ten, true) && confirm() == SM_OK);
    CHECK(restart() == SM_OK && is_running(0, &one) && is_running(1, &b_ten));
    swap_and_confirm(&many);
    CHECK(restart() == SM_OK && is_running(0, &many) && is_running(1, &b_ten));
}

// ---- faults ----

// clause 12.49: the power is cut at every byte of a confirmation, on a blank memory and on one with earlier sets.  Afterwards all machines have
// the old images, or all have the new ones.  If the confirmation has succeeded, they have the new ones.  The next swap is stored.
static void test_power_cuts(int before)
{
    unsigned old_runs = 0, new_runs = 0;
    bool was_cut = true;

    for (uint32_t writes = 0; was_cut; writes++) {
        bool is_whole = false;
        for (uint32_t bytes = 0; !is_whole; bytes++) {
            const SwapMachine *a = before == 0 ? &one : before == 1 ? &ten : &many, *b = before == 0 ? &b_one : &b_ten;
            SmResult r;
            begin(&one, &b_one);
            if (before > 0)
                CHECK(swap(&ten, &b_ten, true) && confirm() == SM_OK);
            ticks(1);
            if (before > 1)
                swap_and_confirm(&many);
            CHECK(swap(before == 2 ? &ten : &many, before == 0 ? &b_ten : NULL, true));
            sim_cut_power(writes, bytes);
            r = confirm();
            was_cut = r != SM_OK;
            CHECK(stage_phase() == (r == SM_OK ? SM_SWAP_CONFIRMED : SM_SWAP_TRIAL));
            is_whole = !was_cut || bytes >= IMAGE_ROOM + 73;      // more bytes than any write has
            CHECK(restart() == SM_OK);
            if (is_running(0, a) && is_running(1, b)) {
                CHECK(r != SM_OK);
                old_runs++;
            } else {
                CHECK(is_running(0, before == 2 ? &ten : &many) && is_running(1, before == 0 ? &b_ten : &b_one));
                new_runs++;
            }
            if (bytes % 16 == 0) {
                swap_and_confirm(&many);
                CHECK(restart() == SM_OK && is_running(0, &many));
            }
        }
    }
    CHECK(old_runs > 300 && new_runs > 0);
}

// clause 12.50: each access to the memory fails once.  The trial continues, and without a later confirmation the machines roll back.
static void test_failures(SimCall call)
{
    SmResult r = SM_E_DEVICE;
    unsigned failures = 0;

    for (uint32_t after = 0; r != SM_OK; after++) {
        SmEvent e;
        begin(&one, NULL);
        swap_and_confirm(&ten);
        CHECK(swap(&many, NULL, false));
        sim_fail(call, after, SM_E_DEVICE);
        r = confirm();
        sim_fail(call, 0, SM_OK);
        if (r == SM_OK)
            break;
        failures++;
        CHECK(r == SM_E_DEVICE && stage_phase() == SM_SWAP_TRIAL && stage_status().stored == r);
        ticks(1);
        CHECK(stage_events(SM_EVENT_NOT_STORED, &e) == 1 && e.a == (uint32_t)-r && stage_events(SM_EVENT_TRIAL, NULL) == 1);
        if (after % 2) {                                   // the confirmation is requested again
            CHECK(confirm() == SM_OK && stage_phase() == SM_SWAP_CONFIRMED);
            CHECK(restart() == SM_OK && is_running(0, &many));
        } else {
            ticks(60);
            CHECK(stage_phase() == SM_SWAP_RETURNED && is_running(0, &ten));
            CHECK(restart() == SM_OK && is_running(0, &ten));
        }
    }
    CHECK(failures >= 2);
}

// A confirmation that waits for the storage: neither the length of the trial nor an @abort state ends the trial.
static void test_waiting(void)
{
    begin(&one, NULL);
    CHECK(swap(&ten, NULL, false) && sm_swap_confirm(&stage.swaps) == SM_OK);
    ticks(200);
    CHECK(stage_phase() == SM_SWAP_TRIAL && is_running(0, &ten) && sm_swap_confirm(&stage.swaps) == SM_OK);
    CHECK(stage_swap("a", &many, SM_SWAP_RESTART, NULL) == SM_E_BUSY);
    CHECK(sm_swaps_save(&stage.swaps) == SM_OK && stage_phase() == SM_SWAP_CONFIRMED && sm_swap_confirm(&stage.swaps) == SM_E_ARGUMENT);
    CHECK(sm_swaps_save(&stage.swaps) == SM_OK);
    ticks(1);
    // if storing fails then, the trial has lasted too long
    CHECK(swap(&many, NULL, false) && sm_swap_confirm(&stage.swaps) == SM_OK);
    ticks(200);
    sim_fail(SIM_nvm_write, 0, SM_E_SPACE);
    CHECK(sm_swaps_save(&stage.swaps) == SM_E_SPACE && stage_phase() == SM_SWAP_TRIAL);
    ticks(2);
    CHECK(stage_phase() == SM_SWAP_RETURNED && is_running(0, &ten));
}

// clause 12.50: every byte of the memory is damaged.  Then the earlier set runs, or the built-in machine, and an event has the reason.
static void test_damage(void)
{
    static uint8_t copy[SIM_NVM_SIZE];
    unsigned older = 0, none = 0;

    begin(&one, NULL);
    swap_and_confirm(&ten);
    swap_and_confirm(&many);
    memcpy(copy, sim_nvm("eeprom"), sizeof copy);
    for (uint32_t at = 0; at < SIM_NVM_SIZE; at++) {
        memcpy(sim_nvm("eeprom"), copy, sizeof copy);
        sim_nvm("eeprom")[at] ^= 0x10;
        CHECK(restart() == SM_OK && (is_running(0, &many) || is_running(0, &ten)));
        older += is_running(0, &ten);
        // the older set is damaged, too
        memset(sim_nvm("eeprom"), 0xff, 64);
        CHECK(restart() == SM_OK && (is_running(0, &many) || is_running(0, &one) || is_running(0, &ten)));
        if (is_running(0, &one)) {
            CHECK(was_refused(SM_SWAP_NO_DAMAGED));
            none++;
        }
    }
    CHECK(older > 100 && none > 100);
    // if both heads are erased, the memory counts as new
    memset(sim_nvm("eeprom"), 0xff, 128);
    CHECK(restart() == SM_OK && is_running(0, &one) && stage_events(SM_EVENT_STORED, NULL) == 0);
}

// ---- writers ----

// clause 12.58 for stored images: the application has a new writer, or the machine that gave an element up has been built again.
static void test_writers(void)
{
    static const SmRange p[] = {{AT_P, 8}};
    SwapMachine takes, takes_p, gives, gives_p, other;
    SmEvent e;

    machine_compile(&takes, A "F64 more\n[A] @swap\n.step\nmore = 1\n", STAGE_SV, 2, true);
    machine_compile(&takes_p, A "[A] @swap\n.step\np = 1\n", STAGE_SV, 2, true);
    machine_compile(&gives, B "[A] @swap\n.step\nif 1 > 2: p = 0\n", STAGE_SV, 2, true);
    machine_compile(&gives_p, B "[A] @swap\n.step\np = 2\n", STAGE_SV, 2, true);
    machine_compile(&other, B "[A] @swap\n.step\nmore = 7\n", STAGE_SV, 2, true);
    begin(&one, &b_one);
    swap_and_confirm(&takes_p);
    CHECK(restart() == SM_OK && is_running(0, &takes_p) && stage_events(SM_EVENT_STORED, NULL) == 1);
    CHECK(restart_with(p, 1) == SM_OK && is_running(0, &one) && is_running(1, &b_one));
    CHECK(stage_events(SM_EVENT_STORED, &e) == 1 && e.b == SM_SWAP_NO_WRITER && e.a == stage_identity(&takes_p));
    ticks(1);
    CHECK(stage_number(AT_P) == 0);
    // one machine takes over what the other gives up: both stored images run, or none
    begin(&one, &b_one);
    CHECK(swap(&takes, &gives, true) && confirm() == SM_OK);
    CHECK(restart() == SM_OK && is_running(0, &takes) && is_running(1, &gives) && stage_events(SM_EVENT_STORED, NULL) == 2);
    begin(&one, &b_one);
    CHECK(swap(&takes, &gives_p, true) && confirm() == SM_OK && restart() == SM_OK && is_running(0, &takes) && is_running(1, &gives_p));
    CHECK(restart_with(p, 1) == SM_OK && is_running(0, &one) && is_running(1, &b_one));
    plan.b = &other;
    CHECK(restart() == SM_OK && is_running(0, &one) && is_running(1, &other) && stage_events(SM_EVENT_STORED, NULL) == 2);
    machine_free(&takes);
    machine_free(&takes_p);
    machine_free(&gives);
    machine_free(&gives_p);
    machine_free(&other);
}

// ---- conditions ----

// clause 12.52: each stored image is checked again
static void test_conditions(void)
{
    begin(&one, NULL);
    swap_and_confirm(&ten);
    plan.a = &many;                                        // the application is built with another machine now
    CHECK(restart() == SM_OK && was_refused(SM_SWAP_NO_BUILD));
    plan.a = &one;
    CHECK(restart() == SM_OK && is_running(0, &ten));
    plan.longest = 1;
    CHECK(restart() == SM_OK && was_refused(SM_SWAP_NO_SLOW));
    plan.longest = 0;
    for (uint32_t room = 0; room < 2000; room += 8) {
        plan.room = room;
        CHECK(restart() == SM_OK && (is_running(0, &ten) || was_refused(SM_SWAP_NO_MEMORY)));
    }
    CHECK(is_running(0, &ten));
    plan.room = STAGE_ROOM;
    plan.decoded = true;
    CHECK(restart() == SM_OK && is_running(0, &ten));
    ticks(5);
    CHECK(stage_number(AT_OUT) == 50);
    plan.guarded = true;
    CHECK(restart() == SM_OK && is_running(0, &ten));
    ticks(5);
    CHECK(stage_number(AT_OUT) == 50);
    // the application no longer has one of the machines
    begin(&one, &b_one);
    CHECK(swap(&ten, &b_ten, true) && confirm() == SM_OK);
    plan.b = NULL;
    CHECK(restart() == SM_OK && is_running(0, &ten));
}

// clause 12.52: authentication codes, with and without a key
static void test_keys(void)
{
    static const uint8_t right[SMVM_KEY] = {1, 2, 3}, wrong[SMVM_KEY] = {1, 2, 4};

    begin(&one, NULL);
    key = right;
    CHECK(restart() == SM_OK);
    swap_and_confirm(&ten);
    CHECK(restart() == SM_OK && is_running(0, &ten));
    key = wrong;
    CHECK(restart() == SM_OK && was_refused(SM_SWAP_NO_DAMAGED));
    key = NULL;
    CHECK(restart() == SM_OK && was_refused(SM_SWAP_NO_DAMAGED));
    swap_and_confirm(&many);
    CHECK(restart() == SM_OK && is_running(0, &many));
    key = right;
    CHECK(restart() == SM_OK && !is_running(0, &many));
}

// clause 12.51: a stored machine starts in the state with the name that @state has, or in the first state
static void test_first_state(void)
{
    begin(&here, NULL);
    swap_and_confirm(&there);                              // the same states in another order
    for (uint32_t state = 0; state <= 3; state++) {
        reset_but_memory();
        stage_set_up(&plan);
        stage_store("eeprom", image_room, NULL);
        stage.machine[0].machine->initial = state;
        CHECK(stage_start() == SM_OK && is_running(0, &there));
        CHECK(stage_u32(AT_SA) == (state == 0 ? 1 : 4 - state));
    }
    swap_and_confirm(&elsewhere);                          // no state has that name
    reset_but_memory();
    stage_set_up(&plan);
    stage_store("eeprom", image_room, NULL);
    stage.machine[0].machine->initial = 3;
    CHECK(stage_start() == SM_OK && is_running(0, &elsewhere) && stage_u32(AT_SA) == 1);
}

// ---- the memory ----

// A memory that belongs to another program is not changed, and the application does not start.
static void test_foreign(void)
{
    static const char text[] = "not a storage";

    begin(&one, NULL);
    sim_reset();
    memcpy(sim_nvm("eeprom"), text, sizeof text);
    CHECK(restart() == SM_E_FOREIGN && memcmp(sim_nvm("eeprom"), text, sizeof text) == 0);
    CHECK(strcmp(stage.app.failed_file, "eeprom") == 0 && stage.app.reason != NULL);
    sim_reset();
    stage_set_up(&plan);
    stage_store("flash", image_room, NULL);                // this memory must be erased before it is written
    CHECK(stage_start() == SM_E_UNSUPPORTED);
    sim_reset();
    stage_set_up(&plan);
    stage_store("nowhere", image_room, NULL);
    CHECK(stage_start() == SM_E_MISSING);
    image_room = SIM_NVM_SIZE;
    CHECK(restart() == SM_E_SPACE);
}

// The size of a set changes with the size of the slots.  The current set is found, and never overwritten.
static void test_other_rooms(void)
{
    for (uint32_t first = 250; first <= 500; first += 25)
        for (uint32_t then = 250; then <= 500; then += 25)
            for (uint32_t writes = 0; writes < 4; writes++) {
                begin(&one, NULL);
                image_room = first;
                CHECK(restart() == SM_OK);
                swap_and_confirm(&many);
                if (first % 50)
                    swap_and_confirm(&ten);
                image_room = then;
                CHECK(restart() == SM_OK && is_running(0, first % 50 ? &ten : &many));
                CHECK(swap(&there, NULL, false));
                sim_cut_power(writes, 20);
                (void)confirm();
                CHECK(restart() == SM_OK && (is_running(0, first % 50 ? &ten : &many) || is_running(0, &there)));
            }
}

int main(void)
{
    machine_compile(&one, COUNT(1), STAGE_SV, 2, true);
    machine_compile(&ten, COUNT(10), STAGE_SV, 2, true);
    machine_compile(&many, COUNT(1000), STAGE_SV, 2, true);
    machine_compile(&b_one, COUNT_B(1), STAGE_SV, 2, true);
    machine_compile(&b_ten, COUNT_B(10), STAGE_SV, 2, true);
    machine_compile(&here, STATES("[P] @swap\n[Q] @swap\n[R] @swap\n"), STAGE_SV, 2, true);
    machine_compile(&there, STATES("[R] @swap\n[Q] @swap\n[P] @swap\n"), STAGE_SV, 2, true);
    machine_compile(&elsewhere, STATES("[X] @swap\n[Y] @swap\n"), STAGE_SV, 2, true);
    CHECK(many.image_size <= IMAGE_ROOM && b_ten.image_size <= IMAGE_ROOM);
    test_restart();
    test_built_in();
    test_two_machines();
    for (int before = 0; before < 3; before++)
        test_power_cuts(before);
    test_failures(SIM_nvm_write);
    test_failures(SIM_nvm_read);
    test_waiting();
    test_damage();
    test_writers();
    test_conditions();
    test_keys();
    test_first_state();
    test_foreign();
    test_other_rooms();
    machine_free(&one);
    machine_free(&ten);
    machine_free(&many);
    machine_free(&b_one);
    machine_free(&b_ten);
    machine_free(&here);
    machine_free(&there);
    machine_free(&elsewhere);
    return test_end("swap/storing");
}
