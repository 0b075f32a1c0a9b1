// SPDX-License-Identifier: Apache-2.0
// Empty resets for the parts that are real and not simulated on a desk: console, memories and logs.
#include "runtime-c/psl/sim/world.h"

void sim_console_reset(void)
{
}

void sim_nvm_reset(void)
{
}

void sim_log_reset(void)
{
}
