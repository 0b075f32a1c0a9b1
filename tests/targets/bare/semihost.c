// SPDX-License-Identifier: Apache-2.0
// Standard input and output for a chip without them: the emulator provides them by semihosting, through the two headers beside this file.  Also
// the start of the program.
#include <stddef.h>
#include <stdint.h>

#include "tests/targets/bare/stdio.h"
#include "tests/targets/bare/stdlib.h"

enum { SYS_OPEN = 1, SYS_WRITE = 5, SYS_READ = 6, SYS_EXIT_EXTENDED = 0x20, MODE_R = 0, MODE_W = 4, EXITED = 0x20026, BLOCK = 512 };

static intptr_t in, out;
static unsigned char from[BLOCK], to[BLOCK];
static size_t at, n, filled;

static intptr_t call(intptr_t what, const void *arguments)
{
#if defined(__riscv)
    register intptr_t a0 __asm__("a0") = what;
    register const void *a1 __asm__("a1") = arguments;
    __asm__ volatile(".balign 16\n.option push\n.option norvc\nslli zero, zero, 0x1f\nebreak\nsrai zero, zero, 7\n.option pop"
                     : "+r"(a0) : "r"(a1) : "memory");
    return a0;
#else
    register intptr_t r0 __asm__("r0") = what;
    register const void *r1 __asm__("r1") = arguments;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
#endif
}

static intptr_t open(intptr_t mode)
{
    const intptr_t arguments[] = { (intptr_t)":tt", mode, 3 };

    return call(SYS_OPEN, arguments);
}

int fflush(FILE *stream)
{
    const intptr_t arguments[] = { out, (intptr_t)to, (intptr_t)filled };

    (void)stream;
    if (filled > 0 && call(SYS_WRITE, arguments) != 0)
        exit(4);
    filled = 0;
    return 0;
}

int putchar(int c)
{
    if (filled == BLOCK)
        fflush(stdout);
    to[filled++] = (unsigned char)c;
    return c;
}

// All output is flushed before the program waits for an answer.
int getchar(void)
{
    if (at == n) {
        const intptr_t arguments[] = { in, (intptr_t)from, BLOCK };

        fflush(stdout);
        n = BLOCK - (size_t)call(SYS_READ, arguments);
        at = 0;
        if (n == 0)
            return EOF;
    }
    return from[at++];
}

void exit(int status)
{
    const intptr_t arguments[] = { EXITED, status };

    for (;;)
        call(SYS_EXIT_EXTENDED, arguments);
}

int main(void);
void begin(void);
void trapped(void);

void begin(void)
{
    in = open(MODE_R);
    out = open(MODE_W);
    const int status = main();

    fflush(stdout);
    exit(status);
}

void trapped(void) { exit(5); }
