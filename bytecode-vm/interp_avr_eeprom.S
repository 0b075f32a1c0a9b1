// SPDX-License-Identifier: Apache-2.0
// Like interp_avr.S, for images in flash below 0x8000 or in EEPROM from 0x8000 on.
#define SMVM_EEPROM
#include "bytecode-vm/interp_avr.S"
