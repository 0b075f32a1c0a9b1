// SPDX-License-Identifier: Apache-2.0
// smc set: shows the parameters of an image, or writes an image in which some have other values.
#include <string.h>

#include "bytecode-vm/auth.h"
#include "compiler/cli/image_parameters.h"
#include "compiler/cli/key.h"

int cmd_set(Cli *c)
{
    OsOutput out = {NULL, NULL, 0};
    bool good = true;
    SmvmVerdict v;
    SmvmAuth a;
    Source *image;
    uint8_t *bytes;
    Buf list;
    int code;

    if (c->files == 0 || (c->files > 1) != c->given[OPT_OUTPUT])
        return cli_usage_error(c, TEXT_set_what);
    if ((code = cli_load_image(c, c->file[0], &image, &v)) != EXIT_OK)
        return code;
    if (c->files == 1) {
        buf_init(&list, &c->session.arena);
        parameters_list(c, (SmvmBytes)image->text, &list);
        return cli_print(c, 1, &list) ? EXIT_OK : EXIT_ENVIRONMENT;
    }
    if (smvm_auth_read((SmvmBytes)image->text, &a))
        return cli_print_error(c, TEXT_set_signed, image->name), EXIT_PROBLEM;
    bytes = arena_alloc(&c->session.arena, image->len);
    memcpy(bytes, image->text, image->len);
    for (size_t i = 1; i < c->files; i++)
        good = parameters_set(c, bytes, c->file[i]) && good;
    out = (OsOutput){c->value[OPT_OUTPUT], (const char *)bytes, image->len};
    if (!good)
        return EXIT_PROBLEM;
    return cli_write_outputs(c, &out, 1);
}
