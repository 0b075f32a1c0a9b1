// SPDX-License-Identifier: Apache-2.0
// An application's main on AVR, where the emulator ends with the input (tests/avr/console.c), and no program else.
#include <stdio.h>

#include "stand_app.h"

int main(void)
{
    (void)sm_app_main(&stand_app);
    (void)getchar();
    return 0;
}
