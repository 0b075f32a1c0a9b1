// SPDX-License-Identifier: Apache-2.0
// The settings of the VM that a target can override.  Define SMVM_CONFIG as the name of a header ("my_vm_config.h") that defines
// any of them, or put a header "smc_config.h" on the include path.  The defaults are below.
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

// Where an image is stored, and how the VM reads its bytes.  SMVM_FETCH is the only access to an image.  For EEPROM, define SMVM_BYTES as
// uint16_t and SMVM_FETCH(image, at) as eeprom_read_byte((image) + (at)), or as a function that selects among several memories.  An
// SMVM_BYTES plus an offset must refer to the bytes from that offset on.
#ifndef SMVM_FETCH
#define SMVM_BYTES const uint8_t *
#define SMVM_FETCH(image, at) ((image)[at])
#define SMVM_TEXT(image, at) ((const char *)(image) + (at))
#endif

// Selects assembly in place of the C interpreter.  The assembly requires an AVR, uint16_t as SMVM_BYTES and SMVM_AT, and SMVM_KEEP_TABLES.
//   0  none
//   1  interp_avr.S: SMVM_FETCH reads flash
//   2  interp_avr_eeprom.S: SMVM_FETCH reads EEPROM at address - 0x8000 for addresses from 0x8000 on, and flash below
#if !defined(SMVM_FETCH_AVR) || !defined(__AVR_HAVE_MUL__) || defined(SMVM_PORTABLE)
#undef SMVM_FETCH_AVR
#define SMVM_FETCH_AVR 0
#endif

// A pointer to a name in an image, if the image is in memory that pointers can address; otherwise an empty name.
#ifndef SMVM_TEXT
#define SMVM_TEXT(image, at) ""
#endif

// A type for any offset in an image or in a state vector: uint16_t if both limits below are under 64 KB.  Its largest value is beyond both
// limits, and represents every offset or size that this target cannot hold.
#ifndef SMVM_AT
#define SMVM_AT uint32_t
#endif

// SMVM_IMAGE_MAX: bytes of the largest image.  SMVM_RAM_MAX: limit, in bytes, on the RAM of one machine and on the size of a state vector.  The
// verifier rejects images beyond these limits.
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

// 1: a running machine stores the offsets of its tables in RAM, which takes nine SMVM_AT and a byte.  0: each step reads them from the
// image, which takes an 8-bit computer several thousand cycles and a 64-bit one as long as a step of a small machine.  The default is 0
// for 32-bit chips, where RAM is scarce.
#ifndef SMVM_KEEP_TABLES
#if SIZE_MAX < 0x7fffffff || SIZE_MAX > 0xffffffff
#define SMVM_KEEP_TABLES 1
#else
#define SMVM_KEEP_TABLES 0
#endif
#endif

// 1: the interpreter has code of its own for each opcode (interp.def), so a step executes half as many CPU instructions.  0: opcodes share
// code, which is 16 KB smaller on x86-64.
#ifndef SMVM_SPECIALIZE
#if SIZE_MAX < 0x7fffffff || defined(__OPTIMIZE_SIZE__)
#define SMVM_SPECIALIZE 0
#else
#define SMVM_SPECIALIZE 1
#endif
#endif

// 1: the verifier computes the longest step.  0: it does not; the sender of an image must check it.
#ifndef SMVM_LONGEST
#if SIZE_MAX < 0x7fffffff
#define SMVM_LONGEST 0
#else
#define SMVM_LONGEST 1
#endif
#endif

// The elementary functions that the VM has: bit n is set for the function with number n (stdlib/elementary.def).  The verifier refuses an image
// that calls another.  On AVR a call needs up to 309 bytes of stack, and all functions 26 KB of flash (docs/evidence/speed.md).
#ifndef SMVM_FUNCTIONS
#define SMVM_FUNCTIONS UINT32_MAX
#endif

