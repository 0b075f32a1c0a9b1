// SPDX-License-Identifier: Apache-2.0
// Defines PSL_AVR on the boards that this platform supports: Uno, Nano and Pro Mini (ATmega328P), Mega (ATmega2560), at 16 or 8 MHz.
// For other chips these files compile to nothing.
#ifndef PSL_AVR_CHIP_H
#define PSL_AVR_CHIP_H

#if defined(__AVR_ATmega328P__) || defined(__AVR_ATmega2560__)
#if F_CPU == 16000000 || F_CPU == 8000000
#define PSL_AVR
#elif !defined(ARDUINO)       // an Arduino library is compiled as a whole, also for sketches that use only its VM
#error "smc: build with -DF_CPU=16000000UL or -DF_CPU=8000000UL, the clock of the board; the platform layer counts time with no other"
#endif
#endif

#endif
