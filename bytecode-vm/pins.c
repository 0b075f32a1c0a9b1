// SPDX-License-Identifier: Apache-2.0
// Reads the pins of an image in place, row by row (docs/bytecode.md, IO), and checks them for the verifier.
#include <string.h>

#include "bytecode-vm/image.h"
#include "bytecode-vm/smvm.h"
#include "stdlib/convert.h"

// The bits of the first byte of a row.
enum {
    KIND = 3, DIGITAL = 2, OUTPUT = 1,        // bits 0 and 1, as SmvmPin.kind
    FLAGS_AT = 2, FLAGS = 7,                  // bits 2 to 4, as SmvmPin.flags
    SCALED = 0x20, SHIFTED = 0x40,            // SCALED: the row has a scale.  SHIFTED: the row has an offset
    MORE = 0x80                               // the row has a hold (inputs) or a safe value (outputs)
};

// Reads a varint into *n; a larger one becomes `most`.  Returns false if the section ends inside it.
static bool read_count(SmvmPins *p, SmvmAt most, SmvmAt *n)
{
    const bool there = smvm_read_number(&p->in) != SMVM_VARINT_CUT_SHORT;

    *n = there && p->in.n < most ? p->in.n : most;
    return there;
}

// Initialises p, so that smvm_next_pin reads the first pin of the image.  Returns false if the image has no pins.
bool smvm_pins(SmvmBytes image, SmvmPins *p)
{
    SmvmAt at;

    memset(p, 0, sizeof *p);
    if (!smvm_find_section(image, SMVM_S_IO, &p->in) || (at = smvm_skip(&p->in, 4)) == 0)
        return false;
    p->layout = smvm_uint(image, at, 4);
    return read_count(p, SMVM_NOWHERE >> 3, &p->sv_size) && read_count(p, SMVM_NOWHERE, &p->left);
}

// Numbers are encoded like locations.  If the type field is WHOLE, the offset field contains the number, 20 bits in two's complement.
// Otherwise the type is F32 or F64, the offset field is 0, and the number's bits follow.
enum { WHOLE = 15 };

// Reads a number into *x. Returns false if the section ends inside the number, or the encoding of the number is invalid.
static bool read_f64(SmvmPins *p, SmF64 *x)
{
    const SmvmAt at = smvm_skip(&p->in, SMVM_LOCATION_BYTES);
    uint16_t low;
    uint8_t type, high;
    SmvmAt bits;

    if (at == 0)
        return false;
    low = (uint16_t)smvm_uint(p->in.image, at, 2);
    type = smvm_u8(p->in.image, (SmvmAt)(at + 2));
    high = type >> 4;
    type &= 0xf;
    if (type == WHOLE) {
        *x = sm_from_i32((int32_t)low + (int32_t)(high < 8 ? high : high - 16) * 0x10000);
        return true;
    }
    if ((type != SM_F32 && type != SM_F64) || high != 0 || low != 0 || (bits = smvm_skip(&p->in, type == SM_F32 ? 4 : 8)) == 0)
        return false;
    if (type == SM_F32)
        *x = sm_from_f32(sm_f32_from_bits(smvm_uint(p->in.image, bits, 4)));
    else
        smvm_read_bits(p->in.image, bits, x, 8);
    return true;
}

// Reads the location of the pin's element.  Returns false if the section ends inside it.
static bool read_element(SmvmPins *p, SmvmPin *pin)
{
    const SmvmAt at = smvm_skip(&p->in, SMVM_LOCATION_BYTES);
    SmvmLocation element;

    if (at == 0)
        return false;
    element = smvm_location(p->in.image, at);
    pin->type = (uint8_t)element.type;
    pin->offset = element.offset;
    return true;
}

// Reads the field that is present if bit MORE is set: the safe value of an output, the hold of an input.  Returns false if the section ends
// inside it, or the number is invalid.
static bool read_safe_or_hold(SmvmPins *p, SmvmPin *pin)
{
    SmvmAt at;

    if (pin->kind & OUTPUT)
        return read_f64(p, &pin->safe);
    if ((at = smvm_skip(&p->in, 1)) == 0)
        return false;
    pin->hold = smvm_u8(p->in.image, at);
    return true;
}

