// SPDX-License-Identifier: Apache-2.0
// Each byte of several images is changed to other values, with a corrected checksum.  The verifier refuses the result, or it runs without an
// access outside its memory.  Each image is also cut at every length.
//
//     vm_mutate [STEPS [VALUES [FOLDER|- [IMAGE…]]]]
// STEPS: steps of each accepted mutant.  VALUES: number of values for each byte (256: all).  FOLDER: where the images are written, as seeds for
// fuzzing.  IMAGE: more images.
//
// Run it under sanitizers (make check-mutate): without them, few errors are detected.
#include "tests/heap.h"
#include "tests/unit/vm_hammer.h"

#include <stdio.h>

#include "bytecode-vm/auth.h"
#include "compiler/emit/bytecode/bytecode.h"
#include "tests/test.h"

static uint32_t steps = 20, values = 24;
static const char *folder;
static unsigned long accepted, refused;

static bool is_signed(const uint8_t *image)
{
    static const uint8_t key[SMVM_KEY] = {[SMVM_KEY - 1] = 7};
    uint32_t number;

    return smvm_auth_check(image, key, &number);
}

static const uint8_t *whole;                          // the image that is changed
static uint32_t length;

static void try_mutant(const uint8_t *image, uint32_t n, uint64_t seed)
{
    if (hammer(image, n, steps, seed) == 0) {
        accepted++;
        CHECK(!is_signed(image) || (n == length && memcmp(image, whole, n) == 0));
    } else
        refused++;
}

static void keep_image(const uint8_t *image, uint32_t n)
{
    static unsigned number;
    char path[300];
    FILE *f;

    snprintf(path, sizeof path, "%s/%u.smb", folder, number++);
    f = fopen(path, "wb");
    CHECK(f && fwrite(image, 1, n, f) == n && fclose(f) == 0);
}

static void mutate_image(const uint8_t *image, uint32_t n)
{
    uint8_t *copy = malloc(n);                        // of exactly this size, so that a sanitizer notices a read beyond it

    if (folder)
        keep_image(image, n);
    whole = image;
    length = n;
    memcpy(copy, image, n);
    CHECK(hammer(copy, n, 1000, 1) == 0);
    for (uint32_t at = 0; at < n; at++) {
        for (uint32_t k = 1; k <= values; k++) {
            uint64_t seed = (uint64_t)at << 20 | k << 1 | 1;
            copy[at] = (uint8_t)(image[at] + (values > 255 ? k : k < 9 ? 1u << (k - 1) : (uint32_t)(hammer_random(&seed) >> 16)));
            if (at < 8 || at > 10)                    // (a wrong length would make the checksum read outside the image)
                fix_crc(copy);
            try_mutant(copy, n, seed);
        }
        memcpy(copy, image, n);
    }
    free(copy);
}

static void truncate_image(const uint8_t *image, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++) {
        uint8_t *copy = malloc(i ? i : 1);
        memcpy(copy, image, i);
        CHECK(hammer(copy, i, 1, 1) == SMVM_R_LENGTH);
        if (i >= 12) {
            copy[8] = (uint8_t)i;
            copy[9] = (uint8_t)(i >> 8);
            copy[10] = (uint8_t)(i >> 16);
            fix_crc(copy);
            try_mutant(copy, i, 1);
        }
        free(copy);
    }
}

// ---- the images ----

static const char *const sample[] = {"tests/ir/samples/tank.ir", "tests/ir/samples/windows.ir", "tests/ir/samples/ifs.ir", "tests/ir/samples/types.ir"};
enum { SAMPLES = 4 };

static IrMachine *read(Arena *a, StrPool *strings, const char *path)
{
    static char text[100000];
    const char *error = "cannot be read";
    FILE *f = fopen(path, "rb");
    size_t n = f ? fread(text, 1, sizeof text, f) : 0;
    IrMachine *m = ir_read(a, strings, text, n, &error);

    if (f)
        fclose(f);
    if (!m)
        fprintf(stderr, "%s: %s\n", path, error);
    return m;
}

static void hammer_images_of(Arena *a, IrMachine *const *m, size_t n, bool debug)
{
    Diags diags;
    Buf image;

    diags_init(&diags, a);
    buf_init(&image, a);
    CHECK(emit_image(a, &diags, m, n, NULL, debug, &image));
    mutate_image((const uint8_t *)image.at, (uint32_t)image.n);
    truncate_image((const uint8_t *)image.at, (uint32_t)image.n);
}

