# --soft: numbers of F64 are SmF64s, and what they are made of comes beside the machine, once a folder.  Integers stay C's own.
args build --emit=c --soft -w a.sm b.sm && ls && grep -n sm_soft a.h && sed -n '/F64/p;/^static.*step/,/^}/p' a.h a.c && head -4 sm_soft.h && head -3 sm_soft.c sm_soft_avr.S

-- a.sm --
[state_vector]
U64 G
U32 S
F64 pressure
F32 flow
I16 count
U64 ticks
bool open
[local]
F64 limit = 0.1
[Idle]
.step
    limit = pressure / 3 - flow * 2
    flow = flow + 0.5
    count = count + 1
    ticks = ticks + 1
    open = pressure > 775 and limit <= flow
    count > 7: -> Idle
-- b.sm --
[state_vector]
U64 G
U32 S
[Idle]
-- stdout --
a.c
a.h
a.sm
b.c
b.h
b.sm
sm_soft.c
sm_soft.h
sm_soft_avr.S
8:#include "sm_soft.h"
    SmF64    pressure;
    SmF64    limit;
#if !SM_F64_SOFT
#error "this code was generated for soft numbers, but stdlib/f64.h uses a double here: build with -DSM_F64_SOFT=1, or smc without --soft"
static inline SmF64 sm_to_f64(SmF64 x)
static inline SmF64 sm_read_f64(SmF64 x)
static uint8_t a_Idle_step(A *m, ASv *sv)
{
    const SmF64 pressure = sm_read_f64(sv->pressure);
    const SmF64 pressure = sm_read_f64(sv->pressure);
    const float value1 = sm_no_nan_f32(sv->flow);
    m->limit = sm_to_f64(sm_sub(sm_div(pressure, sm_from_bits(0x4008000000000000u /* 3.0 */)),
        sm_mul(sm_from_f32(value1), sm_from_bits(0x4000000000000000u /* 2.0 */))));
    sv->flow = sm_round_f32(sm_add(sm_from_f32(value1), sm_from_bits(0x3FE0000000000000u /* 0.5 */)));
    sv->count = (int16_t)sm_clip_i32((int32_t)sv->count + 1, INT16_MIN, INT16_MAX);
    sv->ticks = sm_count_u64(sv->ticks, 1);
    sv->open = sm_soft_beyond(&sv->pressure, 0x40883800u /* 775.0 */)
        && sm_le(m->limit, sm_from_f32(sv->flow));
    if (sv->count > 7) {
        return A_STATE_Idle;
    }
    return 0;
}
// Numbers for emitted C where no `double` is an IEEE binary64: what may be done with them.  Made by smc from its stdlib: change that, not this file.
#ifndef SM_F64_H              // otherwise stdlib/f64.h, which declares all of this, has been included, as by smc's Arduino library
#ifndef SM_F64_SOFT
#define SM_F64_SOFT 1
==> sm_soft.c <==
// Numbers for emitted C where no `double` is an IEEE binary64: portable C.  Made by smc from its stdlib: change that, not this file.
#include "sm_soft.h"


==> sm_soft_avr.S <==
// Numbers for emitted C where no `double` is an IEEE binary64: assembly for AVR, nothing elsewhere.  Made by smc from its stdlib: change that, not this file.
// Unpacks and packs numbers for the operations of soft.h.  Internal to stdlib/soft_*.c.
//
