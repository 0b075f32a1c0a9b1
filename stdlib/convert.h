// SPDX-License-Identifier: Apache-2.0
// Conversion between F64 and the types of elements (language.md 2), as values, as bit cells and in memory.
//
//   sm_to_X(x)     F64 to X, as a store does: NaN becomes 0; integers truncate toward zero, then saturate.
//   sm_from_X(v)   X to F64: exact, except that I64 and U64 round to nearest even above 2^53 (these two are in f64.h).
//   sm_read_X(v)   the value that reading a stored X returns: as sm_from_X, but a stored NaN reads as 0.
//   sm_no_nan_f32(v)  the value of a stored F32 as an F32: NaN reads as 0.
//
// A cell is the bits of a value in its own type, zero-extended to 64: I8 -1 is 0xff, F32 its binary32, bool 0 or 1.
// Memory is in the host's byte order and need not be aligned.  A bool is one byte; any nonzero byte reads as true.
//
// Lines `// snippet of emitted C: NAME` divide this file into the snippets that emitted C can contain; f64.h explains them.
#ifndef SM_CONVERT_H
#define SM_CONVERT_H

#include "stdlib/f64.h"
#include "stdlib/types.h"

#if !SM_F64_SOFT
// snippet of emitted C: sm_to_i32 (only where SmF64 is a double)
static inline int32_t sm_to_i32(SmF64 x)
{
    if (sm_le(sm_from_i32(INT32_MIN), x) && sm_le(x, sm_from_i32(INT32_MAX)))
        return sm_truncate_i32(x);
    return sm_is_nan(x) ? 0 : sm_lt(x, sm_from_i32(0)) ? INT32_MIN : INT32_MAX;
}
// snippet of emitted C: sm_to_u32 (only where SmF64 is a double)
static inline uint32_t sm_to_u32(SmF64 x)
{
    if (sm_le(sm_from_i32(0), x) && sm_le(x, sm_from_u32(UINT32_MAX)))
        return sm_truncate_u32(x);
    return sm_lt(sm_from_i32(0), x) ? UINT32_MAX : 0u;
}
// snippet of emitted C: sm_to_i64 (only where SmF64 is a double)
static inline int64_t sm_to_i64(SmF64 x)
{
    if (sm_le(sm_from_bits(0xC3E0000000000000u), x) && sm_lt(x, sm_from_bits(0x43E0000000000000u)))   // -2^63, 2^63
        return sm_truncate_i64(x);
    return sm_is_nan(x) ? 0 : sm_lt(x, sm_from_i32(0)) ? INT64_MIN : INT64_MAX;
}
// snippet of emitted C: sm_to_u64 (only where SmF64 is a double)
static inline uint64_t sm_to_u64(SmF64 x)
{
    if (sm_le(sm_from_i32(0), x) && sm_lt(x, sm_from_bits(0x43F0000000000000u)))   // 2^64
        return sm_truncate_u64(x);
    return sm_lt(sm_from_i32(0), x) ? UINT64_MAX : 0u;
}
// snippet of emitted C: sm_to_i16 (only where SmF64 is a double)
static inline int16_t sm_to_i16(SmF64 x)
{
    if (sm_le(sm_from_i32(INT16_MIN), x))
        return sm_lt(x, sm_from_i32(INT16_MAX)) ? (int16_t)sm_truncate_i32(x) : (int16_t)INT16_MAX;
    return sm_is_nan(x) ? (int16_t)0 : (int16_t)INT16_MIN;
}
// snippet of emitted C: sm_to_i8 (only where SmF64 is a double)
static inline int8_t sm_to_i8(SmF64 x)
{
    if (sm_le(sm_from_i32(INT8_MIN), x))
        return sm_lt(x, sm_from_i32(INT8_MAX)) ? (int8_t)sm_truncate_i32(x) : (int8_t)INT8_MAX;
    return sm_is_nan(x) ? (int8_t)0 : (int8_t)INT8_MIN;
}
// snippet of emitted C: sm_to_u16 (only where SmF64 is a double)
static inline uint16_t sm_to_u16(SmF64 x)
{
    if (sm_lt(sm_from_i32(0), x))
        return sm_lt(x, sm_from_i32(UINT16_MAX)) ? (uint16_t)sm_truncate_i32(x) : (uint16_t)UINT16_MAX;
    return 0;
}
// snippet of emitted C: sm_to_u8 (only where SmF64 is a double)
static inline uint8_t sm_to_u8(SmF64 x)
{
    if (sm_lt(sm_from_i32(0), x))
        return sm_lt(x, sm_from_i32(UINT8_MAX)) ? (uint8_t)sm_truncate_i32(x) : (uint8_t)UINT8_MAX;
    return 0;
}
// snippet of emitted C: end
#endif
// snippet of emitted C: sm_to_f32
static inline float sm_to_f32(SmF64 x)
{
    return SM_UNLIKELY(sm_is_nan(x)) ? 0.0f : sm_round_f32(x);
}
// snippet of emitted C: sm_to_f64
static inline SmF64 sm_to_f64(SmF64 x)
{
    return SM_UNLIKELY(sm_is_nan(x)) ? sm_from_i32(0) : x;
}
// snippet of emitted C: end
#if !SM_F64_SOFT
// snippet of emitted C: sm_to_bool (only where SmF64 is a double)
static inline bool sm_to_bool(SmF64 x)
{
    return sm_lt(x, sm_from_i32(0)) || sm_lt(sm_from_i32(0), x);   // both are false for NaN
}
// snippet of emitted C: end
#endif
// snippet of emitted C: sm_clip_i32
// x, clipped to the limits of another integer type.
static inline int32_t sm_clip_i32(int32_t x, int32_t lo, int32_t hi) { return x < lo ? lo : x > hi ? hi : x; }
// snippet of emitted C: sm_clip_i64
// x, clipped to the limits of another integer type.
static inline int64_t sm_clip_i64(int64_t x, int64_t lo, int64_t hi) { return x < lo ? lo : x > hi ? hi : x; }
// snippet of emitted C: sm_clip_u64
// x, clipped to the upper limit of another integer type.
static inline uint64_t sm_clip_u64(uint64_t x, uint64_t hi) { return x > hi ? hi : x; }
// snippet of emitted C: sm_count_up
// Returns v + 1 as floating-point arithmetic computes it.  v is at most 2^53, from where adding one changes nothing.
static inline uint64_t sm_count_up(uint64_t v) { return v + (v < 0x20000000000000u); }
// snippet of emitted C: sm_count_up_if
// Returns v + 1 as floating-point arithmetic computes it if c is true, else v.  v is at most 2^53, from where adding one changes nothing.
static inline uint64_t sm_count_up_if(uint64_t v, bool c) { return v + (c && v < 0x20000000000000u); }
// snippet of emitted C: sm_count_u64
// Returns v + n as floating-point arithmetic computes and stores it: exact for small v, rounded beyond 2^53.  n is from -2^52 to 2^52.
static inline uint64_t sm_count_u64(uint64_t v, int64_t n)
{
    if (v <= 0x10000000000000u && (n >= 0 || v >= (uint64_t)-n))
        return v + (uint64_t)n;
    return sm_to_u64(sm_add(sm_from_u64(v), sm_from_i64(n)));
}
// snippet of emitted C: sm_count_i64
// Returns v + n as floating-point arithmetic computes and stores it: exact for small v, rounded beyond 2^53.  n is from -2^52 to 2^52.
static inline int64_t sm_count_i64(int64_t v, int64_t n)
{
    if (-0x10000000000000 <= v && v <= 0x10000000000000)
        return v + n;
    return sm_to_i64(sm_add(sm_from_i64(v), sm_from_i64(n)));
}
// snippet of emitted C: sm_read_f64
static inline SmF64 sm_read_f64(SmF64 x)
{
    return SM_UNLIKELY(sm_is_nan(x)) ? sm_from_i32(0) : x;
}
// snippet of emitted C: end
#if !SM_F64_SOFT
// snippet of emitted C: sm_read_f32 (only where SmF64 is a double)
static inline SmF64 sm_read_f32(float v)
{
    const SmF64 x = sm_from_f32(v);
    return SM_UNLIKELY(sm_is_nan(x)) ? sm_from_i32(0) : x;
}
// snippet of emitted C: sm_no_nan_f32 (only where SmF64 is a double)
static inline float sm_no_nan_f32(float v)
{
    return SM_UNLIKELY(sm_is_nan(sm_from_f32(v))) ? 0.0f : v;
}
// snippet of emitted C: end
#endif

