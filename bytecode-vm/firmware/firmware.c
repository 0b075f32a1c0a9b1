// SPDX-License-Identifier: Apache-2.0
// The generic firmware of an Arduino Uno or Mega (docs/boards.md).  It runs the image that the store chooses, with its pins and period, and
// accepts new images over the serial line at the same time.  Steps of the machines run in the interrupt of the clock.  Serial line,
// verifier and EEPROM use the remaining time.
#include <string.h>

#include "bytecode-vm/auth.h"
#include "bytecode-vm/firmware/firmware.h"
#include "bytecode-vm/firmware/runner.h"
#include "bytecode-vm/permit.h"
#include "bytecode-vm/target/agent.h"
#include "bytecode-vm/target/state_log.h"
#include "runtime-c/pal/dio.h"
#include "runtime-c/pal/nvm.h"
#include "runtime-c/pal/serial.h"
#include "runtime-c/pal/watchdog.h"
#include "runtime-c/psl/avr/avr.h"

#ifdef PSL_AVR
#include <avr/pgmspace.h>
#include <avr/sleep.h>

enum {
    PERIOD = 10,              // milliseconds between steps, for an image that was sent without a period
    EEPROM_WRITE = 4,         // milliseconds of a byte write, rounded up: none starts if it would still be in progress at the next step
    MS_CYCLES = F_CPU / 1000, // CPU cycles of a millisecond
    STEP_CYCLES = MS_CYCLES / 10 * 9      // cycles that a step may take per millisecond of its period: clock and line use the rest
};
// The chip divides its clock to these with an error of 2.1 %.  (115,200 at 8 MHz would be 3.5 % off.)
#define BITS_PER_SECOND (F_CPU == 8000000 ? UINT32_C(57600) : UINT32_C(115200))

static const uint8_t built_in[] PROGMEM = {
#include "safe_image.inc"
};

// ---- pins ----

typedef char firmware_has_no_pin_as_the_vm[AVR_NO_PIN == SMVM_NO_PIN ? 1 : -1];

#ifdef FIRMWARE_ARM_PIN
#if FIRMWARE_ARM_PIN < AVR_SERIAL_PINS || FIRMWARE_ARM_PIN >= AVR_PINS
#error "ARM_PIN is a pin of the board as a number: 2 to 19 on an Uno, 2 to 69 on a Mega (0 and 1 are the line)"
#endif
static PalDio arming;

// Whether the board is armed.  A plug that connects the pin to ground keeps it disarmed; if the plug is removed or its wire breaks, it is armed.
static bool is_armed(void)
{
    bool armed = true;

    (void)pal_dio_read(arming, &armed);
    return armed;
}

static void open_arming(void) { (void)pal_dio_open(&arming, FIRMWARE_ARM_PIN, PAL_DIO_PULL_UP, true); }

// Returns the chip's pin for a pin number of the image, or SMVM_NO_PIN for the arming pin, which no image can use.
static uint8_t physical_pin_of(uint16_t number, uint8_t kind)
{
    const uint8_t pin = avr_physical_pin(number, kind);

    return pin == FIRMWARE_ARM_PIN ? SMVM_NO_PIN : pin;
}
#else
static bool is_armed(void) { return false; }
static void open_arming(void) {}
#define physical_pin_of avr_physical_pin
#endif

// ---- running an image ----

typedef char firmware_windows_have_room[FIRMWARE_MEMORY / 4 <= UINT32_C(1) << (SM_ROLL_WAITING - 1) ? 1 : -1];
typedef char firmware_pins_take_what_smc_counts[SMVM_RUNNER_DIGITAL == 10 && SMVM_RUNNER_ANALOG == 26 ? 1 : -1];     // compiler/budget/boards.def
static uint64_t memory[FIRMWARE_MEMORY / 8];
static SmvmRunner runner = {.memory = memory, .size = sizeof memory, .physical_pin = physical_pin_of};
static SmEvent event_ring[FIRMWARE_EVENTS];
static SmEvents events = {.at = event_ring, .room = FIRMWARE_EVENTS, .guarded = true};
static uint16_t state[SMVM_RUNNER_MACHINES];           // the state of each machine after the last step

