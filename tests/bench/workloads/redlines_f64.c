// SPDX-License-Identifier: Apache-2.0
// The red lines by the definitions of the language: every value a double, every store a conversion, windows of doubles.
#include "tests/bench/workloads/redlines.h"

enum { RUN = 1, TRIPPED };

static const double least[SENSORS] = {-20, -21, -22, -23, -24, -25, -26, -27, -28, -29, -30, -31, -32, -33, -34, -35, -36, -37, -38, -39, -40, -41, -42, -43};
static const double most[SENSORS] = {60, 63, 66, 69, 72, 75, 61, 64, 67, 70, 73, 76, 62, 65, 68, 71, 74, 60, 63, 66, 69, 72, 75, 61};

void redlines_f64_init(RedlinesF64 *m, RedlinesSv *sv)
{
    memset(m, 0, sizeof *m);
    frame_init(&m->frame);
    for (int i = 0; i < SENSORS; i++)
        window_init(&m->median[i], m->three[i], 3);
    for (int i = 0; i < AVERAGED; i++)
        window_init(&m->average[i], m->four[i], 4);
    sv->state = RUN;
}

static void put(RedlinesF64 *m, const RedlinesSv *sv)
{
    float sensor[SENSORS];

    memcpy(sensor, &sv->s0, sizeof sensor);
    for (int i = 0; i < SENSORS; i++)
        window_put(&m->median[i], F(sensor[i]));
    for (int i = 0; i < AVERAGED; i++)
        window_put(&m->average[i], F(sensor[i]));
}

static uint32_t run(RedlinesF64 *m, RedlinesSv *sv)
{
    const Window *w = m->average;

    if (m->frame.first)
        sv->closed = false;
    sv->hottest = sm_to_f32(sm_max(sm_max(window_avg(&w[0]), window_avg(&w[1])), sm_max(window_avg(&w[2]), window_avg(&w[3]))));
    for (int i = 0; i < SENSORS; i++) {
        const double x = window_median(&m->median[i]);
        if (!(least[i] < x && x < most[i])) {
            sv->code = sm_to_u8(I(i + 1));
            return TRIPPED;
        }
    }
    return 0;
}

static uint32_t tripped(const RedlinesF64 *m, RedlinesSv *sv)
{
    if (m->frame.first) {
        sv->closed = true;
        sv->trips = sm_to_u16(I(sv->trips) + 1.0);
    }
    return sv->reset && I(m->frame.T) > 30.0 ? RUN : 0;
}

void redlines_f64_step(RedlinesF64 *m, RedlinesSv *sv)
{
    if (!frame_begin(&m->frame, sv->time, &sv->state))
        return;
    put(m, sv);
    frame_end(&m->frame, m->frame.state == RUN ? run(m, sv) : tripped(m, sv));
}