static inline SmF64 sm_from_i8(int8_t v) { return sm_from_i32(v); }
static inline SmF64 sm_from_i16(int16_t v) { return sm_from_i32(v); }
static inline SmF64 sm_from_u8(uint8_t v) { return sm_from_i32(v); }
static inline SmF64 sm_from_u16(uint16_t v) { return sm_from_i32(v); }
static inline SmF64 sm_from_bool(bool v) { return sm_from_i32(v); }

static inline uint32_t sm_f32_bits(float v) { uint32_t u; memcpy(&u, &v, sizeof u); return u; }
static inline float sm_f32_from_bits(uint32_t u) { float v; memcpy(&v, &u, sizeof v); return v; }

// The value, as F64, of an element whose bits are `cell`; a NaN is read as 0.  Bits beyond the type's width are ignored.
static inline SmF64 sm_cell_to_f64(SmType type, uint64_t cell)
{
    switch (type) {
    case SM_I8: return sm_from_i32(cell & 0x80u ? (int32_t)(cell & 0xffu) - 0x100 : (int32_t)(cell & 0xffu));
    case SM_I16: return sm_from_i32(cell & 0x8000u ? (int32_t)(cell & 0xffffu) - 0x10000 : (int32_t)(cell & 0xffffu));
    case SM_I32: { const uint32_t u = (uint32_t)cell; int32_t v; memcpy(&v, &u, sizeof v); return sm_from_i32(v); }
    case SM_I64: { int64_t v; memcpy(&v, &cell, sizeof v); return sm_from_i64(v); }
    case SM_U8: return sm_from_u32((uint32_t)(cell & 0xffu));
    case SM_U16: return sm_from_u32((uint32_t)(cell & 0xffffu));
    case SM_U32: return sm_from_u32((uint32_t)cell);
    case SM_U64: return sm_from_u64(cell);
    case SM_F32: return sm_read_f32(sm_f32_from_bits((uint32_t)cell));
    case SM_F64: return sm_read_f64(sm_from_bits(cell));
    case SM_BOOL: return sm_from_i32((cell & 0xffu) != 0);
    case SM_TYPE_COUNT: break;
    }
    return sm_from_i32(0);
}

