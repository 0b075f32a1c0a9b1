// SPDX-License-Identifier: Apache-2.0
// smc key, and reading key files: a key file is a line of 32 hexadecimal digits.
#include "compiler/cli/key.h"

#include <string.h>

enum { DIGITS = 2 * SMVM_KEY };

static const char digit[] = "0123456789abcdef";

static bool is_hex_digit(char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); }

// Whether a file with these bytes is a key: 32 hexadecimal digits and line ends.
bool key_is_file(const char *text, size_t n)
{
    size_t i = 0;

    while (i < n && i < DIGITS && is_hex_digit(text[i]))
        i++;
    if (i < DIGITS)
        return false;
    while (i < n && (text[i] == '\r' || text[i] == '\n'))
        i++;
    return i == n;
}

// Returns the value of a hexadecimal digit.
static uint8_t digit_value(char c)
{
    return (uint8_t)(c <= '9' ? c - '0' : (c | 0x20) - 'a' + 10);
}

// Reads the key that --key names.  Returns EXIT_OK, or the exit code after a message.  Warns of a file that other users can read.
int key_load(Cli *c, uint8_t key[SMVM_KEY])
{
    const char *const path = c->value[OPT_KEY];
    const Source *const s = cli_read_source(c, path);

    if (!s)
        return EXIT_ENVIRONMENT;
    if (!key_is_file(s->text, s->len)) {
        cli_print_error(c, TEXT_not_a_key, path, DIGITS);
        return EXIT_PROBLEM;
    }
    if (!os_is_private(path))
        cli_print_warning(c, TEXT_key_readable, path, path);
    for (unsigned i = 0; i < SMVM_KEY; i++)
        key[i] = (uint8_t)(digit_value(s->text[2 * i]) << 4 | digit_value(s->text[2 * i + 1]));
    return EXIT_OK;
}

// Checks that an image is signed with the loaded key; if not, prints the reason followed by `then` and returns false.
bool key_check_signature(Cli *c, const Source *image, const uint8_t *key, const char *then)
{
    const uint32_t mark = smvm_auth_mark(key);
    SmvmAuth a;
    uint32_t number;

    if (smvm_auth_check((SmvmBytes)image->text, key, &number))
        return true;
    if (!smvm_auth_read((SmvmBytes)image->text, &a))
        cli_print_error(c, TEXT_not_signed, image->name, then);
    else if (a.mark != mark)
        cli_print_error(c, TEXT_signed_with_other, image->name, (unsigned long)a.mark, c->value[OPT_KEY], (unsigned long)mark, then);
    else
        cli_print_error(c, TEXT_changed_since_signed, image->name, c->value[OPT_KEY], then);
    return false;
}

int cmd_key(Cli *c)
{
    const char *why;
    uint8_t key[SMVM_KEY];
    char text[DIGITS + 1];
    Buf out;

    if (c->files != 1 || strcmp(c->file[0], "-") == 0)
        return cli_usage_error(c, TEXT_key_what);
    if (outputs_is_source_name(c->file[0], strlen(c->file[0])))
        return cli_usage_error(c, TEXT_key_is_source, c->file[0]);
    if (!os_get_random_bytes(key, sizeof key, &why))
        return cli_print_error(c, TEXT_cannot_make_key, why), EXIT_ENVIRONMENT;
    for (unsigned i = 0; i < SMVM_KEY; i++) {
        text[2 * i] = digit[key[i] >> 4];
        text[2 * i + 1] = digit[key[i] & 15];
    }
    text[DIGITS] = '\n';
    if (!os_write_private(c->file[0], text, sizeof text, &why)) {
        cli_print_error(c, TEXT_cannot_create, cli_printable_name(&c->session.arena, c->file[0]), why);
        return EXIT_ENVIRONMENT;
    }
    buf_init(&out, &c->session.arena);
    buf_printf(&out, "%s: key %08lx\n", c->file[0], (unsigned long)smvm_auth_mark(key));       // as boards and images report it
    return cli_print(c, 1, &out) ? EXIT_OK : EXIT_ENVIRONMENT;
}
