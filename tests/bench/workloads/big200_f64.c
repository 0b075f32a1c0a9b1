// SPDX-License-Identifier: Apache-2.0
// 200 states by the definitions of the language: every value a double, every store a conversion.
#include "tests/bench/workloads/big200.h"

void big200_f64_init(Big200F64 *m, Big200Sv *sv)
{
    frame_init(&m->frame);
    sv->state = 1;
}

#define KIND_0(number, a, one, other) sv->total = sm_to_f64(D(sv->total) * 0.5 + D(sv->rate) * I(a)); return D(sv->total) > 0.0 ? one : other;
#define KIND_1(number, a, one, other)                                                                          \
    sv->sum = sm_to_i32(I(sv->sum) + I(a));                                                                    \
    if (I(sv->sum) > 100000.0)                                                                                 \
        sv->sum = 0;                                                                                           \
    return I(sv->level) > I(a) ? one : other;
#define KIND_2(number, a, one, other) return I(sv->level) < I(a) ? one : other;
#define KIND_3(number, a, one, other) sv->open = I(sv->level) > I(a) && sv->ready; return sv->open ? one : other;
#define KIND_4(number, a, one, other)                                                                          \
    if (sv->ready) {                                                                                           \
        sv->run = sm_to_u8(I(sv->run) + 1.0);                                                                  \
        return one;                                                                                            \
    }                                                                                                          \
    sv->run = 0;                                                                                               \
    return other;

#define ENTRY_0(number)
#define ENTRY_1(number)
#define ENTRY_2(number) sv->marks = number - 1;
#define ENTRY_3(number)
#define ENTRY_4(number)

#define EXIT_0
#define EXIT_1
#define EXIT_2 sv->open = !sv->open;
#define EXIT_3
#define EXIT_4

static void entry(const Big200F64 *m, Big200Sv *sv)
{
    switch (m->frame.state) {
#define STATE(number, kind, a, one, other) case number: ENTRY_##kind(number) break;
#include "tests/bench/workloads/big200.def"
#undef STATE
    default: break;
    }
}

static uint32_t step(const Big200F64 *m, Big200Sv *sv)
{
    switch (m->frame.state) {
#define STATE(number, kind, a, one, other) case number: KIND_##kind(number, a, one, other)
#include "tests/bench/workloads/big200.def"
#undef STATE
    default: return 0;
    }
}

static void leave(const Big200F64 *m, Big200Sv *sv)
{
    switch (m->frame.state) {
#define STATE(number, kind, a, one, other) case number: EXIT_##kind break;
#include "tests/bench/workloads/big200.def"
#undef STATE
    default: break;
    }
}

void big200_f64_step(Big200F64 *m, Big200Sv *sv)
{
    uint32_t to;

    if (!frame_begin(&m->frame, sv->time, &sv->state))
        return;
    if (m->frame.first)
        entry(m, sv);
    to = step(m, sv);
    if (to != 0)
        leave(m, sv);
    frame_end(&m->frame, to);
}
