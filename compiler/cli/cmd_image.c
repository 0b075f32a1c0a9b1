// SPDX-License-Identifier: Apache-2.0
// smc disasm and smc verify: inspect images with the device's own code.
#include "bytecode-vm/image.h"
#include "bytecode-vm/smvm.h"
#include "compiler/cli/key.h"

// Called by the disassembler: appends `text` to a Buf.
static void append_text(void *context, const char *text, size_t length)
{
    buf_put(context, text, length);
}

// Returns what to do about a refused image; NULL if only its creator can know.
static const char *advice_for_rule(uint8_t rule)
{
    switch (rule) {
    case SMVM_R_MAGIC: return "it is no image; 'smc build' makes one of a machine";
    case SMVM_R_FORMAT: return "it was made by another version of smc: build it again with this one, from its sources";
    case SMVM_R_LENGTH: case SMVM_R_CRC: return "it is damaged, or not all of it is there: copy it again, or build it again from its sources";
    default: return NULL;
    }
}

// Reads an image and runs the device's own verifier on it.  Returns EXIT_OK, or the exit code after a message.
int cli_load_image(Cli *c, const char *path, Source **image, SmvmVerdict *v)
{
    uint32_t length;

    if ((*image = cli_read_source(c, path)) == NULL)
        return EXIT_ENVIRONMENT;
    if (smvm_verify((SmvmBytes)(*image)->text, (*image)->len, v) != 0) {
        cli_print_error(c, TEXT_image_rule, (*image)->name, (unsigned)v->rule, (unsigned long)v->at, smvm_rule_text(v->rule));
        if (advice_for_rule(v->rule))
            cli_print_note(c, TEXT_sentence, advice_for_rule(v->rule));
        return EXIT_PROBLEM;
    }
    length = smvm_uint((SmvmBytes)(*image)->text, SMVM_LENGTH_AT, 3);
    if (length == (*image)->len)
        return EXIT_OK;
    // The verifier accepts bytes after an image, because a board stores images in larger slots. A file must not contain any.
    cli_print_error(c, TEXT_image_length, (*image)->name, (unsigned long)length, (unsigned long)(*image)->len);
    cli_print_note(c, TEXT_image_extra);
    return EXIT_PROBLEM;
}

int cmd_disasm(Cli *c)
{
    Buf out;

    if (c->files == 0)
        return cli_usage_error(c, TEXT_disasm_what);
    buf_init(&out, &c->session.arena);
    for (size_t i = 0; i < c->files; i++) {
        Source *image;
        SmvmVerdict v;
        int code = cli_load_image(c, c->file[i], &image, &v);
        if (code != EXIT_OK)
            return code;
        smvm_disasm((SmvmBytes)image->text, append_text, &out);
    }
    return cli_print(c, 1, &out) ? EXIT_OK : EXIT_ENVIRONMENT;
}

// Writes a pin in words.  Bits of p->kind: 1 output, 2 digital.  Bits of p->flags: 2 @pull_up, 4 @pull_down.
void cli_write_pin(Buf *out, const SmvmPin *p)
{
    buf_printf(out, "%s %s %lu%s", p->kind & 2 ? "digital" : "analog", p->kind & 1 ? "output" : "input", (unsigned long)p->pin,
               p->flags & 4 ? " with @pull_down" : p->flags & 2 ? " with @pull_up" : "");
}

// Describes the machines and the pins of an image.
static void describe_image(const char *name, const Source *image, Buf *out)
{
    SmvmMachine m;
    SmvmPins all;
    SmvmPin p;
    const char *between = ": pins: ";

    for (uint32_t i = 0; smvm_machine((SmvmBytes)image->text, i, &m); i++)
        buf_printf(out, "%s: machine %lu: %lu state%s%s, longest step %lu instructions, %lu bytes of RAM on a 64-bit computer, state vector %lu bytes (layout %08lx)\n",
                   name, (unsigned long)(i + 1), (unsigned long)m.states, m.states == 1 ? "" : "s",
                   smvm_state_is_safe(&m, 1) ? "" : ", the first not marked @safe", (unsigned long)smvm_longest_step(&m),
                   (unsigned long)smvm_ram_size_64(&m), (unsigned long)m.sv_size, (unsigned long)m.layout);
    if (!smvm_pins((SmvmBytes)image->text, &all) || all.left == 0)
        return;
    buf_str(out, name);
    for (; smvm_next_pin(&all, &p); between = ", ") {
        buf_str(out, between);
        cli_write_pin(out, &p);
    }
    buf_str(out, "\n");
}

// Writes with which key an image is signed, if it is signed.  With a key, first checks that it is signed with that key; returns EXIT_PROBLEM after a
// message if not.
static int describe_code(Cli *c, const Source *image, const uint8_t *key, Buf *out)
{
    SmvmAuth a;

    if (key && !key_check_signature(c, image, key, ""))
        return EXIT_PROBLEM;
    if (smvm_auth_read((SmvmBytes)image->text, &a))
        buf_printf(out, "%s: signed with %skey %08lx, number %lu\n", image->name, key ? "this " : "", (unsigned long)a.mark, (unsigned long)a.number);
    return EXIT_OK;
}

int cmd_verify(Cli *c)
{
    int worst = EXIT_OK;
    uint8_t key[SMVM_KEY];
    Buf out;

    if (c->files == 0)
        return cli_usage_error(c, TEXT_verify_what);
    if (c->given[OPT_KEY] && (worst = key_load(c, key)) != EXIT_OK)
        return worst;
    buf_init(&out, &c->session.arena);
    for (size_t i = 0; i < c->files; i++) {
        Source *image;
        SmvmVerdict v;
        int code = cli_load_image(c, c->file[i], &image, &v);
        if (code == EXIT_OK)
            describe_image(image->name, image, &out);
        if (code == EXIT_OK)
            code = describe_code(c, image, c->given[OPT_KEY] ? key : NULL, &out);
        worst = code > worst ? code : worst;
    }
    if (!cli_print(c, 1, &out))
        return EXIT_ENVIRONMENT;
    return worst;
}
