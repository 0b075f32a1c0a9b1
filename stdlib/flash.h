// SPDX-License-Identifier: Apache-2.0
// Tables of constants that stay in flash on AVR, which copies all others into RAM.
//     static const Row rows[] SM_FLASH = {…};
//     Row row;
//     sm_flash_get(&row, &rows[i], sizeof row);
#ifndef SM_FLASH_H
#define SM_FLASH_H

#ifdef __AVR__
#include <avr/pgmspace.h>
#define SM_FLASH PROGMEM
#define sm_flash_get(to, from, n) memcpy_P((to), (from), (n))
#else
#include <string.h>
#define SM_FLASH
#define sm_flash_get(to, from, n) memcpy((to), (from), (n))
#endif

#endif
