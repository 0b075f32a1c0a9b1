# SPDX-License-Identifier: Apache-2.0
# A desk: simulated time, pins and lines (../sim), with the real console, logs and memories of the computer (../linux).  An application
# runs on it faster than real time, the same way in every run, and leaves its log.
PSL      = $(patsubst %,runtime-c/psl/sim/%.c,world clock lock network socket dio aio serial watchdog) runtime-c/psl/none/thread.c \
           $(patsubst %,runtime-c/psl/linux/%.c,linux console nvm log) runtime-c/psl/desk/desk.c
PSL_LIBS = -pthread