static void hammer_samples(void)
{
    IrMachine *m[SAMPLES];
    StrPool strings;
    jmp_buf oom;
    Arena a;

    arena_init(&a, heap_alloc, NULL, &oom);
    str_pool_init(&strings, &a);
    for (size_t i = 0; i < SAMPLES; i++) {
        m[i] = read(&a, &strings, sample[i]);
        CHECK(m[i] != NULL);
        if (!m[i])
            return;
        hammer_images_of(&a, &m[i], 1, false);
        hammer_images_of(&a, &m[i], 1, true);
    }
    hammer_images_of(&a, m, SAMPLES, true);           // four machines in one image
    arena_free(&a);
}

// Puts an instruction of each opcode with operands of every length, ordered so that the registers have numbers.
static void put_every(Build *b, unsigned f)
{
    static const uint32_t far[] = {1, 97, 0xc61};

    for (unsigned op = 0x80; op < 0x100; op++) {
        const uint32_t shape = smvm_shape((uint8_t)op);
        if (shape & SMVM_SHAPE_Y) {
            code(b, SMVM_ldx_plus, 1, op);
            code(b, SMVM_ldy_local + op % 12, 1, 0);
        } else if (shape & SMVM_SHAPE_X)
            typed(b, SMVM_ldx_elem, op % 11, 24);
        if (shape & SMVM_SHAPE_Z || op == SMVM_sample || shape == 0)
            continue;
        if (shape & SMVM_SHAPE_J)
            code(b, op, shape & SMVM_SHAPE_N ? 2 : 1, shape & SMVM_SHAPE_N ? far[(op + f) % 3] : 0, 0);
        else if (shape & SMVM_SHAPE_K)
            code(b, op, 2, f % 5, 0);
        else if (op == SMVM_fn)
            code(b, op, 1, f % 5);
        else if (shape & SMVM_SHAPE_E)
            code(b, op, 1, 32u >> smvm_type_shift(op & 0xf));
        else if (shape & SMVM_SHAPE_FOLLOWS)
            code(b, op, 1, shape & SMVM_SHAPE_N ? far[(op + f) % 3] : shape & (SMVM_SHAPE_F | SMVM_SHAPE_D) ? 0 : f % 2 + (op == SMVM_set));
        else
            code(b, op, 0);
        if (shape & SMVM_SHAPE_GX)
            code(b, SMVM_out, 1, op % 2);
        if (shape & SMVM_SHAPE_J)                     // a target
            code(b, SMVM_ldx_time, 0);
    }
}

// Hammers the image of a file.  It is signed with the key above if the name of the file contains "signed".
static void hammer_file(const char *path)
{
    static uint8_t image[4096];
    FILE *f = fopen(path, "rb");
    const uint32_t n = f ? (uint32_t)fread(image, 1, sizeof image, f) : 0;

    CHECK(n > 0 && n < sizeof image);
    if (f)
        fclose(f);
    CHECK(is_signed(image) == (strstr(path, "signed") != NULL));
    mutate_image(image, n);
    truncate_image(image, n);
}

static void hammer_every_opcode(void)
{
    static uint8_t image[8192];
    Build b;

    memset(&b, 0, sizeof b);
    b.sv_words = 6;
    b.from = 1;
    b.to = 5;
    b.g = 1;
    b.s = 4;
    b.locals = 16;
    b.windows = b.f32s = b.f64s = 1;
    b.outputs = b.states = 2;
    b.width = 3;
    b.window[0] = WINDOW(100, 31);
    b.f32[0] = 0xff800000;
    b.f64[0] = 1;
    b.output[0] = PLACE(F32, 20);
    b.output[1] = PLACE(I64, 24);
    code(&b, SMVM_ldx_local + SMVM_RAW, 1, 1);
    code(&b, SMVM_sample, 1, 0);
    code(&b, SMVM_end, 0);
    end_function(&b);
    for (unsigned f = 0; f < 6; f++) {
        if (f % 4 == 1)
            put_every(&b, f);
        code(&b, SMVM_ldx_time, 0);
        code(&b, SMVM_jt, 1, 1);
        code(&b, SMVM_end, 0);
        code(&b, f % 3 == 2 ? SMVM_end : SMVM_goto, f % 3 == 2 ? 0 : 1, 1 + f % 2);
        end_function(&b);
    }
    mutate_image(image, build_image(&b, image));
    truncate_image(image, build_image(&b, image));
}

int main(int argc, char **argv)
{
    if (argc > 1)
        steps = (uint32_t)strtoul(argv[1], NULL, 10);
    if (argc > 2)
        values = (uint32_t)strtoul(argv[2], NULL, 10);
    if (argc > 3 && strcmp(argv[3], "-") != 0)
        folder = argv[3];
    hammer_samples();
    hammer_every_opcode();
    for (int i = 4; i < argc; i++)
        hammer_file(argv[i]);
    CHECK(values < 24 || (accepted > 1000 && refused > accepted));
    fprintf(stderr, "%lu mutants refused, %lu ran\n", refused, accepted);
    return test_end("vm_mutate");
}
