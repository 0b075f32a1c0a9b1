# SPDX-License-Identifier: Apache-2.0
# Linux with glibc or musl; 3.10 or later, for digital pins 5.10.
PSL      = $(patsubst %,runtime-c/psl/linux/%.c,linux clock console thread lock socket dio serial nvm) \
           $(patsubst %,runtime-c/psl/none/%.c,aio watchdog)
PSL_LIBS = -pthread
