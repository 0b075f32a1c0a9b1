// SPDX-License-Identifier: Apache-2.0
// A serial line of this computer, a socket or a TCP connection, and a clock for timeouts.  Like os.h, for the command only.
#ifndef SMC_OS_SERIAL_H
#define SMC_OS_SERIAL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

// Opens a line in raw mode: 8 data bits, no parity, 1 stop bit, no flow control.  Bytes that arrived earlier are dropped.  DTR stays on
// after the close, because an Arduino restarts whenever DTR turns on.
bool os_serial_open(const char *path, unsigned long bits_per_second, int *fd, const char **why);
// Connects to the socket at a path of this computer.
bool os_socket_open(const char *path, int *fd, const char **why);
// Connects to "HOST:PORT" by TCP; without HOST to this computer.  Waits at most 5 s for each address of the host.
bool os_tcp_open(const char *address, int *fd, const char **why);

// Opens any of the three: a socket if there is one at `where`, "HOST:PORT" if it has a ':' and no '/' and is no file, else a serial line.
bool os_line_open(const char *where, unsigned long bits_per_second, int *fd, const char **why);

// The following functions accept the descriptor of any of these.
// Returns false if the line accepted no byte for 5 s, or the device is disconnected.
bool os_serial_send(int fd, const uint8_t *bytes, size_t n);
// Waits up to `wait` milliseconds.  Returns the number of bytes received, 0 if none, -1 if the device is disconnected.
int os_serial_receive(int fd, uint8_t *bytes, size_t room, uint32_t wait);
void os_serial_close(int fd);

uint32_t os_milliseconds(void);       // returns the milliseconds since an arbitrary time, modulo 2^32
uint16_t os_run_nonce(void);          // a number that is unlikely to be the same in the next run of the command

#endif
