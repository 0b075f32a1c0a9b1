# SPDX-License-Identifier: Apache-2.0
# A desk: simulated time, pins and lines (../sim), with the console, the logs and the memories of the computer it stands on (../linux). An
# application flies on it in a fraction of the time, the same in every run, and leaves its log.
PSL      = $(patsubst %,runtime-c/psl/sim/%.c,world clock lock network socket dio aio serial watchdog) runtime-c/psl/none/thread.c \
           $(patsubst %,runtime-c/psl/linux/%.c,linux console nvm log) runtime-c/psl/desk/desk.c
PSL_LIBS = -pthread
