// SPDX-License-Identifier: Apache-2.0
// The main function of an application on AVR.  The emulator ends when the input ends (tests/avr/console.c).
#include <stdio.h>

#include "stand_app.h"

int main(void)
{
    (void)sm_app_main(&stand_app);
    (void)getchar();
    return 0;
}