static volatile uint16_t ms_left = 1, period = PERIOD;  // milliseconds until the next step; milliseconds between steps
static volatile bool stepping;         // a step is running
static volatile bool is_paused = true; // no step may begin
static volatile bool is_after_step;    // a step has ended since the last tick (on_tick), and may_write has not been called since
static bool is_logging;                // the EEPROM write that may_write decides on is one of the log, for which no step may wait
static uint16_t skipped;                               // number of steps that were due while another step ran
static struct { uint32_t low, high; } now_g;           // G in milliseconds.  Two halves, because avr-gcc needs three times the code for a uint64_t

// Converts milliseconds to nanoseconds: multiplies by 125, 125 and 64, byte by byte.  This takes half the flash of gcc's multiplication.
typedef char firmware_multiplies_by_a_million[UINT32_C(125) * 125 * 64 == PAL_MILLISECOND ? 1 : -1];

// Multiplies `time`, 8 bytes in milliseconds with the low byte first, by 125 * 125 * 64 = 1000000.
static void to_nanoseconds(uint8_t *time)
{
    uint16_t digit = 0;

    for (uint8_t i = 0; i < 3 * sizeof(uint64_t); i++) {
        digit = (uint16_t)(digit + time[i & 7] * (i < 16 ? 125u : 64u));
        time[i & 7] = (uint8_t)digit;
        digit >>= 8;
    }
}

static void emit_event(uint8_t kind, uint8_t source, uint16_t a, uint32_t b)
{
    SmEvent e;

    e.time = avr_milliseconds();
    to_nanoseconds((uint8_t *)&e.time);
    e.kind = kind;
    e.source = source;
    e.a = a;
    e.b = b;
    sm_event(&events, &e);
}

// Emits an event for each machine that has changed its state.
static void report_states(void)
{
    for (uint8_t i = 0; i < runner.machines; i++) {
        const uint16_t to = (uint16_t)smvm_state(runner.vm[i]);
        if (to != state[i])
            emit_event(SM_EVENT_STATE, i, state[i], to);
        state[i] = to;
    }
}

static void step_machines(void)
{
    const uint16_t address = avr_eeprom_save_address();
    uint32_t add;

    smvm_runner_step(&runner, &now_g);
    report_states();
    avr_eeprom_restore_address(address);
    if (skipped > 0)
        emit_event(SM_EVENT_OVERRUN, 0, skipped, (uint32_t)skipped * period * 1000u);
    add = (uint32_t)period * (skipped + 1u);
    now_g.low += add;
    now_g.high += now_g.low < add;
    skipped = 0;
}

// Called every millisecond, in the interrupt of the clock.
static void on_tick(void)
{
    is_after_step = false;
    if (--ms_left > 0)
        return;
    ms_left = period;
    if (is_paused)
        return;
    if (stepping) {
        skipped += skipped < UINT16_MAX - 1;
        return;
    }
    stepping = true;
    GPIOR0 = 1;                            // lets an emulator of the chip count the cycles of a step
    sei();
    step_machines();
    cli();
    GPIOR0 = 0;
    stepping = false;
    is_after_step = true;
}

// Whether a byte write to EEPROM may start now: it ends before the next step, or a step has just ended.  (A period can be too short for a write
// between two steps.)
static bool may_write(void)
{
    const bool may = is_paused || ms_left > EEPROM_WRITE || (!(FIRMWARE_LOG && is_logging) && is_after_step);

    is_after_step = false;
    return may;
}

static SmResult run_image(SmvmBytes image, uint16_t milliseconds)
{
    SmResult r;

    is_paused = true;
    smvm_runner_stop(&runner);
    r = smvm_runner_open(&runner, image);
    if (r != SM_OK)
        return r;
    memset(state, 0, sizeof state);
    report_states();
    memset(&now_g, 0, sizeof now_g);
    skipped = 0;
    cli();
    period = milliseconds != 0 ? milliseconds : PERIOD;
    ms_left = 1;
    is_paused = false;
    sei();
    return SM_OK;
}

static AgentBoard board;

static void run_built_in(void)
{
    SmvmVerdict why;

    if (smvm_verify((SmvmBytes)(uint16_t)built_in, sizeof built_in, &why) != 0 || run_image((SmvmBytes)(uint16_t)built_in, PERIOD) != SM_OK)
        board.built_in_size = 0;           // so that the agent does not report the built-in image as running
}

// ---- callbacks for the agent ----

