// SPDX-License-Identifier: Apache-2.0
// The VM on an ATmega328P: images in flash, or with VM_EEPROM as in the firmware.
#ifdef VM_EEPROM
#define SMVM_FETCH_AVR 2
#include "bytecode-vm/firmware/config.h"
#else
#include <avr/pgmspace.h>
#define SMVM_BYTES uint16_t
#define SMVM_FETCH(image, at) pgm_read_byte((const uint8_t *)((image) + (uint16_t)(at)))
#define SMVM_FETCH_AVR 1
#define SMVM_AT uint16_t
#define SMVM_IMAGE_MAX 0x7fffu
#define SMVM_RAM_MAX 0x7fffu
#endif
