# SPDX-License-Identifier: Apache-2.0
# Arduino Uno and Mega (ATmega328P, ATmega2560) without the Arduino core: avr-gcc and avr-libc are enough.
PSL      = $(patsubst %,runtime-c/psl/avr/%.c,clock lock dio aio serial nvm watchdog) \
           $(patsubst %,runtime-c/psl/none/%.c,console thread socket log)
PSL_LIBS =
