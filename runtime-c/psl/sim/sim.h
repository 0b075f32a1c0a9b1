// SPDX-License-Identifier: Apache-2.0
// The simulated platform, for tests: the hand that moves its time, its pins and its lines, and that lets things fail.  One
// thread; nothing is real, so a run is the same each time.
//
//     sim_reset();
//     sim_wire(4, 7);                            // pin 7 follows pin 4
//     sim_fail(SIM_dio_write, 2, SM_E_DEVICE);   // the third write from now says so and does nothing
//     run_the_mission();                         // time moves when it sleeps or waits, by exactly as much
//     CHECK(sim_pin(4));
#ifndef PSL_SIM_H
#define PSL_SIM_H

#include "runtime-c/pal/pal.h"
#include "runtime-c/pal/socket.h"

#ifdef __cplusplus
extern "C" {
#endif

// Everything as it is when a program starts: time at 1 s, nothing open, pins low, no faults, memories gone.
void sim_reset(void);

// ---- faults ----

// The calls that can be made to fail or to take time: SIM_dio_write is pal_dio_write.
typedef enum SimCall {
#define SIM_CALL(name) SIM_##name,
#include "runtime-c/psl/sim/calls.def"
#undef SIM_CALL
    SIM_CALLS
} SimCall;

// After `after` more calls of that kind, one gives `result` and does nothing.  A later sim_fail takes the place of this one.
void sim_fail(SimCall call, uint32_t after, SmResult result);

// As sim_fail, and all after that one as well: the device is broken.  SM_OK mends it.
void sim_break(SimCall call, uint32_t after, SmResult result);

// From now on each call of that kind takes so many nanoseconds.
void sim_delay(SimCall call, uint64_t ns);

// How often such a call was made since sim_reset.
uint32_t sim_count(SimCall call);

// ---- time ----

void sim_advance(uint64_t ns);

// Each sleep ends so much later than it should.
void sim_oversleep(uint64_t ns);

// The world outside: from now on, whatever moves time, `world` is called at every multiple of `period` nanoseconds from here, when
// the clock shows just that, before whoever sleeps until then wakes.  It drives pins and looks at them; it must not wait or sleep.
// NULL, or a period of 0: none.
void sim_every(uint64_t period, void (*world)(void));

// ---- the console ----

// What was written since sim_reset, up to 4095 bytes of it.
const char *sim_console(void);

// ---- digital and analog ----

#define SIM_PINS 64

// Drives an input from outside; a pin that is neither driven nor wired reads as its pull resistor says, low without one.
void sim_drive(uint16_t pin, bool level);

// Connects pin `from`, an output, to pin `to`; channels likewise.
void sim_wire(uint16_t from, uint16_t to);
void sim_wire_analog(uint16_t from, uint16_t to);

// The level at a pin, as an oscilloscope would see it, and how often it has changed since sim_reset.
bool sim_pin(uint16_t pin);
uint32_t sim_edges(uint16_t pin);

// What a channel measures; what an output was set to.
void sim_set_analog(uint16_t channel, int32_t millionths);
int32_t sim_analog(uint16_t channel);

// ---- serial ----

// The far end of line "serial0" or "serial1": sends to it, takes what came from it (giving how much), pulls the plug or puts it
// back.
void sim_serial_send(const char *name, const void *bytes, size_t n);
size_t sim_serial_take(const char *name, void *bytes, size_t room);
void sim_serial_plug(const char *name, bool in);

// ---- the network ----

// All datagrams: each takes so long; of so many, counted from now, one is lost, comes twice, or comes after the next.  0: none.
typedef struct SimNetwork {
    uint64_t delay;
    uint32_t lose, repeat, reorder;
} SimNetwork;
void sim_network(SimNetwork network);

// ---- non-volatile memory ----

// The kinds of memory: "eeprom" (each byte on its own, no erase), "flash" (writes of 8, erase 32 at a time, to 0xff).
#define SIM_NVM_SIZE 2048u

// The power goes in the write, erase or append to a log that comes after `after` more of them, when `bytes` bytes of it are done (and
// one byte more is anything).  That call and all after it give SM_E_DEVICE until sim_power_on, which closes all memories and
// logs and keeps what they hold.
void sim_cut_power(uint32_t after, uint32_t bytes);
void sim_power_on(void);

// The SIM_NVM_SIZE bytes of a memory, to be looked at and damaged.
uint8_t *sim_nvm(const char *name);

// From now on those of `bits` at a place of that memory read as `value` has them, whatever is written.  0 bits: it is mended.
void sim_stick(const char *name, uint32_t at, uint8_t bits, uint8_t value);

// ---- logs ----

// How many there can be, and how many bytes each holds.
#define SIM_LOGS 2
#ifndef SIM_LOG_SIZE
#define SIM_LOG_SIZE 1048576u
#endif

// What the log of that name holds, *n bytes, until sim_reset; NULL: there is none.  How many of them a sync has brought to the medium.
const uint8_t *sim_log(const char *name, size_t *n);
size_t sim_log_synced(const char *name);

// From now on a log takes no more than so many bytes in all.
void sim_log_space(uint32_t bytes);

// The log of that name loses its end and has no more than so many bytes, as on a file system that was repaired.
void sim_log_shrink(const char *name, size_t bytes);

// ---- the watchdog ----

// Whether it has bitten: time went by without food.
bool sim_watchdog_bitten(void);

#ifdef __cplusplus
}
#endif
#endif
