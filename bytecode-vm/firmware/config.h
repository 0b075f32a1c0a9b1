// SPDX-License-Identifier: Apache-2.0
// Configures VM and runtime for the firmware (SMVM_CONFIG, SM_CONFIG).  Images are in flash, or in EEPROM at addresses from 0x8000 on.
#ifndef SMVM_FIRMWARE_CONFIG_H
#define SMVM_FIRMWARE_CONFIG_H

#include <stdint.h>

#define FIRMWARE_EEPROM 0x8000u
#ifdef __AVR__
#include <avr/eeprom.h>
#include <avr/pgmspace.h>
static inline uint8_t smvm_firmware_byte(uint16_t at)
{
    return at < FIRMWARE_EEPROM ? pgm_read_byte(at) : eeprom_read_byte((const uint8_t *)(at - FIRMWARE_EEPROM));
}
#endif

#define SMVM_BYTES uint16_t
#define SMVM_FETCH(image, at) smvm_firmware_byte((uint16_t)((image) + (uint16_t)(at)))
#ifndef SMVM_FETCH_AVR
#define SMVM_FETCH_AVR 2
#endif
#define SMVM_AT uint16_t
#define SMVM_IMAGE_MAX 0x7fffu
#define SMVM_RAM_MAX 0x7fffu
#define SMVM_STORE_BYTES 1
#ifndef FIRMWARE_KEY
#define SMVM_STORE_KEY 0
#endif
#define PAL_LOCKS 1

// These depend on the chip.  FIRMWARE_STORE, FIRMWARE_SLOTS: bytes of EEPROM that the store uses, and the number of its slots.
// FIRMWARE_MEMORY: bytes of RAM for state vector, machines and pins.  FIRMWARE_EVENTS: the number of events that are stored.
// FIRMWARE_LOG: 1 if transitions are stored in EEPROM (target/state_log.h).  FIRMWARE_BODY: the largest body of a frame, in bytes.  A frame with
// its head, its end and a zero before it must fit into the ring buffer of the line: otherwise a request that arrives during a long step would be
// cut off.
#if defined(__AVR_ATmega2560__)
#define FIRMWARE_STORE 4096
#define FIRMWARE_SLOTS 2
#define FIRMWARE_MEMORY 5120
#define FIRMWARE_EVENTS 32
#define FIRMWARE_LOG 1
#define FIRMWARE_BODY 96
#define AVR_SERIAL_RING 128
#define SM_ROLL_WAITING 12
#else
#ifndef SMVM_FUNCTIONS
#define SMVM_FUNCTIONS UINT32_C(0)                    // no room for elementary functions, in flash or on the stack
#endif
#define FIRMWARE_STORE 1024
#define FIRMWARE_SLOTS 1
#define FIRMWARE_MEMORY 1024
#define FIRMWARE_EVENTS 4
#define FIRMWARE_LOG 0        // an Uno has no RAM for a log: the stack needs nearly all of it
#define FIRMWARE_BODY 48
#define AVR_SERIAL_RING 64
#define SM_ROLL_WAITING 9
#endif

#endif
