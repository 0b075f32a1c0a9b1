// SPDX-License-Identifier: Apache-2.0
// 200 states as a flight-software engineer writes them: one switch, whose cases come from a table.
#include "tests/bench/workloads/big200.h"

void big200_native_init(Big200Native *m, Big200Sv *sv)
{
    m->state = 1;
    m->first = true;
    sv->state = 1;
}

#define KIND_0(number, a) (sv->total = sv->total * 0.5 + sv->rate * a, sv->total > 0)
#define KIND_1(number, a) (sv->sum = sv->sum + a > 100000 ? 0 : sv->sum + a, sv->level > a)
#define KIND_2(number, a) (sv->marks = number - 1, sv->open = !sv->open, sv->level < a)
#define KIND_3(number, a) (sv->open = (sv->level > a) & (sv->ready != 0))
#define KIND_4(number, a) (sv->run = (uint8_t)(!sv->ready ? 0 : sv->run < UINT8_MAX ? sv->run + 1 : UINT8_MAX), sv->ready)

// Every step makes a transition.
void big200_native_step(Big200Native *m, Big200Sv *sv)
{
    sv->state = m->state;
    switch (m->state) {
#define STATE(number, kind, a, one, other) case number: m->state = KIND_##kind(number, a) ? one : other; break;
#include "tests/bench/workloads/big200.def"
    default: break;
    }
}
