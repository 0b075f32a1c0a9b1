// SPDX-License-Identifier: Apache-2.0
// Steps each firmware of row.c on an emulated ATmega328P with the same inputs.  After every step all state vectors must be equal.
//     run dual|median ELF…     for each ELF: cycles of a step, average and most
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "tests/avr/mailbox.h"
#include "tests/avr/sim.h"

enum { STEPS = 4000, DELTA = 20, ROWS = 8, MOST_SV = 64, INPUT_AT = 12 };

static uint64_t state;
static uint8_t expected[STEPS][MOST_SV];

static double noise(double width)
{
    state ^= state >> 12;
    state ^= state << 25;
    state ^= state >> 27;
    return ((double)(state * 0x2545F4914F6CDD1Du >> 11) / 9007199254740992.0 * 2 - 1) * width;
}

typedef struct Flight { double height, speed; } Flight;      // m, m/s

// Ten seconds on the pad, three of thrust, a fall under a drogue and from 150 m under the main parachute.
static void fly(Flight *f, unsigned t, float *in)
{
    const double felt = t < 10000 ? 9.8 : t < 13000 ? 45 : f->speed > 0 ? -3 : 9.8;
    const double fall = f->height < 150 ? -6 : -20;

    if (t >= 10000)
        f->speed += (felt - 9.8) * DELTA / 1000.0 - (t >= 13000 && f->speed <= 0 ? 9.8 * DELTA / 1000.0 : 0);
    if (f->speed < fall)
        f->speed = fall;
    f->height += f->speed * DELTA / 1000.0;
    if (f->height < 0)
        f->height = 0;
    in[0] = (float)(400 + f->height + noise(0.5));
    in[1] = (float)(felt + noise(1));
}

static void put_inputs(uint8_t *sv, int dual, Flight *f, unsigned i)
{
    const uint64_t time = (uint64_t)(i + 1) * DELTA;
    const int16_t raw = (int16_t)(512 + noise(200));
    float in[2];

    memcpy(sv, &time, sizeof time);
    if (!dual) {
        memcpy(sv + INPUT_AT, &raw, sizeof raw);
        return;
    }
    fly(f, (unsigned)time, in);
    memcpy(sv + INPUT_AT, in, sizeof in);
}

// Runs the firmware of a row.  Checks that it computes the same as the first.
static int run(const char *elf, int dual, int first)
{
    Flight f = {0, 0};
    uint64_t sum = 0, most = 0;
    TankBox *box;
    uint8_t *sv;
    Sim sim;

    state = 88172645463325252u;
    if (!sim_open(&sim, elf) || !sim_until_ready(&sim))
        return 0;
    box = sim_mailbox(&sim);
    sv = sim_ram(&sim) + box->sv;
    for (unsigned i = 0; i < STEPS; i++) {
        put_inputs(sv, dual, &f, i);
        if (!sim_until_ready(&sim))
            return 0;
        if (first)
            memcpy(expected[i], sv, box->sv_size);
        if (memcmp(expected[i], sv, box->sv_size) != 0) {
            fprintf(stderr, "%s differs at step %u\n", elf, i + 1);
            return 0;
        }
        sum += sim.cycles;
        most = sim.cycles > most ? sim.cycles : most;
    }
    printf("%s %.0f %lu state %u\n", elf, (double)sum / STEPS, (unsigned long)most, sv[8]);
    return 1;
}

int main(int argc, char **argv)
{
    if (argc < 3)
        return 2;
    for (int i = 2; i < argc; i++)
        if (!run(argv[i], strcmp(argv[1], "dual") == 0, i == 2))
            return 1;
    return 0;
}
