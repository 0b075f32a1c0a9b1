# SPDX-License-Identifier: Apache-2.0
# NI sbRIO and other controllers with NI Linux Real-Time: the files of ../linux, with pins and channels in the FPGA.  The program also needs a
# table of pins (fpga.h) and two files that NI's FPGA Interface C API Generator writes: NiFpga.c, and NiFpga.h on the include path.
# docs/sbrio.md has the steps.  Watchdog: as in ../linux.
PSL_WATCHDOG ?= watchdog
PSL      = $(patsubst %,runtime-c/psl/linux/%.c,linux clock console thread lock socket serial nvm log $(PSL_WATCHDOG)) \
           $(patsubst %,runtime-c/psl/sbrio/%.c,session dio aio)
PSL_LIBS = -pthread -lrt -ldl
