// SPDX-License-Identifier: Apache-2.0
// An image as a C constant, for programs without files, such as Arduino sketches.
#include <string.h>

#include "compiler/emit/c/emit_c.h"
#include "compiler/emit/c/unit.h"

void emit_c_bytes(const Buf *image, Buf *out)
{
    const unsigned char *at = (const unsigned char *)image->at;

    for (size_t i = 0; i < image->n; i++)
        buf_printf(out, "%s0x%02x,", i % 16 == 0 ? "\n    " : " ", at[i]);
}

void emit_c_image(Arena *arena, const char *name, const Buf *image, const EmitCOptions *o, Buf *out)
{
    const char *wanted = o->prefix ? o->prefix : name, *prefix = c_identifier(arena, wanted, strlen(wanted));
    const char *macro = c_macro_name(arena, prefix);

    buf_printf(out, "// The bytecode of %s as an array.  Made by smc from %s: change that, not this file.\n", name, o->source);
    buf_printf(out, "#ifndef %s_IMAGE_H_INCLUDED\n#define %s_IMAGE_H_INCLUDED\n\n#include <stdint.h>\n\n", macro, macro);
    buf_printf(out,
               "#ifdef __AVR__      // whose constants are copied into RAM, unless told to stay in flash\n#include <avr/pgmspace.h>\n"
               "#define %s_IMAGE_IN PROGMEM\n#else\n#define %s_IMAGE_IN\n#endif\n\n",
               macro, macro);
    buf_printf(out, "static const uint8_t %s_image[%u] %s_IMAGE_IN = {", prefix, (unsigned)image->n, macro);
    emit_c_bytes(image, out);
    buf_str(out, "\n};\n\n#endif\n");
}
