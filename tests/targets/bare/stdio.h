// SPDX-License-Identifier: Apache-2.0
// The part of <stdio.h> that emitted C's driver and vm.c use.  semihost.c implements it.
#ifndef SM_BARE_STDIO_H
#define SM_BARE_STDIO_H

typedef int FILE;
#define EOF (-1)
#define stdout ((FILE *)0)
int getchar(void);
int putchar(int c);
int fflush(FILE *stream);             // getchar also does this before it waits

#endif
