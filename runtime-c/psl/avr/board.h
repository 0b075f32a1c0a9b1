// SPDX-License-Identifier: Apache-2.0
// The port and bit of each pin, and which pins have PWM.  Numbers are those of Arduino Uno and Mega.
#ifndef PSL_AVR_BOARD_H
#define PSL_AVR_BOARD_H

#ifdef PSL_AVR               // defined by chip.h on the supported boards
#include <avr/io.h>
#include <avr/pgmspace.h>
#include <stdint.h>

// Each port has three registers, PIN, DDR and PORT, in this order.  The ports H to L are at higher addresses.
enum { AVR_PORT_LOW = 0x20, AVR_PORT_HIGH = 0x100, AVR_PORTS_LOW = 7 };
enum { AVR_A, AVR_B, AVR_C, AVR_D, AVR_E, AVR_F, AVR_G, AVR_H, AVR_J, AVR_K, AVR_L };

// AVR_P: a pin in one byte, port << 3 | bit.  AVR_UP, AVR_DOWN: the eight pins of a port in ascending or descending order.
#define AVR_P(port, bit) (uint8_t)(AVR_##port << 3 | (bit))
#define AVR_UP(port) AVR_P(port, 0), AVR_P(port, 1), AVR_P(port, 2), AVR_P(port, 3), AVR_P(port, 4), AVR_P(port, 5), AVR_P(port, 6), AVR_P(port, 7)
#define AVR_DOWN(port) AVR_P(port, 7), AVR_P(port, 6), AVR_P(port, 5), AVR_P(port, 4), AVR_P(port, 3), AVR_P(port, 2), AVR_P(port, 1), AVR_P(port, 0)

// A pin with PWM: its timer's register TCCRnA (TCCRnB follows it), its compare register, and the bit that connects the two.
typedef struct AvrPwm { uint8_t pin; uint16_t control, compare; uint8_t connect; } AvrPwm;
enum { AVR_COM_A = 0x80, AVR_COM_B = 0x20, AVR_COM_C = 0x08 };
#define AVR_PWM(pin, timer, unit) {pin, _SFR_ADDR(TCCR##timer##A), _SFR_ADDR(OCR##timer##unit), AVR_COM_##unit}

#if defined(__AVR_ATmega328P__)
enum { AVR_ANALOG_FIRST = 14, AVR_ANALOGS = 6, AVR_PWMS = 4 };
static const uint8_t avr_pins[AVR_PINS] PROGMEM = {
    AVR_UP(D), AVR_P(B, 0), AVR_P(B, 1), AVR_P(B, 2), AVR_P(B, 3), AVR_P(B, 4), AVR_P(B, 5),
    AVR_P(C, 0), AVR_P(C, 1), AVR_P(C, 2), AVR_P(C, 3), AVR_P(C, 4), AVR_P(C, 5)};
static const AvrPwm avr_pwms[AVR_PWMS] PROGMEM = {AVR_PWM(3, 2, B), AVR_PWM(9, 1, A), AVR_PWM(10, 1, B), AVR_PWM(11, 2, A)};
#elif defined(__AVR_ATmega2560__)
enum { AVR_ANALOG_FIRST = 54, AVR_ANALOGS = 16, AVR_PWMS = 13 };
static const uint8_t avr_pins[AVR_PINS] PROGMEM = {
    AVR_P(E, 0), AVR_P(E, 1), AVR_P(E, 4), AVR_P(E, 5), AVR_P(G, 5), AVR_P(E, 3), AVR_P(H, 3), AVR_P(H, 4), AVR_P(H, 5), AVR_P(H, 6),
    AVR_P(B, 4), AVR_P(B, 5), AVR_P(B, 6), AVR_P(B, 7), AVR_P(J, 1), AVR_P(J, 0), AVR_P(H, 1), AVR_P(H, 0), AVR_P(D, 3), AVR_P(D, 2),
    AVR_P(D, 1), AVR_P(D, 0), AVR_UP(A), AVR_DOWN(C), AVR_P(D, 7), AVR_P(G, 2), AVR_P(G, 1), AVR_P(G, 0), AVR_DOWN(L),
    AVR_P(B, 3), AVR_P(B, 2), AVR_P(B, 1), AVR_P(B, 0), AVR_UP(F), AVR_UP(K)};
static const AvrPwm avr_pwms[AVR_PWMS] PROGMEM = {
    AVR_PWM(2, 3, B), AVR_PWM(3, 3, C), AVR_PWM(5, 3, A), AVR_PWM(6, 4, A), AVR_PWM(7, 4, B), AVR_PWM(8, 4, C), AVR_PWM(9, 2, B),
    AVR_PWM(10, 2, A), AVR_PWM(11, 1, A), AVR_PWM(12, 1, B), AVR_PWM(44, 5, C), AVR_PWM(45, 5, B), AVR_PWM(46, 5, A)};
#endif

#endif
#endif
