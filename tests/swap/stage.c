// SPDX-License-Identifier: Apache-2.0
// Sets up the application of stage.h.
#include "tests/swap/stage.h"

#include <stdlib.h>
#include <string.h>

#include "runtime-c/pal/clock.h"

Stage stage;

static union { uint64_t word[STAGE_SIZE / 8]; uint8_t byte[STAGE_SIZE]; } vector;
static const SmElement element[] = {{AT_TIME, SM_U64, 0}, {AT_SA, SM_U32, 0}, {AT_SB, SM_U32, 0}, {AT_P, SM_F64, 0}, {AT_OUT, SM_F64, 0},
                                    {AT_MORE, SM_F64, 0}, {AT_ARMED, SM_BOOL, 0}};
static const SmRegion region[] = {{0, STAGE_SIZE, 41, 0, 7}};
static SmLayout layout = {0, 7, 1, element, region, {0, STAGE_SIZE, 41, 0, 7}};
static SmStateVec sv;
static SmEvent ring[STAGE_EVENTS];
static SmMachine machine[2];
static uint64_t memory[2][STAGE_ROOM / 8], decoded[2][STAGE_ROOM / 8], slots[2][2][STAGE_ROOM / 8], copy[2][STAGE_SIZE / 8];
static SmTask task[4 + 2 + STAGE_WORKERS + 1];
static SmTask *order[4 + 2 + STAGE_WORKERS + 1];
static SmRate rate[6];
static SmExecutor *executors[2];
static void (*act)(const SmTick *);
static unsigned seen[256];
static SmEvent last_of[256];
static uint32_t cursor;

static SmResult work(void *context, const SmTick *tick)
{
    (void)tick;
    ++*(uint32_t *)context;
    return SM_OK;
}

static SmResult run_act(void *context, const SmTick *tick)
{
    (void)context;
    if (act != NULL)
        act(tick);
    return SM_OK;
}

// Sets up machine `i`: its slots, and the image with which it begins.
static void set_up_machine(unsigned i, const SwapMachine *m, const StagePlan *plan)
{
    static const char *const name[] = {"a", "b"};
    SmvmSlot *s = stage.slot[i];
    SmSwappable *w = &stage.machine[i];

    memset(&machine[i], 0, sizeof machine[i]);
    s[0].target.image = m->image;
    s[0].target.size = m->image_size;
    s[0].target.memory = memory[i];
    s[0].target.memory_size = STAGE_ROOM;
    s[0].target.decoded = decoded[i];
    s[0].target.decoded_size = STAGE_ROOM;
    for (int k = 0; k < 2; k++) {
        s[k].target.decoder = plan->decoded ? &smvm_decoder : NULL;
        s[k].memory = slots[i][k];
        s[k].size = plan->room;
        s[k].longest = plan->longest;
        w->slot[k] = &s[k];
    }
    machine[i].name = name[i];
    machine[i].type = &smvm_machine_type;
    machine[i].self = &s[0];
    machine[i].sv = &sv;
    machine[i].events = &stage.events;
    machine[i].copy = plan->guarded ? copy[i] : NULL;
    machine[i].number = (uint16_t)i;
    w->machine = &machine[i];
    w->type = &smvm_slot_type;
    w->executor = plan->two_executors && i == 1;
}

static unsigned add_task(unsigned n, SmTaskInit *init, SmTaskStep *step, void *context)
{
    task[n].name = "task";
    task[n].init = init;
    task[n].step = step;
    task[n].context = context;
    task[n].number = (uint16_t)n;
    order[n] = &task[n];
    return n + 1;
}

// Adds the tasks of an executor: its gate, the machines, and for the first executor all other tasks.
static unsigned add_executor(unsigned x, unsigned n, unsigned r, const StagePlan *plan)
{
    SmExecutor *e = &stage.executor[x];
    unsigned first = n;

    stage.gate[x].swaps = &stage.swaps;
    n = add_task(n, sm_swap_gate_init, sm_swap_gate_enter, &stage.gate[x]);
    rate[r] = (SmRate){1, 1, &order[first]};
    for (unsigned i = 0; i < stage.swaps.machines; i++)
        if (stage.machine[i].executor == x)
            n = add_task(n, sm_swappable_init, sm_swappable_step, &stage.machine[i]);
    for (unsigned i = 0; x == 0 && i < STAGE_WORKERS; i++)
        n = add_task(n, NULL, work, &stage.calls[i]);
    if (x == 0)
        n = add_task(n, NULL, run_act, NULL);
    rate[r + 1] = (SmRate){1, (uint16_t)(n - first - 1), &order[first + 1]};
    n = add_task(n, NULL, sm_swap_gate_leave, &stage.gate[x]);
    rate[r + 2] = (SmRate){1, 1, &order[n - 1]};
    e->name = "executor";
    e->period = plan->period[x] != 0 ? plan->period[x] : PAL_MILLISECOND;
    e->rate = &rate[r];
    e->rates = 3;
    e->sv = &sv;
    e->events = &stage.events;
    e->time = &element[0];
    e->unit = PAL_MICROSECOND;
    e->number = (uint16_t)x;
    executors[x] = e;
    return n;
}

