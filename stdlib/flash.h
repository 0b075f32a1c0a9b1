// SPDX-License-Identifier: Apache-2.0
// Marks tables and messages that remain in flash on AVR, which copies all other constants into RAM.
//     static const Row rows[] SM_FLASH = {…};
//     Row row;
//     sm_flash_read(&row, &rows[i], sizeof row);
//
//     const char *what = SM_TEXT("the clock");          // inside a function; on AVR this is not a pointer to RAM
//     for (; (c = sm_text_byte(what)) != '\0'; what++) …
#ifndef SM_FLASH_H
#define SM_FLASH_H

#include <string.h>

// snippet of emitted C: SM_FLASH
#ifdef __AVR__
#include <avr/pgmspace.h>
#define SM_FLASH PROGMEM                                          // in flash: AVR copies other constants into RAM
#define sm_flash_read(to, from, n) memcpy_P((to), (from), (n))
#else
#define SM_FLASH
#define sm_flash_read(to, from, n) memcpy((to), (from), (n))
#endif
// snippet of emitted C: end

#ifdef __AVR__
#define SM_TEXT(text) (__extension__({static const char text_[] PROGMEM = text; (const char *)text_;}))
#define sm_text_byte(at) ((char)pgm_read_byte(at))
#else
#define SM_TEXT(text) (text)
#define sm_text_byte(at) (*(at))
#endif

#endif
