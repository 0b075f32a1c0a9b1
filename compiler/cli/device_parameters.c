// SPDX-License-Identifier: Apache-2.0
// Values of parameters are part of an image.  So the host reads the image back that the board runs, changes values in it as `smc set` does, and
// sends it as a new image: what is promised of an update (docs/link.md) is also promised of a setting.
#include "compiler/cli/device_parameters.h"

#include <string.h>
#include <time.h>

#include "compiler/cli/board_flash.h"
#include "compiler/cli/image_parameters.h"
#include "compiler/cli/key.h"
#include "compiler/cli/setting.h"
#include "compiler/device/sign.h"

#define IMAGE_NAME "the image with these values"

// An image of the board, as its bytes on the host.
typedef struct ReadImage { DeviceImage at; uint8_t *bytes; uint32_t longest; } ReadImage;

// Reads back the image that runs, and verifies it.
static int read_running_image(BoardLine *b, ReadImage *image)
{
    SmvmVerdict v;

    if (!device_find_running_image(&b->host, &b->info, &image->at))
        return board_report_failure(b, "asking what runs");
    if (!image->at.runs || image->at.state == DEVICE_EMPTY)
        return cli_print_error(b->c, TEXT_nothing_runs), EXIT_PROBLEM;
    image->bytes = arena_alloc(&b->c->session.arena, image->at.length);
    if (!device_read_image(&b->host, &b->info, &image->at, image->bytes))
        return board_report_failure(b, "reading the image that runs");
    if (smvm_verify(image->bytes, image->at.length, &v) != 0)
        return cli_print_error(b->c, TEXT_image_not_readable, (unsigned)v.rule, (unsigned long)v.at, smvm_rule_text(v.rule)), EXIT_PROBLEM;
    image->longest = v.longest;
    return EXIT_OK;
}

int device_show_parameters(BoardLine *b, Buf *out)
{
    ReadImage image;
    const int code = read_running_image(b, &image);

    if (code != EXIT_OK)
        return code;
    board_describe(out, &image.at);
    parameters_list(b->c, image.bytes, out);
    return EXIT_OK;
}

// ---- setting ----

// Whether the arguments after `set` have the form NAME=VALUE. Returns false after a message.
bool device_check_settings(Cli *c)
{
    Setting s;

    for (size_t i = 1; i < c->files; i++)
        if (!setting_parse(c, c->file[i], &s))
            return false;
    if (c->files < 2)
        cli_usage_error(c, TEXT_device_set_what);
    return c->files >= 2;
}

// Signs the image, whose signature does not fit its new values, with --key and a number that the board accepts.
static int sign_again(BoardLine *b, ReadImage *image)
{
    const uint32_t now = sign_number_at((int64_t)time(NULL)), number = now > b->info.newest ? now : b->info.newest + 1;
    uint8_t key[SMVM_KEY], *const bytes = arena_alloc(&b->c->session.arena, image->at.length + SIGN_ROOM);
    int code;

    if (!b->c->given[OPT_KEY])
        return cli_print_error(b->c, TEXT_device_set_key), EXIT_PROBLEM;
    if ((code = key_load(b->c, key)) != EXIT_OK)
        return code;
    if (b->info.reports_mark && b->info.requires_signature && smvm_auth_mark(key) != b->info.mark)
        return cli_print_error(b->c, TEXT_device_other_key, b->c->value[OPT_KEY], (unsigned long)smvm_auth_mark(key), (unsigned long)b->info.mark),
               EXIT_PROBLEM;
    if (number > SIGN_NUMBER_MOST)
        return cli_print_error(b->c, TEXT_device_set_number, (unsigned long)b->info.newest), EXIT_PROBLEM;
    image->at.length = image_sign(image->bytes, image->at.length, key, number, bytes);
    if (image->at.length == 0)
        return cli_print_error(b->c, TEXT_too_many_sections, IMAGE_NAME), EXIT_PROBLEM;
    image->bytes = bytes;
    return EXIT_OK;
}

// Changes the values in the image.  Returns false after a message for each value that is refused.
static bool set_values(Cli *c, uint8_t *bytes)
{
    bool good = true;

    for (size_t i = 1; i < c->files; i++)
        good = parameters_set(c, bytes, c->file[i]) && good;
    if (!good)
        cli_print_note(c, TEXT_nothing_was_sent);
    return good;
}

int device_set_parameters(BoardLine *b, Buf *out)
{
    Cli *const c = b->c;
    ReadImage image;
    SmvmAuth auth;
    FlashImage send;
    uint64_t before;
    int code = read_running_image(b, &image);

    if (code != EXIT_OK)
        return code;
    before = smvm_settings_identity(image.bytes);
    if (!set_values(c, image.bytes))
        return EXIT_PROBLEM;
    parameters_list(c, image.bytes, out);
    if (smvm_settings_identity(image.bytes) == before) {
        cli_print_note(c, TEXT_same_settings);
        return EXIT_OK;
    }
    if ((b->info.requires_signature || smvm_auth_read(image.bytes, &auth)) && (code = sign_again(b, &image)) != EXIT_OK)
        return code;
    send = (FlashImage){image.bytes, image.at.length, image.longest, image.at.period};
    return board_flash(b, IMAGE_NAME, &send);
}