// Reads the next pin, in the order of the .io file.  Returns false at the end.
bool smvm_next_pin(SmvmPins *p, SmvmPin *pin)
{
    SmvmAt at;
    SmvmVarintStatus found;
    uint8_t front;

    if (p->left == 0 || (at = smvm_skip(&p->in, 1)) == 0)
        return false;
    front = smvm_u8(p->in.image, at);
    memset(pin, 0, sizeof *pin);                      // an F64 whose bits are all zero is 0
    pin->kind = front & KIND;
    pin->flags = front >> FLAGS_AT & FLAGS;
    pin->scale = sm_from_i32(1);
    if (!read_element(p, pin) || (found = smvm_read_number(&p->in)) == SMVM_VARINT_CUT_SHORT)
        return false;
    pin->pin = found == SMVM_VARINT_TOO_LARGE ? UINT16_MAX + UINT32_C(1) : p->in.n;
    if ((front & SCALED && !read_f64(p, &pin->scale)) || (front & SHIFTED && !read_f64(p, &pin->zero))
        || (front & MORE && !read_safe_or_hold(p, pin)))
        return false;
    p->left--;
    return true;
}

// ---- for the verifier ----

// Compares the two bytes with sign and exponent alone, because avr-gcc 5.4 takes a comparison of all 64 masked bits for true.
SMVM_NOINLINE static bool is_finite(const SmF64 *x)
{
    const uint16_t one = 1;
    uint8_t is_little;
    uint16_t top;

    memcpy(&is_little, &one, sizeof is_little);
    memcpy(&top, (const uint8_t *)x + (is_little ? sizeof *x - sizeof top : 0), sizeof top);
    return (top & 0x7FF0u) != 0x7FF0u;
}

// Whether the pin's element lies within the state vector.
static bool is_in_vector(const SmvmPins *p, const SmvmPin *pin)
{
    const SmvmAt size = (SmvmAt)(8 * p->sv_size);
    const uint8_t bytes = (uint8_t)(1u << smvm_shift(pin->type));

    return bytes <= size && pin->offset <= (SmvmAt)(size - bytes);
}

// Whether the pin can have its flags: only digital inputs have pull resistors, at most one of the two; only digital pins can be inverted.
static bool are_flags_valid(const SmvmPin *pin)
{
    if (pin->kind & DIGITAL)
        return pin->kind & OUTPUT ? pin->flags <= 1 : pin->flags <= 5;
    return pin->flags == 0;
}

// Returns 0, or the rule that the pin breaks.
static uint8_t check_pin(const SmvmPins *p, const SmvmPin *pin)
{
    if (pin->pin > UINT16_MAX || pin->type >= SM_TYPE_COUNT || !are_flags_valid(pin) || (pin->type == SM_BOOL) != ((pin->kind & DIGITAL) != 0)
        || !is_in_vector(p, pin))
        return SMVM_R_PIN;
    if (!is_finite(&pin->scale) || !is_finite(&pin->zero) || !is_finite(&pin->safe) || !sm_to_bool(pin->scale))
        return SMVM_R_PIN_NUMBER;
    return 0;
}

// Returns 0, or the rule that a pin or the section breaks, and sets *at to the offset of the error.
static uint8_t check_pins(SmvmPins *p, SmvmAt *at)
{
    SmvmPin pin;
    uint8_t rule;

    while (p->left > 0) {
        *at = p->in.at;
        if (!smvm_next_pin(p, &pin))
            return SMVM_R_IO;
        if ((rule = check_pin(p, &pin)) != 0)
            return rule;
    }
    *at = p->in.at;
    return p->in.at == p->in.end ? 0 : SMVM_R_IO;
}

// Returns 0, or the rule that the IO section breaks, and sets *at to the offset of the error (pins.c).
SMVM_NOINLINE uint8_t smvm_check_pins(SmvmBytes image, SmvmAt *at)
{
    SmvmPins p;

    if (smvm_pins(image, &p))
        return check_pins(&p, at);
    *at = p.in.at;
    return p.in.at == 0 ? 0 : SMVM_R_IO;              // no section IO, or one that is cut short
}
