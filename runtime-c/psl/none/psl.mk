# SPDX-License-Identifier: Apache-2.0
# The platform without any devices: the starting point of a new platform, and the source of stubs for missing devices.
PSL      = $(patsubst %,runtime-c/psl/none/%.c,clock console thread lock socket dio aio serial nvm log watchdog)
PSL_LIBS =
