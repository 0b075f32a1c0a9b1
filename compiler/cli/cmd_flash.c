// SPDX-License-Identifier: Apache-2.0
// smc flash: sends an image to a board over a serial line. The previous image stays selected until the board has received and verified
// the whole new one.
#include <stdlib.h>
#include <string.h>

#include "compiler/cli/board_flash.h"
#include "compiler/cli/key.h"

// Reads the value of --period, "20" or "20ms", in milliseconds; 0 if it is absent. Returns false for any other value.
static bool read_period(Cli *c, uint16_t *period)
{
    const char *word = c->given[OPT_PERIOD] ? c->value[OPT_PERIOD] : NULL;
    unsigned long n;
    char *end;

    *period = 0;
    if (!word)
        return true;
    n = strtoul(word, &end, 10);
    *period = (uint16_t)n;
    return word[0] >= '0' && word[0] <= '9' && n >= 1 && n <= UINT16_MAX && (!*end || strcmp(end, "ms") == 0);
}

int cmd_flash(Cli *c)
{
    uint8_t key[SMVM_KEY];
    uint16_t period;
    BoardLine b;
    FlashImage image;
    Source *file;
    SmvmVerdict v;
    int code;

    if (c->files != 1)
        return cli_usage_error(c, TEXT_flash_what);
    if (has_suffix(c->file[0], ".sm"))
        return cli_usage_error(c, TEXT_flash_source, c->file[0]);
    if (!read_period(c, &period))
        return cli_usage_error(c, TEXT_period_number, c->value[OPT_PERIOD]);
    if ((code = cli_load_image(c, c->file[0], &file, &v)) != EXIT_OK)
        return code;
    // A board reports which key it has. But it detects a modified image only after receiving all of it; a board with one slot has then lost
    // its previous image. So --key checks the signature here.
    if (c->given[OPT_KEY] && (code = key_load(c, key)) != EXIT_OK)
        return code;
    if (c->given[OPT_KEY] && !key_check_signature(c, file, key, "; nothing was sent"))
        return EXIT_PROBLEM;
    if ((code = board_open(c, &b)) != EXIT_OK)
        return code;
    if (b.is_application) {
        cli_print_error(c, TEXT_flash_application, c->value[OPT_PORT], c->file[0], c->value[OPT_PORT]);
        board_close(&b);
        return EXIT_PROBLEM;
    }
    image = (FlashImage){(const uint8_t *)file->text, (uint32_t)file->len, v.longest, period};
    code = board_flash(&b, file->name, &image);
    board_close(&b);
    return code;
}