// Whether every machine is in a state marked @safe, or has no such state.
static bool is_safe(void)
{
    SmvmMachine m;
    bool safe = true;

    for (uint8_t i = 0; i < runner.machines && safe; i++) {
        uint16_t now_in;
        cli();
        now_in = state[i];
        sei();
        safe = !smvm_machine(runner.image, i, &m) || smvm_state_is_safe(&m, now_in);
    }
    return safe;
}

// Returns SM_OK if images can be changed now: the board is not armed and its machines are in safe states.
static SmResult may_update(void *context)
{
    (void)context;
    return is_armed() ? SM_E_ARMED : is_safe() ? SM_OK : SM_E_UNSAFE;
}

static SmResult fits_board(void *context, SmvmBytes image)
{
    (void)context;
    return smvm_runner_fits(&runner, image);
}

static SmResult leave_slot(void *context, const uint8_t *begin, uint8_t n);

static AgentBoard board = {
    .ram = FIRMWARE_MEMORY - (sizeof(SmVm) + 7) / 8 * 8, .machines = SMVM_RUNNER_MACHINES, 
    .abilities = (SM_ROLL_NONE ? 0 : LINK_WINDOWS) | (SMVM_PARAMETERS ? LINK_PARAMETERS : 0), .functions = SMVM_FUNCTIONS,
    .ram_digital = SMVM_RUNNER_DIGITAL, .ram_analog = SMVM_RUNNER_ANALOG, .period = PERIOD, .cycles = STEP_CYCLES,
    .physical_pin = physical_pin_of, .may_update = may_update, .fits = fits_board, .leave_slot = leave_slot, .built_in_size = sizeof built_in};

// ---- start ----

enum { RECORDS = 2 * STORE_RECORD, SLOT = (FIRMWARE_STORE - RECORDS) / FIRMWARE_SLOTS };

static Store store;
static Agent agent;
static PalSerial line;
static uint8_t frame[LINK_ROOM(FIRMWARE_BODY)];

#ifdef FIRMWARE_KEY
static void read_key(uint8_t *key)
{
    static const uint8_t in_flash[] PROGMEM = {
#include "key.inc"
    };

    memcpy_P(key, in_flash, SMVM_KEY);
}

static bool is_authentic(SmvmBytes image, uint32_t *number)
{
    uint8_t key[SMVM_KEY];

    read_key(key);
    return smvm_auth_check(image, key, number);
}

// Checks the permit in the body of a BEGIN.  Not inlined, so that its stack is released before the built-in image is started.
SMVM_NOINLINE static SmResult check_permit(const uint8_t *begin, uint8_t n)
{
    uint8_t key[SMVM_KEY];

    read_key(key);
    return smvm_permit_check(begin, n, sm_link_load(store.choice.newest, 4), key);
}

// Makes the store accept only images that are signed with the board's key.
static void use_key(void)
{
    uint8_t key[SMVM_KEY];

    read_key(key);
    board.mark = smvm_auth_mark(key);
    store.is_authentic = is_authentic;
}
#else
static SmResult check_permit(const uint8_t *begin, uint8_t n) { return (void)begin, (void)n, SM_OK; }
static void use_key(void) {}
#endif

// Checks a permit to begin an update. If it is good, runs the built-in image, so that the store's slot can be overwritten.
static SmResult leave_slot(void *context, const uint8_t *begin, uint8_t n)
{
    const SmResult r = check_permit(begin, n);

    (void)context;
    if (r == SM_OK)
        run_built_in();
    return r;
}

// Opens the store and gives it the board's key.  Returns false if the store could not be opened.
static bool open_store(PalNvm nvm, const StorePlan *plan)
{
    const SmResult r = smvm_store_open(&store, nvm, plan);

    use_key();
    return r == SM_OK;
}

static void start_store(void)
{
    const StorePlan plan = {FIRMWARE_STORE, FIRMWARE_SLOTS, {FIRMWARE_EEPROM + RECORDS, FIRMWARE_EEPROM + RECORDS + SLOT}};
    uint8_t slot = STORE_BUILT_IN;
    PalNvm nvm;

    if (pal_nvm_open(&nvm, "eeprom", FIRMWARE_STORE) == SM_OK && open_store(nvm, &plan))
        (void)smvm_store_boot(&store, &slot);
    for (uint8_t i = 0; i < FIRMWARE_SLOTS && slot != STORE_BUILT_IN; i++) {
        if (run_image(plan.image[slot], smvm_store_period(&store, slot)) == SM_OK)
            return;
        (void)smvm_store_skip_image(&store, &slot);          // the image cannot run, for example if it uses one pin of the chip twice
    }
    smvm_store_run_built_in(&store);
    run_built_in();
}

