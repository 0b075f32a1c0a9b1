// SPDX-License-Identifier: Apache-2.0
// Builds images by hand for the tests of the VM.  Written from docs/bytecode.md, without code of the compiler's writer.
#ifndef VM_BUILD_H
#define VM_BUILD_H

#include <stdarg.h>
#include <stdint.h>
#include <string.h>

#include "bytecode-vm/image.h"
#include "stdlib/crc32.h"

typedef struct Build {
    uint32_t layout, sv_words, from, to;  // all three in units of 8 bytes; `to` 0: all of it
    uint32_t locals, states, width;
    uint32_t g, s;                        // in units of their sizes
    uint32_t window[8], windows;
    uint32_t output[512], outputs;
    uint32_t f32[8], f32s;
    uint64_t f64[8];
    uint32_t f64s;
    uint8_t code[4096];
    uint32_t size;
    uint32_t end[64], ends;               // of functions: sample, then entry, step, exit of each state
    uint8_t init[64], safe[8];
    uint32_t init_size, safe_size;
} Build;

// Returns the rule that a size beyond 64 KB violates: `rule`, but on a target with offsets of 16 bits the rule about the limit of its memory.
#define BEYOND(rule) (sizeof(SmvmAt) > 2 ? (rule) : SMVM_R_RAM)

// Encodes a reference of three bytes: the offset in units of the type's size in the lowest 16 and the highest 4 bits, the type in between.
#define PLACE_OF(type, at) (((uint32_t)(at) & 0xffff) | (uint32_t)(type) << 16 | (uint32_t)(at) >> 16 << 20)
#define PLACE(type, offset) PLACE_OF(SM_##type, (offset) >> smvm_type_shift(SM_##type))
#define WINDOW(size, stats) WINDOW_OF(SM_ROLL_F64, size, stats)
#define WINDOW_OF(type, size, stats) ((uint32_t)(size) | (uint32_t)(type) << 17 | (uint32_t)(stats) << 21)

static inline uint32_t put_number(uint8_t *p, uint32_t v)
{
    if (v < 96) {
        p[0] = (uint8_t)v;
        return 1;
    }
    if (v < 96 + 24 * 128) {
        v -= 96;
        p[0] = (uint8_t)(96 + v / 128);
        p[1] = (uint8_t)(v % 128);
        return 2;
    }
    v -= 96 + 24 * 128;
    p[0] = (uint8_t)(120 + (v >> 21));
    p[1] = (uint8_t)(v >> 14 & 127);
    p[2] = (uint8_t)(v / 128 % 128);
    p[3] = (uint8_t)(v % 128);
    return 4;
}

static inline void put_bytes(uint8_t **p, uint64_t v, unsigned n)
{
    for (unsigned i = 0; i < n; i++)
        *(*p)++ = (uint8_t)(v >> 8 * i);
}

// Appends an instruction: its opcode, then the n numbers that follow as arguments.
static inline void code(Build *b, unsigned op, int n, ...)
{
    va_list numbers;

    b->code[b->size++] = (uint8_t)op;
    va_start(numbers, n);
    for (int i = 0; i < n; i++)
        b->size += put_number(b->code + b->size, va_arg(numbers, unsigned));
    va_end(numbers);
}

// Appends an instruction that loads or stores a value of a type at an offset in bytes: typed(b, SMVM_ldx_elem, SM_F64, 16).
static inline void typed(Build *b, unsigned op, unsigned type, unsigned offset)
{
    code(b, op + type, 1, offset >> (type == SMVM_RAW ? 3u : smvm_type_shift(type)));
}

static inline void end_function(Build *b) { b->end[b->ends++] = b->size; }

static inline void fix_crc(uint8_t *image)
{
    uint32_t n = image[8] | (uint32_t)image[9] << 8 | (uint32_t)image[10] << 16, crc = SM_CRC32_START;
    uint8_t *at = image + 4;

    for (uint32_t i = 0; i < n; i++)
        if (i < 4 || i > 7)
            crc = sm_crc32_byte(crc, image[i]);
    put_bytes(&at, sm_crc32_end(crc), 4);
}