// The cell of an element after x is stored in it.
static inline uint64_t sm_cell_from_f64(SmType type, SmF64 x)
{
    switch (type) {
    case SM_I8: return (uint8_t)sm_to_i8(x);
    case SM_I16: return (uint16_t)sm_to_i16(x);
    case SM_I32: return (uint32_t)sm_to_i32(x);
    case SM_I64: return (uint64_t)sm_to_i64(x);
    case SM_U8: return sm_to_u8(x);
    case SM_U16: return sm_to_u16(x);
    case SM_U32: return sm_to_u32(x);
    case SM_U64: return sm_to_u64(x);
    case SM_F32: return sm_f32_bits(sm_to_f32(x));
    case SM_F64: return sm_bits(sm_to_f64(x));
    case SM_BOOL: return sm_to_bool(x);
    case SM_TYPE_COUNT: break;
    }
    return 0;
}

// The cell of the element at p: its bits as stored, NaN included.  The cell of a bool is 0 or 1.
static inline uint64_t sm_cell_load(SmType type, const void *p)
{
    switch (type) {
    case SM_BOOL: return *(const uint8_t *)p != 0;
    case SM_I8: case SM_U8: return *(const uint8_t *)p;
    case SM_I16: case SM_U16: { uint16_t v; memcpy(&v, p, sizeof v); return v; }
    case SM_I32: case SM_U32: case SM_F32: { uint32_t v; memcpy(&v, p, sizeof v); return v; }
    case SM_I64: case SM_U64: case SM_F64: { uint64_t v; memcpy(&v, p, sizeof v); return v; }
    case SM_TYPE_COUNT: break;
    }
    return 0;
}

