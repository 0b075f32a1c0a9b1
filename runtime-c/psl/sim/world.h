// SPDX-License-Identifier: Apache-2.0
// Internal to the simulated platform; tests use sim.h.
#ifndef PSL_SIM_WORLD_H
#define PSL_SIM_WORLD_H

#include "runtime-c/psl/sim/sim.h"
#include "runtime-c/psl/table.h"

// Every function that SimCall names calls this first.  Counts the call, advances time by the delay set with sim_delay, and returns the error
// that sim_fail or sim_break injects into this call; SM_OK if the call shall succeed.
SmResult sim_begin_call(SimCall call);

// Advances time to `time`, if that is in the future.
void sim_advance_to(uint64_t time);

// For a call that waits for something that the world (sim_every) may do: advances time to `end`, but stops after the next action of
// the world.  The caller then checks again.  Returns false if `end` had been reached before.
bool sim_wait(uint64_t end);

// Each resets one part of the platform, for sim_reset.
void sim_clock_reset(void);
void sim_console_reset(void);
void sim_lock_reset(void);
void sim_dio_reset(void);
void sim_aio_reset(void);
void sim_serial_reset(void);
void sim_socket_reset(void);
void sim_nvm_reset(void);
void sim_log_reset(void);
void sim_watchdog_reset(void);

// Called before each write, erase or append of n bytes: returns how many are stored before a power cut.  After the cut all calls
// fail.
uint32_t sim_bytes_before_power_cut(uint32_t n);
bool sim_is_power_off(void);

// Power on: all logs are closed, their content is unchanged.
void sim_log_power_on(void);

// Reports the current time to the watchdog, without feeding it.
void sim_watchdog_check(uint64_t now);

#endif
