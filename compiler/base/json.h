// SPDX-License-Identifier: Apache-2.0
// JSON, written.
#ifndef SMC_JSON_H
#define SMC_JSON_H

#include "compiler/base/buf.h"

// The text as a JSON string, in quotes; NULL as null.  Bytes that are not UTF-8 become U+FFFD.
void json_put_string(Buf *out, const char *s);

#endif
