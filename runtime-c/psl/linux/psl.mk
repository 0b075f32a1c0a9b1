# SPDX-License-Identifier: Apache-2.0
# Linux with glibc or musl; 3.10 or later, for digital pins 5.10.
# Watchdog: `watchdog` is the hardware's; `watchdog_process` is a timer that kills the program.
PSL_WATCHDOG ?= watchdog
PSL      = $(patsubst %,runtime-c/psl/linux/%.c,linux clock console thread lock socket dio aio serial nvm log $(PSL_WATCHDOG))
PSL_LIBS = -pthread -lrt
