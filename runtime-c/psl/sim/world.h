// SPDX-License-Identifier: Apache-2.0
// What the files of the simulated platform share; tests use sim.h.
#ifndef PSL_SIM_WORLD_H
#define PSL_SIM_WORLD_H

#include "runtime-c/psl/sim/sim.h"
#include "runtime-c/psl/table.h"

// Comes first in each call that a test may disturb: counts it, lets its time go by, gives the result it is to fail with, or SM_OK.
SmResult sim_enter(SimCall call);

// Moves time to `time` if it is earlier.
void sim_move_to(uint64_t time);

// Each file's part of sim_reset.
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

// Each write, erase or append of n bytes that is about to happen: how many of them the power lasts for.  Once it is gone nothing works.
uint32_t sim_power_lasts(uint32_t n);
bool sim_power_gone(void);

// The power comes back: all is closed, the rest is as it was.
void sim_log_power_on(void);

// Feeds nothing: tells the watchdog what time it is.
void sim_watchdog_look(uint64_t now);

#endif
