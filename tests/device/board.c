// SPDX-License-Identifier: Apache-2.0
// A board without hardware: a program that runs VM, store and agent, with a terminal device as its line and a file as its non-volatile memory.
// A test can kill it at any time and start it again.
//   board LINE MEMORY        while there is a file MEMORY.armed, it is armed; the key in MEMORY.key is its own; MEMORY.plain: it reports a VM without windows, parameters and elementary functions
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "bytecode-vm/auth.h"
#include "bytecode-vm/target/agent.h"
#include "runtime-c/pal/clock.h"
#include "runtime-c/pal/nvm.h"
#include "runtime-c/pal/serial.h"

enum { MEMORY = 4096, BODY = 64, SLOTS = 2, EVENTS = 16, VECTOR = 1024, RAM = 8192, PERIOD = 10000000, COUNTED = 20 };      // COUNTED: steps until a start counts in full

typedef struct Machine {
    SmvmMachine m;
    uint64_t memory[RAM / 8], vector[VECTOR / 8], *time;
    uint32_t state;           // the current state; 0: no machine runs
} Machine;

static uint8_t shadow[MEMORY];       // a copy of the memory that the VM can read
static Machine machine;
static SmEvent storage[EVENTS];
static SmEvents events;
static Store store;
static Agent agent;
static char armed_path[256], key_path[256], plain_path[256];
static uint8_t key[SMVM_KEY];

static void report_events(uint8_t kind, uint32_t a, uint32_t b)
{
    SmEvent e;

    memset(&e, 0, sizeof e);
    e.time = pal_clock_now();
    e.kind = kind;
    e.a = a;
    e.b = b;
    sm_event(&events, &e);
}

// ---- the machine ----

static SmResult image_fits(void *context, SmvmBytes image)
{
    SmvmMachine m;

    (void)context;
    if (!smvm_machine(image, 0, &m) || smvm_ram_size(&m) > RAM)
        return SM_E_MEMORY;
    return m.sv_size <= VECTOR ? SM_OK : SM_E_LAYOUT;
}

static void machine_start(SmvmBytes image)
{
    SmvmVector v = {machine.vector, 0, 0};

    memset(&machine, 0, sizeof machine);
    if (image_fits(NULL, image) != SM_OK || !smvm_machine(image, 0, &machine.m))
        return;
    v.size = machine.m.sv_size;
    v.layout = machine.m.layout;
    if (smvm_init(machine.memory, RAM, &machine.m, &v, 1) != SM_OK)
        return;
    machine.time = (uint64_t *)(void *)((char *)machine.vector + machine.m.g);
    machine.state = 1;
    report_events(SM_EVENT_STATE, 0, 1);
}

static void machine_step(void)
{
    SmVm *const vm = (SmVm *)(void *)machine.memory;

    if (machine.state == 0)
        return;
    if (++*machine.time == COUNTED)
        (void)smvm_store_count_start(&store);
    smvm_step(vm, machine.vector);
    if (smvm_state(vm) != machine.state)
        report_events(SM_EVENT_STATE, machine.state, smvm_state(vm));
    machine.state = smvm_state(vm);
}

// ---- the board ----

static SmResult may_update(void *context)
{
    (void)context;
    if (access(armed_path, F_OK) == 0)
        return SM_E_ARMED;
    return machine.state == 0 || smvm_state_is_safe(&machine.m, machine.state) ? SM_OK : SM_E_UNSAFE;
}

static SmResult leave_slot(void *context, const uint8_t *begin, uint8_t n)
{
    (void)context, (void)begin, (void)n;
    machine.state = 0;
    return SM_OK;
}

static bool reload_memory(void) { return pal_nvm_read(store.nvm, 0, shadow, MEMORY) == SM_OK; }

// Returns the pins of a Mega: digital pins, of which some are also analog, and PWM on any.
static uint8_t physical_pin(uint16_t number, uint8_t kind)
{
    const uint16_t place = (kind & 3) == 0 ? (uint16_t)(54 + number) : number;

    return place < 2 || place > 69 || number > 69 || (kind & 16) != 0 ? SMVM_NO_PIN : (uint8_t)place;
}

static AgentBoard board = {.ram = RAM, .longest_step = 100000, .machines = 2, .ram_digital = 10, .ram_analog = 26, .period = PERIOD / 1000000, .cycles = 14400, .physical_pin = physical_pin,
                           .may_update = may_update, .fits = image_fits, .leave_slot = leave_slot, .built_in = shadow};

static bool has_key(void)
{
    FILE *f = fopen(key_path, "r");
    unsigned byte, n = 0;

    while (f && n < SMVM_KEY && fscanf(f, "%2x", &byte) == 1)
        key[n++] = (uint8_t)byte;
    if (f)
        fclose(f);
    return n == SMVM_KEY;
}

static bool is_authentic(SmvmBytes image, uint32_t *number) { return smvm_auth_check(image, key, number); }

static bool open_store(PalNvm nvm, const StorePlan *plan)
{
    if (smvm_store_open(&store, nvm, plan) != SM_OK)
        return false;
    store.is_authentic = has_key() ? is_authentic : NULL;
    board.mark = smvm_auth_mark(key);
    return true;
}

static bool start_board(PalNvm nvm, uint8_t *frame)
{
    StorePlan plan = {MEMORY, SLOTS, {shadow + 2 * STORE_RECORD, shadow + 2 * STORE_RECORD + (MEMORY - 2 * STORE_RECORD) / SLOTS}};
    uint8_t slot;

    store.nvm = nvm;
    events.at = storage;
    events.room = EVENTS;
    if (!reload_memory() || sm_events_init(&events) != SM_OK || !open_store(nvm, &plan) ||
        smvm_store_boot(&store, &slot) != SM_OK)
        return false;
    board.abilities = access(plain_path, F_OK) != 0 ? LINK_WINDOWS | LINK_PARAMETERS : 0;
    board.functions = board.abilities != 0 ? SMVM_FUNCTIONS : 0;
    smvm_agent_init(&agent, &store, &board, &events, frame, BODY);
    report_events(SM_EVENT_START, 0, 0);
    machine.state = 0;
    if (slot != STORE_BUILT_IN)
        machine_start(plan.image[slot]);
    return true;
}

static bool serve_requests(PalSerial line, uint8_t byte)
{
    const uint16_t n = smvm_agent_receive(&agent, byte);
    size_t sent;

    return n == 0 || (reload_memory() && pal_serial_send(line, agent.frame, n, &sent, PERIOD * 100u) == SM_OK);
}

int main(int argc, char **argv)
{
    static uint8_t frame[LINK_ROOM(BODY)];
    PalSerial line;
    PalNvm nvm;
    uint8_t byte;
    size_t n;

    if (argc != 3 || snprintf(armed_path, sizeof armed_path, "%s.armed", argv[2]) < 0 ||
        snprintf(key_path, sizeof key_path, "%s.key", argv[2]) < 0 || snprintf(plain_path, sizeof plain_path, "%s.plain", argv[2]) < 0)
        return 2;
    if (pal_serial_open(&line, argv[1], 115200) != SM_OK || pal_nvm_open(&nvm, argv[2], MEMORY) != SM_OK || !start_board(nvm, frame))
        return 3;
    for (;;) {
        const SmResult r = pal_serial_receive(line, &byte, 1, &n, PERIOD);
        if (r == SM_OK ? !serve_requests(line, byte) : r != SM_E_TIMEOUT)
            return 3;
        machine_step();
        if (agent.restart && !start_board(nvm, frame))
            return 3;
    }
}
