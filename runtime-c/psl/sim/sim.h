// SPDX-License-Identifier: Apache-2.0
// The simulated platform, for tests.  This header lets a test control time, pins and lines, and inject faults.  There is one
// thread, and nothing depends on the real world, so a run is the same each time.
//
//     sim_reset();
//     sim_wire(4, 7);                            // pin 7 follows output pin 4
//     sim_fail(SIM_dio_write, 2, SM_E_DEVICE);   // the third write from now fails with this result and does nothing
//     run_the_mission();                         // a sleep or wait advances time by exactly its duration
//     CHECK(sim_pin(4));
#ifndef PSL_SIM_H
#define PSL_SIM_H

#include "runtime-c/pal/pal.h"
#include "runtime-c/pal/socket.h"

#ifdef __cplusplus
extern "C" {
#endif

// Restores the state of program start: time at 1 s, nothing open, pins low, no faults, memories and logs erased.
void sim_reset(void);

// ---- faults ----

// The calls for which a test can inject faults or delays: SIM_dio_write is pal_dio_write.
typedef enum SimCall {
#define SIM_CALL(name) SIM_##name,
#include "runtime-c/psl/sim/calls.def"
#undef SIM_CALL
    SIM_CALLS
} SimCall;

// After `after` more calls of that kind, one call fails with `result` and does nothing.  A later sim_fail replaces this one.
void sim_fail(SimCall call, uint32_t after, SmResult result);

// Like sim_fail, but all later calls fail too: the device is broken.  SM_OK repairs it.
void sim_break(SimCall call, uint32_t after, SmResult result);

// From now on each call of that kind takes `ns` nanoseconds.
void sim_delay(SimCall call, uint64_t ns);

// Returns the number of calls of that kind since sim_reset.
uint32_t sim_count(SimCall call);

// ---- time ----

void sim_advance(uint64_t ns);

// Each sleep ends `ns` nanoseconds late.
void sim_oversleep(uint64_t ns);

// Simulates the external world.  From now on `world` is called every `period` nanoseconds, whatever advances the time.  The clock
// then shows exactly that time, and threads that sleep until then have not continued yet.  `world` may set and read pins, send and
// receive, but must not wait or sleep. A call that waits, for instance to receive, returns at the time at which `world` ends its
// wait.  NULL or a period of 0 removes it.
void sim_every(uint64_t period, void (*world)(void));

// ---- the console ----

// Returns the text written since sim_reset, at most 4095 bytes.
const char *sim_console(void);

// ---- digital and analog ----

#define SIM_PINS 64

// Drives a pin externally.  A pin that is neither driven nor wired reads as the level of its pull resistor, or low without one.
void sim_drive(uint16_t pin, bool level);

// Connect output pin `from` to pin `to`, or analog output `from` to analog input `to`.
void sim_wire(uint16_t from, uint16_t to);
void sim_wire_analog(uint16_t from, uint16_t to);

// sim_pin returns the level at a pin, as on an oscilloscope; sim_count_pin_changes, how often it has changed since sim_reset.
bool sim_pin(uint16_t pin);
uint32_t sim_count_pin_changes(uint16_t pin);

// Sets the value that a channel measures; reads the value of an output.
void sim_set_analog(uint16_t channel, int32_t millionths);
int32_t sim_analog(uint16_t channel);

// ---- serial ----

// The remote end of line "serial0" or "serial1": sends bytes to the program, receives the program's bytes (returning their
// number), or unplugs and replugs the line.
void sim_serial_send(const char *name, const void *bytes, size_t n);
size_t sim_serial_receive(const char *name, void *bytes, size_t room);
void sim_serial_plug(const char *name, bool in);

// ---- the network ----

// Applies to all datagrams.  `delay` is their transit time in nanoseconds.  Of every `lose`, `repeat` or `reorder` datagrams,
// counted from now, one is lost, arrives twice, or arrives after the next one.  0: none.
typedef struct SimNetwork {
    uint64_t delay;
    uint32_t lose, repeat, reorder;
} SimNetwork;
void sim_network(SimNetwork network);

// Applies to all streams.  `connect`: nanoseconds until the answer to pal_socket_connect_start arrives.  `send`, `receive`: the most
// bytes that one attempt to send or receive transfers; 0: no limit.  A connection that is refused: no socket listens.
typedef struct SimStreams {
    uint64_t connect;
    uint32_t send, receive;
} SimStreams;
void sim_streams(SimStreams faults);

// ---- non-volatile memory ----

// The memories: "eeprom" (single bytes, no erase) and "flash" (writes of 8 bytes, erases of 32 bytes, to 0xff).
#define SIM_NVM_SIZE 2048u

// Cuts the power during a write, an erase or an append to a log, after `after` more of these calls.  The call stores `bytes`
// bytes, and the byte after them becomes undefined.  It and all later calls of memories and logs return SM_E_DEVICE until
// sim_power_on, except pal_nvm_info and the two closes, which do not access the medium.  sim_power_on closes all memories and logs
// and preserves their content.
void sim_cut_power(uint32_t after, uint32_t bytes);
void sim_power_on(void);

// Returns the SIM_NVM_SIZE bytes of a memory.  Tests may read and damage them.
uint8_t *sim_nvm(const char *name);

// From now on the bits in `bits` of byte `at` have the values in `value`, whatever is written.  `bits` = 0 repairs it.
void sim_stick(const char *name, uint32_t at, uint8_t bits, uint8_t value);

// ---- logs ----

// Maximum number of logs, and bytes in each.
#define SIM_LOGS 2
#ifndef SIM_LOG_SIZE
#define SIM_LOG_SIZE 1048576u
#endif

// sim_log returns the content of the log with that name, *n bytes, valid until sim_reset; NULL if no log has it.  sim_log_synced
// returns how many of its bytes were appended before the last sync.
const uint8_t *sim_log(const char *name, size_t *n);
size_t sim_log_synced(const char *name);

// From now on a log accepts at most `bytes` bytes in total.
void sim_log_space(uint32_t bytes);

// Truncates the log with that name to at most `bytes` bytes, like the repair of a file system.
void sim_log_shrink(const char *name, size_t bytes);

// ---- the watchdog ----

// Whether the watchdog has fired, because it was not fed in time.
bool sim_watchdog_fired(void);

#ifdef __cplusplus
}
#endif
#endif
