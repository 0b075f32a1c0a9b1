// SPDX-License-Identifier: Apache-2.0
// Each byte of varied images is changed to other values, with the checksum made right again: the result is refused, or it runs
// without leaving its memory.  Each image is also cut at every length.
//
//     vm_mutate [STEPS [VALUES [FOLDER]]]     steps of each accepted mutant; how many values a byte gets (256: all); where
//                                             to write the images, as seeds for fuzzing
//
// To be run under sanitizers (make check-mutate); without them little is seen.
#include "tests/unit/vm_hammer.h"

#include <stdio.h>

#include "compiler/emit/bytecode/bytecode.h"
#include "tests/test.h"

static uint32_t steps = 20, values = 24;
static const char *folder;
static unsigned long accepted, refused;

static void *host(void *context, void *old, size_t size)
{
    (void)context;
    if (size)
        return realloc(old, size);
    free(old);
    return NULL;
}

static void try(const uint8_t *image, uint32_t n, uint64_t seed)
{
    if (hammer(image, n, steps, seed) == 0)
        accepted++;
    else
        refused++;
}

static void keep(const uint8_t *image, uint32_t n)
{
    static unsigned number;
    char path[300];
    FILE *f;

    snprintf(path, sizeof path, "%s/%u.smb", folder, number++);
    f = fopen(path, "wb");
    CHECK(f && fwrite(image, 1, n, f) == n && fclose(f) == 0);
}

static void mutate(const uint8_t *image, uint32_t n)
{
    uint8_t *copy = malloc(n);                        // exactly as long: a read beyond it is seen

    if (folder)
        keep(image, n);
    memcpy(copy, image, n);
    CHECK(hammer(copy, n, 1000, 1) == 0);
    for (uint32_t at = 0; at < n; at++) {
        for (uint32_t k = 1; k <= values; k++) {
            uint64_t seed = (uint64_t)at << 20 | k << 1 | 1;
            copy[at] = (uint8_t)(image[at] + (values > 255 ? k : k < 9 ? 1u << (k - 1) : (uint32_t)(hammer_random(&seed) >> 16)));
            if (at < 8 || at > 10)                    // (not where a wrong length would make the checksum read beyond)
                fix_crc(copy);
            try(copy, n, seed);
        }
        memcpy(copy, image, n);
    }
    free(copy);
}

static void cut(const uint8_t *image, uint32_t n)
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
            try(copy, i, 1);
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
    mutate((const uint8_t *)image.at, (uint32_t)image.n);
    cut((const uint8_t *)image.at, (uint32_t)image.n);
}

static void samples(void)
{
    IrMachine *m[SAMPLES];
    StrPool strings;
    jmp_buf oom;
    Arena a;

    arena_init(&a, host, NULL, &oom);
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

// By hand: entries of three bytes, every opcode, numbers of every length.
static void every_opcode(void)
{
    static uint8_t image[4096];
    const uint32_t operand[] = {ELEMENT(F32, 16), ELEMENT(I64, 24), ELEMENT(U64, 0), ELEMENT(U32, 8), LOCAL(I8, 1), LOCAL(F64, 8), OPERAND(22, 0),
                                OPERAND(23, 0), OPERAND(24, 0x40000), OPERAND(25, 0), OPERAND(26, 0), OPERAND(27, 11), OPERAND(27, SM_I16)};
    Build b;

    memset(&b, 0, sizeof b);
    b.sv_words = 4;
    b.locals = 16;
    b.temps = b.windows = b.f32s = b.f64s = 1;
    b.outputs = b.states = 2;
    b.width = 3;
    b.window[0] = WINDOW(100, 31);
    b.f32[0] = 0xff800000;
    b.f64[0] = 1;
    b.operands = 13;
    memcpy(b.operand, operand, sizeof operand);
    code(&b, SMVM_sample, 2, 0, 5);
    code(&b, SMVM_end, 0);
    end_function(&b);
    for (unsigned f = 0; f < 6; f++) {
        for (unsigned op = 0x80; op < 0x100; op++) {
            uint8_t shape = smvm_shape((uint8_t)op);
            if (shape == (SMVM_SHAPE_D | SMVM_SHAPE_X))
                code(&b, op, 2, (op + f) % 2, op % 11);
            else if (shape == (SMVM_SHAPE_D | SMVM_SHAPE_X | SMVM_SHAPE_Y))
                code(&b, op, 3, 4 + (op + f) % 3, op % 11, (op + 5) % 11);
            else if (shape == (SMVM_SHAPE_D | SMVM_SHAPE_W))
                code(&b, op, 2, 5 + f % 2, 0);
            else if (shape == (SMVM_SHAPE_X | SMVM_SHAPE_J))
                code(&b, op, 2, (op + f) % 11, 0);
            else if (shape == (SMVM_SHAPE_X | SMVM_SHAPE_Y | SMVM_SHAPE_J))
                code(&b, op, 3, (op + f) % 11, op % 7, 0);
        }
        code(&b, SMVM_add, 3, 11, 4, 5);
        code(&b, SMVM_mul, 3, 12, 11, 11);
        code(&b, SMVM_jnlt, 3, 12, 5, 0);
        code(&b, SMVM_jt, 2, 4, 1);
        code(&b, SMVM_end, 0);
        code(&b, f % 3 == 2 ? SMVM_end : SMVM_goto, f % 3 == 2 ? 0 : 1, 1 + f % 2);
        end_function(&b);
    }
    mutate(image, build_image(&b, image));
    cut(image, build_image(&b, image));
}

int main(int argc, char **argv)
{
    if (argc > 1)
        steps = (uint32_t)strtoul(argv[1], NULL, 10);
    if (argc > 2)
        values = (uint32_t)strtoul(argv[2], NULL, 10);
    if (argc > 3)
        folder = argv[3];
    samples();
    every_opcode();
    CHECK(values < 24 || (accepted > 1000 && refused > accepted));
    fprintf(stderr, "%lu mutants refused, %lu ran\n", refused, accepted);
    return test_end("vm_mutate");
}
