// SPDX-License-Identifier: Apache-2.0
// Times, first steps and conversions as the language defines them (language.md 6), for the rows `f64`.
#ifndef BENCH_FRAME_H
#define BENCH_FRAME_H

#include <stdbool.h>
#include <stdint.h>

#include "stdlib/convert.h"
#include "stdlib/math.h"

#define F(x) sm_read_f32(x)
#define D(x) sm_read_f64(x)
#define I(x) ((double)(x))

typedef struct Frame {
    uint32_t state;
    bool first, ran;
    uint64_t start, last, T;
} Frame;

static inline void frame_init(Frame *f)
{
    const Frame none = {1, true, false, 0, 0, 0};

    *f = none;
}

// Returns false if the step is refused.
static inline bool frame_begin(Frame *f, uint64_t time, uint32_t *state)
{
    if (time == UINT64_MAX || (f->ran && time <= f->last))
        return false;
    f->ran = true;
    f->last = time;
    if (f->first) {
        f->start = time;
        *state = f->state;
    }
    f->T = time - f->start;
    return true;
}

static inline void frame_end(Frame *f, uint32_t to)           // `to`: a state, or 0 for no transition
{
    f->first = to != 0;
    if (to != 0)
        f->state = to;
}

#endif
