// SPDX-License-Identifier: Apache-2.0
// The pins of an image (docs/bytecode.md, IO): accepted sections, refused ones, and every byte of a section changed.  Images are built by hand.
#include <stdlib.h>
#include <string.h>

#include "stdlib/convert.h"
#include "tests/test.h"
#include "tests/unit/vm_hammer.h"

enum { VECTOR = 64, LAYOUT = 77, SECTION_AT = 12 + 3 * 8 };

// A section that is being built: the vector's layout and size, the number of pins, then rows.
typedef struct Pins {
    uint8_t at[400];
    uint32_t n;
} Pins;

static void put(Pins *p, uint64_t v, unsigned bytes)
{
    uint8_t *to = p->at + p->n;

    put_bytes(&to, v, bytes);
    p->n += bytes;
}

static void put_varint(Pins *p, uint32_t v) { p->n += put_number(p->at + p->n, v); }

static Pins begin(uint32_t count)
{
    Pins p;

    memset(&p, 0, sizeof p);
    put(&p, LAYOUT, 4);
    put_varint(&p, VECTOR / 8);
    put_varint(&p, count);
    return p;
}

static void row(Pins *p, unsigned front, uint32_t element, uint32_t pin)
{
    put(p, front, 1);
    put(p, element, 3);
    put_varint(p, pin);
}

#define WHOLE_OF(v) PLACE_OF(15, (uint32_t)(v) & 0xfffff)

static void whole(Pins *p, int32_t v) { put(p, WHOLE_OF(v), 3); }
static void single(Pins *p, uint32_t bits) { put(p, PLACE_OF(SM_F32, 0), 3), put(p, bits, 4); }
static void real(Pins *p, uint64_t bits) { put(p, PLACE_OF(SM_F64, 0), 3), put(p, bits, 8); }

static uint8_t image[2000];

// Builds an image of these pins and a machine that does nothing.
static uint32_t put_pins_image(const Pins *p, uint8_t pins_id, uint8_t version)
{
    const uint8_t id[] = {pins_id, 0x81, 0x82};
    uint32_t size[] = {p->n, 0, 0}, at = SECTION_AT;
    Build b;

    memset(&b, 0, sizeof b);
    b.layout = LAYOUT;
    b.sv_words = VECTOR / 8;
    b.states = b.width = 1;
    b.s = 2;
    for (int i = 0; i < 4; i++)
        end_function(&b);
    memcpy(image + at, p->at, p->n);
    size[1] = put_machine(&b, image + at + p->n);
    put_header(image, 3, id, size);
    image[13] = version;
    fix_crc(image);
    return at + p->n + size[1];
}

static uint8_t verify_pins(const Pins *p)
{
    SmvmVerdict v;

    return smvm_verify(image, put_pins_image(p, 0x03, 2), &v);
}

static uint8_t verify_row(unsigned front, uint32_t element, uint32_t pin)
{
    Pins p = begin(1);

    row(&p, front, element, pin);
    return verify_pins(&p);
}

// ---- accepted sections ----

static Pins sample(void)
{
    Pins p = begin(6);

    row(&p, 0x00, PLACE(F64, 16), 0);
    row(&p, 0xe0, PLACE(F32, 24), 65535);
    whole(&p, 250);
    whole(&p, -125);
    put(&p, 255, 1);
    row(&p, 0x61, PLACE(U16, 28), 96);
    single(&p, 0x3e99999au);
    real(&p, 0x3fb999999999999au);
    row(&p, 0x81, PLACE(I8, 30), 3);
    whole(&p, -524288);
    row(&p, 0x0e | 0x80, PLACE(BOOL, 31), 7);
    put(&p, 3, 1);
    row(&p, 0x87, PLACE(BOOL, 63), 3000);
    whole(&p, 1);
    return p;
}

