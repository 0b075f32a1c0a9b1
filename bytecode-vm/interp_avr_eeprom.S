// SPDX-License-Identifier: Apache-2.0
// The interpreter of interp_avr.S for images in flash, at addresses below 0x8000, or in EEPROM, at addresses from 0x8000 on.
#define SMVM_EEPROM
#include "bytecode-vm/interp_avr.S"
