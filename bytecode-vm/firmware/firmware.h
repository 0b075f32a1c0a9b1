// SPDX-License-Identifier: Apache-2.0
// The generic firmware (docs/boards.md) as a function, for programs that have their own main, such as Arduino sketches.
#ifndef SMVM_FIRMWARE_H
#define SMVM_FIRMWARE_H

#ifdef __cplusplus
extern "C" {
#endif

// Uses timer 0, the serial line and the EEPROM, and never returns.  On AVR.
#ifdef __GNUC__
__attribute__((noreturn))
#endif
void smvm_firmware(void);

#ifdef __cplusplus
}
#endif
#endif
