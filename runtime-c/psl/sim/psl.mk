# SPDX-License-Identifier: Apache-2.0
# The simulated platform, for tests.  It has no threads.
PSL      = $(patsubst %,runtime-c/psl/sim/%.c,world clock console lock network socket dio aio serial nvm log watchdog) \
           runtime-c/psl/none/thread.c
PSL_LIBS =
