// SPDX-License-Identifier: Apache-2.0
// The counters as a flight-software engineer writes them: int where it is large enough, int64_t elsewhere, and limits only where a value can
// reach them.
#include <string.h>

#include "tests/bench/workloads/intcount.h"

static inline int limit(int x, int least, int most) { return x < least ? least : x > most ? most : x; }
static inline int8_t to_i8(int x) { return (int8_t)limit(x, INT8_MIN, INT8_MAX); }
static inline uint8_t to_u8(int x) { return (uint8_t)limit(x, 0, UINT8_MAX); }
static inline int16_t to_i16(int x) { return (int16_t)limit(x, INT16_MIN, INT16_MAX); }
static inline uint16_t to_u16(int x) { return (uint16_t)limit(x, 0, UINT16_MAX); }
static inline int32_t to_i32(int64_t x) { return (int32_t)(x < INT32_MIN ? INT32_MIN : x > INT32_MAX ? INT32_MAX : x); }
static inline uint32_t add_u32(uint32_t x, uint32_t y) { return x + y < x ? UINT32_MAX : x + y; }

void intcount_native_init(IntcountNative *m, IntcountSv *sv)
{
    memset(m, 0, sizeof *m);
    m->first = true;
    sv->state = 1;
}

static void clock(IntcountNative *m, IntcountSv *sv)
{
    if (++m->tenths >= 10) {
        m->tenths = 0;
        sv->seconds = to_u8(sv->seconds + 1);
        if (sv->seconds >= 60) {
            sv->seconds = 0;
            sv->minutes = to_u8(sv->minutes + 1);
        }
    }
}

void intcount_native_step(IntcountNative *m, IntcountSv *sv)
{
    const int adc0 = sv->adc0, adc1 = sv->adc1, mode = sv->mode, fault = sv->fault;
    const int64_t moved = (int64_t)sv->encoder - m->before;

    if (m->first) {
        m->first = false;
        sv->state = 1;
    }
    sv->ticks = add_u32(sv->ticks, 1);
    sv->pulses = add_u32(sv->pulses, sv->pulse != 0);
    sv->travel = add_u32(sv->travel, (uint32_t)(moved < 0 ? -moved : moved));
    sv->position = to_i32(sv->position + moved);
    sv->rate = to_i16(to_i32(moved));
    m->before = sv->encoder;
    sv->energy = add_u32(sv->energy, (uint32_t)(adc0 * mode));
    sv->balance = to_i32((int64_t)sv->balance + (adc0 - adc1));
    sv->error = to_i32((int64_t)sv->encoder - 1000 * mode);
    sv->faults = to_u16(sv->faults + fault);
    sv->high = (uint16_t)(adc0 > sv->high - 3 ? adc0 : sv->high - 3);
    sv->quiet = to_u16(adc0 > 100 ? 0 : sv->quiet + 1);
    sv->span = (uint16_t)(adc0 > m->last ? adc0 - m->last : m->last - adc0);
    m->last = (uint16_t)adc0;
    sv->turn = to_i16(sv->turn + sv->gyro);
    sv->drift = to_i16((16 * (sv->drift + sv->trim) - sv->gyro) / 16);
    sv->debounce = to_u8(sv->debounce + (sv->pulse ? 16 : -9));
    sv->leak = to_u8(sv->leak + 40 * fault - 1);
    sv->retries = mode == 3 ? to_u8(sv->retries + 1) : mode == 0 ? 0 : sv->retries;
    clock(m, sv);
    sv->score = to_i8(sv->score + (fault ? -20 : 1));
    sv->tilt = to_i8(sv->trim * 3 + mode);
    sv->bias = to_i8(sv->bias + (adc0 > adc1) - (adc0 < adc1));
    sv->alarm = (sv->leak > 100) | (sv->score < -100) | (sv->faults > 1000);
    sv->steady = (sv->debounce == 255) & (sv->span < 50);
    sv->late = ((int64_t)sv->travel - (int64_t)sv->pulses * 4 > 100000) | (sv->quiet > 500);
}
