// SPDX-License-Identifier: Apache-2.0
// The semantics of every type, operator and builtin of the language.  Freestanding C99 (also C++11): no heap, no libm, no I/O.
//
//   types.h    the types, operators and builtins as tables
//   f64.h      SmF64, the only number type, and its arithmetic
//   convert.h  between F64 and the other types, saturating
//   math.h     the builtins that depend only on their arguments
//   elementary.h  those of them that are rounded, such as exp and sin
//   roll.h     rolling windows
//   crc32.h    the checksum of images and links
//   result.h   the status of a call
#ifndef SM_STD_H
#define SM_STD_H

#include "stdlib/convert.h"
#include "stdlib/crc32.h"
#include "stdlib/elementary.h"
#include "stdlib/f64.h"
#include "stdlib/math.h"
#include "stdlib/result.h"
#include "stdlib/roll.h"
#include "stdlib/types.h"

#endif
