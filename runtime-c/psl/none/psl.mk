# SPDX-License-Identifier: Apache-2.0
# The platform that has nothing: what a new one starts from, and what stands in where one has no such thing.
PSL      = $(patsubst %,runtime-c/psl/none/%.c,clock console thread lock socket dio aio serial nvm log watchdog)
PSL_LIBS =
