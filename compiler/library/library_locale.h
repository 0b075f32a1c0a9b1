// SPDX-License-Identifier: Apache-2.0
// The locale "C" for one thread, while a call of the library runs.
#ifndef SMC_LIBRARY_LOCALE_H
#define SMC_LIBRARY_LOCALE_H

void *library_locale_new(void);               // NULL: out of memory
void library_locale_free(void *c);
// Sets the locale of this thread to c.  Returns its own one, for library_locale_leave.
void *library_locale_enter(void *c);
void library_locale_leave(void *own);

#endif
