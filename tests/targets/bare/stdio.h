// SPDX-License-Identifier: Apache-2.0
// As much of <stdio.h> as emitted C's driver and vm.c use; semihost.c is behind it.
#ifndef SM_BARE_STDIO_H
#define SM_BARE_STDIO_H

typedef int FILE;
#define EOF (-1)
#define stdout ((FILE *)0)
int getchar(void);
int putchar(int c);
int fflush(FILE *stream);             // getchar does so before it waits

#endif
