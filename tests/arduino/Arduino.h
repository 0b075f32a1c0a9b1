// SPDX-License-Identifier: Apache-2.0
// The part of the Arduino core that the examples use, for compilers without one.  A sketch that compiles with it uses no other part.
#ifndef Arduino_h
#define Arduino_h

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { LOW, HIGH, INPUT = 0, OUTPUT, A0 = 14 };

unsigned long millis(void);
int analogRead(uint8_t pin);
void pinMode(uint8_t pin, uint8_t mode);
void digitalWrite(uint8_t pin, uint8_t value);
void setup(void);
void loop(void);

struct HardwareSerial {
    void begin(unsigned long baud);
    void print(const char *text);
    void print(char c);
    void print(long number);
    void print(unsigned long number);
    void print(int number) { print((long)number); }
    void print(unsigned number) { print((unsigned long)number); }
    template <class T> void println(T what) { print(what); print('\n'); }
};
extern HardwareSerial Serial;

#endif
