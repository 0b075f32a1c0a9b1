// SPDX-License-Identifier: Apache-2.0
// "Serial": the line of the USB connector.  An interrupt stores received bytes in a ring.  Sending waits until all bytes are
// accepted.
#include "runtime-c/pal/serial.h"

#include <string.h>

#include "runtime-c/pal/clock.h"
#include "runtime-c/psl/avr/avr.h"

#ifdef PSL_AVR
#include <util/atomic.h>

#ifndef AVR_SERIAL_RING
#define AVR_SERIAL_RING 128            // bytes, a power of two, at most 256
#endif

static volatile uint8_t ring[AVR_SERIAL_RING], head, tail;     // head: where the next received byte is stored; tail: the next one to read
static bool open;

#ifdef USART0_RX_vect
#define RECEIVE_VECTOR USART0_RX_vect   // a Mega has four serial lines
#else
#define RECEIVE_VECTOR USART_RX_vect
#endif

ISR(RECEIVE_VECTOR)
{
    const uint8_t byte = UDR0, next = (uint8_t)((head + 1u) % AVR_SERIAL_RING);

    if (next != tail) {
        ring[head] = byte;
        head = next;
    }
}

SmResult pal_serial_open(PalSerial *line, const char *name, uint32_t bits_per_second)
{
    if (!line || !name || bits_per_second < 1200 || bits_per_second > F_CPU / 8)
        return SM_E_ARGUMENT;
    if (strcmp(name, "Serial") != 0)
        return SM_E_MISSING;
    if (open)
        return SM_E_BUSY;
    UBRR0 = (uint16_t)((F_CPU / 4 / bits_per_second - 1) / 2);
    UCSR0A = 1 << U2X0;
    UCSR0C = 1 << UCSZ01 | 1 << UCSZ00;
    UCSR0B = 1 << RXCIE0 | 1 << RXEN0 | 1 << TXEN0;
    head = tail = 0;
    open = true;
    line->id = 1;
    return SM_OK;
}

// Waits without a timeout: a byte at 1200 bits per second takes 8 ms, and the chip never stops sending.
SmResult pal_serial_send(PalSerial line, const void *bytes, size_t n, size_t *sent, uint64_t timeout)
{
    const uint8_t *from = bytes;

    if (!sent)
        return SM_E_ARGUMENT;
    *sent = 0;
    if ((!bytes && n > 0) || timeout > PAL_TIMEOUT_MAX)
        return SM_E_ARGUMENT;
    if (line.id != 1 || !open)
        return SM_E_HANDLE;
    for (; *sent < n; ++*sent) {
        UCSR0A = 1 << TXC0 | 1 << U2X0;
        UDR0 = *from++;
        // Waits after each byte, not before it: if the line was switched off before, as by Arduino's core at its start, simavr sets
        // UDRE0 only after the first byte.
        while ((UCSR0A & 1 << UDRE0) == 0)
            ;
    }
    return SM_OK;
}

// Removes the oldest received byte from the ring.  Returns false if the ring is empty.
static bool pop_byte(uint8_t *byte)
{
    if (head == tail)
        return false;
    *byte = ring[tail];
    tail = (uint8_t)((tail + 1u) % AVR_SERIAL_RING);
    return true;
}

SmResult pal_serial_receive(PalSerial line, void *bytes, size_t room, size_t *n, uint64_t timeout)
{
    uint8_t *to = bytes;
    uint64_t start = 0;

    if (!bytes || room == 0 || !n || timeout > PAL_TIMEOUT_MAX)
        return SM_E_ARGUMENT;
    if (line.id != 1 || !open)
        return SM_E_HANDLE;
    if (timeout != 0)
        for (start = pal_clock_now(); head == tail && pal_clock_now() - start < timeout;)
            ;
    for (*n = 0; *n < room && pop_byte(to); ++*n)
        to++;
    return *n > 0 ? SM_OK : SM_E_TIMEOUT;
}

SmResult pal_serial_close(PalSerial line)
{
    if (line.id != 1 || !open)
        return SM_E_HANDLE;
    UCSR0B = 0;
    open = false;
    return SM_OK;
}

#endif
