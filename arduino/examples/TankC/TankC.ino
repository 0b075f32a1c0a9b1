// SPDX-License-Identifier: Apache-2.0
// A tank keeps its pressure in a band by a vent valve.  The logic is tank.sm in this folder; the C beside it was made of it, with numbers
// that are the same on every board:
//     smc build tank.sm --emit=c --soft
// Change tank.sm, make the C again, upload.  This sketch needs no library.
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
    sv.tankPressure = sm_from_i32(pressure);
    tank_step(&tank, &sv);
    digitalWrite(VALVE, sv.valveOpen ? HIGH : LOW);

    Serial.print(pressure);
    Serial.print(' ');
    Serial.print(sv.state);
    Serial.print(' ');
    Serial.println(sv.valveOpen);
    due += PERIOD;
}
