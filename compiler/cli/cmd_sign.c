// SPDX-License-Identifier: Apache-2.0
// smc sign: adds a number and an authentication code, made with a key, to an image.
#include <time.h>

#include "compiler/cli/key.h"
#include "compiler/device/sign.h"

// Numbers count seconds from the start of 2020. Numbers above MOST are refused, so that no mistake uses up those that a board can still
// accept.
enum { YEAR_2020 = 1577836800 };
#define MOST 4000000000u

// Time increases on every computer that signs, so it serves as the default number.
static bool number_from_clock(Cli *c, uint32_t *number)
{
    const int64_t seconds = (int64_t)time(NULL) - YEAR_2020;

    *number = (uint32_t)seconds;
    if (seconds >= 1 && seconds <= MOST)
        return true;
    cli_print_error(c, TEXT_clock_wrong);
    return false;
}

static bool number_from_option(Cli *c, uint32_t *number)
{
    uint64_t n = 0;
    const char *word = c->value[OPT_NUMBER];

    while (*word >= '0' && *word <= '9' && n <= MOST)
        n = n * 10 + (uint64_t)(*word++ - '0');
    *number = (uint32_t)n;
    if (*word == '\0' && n >= 1 && n <= MOST)
        return true;
    cli_usage_error(c, TEXT_number_range, (unsigned long)MOST, c->value[OPT_NUMBER]);
    return false;
}

static int sign_image(Cli *c, const Source *image, const uint8_t *key, uint32_t number)
{
    OsOutput out = {c->given[OPT_OUTPUT] ? c->value[OPT_OUTPUT] : c->file[0], NULL, 0};
    uint8_t *const bytes = arena_alloc(&c->session.arena, image->len + SIGN_ROOM);

    out.bytes = bytes;
    out.n = image_sign((const uint8_t *)image->text, (uint32_t)image->len, key, number, bytes);
    if (out.n == 0)
        return cli_print_error(c, TEXT_too_many_sections, image->name), EXIT_PROBLEM;
    return !c->given[OPT_OUTPUT] || os_same_file(out.path, c->file[0]) ? cli_write_edited(c, &out) : cli_write_outputs(c, &out, 1);
}

int cmd_sign(Cli *c)
{
    uint8_t key[SMVM_KEY];
    SmvmVerdict v;
    Source *image;
    uint32_t number;
    int code;

    if (c->files != 1 || !c->given[OPT_KEY])
        return cli_usage_error(c, TEXT_sign_what);
    if (c->given[OPT_NUMBER] && !number_from_option(c, &number))
        return EXIT_USAGE;
    if (!c->given[OPT_NUMBER] && !number_from_clock(c, &number))
        return EXIT_ENVIRONMENT;
    if ((code = cli_load_image(c, c->file[0], &image, &v)) != EXIT_OK || (code = key_load(c, key)) != EXIT_OK)
        return code;
    return sign_image(c, image, key, number);
}