// Starts the parts of the board.  Not inlined, so that its stack is released before the main loop.
SMVM_NOINLINE static void start_board(void)
{
    uint64_t period_ns;
    bool caused = false;

    avr_clock_start(on_tick);
    avr_eeprom_guard_writes(may_write);
    (void)pal_watchdog_caused_start(&caused);
    (void)sm_events_init(&events);
    (void)pal_serial_open(&line, "Serial", BITS_PER_SECOND);
    sei();
    (void)pal_watchdog_start(4 * (uint64_t)PAL_SECOND, &period_ns);
    emit_event(SM_EVENT_START, 0, 0, caused);
    open_arming();
    start_store();
    board.built_in = (SmvmBytes)(uint16_t)built_in;
    smvm_agent_init(&agent, &store, &board, &events, frame, FIRMWARE_BODY);
}

// Whether the image has run for 10 s: the second byte of G, which counts units of 256 ms, has reached 40.  It wraps around every 65 s; then the
// result is false again for 10 s.  That is harmless: smvm_store_count_start, which the result triggers, needs one call only.  One byte is read
// because the interrupt of the clock cannot change it during the read.
static bool has_run_for_a_while(void) { return ((const volatile uint8_t *)&now_g.low)[1] >= 40; }

// Processes a received byte; returns false if no byte has arrived.
static bool serve_line(void)
{
    uint8_t byte;
    size_t n;
    uint16_t length;

    if (pal_serial_receive(line, &byte, 1, &n, 0) != SM_OK)
        return false;
    if ((length = smvm_agent_receive(&agent, byte)) > 0)
        (void)pal_serial_send(line, agent.frame, length, &n, 0);
    if (!agent.restart)
        return true;
    is_paused = true;
    smvm_runner_stop(&runner);
    while ((UCSR0A & 1 << TXC0) == 0)
        ;
    avr_restart();
}

// ---- the log of transitions ----

#if FIRMWARE_LOG
static StateLog state_log;
static uint32_t log_cursor;

// Opens the log of the image that runs. Neither this function nor write_log is inlined, so that their stack is released before requests are served.
SMVM_NOINLINE static void open_log(void)
{
    if (store.running != STORE_BUILT_IN)
        smvm_state_log_open(&state_log, store.plan.image[store.running], store.slot_size);
}

// Begins a record for the next transition, and writes the next byte of the current record, unless a step would have to wait for the write.
SMVM_NOINLINE static void write_log(void)
{
    static uint8_t earned_at;          // time of the last smvm_state_log_add_credit, in units of 8.192 s
    const uint8_t now = (uint8_t)(avr_milliseconds() >> 13);
    uint32_t lost;
    SmvmAt at;
    SmEvent e;
    uint8_t byte;

    if (state_log.records == 0)
        return;
    if (now != earned_at)
        smvm_state_log_add_credit(&state_log);
    earned_at = now;
    if (smvm_state_log_is_idle(&state_log) && sm_events_read(&events, &log_cursor, &e, 1, &lost) == 1)
        smvm_state_log_add(&state_log, &e, lost);
    if (!smvm_state_log_next(&state_log, &at, &byte))
        return;
    is_logging = true;
    if (avr_eeprom_begin_write((uint16_t)(state_log.image + at - FIRMWARE_EEPROM), byte))
        smvm_state_log_advance(&state_log);
    is_logging = false;
}
#else
static void open_log(void) {}
static void write_log(void) {}
#endif

void smvm_firmware(void)
{
    start_board();
    open_log();
    SMCR = 1 << SE;                        // enables idle mode, which the clock ends after at most a millisecond
    for (;;) {
        (void)pal_watchdog_feed();
        if (has_run_for_a_while())
            (void)smvm_store_count_start(&store);
        write_log();
        if (!serve_line())
            sleep_cpu();
    }
}

#ifndef ARDUINO                            // Arduino's core has its own main, which calls the sketch
int main(void) { smvm_firmware(); }
#endif

#endif