void stage_set_up(const StagePlan *plan)
{
    const unsigned n = plan->two_executors ? 2 : 1;
    unsigned tasks;

    memset(&stage, 0, sizeof stage);
    memset(&sv, 0, sizeof sv);
    memset(&vector, 0, sizeof vector);
    memset(task, 0, sizeof task);
    memset(seen, 0, sizeof seen);
    memset(slots, 0xa5, sizeof slots);
    cursor = 0;
    act = plan->act;
    layout.hash = plan->a->m.layout;
    sv.layout = &layout;
    sv.at = vector.byte;
    sv.guarded = plan->guarded;
    stage.events.at = ring;
    stage.events.guarded = plan->guarded;
    stage.events.room = STAGE_EVENTS;
    stage.swaps = (SmSwaps){.writing = SM_SWAP_WRITING, .machine = stage.machine, .machines = plan->b != NULL ? 2 : 1, .gate = stage.gate,
                            .gates = (uint16_t)n, .trial = plan->trial != 0 ? plan->trial : 100, .sv = &sv, .events = &stage.events, .armed = &element[6]};
    set_up_machine(0, plan->a, plan);
    if (plan->b != NULL)
        set_up_machine(1, plan->b, plan);
    tasks = add_executor(0, 0, 0, plan);
    if (plan->two_executors)
        add_executor(1, tasks, 3, plan);
    stage.app = (SmApp){.name = "stage", .sv = &sv, .events = &stage.events, .executor = executors, .executors = (uint16_t)n,
                        .writing = &stage.swaps.writing};
}

void stage_reach(SmSwapPlace place, const char *name, const char *key_file)
{
    static uint8_t buffer[SM_SWAP_ROOM(2, STAGE_ROOM)];
    static SmSwapChange changes[2];

    memset(buffer, 0xa5, sizeof buffer);
    stage.link = (SmSwapLink){.service = SM_SWAP_LINK_SERVICE, .swaps = &stage.swaps, .place = place, .name = name, .address = {{127, 0, 0, 1}, 4711},
                              .speed = 115200, .key_file = key_file, .number_memory = key_file != NULL ? "eeprom" : NULL, .machine = machine,
                              .machines = stage.swaps.machines, .change = changes, .buffer = buffer, .room = sizeof buffer,
                              .app_name = "stage", .events = &stage.events};
    stage.swaps.service = &stage.link.service;
}

void stage_store(const char *name, uint32_t image, const uint8_t *key)
{
    stage.store = (SmSwapStore){.storage = SM_SWAP_STORE_STORAGE, .memory = name, .room = SM_SWAP_STORE_ROOM(stage.swaps.machines, image), .key = key};
    stage.swaps.storage = &stage.store.storage;
}

SmResult stage_start(void)
{
    SmResult r;

    if (sm_statevec_init(&sv) != SM_OK || sm_events_init(&stage.events) != SM_OK)
        abort();
    r = sm_swaps_restore(&stage.app);
    for (unsigned x = 0; x < stage.swaps.gates; x++) {
        if (sm_executor_init(&stage.executor[x], NULL) != SM_OK)
            abort();
        sm_executor_start(&stage.executor[x], pal_clock_now());
    }
    return r;
}

void stage_begin(const StagePlan *plan)
{
    stage_set_up(plan);
    (void)stage_start();
}

void stage_tick(unsigned executor)
{
    (void)pal_clock_sleep_until(sm_executor_due(&stage.executor[executor]));
    sm_executor_tick(&stage.executor[executor]);
}

SmSwapStatus stage_status(void)
{
    SmSwapStatus s;

    memset(&s, 0xff, sizeof s);
    (void)sm_swap_status(&stage.swaps, &s);
    return s;
}

SmSwapPhase stage_phase(void) { return stage_status().phase; }

void stage_settle(void)
{
    for (int i = 0; i < 2000 && (stage_phase() == SM_SWAP_PREPARING || stage_phase() == SM_SWAP_WAITING || stage.swaps.refusal_due); i++) {
        (void)sm_swaps_prepare(&stage.swaps);
        stage_tick(0);
    }
}

double stage_number(uint32_t at)
{
    double x;

    memcpy(&x, vector.byte + at, sizeof x);
    return x;
}

uint32_t stage_u32(uint32_t at)
{
    uint32_t x;

    memcpy(&x, vector.byte + at, sizeof x);
    return x;
}

void stage_set_number(uint32_t at, double value) { memcpy(vector.byte + at, &value, sizeof value); }
void stage_arm(bool armed) { vector.byte[AT_ARMED] = armed; }

SmResult stage_swap(const char *name, const SwapMachine *to, SmSwapMode mode, const char *state)
{
    const SmSwapChange change = {name, to->image, to->image_size, (uint8_t)mode, state, false};

    return sm_swap_begin(&stage.swaps, &change, 1);
}

unsigned stage_events(SmEventKind kind, SmEvent *last)
{
    SmEvent e;

    while (sm_events_read(&stage.events, &cursor, &e, 1, NULL) == 1) {
        seen[e.kind]++;
        last_of[e.kind] = e;
    }
    if (last != NULL)
        *last = last_of[kind];
    return seen[kind];
}

uint32_t stage_identity(const SwapMachine *m) { return smvm_uint(m->image, SMVM_CRC_AT, 4); }