// 1: the VM runs images whose machines have parameters (language.md 5.77).  0: the verifier refuses them, because their section is unknown,
// which saves 1.1 KB of flash and 8 bytes of stack on AVR.  The boot loader of an Arduino Pro takes 2 KB, which leaves no room for parameters.
#ifndef SMVM_PARAMETERS
#ifdef ARDUINO_AVR_PRO
#define SMVM_PARAMETERS 0
#else
#define SMVM_PARAMETERS 1
#endif
#endif

// 1: the store (target/store.h) supports only memory that can be written byte by byte and again without erasing, such as EEPROM.
// 0: it asks the memory for these properties at run time.
#ifndef SMVM_STORE_BYTES
#define SMVM_STORE_BYTES 0
#endif

// 1: the store and the agent support a key (target/store.h).  0: they do not, for builds whose boards never have one.
#ifndef SMVM_STORE_KEY
#define SMVM_STORE_KEY 1
#endif

// How many pending forward jump targets the verifier follows exactly when it computes the longest step.  Beyond that number it adds up all
// instructions instead, which is never less than the exact result.  Each target takes eight bytes of the verifier's stack.
#ifndef SMVM_JOINS
#define SMVM_JOINS 32
#endif

// 1: the interpreters dispatch by addresses of labels, an extension of GNU C.  0: by a switch.
#ifndef SMVM_COMPUTED_GOTO
#ifdef __GNUC__
#define SMVM_COMPUTED_GOTO 1
#else
#define SMVM_COMPUTED_GOTO 0
#endif
#endif

// Runs at each instruction that the C interpreter executes, for tests that count instructions.
#ifndef SMVM_ON_INSTRUCTION
#define SMVM_ON_INSTRUCTION (void)0
#endif

// For functions that their callers run rarely: not inlined when the compiler optimizes for size.
#if defined(__GNUC__) && defined(__OPTIMIZE_SIZE__)
#define SMVM_NOINLINE __attribute__((noinline))
#else
#define SMVM_NOINLINE
#endif

// For functions that frequently executed code calls rarely: never inlined, and compilers keep the callers' registers for the other paths.
#ifdef __GNUC__
#define SMVM_RARE __attribute__((cold, noinline))
#else
#define SMVM_RARE
#endif

// For small functions in frequently executed code: always inlined.
#ifdef __GNUC__
#define SMVM_INLINE static inline __attribute__((always_inline))
#else
#define SMVM_INLINE static inline
#endif

// Tells the compiler that a condition is rarely true, or almost always.
#ifdef __GNUC__
#define SMVM_LIKELY(condition) __builtin_expect((condition) != 0, 1)
#define SMVM_UNLIKELY(condition) __builtin_expect((condition), 0)
#else
#define SMVM_LIKELY(condition) (condition)
#define SMVM_UNLIKELY(condition) (condition)
#endif

typedef SMVM_BYTES SmvmBytes;

// SMVM_IMAGE converts an array to an image; the array must be in the memory that the VM fetches from.  SMVM_IMAGE_IN puts it there:
// `const uint8_t a[] SMVM_IMAGE_IN = {…}` is in flash on AVR.  Without it, AVR copies constants into RAM.
#define SMVM_IMAGE(array) ((SmvmBytes)(uintptr_t)(array))
#ifndef SMVM_IMAGE_IN
#ifdef __AVR__
#define SMVM_IMAGE_IN __attribute__((__progmem__))
#else
#define SMVM_IMAGE_IN
#endif
#endif
typedef SMVM_AT SmvmAt;

#ifndef SMVM_BINDINGS
typedef char smvm_at_is_too_small[SMVM_IMAGE_MAX < (SMVM_AT)-1 && SMVM_RAM_MAX < (SMVM_AT)-1 && SMVM_RAM_MAX <= (size_t)-1 / 2 ? 1 : -1];
typedef char smvm_joins_are_1_to_255[SMVM_JOINS >= 1 && SMVM_JOINS <= 255 ? 1 : -1];
#endif

#endif
