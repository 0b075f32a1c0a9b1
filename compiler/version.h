// SPDX-License-Identifier: Apache-2.0
// The version of everything in this tree; the only place that names it.
#ifndef SMC_VERSION_H
#define SMC_VERSION_H

#define SMC_VERSION "0.1.0"

#endif