static void test_reading(void)
{
    Pins p = sample();
    SmvmPins all;
    SmvmPin a;

    CHECK(verify_pins(&p) == 0);
    CHECK(smvm_pins(image, &all) && all.left == 6 && all.layout == LAYOUT && all.sv_size == VECTOR / 8);
    CHECK(smvm_next_pin(&all, &a) && a.kind == 0 && a.type == SM_F64 && a.offset == 16 && a.pin == 0 && a.flags == 0 && a.hold == 0);
    CHECK(sm_eq(a.scale, sm_from_i32(1)) && sm_eq(a.zero, sm_from_i32(0)) && sm_eq(a.safe, sm_from_i32(0)));
    CHECK(smvm_next_pin(&all, &a) && a.type == SM_F32 && a.offset == 24 && a.pin == 65535 && a.hold == 255);
    CHECK(sm_eq(a.scale, sm_from_i32(250)) && sm_eq(a.zero, sm_from_i32(-125)));
    CHECK(smvm_next_pin(&all, &a) && a.kind == 1 && a.type == SM_U16 && a.pin == 96);
    CHECK(sm_bits(a.scale) == sm_bits(sm_from_f32(0.3f)) && sm_bits(a.zero) == 0x3fb999999999999au);
    CHECK(smvm_next_pin(&all, &a) && a.type == SM_I8 && sm_eq(a.safe, sm_from_i32(-524288)));
    CHECK(smvm_next_pin(&all, &a) && a.kind == 2 && a.type == SM_BOOL && a.flags == 3 && a.hold == 3);
    CHECK(smvm_next_pin(&all, &a) && a.kind == 3 && a.offset == 63 && a.flags == 1 && a.pin == 3000 && sm_eq(a.safe, sm_from_i32(1)));
    CHECK(!smvm_next_pin(&all, &a));
}

// An image with pins of another version, and one without pins.
static void test_absent(void)
{
    Pins p = sample();
    SmvmVerdict v;
    SmvmPins all;

    CHECK(smvm_verify(image, put_pins_image(&p, 0x03, 3), &v) == 0 && !smvm_pins(image, &all));
    CHECK(smvm_verify(image, put_pins_image(&p, 0x7f, 1), &v) == 0 && !smvm_pins(image, &all));
    p = begin(0);
    CHECK(verify_pins(&p) == 0 && smvm_pins(image, &all) && all.left == 0);
}

// ---- refused sections ----

static void test_record(void)
{
    Pins p = sample();

    for (uint32_t n = 0; n < sample().n; n++) {       // cut at any position
        p.n = n;
        CHECK(verify_pins(&p) == SMVM_R_IO);
    }
    p = sample();
    put(&p, 0, 1);                                    // a byte after the last pin
    CHECK(verify_pins(&p) == SMVM_R_IO);
    p = sample();
    p.at[5] = 5;                                      // fewer pins than there are; more pins
    CHECK(verify_pins(&p) == SMVM_R_IO);
    p.at[5] = 7;
    CHECK(verify_pins(&p) == SMVM_R_IO);
    p.at[5] = 0x80;                                   // not a valid number
    CHECK(verify_pins(&p) == SMVM_R_IO);
}

static void test_rows(void)
{
    CHECK(verify_row(0, PLACE(F64, 56), 65535) == 0);
    CHECK(verify_row(0, PLACE(F64, 64), 0) == SMVM_R_PIN);
    CHECK(verify_row(0, PLACE(U8, 63), 0) == 0 && verify_row(0, PLACE(U8, 64), 0) == SMVM_R_PIN);
    CHECK(verify_row(0, PLACE_OF(9, 0xfffff), 0) == SMVM_R_PIN);
    CHECK(verify_row(0, PLACE(F64, 0), 65536) == SMVM_R_PIN);
    CHECK(verify_row(0, PLACE(F64, 0), 0x1000c5fu) == SMVM_R_PIN);
    for (unsigned type = 10; type < 16; type++)       // an analog pin of type bool; a type that does not exist
        CHECK(verify_row(0, PLACE_OF(type, 0), 0) == SMVM_R_PIN);
    for (unsigned type = 0; type < 10; type++)
        CHECK(verify_row(2, PLACE_OF(type, 0), 0) == SMVM_R_PIN && verify_row(1, PLACE_OF(type, 0), 0) == 0);
}

static void test_flags(void)
{
    for (unsigned flags = 0; flags < 8; flags++) {
        CHECK((verify_row(2 | flags << 2, PLACE(BOOL, 0), 0) == 0) == (flags < 6));         // an input has at most one resistor
        CHECK((verify_row(3 | flags << 2, PLACE(BOOL, 0), 0) == 0) == (flags < 2));         // an output has no resistor
        CHECK((verify_row(0 | flags << 2, PLACE(F64, 0), 0) == 0) == (flags == 0));
        CHECK((verify_row(1 | flags << 2, PLACE(F64, 0), 0) == 0) == (flags == 0));
    }
}

