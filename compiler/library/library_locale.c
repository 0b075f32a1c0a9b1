// SPDX-License-Identifier: Apache-2.0
// The compiler writes and reads numbers with printf and strtod, which use the decimal separator of the program's locale.  So while a call of
// the library runs, its thread has the locale "C".  Needs POSIX.1-2008; elsewhere a program must not set LC_NUMERIC.
#define _POSIX_C_SOURCE 200809L
#include "compiler/library/library_locale.h"

#include <stddef.h>

#if defined(__unix__) || defined(__APPLE__)
#include <locale.h>
#if defined(__APPLE__)
#include <xlocale.h>
#endif

void *library_locale_new(void) { return (void *)newlocale(LC_NUMERIC_MASK, "C", (locale_t)0); }
void library_locale_free(void *c) { freelocale((locale_t)c); }
void *library_locale_enter(void *c) { return (void *)uselocale((locale_t)c); }
void library_locale_leave(void *own) { uselocale((locale_t)own); }
#else
static char only;      // only its address is used, as the locale of every session; nothing is stored in it
void *library_locale_new(void) { return &only; }
void library_locale_free(void *c) { (void)c; }
void *library_locale_enter(void *c) { return c; }
void library_locale_leave(void *own) { (void)own; }
#endif
