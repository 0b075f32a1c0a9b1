// SPDX-License-Identifier: Apache-2.0
// Shared by the files that emit applications.
#ifndef SMC_EMIT_C_APP_EMIT_H
#define SMC_EMIT_C_APP_EMIT_H

#include "compiler/emit/c/app.h"

// ---- app_image.c ----

// Writes the variables NAMEImage, NAMEMemory and NAMESelf.
void put_app_image(const AppMachine *m, const Buf *image, Buf *out);

#endif
