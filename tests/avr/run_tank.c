// SPDX-License-Identifier: Apache-2.0
// Compares the emitted tank with the handwritten one on an emulated ATmega328P: the same state vector after every step, and the cycles.
//   run_tank ELF f64|i16 MOST         the type of pressure; fails if the emitted one needs more than MOST hundredths of the other's cycles on average
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/avr/mailbox.h"
#include "tests/avr/sim.h"

enum { STEPS = 2176, RESTART = 97, DELTA = 10, PLACE_I16 = 12, PLACE_F64 = 16 };      // of the pressure in the state vector

typedef struct Cost {
    uint64_t sum, most;
} Cost;

typedef struct Bench {
    Sim sim;
    TankBox *box;
    size_t place;
    Cost cost[2];
    uint8_t ran[2];
} Bench;

static uint64_t next(uint64_t *state)
{
    *state ^= *state >> 12;
    *state ^= *state << 25;
    *state ^= *state >> 27;
    return *state * 0x2545F4914F6CDD1Du;
}

// Returns a pressure near the valve's threshold, 725 to 824, and seldom one beyond.
static double random_pressure(uint64_t *state) { return next(state) % 500 == 0 ? 1000 : 725 + (double)(next(state) % 990) / 10; }

static bool step(Bench *b, uint8_t which, uint64_t time, double p)
{
    uint8_t *sv = sim_ram(&b->sim) + b->box->sv + which * b->box->sv_size;
    const int16_t whole = (int16_t)p;

    memcpy(sv, &time, sizeof time);
    memcpy(sv + b->place, b->place == PLACE_F64 ? (const void *)&p : (const void *)&whole, b->place == PLACE_F64 ? sizeof p : sizeof whole);
    b->box->what = which;
    if (!sim_until_ready(&b->sim))
        return false;
    b->cost[which].sum += b->sim.cycles;
    b->cost[which].most = b->cost[which].most < b->sim.cycles ? b->sim.cycles : b->cost[which].most;
    b->ran[which] = b->box->result;
    return true;
}

static bool same(const Bench *b)
{
    const uint8_t *sv = sim_ram(&b->sim) + b->box->sv;

    return b->ran[0] == b->ran[1] && memcmp(sv, sv + b->box->sv_size, b->box->sv_size) == 0;
}

static bool run(Bench *b)
{
    uint64_t state = 88172645463325252u, time = 0;

    for (int i = 0; i < STEPS; i++) {
        const double p = random_pressure(&state);
        time += next(&state) % 50 != 0 ? DELTA : 0;                // otherwise the time does not advance
        b->box->begins = i % RESTART == 0;
        if (!step(b, TANK_EMITTED, time, p))
            return false;
        b->box->begins = 0;
        if (!step(b, TANK_HAND, time, p) || !same(b))
            return false;
    }
    return true;
}

int main(int argc, char **argv)
{
    Bench b = {0};

    if (argc != 4 || !sim_open(&b.sim, argv[1]) || !sim_until_ready(&b.sim))
        return 1;
    b.box = sim_mailbox(&b.sim);
    b.place = strcmp(argv[2], "i16") == 0 ? PLACE_I16 : PLACE_F64;
    if (!run(&b)) {
        printf("%s: the two differ\n", argv[2]);
        return 1;
    }
    for (int i = 0; i < 2; i++)
        printf("%s, %s: %.0f cycles a step, %lu at most\n", argv[2], i == TANK_HAND ? "by hand" : "emitted", (double)b.cost[i].sum / STEPS,
               (unsigned long)b.cost[i].most);
    return b.cost[TANK_EMITTED].sum * 100 > b.cost[TANK_HAND].sum * strtoul(argv[3], NULL, 10);
}
