// SPDX-License-Identifier: Apache-2.0
// smc sign: adds a number and an authentication code, made with a key, to an image.
#include <time.h>

#include "compiler/cli/key.h"
#include "compiler/device/sign.h"

// Reads the value of --number; false after a message.
static bool read_number(Cli *c, uint32_t *number)
{
    uint64_t n = 0;
    const char *word = c->value[OPT_NUMBER];

    while (*word >= '0' && *word <= '9' && n <= SIGN_NUMBER_MOST)
        n = n * 10 + (uint64_t)(*word++ - '0');
    *number = (uint32_t)n;
    if (*word == '\0' && n >= 1 && n <= SIGN_NUMBER_MOST)
        return true;
    cli_usage_error(c, TEXT_number_range, (unsigned long)SIGN_NUMBER_MOST, c->value[OPT_NUMBER]);
    return false;
}

int cmd_sign(Cli *c)
{
    uint8_t key[SMVM_KEY], *bytes;
    OsOutput out = {NULL, NULL, 0};
    SmvmVerdict v;
    Source *image;
    uint32_t number;
    int code;

    if (c->files != 1 || !c->given[OPT_KEY])
        return cli_usage_error(c, TEXT_sign_what);
    if (c->given[OPT_NUMBER] && !read_number(c, &number))
        return EXIT_USAGE;
    if (!c->given[OPT_NUMBER] && (number = sign_number_at((int64_t)time(NULL))) == 0)
        return cli_print_error(c, TEXT_clock_wrong), EXIT_ENVIRONMENT;
    if ((code = cli_load_image(c, c->file[0], &image, &v)) != EXIT_OK || (code = key_load(c, key)) != EXIT_OK)
        return code;
    bytes = arena_alloc(&c->session.arena, image->len + SIGN_ROOM);
    out.path = c->given[OPT_OUTPUT] ? c->value[OPT_OUTPUT] : c->file[0];
    out.bytes = (const char *)bytes;
    out.n = image_sign((const uint8_t *)image->text, (uint32_t)image->len, key, number, bytes);
    if (out.n == 0)
        return cli_print_error(c, TEXT_too_many_sections, image->name), EXIT_PROBLEM;
    return !c->given[OPT_OUTPUT] || os_same_file(out.path, c->file[0]) ? cli_write_edited(c, &out) : cli_write_outputs(c, &out, 1);
}
