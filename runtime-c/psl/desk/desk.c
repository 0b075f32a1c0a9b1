// SPDX-License-Identifier: Apache-2.0
// What sim_reset starts anew and a desk does not: a console, memories and logs that are real.
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
