// SPDX-License-Identifier: Apache-2.0
// What a target may decide about the VM.  Define SMVM_CONFIG as the name of a header ("my_vm_config.h") that defines any
// of these, or have a header "smc_config.h" on the path; the rest is as below.
#ifndef SMVM_CONFIG_H
#define SMVM_CONFIG_H

#include <stddef.h>
#include <stdint.h>

#if !defined(SMVM_CONFIG) && defined(__has_include)
#if __has_include("smc_config.h")
#define SMVM_CONFIG "smc_config.h"
#endif
#endif
#ifdef SMVM_CONFIG
#include SMVM_CONFIG
#elif defined(__AVR__)              // images in flash
#include <avr/pgmspace.h>
#define SMVM_BYTES uint16_t
#define SMVM_FETCH(image, at) pgm_read_byte((const uint8_t *)((image) + (uint16_t)(at)))
#define SMVM_FETCH_AVR 1
#define SMVM_AT uint16_t
#define SMVM_IMAGE_MAX 0x7fffu
#define SMVM_RAM_MAX 0x7fffu
#endif

// Where an image lies, and how its bytes are read: the only access to an image there is.  For EEPROM: define SMVM_BYTES as uint16_t and
// SMVM_FETCH(image, at) as eeprom_read_byte((image) + (at)), or as what tells memories apart.  An SMVM_BYTES plus an offset is where the
// bytes from there on lie.
#ifndef SMVM_FETCH
#define SMVM_BYTES const uint8_t *
#define SMVM_FETCH(image, at) ((image)[at])
#define SMVM_TEXT(image, at) ((const char *)(image) + (at))
#endif

// Assembly in place of the interpreter, on AVR with uint16_t as SMVM_BYTES and SMVM_AT, and with SMVM_KEEP_TABLES: 1 interp_avr.S, where
// SMVM_FETCH reads flash; 2 interp_avr_eeprom.S, where it reads EEPROM at addresses from 0x8000 on, less that, and flash below; 0 none.
#if !defined(SMVM_FETCH_AVR) || !defined(__AVR_HAVE_MUL__) || defined(SMVM_PORTABLE)
#undef SMVM_FETCH_AVR
#define SMVM_FETCH_AVR 0
#endif

// Names in an image as text, where an image lies in memory like any other.
#ifndef SMVM_TEXT
#define SMVM_TEXT(image, at) ""
#endif

// Holds any offset in an image and in a state vector: uint16_t where neither reaches 64 KB, as the two limits below say.  Its largest
// value is beyond both: what is larger than this target can hold becomes that.
#ifndef SMVM_AT
#define SMVM_AT uint32_t
#endif

// The largest image; and the most RAM that one machine may need, and the largest state vector.  Images beyond are refused.
#ifndef SMVM_IMAGE_MAX
#define SMVM_IMAGE_MAX 0x00ffffffu
#endif
#ifndef SMVM_RAM_MAX
#if SIZE_MAX < 0x7fffffff
#define SMVM_RAM_MAX 0x7fffu
#else
#define SMVM_RAM_MAX 0x7fffffffu
#endif
#endif

// 1: a machine that runs keeps in RAM where its tables are, ten SMVM_AT and a byte; 0: it reads that out of the image at each step,
// which takes an 8-bit computer several thousand cycles.
#ifndef SMVM_KEEP_TABLES
#if SIZE_MAX < 0x7fffffff
#define SMVM_KEEP_TABLES 1
#else
#define SMVM_KEEP_TABLES 0
#endif
#endif

// Whether the verifier counts the longest step: 1; or 0, where that is for whoever sends images to know.
#ifndef SMVM_LONGEST
#if SIZE_MAX < 0x7fffffff
#define SMVM_LONGEST 0
#else
#define SMVM_LONGEST 1
#endif
#endif

// 1: the memory of images (target/store.h) is written byte by byte and again without erasing, as an EEPROM is, and the store is made for no other;
// 0: it goes by what the memory says of itself.
#ifndef SMVM_STORE_BYTES
#define SMVM_STORE_BYTES 0
#endif

// Whether the store and the agent can have a key (target/store.h): 1; or 0, where no board that they are made for has one.
#ifndef SMVM_STORE_KEY
#define SMVM_STORE_KEY 1
#endif

// How many jumps whose targets are still ahead the verifier follows exactly when it counts the longest step; beyond, it adds
// up all instructions, which is never less.  Eight bytes of its stack each.
#ifndef SMVM_JOINS
#define SMVM_JOINS 32
#endif

// Whether the decoded form goes from instruction to instruction by addresses of labels, which GNU C has.
#ifndef SMVM_COMPUTED_GOTO
#ifdef __GNUC__
#define SMVM_COMPUTED_GOTO 1
#else
#define SMVM_COMPUTED_GOTO 0
#endif
#endif

// Of functions that are seldom called by those that are called at every turn: not made part of them where code is to be small.
#if defined(__GNUC__) && defined(__OPTIMIZE_SIZE__)
#define SMVM_APART __attribute__((noinline))
#else
#define SMVM_APART
#endif

// Of small functions whose arguments must stay in registers.
#ifdef __GNUC__
#define SMVM_INLINE static inline __attribute__((always_inline))
#else
#define SMVM_INLINE static inline
#endif

typedef SMVM_BYTES SmvmBytes;

// An array as an image, where the VM fetches from the memory that the array is in; and what puts it there: `const uint8_t a[] SMVM_IMAGE_IN = {…}`
// is in flash on AVR, whose constants are copied into RAM else.
#define SMVM_IMAGE(array) ((SmvmBytes)(uintptr_t)(array))
#ifndef SMVM_IMAGE_IN
#ifdef __AVR__
#define SMVM_IMAGE_IN __attribute__((__progmem__))
#else
#define SMVM_IMAGE_IN
#endif
#endif
typedef SMVM_AT SmvmAt;

typedef char smvm_at_is_too_small[SMVM_IMAGE_MAX < (SMVM_AT)-1 && SMVM_RAM_MAX < (SMVM_AT)-1 && SMVM_RAM_MAX <= (size_t)-1 / 2 ? 1 : -1];
typedef char smvm_joins_are_1_to_255[SMVM_JOINS >= 1 && SMVM_JOINS <= 255 ? 1 : -1];

#endif
