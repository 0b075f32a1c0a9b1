// SPDX-License-Identifier: Apache-2.0
// The generic firmware (docs/boards.md) as a function, for programs that have their own main, such as Arduino sketches.
#ifndef SMVM_FIRMWARE_H
#define SMVM_FIRMWARE_H

#include "runtime-c/psl/avr/chip.h"

#ifdef PSL_AVR
#define SMVM_HAS_FIRMWARE     // the firmware supports this board

#ifdef __cplusplus
extern "C" {
#endif

// Uses timer 0, the serial line and the EEPROM, and never returns.
__attribute__((noreturn)) void smvm_firmware(void);

#ifdef __cplusplus
}
#endif
#endif
#endif
