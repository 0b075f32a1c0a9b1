// SPDX-License-Identifier: Apache-2.0
// A tank keeps its pressure in a band by a vent valve.  The logic is tank.sm in this folder, here as bytecode for the virtual machine:
//     smc build tank.sm --emit=array          gives tank_image.h, the bytecode
//     smc build tank.sm --emit=c --soft       gives tank.h, of which this sketch takes TankSv, what the machine reads and writes
// On AVR the bytecode stays in flash.
//
// Wiring: a pressure sensor on A0 (or a potentiometer: 5 V are 1023 psi), the valve's driver on pin 8.
// The Serial Plotter at 115200 shows pressure, state and valve.
#include <smc.h>

#include "tank.h"
#include "tank_image.h"

const int SENSOR = A0, VALVE = 8;
const unsigned long PERIOD = 10;      // milliseconds a step

uint64_t memory[16];                  // of the machine; it says so if that is too little
TankSv sv;                            // what the machine reads and writes
unsigned long due;                    // when the next step begins

// Why the machine does not start; 0: it does.
int start()
{
    const SmvmBytes image = SMVM_IMAGE(tank_image);
    const SmvmVector vector = {&sv, sizeof sv, TANK_SV_LAYOUT};
    SmvmVerdict why;
    SmvmMachine machine;

    if (smvm_verify(image, sizeof tank_image, &why) != 0)
        return why.rule;              // bytecode.md lists the rules
    if (!smvm_machine(image, 0, &machine))
        return -1;
    return smvm_init(memory, sizeof memory, &machine, &vector, 1);
}

void setup()
{
    int why;

    pinMode(VALVE, OUTPUT);
    Serial.begin(115200);
    if ((why = start()) != 0) {
        Serial.print("the machine does not start here: ");
        Serial.println(why);
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
    smvm_step((SmVm *)memory, &sv);
    digitalWrite(VALVE, sv.valveOpen ? HIGH : LOW);

    Serial.print(pressure);
    Serial.print(' ');
    Serial.print(sv.state);
    Serial.print(' ');
    Serial.println(sv.valveOpen);
    due += PERIOD;
}
