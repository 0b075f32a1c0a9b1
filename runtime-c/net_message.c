// SPDX-License-Identifier: Apache-2.0
// The wire form of messages (net.h).  Every loop is bounded by the table of the message, never by a received byte.
#include <string.h>

#include "runtime-c/net.h"
#include "stdlib/convert.h"
#include "stdlib/crc32.h"

#define LOWEST  0xFFF0000000000000u       // the bits of minus and plus infinity
#define HIGHEST 0x7FF0000000000000u

enum { MAGIC_LOW = 0x53, MAGIC_HIGH = 0x4D, VERSION = 1 };

// ---- bytes ----

// put32 and get32: for a little-endian processor, compilers make one store or load of each. They do not do that for a loop over the bytes.
static inline void put32(uint8_t *at, uint32_t x)
{
    at[0] = (uint8_t)x;
    at[1] = (uint8_t)(x >> 8);
    at[2] = (uint8_t)(x >> 16);
    at[3] = (uint8_t)(x >> 24);
}

static inline uint32_t get32(const uint8_t *at) { return at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24; }

// Writes the lowest n bytes of x: 1, 2, 4 or 8.
static void put(uint8_t *at, uint64_t x, unsigned n)
{
    if (n < 4) {
        at[0] = (uint8_t)x;
        at[n - 1] = (uint8_t)(x >> 8 * (n - 1));
        return;
    }
    put32(at, (uint32_t)x);
    if (n > 4)
        put32(at + 4, (uint32_t)(x >> 32));
}

// Reads n bytes: 1, 2, 4 or 8.
static uint64_t get(const uint8_t *at, unsigned n)
{
    if (n < 4)
        return n == 1 ? at[0] : (uint64_t)(at[0] | (uint32_t)at[1] << 8);
    return n == 4 ? get32(at) : get32(at) | (uint64_t)get32(at + 4) << 32;
}

// ---- values ----

// The bits of infinity in a type; 0 if the type has none.
static uint64_t infinity_of(SmType type) { return type == SM_F64 ? 0x7FF0000000000000u : type == SM_F32 ? 0x7F800000u : 0; }

// Whether the bits are those of an infinity or a NaN.
static bool is_not_finite(SmType type, uint64_t bits) { return infinity_of(type) != 0 && (bits & infinity_of(type)) == infinity_of(type); }

// Returns the bits that are sent for an element: 0 for a NaN, the largest finite number for an infinity.
static uint64_t bits_to_send(SmType type, uint64_t bits)
{
    const uint64_t sign = type == SM_F64 ? (uint64_t)1 << 63 : (uint64_t)1 << 31;

    if (type == SM_BOOL)
        return bits != 0;
    if (!is_not_finite(type, bits))
        return bits;
    return bits & ~(infinity_of(type) | sign) ? 0 : bits - 1;          // the largest finite number precedes the infinity
}

// Returns why a received value is refused: it is not finite, or out of range. SM_NET_accepted if it is not refused.
static SmNetCount check_value(const SmNetField *f, const uint8_t *at)
{
    const SmType type = (SmType)f->type;
    const uint64_t bits = get(at, sm_type_bytes[type]);
    SmF64 x;

    if (type == SM_BOOL)
        return bits > 1 ? SM_NET_nan : SM_NET_accepted;
    if (is_not_finite(type, bits))
        return SM_NET_nan;
    if (f->least == LOWEST && f->most == HIGHEST)             // no @range: every finite number is accepted
        return SM_NET_accepted;
    x = sm_cell_to_f64(type, bits);
    return sm_le(sm_from_bits(f->least), x) && sm_le(x, sm_from_bits(f->most)) ? SM_NET_accepted : SM_NET_range;
}

// ---- messages ----

static size_t end_of_values(const SmNetMessage *m) { return (size_t)m->size - SM_NET_CRC - (m->key ? SM_NET_CODE : 0); }

void sm_net_encode(const SmNetMessage *m, const uint64_t *value, SmNetStamp stamp, uint8_t *bytes)
{
    uint8_t *at = bytes + SM_NET_HEADER;
    const size_t end = end_of_values(m), crc = (size_t)m->size - SM_NET_CRC;

    bytes[0] = MAGIC_LOW;
    bytes[1] = MAGIC_HIGH;
    bytes[2] = VERSION;
    bytes[3] = m->key != NULL;
    put32(bytes + 4, m->hash);
    put32(bytes + 8, stamp.run);
    put32(bytes + 12, stamp.number);
    for (uint16_t i = 0; i < m->fields; i++) {
        const SmType type = (SmType)m->field[i].type;
        put(at, bits_to_send(type, value[i]), sm_type_bytes[type]);
        at += sm_type_bytes[type];
    }
    if (m->key)
        m->seal(bytes, end, m->key, bytes + end);
    put32(bytes + crc, sm_crc32(bytes, crc));
}

