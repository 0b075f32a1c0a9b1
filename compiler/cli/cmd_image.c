// SPDX-License-Identifier: Apache-2.0
// smc disasm and smc verify: images inspected with the device's own code.
#include "bytecode-vm/smvm.h"
#include "compiler/cli/cli.h"

static void put_text(void *context, const char *text, size_t length)
{
    buf_put(context, text, length);
}

int cli_load_image(Cli *c, const char *path, Source **image, SmvmVerdict *v)
{
    if ((*image = cli_load(c, path)) == NULL)
        return EXIT_ENVIRONMENT;
    if (smvm_verify((SmvmBytes)(*image)->text, (*image)->len, v) == 0)
        return EXIT_OK;
    cli_say(c, "%s: refused by rule %u at byte %lu: %s", (*image)->name, (unsigned)v->rule, (unsigned long)v->at,
            smvm_rule_text(v->rule));
    return EXIT_PROBLEM;
}

int cmd_disasm(Cli *c)
{
    Buf out;

    if (c->files == 0)
        return cli_usage(c, "disasm wants an image, as in 'smc disasm tank.smb'");
    buf_init(&out, &c->session.arena);
    for (size_t i = 0; i < c->files; i++) {
        Source *image;
        SmvmVerdict v;
        int code = cli_load_image(c, c->file[i], &image, &v);
        if (code != EXIT_OK)
            return code;
        smvm_disasm((SmvmBytes)image->text, put_text, &out);
    }
    return cli_print(c, 1, &out) ? EXIT_OK : EXIT_ENVIRONMENT;
}

static void describe(const char *name, const Source *image, Buf *out)
{
    SmvmMachine m;

    for (uint32_t i = 0; smvm_machine((SmvmBytes)image->text, i, &m); i++)
        buf_printf(out, "%s: machine %lu: %lu states, longest step %lu instructions, %lu bytes of RAM, state vector %lu bytes (layout %08lx)\n",
                   name, (unsigned long)(i + 1), (unsigned long)m.states, (unsigned long)smvm_longest_step(&m),
                   (unsigned long)smvm_ram_size(&m), (unsigned long)m.sv_size, (unsigned long)m.layout);
}

int cmd_verify(Cli *c)
{
    int worst = EXIT_OK;
    Buf out;

    if (c->files == 0)
        return cli_usage(c, "verify wants an image, as in 'smc verify tank.smb'");
    buf_init(&out, &c->session.arena);
    for (size_t i = 0; i < c->files; i++) {
        Source *image;
        SmvmVerdict v;
        int code = cli_load_image(c, c->file[i], &image, &v);
        if (code == EXIT_OK)
            describe(image->name, image, &out);
        worst = code > worst ? code : worst;
    }
    if (!cli_print(c, 1, &out))
        return EXIT_ENVIRONMENT;
    return worst;
}
