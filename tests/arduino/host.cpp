// SPDX-License-Identifier: Apache-2.0
// The fake core as a program: runs a sketch at the tank of plant.h and prints what the sketch prints.
#include <stdio.h>
#include <stdlib.h>

#include "Arduino.h"
#include "tests/arduino/plant.h"

static unsigned long now;
static int pressure = PLANT_FIRST, step;
static bool open;

unsigned long millis(void) { return now; }
int analogRead(uint8_t pin) { return pin == A0 ? pressure : 0; }
void pinMode(uint8_t, uint8_t) {}

void digitalWrite(uint8_t pin, uint8_t value)
{
    if (pin == VALVE_PIN)
        open = value != LOW;
}

HardwareSerial Serial;
void HardwareSerial::begin(unsigned long) {}
void HardwareSerial::print(const char *text) { fputs(text, stdout); }
void HardwareSerial::print(long number) { printf("%ld", number); }
void HardwareSerial::print(unsigned long number) { printf("%lu", number); }

void HardwareSerial::print(char c)
{
    putchar(c);
    if (c == '\n')
        pressure = plant_next(pressure, open, step++);
}

int main()
{
    for (setup(); step < PLANT_STEPS && now < 100000; now++)
        loop();
    return 0;
}