// Writes the low bytes of a cell, as many as the type has, without conversion; a bool becomes 0 or 1.
static inline void sm_cell_store(SmType type, void *p, uint64_t cell)
{
    switch (type) {
    case SM_BOOL: *(uint8_t *)p = (cell & 0xffu) != 0; break;
    case SM_I8: case SM_U8: *(uint8_t *)p = (uint8_t)cell; break;
    case SM_I16: case SM_U16: { const uint16_t v = (uint16_t)cell; memcpy(p, &v, sizeof v); break; }
    case SM_I32: case SM_U32: case SM_F32: { const uint32_t v = (uint32_t)cell; memcpy(p, &v, sizeof v); break; }
    case SM_I64: case SM_U64: case SM_F64: memcpy(p, &cell, sizeof cell); break;
    case SM_TYPE_COUNT: break;
    }
}

// sm_load returns the value that reading the element at p yields, as an F64.  sm_store stores x in the element at p.  Functions on cells have
// the same results, but with these an 8-bit computer need not widen 8 bits to 64.
static inline SmF64 sm_load(SmType type, const void *p)
{
    switch (type) {
    case SM_I8: { int8_t v; memcpy(&v, p, sizeof v); return sm_from_i32(v); }
    case SM_I16: { int16_t v; memcpy(&v, p, sizeof v); return sm_from_i32(v); }
    case SM_I32: { int32_t v; memcpy(&v, p, sizeof v); return sm_from_i32(v); }
    case SM_I64: { int64_t v; memcpy(&v, p, sizeof v); return sm_from_i64(v); }
    case SM_U8: { uint8_t v; memcpy(&v, p, sizeof v); return sm_from_u32(v); }
    case SM_U16: { uint16_t v; memcpy(&v, p, sizeof v); return sm_from_u32(v); }
    case SM_U32: { uint32_t v; memcpy(&v, p, sizeof v); return sm_from_u32(v); }
    case SM_U64: { uint64_t v; memcpy(&v, p, sizeof v); return sm_from_u64(v); }
    case SM_F32: { float v; memcpy(&v, p, sizeof v); return sm_read_f32(v); }
    case SM_F64: { SmF64 v; memcpy(&v, p, sizeof v); return sm_read_f64(v); }
    case SM_BOOL: return sm_from_i32(*(const uint8_t *)p != 0);
    case SM_TYPE_COUNT: break;
    }
    return sm_from_i32(0);
}

#if defined(__OPTIMIZE_SIZE__) && !SM_F64_SOFT
// When optimizing for size, x is first converted to a 64-bit integer, then clipped to the limits of the type, and stored as a cell.
static inline int64_t sm_to_signed(SmType type, SmF64 x)
{
    const int64_t v = sm_to_i64(x), one = 1;
    const unsigned bits = 8u << (type & 3u), sign = type < SM_U8;
    return type == SM_I64 ? v : sm_clip_i64(v, sign ? -(one << (bits - 1)) : 0, (one << (bits - sign)) - 1);
}

static inline void sm_store(SmType type, void *p, SmF64 x)
{
    const bool other = type >= SM_U64;                // U64, F32, F64, bool
    sm_cell_store(type, p, other ? sm_cell_from_f64(type, x) : (uint64_t)sm_to_signed(type, x));
}
#else
static inline void sm_store(SmType type, void *p, SmF64 x)
{
    switch (type) {
    case SM_I8: { const int8_t v = sm_to_i8(x); memcpy(p, &v, sizeof v); break; }
    case SM_I16: { const int16_t v = sm_to_i16(x); memcpy(p, &v, sizeof v); break; }
    case SM_I32: { const int32_t v = sm_to_i32(x); memcpy(p, &v, sizeof v); break; }
    case SM_I64: { const int64_t v = sm_to_i64(x); memcpy(p, &v, sizeof v); break; }
    case SM_U8: *(uint8_t *)p = sm_to_u8(x); break;
    case SM_U16: { const uint16_t v = sm_to_u16(x); memcpy(p, &v, sizeof v); break; }
    case SM_U32: { const uint32_t v = sm_to_u32(x); memcpy(p, &v, sizeof v); break; }
    case SM_U64: { const uint64_t v = sm_to_u64(x); memcpy(p, &v, sizeof v); break; }
    case SM_F32: { const float v = sm_to_f32(x); memcpy(p, &v, sizeof v); break; }
    case SM_F64: { const SmF64 v = sm_to_f64(x); memcpy(p, &v, sizeof v); break; }
    case SM_BOOL: *(uint8_t *)p = sm_to_bool(x); break;
    case SM_TYPE_COUNT: break;
    }
}
#endif

#endif
