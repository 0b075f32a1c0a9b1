# SPDX-License-Identifier: Apache-2.0
# Linux with glibc or musl; 3.10 or later, for digital pins 5.10.
# Which watchdog: `watchdog`, the hardware's; `watchdog_process`, a timer that ends the program.
PSL_WATCHDOG ?= watchdog
PSL      = $(patsubst %,runtime-c/psl/linux/%.c,linux clock console thread lock socket dio aio serial nvm log $(PSL_WATCHDOG))
PSL_LIBS = -pthread -lrt
