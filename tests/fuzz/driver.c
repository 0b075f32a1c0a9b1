// SPDX-License-Identifier: Apache-2.0
// Runs a fuzz target without a fuzzer: on each file given, then on N inputs made from these by small random changes.
//
//     TARGET [-n N] [-s SEED] [-o FILE] FILE…
//
// The FILE of -o receives each input before it is tried, so that after a crash it contains the input that caused it.  The same seed produces the
// same inputs.  Each FILE is one test, together with all inputs derived from it.  The last test is that enough inputs were accepted
// (fuzz_floor).
#include <stdbool.h>
#include <string.h>

#include "tests/fuzz/fuzz.h"

enum { LARGEST = 1 << 20, CORPUS_MOST = 4096 };

typedef struct Input { uint8_t *at; size_t n; } Input;

static Input corpus[CORPUS_MOST];
static size_t inputs;
static uint64_t state = 88172645463325252u;

static uint64_t next_random(void)
{
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return state;
}

static size_t below(size_t n) { return n ? (size_t)(next_random() % n) : 0; }

static void add_file(const char *path)
{
    FILE *f = fopen(path, "rb");
    Input in = {malloc(LARGEST), 0};

    if (!f || !in.at || inputs == CORPUS_MOST) {
        fprintf(stderr, "cannot take %s\n", path);
        exit(3);
    }
    in.n = fread(in.at, 1, LARGEST, f);
    fclose(f);
    corpus[inputs++] = in;
}

// ---- changes ----

static void change_byte(Input *x)
{
    if (x->n)
        x->at[below(x->n)] = (uint8_t)next_random();
}

static void flip_bit(Input *x)
{
    if (x->n)
        x->at[below(x->n)] ^= (uint8_t)(1u << below(8));
}

static void cut(Input *x)
{
    size_t from = below(x->n + 1), n = below(x->n - from + 1) % 64;

    memmove(x->at + from, x->at + from + n, x->n - from - n);
    x->n -= n;
}

// Inserts a part of a random input.
static void splice(Input *x)
{
    const Input *other = &corpus[below(inputs)];
    size_t from = below(other->n + 1), n = below(other->n - from + 1) % 256, to = below(x->n + 1);

    if (x->n + n > LARGEST)
        return;
    memmove(x->at + to + n, x->at + to, x->n - to);
    memcpy(x->at + to, other->at + from, n);
    x->n += n;
}

static int is_digit(uint8_t c) { return c >= '0' && c <= '9'; }

// Replaces a digit: most faults of sources are in their numbers.
static void change_digit(Input *x)
{
    for (size_t at = below(x->n + 1); at < x->n; at++)
        if (is_digit(x->at[at])) {
            x->at[at] = (uint8_t)('0' + below(10));
            return;
        }
}

// Overwrites a part of the input by a copy of another part, of at most 127 bytes.
static void repeat_piece(Input *x)
{
    size_t from = below(x->n + 1), n = below(x->n - from + 1) % 128, to = below(x->n + 1);

    if (n == 0 || to + n > x->n)
        return;
    memmove(x->at + to, x->at + from, n);
}

static void change(Input *x)
{
    static void (*const how[])(Input *) = {change_byte, flip_bit, cut, splice, change_digit, change_digit, repeat_piece};

    for (size_t times = 1 + below(1 + below(5)); times > 0; times--)       // often only one change: more of these inputs are accepted
        how[below(sizeof how / sizeof how[0])](x);
}

// ---- running ----

static void keep(const char *path, const Input *x)
{
    FILE *f = path ? fopen(path, "wb") : NULL;

    if (!f)
        return;
    fwrite(x->at, 1, x->n, f);
    fclose(f);
}

static void try(const Input *x, const char *crash_file)
{
    uint8_t *copy = malloc(x->n ? x->n : 1);                  // a separate block, so that a sanitizer notices a read beyond it

    if (!copy)
        exit(3);
    memcpy(copy, x->at, x->n);
    keep(crash_file, x);
    LLVMFuzzerTestOneInput(copy, x->n);
    free(copy);
}

static void try_changed(const char *crash_file)
{
    const Input *from = &corpus[below(inputs)];
    static uint8_t space[LARGEST];
    Input x = {space, from->n};

    memcpy(x.at, from->at, from->n);
    change(&x);
    try(&x, crash_file);
}

int main(int argc, char **argv)
{
    unsigned long runs = 0, tried;
    bool enough;
    const char *crash_file = NULL;

    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "-n") == 0 && i + 1 < argc)
            runs = strtoul(argv[++i], NULL, 10);
        else if (strcmp(argv[i], "-s") == 0 && i + 1 < argc)
            state ^= strtoul(argv[++i], NULL, 10) * 0x9e3779b97f4a7c15u;
        else if (strcmp(argv[i], "-o") == 0 && i + 1 < argc)
            crash_file = argv[++i];
        else
            add_file(argv[i]);
    }
    for (size_t i = 0; i < inputs; i++)
        try(&corpus[i], crash_file);
    for (unsigned long i = 0; inputs && i < runs; i++)
        try_changed(crash_file);
    tried = (unsigned long)inputs + (inputs ? runs : 0);
    enough = tried > 0 && fuzz_reached * 100 >= fuzz_floor * tried;
    printf("%s: %lu inputs, %lu of them accepted; %u of 100 must be\n", argv[0], tried, fuzz_reached, fuzz_floor);
    printf("%lu passed, %d failed\n", (unsigned long)inputs * (runs ? 2 : 1) + enough, !enough);
    for (size_t i = 0; i < inputs; i++)
        free(corpus[i].at);
    return !enough;
}
