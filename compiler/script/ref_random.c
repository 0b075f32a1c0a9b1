// SPDX-License-Identifier: Apache-2.0
// Random numbers of scripts (language.md 8.48 to 8.53): PCG32, one stream a call, twelve draws a step.
#include "compiler/script/ref.h"

static const uint64_t multiplier = UINT64_C(6364136223846793005);

// Returns the increment of a call's generator.  Generators with different increments produce different streams.
static uint64_t increment_of(uint32_t call) { return 2 * ((uint64_t)call + 1) + 1; }

// Returns the next number of a PCG generator (XSH-RR, 32 bits).
static uint32_t next_random(uint64_t *state, uint64_t increment)
{
    const uint64_t old = *state;
    const uint32_t mixed = (uint32_t)((old >> 18 ^ old) >> 27), turn = (uint32_t)(old >> 59);

    *state = old * multiplier + increment;
    return mixed >> turn | mixed << (-turn & 31);
}

// Returns the state of a call's generator before the draws of a step; steps count from 1.  n draws change a state x to a * x + b; a and b for 2 n
// draws follow from a and b for n, so the loop has one iteration for each bit of the number of draws.
static uint64_t state_before(uint64_t seed, uint32_t call, uint64_t step)
{
    const uint64_t increment = increment_of(call);
    uint64_t state = (increment + seed) * multiplier + increment;
    uint64_t a = multiplier, b = increment;

    for (uint64_t n = REF_DRAWS * (step - 1); n > 0; n >>= 1) {
        if (n & 1)
            state = state * a + b;
        b = (a + 1) * b;
        a *= a;
    }
    return state;
}

// Returns the value of a call from the draws of one step.  Each operation is a statement of its own, so that each one rounds.
static double value_of(const ScriptRandom *call, const uint32_t u[REF_DRAWS])
{
    uint64_t sum = 0;
    double x, range;

    if (!call->is_noise) {
        x = u[0] / 4294967296.0;
        range = call->b - call->a;
        x = range * x;
        return call->a + x;
    }
    for (int i = 0; i < REF_DRAWS; i++)
        sum += u[i];
    x = (double)sum / 4294967296.0;
    x = x - 6;
    return call->a * x;
}

void ref_random_init(RefRandom *r, Arena *arena, const ScriptRandoms *calls, uint64_t seed)
{
    r->call = calls->at;
    r->stream = ARENA_ARRAY(arena, RefStream, calls->n);
    r->seed = seed;
    r->step = 0;
    r->first = 0;
}

double ref_random_value(RefRandom *r, uint32_t call)
{
    RefStream *s = &r->stream[call];
    uint32_t u[REF_DRAWS];

    if (s->step == r->step)
        return s->value;
    if (s->step == 0 || s->step + 1 != r->step)
        s->state = state_before(r->seed, r->first + call, r->step);
    for (int i = 0; i < REF_DRAWS; i++)
        u[i] = next_random(&s->state, increment_of(r->first + call));
    s->step = r->step;
    return s->value = value_of(&r->call[call], u);
}