static uint8_t verify_scale(uint32_t entry, uint64_t bits, unsigned bytes)
{
    Pins p = begin(1);

    row(&p, 0x20, PLACE(F64, 0), 0);
    put(&p, entry, 3);
    put(&p, bits, bytes);
    return verify_pins(&p);
}

static uint8_t verify_real(unsigned front, uint64_t bits)
{
    Pins p = begin(1);

    row(&p, front, PLACE(F64, 0), 0);
    real(&p, bits);
    return verify_pins(&p);
}

static void test_numbers(void)
{
    CHECK(verify_scale(WHOLE_OF(1), 0, 0) == 0);
    CHECK(verify_scale(WHOLE_OF(0), 0, 0) == SMVM_R_PIN_NUMBER);
    CHECK(verify_scale(PLACE_OF(SM_F32, 0), 0x3f800000u, 4) == 0);
    CHECK(verify_scale(PLACE_OF(SM_F32, 0), 0x80000000u, 4) == SMVM_R_PIN_NUMBER);
    CHECK(verify_scale(PLACE_OF(SM_F32, 0), 0x7f800000u, 4) == SMVM_R_PIN_NUMBER);
    CHECK(verify_scale(PLACE_OF(SM_F32, 1), 0x3f800000u, 4) == SMVM_R_IO);    // the other numbers are 0
    CHECK(verify_scale(PLACE_OF(SM_F64, 0x10000), 1, 8) == SMVM_R_IO);
    for (unsigned type = 0; type < 15; type++)        // of no number
        CHECK(type == SM_F32 || type == SM_F64 || verify_scale(PLACE_OF(type, 0), 0, 0) == SMVM_R_IO);
    CHECK(verify_scale(WHOLE_OF(524287), 0, 0) == 0 && verify_scale(WHOLE_OF(-524288), 0, 0) == 0);
    for (unsigned front = 0x20; front <= 0x81; front = front == 0x20 ? 0x40 : front == 0x40 ? 0x81 : 0x100) {
        CHECK(verify_real(front, 1) == 0);
        CHECK(verify_real(front, 0x7ff0000000000000u) == SMVM_R_PIN_NUMBER);
        CHECK(verify_real(front, 0xfff0000000000000u) == SMVM_R_PIN_NUMBER);
        CHECK(verify_real(front, 0x7ff8000000000000u) == SMVM_R_PIN_NUMBER);
    }
}

// ---- hostile ----

// Sets each byte of the section to each value: the section is refused, or the pins read from it are usable.
static void test_mutants(void)
{
    const Pins p = sample();
    uint32_t n = put_pins_image(&p, 0x03, 2);
    uint8_t *copy = malloc(n);

    memcpy(copy, image, n);
    for (uint32_t at = 12; at < SECTION_AT + p.n; at++) {
        for (unsigned value = 0; value < 256; value++) {
            copy[at] = (uint8_t)value;
            fix_crc(copy);
            (void)hammer(copy, n, 1, 1);
        }
        memcpy(copy, image, n);
    }
    CHECK(hammer(copy, n, 1, 1) == 0);
    free(copy);
}

// Random sections with a valid beginning.
static void test_random(void)
{
    uint64_t seed = 7;
    unsigned long accepted = 0;

    for (int i = 0; i < 20000; i++) {
        Pins p = begin(1 + (uint32_t)(hammer_random(&seed) % 3));
        uint32_t n;
        uint8_t *copy;
        for (uint64_t k = hammer_random(&seed) % 24; k > 0; k--)
            put(&p, hammer_random(&seed) >> 40, 1);
        n = put_pins_image(&p, 0x03, 2);
        copy = malloc(n);
        memcpy(copy, image, n);
        accepted += hammer(copy, n, 1, 1) == 0;
        free(copy);
    }
    CHECK(accepted < 20000);
}

int main(void)
{
    test_reading();
    test_absent();
    test_record();
    test_rows();
    test_flags();
    test_numbers();
    test_mutants();
    test_random();
    return test_end("vm_pins");
}