// Whether the authentication code of a message is correct.  The duration does not depend on which bytes are wrong.
static bool is_sealed(const SmNetMessage *m, const uint8_t *bytes)
{
    const size_t end = end_of_values(m);
    uint8_t code[SM_NET_CODE], differs = 0;

    m->seal(bytes, end, m->key, code);
    for (unsigned i = 0; i < SM_NET_CODE; i++)
        differs |= code[i] ^ bytes[end + i];
    return differs == 0;
}

SmNetCount sm_net_check_header(const SmNetMessage *m, const uint8_t *bytes)
{
    if (bytes[0] != MAGIC_LOW || bytes[1] != MAGIC_HIGH || bytes[2] != VERSION || bytes[3] > 1)
        return SM_NET_damaged;
    return get32(bytes + 4) == m->hash ? SM_NET_accepted : SM_NET_hash;
}

// Returns why the header, the length or the checksums of a message are refused; SM_NET_accepted if they are not.
static SmNetCount check_frame(const SmNetMessage *m, const uint8_t *bytes, size_t n)
{
    const size_t crc = (size_t)m->size - SM_NET_CRC;
    SmNetCount cause;

    if (n != m->size)
        return n < m->size ? SM_NET_short_ : SM_NET_long_;
    cause = sm_net_check_header(m, bytes);
    if (cause == SM_NET_damaged || get32(bytes + crc) != sm_crc32(bytes, crc))
        return SM_NET_damaged;
    if (cause != SM_NET_accepted)
        return cause;
    if (bytes[3] != (m->key != NULL) || (m->key && !is_sealed(m, bytes)))
        return SM_NET_key;
    return SM_NET_accepted;
}

// Checks a received message of n bytes and reads its stamp. Returns SM_NET_accepted, or why it is refused.
SmNetCount sm_net_check(const SmNetMessage *m, const uint8_t *bytes, size_t n, SmNetStamp *stamp)
{
    SmNetCount cause = check_frame(m, bytes, n);
    const uint8_t *at = bytes + SM_NET_HEADER;

    for (uint16_t i = 0; i < m->fields && cause == SM_NET_accepted; i++) {
        cause = check_value(&m->field[i], at);
        at += sm_type_bytes[m->field[i].type];
    }
    if (cause != SM_NET_accepted)
        return cause;
    stamp->run = get32(bytes + 8);
    stamp->number = get32(bytes + 12);
    return SM_NET_accepted;
}

void sm_net_values(const SmNetMessage *m, const uint8_t *bytes, uint64_t *value)
{
    const uint8_t *at = bytes + SM_NET_HEADER;

    for (uint16_t i = 0; i < m->fields; i++) {
        const unsigned n = sm_type_bytes[m->field[i].type];
        value[i] = get(at, n);
        at += n;
    }
}

// ---- the order of messages ----

// Accepts the first message of a run of the sender.
static SmNetCount begin_run(SmNetOrder *o, SmNetStamp stamp)
{
    o->any = true;
    o->last = stamp;
    o->seen = 1;
    return SM_NET_accepted;
}

// Decides whether a message is newer than those accepted before, and records it if it is accepted.
SmNetCount sm_net_order(SmNetOrder *o, SmNetStamp stamp, bool sealed, bool silent)
{
    const uint32_t ahead = stamp.number - o->last.number, behind = o->last.number - stamp.number;

    if (!o->any)
        return sealed && stamp.run < o->last.run ? SM_NET_late : begin_run(o, stamp);
    if (stamp.run != o->last.run)
        return (sealed ? stamp.run > o->last.run : silent) ? begin_run(o, stamp) : SM_NET_late;
    if (ahead != 0 && ahead < 0x80000000u) {
        o->seen = ahead < 64 ? o->seen << ahead | 1 : 1;
        o->last = stamp;
        return SM_NET_accepted;
    }
    return behind < 64 && (o->seen >> behind & 1) ? SM_NET_repeated : SM_NET_late;
}
