// SPDX-License-Identifier: Apache-2.0
// A serial line of this computer, and a clock to wait by.  As os.h, for the command alone.
#ifndef SMC_OS_SERIAL_H
#define SMC_OS_SERIAL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

// Opens a line for bytes as they are: 8 data bits, no parity, 1 stop bit, no flow control.  What had arrived before is dropped.
bool os_serial_open(const char *path, unsigned long bits_per_second, int *fd, const char **why);
bool os_serial_send(int fd, const uint8_t *bytes, size_t n);                           // false: the line is gone
// Waits up to `wait` milliseconds; gives how many bytes came, 0 if none did, -1 when the line is gone.
int os_serial_receive(int fd, uint8_t *bytes, size_t room, uint32_t wait);
void os_serial_close(int fd);

uint32_t os_milliseconds(void);       // since some time, modulo 2^32
uint16_t os_unlike(void);             // a number that the next call of the command will hardly have again

#endif
