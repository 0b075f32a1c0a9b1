// SPDX-License-Identifier: Apache-2.0
// A tank keeps its pressure in a band by a vent valve.  The logic is tank.sm in this folder; the C beside it was generated from it, with
// numbers that are the same on every board.  It has two forms, of which the compiler chooses: for boards whose double has 64 bits and is
// computed correctly (ESP32, Teensy 4), and for all others (Uno, Mega, Due).  Change tank.sm, generate the form for your board, upload:
//     smc build tank.sm --emit=c              for the former
//     smc build tank.sm --emit=c --soft       for the latter
// This sketch needs no library.
//
// Wiring: a pressure sensor on A0 (or a potentiometer: 5 V are 1023 psi), the valve's driver on pin 8.
// The Serial Plotter at 115200 shows pressure, state and valve.
#include "tank.h"

const int SENSOR = A0, VALVE = 8;
const unsigned long PERIOD = 10;      // milliseconds a step

Tank tank;
TankSv sv;                            // what the machine reads and writes
unsigned long due;                    // when the next step begins

void setup()
{
    pinMode(VALVE, OUTPUT);
    Serial.begin(115200);
    if (tank_init(&tank, &sv, TANK_INITIAL_STATE) != TANK_OK) {
        Serial.println("the machine does not start here");
        while (true)
            ;
    }
    due = millis();
}

void loop()
{
    int pressure;

    if ((long)(millis() - due) < 0)
        return;
    pressure = analogRead(SENSOR);
    sv.time += PERIOD;
#if SM_F64_SOFT
    sv.tankPressure = sm_from_i32(pressure);
#else
    sv.tankPressure = pressure;
#endif
    tank_step(&tank, &sv);
    digitalWrite(VALVE, sv.valveOpen ? HIGH : LOW);

    Serial.print(pressure);
    Serial.print(' ');
    Serial.print(sv.state);
    Serial.print(' ');
    Serial.println(sv.valveOpen);
    due += PERIOD;
}
