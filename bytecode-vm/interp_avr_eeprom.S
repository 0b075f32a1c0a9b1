// SPDX-License-Identifier: Apache-2.0
// As interp_avr.S, for images in flash below 0x8000 or in EEPROM from there on.
#define SMVM_EEPROM
#include "bytecode-vm/interp_avr.S"