static inline uint32_t put_machine(const Build *b, uint8_t *p)
{
    const uint32_t number[] = {b->sv_words, b->from, b->to != 0 ? b->to : b->sv_words, b->locals, b->windows, b->outputs, b->states, b->width,
                               b->f32s, b->f64s, b->g, b->s};
    uint8_t *start = p;

    put_bytes(&p, b->layout, 4);
    for (unsigned i = 0; i < sizeof number / sizeof number[0]; i++)
        p += put_number(p, number[i]);
    for (uint32_t i = 0; i < b->windows; i++)
        put_bytes(&p, b->window[i], 4);
    for (uint32_t i = 0; i < b->outputs; i++)
        put_bytes(&p, b->output[i], 3);
    for (uint32_t i = 0; i < b->ends; i++)
        put_bytes(&p, b->end[i], b->width);
    for (uint32_t i = 0; i < b->f32s; i++)
        put_bytes(&p, b->f32[i], 4);
    for (uint32_t i = 0; i < b->f64s; i++)
        put_bytes(&p, b->f64[i], 8);
    return (uint32_t)(p - start);
}

// Writes the header and the section table of n sections whose bytes follow one another.  Returns the length of the image.
static inline uint32_t put_header(uint8_t *image, unsigned n, const uint8_t *id, const uint32_t *size)
{
    uint8_t *p = image + 12;
    uint32_t at = 12 + 8 * n;

    for (unsigned i = 0; i < n; i++) {
        *p++ = id[i];
        *p++ = id[i] == 0x01 || id[i] == 0x04 || id[i] == 0x05 || id[i] == 0x07 || id[i] == 0x08 ? 1 : 2;
        put_bytes(&p, at, 3);
        put_bytes(&p, size[i], 3);
        at += size[i];
    }
    memcpy(image, "smb\2", 4);
    p = image + 8;
    put_bytes(&p, at, 3);
    *p = (uint8_t)n;
    fix_crc(image);
    return at;
}

// Adds the sections with these ids, at most 20.  Each MACHINE, CODE, INIT, SAFE, SWAP and ABORT belongs to the next machine of b.  Sections with
// other ids have two bytes without meaning.
static inline uint32_t build_sections(const Build *b, unsigned n, const uint8_t *id, uint8_t *image)
{
    uint32_t size[20], at = 12 + 8 * n;
    const Build *next = b;

    for (unsigned i = 0; i < n; i++) {
        const bool marks = id[i] == 0x05 || id[i] == 0x07 || id[i] == 0x08;
        if (id[i] == 0x81)
            b = next++;
        size[i] = id[i] == 0x82 ? b->size : id[i] == 0x83 ? b->init_size : marks ? b->safe_size : 2;
        if (id[i] == 0x81)
            size[i] = put_machine(b, image + at);
        else if (id[i] == 0x82)
            memcpy(image + at, b->code, b->size);
        else if (id[i] == 0x83)
            memcpy(image + at, b->init, b->init_size);
        else if (marks)
            memcpy(image + at, b->safe, b->safe_size);
        else
            image[at] = image[at + 1] = 0xa5;
        at += size[i];
    }
    return put_header(image, n, id, size);
}

static inline uint32_t build_image(const Build *b, uint8_t *image)
{
    static const uint8_t id[] = {0x7f, 0x81, 0x82, 0x83};

    return build_sections(b, 4, id, image);
}

// Returns where section `index` of the image begins, and its length.
static inline uint32_t section_at(const uint8_t *image, unsigned index)
{
    const uint8_t *p = image + 12 + 8 * index;
    return p[2] | (uint32_t)p[3] << 8 | (uint32_t)p[4] << 16;
}

#endif
